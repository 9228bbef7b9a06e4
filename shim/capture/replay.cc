#include "capture/replay.h"

#include <tuple>
#include <utility>

#include "capture/record.h"

namespace truequad {
namespace {

using Replay = void (*)(const Driver&, Slot, const Float4&, const Raw&);

template <Row row>
GLuint slot_name(Slot slot) {
  if constexpr (row.family == Family::MultiTexCoord) return GL_TEXTURE0 + (slot - kTexture);
  else return slot == kPosition ? 0 : slot - kGeneric + 1;
}

template <typename T>
T read(const Raw& raw, unsigned offset) {
  T value;
  std::memcpy(&value, raw.bytes + offset, sizeof value);
  return value;
}

// Calls f(values…) or f(pointer) with the numbers of a row.
template <Row row, typename T, typename F>
void with_numbers(const Float4& value, const Raw& raw, F f) {
  T numbers[4] = {};
  if constexpr (kIsPlain<row, T>) std::memcpy(numbers, value.at, sizeof numbers);
  else std::memcpy(numbers, raw.bytes, row.family == Family::Material ? 4 * sizeof(T) : row.size * sizeof(T));
  if constexpr (row.vector) {
    f(static_cast<const T*>(numbers));
  } else {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      f(numbers[i]...);
    }(std::make_index_sequence<row.family == Family::Material ? 1 : row.size>());
  }
}

template <typename Last>
using NumberOf = std::remove_cv_t<std::remove_pointer_t<Last>>;

template <Row row, typename... Arguments>
void replay_row(void(GLAPIENTRY* call)(Arguments...), Slot slot, const Float4& value, const Raw& raw) {
  using Last = std::tuple_element_t<sizeof...(Arguments) - 1, std::tuple<Arguments...>>;
  using T = NumberOf<Last>;
  constexpr bool kNamed = row.family == Family::MultiTexCoord || row.family == Family::VertexAttrib ||
                          row.family == Family::VertexAttribI || row.family == Family::VertexAttribL ||
                          row.family == Family::VertexAttribP;
  constexpr std::size_t kOthers = kNamed ? 1 : row.family == Family::Material ? 2 : 0;
  if constexpr (row.family == Family::VertexAttribNV) {
    // Never recorded.
  } else if constexpr (row.encoding == Encoding::kPacked) {
    const GLenum type = read<GLenum>(raw, kRawType);
    const GLuint bits_ = read<GLuint>(raw, 0);
    const auto last = [&] {
      if constexpr (row.vector) return &bits_;
      else return bits_;
    }();
    if constexpr (row.family == Family::VertexAttribP) {
      call(slot_name<row>(slot), type, read<GLboolean>(raw, kRawNormalized), last);
    } else if constexpr (kNamed) {
      call(slot_name<row>(slot), type, last);
    } else {
      call(type, last);
    }
  } else if constexpr (!row.vector && row.family != Family::Material && sizeof...(Arguments) != kOthers + row.size) {
    // Never recorded (record.h).
  } else {
    with_numbers<row, T>(value, raw, [&](auto... numbers) {
      if constexpr (row.family == Family::Material) {
        const MaterialName name = material_name(slot);
        call(name.face, name.property, numbers...);
      } else if constexpr (kNamed) {
        call(slot_name<row>(slot), numbers...);
      } else {
        call(numbers...);
      }
    });
  }
}

constexpr Replay kReplay[] = {
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_)         \
  [](const Driver& driver, Slot slot, const Float4& value, const Raw& raw) {          \
    replay_row<kRows[kRow##Name]>(driver.Name, slot, value, raw);                     \
  },
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
};

}  // namespace

void replay(const Driver& driver, Slot slot, RowId row, const Float4& value, const Raw& raw) {
  kReplay[row](driver, slot, value, raw);
}

}  // namespace truequad
