#include "capture/kept_calls.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <tuple>
#include <type_traits>

#include "capture/capture.h"
#include "capture/kept_current.h"
#include "capture/list_compile.h"
#include "capture/rows.h"

namespace truequad {
namespace {

// Behind the rows: calls that are no attributes.
enum : RowId { kKeptBegin = kRowCount, kKeptEnd, kKeptNoteCurrent, kKeptRestoreCurrent, kKeptCount };

// What GL reads through a pointer: one packed number, as many as the call's name says, or as the property has.
template <Row row>
unsigned pointed_numbers([[maybe_unused]] GLenum property) {
  if constexpr (row.encoding == Encoding::kPacked) return 1;
  if constexpr (row.family == Family::Material) {
    return property == GL_SHININESS ? 1 : property == GL_COLOR_INDEXES ? 3 : 4;
  }
  return row.size;
}

// Whether a call can be kept. Drivers reject packed numbers of a type that they do not know at once, not when the list is
// called; which they know besides these two is theirs to say. Calls of fixed-point numbers Mesa makes at once, while a list
// is compiled, and compiles nothing, or refuses them. Of glMaterial*v GL reads nothing unless it knows the property.
template <Row row>
bool keepable([[maybe_unused]] GLenum property, [[maybe_unused]] GLenum packed_type) {
  if constexpr (row.encoding == Encoding::kFixed) return false;
  if constexpr (row.encoding == Encoding::kPacked) {
    return packed_type == GL_UNSIGNED_INT_2_10_10_10_REV || packed_type == GL_INT_2_10_10_10_REV;
  }
  if constexpr (row.family == Family::Material) {
    if constexpr (!row.vector) return true;
    switch (property) {
      case GL_AMBIENT:
      case GL_DIFFUSE:
      case GL_SPECULAR:
      case GL_EMISSION:
      case GL_SHININESS:
      case GL_AMBIENT_AND_DIFFUSE:
      case GL_COLOR_INDEXES: return true;
      default: return false;
    }
  }
  return true;
}

template <typename T>
using Number = std::remove_cv_t<std::remove_pointer_t<T>>;

// An argument on its way from the bytes to a call.
template <typename T>
struct Argument {
  Number<T> numbers[4] = {};
  T get() const {
    if constexpr (std::is_pointer_v<T>) return numbers;
    else return numbers[0];
  }
};

template <Row row, auto member, typename Function>
struct Kept;
template <Row row, auto member, typename... Arguments>
struct Kept<row, member, void(GLAPIENTRY*)(Arguments...)> {
  template <typename T>
  static std::size_t size_of(GLenum property) {
    return sizeof(Number<T>) * (std::is_pointer_v<T> ? pointed_numbers<row>(property) : 1);
  }

  // The property of a glMaterial call.
  static GLenum property_of([[maybe_unused]] const std::tuple<Arguments...>& arguments) {
    if constexpr (row.family == Family::Material) return GLenum(std::get<1>(arguments));
    else return 0;
  }

  // The type of a packed number, behind the texture unit or the attribute.
  static GLenum packed_type_of([[maybe_unused]] const std::tuple<Arguments...>& arguments) {
    constexpr bool named = row.family == Family::MultiTexCoord || row.family == Family::VertexAttribP;
    if constexpr (row.encoding == Encoding::kPacked) return std::get<named>(arguments);
    else return 0;
  }

  static void GLAPIENTRY call(Arguments... arguments) {
    const GLenum property = property_of({arguments...});
    if (!keepable<row>(property, packed_type_of({arguments...}))) {
      return (open_driver_part(entry).*member)(arguments...);
    }
    if constexpr (row.family == Family::Vertex) keep_leading(entry);
    KeptCalls* kept = kept_calls(entry);
    unsigned char* to = kept ? kept->add(sizeof(RowId) + (size_of<Arguments>(property) + ...)) : nullptr;
    if (!to) return;
    if constexpr (row.family == Family::Vertex) {
      entry.list->kept_inside |= !entry.list->kept_primitive;
      if (Part* const part = entry.list->kept) part->paired &= part->inside;
    }
    const RowId id = row.id;
    std::memcpy(to, &id, sizeof id);
    to += sizeof id;
    const auto store = [&]<typename T>(T argument) {
      const std::size_t size = size_of<T>(property);
      if constexpr (std::is_pointer_v<T>) std::memcpy(to, argument, size);
      else std::memcpy(to, &argument, size);
      to += size;
    };
    (store(arguments), ...);
  }

  static const unsigned char* play(const unsigned char* from) {
    GLenum property = 0;
    unsigned index = 0;
    const auto load = [&]<typename T>() {
      Argument<T> argument;
      const std::size_t size = size_of<T>(property);
      std::memcpy(argument.numbers, from, size);
      from += size;
      if constexpr (row.family == Family::Material && std::is_same_v<T, GLenum>) {
        if (index == 1) property = argument.numbers[0];
      }
      ++index;
      return argument;
    };
    // Braces: in order.
    const std::tuple<Argument<Arguments>...> loaded{load.template operator()<Arguments>()...};
    std::apply([](const auto&... argument) { (entry.dispatch->*member)(argument.get()...); }, loaded);
    return from;
  }
};

// Arguments whose number is in an argument (glVertexAttribs4fvNV): left to the driver.
template <Row row>
inline constexpr bool kIsKept = row.family != Family::VertexAttribNV;

template <auto member, typename Function>
struct Others;
template <auto member, typename Result, typename... Arguments>
struct Others<member, Result(GLAPIENTRY*)(Arguments...)> {
  static Result GLAPIENTRY call(Arguments... arguments) {
    return (open_driver_part(entry).*member)(arguments...);
  }
};

void GLAPIENTRY keep_begin(GLenum mode) {
  if (!has_quads(mode)) {
    // Already noted as begun.
    const bool inside = entry.inside;
    if (mode <= GL_PATCHES) entry.inside = false;
    const Driver& driver = open_driver_part(entry);
    entry.inside = inside;
    return driver.Begin(mode);
  }
  KeptCalls* kept = kept_calls(entry);
  unsigned char* to = kept ? kept->add(sizeof(RowId) + sizeof mode) : nullptr;
  if (!to) return;
  const RowId id = kKeptBegin;
  std::memcpy(to, &id, sizeof id);
  std::memcpy(to + sizeof id, &mode, sizeof mode);
  ListCompile& list = *entry.list;
  if (!list.kept_primitive && !list.kept_inside) list.kept->opens = true;
  list.kept_primitive = true;
  list.kept->paired &= !list.kept->inside;
  list.kept->inside = true;
}

void GLAPIENTRY keep_end() {
  KeptCalls* kept = kept_calls(entry);
  unsigned char* to = kept ? kept->add(sizeof(RowId)) : nullptr;
  if (!to) return;
  const RowId id = kKeptEnd;
  std::memcpy(to, &id, sizeof id);
  entry.list->kept_inside |= !entry.list->kept_primitive;
  if (Part* const part = entry.list->kept) {
    part->paired &= part->inside;
    part->inside = false;
  }
}

constexpr Driver make_keeping() {
  Driver table{};
#define TQ_COMMAND(name, result, parameters, arguments) table.name = Others<&Driver::name, decltype(Driver::name)>::call;
#include "gl_commands.inc"
#undef TQ_COMMAND
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_) \
  if constexpr (kIsKept<kRows[kRow##Name]>) table.Name = Kept<kRows[kRow##Name], &Driver::Name, decltype(Driver::Name)>::call;
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
  table.Begin = keep_begin;
  table.End = keep_end;
  return table;
}

using Play = const unsigned char* (*)(const unsigned char*);

constexpr Play kPlay[kKeptCount] = {
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_) \
  &Kept<kRows[kRow##Name], &Driver::Name, decltype(Driver::Name)>::play,
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
  [](const unsigned char* from) {
    GLenum mode;
    std::memcpy(&mode, from, sizeof mode);
    begin(entry, mode);
    return from + sizeof mode;
  },
  [](const unsigned char* from) {
    end(entry);
    return from;
  },
  [](const unsigned char* from) {
    SlotMask slots;
    std::memcpy(&slots, from, sizeof slots);
    note_current(entry, slots);
    return from + sizeof slots;
  },
  [](const unsigned char* from) {
    restore_current(entry);
    return from;
  },
};

}  // namespace

constinit const Driver keeping = make_keeping();

KeptCalls::~KeptCalls() { std::free(bytes_); }

unsigned char* KeptCalls::add(std::size_t size) {
  if (capacity_ - size_ < size) {
    const std::size_t capacity = std::max<std::size_t>(256, 2 * capacity_ + size);
    void* bytes = std::realloc(bytes_, capacity);
    if (!bytes) return nullptr;
    bytes_ = static_cast<unsigned char*>(bytes);
    capacity_ = capacity;
  }
  size_ += size;
  return bytes_ + size_ - size;
}

bool keep_noting_current(Entry& e, SlotMask slots) {
  KeptCalls* const kept = kept_calls(e);
  unsigned char* const to = kept ? kept->add(sizeof(RowId) + sizeof slots) : nullptr;
  if (!to) return false;
  const RowId id = kKeptNoteCurrent;
  std::memcpy(to, &id, sizeof id);
  std::memcpy(to + sizeof id, &slots, sizeof slots);
  // What follows is kept as well.
  ListCompile& list = *e.list;
  if (!list.kept_primitive && !list.kept_inside) list.kept->opens = true;
  list.kept_primitive = true;
  return true;
}

void keep_restoring_current(Entry& e) {
  KeptCalls* const kept = kept_calls(e);
  unsigned char* const to = kept ? kept->add(sizeof(RowId)) : nullptr;
  const RowId id = kKeptRestoreCurrent;
  if (to) std::memcpy(to, &id, sizeof id);
}

void KeptCalls::play(Entry&) const {
  const unsigned char* const end = bytes_ + size_;
  for (const unsigned char* at = bytes_; at != end;) {
    RowId id;
    std::memcpy(&id, at, sizeof id);
    at = kPlay[id](at + sizeof id);
  }
}

}  // namespace truequad
