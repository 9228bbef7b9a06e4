// draw_arrays FAMILY,FAMILY… COUNT WIDTH HEIGHT WAY FILE: draws the scenes of COUNT seeds of each family from vertex arrays, in
// one of many ways, and writes the raw pictures. A program like any other, which knows nothing of truequad.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "scenes.h"

namespace truequad::images {
namespace {

constexpr int kTexels = 256;
constexpr GLenum kModes[] = {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};

void make_texture() {
  std::vector<unsigned char> texels;
  for (int j = 0; j < kTexels; ++j) {
    for (int i = 0; i < kTexels; ++i) {
      texels.insert(texels.end(), {(unsigned char)(i), (unsigned char)(j), (unsigned char)(i ^ j), 255});
    }
  }
  GLuint name;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kTexels, kTexels, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

// The vertices of one primitive as arrays hold them; glInterleavedArrays knows this as GL_T4F_C4F_N3F_V4F.
struct Element {
  GLfloat texture[4], color[4], normal[3], position[4];
};
constexpr GLsizei kStride = sizeof(Element);

GLenum mode_of(const Primitive& p) { return kModes[int(p.mode)]; }
GLsizei count_of(const Primitive& p) { return GLsizei(p.vertices.size()); }

std::vector<Element> elements_of(const Primitive& p) {
  std::vector<Element> elements;
  for (const Vertex& v : p.vertices) {
    Element e{{}, {1, 1, 1 - v.mark / 255.0f, 1}, {0, 0, 1}, {}};
    std::memcpy(e.texture, v.texture.data(), sizeof e.texture);
    std::memcpy(e.position, v.position.data(), sizeof e.position);
    elements.push_back(e);
  }
  return elements;
}

// Of all primitives; `first` says where each begins.
std::vector<Element> all_elements(const Scene& scene, std::vector<GLint>& first, std::vector<GLsizei>& count) {
  std::vector<Element> all;
  for (const Primitive& p : scene.primitives) {
    first.push_back(GLint(all.size()));
    count.push_back(count_of(p));
    const auto elements = elements_of(p);
    all.insert(all.end(), elements.begin(), elements.end());
  }
  return all;
}

// `base`: an address, or an offset in the buffer that is bound.
void point_at(const unsigned char* base, GLsizei stride = kStride) {
  glTexCoordPointer(4, GL_FLOAT, stride, base + offsetof(Element, texture));
  glColorPointer(4, GL_FLOAT, stride, base + offsetof(Element, color));
  glVertexPointer(4, GL_FLOAT, stride, base + offsetof(Element, position));
}
void point_at(const std::vector<Element>& elements) {
  point_at(reinterpret_cast<const unsigned char*>(elements.data()));
}
constexpr GLenum kArrays[] = {GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY, GL_VERTEX_ARRAY};
void enable_arrays() {
  for (GLenum array : kArrays) glEnableClientState(array);
}
void disable_arrays() {
  for (GLenum array : kArrays) glDisableClientState(array);
}

void immediate(const Primitive& p) {
  glBegin(mode_of(p));
  for (const Element& e : elements_of(p)) {
    glColor4fv(e.color);
    glTexCoord4fv(e.texture);
    glVertex4fv(e.position);
  }
  glEnd();
}

const unsigned char* offset(std::size_t bytes) { return reinterpret_cast<const unsigned char*>(bytes); }

using Way = std::function<void(const Scene&)>;
using EachPrimitive = std::function<void(const Primitive&, const std::vector<Element>&)>;

// Each primitive with its elements in client memory, and the arrays set to them.
auto by_primitive(EachPrimitive draw) {
  return [draw](const Scene& scene) {
    enable_arrays();
    for (const Primitive& p : scene.primitives) {
      const auto elements = elements_of(p);
      point_at(elements);
      draw(p, elements);
    }
    disable_arrays();
  };
}

// Indices that put the elements in another order; `elements` is rearranged to match.
template <typename T>
std::vector<T> shuffled(std::vector<Element>& elements) {
  const std::size_t count = elements.size();
  std::vector<T> indices(count);
  std::vector<Element> moved(count);
  for (std::size_t i = 0; i < count; ++i) {
    indices[i] = T(count - 1 - i);
    moved[count - 1 - i] = elements[i];
  }
  elements = moved;
  return indices;
}

template <typename T>
void indexed(const Scene& scene, GLenum type, bool range) {
  enable_arrays();
  for (const Primitive& p : scene.primitives) {
    auto elements = elements_of(p);
    const auto indices = shuffled<T>(elements);
    point_at(elements);
    if (range) glDrawRangeElements(mode_of(p), 0, GLuint(elements.size() - 1), count_of(p), type, indices.data());
    else glDrawElements(mode_of(p), count_of(p), type, indices.data());
  }
  disable_arrays();
}

GLuint buffer_of(GLenum target, std::size_t size, const void* data, GLenum usage = GL_STATIC_DRAW) {
  GLuint name;
  glGenBuffers(1, &name);
  glBindBuffer(target, name);
  glBufferData(target, GLsizeiptr(size), data, usage);
  return name;
}
void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }

// All elements in one buffer behind a gap, `fill` puts them there; each primitive by glDrawArrays.
void from_buffer(const Scene& scene, const std::function<void(std::size_t gap, std::size_t size, const void*)>& fill) {
  constexpr std::size_t kGap = 12;
  std::vector<GLint> first;
  std::vector<GLsizei> count;
  const auto all = all_elements(scene, first, count);
  const std::size_t size = all.size() * sizeof(Element);
  const GLuint buffer = buffer_of(GL_ARRAY_BUFFER, kGap + size, nullptr);
  fill(kGap, size, all.data());
  enable_arrays();
  point_at(offset(kGap));
  for (std::size_t i = 0; i < first.size(); ++i) glDrawArrays(mode_of(scene.primitives[i]), first[i], count[i]);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  disable_arrays();
  delete_buffer(buffer);
}

// The buffer has other contents when it is first drawn from; then `change` replaces them.
auto changed_buffer(const std::function<void(GLuint, std::size_t, const void*)>& change, bool mutable_ = true) {
  return [change, mutable_](const Scene& scene) {
    std::vector<GLint> first;
    std::vector<GLsizei> count;
    const auto all = all_elements(scene, first, count);
    const std::size_t size = all.size() * sizeof(Element);
    auto others = all;
    for (Element& e : others) {
      e.position[0] = -e.position[0] * 0.75f;
      e.texture[0] = 1 - e.texture[0];
    }
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    if (mutable_) {
      glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(size), others.data(), GL_DYNAMIC_DRAW);
    } else {
      glBufferStorage(GL_ARRAY_BUFFER, GLsizeiptr(size), others.data(),
                      GL_DYNAMIC_STORAGE_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT);
    }
    enable_arrays();
    point_at(offset(0));
    const auto draw = [&] {
      for (std::size_t i = 0; i < first.size(); ++i) glDrawArrays(mode_of(scene.primitives[i]), first[i], count[i]);
    };
    draw();
    glClear(GL_COLOR_BUFFER_BIT);
    change(buffer, size, all.data());
    draw();
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    disable_arrays();
    delete_buffer(buffer);
  };
}

// A second pass over what `first` drew, on the same depths, added to it.
void two_passes(const Scene& scene, const Way& first, const Way& second) {
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  first(scene);
  glDepthFunc(GL_EQUAL);
  glBlendFunc(GL_ONE, GL_ONE);
  glEnable(GL_BLEND);
  second(scene);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
}

void immediate_primitives(const Scene& scene) {
  for (const Primitive& p : scene.primitives) immediate(p);
}
void primitives_from_arrays(const Scene& scene) {
  by_primitive([](const Primitive& p, const auto&) { glDrawArrays(mode_of(p), 0, count_of(p)); })(scene);
}

// A rectangle with a warped texture, and another without texture on it.
void rectangles(const std::function<void()>& second) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glRotatef(30, 1, 1, 0);
  two_passes(
      {},
      [](const Scene&) {
        glColor3f(1, 1, 1);
        glBegin(GL_QUADS);
        glTexCoord2f(0.1f, 0.1f), glVertex2f(-0.75f, -0.5f);
        glTexCoord2f(0.9f, 0.1f), glVertex2f(0.5f, -0.5f);
        glTexCoord2f(0.6f, 0.9f), glVertex2f(0.5f, 0.75f);
        glTexCoord2f(0.4f, 0.8f), glVertex2f(-0.75f, 0.75f);
        glEnd();
      },
      [&](const Scene&) {
        glDisable(GL_TEXTURE_2D);
        glColor3f(0.25f, 0.25f, 0);
        second();
        glEnable(GL_TEXTURE_2D);
      });
}

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

void look(const Scene& scene) {
  glViewport(scene.viewport[0], scene.viewport[1], scene.viewport[2], scene.viewport[3]);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(scene.projection.data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(scene.modelview.data());
  glShadeModel(scene.primitives.front().mode == Mode::kQuadStrip ? GL_FLAT : GL_SMOOTH);
  glEnable(GL_TEXTURE_2D);
}

OSMesaContext first_context, second_context;
std::vector<unsigned char> canvas;
int canvas_width, canvas_height;

void make_current(OSMesaContext context) {
  OSMesaMakeCurrent(context, canvas.data(), GL_UNSIGNED_BYTE, canvas_width, canvas_height);
}

const std::map<std::string, Way>& ways() {
  static const std::map<std::string, Way> all = {
      {"immediate", immediate_primitives},
      {"passes_immediate", [](const Scene& s) { two_passes(s, immediate_primitives, immediate_primitives); }},
      {"passes_arrays", [](const Scene& s) { two_passes(s, immediate_primitives, primitives_from_arrays); }},
      {"passes_arrays_first", [](const Scene& s) { two_passes(s, primitives_from_arrays, immediate_primitives); }},
      {"rectangle_immediate", [](const Scene&) {
         rectangles([] {
           glBegin(GL_QUADS);
           glVertex2f(-0.75f, -0.5f), glVertex2f(0.5f, -0.5f), glVertex2f(0.5f, 0.75f), glVertex2f(-0.75f, 0.75f);
           glEnd();
         });
       }},
      {"rectangle", [](const Scene&) { rectangles([] { glRectf(-0.75f, -0.5f, 0.5f, 0.75f); }); }},
      {"arrays", by_primitive([](const Primitive& p, const auto&) { glDrawArrays(mode_of(p), 0, count_of(p)); })},
      {"arrays_ext", by_primitive([](const Primitive& p, const auto&) { glDrawArraysEXT(mode_of(p), 0, count_of(p)); })},
      {"twice", by_primitive([](const Primitive& p, const auto&) {
         glDrawArrays(mode_of(p), 0, count_of(p));
         glDrawArrays(mode_of(p), 0, count_of(p));
       })},
      {"bytes", [](const Scene& s) { indexed<GLubyte>(s, GL_UNSIGNED_BYTE, false); }},
      {"shorts", [](const Scene& s) { indexed<GLushort>(s, GL_UNSIGNED_SHORT, false); }},
      {"ints", [](const Scene& s) { indexed<GLuint>(s, GL_UNSIGNED_INT, false); }},
      {"range", [](const Scene& s) { indexed<GLushort>(s, GL_UNSIGNED_SHORT, true); }},
      {"interleaved", [](const Scene& s) {
         for (const Primitive& p : s.primitives) {
           const auto elements = elements_of(p);
           glInterleavedArrays(GL_T4F_C4F_N3F_V4F, 0, elements.data());
           glDrawArrays(mode_of(p), 0, count_of(p));
         }
         disable_arrays();
         glDisableClientState(GL_NORMAL_ARRAY);
       }},
      {"pushed", [](const Scene& s) {
         for (const Primitive& p : s.primitives) {
           const auto elements = elements_of(p);
           enable_arrays();
           point_at(elements);
           glDrawArrays(mode_of(p), 0, count_of(p));
           glClear(GL_COLOR_BUFFER_BIT);
           glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
           glVertexPointer(4, GL_FLOAT, kStride, elements[0].texture);
           glPopClientAttrib();
           glDrawArrays(mode_of(p), 0, count_of(p));
           disable_arrays();
         }
       }},
      // The arrays are doubles, one behind the other, without strides.
      {"doubles", [](const Scene& s) {
         enable_arrays();
         for (const Primitive& p : s.primitives) {
           std::vector<GLdouble> texture, position;
           std::vector<GLfloat> color;
           for (const Element& e : elements_of(p)) {
             texture.insert(texture.end(), e.texture, e.texture + 4);
             position.insert(position.end(), e.position, e.position + 4);
             color.insert(color.end(), e.color, e.color + 3);
           }
           glTexCoordPointer(4, GL_DOUBLE, 0, texture.data());
           glVertexPointer(4, GL_DOUBLE, 0, position.data());
           glColorPointer(3, GL_FLOAT, 0, color.data());
           glDrawArrays(mode_of(p), 0, count_of(p));
         }
         disable_arrays();
       }},
      // At odd addresses, as packed structures of programs are.
      {"unaligned", [](const Scene& s) {
         enable_arrays();
         for (const Primitive& p : s.primitives) {
           const auto elements = elements_of(p);
           std::vector<unsigned char> bytes(1 + elements.size() * (sizeof(Element) + 1));
           for (std::size_t i = 0; i < elements.size(); ++i) {
             std::memcpy(bytes.data() + 1 + i * (sizeof(Element) + 1), &elements[i], sizeof(Element));
           }
           point_at(bytes.data() + 1, kStride + 1);
           glDrawArrays(mode_of(p), 0, count_of(p));
         }
         disable_arrays();
       }},
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
      {"multi_arrays", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         enable_arrays();
         point_at(all);
         glMultiDrawArrays(mode_of(s.primitives[0]), first.data(), count.data(), GLsizei(first.size()));
         disable_arrays();
       }},
      {"multi_elements", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         std::vector<GLushort> indices;
         for (std::size_t i = 0; i < all.size(); ++i) indices.push_back(GLushort(i));
         std::vector<const void*> starts;
         for (GLint i : first) starts.push_back(indices.data() + i);
         enable_arrays();
         point_at(all);
         glMultiDrawElements(mode_of(s.primitives[0]), count.data(), GL_UNSIGNED_SHORT, starts.data(), GLsizei(first.size()));
         disable_arrays();
       }},
      {"base_vertex", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         std::vector<GLubyte> indices;
         for (int i = 0; i < 256; ++i) indices.push_back(GLubyte(i));
         enable_arrays();
         point_at(all);
         for (std::size_t i = 0; i < first.size(); ++i) {
           glDrawElementsBaseVertex(mode_of(s.primitives[i]), count[i], GL_UNSIGNED_BYTE, indices.data(), first[i]);
         }
         disable_arrays();
       }},
      {"multi_base_vertex", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         std::vector<GLuint> indices;
         for (GLuint i = 0; i < 256; ++i) indices.push_back(i);
         const std::vector<const void*> starts(first.size(), indices.data());
         enable_arrays();
         point_at(all);
         glMultiDrawElementsBaseVertex(mode_of(s.primitives[0]), count.data(), GL_UNSIGNED_INT, starts.data(),
                                       GLsizei(first.size()), first.data());
         disable_arrays();
       }},
      {"instanced", by_primitive([](const Primitive& p, const auto&) {
         glDrawArraysInstanced(mode_of(p), 0, count_of(p), 2);
       })},
      {"indirect", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         const GLuint buffer = buffer_of(GL_ARRAY_BUFFER, all.size() * sizeof(Element), all.data());
         std::vector<GLuint> commands;
         for (std::size_t i = 0; i < first.size(); ++i) {
           commands.insert(commands.end(), {GLuint(count[i]), 1u, GLuint(first[i]), 0u});
         }
         const GLuint indirect = buffer_of(GL_DRAW_INDIRECT_BUFFER, commands.size() * 4, commands.data());
         enable_arrays();
         point_at(offset(0));
         for (std::size_t i = 0; i < first.size(); ++i) glDrawArraysIndirect(mode_of(s.primitives[0]), offset(16 * i));
         glClear(GL_COLOR_BUFFER_BIT);
         glMultiDrawArraysIndirect(mode_of(s.primitives[0]), nullptr, GLsizei(first.size()), 0);
         disable_arrays();
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
         delete_buffer(buffer);
         delete_buffer(indirect);
       }},
      {"indirect_elements", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         std::vector<GLushort> indices;
         for (GLushort i = 0; i < 256; ++i) indices.push_back(i);
         const GLuint buffer = buffer_of(GL_ARRAY_BUFFER, all.size() * sizeof(Element), all.data());
         const GLuint elements = buffer_of(GL_ELEMENT_ARRAY_BUFFER, indices.size() * 2, indices.data());
         enable_arrays();
         point_at(offset(0));
         for (std::size_t i = 0; i < first.size(); ++i) {
           // In the client's memory, which compatibility contexts allow.
           const GLint command[] = {count[i], 1, 0, first[i], 0};
           glDrawElementsIndirect(mode_of(s.primitives[0]), GL_UNSIGNED_SHORT, command);
         }
         disable_arrays();
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
         delete_buffer(buffer);
         delete_buffer(elements);
       }},
      {"restart", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         std::vector<GLushort> indices;
         for (std::size_t i = 0; i < first.size(); ++i) {
           for (GLint k = 0; k < count[i]; ++k) indices.push_back(GLushort(first[i] + k));
           indices.push_back(0xfffe);
         }
         glPrimitiveRestartIndex(0xfffe);
         glEnable(GL_PRIMITIVE_RESTART);
         enable_arrays();
         point_at(all);
         glDrawElements(mode_of(s.primitives[0]), GLsizei(indices.size()), GL_UNSIGNED_SHORT, indices.data());
         disable_arrays();
         glDisable(GL_PRIMITIVE_RESTART);
       }},
      {"array_element", by_primitive([](const Primitive& p, const auto&) {
         glBegin(mode_of(p));
         for (GLint i = 0; i < count_of(p); ++i) glArrayElement(i);
         glEnd();
       })},
      // Positions alone by element, the rest by calls.
      {"mixed_element", by_primitive([](const Primitive& p, const auto& elements) {
         glDisableClientState(GL_COLOR_ARRAY);
         glBegin(mode_of(p));
         for (GLint i = 0; i < count_of(p); ++i) {
           glColor4fv(elements[std::size_t(i)].color);
           glArrayElement(i);
         }
         glEnd();
         glEnableClientState(GL_COLOR_ARRAY);
       })},
      {"element_of_buffer", [](const Scene& s) {
         std::vector<GLint> first;
         std::vector<GLsizei> count;
         const auto all = all_elements(s, first, count);
         const GLuint buffer = buffer_of(GL_ARRAY_BUFFER, all.size() * sizeof(Element), all.data());
         enable_arrays();
         point_at(offset(0));
         for (std::size_t i = 0; i < first.size(); ++i) {
           glBegin(mode_of(s.primitives[i]));
           for (GLint k = 0; k < count[i]; ++k) glArrayElement(first[i] + k);
           glEnd();
         }
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         disable_arrays();
         delete_buffer(buffer);
       }},
      {"list", [](const Scene& s) {
         enable_arrays();
         glNewList(5, GL_COMPILE);
         for (const Primitive& p : s.primitives) {
           const auto elements = elements_of(p);
           point_at(elements);
           glDrawArrays(mode_of(p), 0, count_of(p));
         }
         glEndList();
         disable_arrays();
         glCallList(5);
       }},
      {"list_of_elements", [](const Scene& s) {
         enable_arrays();
         glNewList(5, GL_COMPILE);
         for (const Primitive& p : s.primitives) {
           auto elements = elements_of(p);
           const auto indices = shuffled<GLuint>(elements);
           point_at(elements);
           glDrawElements(mode_of(p), count_of(p), GL_UNSIGNED_INT, indices.data());
         }
         glEndList();
         disable_arrays();
         glCallList(5);
       }},
      {"list_executed", [](const Scene& s) {
         enable_arrays();
         glNewList(5, GL_COMPILE_AND_EXECUTE);
         for (const Primitive& p : s.primitives) {
           const auto elements = elements_of(p);
           point_at(elements);
           glDrawArrays(mode_of(p), 0, count_of(p));
         }
         glEndList();
         disable_arrays();
       }},
      {"list_of_array_element", [](const Scene& s) {
         enable_arrays();
         glNewList(5, GL_COMPILE);
         for (const Primitive& p : s.primitives) {
           const auto elements = elements_of(p);
           point_at(elements);
           glBegin(mode_of(p));
           for (GLint i = 0; i < count_of(p); ++i) glArrayElement(i);
           glEnd();
         }
         glEndList();
         disable_arrays();
         glCallList(5);
       }},
      {"locked", by_primitive([](const Primitive& p, const auto& elements) {
         glLockArraysEXT(0, GLsizei(elements.size()));
         glDrawArrays(mode_of(p), 0, count_of(p));
         glUnlockArraysEXT();
       })},
      {"buffer", [](const Scene& s) {
         from_buffer(s, [](std::size_t gap, std::size_t size, const void* data) {
           glBufferSubData(GL_ARRAY_BUFFER, GLintptr(gap), GLsizeiptr(size), data);
         });
       }},
      {"index_buffer", [](const Scene& s) {
         enable_arrays();
         for (const Primitive& p : s.primitives) {
           auto elements = elements_of(p);
           const auto indices = shuffled<GLushort>(elements);
           point_at(elements);
           const GLuint buffer = buffer_of(GL_ELEMENT_ARRAY_BUFFER, 4 + indices.size() * 2, nullptr);
           glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 4, GLsizeiptr(indices.size() * 2), indices.data());
           glDrawElements(mode_of(p), count_of(p), GL_UNSIGNED_SHORT, offset(4));
           glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
           delete_buffer(buffer);
         }
         disable_arrays();
       }},
      {"vertex_array_objects", [](const Scene& s) {
         std::vector<GLuint> objects(s.primitives.size()), buffers(s.primitives.size());
         glGenVertexArrays(GLsizei(objects.size()), objects.data());
         for (std::size_t i = 0; i < objects.size(); ++i) {
           const auto elements = elements_of(s.primitives[i]);
           glBindVertexArray(objects[i]);
           buffers[i] = buffer_of(GL_ARRAY_BUFFER, elements.size() * sizeof(Element), elements.data());
           enable_arrays();
           point_at(offset(0));
         }
         for (std::size_t i = 0; i < objects.size(); ++i) {
           glBindVertexArray(objects[i]);
           glDrawArrays(mode_of(s.primitives[i]), 0, count_of(s.primitives[i]));
         }
         glBindVertexArray(0);
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         glDeleteVertexArrays(GLsizei(objects.size()), objects.data());
         glDeleteBuffers(GLsizei(buffers.size()), buffers.data());
       }},
      {"data", changed_buffer([](GLuint, std::size_t size, const void* data) {
         glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(size), data, GL_DYNAMIC_DRAW);
       })},
      {"sub_data", changed_buffer([](GLuint, std::size_t size, const void* data) {
         glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), data);
       })},
      {"named", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         // OSMesa does not export it.
         const auto named = PFNGLNAMEDBUFFERSUBDATAPROC(OSMesaGetProcAddress("glNamedBufferSubData"));
         named(name, 0, GLsizeiptr(size), data);
       })},
      {"map", changed_buffer([](GLuint, std::size_t size, const void* data) {
         std::memcpy(glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY), data, size);
         glUnmapBuffer(GL_ARRAY_BUFFER);
       })},
      {"map_range", changed_buffer([](GLuint, std::size_t size, const void* data) {
         void* to = glMapBufferRange(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
         std::memcpy(to, data, size);
         glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, GLsizeiptr(size));
         glUnmapBuffer(GL_ARRAY_BUFFER);
       })},
      {"copied", changed_buffer([](GLuint, std::size_t size, const void* data) {
         const GLuint other = buffer_of(GL_COPY_READ_BUFFER, size, data);
         glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, GLsizeiptr(size));
         delete_buffer(other);
       })},
      {"cleared", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         const GLuint zero = 0;
         glClearBufferData(GL_ARRAY_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
         glInvalidateBufferData(name);
         glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), data);
       })},
      {"deleted", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         delete_buffer(name);
         glBindBuffer(GL_ARRAY_BUFFER, name);
         glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(size), data, GL_STREAM_DRAW);
         point_at(offset(0));
       })},
      {"other_context", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         glFinish();
         make_current(second_context);
         glBindBuffer(GL_ARRAY_BUFFER, name);
         glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), data);
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         glFinish();
         make_current(first_context);
       })},
      {"pixels_packed", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         // The same bytes through a texture.
         glPushAttrib(GL_ALL_ATTRIB_BITS);
         GLuint texture;
         glGenTextures(1, &texture);
         glBindTexture(GL_TEXTURE_2D, texture);
         glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, GLsizei(size / 4), 1, 0, GL_RED, GL_FLOAT, data);
         glBindBuffer(GL_PIXEL_PACK_BUFFER, name);
         glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, nullptr);
         glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
         glDeleteTextures(1, &texture);
         glPopAttrib();
       })},
      {"persistent", changed_buffer([](GLuint, std::size_t size, const void* data) {
         void* to = glMapBufferRange(GL_ARRAY_BUFFER, 0, GLsizeiptr(size),
                                     GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT);
         std::memcpy(to, data, size);
       }, false)},
  };
  return all;
}

int run(int count, char** arguments) {
  const auto way = count == 7 ? ways().find(arguments[5]) : ways().end();
  if (way == ways().end()) {
    std::fprintf(stderr, "usage: %s FAMILIES COUNT WIDTH HEIGHT WAY FILE\n", arguments[0]);
    return 2;
  }
  const unsigned seeds = unsigned(std::atoi(arguments[2]));
  canvas_width = std::atoi(arguments[3]);
  canvas_height = std::atoi(arguments[4]);
  canvas.resize(std::size_t(canvas_width) * std::size_t(canvas_height) * 4);
  std::FILE* file = std::fopen(arguments[6], "wb");
  first_context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  second_context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, first_context);
  if (!file || !first_context || !second_context) return 70;
  make_current(first_context);
  make_texture();
  bool written = true;
  std::istringstream names(arguments[1]);
  for (std::string name; std::getline(names, name, ',');) {
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const Scene scene = family(name).make(seed, canvas_width, canvas_height);
      glClear(GL_COLOR_BUFFER_BIT);
      look(scene);
      way->second(scene);
      glFinish();
      written = written && std::fwrite(canvas.data(), canvas.size(), 1, file) == 1;
    }
  }
  for (OSMesaContext context : {second_context, first_context}) {
    make_current(context);
    if (const GLenum error = glGetError()) {
      std::fprintf(stderr, "%s: GL error 0x%x\n", arguments[0], error);
      return 1;
    }
  }
  return std::fclose(file) == 0 && written ? 0 : 1;
}

}  // namespace
}  // namespace truequad::images

int main(int count, char** arguments) { return truequad::images::run(count, arguments); }
