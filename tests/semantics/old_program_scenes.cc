// What old programs do around textured quads: turned faces and mirrored matrices, pictures copied and accumulated between the
// passes, nested names, queries and conditions within lists.
#include <vector>

#include "cases.h"
#include "scene_tools.h"

namespace truequad::semantics {
namespace {

void plain(const Shape& shape) {
  send_with(shape, [](const Vertex&, int) {});
}

// Each side has a colour of its own, by emission, and its own specular light from a lamp near the surface.
void two_coloured_sides() {
  const float front[] = {0.8f, 0, 0.1f, 1}, back[] = {0, 0.7f, 0.3f, 1}, black[] = {0, 0, 0, 1}, lamp[] = {0.2f, 0.3f, 1, 0};
  glMaterialfv(GL_FRONT, GL_EMISSION, front);
  glMaterialfv(GL_BACK, GL_EMISSION, back);
  for (const GLenum property : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) glMaterialfv(GL_FRONT_AND_BACK, property, black);
  glLightfv(GL_LIGHT0, GL_POSITION, lamp);
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHTING);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
}

// Sides are told by the winding on the screen, whatever the matrices mirror, and one of them is culled.
void mirrored_sides(unsigned first, unsigned seeds) {
  prepare_scene();
  two_coloured_sides();
  for (const GLenum winding : {GL_CCW, GL_CW}) {
    glFrontFace(winding);
    for (const GLenum culled : {GL_NONE, GL_FRONT, GL_BACK}) {
      culled == GL_NONE ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
      if (culled != GL_NONE) glCullFace(culled);
      for (const GLenum matrix : {GL_MODELVIEW, GL_PROJECTION}) {
        const std::string name =
            std::to_string(winding) + " " + std::to_string(culled) + " " + std::to_string(matrix) + " ";
        for_each_planar(first, seeds, name, [&](const Shape& shape) {
          glMatrixMode(matrix);
          const std::array<float, 16> flip{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
          if (matrix == GL_PROJECTION) {
            glLoadMatrixf(flip.data());
            glMultMatrixf(shape.projection.data());
          } else {
            glMultMatrixf(flip.data());
          }
          plain(shape);
          glMatrixMode(GL_MODELVIEW);
        });
      }
    }
  }
  glDisable(GL_CULL_FACE);
  glDisable(GL_LIGHTING);
}

// Motion blur and soft edges by the accumulation buffer, and its clearing by glClear between.
void accumulated(unsigned first, unsigned seeds) {
  prepare_scene();
  glClearAccum(0.1f, 0, 0.2f, 0);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glClear(GL_ACCUM_BUFFER_BIT);
    for (int step = 0; step < 4; ++step) {
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      glPushMatrix();
      glTranslatef(0.03f * float(step), 0, 0);
      plain(shape);
      glPopMatrix();
      glAccum(step == 0 ? GL_LOAD : GL_ACCUM, 0.25f);
    }
    glAccum(GL_RETURN, 1);
  });
}

// Pixels are read, copied and drawn between the quads: what is drawn before is in the buffer then.
void copied(unsigned first, unsigned seeds) {
  prepare_scene();
  GLint white = 0;
  GLuint copy = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &white);
  glGenTextures(1, &copy);
  const GLubyte bits[] = {0xaa, 0x55, 0xf0, 0x0f, 0xcc, 0x33, 0x99, 0x66};
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    glColor3ub(200, 60, 30);
    plain(shape);
    glBindTexture(GL_TEXTURE_2D, copy);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 64, 64, 0);
    std::vector<GLubyte> texels(64 * 64 * 4);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    static int number = 0;
    record("texels " + std::to_string(number++), texels);
    glBindTexture(GL_TEXTURE_2D, GLuint(white));
    glWindowPos2i(3, 5);
    glCopyPixels(kWidth / 3, kHeight / 3, kWidth / 2, kHeight / 2, GL_COLOR);
    glColor3ub(20, 250, 130);
    glWindowPos2i(50, 60);
    glBitmap(8, 8, 0, 0, 4, 4, bits);
    glScalef(0.5f, 0.5f, 1);
    plain(shape);
    glDrawPixels(32, 32, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  });
  glDeleteTextures(1, &copy);
}

// The nearest is the farthest: depth range, clearing and comparison turned round, by passes of which the last meets none.
void reversed_depth(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glClearDepth(0);
  for (const bool by_range : {true, false}) {
    by_range ? glDepthRange(1, 0) : glDepthRange(0, 1);
    for_each_planar(first, seeds, by_range ? "range " : "matrix ", [&](const Shape& shape) {
      if (!by_range) {
        const std::array<float, 16> flip{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixf(flip.data());
        glMultMatrixf(shape.projection.data());
        glMatrixMode(GL_MODELVIEW);
      }
      glDepthFunc(GL_GREATER);
      glColor3ub(kTouch, 0, 0);
      plain(shape);
      glDepthFunc(GL_EQUAL);
      glColor3ub(0, kTouch, 0);
      plain(shape);
      glDepthFunc(GL_GREATER);
      glColor3ub(0, 0, 8 * kTouch);
      plain(shape);
    });
  }
  glDepthFunc(GL_LESS);
  glDepthRange(0, 1);
  glClearDepth(1);
}

// A stack of names, hits of several depths, and quads outside of the clip volume that hit nothing; more hits than there is room
// for.
void nested_names(unsigned first, unsigned seeds) {
  prepare_scene();
  int number = 0;
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    for (const GLsizei room : {400, 9}) {
      std::vector<GLuint> hits(400);
      glSelectBuffer(room, hits.data());
      plain(shape);
      glRenderMode(GL_SELECT);
      glInitNames();
      for (GLuint outer = 0; outer < 3; ++outer) {
        glPushName(outer);
        glPushMatrix();
        glTranslatef(outer == 1 ? 100.0f : 0, 0, -0.1f * float(outer));
        for (GLuint inner = 10; inner < 12; ++inner) {
          glPushName(inner);
          plain(shape);
          glLoadName(inner + 10);
          glBegin(GL_QUADS);
          glEnd();
          glPopName();
        }
        plain(shape);
        glPopMatrix();
        glPopName();
      }
      const GLint count = glRenderMode(GL_RENDER);
      hits.push_back(GLuint(count));
      record("hits " + std::to_string(number++), hits);
    }
  });
}

// Every form of feedback, and what a list feeds.
void fed_in_every_form(unsigned first, unsigned seeds) {
  prepare_scene();
  int number = 0;
  for (const GLenum form : {GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE}) {
    for_each_planar(first, seeds, std::to_string(form) + " ", [&](const Shape& shape) {
      const GLuint list = glGenLists(1);
      glNewList(list, GL_COMPILE);
      glPassThrough(3);
      for (const Primitive& primitive : shape.primitives) {
        glBegin(primitive.mode);
        for (const Vertex& v : primitive.vertices) {
          glTexCoord2f(v.u, v.v);
          glVertex3fv(v.position.data());
        }
        glEnd();
      }
      glPassThrough(4);
      glEndList();
      glCallList(list);
      std::vector<GLfloat> fed(4000);
      glFeedbackBuffer(GLsizei(fed.size()), form, fed.data());
      glRenderMode(GL_FEEDBACK);
      glCallList(list);
      const GLint count = glRenderMode(GL_RENDER);
      fed.resize(std::size_t(count > 0 ? count : 0));
      record("fed " + std::to_string(number++), fed);
      glDeleteLists(list, 1);
    });
  }
}

// A list that does a bit of everything: matrices and attributes are pushed and popped around its quads, textures switched off and
// bound again, a query runs inside, and the caller goes on with what it left.
void everything_in_a_list(unsigned first, unsigned seeds) {
  prepare_scene();
  GLuint query = 0;
  glGenQueries(1, &query);
  std::vector<GLuint> counts;
  int number = 0;
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    const auto quads = [&](GLubyte red) {
      for (const Primitive& primitive : shape.primitives) {
        glBegin(primitive.mode);
        for (const Vertex& v : primitive.vertices) {
          glColor3ub(red, 7, 3);
          glTexCoord2f(v.u, v.v);
          glVertex3fv(v.position.data());
        }
        glEnd();
      }
    };
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushMatrix();
    glEnable(GL_BLEND);
    quads(64);
    glDisable(GL_TEXTURE_2D);
    glScalef(0.75f, 0.75f, 1);
    quads(32);
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_TEXTURE);
    glPushMatrix();
    glScalef(4, 2, 1);
    quads(16);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPopAttrib();
    glScissor(0, 0, kWidth / 2, kHeight);
    glEnable(GL_SCISSOR_TEST);
    quads(8);
    glPopMatrix();
    glRasterPos2f(0, 0);
    glPopAttrib();
    quads(4);
    glTranslatef(0.1f, 0, 0);
    glEndList();
    glBeginQuery(GL_SAMPLES_PASSED, query);
    glCallList(list);
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint count = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    counts.push_back(count);
    GLfloat matrix[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
    record("matrix " + std::to_string(number), matrix, sizeof matrix);
    const GLboolean on[] = {glIsEnabled(GL_TEXTURE_2D), glIsEnabled(GL_BLEND), glIsEnabled(GL_SCISSOR_TEST)};
    record("on " + std::to_string(number++), on, sizeof on);
    glDeleteLists(list, 1);
  });
  record("counts", counts);
  glDeleteQueries(1, &query);
}

// Lists in lists, as deep as the driver goes and deeper: each moves, draws, calls the next one, moves and draws again.
void nested_lists(unsigned, unsigned) {
  prepare_scene();
  GLint most = 0;
  glGetIntegerv(GL_MAX_LIST_NESTING, &most);
  const GLuint depth = GLuint(most) + 3, base = glGenLists(GLsizei(depth));
  const auto quad = [] {
    glBegin(GL_QUADS);
    send_warped_quad();
    glEnd();
  };
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  for (const bool by_lists : {false, true}) {
    for (GLuint i = 0; i < depth; ++i) {
      glNewList(base + i, GL_COMPILE);
      glTranslatef(1.0f / 512, 0, 0);
      if (i % 3 == 0 || i + 6 > depth) quad();
      const GLushort next = GLushort(i + 1);
      if (by_lists) {
        glListBase(base);
        glCallLists(1, GL_UNSIGNED_SHORT, &next);
      } else {
        glCallList(base + next);
      }
      glTranslatef(0, 1.0f / 512, 0);
      if (i % 5 == 0) quad();
      glEndList();
    }
    glClear(GL_COLOR_BUFFER_BIT);
    glLoadIdentity();
    glColor3ub(2, 3, 5);
    glCallList(base);
    GLfloat matrix[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
    record(by_lists ? "moved by lists" : "moved", matrix, sizeof matrix);
    record_picture(by_lists ? "nested by lists" : "nested");
  }
  glListBase(0);
  glLoadIdentity();
  glDeleteLists(base, GLsizei(depth));
}

}  // namespace

const std::vector<Scene>& old_program_scenes() {
  static const std::vector<Scene> scenes = {
      {"mirrored_sides", mirrored_sides},
      {"accumulated", accumulated},
      {"copied", copied},
      {"reversed_depth", reversed_depth},
      {"nested_names", nested_names},
      {"fed_in_every_form", fed_in_every_form},
      {"everything_in_a_list", everything_in_a_list},
      {"nested_lists", nested_lists},
  };
  return scenes;
}

}  // namespace truequad::semantics
