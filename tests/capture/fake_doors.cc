// A table of functions that do what the doors of the library do, on top of the fake driver; and calls of any row of the
// attribute list with reproducible arguments.
#include <cstring>
#include <random>
#include <type_traits>

#include "capture/arrays.h"
#include "capture/capture.h"
#include "capture/list_compile.h"
#include "capture/list_play.h"
#include "capture/record.h"
#include "capture/rect.h"
#include "fake_gl.h"

namespace truequad::fake {
namespace {

template <auto member, typename Result, typename... Arguments>
auto door(Result(GLAPIENTRY*)(Arguments...)) {
  return [](Arguments... arguments) -> Result { return (entry.dispatch->*member)(arguments...); };
}

Driver make_doors() {
  Driver d;
#define TQ_COMMAND(name, result, parameters, arguments) d.name = door<&Driver::name>(decltype(d.name){});
#include "gl_commands.inc"
#undef TQ_COMMAND
  d.Begin = [](GLenum mode) { begin(entry, mode); };
  d.End = [] { end(entry); };
  d.CallList = [](GLuint list) { call_list(entry, list); };
  d.CallLists = [](GLsizei count, GLenum type, const void* lists) { call_lists(entry, count, type, lists); };
  d.DeleteLists = [](GLuint list, GLsizei range) { delete_lists(entry, list, range); };
  d.GenLists = [](GLsizei range) { return gen_lists(entry, range); };
  d.IsList = [](GLuint list) { return is_list(entry, list); };
  d.NewList = [](GLuint list, GLenum mode) { new_list(entry, list, mode); };
  d.EndList = [] { end_list(entry); };
  d.Clear = [](GLbitfield mask) { clear(entry, mask); };
  d.DepthFunc = [](GLenum function) { depth_func(entry, function); };
  d.StencilOp = [](GLenum fail, GLenum zfail, GLenum pass) { stencil_op(entry, fail, zfail, pass); };
  d.StencilOpSeparate = [](GLenum face, GLenum fail, GLenum zfail, GLenum pass) {
    stencil_op_separate(entry, face, fail, zfail, pass);
  };
#define TQ_DRAW(name, parameters, arguments, draw)            \
  d.name = [] parameters {                                    \
    const auto own = [&] { entry.dispatch->name arguments; }; \
    draw;                                                     \
  };
#include "capture/array_calls.inc"
  // The fake driver knows no array's elements: to it these are calls like any other.
  d.ArrayElement = door<&Driver::ArrayElement>(d.ArrayElement);
  d.ArrayElementEXT = door<&Driver::ArrayElementEXT>(d.ArrayElementEXT);
  return d;
}

// --- invoke -------------------------------------------------------------------------------------------------------

class Arguments {
 public:
  explicit Arguments(unsigned seed) : random_(seed) {}
  unsigned below(unsigned n) { return unsigned(random_() % n); }

  template <Row row, typename T>
  T number() {
    if constexpr (row.encoding == Encoding::kHalf) {
      return T(0x3000 + below(0x1800) + (below(2) << 15));  // 0.125 to 32, both signs
    } else if constexpr (row.encoding == Encoding::kFixed) {
      return T(int(below(4 << 16)) - (2 << 16));
    } else if constexpr (row.encoding == Encoding::kPacked) {
      return T(random_());
    } else if constexpr (std::is_floating_point_v<T>) {
      return T(double(random_()) / 2147483648.0 - 1);
    } else {
      return T(random_());
    }
  }

 private:
  std::mt19937 random_;
};

template <Row row>
GLuint name_of(Arguments& random, unsigned place, bool wild) {
  if (wild && random.below(20) == 0) return random.below(100);
  if constexpr (row.family == Family::MultiTexCoord) return GL_TEXTURE0 + place % kTextureUnits;
  else return place % 16;
}

GLenum packed_type(Arguments& random, bool wild) {
  if (wild && random.below(20) == 0) return GL_FLOAT;
  return random.below(2) ? GL_INT_2_10_10_10_REV : GL_UNSIGNED_INT_2_10_10_10_REV;
}

template <Row row, typename... A>
void invoke_row(void(GLAPIENTRY* call)(A...), unsigned seed, unsigned place, bool wild) {
  Arguments random(seed);
  constexpr bool kNamed = row.family == Family::MultiTexCoord || row.family == Family::VertexAttrib ||
                          row.family == Family::VertexAttribI || row.family == Family::VertexAttribL ||
                          row.family == Family::VertexAttribP || row.family == Family::VertexAttribNV;
  [[maybe_unused]] constexpr GLenum kFaces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
  [[maybe_unused]] constexpr GLenum kProperties[] = {GL_AMBIENT,  GL_DIFFUSE,   GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR,
                                                     GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES};
  GLenum property = 0;
  unsigned index = 0;
  using Last = std::tuple_element_t<sizeof...(A) - 1, std::tuple<A...>>;
  std::remove_cv_t<std::remove_pointer_t<Last>> numbers[4];
  // At an odd address: GL asks for no alignment, and the packed structures of programs have none.
  alignas(16) unsigned char unaligned[1 + sizeof numbers];
  const auto argument = [&]<typename T>() -> T {
    const unsigned i = index++;
    if constexpr (std::is_pointer_v<T>) {
      for (auto& x : numbers) x = random.number<row, std::remove_cvref_t<decltype(x)>>();
      if (property == GL_SHININESS && numbers[0] < 0) numbers[0] = std::remove_cvref_t<decltype(numbers[0])>(-(numbers[0] / 4));
      if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(numbers[0])>>) {
        if (property == GL_SHININESS) numbers[0] = numbers[0] % 100;
      }
      std::memcpy(unaligned + 1, numbers, sizeof numbers);
      return reinterpret_cast<T>(unaligned + 1);
    } else {
      if constexpr (row.family == Family::Material) {
        if (i == 0) return T(wild && random.below(20) == 0 ? GL_TEXTURE_2D : kFaces[random.below(3)]);
        if (i == 1) {
          property = row.vector ? kProperties[random.below(7)] : GL_SHININESS;
          if (wild && random.below(20) == 0) property = GL_LINE;
          return T(property);
        }
        if (row.encoding == Encoding::kFixed) return T(random.below(100 << 16));
        return T(random.below(100));
      }
      if constexpr (kNamed) {
        if (i == 0) return T(name_of<row>(random, place, wild));
        if (row.encoding == Encoding::kPacked && i == 1) return T(packed_type(random, wild));
        if (row.family == Family::VertexAttribP && i == 2) return T(random.below(2));
      } else if constexpr (row.encoding == Encoding::kPacked) {
        if (i == 0) return T(packed_type(random, wild));
      }
      return random.number<row, T>();
    }
  };
  std::tuple<A...> all{argument.template operator()<A>()...};
  std::apply(call, all);
}

}  // namespace

const Driver& doors() {
  static const Driver table = make_doors();
  return table;
}

void invoke(const Driver& table, RowId row, unsigned seed, unsigned place, bool wild) {
  using Invoke = void (*)(const Driver&, unsigned, unsigned, bool);
  static constexpr Invoke kInvoke[] = {
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_)          \
  [](const Driver& d, unsigned seed_, unsigned place_, bool wild_) {                   \
    invoke_row<kRows[kRow##Name]>(d.Name, seed_, place_, wild_);                       \
  },
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
  };
  kInvoke[row](table, seed, place, wild);
}

void make_current() {
  static char handles[2];
  static unsigned which = 0;
  which ^= 1;
  if (entry.own) entry.own->start_held = false;
  context_made_current(entry, nullptr, nullptr);
  context_destroyed(&handles[which]);
  context_made_current(entry, &handles[which], &driver());
}

}  // namespace truequad::fake
