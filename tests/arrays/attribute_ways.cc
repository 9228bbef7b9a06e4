#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "elements.h"

namespace truequad::images {
namespace {

// What the vertex `i` of a primitive has besides its position and texture coordinates, as near as a type comes to it.
struct Attributes {
  float normal[3], color[4], secondary[3];
};
Attributes attributes_of(std::size_t i) {
  const float x = i & 1 ? 0.5f : -0.4f, y = i & 2 ? 0.3f : -0.6f, step = float(i % 5) / 5;
  return {{x, y, 0.8f}, {0.9f - step / 2, 0.3f + step / 2, i & 1 ? 0.8f : -0.1f, 1}, {step / 3, i & 2 ? 0.4f : 0.1f, 0.2f}};
}

// An array of `size` numbers for each vertex, and what they are worth (GL 4.6 compatibility section 2.3.5: c / (2^(b-1) - 1), not
// below -1).
template <typename T>
class Numbers {
 public:
  static constexpr GLint size_for(GLint size) { return size; }
  void add(const float* values, GLint size) {
    for (GLint i = 0; i < size; ++i) numbers_.push_back(from(values[i]));
  }
  const void* data() const { return numbers_.data(); }
  float worth(std::size_t vertex, GLint size, GLint i) const {
    const T number = numbers_[vertex * std::size_t(size) + std::size_t(i)];
    if constexpr (std::is_floating_point_v<T>) return float(number);
    else return std::max(float(double(number) / double(std::numeric_limits<T>::max())), -1.0f);
  }

 private:
  static T from(float value) {
    if constexpr (std::is_floating_point_v<T>) return T(value) / T(3) * T(3);
    else return T(std::llround((std::is_signed_v<T> ? value : std::max(value, 0.0f)) * double(std::numeric_limits<T>::max())));
  }
  std::vector<T> numbers_;
};

// GL_INT_2_10_10_10_REV or its unsigned twin: a word for each vertex.
template <bool is_signed>
class Packed {
 public:
  static constexpr int kLargest = is_signed ? 511 : 1023;
  // "size … must be 4", or the word has the other order (ARB_vertex_type_2_10_10_10_rev).
  static constexpr GLint size_for(GLint size) { return size == 4 ? 4 : GL_BGRA; }
  void add(const float* values, GLint size) {
    GLuint word = 0;
    for (GLint i = 0; i < 3; ++i) {
      const float value = is_signed ? values[i] : std::max(values[i], 0.0f);
      word |= (GLuint(std::lround(value * kLargest)) & 1023) << 10 * place(i, size);
    }
    words_.push_back(word | 1u << 30);
  }
  const void* data() const { return words_.data(); }
  float worth(std::size_t vertex, GLint size, GLint i) const {
    // The last has two bits, of which 1 was packed.
    if (i == 3) return is_signed ? 1 : float(1 / 3.0);
    const int bits = int(words_[vertex] >> 10 * place(i, size) & 1023);
    return float(is_signed && bits > 511 ? bits - 1024 : bits) / float(kLargest);
  }

 private:
  // Of secondary colours blue comes first.
  static GLint place(GLint i, GLint size) { return size == 2 ? 2 - i : i; }
  std::vector<GLuint> words_;
};
// How the calls below say that they are of secondary colours, which have three components.
template <typename N>
constexpr GLint kSecondary = N::size_for(3) == GL_BGRA ? 2 : 3;

// Packed normals Mesa 22.3 refuses, though the extension has them: they have three components.
template <typename N>
using Normals = std::conditional_t<N::size_for(3) == GL_BGRA, Numbers<GLfloat>, N>;

// Fog coordinates have two types.
template <typename N>
using FogNumber = std::conditional_t<std::is_same_v<N, Numbers<GLdouble>>, GLdouble, GLfloat>;

struct Types {
  GLenum normal, color, fog;
};

template <typename N>
void draw_primitive(const Primitive& p, Types types, bool lit, bool immediate) {
  const auto elements = elements_of(p);
  Normals<N> normals;
  N colors, secondaries;
  std::vector<FogNumber<N>> fog;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Attributes a = attributes_of(i);
    normals.add(a.normal, 3);
    colors.add(a.color, 4);
    secondaries.add(a.secondary, kSecondary<N>);
    fog.push_back(FogNumber<N>(float(i % 3) / 4));
  }
  if (immediate) {
    glBegin(mode_of(p));
    for (std::size_t v = 0; v < elements.size(); ++v) {
      if (lit) glNormal3f(normals.worth(v, 3, 0), normals.worth(v, 3, 1), normals.worth(v, 3, 2));
      glColor4f(colors.worth(v, 4, 0), colors.worth(v, 4, 1), colors.worth(v, 4, 2), colors.worth(v, 4, 3));
      constexpr GLint kSize = kSecondary<N>;
      if (!lit) glSecondaryColor3f(secondaries.worth(v, kSize, 0), secondaries.worth(v, kSize, 1), secondaries.worth(v, kSize, 2));
      if (!lit) glFogCoordf(GLfloat(fog[v]));
      glTexCoord4fv(elements[v].texture);
      glVertex4fv(elements[v].position);
    }
    return glEnd();
  }
  glTexCoordPointer(4, GL_FLOAT, kStride, elements[0].texture);
  glVertexPointer(4, GL_FLOAT, kStride, elements[0].position);
  glColorPointer(4, types.color, 0, colors.data());
  if (lit) glNormalPointer(types.normal, 0, normals.data());
  if (!lit) glSecondaryColorPointer(N::size_for(3), types.color, 0, secondaries.data());
  if (!lit) glFogCoordPointer(types.fog, 0, fog.data());
  glDrawArrays(mode_of(p), 0, count_of(p));
}

// Lit, normals and colours as materials; else colours, secondary colours and fog coordinates.
template <typename N>
Way with_attributes(Types types, bool lit, bool immediate) {
  return [=](const Scene& scene) {
    const std::vector<GLenum> more_arrays = lit ? std::vector<GLenum>{GL_NORMAL_ARRAY}
                                                : std::vector<GLenum>{GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY};
    if (!immediate) {
      enable_arrays();
      for (const GLenum array : more_arrays) glEnableClientState(array);
    }
    constexpr GLfloat kFogColor[] = {0.2f, 0.5f, 0.3f, 1};
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 0);
    glFogf(GL_FOG_END, 1);
    glFogfv(GL_FOG_COLOR, kFogColor);
    glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    const std::vector<GLenum> enabled = lit ? std::vector<GLenum>{GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL, GL_NORMALIZE}
                                            : std::vector<GLenum>{GL_COLOR_SUM, GL_FOG};
    for (const GLenum name : enabled) glEnable(name);
    for (const Primitive& p : scene.primitives) draw_primitive<N>(p, types, lit, immediate);
    for (const GLenum name : enabled) glDisable(name);
    if (!immediate) {
      disable_arrays();
      for (const GLenum array : more_arrays) glDisableClientState(array);
    }
  };
}

}  // namespace

void add_attribute_ways(std::map<std::string, Way>& ways) {
  const auto add = [&]<typename N>(const std::string& name, Types types, const N&) {
    for (const bool lit : {false, true}) {
      const std::string full = (lit ? "lit_" : "colored_") + name;
      ways[full] = with_attributes<N>(types, lit, false);
      ways[full + "_immediate"] = with_attributes<N>(types, lit, true);
    }
  };
  add("floats", {GL_FLOAT, GL_FLOAT, GL_FLOAT}, Numbers<GLfloat>());
  add("doubles", {GL_DOUBLE, GL_DOUBLE, GL_DOUBLE}, Numbers<GLdouble>());
  add("bytes", {GL_BYTE, GL_BYTE, GL_FLOAT}, Numbers<GLbyte>());
  add("shorts", {GL_SHORT, GL_SHORT, GL_FLOAT}, Numbers<GLshort>());
  add("ints", {GL_INT, GL_INT, GL_FLOAT}, Numbers<GLint>());
  add("packed", {GL_FLOAT, GL_INT_2_10_10_10_REV, GL_FLOAT}, Packed<true>());
  add("unsigned_packed", {GL_FLOAT, GL_UNSIGNED_INT_2_10_10_10_REV, GL_FLOAT}, Packed<false>());
}

}  // namespace truequad::images
