#include "elements.h"

namespace truequad::images {
namespace {

// Positions and texture coordinates as integers, which all types have exactly; matrices undo the steps.
constexpr float kPositionSteps = 64, kTextureSteps = 512;
struct Whole {
  int position[3], texture[2];
  GLubyte color[4];
};
std::vector<Whole> whole_elements_of(const Primitive& p) {
  std::vector<Whole> elements;
  for (const Vertex& v : p.vertices) {
    Whole e{{}, {}, {255, 255, GLubyte(255 - int(v.mark)), 255}};
    for (int i = 0; i < 3; ++i) e.position[i] = int(v.position[std::size_t(i)] * kPositionSteps);
    for (int i = 0; i < 2; ++i) e.texture[i] = int(v.texture[std::size_t(i)] * kTextureSteps);
    elements.push_back(e);
  }
  return elements;
}

void with_steps(const Scene& scene, const std::function<void(const Primitive&)>& draw) {
  glScalef(1 / kPositionSteps, 1 / kPositionSteps, 1 / kPositionSteps);
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  glScalef(1 / kTextureSteps, 1 / kTextureSteps, 1);
  for (const Primitive& p : scene.primitives) draw(p);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

// IEEE 754 half precision of an integer below 2048.
struct Half {
  GLushort bits = 0;
  Half() = default;
  explicit Half(int value) {
    const int magnitude = value < 0 ? -value : value;
    if (magnitude == 0) return;
    int exponent = 0;
    while (magnitude >> (exponent + 1)) ++exponent;
    const int fraction = exponent > 10 ? magnitude >> (exponent - 10) : magnitude << (10 - exponent);
    bits = GLushort((value < 0 ? 0x8000 : 0) | (exponent + 15) << 10 | (fraction & 0x3ff));
  }
};

struct Rgba8 {
  GLubyte of[4];
  explicit Rgba8(const GLubyte (&c)[4]) : of{c[0], c[1], c[2], c[3]} {}
};
struct Bgra8 {
  GLubyte of[4];
  explicit Bgra8(const GLubyte (&c)[4]) : of{c[2], c[1], c[0], c[3]} {}
};
struct Rgb16 {
  GLushort of[3];
  explicit Rgb16(const GLubyte (&c)[4]) : of{GLushort(c[0] * 257), GLushort(c[1] * 257), GLushort(c[2] * 257)} {}
};
struct Rgb32 {
  GLuint of[3];
  explicit Rgb32(const GLubyte (&c)[4]) : of{c[0] * 16843009u, c[1] * 16843009u, c[2] * 16843009u} {}
};

// An array of each, tightly packed, with strides of 0.
template <typename P, typename T, typename C>
Way typed(GLenum position_type, GLenum texture_type, GLint color_size, GLenum color_type) {
  return [=](const Scene& scene) {
    enable_arrays();
    with_steps(scene, [&](const Primitive& p) {
      std::vector<P> position;
      std::vector<T> texture;
      std::vector<C> color;
      for (const Whole& e : whole_elements_of(p)) {
        for (int x : e.position) position.push_back(P(x));
        for (int x : e.texture) texture.push_back(T(x));
        color.push_back(C(e.color));
      }
      glVertexPointer(3, position_type, 0, position.data());
      glTexCoordPointer(2, texture_type, 0, texture.data());
      glColorPointer(color_size, color_type, 0, color.data());
      glDrawArrays(mode_of(p), 0, count_of(p));
    });
    disable_arrays();
  };
}

}  // namespace

void add_typed_ways(std::map<std::string, Way>& ways) {
  ways.insert({
      {"typed_immediate", [](const Scene& s) {
         with_steps(s, [](const Primitive& p) {
           glBegin(mode_of(p));
           for (const Whole& e : whole_elements_of(p)) {
             glColor4ubv(e.color);
             glTexCoord2f(GLfloat(e.texture[0]), GLfloat(e.texture[1]));
             glVertex3f(GLfloat(e.position[0]), GLfloat(e.position[1]), GLfloat(e.position[2]));
           }
           glEnd();
         });
       }},
      {"typed_floats", typed<GLfloat, GLfloat, Rgba8>(GL_FLOAT, GL_FLOAT, 4, GL_UNSIGNED_BYTE)},
      {"typed_shorts", typed<GLshort, GLshort, Bgra8>(GL_SHORT, GL_SHORT, GL_BGRA, GL_UNSIGNED_BYTE)},
      {"typed_ints", typed<GLint, GLint, Rgb16>(GL_INT, GL_INT, 3, GL_UNSIGNED_SHORT)},
      {"typed_doubles", typed<GLdouble, GLdouble, Rgb32>(GL_DOUBLE, GL_DOUBLE, 3, GL_UNSIGNED_INT)},
      {"typed_halves", typed<Half, Half, Rgba8>(GL_HALF_FLOAT, GL_HALF_FLOAT, 4, GL_UNSIGNED_BYTE)},
  });
}

}  // namespace truequad::images
