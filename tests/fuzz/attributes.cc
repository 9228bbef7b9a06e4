// Vertices and attributes, through every entry point that the registry has for them.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>
#include <tuple>
#include <utility>

#include "execute.h"

namespace truequad::fuzz {
namespace {

enum class Family { Vertex, TexCoord, MultiTexCoord, Color, SecondaryColor, Normal, FogCoord, Index, EdgeFlag, Material,
                    VertexAttrib, VertexAttribI, VertexAttribL, VertexAttribP, VertexAttribNV };
enum class Number { kPlain, kHalf, kFixed, kPacked };

constexpr Number number_of(std::string_view type) {
  return type == "GLhalfNV" ? Number::kHalf : type == "GLfixed" ? Number::kFixed : type == "Packed" ? Number::kPacked : Number::kPlain;
}

struct Values {
  double at[4];
  GLuint leading[3];  // target or face, property or type, normalized
};

std::uint16_t to_half(double value) {
  if (value == 0 || !std::isfinite(value)) return value != value ? 0x7e00 : 0;
  int exponent;
  const double fraction = std::frexp(std::fabs(value), &exponent);  // [0.5, 1)
  if (exponent + 14 <= 0 || exponent + 14 >= 31) return 0;
  return std::uint16_t((value < 0 ? 0x8000 : 0) | (exponent + 14) << 10 | (int(std::ldexp(fraction, 11)) & 0x3ff));
}

template <Number number, bool normalized, typename T>
T encode(double value) {
  if constexpr (number == Number::kHalf) return T(to_half(value));
  else if constexpr (number == Number::kFixed) return T(std::int64_t(value * 65536));
  else if constexpr (std::is_floating_point_v<T>) return T(value);
  else {
    // Colours are between 0 and 1.
    const double scaled = normalized && value >= 0 && value <= 1 ? value * double(T(~T(0) ^ (std::is_signed_v<T> ? T(1ull << (8 * sizeof(T) - 1)) : T(0)))) : value;
    return std::isfinite(scaled) && std::fabs(scaled) < 1e9 ? T(std::int64_t(scaled)) : T(0);
  }
}

GLuint pack(const double (&at)[4], bool normalized) {
  GLuint bits = 0;
  for (int i = 0; i < 4; ++i) {
    const int width = i < 3 ? 10 : 2;
    const double scaled = normalized ? at[i] * 511 : at[i];
    bits |= (GLuint(int(std::isfinite(scaled) && std::fabs(scaled) < 1000 ? scaled : 0)) & ((1u << width) - 1)) << (10 * i);
  }
  return bits;
}

template <auto member, Family family, Number number, bool normalized, typename Function>
struct Maker;
template <auto member, Family family, Number number, bool normalized, typename... P>
struct Maker<member, family, number, normalized, void(GLAPIENTRY*)(P...)> {
  static constexpr bool kNamed = family == Family::MultiTexCoord || family >= Family::VertexAttrib;
  static constexpr unsigned kLeading = (kNamed ? 1 : family == Family::Material ? 2 : 0) +
                                       (number == Number::kPacked ? family == Family::VertexAttribP ? 2 : 1 : 0);

  template <std::size_t i, typename T>
  static T argument(const Values& values) {
    if constexpr (std::is_pointer_v<T>) {
      using N = std::remove_cv_t<std::remove_pointer_t<T>>;
      static N array[4];
      for (int k = 0; k < 4; ++k) {
        if constexpr (number == Number::kPacked) array[k] = pack(values.at, normalized);
        else array[k] = encode<number, normalized, N>(values.at[k]);
      }
      return array;
    } else if constexpr (i < kLeading) {
      // Packed calls: the type comes after the name.
      if constexpr (number == Number::kPacked && !kNamed) return T(values.leading[1 + i]);
      else return T(values.leading[i]);
    } else if constexpr (number == Number::kPacked) {
      return T(pack(values.at, normalized));
    } else {
      return encode<number, normalized, T>(values.at[(i - kLeading) & 3]);
    }
  }

  static void make(const char* name, const Values& values) {
    if constexpr ((std::is_pointer_v<P> || ...)) print_note("%g %g %g %g", values.at[0], values.at[1], values.at[2], values.at[3]);
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      Call<member>::make(name, argument<i, P>(values)...);
    }(std::index_sequence_for<P...>());
  }
};

struct Entry {
  Family family;
  int size;
  Number number;
  bool normalized, is_unsigned;
  void (*make)(const char* name, const Values& values);
  const char* name;
  const void* const* function;  // in `gl`
};

#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_)                                    \
  {Family::family, size, number_of(#type), normalized != 0, std::string_view(#type).starts_with("GLu"),           \
   &Maker<&Driver::Name, Family::family, number_of(#type), normalized != 0, decltype(Driver::Name)>::make, "gl" #Name, \
   reinterpret_cast<const void* const*>(&gl.Name)},
const Entry kEntries[] = {
#include "attribute_calls.inc"
};
#undef TQ_ATTRIBUTE

bool has_negative(const Values& values) {
  return std::ranges::any_of(values.at, [](double x) { return x < 0; });
}

// Whether a call gives just these whole numbers.
bool gives(const Entry& entry, const Values& values) {
  return !entry.normalized && !(entry.is_unsigned && has_negative(values));
}

// Some call of a family, of so many numbers if the family has such; 0: of any. `exact`: that gives just these.
const Entry& some_call(Random& random, Family family, int size, const Values* exact = nullptr) {
  const Entry* found = nullptr;
  int count = 0;
  for (const Entry& entry : kEntries) {
    if (entry.family != family || (size > 0 && entry.size != size) || !*entry.function || (exact && !gives(entry, *exact))) continue;
    ++count;
    if (random.below(count) == 0) found = &entry;
  }
  if (!found && size > 0) return some_call(random, family, 0, exact);
  return found ? *found : kEntries[0];
}

int size_of(const Op& op) { return 2 + (op.warp / kSize & 3); }

GLuint packed_type(Random& random) {
  if (random.chance(3)) return random.of<GLuint>({GL_FLOAT, GL_UNSIGNED_INT_10F_11F_11F_REV, 0});
  return random.of<GLuint>({GL_INT_2_10_10_10_REV, GL_UNSIGNED_INT_2_10_10_10_REV});
}

// False: the call is an error.
bool make(Random& random, const Entry& entry, Values values, bool exact = false) {
  if (entry.number == Number::kPacked) {
    // After a name (MultiTexCoordP, VertexAttribP), or first.
    values.leading[1] = exact ? GL_INT_2_10_10_10_REV : packed_type(random);
    values.leading[2] = GLuint(random.below(2));
  }
  entry.make(entry.name, values);
  return entry.number != Number::kPacked || values.leading[1] == GL_INT_2_10_10_10_REV || values.leading[1] == GL_UNSIGNED_INT_2_10_10_10_REV;
}

}  // namespace

Corner corner(std::uint32_t shape, int index, unsigned warp) {
  Random random(shape);
  const bool strip = warp & kStrip;
  const int u = strip ? index & 1 : (index & 3) == 1 || (index & 3) == 2;
  const int v = strip ? index / 2 : (index & 3) >= 2;
  const int x = 1 + random.below(14), y = 1 + random.below(14), ax = 6 + random.below(9), ay = random.below(3) - 1,
            bx = random.below(3) - 1, by = (strip ? 3 : 6) + random.below(strip ? 3 : 9);
  const int s = random.below(4), t = random.below(4), as = 1 + random.below(7), at = random.below(3) - 1, bt = 1 + random.below(7);
  Corner c = {x + u * ax + v * bx, y + u * ay + v * by, random.below(9) - 4, s + u * as, t + u * at + v * bt};
  if (u && v % 2) {
    if (warp & kWarpPosition) c.x -= 2 + random.below(3), c.y -= random.below(3);
    if (warp & kWarpTexture) c.s += 2, c.t += 1;
    if (warp & kWarpDepth) c.z += 3;
  }
  return c;
}

void execute_vertex(const Op& op, Player& player) {
  Random random(op.seed);
  const Corner c = corner(op.shape, op.index, op.warp);
  const bool plain = !(op.warp & kVarious) || random.chance(40);
  const int size = size_of(op);
  if (op.step == Step::kTexCoord) {
    if (plain && size == 2) return GL(TexCoord2f, GLfloat(c.s), GLfloat(c.t));
    const Family family = !plain && random.chance(30) ? Family::MultiTexCoord : Family::TexCoord;
    Values values = {{double(c.s), double(c.t), 0, 1}, {GL_TEXTURE0 + GLuint(op.warp & kOneSlot ? 0 : random.below(100) / 85), 0, 0}};
    if (random.chance(1) && !(op.warp & kOneSlot)) values.leading[0] = random.of<GLuint>({GL_TEXTURE0 + 40, 0, GL_TEXTURE0 - 1});
    make(random, some_call(random, family, size), values);
    return;
  }
  const int z = size == 2 ? 0 : c.z;
  ++player.vertices;
  if (plain && size == 3) return GL(Vertex3f, GLfloat(c.x), GLfloat(c.y), GLfloat(z));
  Values values = {{double(c.x), double(c.y), double(z), 1}, {0, 0, 0}};
  const bool exact = op.warp & kExact;
  if (random.chance(1) && !exact) values.at[random.below(4)] = random.of<double>({NAN, INFINITY, 1e30, 1e-40, 0});
  const Family family = !plain && random.chance(6) ? Family::VertexAttrib : Family::Vertex;
  if (!make(random, some_call(random, family, size, exact ? &values : nullptr), values, exact)) --player.vertices;
}

// How many numbers Mesa keeps of a colour that is given by three: of most types it makes a glColor4f.
int numbers_kept(const Entry& entry) {
  const std::string_view name = entry.name;
  for (const char* type : {"3f", "3fv", "3hNV", "3hvNV", "3xOES", "3xvOES", "P3ui", "P3uiv"}) {
    if (name.ends_with(type)) return 3;
  }
  return 4;
}

void execute_attribute(const Op& op, Player& player) {
  Random random(op.seed);
  const Family family = op.warp & kOneSlot ? Family::Color : random.of({Family::Color, Family::Color, Family::Color, Family::SecondaryColor, Family::Normal, Family::Normal,
                                   Family::FogCoord, Family::Index, Family::EdgeFlag, Family::MultiTexCoord, Family::TexCoord,
                                   Family::VertexAttrib, Family::VertexAttribI, Family::VertexAttribL, Family::VertexAttribNV, Family::VertexAttribP});
  Values values = {{random.of({0.0, 0.25, 0.5, 1.0, 0.7}), random.of({0.0, 1.0, 0.3}), random.of({0.0, 1.0, 0.6}), 1}, {0, 0, 0}};
  if (family == Family::MultiTexCoord) values.leading[0] = GL_TEXTURE0 + GLuint(random.chance(2) ? random.below(40) : random.below(2));
  if (family >= Family::VertexAttrib) values.leading[0] = GLuint(random.chance(3) ? random.below(40) : 1 + random.below(15));
  if (random.chance(3)) values.at[random.below(4)] = random.of<double>({NAN, -1, 2, 1e30, 1e-40});
  // What Mesa's lists give to the components that an integer or double call leaves out is a float.
  const bool whole = family == Family::VertexAttribI || family == Family::VertexAttribL;
  const Entry& call = some_call(random, family, op.warp & kOneSlot ? 3 : whole ? 4 : size_of(op));
  if (family == Family::Color) note_colour(player, numbers_kept(call));
  make(random, call, values);
}

void execute_material(const Op& op) {
  Random random(op.seed);
  Values values = {{random.real(0, 1), random.real(0, 1), random.real(0, 1), 1}, {0, 0, 0}};
  values.leading[0] = pick(random, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK, GL_FRONT_AND_BACK);
  values.leading[1] = pick(random, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE, GL_SHININESS, GL_COLOR_INDEXES);
  if (values.leading[1] == GL_SHININESS && random.chance(90)) values.at[0] = double(random.below(129));
  const Entry& entry = some_call(random, Family::Material, 0);
  // Mesa reads four numbers from where a scalar call has one.
  const std::string_view name = entry.name;
  if (name == "glMaterialf" || name == "glMateriali" || name.ends_with("xOES")) values.leading[1] = GL_SHININESS;
  make(random, entry, values);
}

}  // namespace truequad::fuzz
