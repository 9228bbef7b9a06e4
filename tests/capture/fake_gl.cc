#include "fake_gl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "capture/capture.h"

namespace truequad {
Driver default_driver = fake::driver();
}

namespace truequad::fake {
namespace {

Gl* the_gl = nullptr;

// --- values, by the tables of the specifications -------------------------------------------------------------------

double half(unsigned h) {
  const double sign = h & 0x8000 ? -1 : 1;
  const int exponent = h >> 10 & 31;
  const double fraction = (h & 1023) / 1024.0;
  if (exponent == 31) return h & 1023 ? NAN : sign * INFINITY;
  return sign * (exponent ? std::ldexp(1 + fraction, exponent - 15) : std::ldexp(fraction, -14));
}

double packed_field(unsigned bits, int index, bool is_signed, bool normalized) {
  const int width = index == 3 ? 2 : 10;
  int field = int(bits >> (10 * index)) & ((1 << width) - 1);
  if (is_signed && field >= 1 << (width - 1)) field -= 1 << width;
  if (!normalized) return field;
  const double steps = std::pow(2, width) - 1;
  return is_signed ? (2.0 * field + 1) / steps : field / steps;
}

template <Row row, bool normalized = row.normalized, typename T>
double plain(T x) {
  if constexpr (row.encoding == Encoding::kHalf) return half(x);
  else if constexpr (row.encoding == Encoding::kFixed) return x / 65536.0;
  else if constexpr (std::is_floating_point_v<T> || !normalized) return double(x);
  else if constexpr (std::is_signed_v<T>) return (2.0 * double(x) + 1) / (std::pow(2.0, 8 * sizeof x) - 1);
  else return double(x) / (std::pow(2.0, 8 * sizeof x) - 1);
}

// Programs' pointers need no alignment.
template <typename T>
T load(const T* p, int i = 0) {
  T x;
  std::memcpy(&x, reinterpret_cast<const char*>(p) + std::size_t(i) * sizeof x, sizeof x);
  return x;
}

Value defaults(Family family) {
  if (family == Family::FogCoord || family == Family::Index || family == Family::EdgeFlag) return {0, 0, 0, 0};
  return {0, 0, 0, 1};
}

// --- attribute calls ----------------------------------------------------------------------------------------------

constexpr bool named(Family f) {
  return f == Family::MultiTexCoord || f == Family::VertexAttrib || f == Family::VertexAttribI ||
         f == Family::VertexAttribL || f == Family::VertexAttribP || f == Family::VertexAttribNV;
}

template <Row row>
void set_named(GLuint name, const Value& value) {
  Gl& g = gl();
  if constexpr (row.family == Family::MultiTexCoord) {
    if (name < GL_TEXTURE0 || name >= GL_TEXTURE0 + g.units) return g.error(GL_INVALID_ENUM);
    g.set(kTexture + (name - GL_TEXTURE0), value);
  } else if constexpr (row.family == Family::VertexAttribNV) {
    if (name >= 16) return g.error(GL_INVALID_VALUE);
    g.set(kNvAttributes + name, value);
  } else {
    if (name >= 16) return g.error(GL_INVALID_VALUE);
    if (name == 0) g.vertex(value);
    else g.set(kGeneric + name - 1, value);
  }
}

template <Row row>
void set_unnamed(const Value& value) {
  constexpr unsigned kPlace[] = {0, kTexture, 0, kColor, kSecondaryColor, kNormal, kFogCoord, kIndex, kEdgeFlag};
  if constexpr (row.family == Family::Vertex) gl().vertex(value);
  else gl().set(kPlace[unsigned(row.family)], value);
}

template <Row row>
bool unpack(GLenum type, bool normalized, GLuint bits, Value& value) {
  const bool is_signed = type == GL_INT_2_10_10_10_REV;
  if (type == GL_UNSIGNED_INT_10F_11F_11F_REV && row.family == Family::VertexAttribP && row.size == 3) {
    value = {float(half((bits & 2047) << 4)), float(half((bits >> 11 & 2047) << 4)), float(half((bits >> 22) << 5)), 1};
    return true;
  }
  if (!is_signed && type != GL_UNSIGNED_INT_2_10_10_10_REV) return false;
  for (int i = 0; i < row.size; ++i) value[i] = float(packed_field(bits, i, is_signed, normalized));
  return true;
}

template <Row row, typename T>
void set_material(GLenum face, GLenum property, const T* values, bool scalar) {
  Gl& g = gl();
  if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK) return g.error(GL_INVALID_ENUM);
  constexpr GLenum kProperties[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES};
  const bool both = property == GL_AMBIENT_AND_DIFFUSE;
  const auto found = std::find(std::begin(kProperties), std::end(kProperties), both ? GL_AMBIENT : property);
  if (found == std::end(kProperties)) return g.error(GL_INVALID_ENUM);
  const unsigned first = unsigned(found - kProperties);
  if (scalar && property != GL_SHININESS) return g.error(GL_INVALID_ENUM);
  const int size = property == GL_SHININESS ? 1 : property == GL_COLOR_INDEXES ? 3 : 4;
  Value value = {0, 0, 0, 1};
  for (int i = 0; i < size; ++i) {
    const T x = load(values, i);
    value[i] = float(size == 4 ? plain<row, true>(x) : plain<row, false>(x));
  }
  if (property == GL_SHININESS && !(value[0] >= 0 && value[0] <= 128)) return g.error(GL_INVALID_VALUE);
  for (unsigned side = 0; side < 2; ++side) {
    if ((face == GL_FRONT && side == 1) || (face == GL_BACK && side == 0)) continue;
    for (unsigned i = 0; i < (both ? 2u : 1u); ++i) {
      const unsigned place = kMaterial + side * kMaterialProperties + first + i;
      if (!g.tracked(place)) g.set(place, value);
    }
  }
}

struct Bytes {
  unsigned char at[128];
  std::size_t size = 0;
  void add(const void* x, std::size_t n) {
    std::memcpy(at + size, x, n);
    size += n;
  }
};

int material_size(GLenum property) {
  return property == GL_SHININESS ? 1 : property == GL_COLOR_INDEXES ? 3 : 4;
}

template <unsigned command, Row row, typename... Arguments>
void GLAPIENTRY attribute(Arguments... arguments) {
  Bytes bytes;
  [[maybe_unused]] std::size_t vector_size = row.size;
  if constexpr (row.encoding == Encoding::kPacked) vector_size = 1;
  [[maybe_unused]] std::size_t index = 0;
  const auto add = [&]<typename T>(T x) {
    if constexpr (std::is_pointer_v<T>) {
      bytes.add(x, vector_size * sizeof *x);
    } else {
      if (row.family == Family::Material && ++index == 2) vector_size = material_size(GLenum(x));
      bytes.add(&x, sizeof x);
    }
  };
  (add(arguments), ...);
  gl().called(command, bytes.at, bytes.size);

  Value value = defaults(row.family);
  if constexpr (row.family == Family::Material) {
    [&](GLenum face, GLenum property, auto x) {
      if constexpr (std::is_pointer_v<decltype(x)>) set_material<row>(face, property, x, false);
      else set_material<row>(face, property, &x, true);
    }(arguments...);
  } else if constexpr (row.encoding == Encoding::kPacked) {
    const auto bits_of = [](auto x) {
      if constexpr (std::is_pointer_v<decltype(x)>) return load(x);
      else return x;
    };
    if constexpr (row.family == Family::VertexAttribP) {
      [&](GLuint name, GLenum type, GLboolean normalized, auto x) {
        if (!unpack<row>(type, normalized, bits_of(x), value)) return gl().error(GL_INVALID_ENUM);
        set_named<row>(name, value);
      }(arguments...);
    } else if constexpr (named(row.family)) {
      [&](GLuint name, GLenum type, auto x) {
        if (!unpack<row>(type, row.normalized, bits_of(x), value)) return gl().error(GL_INVALID_ENUM);
        set_named<row>(name, value);
      }(arguments...);
    } else {
      [&](GLenum type, auto x) {
        if (!unpack<row>(type, row.normalized, bits_of(x), value)) return gl().error(GL_INVALID_ENUM);
        set_unnamed<row>(value);
      }(arguments...);
    }
  } else {
    const auto with = [&](auto... numbers) {
      if constexpr (row.vector) {
        const auto fill = [&](const auto* p) {
          for (int i = 0; i < row.size; ++i) value[i] = float(plain<row>(load(p, i)));
        };
        (fill(numbers), ...);
      } else {
        int i = 0;
        ((value[i++] = float(plain<row>(numbers))), ...);
      }
    };
    if constexpr (!row.vector && sizeof...(Arguments) != row.size + (named(row.family) ? 1 : 0)) {
      // The registry lacks a parameter: no meaning.
    } else if constexpr (named(row.family)) {
      [&](GLuint name, auto... numbers) {
        with(numbers...);
        set_named<row>(name, value);
      }(arguments...);
    } else {
      with(arguments...);
      set_unnamed<row>(value);
    }
  }
}

template <unsigned command, Row row, typename... Arguments>
auto attribute_function(void(GLAPIENTRY*)(Arguments...)) {
  return &attribute<command, row, Arguments...>;
}

// --- all other calls ----------------------------------------------------------------------------------------------

template <unsigned command, typename Result, typename... Arguments>
Result GLAPIENTRY other(Arguments... arguments) {
  Bytes bytes;
  (bytes.add(&arguments, sizeof arguments), ...);
  gl().called(command, bytes.at, bytes.size);
  if (gl().inside) gl().error(GL_INVALID_OPERATION);
  if constexpr (!std::is_void_v<Result>) return Result{};
}

template <unsigned command, typename Result, typename... Arguments>
auto other_function(Result(GLAPIENTRY*)(Arguments...)) {
  return &other<command, Result, Arguments...>;
}

constexpr GLenum kUnitEnables[] = {GL_TEXTURE_1D,    GL_TEXTURE_2D,    GL_TEXTURE_3D,    GL_TEXTURE_CUBE_MAP,
                                   GL_TEXTURE_RECTANGLE, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R,
                                   GL_TEXTURE_GEN_Q};
bool is_unit_enable(GLenum name) {
  return std::find(std::begin(kUnitEnables), std::end(kUnitEnables), name) != std::end(kUnitEnables);
}

// Names that this driver does not know.
bool unknown(const Gl& g, GLenum name) {
  constexpr struct {
    GLenum name;
    int version;
    const char* extension;
  } kSince[] = {
      {GL_LIGHT_MODEL_COLOR_CONTROL, 12, "EXT_separate_specular_color"},
      {GL_RESCALE_NORMAL, 12, "EXT_rescale_normal"},
      {GL_COLOR_SUM, 14, "EXT_secondary_color"},
      {GL_SAMPLE_BUFFERS, 13, "ARB_multisample"},
      {GL_MULTISAMPLE, 13, "ARB_multisample"},
      {GL_CLAMP_VERTEX_COLOR, 30, "ARB_color_buffer_float"},
      {GL_RGBA_FLOAT_MODE_ARB, 99, "ARB_color_buffer_float"},
      {GL_FRAGMENT_LIGHTING_SGIX, 99, "SGIX_fragment_lighting"},
  };
  const auto* known = std::find_if(std::begin(kSince), std::end(kSince), [&](auto& x) { return x.name == name; });
  return known != std::end(kSince) && g.version_number() < known->version && !g.extension(known->extension);
}

}  // namespace

struct Functions {
  static void GLAPIENTRY begin(GLenum mode) {
    Gl& g = gl();
    g.called(kCommandBegin, &mode, sizeof mode);
    if (g.inside) return g.error(GL_INVALID_OPERATION);
    if (mode > GL_POLYGON) return g.error(GL_INVALID_ENUM);
    g.inside = true;
    g.mode_ = mode;
    g.vertices_.clear();
  }
  static void GLAPIENTRY end() {
    Gl& g = gl();
    g.called(kCommandEnd, nullptr, 0);
    if (!g.inside) return g.error(GL_INVALID_OPERATION);
    g.inside = false;
    if (g.logging) g.drawn.push_back({g.mode_, g.vertices_, g.enabled});
  }
  static GLenum GLAPIENTRY get_error() {
    Gl& g = gl();
    g.called(kCommandGetError, nullptr, 0);
    ++g.get_errors;
    if (g.inside) {
      g.error(GL_INVALID_OPERATION);
      return 0;
    }
    const GLenum code = g.flag;
    g.flag = GL_NO_ERROR;
    g.seen_errors.push_back(code);
    return code;
  }

  // Queries. True: legal now.
  static bool query(unsigned command, GLenum name) {
    Gl& g = gl();
    g.called(command, &name, sizeof name);
    ++g.gets;
    if (g.inside) g.error(GL_INVALID_OPERATION);
    return !g.inside;
  }
  template <typename T>
  static void get(unsigned command, GLenum name, T* out) {
    Gl& g = gl();
    if (!query(command, name)) return;
    const auto copy = [&](const Value& value, int n) { std::copy(value.begin(), value.begin() + n, out); };
    switch (name) {
      case GL_CURRENT_COLOR: return copy(g.current[kColor], 4);
      case GL_CURRENT_NORMAL: return copy(g.current[kNormal], 3);
      case GL_CURRENT_INDEX: return copy(g.current[kIndex], 1);
      case GL_CURRENT_TEXTURE_COORDS: return copy(g.current[kTexture + g.active_unit], 4);
      case GL_CURRENT_SECONDARY_COLOR:
        if (g.version_number() < 14 && !g.extension("EXT_secondary_color")) break;
        return copy(g.current[kSecondaryColor], 4);
      case GL_CURRENT_FOG_COORD:
        if (g.version_number() < 14 && !g.extension("EXT_fog_coord")) break;
        return copy(g.current[kFogCoord], 1);
      case GL_ACTIVE_TEXTURE:
        if (g.version_number() < 13 && !g.extension("ARB_multitexture")) break;
        *out = T(GL_TEXTURE0 + g.active_unit);
        return;
      case GL_ATTRIB_STACK_DEPTH: *out = T(g.attribute_stack.size()); return;
      case GL_NUM_EXTENSIONS:
        if (g.version_number() < 30) break;
        *out = T(g.extensions.size());
        return;
      default: break;
    }
    const auto found = g.numbers.find(name);
    if (found == g.numbers.end() || unknown(g, name)) return g.error(GL_INVALID_ENUM);
    std::transform(found->second.begin(), found->second.end(), out, [](double x) { return T(x); });
  }
  static void GLAPIENTRY get_integer(GLenum name, GLint* out) { get(kCommandGetIntegerv, name, out); }
  static void GLAPIENTRY get_float(GLenum name, GLfloat* out) { get(kCommandGetFloatv, name, out); }
  static void GLAPIENTRY get_boolean(GLenum name, GLboolean* out) { get(kCommandGetBooleanv, name, out); }
  static GLboolean GLAPIENTRY is_enabled(GLenum name) {
    Gl& g = gl();
    if (!query(kCommandIsEnabled, name)) return GL_FALSE;
    const int v = g.version_number();
    if (unknown(g, name) || (name == GL_TEXTURE_3D && v < 12) || (name == GL_TEXTURE_CUBE_MAP && v < 13) ||
        (name == GL_TEXTURE_RECTANGLE && v < 31 && !g.extension("ARB_texture_rectangle")) ||
        (name == GL_DEPTH_CLAMP && v < 32 && !g.extension("ARB_depth_clamp")) ||
        (name == GL_VERTEX_PROGRAM_ARB && !g.extension("ARB_vertex_program")) ||
        (name == GL_FRAGMENT_PROGRAM_ARB && !g.extension("ARB_fragment_program")) ||
        (name == GL_FRAGMENT_PROGRAM_NV && !g.extension("NV_fragment_program")) ||
        (name == GL_FRAGMENT_SHADER_ATI && !g.extension("ATI_fragment_shader")) ||
        (name == GL_VERTEX_SHADER_EXT && !g.extension("EXT_vertex_shader")) ||
        (name == GL_TEXTURE_SHADER_NV && !g.extension("NV_texture_shader"))) {
      g.error(GL_INVALID_ENUM);
      return GL_FALSE;
    }
    if (is_unit_enable(name)) {
      if (g.active_unit >= g.units) g.error(GL_INVALID_OPERATION);
      const auto unit = g.unit_enabled.find(g.active_unit);
      return unit != g.unit_enabled.end() && unit->second.contains(name);
    }
    return g.enabled.contains(name);
  }
  static const GLubyte* GLAPIENTRY get_string(GLenum name) {
    Gl& g = gl();
    if (!query(kCommandGetString, name)) return nullptr;
    if (name == GL_VERSION) return reinterpret_cast<const GLubyte*>(g.version.c_str());
    static std::string all;
    all.clear();
    if (name != GL_EXTENSIONS || g.numbers.contains(GL_CONTEXT_PROFILE_MASK)) {
      // Core profiles have no such string; the scripts that set a profile have GL 3.2.
      g.error(GL_INVALID_ENUM);
      return nullptr;
    }
    for (const std::string& x : g.extensions) all += x + " ";
    return reinterpret_cast<const GLubyte*>(all.c_str());
  }
  static const GLubyte* GLAPIENTRY get_string_i(GLenum name, GLuint index) {
    Gl& g = gl();
    if (!query(kCommandGetStringi, name)) return nullptr;
    if (g.version_number() < 30 || name != GL_EXTENSIONS) {
      g.error(GL_INVALID_ENUM);
      return nullptr;
    }
    auto x = g.extensions.begin();
    std::advance(x, index);
    return reinterpret_cast<const GLubyte*>(x->c_str());
  }
  static GLhandleARB GLAPIENTRY get_handle(GLenum name) {
    Gl& g = gl();
    if (!query(kCommandGetHandleARB, name)) return 0;
    if (!g.extension("ARB_shader_objects")) g.error(GL_INVALID_OPERATION);
    return GLhandleARB(g.numbers.contains(name) ? g.numbers[name][0] : 0);
  }
  static void GLAPIENTRY get_query(GLenum target, GLenum name, GLint* out) {
    Gl& g = gl();
    if (!query(kCommandGetQueryiv, target)) return;
    if (name != GL_CURRENT_QUERY || (g.version_number() < 30 && !g.extension("EXT_transform_feedback"))) {
      return g.error(GL_INVALID_ENUM);
    }
    *out = g.queries[target];
  }
  static void GLAPIENTRY get_pointer(GLenum name, void** out) {
    Gl& g = gl();
    if (!query(kCommandGetPointerv, name)) return;
    const auto found = g.pointers.find(name);
    if (found == g.pointers.end()) return g.error(GL_INVALID_ENUM);
    *out = const_cast<void*>(found->second);
  }
  static void GLAPIENTRY get_material(GLenum face, GLenum property, GLfloat* out) {
    Gl& g = gl();
    if (!query(kCommandGetMaterialfv, property)) return;
    constexpr GLenum kProperties[] = {GL_AMBIENT,  GL_DIFFUSE,   GL_SPECULAR,
                                      GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES};
    const unsigned index = unsigned(std::find(std::begin(kProperties), std::end(kProperties), property) - kProperties);
    const Value& value = g.current[kMaterial + (face == GL_BACK ? kMaterialProperties : 0) + index];
    std::copy(value.begin(), value.begin() + material_size(property), out);
  }
  static void GLAPIENTRY get_light(GLenum light, GLenum property, GLfloat* out) {
    Gl& g = gl();
    if (!query(kCommandGetLightfv, property)) return;
    const auto found = g.lights.find(light);
    if (found == g.lights.end() || !found->second.contains(property)) return g.error(GL_INVALID_ENUM);
    const std::vector<float>& values = found->second[property];
    std::copy(values.begin(), values.end(), out);
  }
  static void GLAPIENTRY enable(GLenum name) { set_enabled(kCommandEnable, name, true); }
  static void GLAPIENTRY disable(GLenum name) { set_enabled(kCommandDisable, name, false); }
  static void set_enabled(unsigned command, GLenum name, bool on) {
    Gl& g = gl();
    g.called(command, &name, sizeof name);
    if (g.inside) return g.error(GL_INVALID_OPERATION);
    if (unknown(g, name)) return g.error(GL_INVALID_ENUM);
    g.enable(name, on);
  }
  static void GLAPIENTRY active_texture(GLenum texture) {
    Gl& g = gl();
    g.called(kCommandActiveTexture, &texture, sizeof texture);
    if (g.inside) return g.error(GL_INVALID_OPERATION);
    if (texture < GL_TEXTURE0 || texture >= GL_TEXTURE0 + g.units) return g.error(GL_INVALID_ENUM);
    g.active_unit = texture - GL_TEXTURE0;
  }
  static void GLAPIENTRY push_attrib(GLbitfield mask) {
    Gl& g = gl();
    g.called(kCommandPushAttrib, &mask, sizeof mask);
    if (g.inside) return g.error(GL_INVALID_OPERATION);
    if (g.attribute_stack.size() >= g.numbers[GL_MAX_ATTRIB_STACK_DEPTH][0]) return g.error(GL_STACK_OVERFLOW);
    g.attribute_stack.push_back({g.current, g.enabled, g.unit_enabled});
  }
  static void GLAPIENTRY pop_attrib() {
    Gl& g = gl();
    g.called(kCommandPopAttrib, nullptr, 0);
    if (g.inside) return g.error(GL_INVALID_OPERATION);
    if (g.attribute_stack.empty()) return g.error(GL_STACK_UNDERFLOW);
    g.current = g.attribute_stack.back().current;
    g.enabled = g.attribute_stack.back().enabled;
    g.unit_enabled = g.attribute_stack.back().unit_enabled;
    g.attribute_stack.pop_back();
  }

  static Driver table() {
    Driver d;
#define TQ_COMMAND(name, result, parameters, arguments) d.name = other_function<kCommand##name>(decltype(d.name){});
#include "gl_commands.inc"
#undef TQ_COMMAND
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_) \
  d.Name = attribute_function<kCommand##Name, kRows[kRow##Name]>(decltype(d.Name){});
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
    d.Begin = begin;
    d.End = end;
    d.GetError = get_error;
    d.GetIntegerv = get_integer;
    d.GetFloatv = get_float;
    d.GetBooleanv = get_boolean;
    d.IsEnabled = is_enabled;
    d.GetString = get_string;
    d.GetStringi = get_string_i;
    d.GetHandleARB = get_handle;
    d.GetQueryiv = get_query;
    d.GetPointerv = get_pointer;
    d.GetMaterialfv = get_material;
    d.GetLightfv = get_light;
    d.Enable = enable;
    d.Disable = disable;
    d.ActiveTexture = d.ActiveTextureARB = active_texture;
    d.PushAttrib = push_attrib;
    d.PopAttrib = pop_attrib;
    return d;
  }
};

Gl::Gl() {
  numbers[GL_RENDER_MODE] = {GL_RENDER};
  numbers[GL_CURRENT_PROGRAM] = {0};
  numbers[GL_POLYGON_MODE] = {GL_FILL, GL_FILL};
  numbers[GL_SUBPIXEL_BITS] = {8};
  numbers[GL_SAMPLE_BUFFERS] = {0};
  numbers[GL_MAX_TEXTURE_UNITS] = {8};
  numbers[GL_MAX_TEXTURE_COORDS] = {8};
  numbers[GL_SHADE_MODEL] = {GL_SMOOTH};
  numbers[GL_MAX_ATTRIB_STACK_DEPTH] = {16};
  numbers[GL_RGBA_MODE] = {GL_TRUE};
  numbers[GL_CLAMP_VERTEX_COLOR] = {GL_TRUE};
  numbers[GL_RGBA_FLOAT_MODE_ARB] = {GL_FALSE};
  numbers[GL_FRONT_FACE] = {GL_CCW};
  numbers[GL_MAX_LIGHTS] = {8};
  numbers[GL_LIGHT_MODEL_AMBIENT] = {0.2, 0.2, 0.2, 1};
  numbers[GL_LIGHT_MODEL_LOCAL_VIEWER] = numbers[GL_LIGHT_MODEL_TWO_SIDE] = {GL_FALSE};
  numbers[GL_LIGHT_MODEL_COLOR_CONTROL] = {GL_SINGLE_COLOR};
  numbers[GL_COLOR_MATERIAL_FACE] = {GL_FRONT_AND_BACK};
  numbers[GL_COLOR_MATERIAL_PARAMETER] = {GL_AMBIENT_AND_DIFFUSE};
  for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 8; ++light) {
    const float bright = light == GL_LIGHT0 ? 1 : 0;
    lights[light] = {{GL_AMBIENT, {0, 0, 0, 1}},
                     {GL_DIFFUSE, {bright, bright, bright, 1}},
                     {GL_SPECULAR, {bright, bright, bright, 1}},
                     {GL_POSITION, {0, 0, 1, 0}},
                     {GL_SPOT_DIRECTION, {0, 0, -1}},
                     {GL_SPOT_EXPONENT, {0}},
                     {GL_SPOT_CUTOFF, {180}},
                     {GL_CONSTANT_ATTENUATION, {1}},
                     {GL_LINEAR_ATTENUATION, {0}},
                     {GL_QUADRATIC_ATTENUATION, {0}}};
  }
  numbers[GL_MODELVIEW_MATRIX] = numbers[GL_PROJECTION_MATRIX] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  numbers[GL_VIEWPORT] = {0, 0, 400, 400};
  for (Value& value : current) value = {0, 0, 0, 1};
  current[kColor] = {1, 1, 1, 1};
  current[kNormal] = {0, 0, 1, 1};
  unit_enabled[0] = {GL_TEXTURE_2D};
}

void Gl::error(GLenum code) {
  if (logging) all_errors.push_back(code);
  if (flag == GL_NO_ERROR) flag = code;
}

void Gl::called(unsigned command, const void* arguments, std::size_t size) {
  if (logging) log.push_back({command, std::string(static_cast<const char*>(arguments), size)});
}

void Gl::set(unsigned place, const Value& value) {
  current[place] = value;
  if (place != kColor || !enabled.contains(GL_COLOR_MATERIAL)) return;
  for (unsigned material = kMaterial; material < kMaterial + 2 * kMaterialProperties; ++material) {
    if (tracked(material)) current[material] = value;
  }
}

void Gl::enable(GLenum name, bool on) {
  std::set<GLenum>& all = is_unit_enable(name) ? unit_enabled[active_unit] : enabled;
  if (on) all.insert(name);
  else all.erase(name);
  if (name == GL_COLOR_MATERIAL) set(kColor, current[kColor]);
}

bool Gl::tracked(unsigned place) const {
  if (!enabled.contains(GL_COLOR_MATERIAL)) return false;
  constexpr GLenum kProperties[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
  const unsigned face = (place - kMaterial) / kMaterialProperties, property = (place - kMaterial) % kMaterialProperties;
  const GLenum tracked_face = GLenum(numbers.at(GL_COLOR_MATERIAL_FACE)[0]);
  const GLenum tracked_property = GLenum(numbers.at(GL_COLOR_MATERIAL_PARAMETER)[0]);
  if (tracked_face == (face == 0 ? GL_BACK : GL_FRONT) || property >= std::size(kProperties)) return false;
  return tracked_property == GL_AMBIENT_AND_DIFFUSE ? property < 2 : kProperties[property] == tracked_property;
}

void Gl::vertex(const Value& position) {
  if (!inside || !logging) return;
  vertices_.push_back(current);
  vertices_.back()[kPosition] = position;
}

Gl& gl() {
  if (!the_gl) the_gl = new Gl;
  return *the_gl;
}
void reset(Gl fresh) { gl() = std::move(fresh); }

const Driver& driver() {
  static const Driver table = Functions::table();
  return table;
}

}  // namespace truequad::fake
