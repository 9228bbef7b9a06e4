// draw_arrays FAMILY,FAMILY… COUNT WIDTH HEIGHT WAY FILE: draws scenes from vertex arrays, in one of many ways (ways.h).
#include <cstring>
#include <numeric>

#include "elements.h"

namespace truequad::images {
namespace {

void immediate(const Primitive& p) {
  glBegin(mode_of(p));
  for (const Element& e : elements_of(p)) {
    glColor4fv(e.color);
    glTexCoord4fv(e.texture);
    glVertex4fv(e.position);
  }
  glEnd();
}

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

// All primitives' elements, one behind the other, and the arrays set to them.
Way from_one_array(std::function<void(const Scene&, const std::vector<GLint>& first, const std::vector<GLsizei>& count)> draw) {
  return [draw](const Scene& scene) {
    std::vector<GLint> first;
    std::vector<GLsizei> count;
    const auto all = all_elements(scene, first, count);
    enable_arrays();
    point_at(all);
    draw(scene, first, count);
    disable_arrays();
  };
}

// 0 to 255.
template <typename T>
std::vector<T> counted() {
  std::vector<T> indices(256);
  std::iota(indices.begin(), indices.end(), T(0));
  return indices;
}

// One call for all primitives, which `between` parts.
template <typename T>
Way restarting(GLenum restart, GLenum type, T between, GLuint set) {
  return from_one_array([=](const Scene& s, const auto& first, const auto& count) {
    std::vector<T> indices;
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (GLint k = 0; k < count[i]; ++k) indices.push_back(T(first[i] + k));
      indices.push_back(between);
    }
    glPrimitiveRestartIndex(set);
    glEnable(restart);
    glDrawElements(mode_of(s.primitives[0]), GLsizei(indices.size()), type, indices.data());
    glDisable(restart);
  });
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

// Arrays that are compiled into lists.
void add_list_ways(std::map<std::string, Way>& ways) {
  ways.insert({
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
  });
}

std::map<std::string, Way> ways() {
  std::map<std::string, Way> all = {
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
      {"multi_arrays", from_one_array([](const Scene& s, const auto& first, const auto& count) {
         glMultiDrawArrays(mode_of(s.primitives[0]), first.data(), count.data(), GLsizei(first.size()));
       })},
      {"multi_elements", from_one_array([](const Scene& s, const auto& first, const auto& count) {
         const auto indices = counted<GLushort>();
         std::vector<const void*> starts;
         for (GLint i : first) starts.push_back(indices.data() + i);
         glMultiDrawElements(mode_of(s.primitives[0]), count.data(), GL_UNSIGNED_SHORT, starts.data(), GLsizei(first.size()));
       })},
      {"base_vertex", from_one_array([](const Scene& s, const auto& first, const auto& count) {
         const auto indices = counted<GLubyte>();
         for (std::size_t i = 0; i < first.size(); ++i) {
           glDrawElementsBaseVertex(mode_of(s.primitives[i]), count[i], GL_UNSIGNED_BYTE, indices.data(), first[i]);
         }
       })},
      {"multi_base_vertex", from_one_array([](const Scene& s, const auto& first, const auto& count) {
         const auto indices = counted<GLuint>();
         const std::vector<const void*> starts(first.size(), indices.data());
         glMultiDrawElementsBaseVertex(mode_of(s.primitives[0]), count.data(), GL_UNSIGNED_INT, starts.data(),
                                       GLsizei(first.size()), first.data());
       })},
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
         const auto indices = counted<GLushort>();
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
      {"restart", restarting<GLushort>(GL_PRIMITIVE_RESTART, GL_UNSIGNED_SHORT, 0xfffe, 0xfffe)},
      // The greatest index of the type, whatever is set for GL_PRIMITIVE_RESTART.
      {"restart_fixed", restarting<GLubyte>(GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_UNSIGNED_BYTE, 0xff, 1)},
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
      {"locked", by_primitive([](const Primitive& p, const auto& elements) {
         glLockArraysEXT(0, GLsizei(elements.size()));
         glDrawArrays(mode_of(p), 0, count_of(p));
         glUnlockArraysEXT();
       })},
  };
  add_list_ways(all);
  add_typed_ways(all);
  add_attribute_ways(all);
  add_buffer_ways(all);
  return all;
}

}  // namespace
}  // namespace truequad::images

int main(int count, char** arguments) { return truequad::images::draw_in_a_way(truequad::images::ways(), count, arguments); }
