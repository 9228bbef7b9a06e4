// draw_lists FAMILY,FAMILY… COUNT WIDTH HEIGHT WAY FILE: draws scenes through display lists, in one of many ways (ways.h).
#include <vector>

#include "list_ways.h"

namespace truequad::images {

void vertex(const Vertex& v) {
  glColor3f(1, 1, 1 - v.mark / 255.0f);
  glTexCoord4fv(v.texture.data());
  glVertex4fv(v.position.data());
}

void primitive(const Primitive& p) {
  glBegin(mode_of(p));
  for (const Vertex& v : p.vertices) vertex(v);
  glEnd();
}

void primitives(const Scene& scene) {
  for (const Primitive& p : scene.primitives) primitive(p);
}

// A triangle that is not seen and changes of state, so that quads are not alone in their list.
void something_else() {
  glPushMatrix();
  glTranslatef(0, 0, 0.001f);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDisable(GL_TEXTURE_2D);
  glBegin(GL_TRIANGLES);
  glColor3f(0.25f, 0.5f, 0.75f);
  glVertex2f(-1, -1);
  glVertex2f(-0.95f, -1);
  glVertex2f(-1, -0.95f);
  glEnd();
  glEnable(GL_TEXTURE_2D);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPopMatrix();
}

void look_elsewhere() {
  glViewport(0, 0, 16, 16);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glDisable(GL_TEXTURE_2D);
}

namespace {

// Lists of vertices, called in the primitive of a list that is executed while it is compiled, and called again: both
// pictures are seen, the second one a little lower.
void inside_executed_begin(const Scene& scene, bool many) {
  for (const Primitive& p : scene.primitives) {
    std::vector<GLuint> names;
    for (std::size_t i = 0; i < p.vertices.size(); ++i) {
      names.push_back(20 + GLuint(i));
      glNewList(names.back(), GL_COMPILE);
      vertex(p.vertices[i]);
      glEndList();
    }
    glNewList(10, GL_COMPILE_AND_EXECUTE);
    glBegin(mode_of(p));
    if (many) glCallLists(GLsizei(names.size()), GL_UNSIGNED_INT, names.data());
    else for (GLuint name : names) glCallList(name);
    glEnd();
    glEndList();
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glTranslatef(0, -0.25f, 0);
    glMultMatrixf(scene.projection.data());
    glCallList(10);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
  }
}

// Lists of vertices, called together in a primitive, after `set_base` has made 2000 the base. With `listed` these calls are
// a list of that mode themselves, in which Mesa 22.3 alone crashes.
template <typename F, typename G>
void inside_begin_by_base(const Scene& scene, F before, GLenum list, G set_base) {
  for (const Primitive& p : scene.primitives) {
    std::vector<GLubyte> names;
    for (std::size_t i = 0; i < p.vertices.size(); ++i) {
      glNewList(2000 + GLuint(i), GL_COMPILE);
      vertex(p.vertices[i]);
      glEndList();
      names.push_back(GLubyte(i));
    }
    before();
    if (list) glNewList(10, list);
    set_base();
    glBegin(mode_of(p));
    glCallLists(GLsizei(names.size()), GL_UNSIGNED_BYTE, names.data());
    glEnd();
    if (list) glEndList();
    if (list == GL_COMPILE) glCallList(10);
    glListBase(0);
  }
}

template <typename F>
void inside_begin_by_base(const Scene& scene, F set_base) {
  inside_begin_by_base(scene, [] {}, 0, set_base);
}

// The base is 2000, below another on the stack.
void push_base() {
  glListBase(2000);
  glPushAttrib(GL_LIST_BIT);
  glListBase(3000);
}

// Three quads side by side in one glBegin. The outer ones are nearly affine, so that they need no correction, but their
// colours and textures show along which diagonal they are cut; the one in the middle needs correction.
void three_quads() {
  look_elsewhere();
  glViewport(0, 0, canvas_width, canvas_height);
  glEnable(GL_TEXTURE_2D);
  glShadeModel(GL_SMOOTH);
  glNewList(9, GL_COMPILE);
  glBegin(GL_QUADS);
  for (int i = 0; i < 3; ++i) {
    const float left = -0.95f + 0.65f * float(i), right = left + 0.55f, bent = i == 1 ? 0.2f : 0.005f;
    glColor3f(1, 0.5f, 0.5f);
    glTexCoord2f(0, 0);
    glVertex2f(left, -0.8f);
    glColor3f(0, 1, 0);
    glTexCoord2f(1, 0);
    glVertex2f(right, -0.8f);
    glColor3f(0.5f, 0.5f, 1);
    glTexCoord2f(1, 1);
    glVertex2f(right - bent, 0.8f);
    glColor3f(1, 1, 0);
    glTexCoord2f(0, 1);
    glVertex2f(left, 0.8f);
  }
  glEnd();
  glEndList();
  glCallList(9);
}

std::map<std::string, Way> ways() {
  std::map<std::string, Way> all = {
      {"immediate", [](const Scene& s) { primitives(s); }},
      {"list",
       [](const Scene& s) {
         look_elsewhere();
         const GLuint list = glGenLists(1);
         glNewList(list, GL_COMPILE);
         primitives(s);
         glEndList();
         look(s);
         glCallList(list);
       }},
      {"without_gen",
       [](const Scene& s) {
         glNewList(77, GL_COMPILE);
         primitives(s);
         glEndList();
         glCallList(77);
       }},
      {"execute",
       [](const Scene& s) {
         glNewList(5, GL_COMPILE_AND_EXECUTE);
         primitives(s);
         glEndList();
       }},
      {"execute_then_call",
       [](const Scene& s) {
         glNewList(5, GL_COMPILE_AND_EXECUTE);
         primitives(s);
         glEndList();
         glClear(GL_COLOR_BUFFER_BIT);
         glCallList(5);
       }},
      {"called_twice",
       [](const Scene& s) {
         glNewList(5, GL_COMPILE);
         primitives(s);
         glEndList();
         look_elsewhere();
         glCallList(5);
         look(s);
         glClear(GL_COLOR_BUFFER_BIT);
         glCallList(5);
       }},
      {"nested",
       [](const Scene& s) {
         const GLuint lists = glGenLists(3);
         glNewList(lists, GL_COMPILE);
         glCallList(lists + 1);
         glEndList();
         glNewList(lists + 1, GL_COMPILE);
         glPushMatrix();
         glCallList(lists + 2);
         glPopMatrix();
         glEndList();
         glNewList(lists + 2, GL_COMPILE);
         primitives(s);
         glEndList();
         glCallList(lists);
       }},
      {"each_its_own",
       [](const Scene& s) {
         const GLuint lists = glGenLists(GLsizei(s.primitives.size()));
         std::vector<GLushort> names;
         for (std::size_t i = 0; i < s.primitives.size(); ++i) {
           glNewList(lists + GLuint(i), GL_COMPILE);
           primitive(s.primitives[i]);
           glEndList();
           names.push_back(GLushort(i));
         }
         glListBase(lists);
         glCallLists(GLsizei(names.size()), GL_UNSIGNED_SHORT, names.data());
         glListBase(0);
       }},
      {"call_lists_in_list", [](const Scene& s) {
         glNewList(1100, GL_COMPILE);
         primitives(s);
         glEndList();
         const GLint name = 100;
         glNewList(1101, GL_COMPILE);
         glCallLists(1, GL_INT, &name);
         glEndList();
         glListBase(1000);
         glCallList(1101);
         glListBase(0);
       }},
      {"redefined",
       [](const Scene& s) {
         glNewList(9, GL_COMPILE);
         something_else();
         primitives(s);
         something_else();
         primitives(s);
         glEndList();
         glNewList(10, GL_COMPILE);
         glCallList(9);
         glEndList();
         glNewList(9, GL_COMPILE);
         primitives(s);
         glEndList();
         glCallList(10);
       }},
      {"redefined_as_triangles",
       [](const Scene& s) {
         glNewList(9, GL_COMPILE);
         primitives(s);
         glEndList();
         glNewList(9, GL_COMPILE);
         something_else();
         glEndList();
         glCallList(9);
         glClear(GL_COLOR_BUFFER_BIT);
         primitives(s);
       }},
      {"inside_begin",
       [](const Scene& s) {
         for (const Primitive& p : s.primitives) {
           for (std::size_t i = 0; i < p.vertices.size(); ++i) {
             glNewList(20 + GLuint(i), GL_COMPILE);
             vertex(p.vertices[i]);
             glEndList();
           }
           glBegin(mode_of(p));
           for (std::size_t i = 0; i < p.vertices.size(); ++i) glCallList(20 + GLuint(i));
           glEnd();
         }
       }},
      {"inside_begin_by_base", [](const Scene& s) { inside_begin_by_base(s, [] { glListBase(2000); }); }},
      {"inside_begin_by_popped_base",
       [](const Scene& s) {
         inside_begin_by_base(s, [] {
           push_base();
           glPopAttrib();
         });
       }},
      {"inside_begin_by_listed_base",
       [](const Scene& s) {
         inside_begin_by_base(s, [] {
           glNewList(1, GL_COMPILE);
           glListBase(2000);
           glEndList();
           glCallList(1);
         });
       }},
      {"inside_begin_by_base_popped_in_list",
       [](const Scene& s) {
         inside_begin_by_base(s, [] {
           glNewList(1, GL_COMPILE);
           glPopAttrib();
           glEndList();
           glListBase(2000);
           glPushAttrib(GL_LIST_BIT);
           glListBase(3000);
           const GLubyte name = 1;
           glListBase(0);
           glCallLists(1, GL_UNSIGNED_BYTE, &name);
         });
       }},
      {"inside_listed_begin_by_base",
       [](const Scene& s) { inside_begin_by_base(s, [] {}, GL_COMPILE, [] { glListBase(2000); }); }},
      {"inside_listed_begin_by_popped_base",
       [](const Scene& s) { inside_begin_by_base(s, push_base, GL_COMPILE, [] { glPopAttrib(); }); }},
      {"inside_listed_begin_by_called_base",
       [](const Scene& s) {
         const auto define = [] {
           glNewList(1, GL_COMPILE);
           glListBase(2000);
           glEndList();
         };
         inside_begin_by_base(s, define, GL_COMPILE, [] { glCallList(1); });
       }},
      {"inside_executed_begin_by_popped_base",
       [](const Scene& s) {
         inside_begin_by_base(s, push_base, GL_COMPILE_AND_EXECUTE, [] { glPopAttrib(); });
       }},
      {"three_quads", [](const Scene&) { three_quads(); }},
      {"inside_executed_begin", [](const Scene& s) { inside_executed_begin(s, false); }},
      {"inside_executed_begin_many", [](const Scene& s) { inside_executed_begin(s, true); }},
      {"among_others",
       [](const Scene& s) {
         glNewList(9, GL_COMPILE);
         something_else();
         for (const Primitive& p : s.primitives) {
           primitive(p);
           something_else();
         }
         glEndList();
         glCallList(9);
       }},
      {"deleted_inner",
       [](const Scene& s) {
         glNewList(9, GL_COMPILE);
         primitives(s);
         glEndList();
         glNewList(10, GL_COMPILE);
         glCallList(9);
         glEndList();
         glDeleteLists(9, 1);
         glCallList(10);
         glCallList(9);
       }},
      {"shared",
       [](const Scene& s) {
         glNewList(9, GL_COMPILE);
         primitives(s);
         glEndList();
         make_current(second_context);
         glClear(GL_COLOR_BUFFER_BIT);
         look(s);
         glCallList(9);
         glFinish();
         make_current(first_context);
       }},
      {"matrices_in_list",
       [](const Scene& s) {
         look_elsewhere();
         glNewList(9, GL_COMPILE);
         look(s);
         primitives(s);
         glEndList();
         glCallList(9);
       }},
  };
  add_types(all);
  add_changes(all);
  return all;
}

}  // namespace
}  // namespace truequad::images

int main(int count, char** arguments) { return truequad::images::draw_in_a_way(truequad::images::ways(), count, arguments); }
