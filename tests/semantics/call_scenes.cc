// Random calls between glBegin and glEnd, legal and illegal: the current values, the errors and their order
// are the native ones after every primitive, whatever was corrected, passed, held or given up in it.
#include <random>
#include <vector>

#include "cases.h"
#include "scene_tools.h"
#include "values.h"

namespace truequad::semantics {
namespace {

class Calls {
 public:
  // `every`: each vertex has texture coordinates of its own, else most.
  Calls(unsigned seed, bool mixed_sizes, bool every = false)
      : engine_(seed), mixed_sizes_(mixed_sizes), every_(every) {}

  int below(int limit) { return int(engine_() % unsigned(limit)); }
  float number() { return float(below(4096)) / 1024 - 2; }

  // Mesa's own current values are wrong after a longer and then a shorter call for one attribute in one
  // primitive: what the shorter one does not give keeps its last value. So sizes stay the same, or change
  // between primitives only.
  void choose_sizes() {
    if (!mixed_sizes_) return;
    for (int& size : size_) size = 1 + below(4);
    colour_size_ = 3 + below(2);
    if (below(3)) size_[0] = 2;
  }

  void attribute() {
    const float a = number(), b = number(), c = number(), d = number();
    const float four[] = {a, b, c, d};
    const GLdouble doubles[] = {a, b, c, d};
    const GLenum face = below(3) == 0 ? GL_FRONT : below(2) ? GL_BACK : GL_FRONT_AND_BACK;
    switch (below(18)) {
      case 0:
      case 1:
        colour(four, doubles);
        break;
      case 2:
        glSecondaryColor3f(a, b, c);
        break;
      case 3:
        glSecondaryColor3b(GLbyte(below(256) - 128), 5, 127);
        break;
      case 4:
        glNormal3f(a, b, c);
        break;
      case 5:
        glNormal3b(GLbyte(below(256) - 128), GLbyte(below(256) - 128), 3);
        break;
      case 6:
        glNormal3s(GLshort(below(60000) - 30000), 2, 3);
        break;
      case 7:
      case 8:
        coordinates(0, four, doubles);
        break;
      case 9:
      case 10:
        coordinates(below(4), four, doubles);
        break;
      case 11:
        glFogCoordf(a);
        break;
      case 12:
        glEdgeFlag(GLboolean(below(2)));
        break;
      case 13:
        glIndexi(below(200));
        break;
      case 14:
        glMaterialfv(face, GL_DIFFUSE, four);
        break;
      case 15:
        glMaterialfv(face, below(2) ? GL_AMBIENT_AND_DIFFUSE : GL_EMISSION, four);
        break;
      case 16:
        glMaterialf(face, GL_SHININESS, float(below(129)));
        break;
      default:
        glVertexAttrib4f(GLuint(9 + below(7)), a, b, c, d);
        break;
    }
  }

  // Outside of Begin and End: of the same sizes, or with all components.
  void outside() {
    const float four[] = {number(), number(), number(), number()};
    const GLdouble doubles[] = {four[0], four[1], four[2], four[3]};
    if (!mixed_sizes_) {
      below(2) ? colour(four, doubles) : coordinates(below(4), four, doubles);
    } else if (below(2)) {
      glColor4fv(four);
    } else {
      glMultiTexCoord4fv(GL_TEXTURE0 + GLenum(below(4)), four);
    }
  }

  // A corner of a warped or of an affine quad, with its coordinates or without.
  void vertex(int i, bool warped) {
    const Corner& c = kWarpedQuad[i % 4];
    if (below(8) != 0 || every_) {
      const float four[] = {warped ? c.s : c.x, warped ? c.t : c.y, 0, 1};
      const GLdouble doubles[] = {four[0], four[1], 0, 1};
      coordinates(0, four, doubles);
    }
    switch (below(7)) {
      case 6:
        glVertexAttrib2f(0, c.x, c.y);  // the same as glVertex
        break;
      case 0:
        glVertex3f(c.x, c.y, 0.25f);
        break;
      case 1:
        glVertex4d(c.x, c.y, 0.25, 1);
        break;
      case 2:
        glVertex2dv(std::vector<GLdouble>{c.x, c.y}.data());
        break;
      default:
        glVertex2f(c.x, c.y);
        break;
    }
  }

  // Neither vertex nor attribute, or an attribute that GL refuses.
  void other(GLuint list) {
    GLfloat value[16];
    switch (below(16)) {
      case 0:
        glEnable(GL_LIGHTING);
        break;
      case 1:
        glBegin(GL_QUADS);
        break;
      case 2:
        glMatrixMode(GL_TEXTURE);
        break;
      case 3:
        glGetFloatv(GL_CURRENT_COLOR, value);
        break;
      case 4:
        glPushMatrix();
        break;
      case 5:
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        break;
      case 6:
        glMaterialf(GL_FRONT, GL_SHININESS, 500);
        break;
      case 7:
        glMaterialf(GL_FRONT, GL_LINEAR, 1);
        break;
      case 8:
        glMultiTexCoord2f(GL_TEXTURE0 + 31, 1, 2);
        break;
      case 9:
        glEvalCoord1f(0.5f);
        break;
      case 10:
        glCallList(list);
        break;
      case 11:
        glFlush();
        break;
      case 12:
        glVertexAttrib4f(99, 1, 2, 3, 4);
        break;
      case 13:
        glMaterialfv(0xdead, GL_DIFFUSE, value);
        break;
      case 14:
        glActiveTexture(GL_TEXTURE2);
        break;
      default:
        glArrayElement(0);
        break;
    }
  }

  // A primitive of any mode and length; `illegal`: a call in `illegal` is neither vertex nor attribute.
  void primitive(GLuint list, int illegal) {
    choose_sizes();
    const GLenum modes[] = {GL_QUADS, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON, GL_TRIANGLES};
    const GLenum mode = modes[below(5)];
    glBegin(mode);
    const int vertices = below(14);
    for (int i = 0; i < vertices; ++i) {
      for (int n = below(3); n > 0; --n) attribute();
      if (illegal && below(illegal) == 0) other(list);
      // A strip's quads are convex as well.
      vertex(mode == GL_QUAD_STRIP ? i ^ (i >> 1 & 1) : i, (i / 4 + vertices) % 3 != 0);
    }
    for (int n = below(3); n > 0; --n) attribute();
    glEnd();
  }

 private:
  void colour(const float (&four)[4], const GLdouble (&doubles)[4]) {
    const GLushort shorts[] = {1, 40000, 65535, 9};
    switch (below(4) + 4 * (colour_size_ == 4)) {
      case 0:
        glColor3fv(four);
        break;
      case 1:
        glColor3i(below(2000000000), -below(2000000000), 5);
        break;
      case 2:
        glColor3ub(GLubyte(below(256)), 9, 200);
        break;
      case 3:
        glColor3dv(doubles);
        break;
      case 4:
        glColor4fv(four);
        break;
      case 5:
        glColor4ub(GLubyte(below(256)), GLubyte(below(256)), 7, 200);
        break;
      case 6:
        glColor4usv(shorts);
        break;
      default:
        glColorP4ui(GL_UNSIGNED_INT_2_10_10_10_REV, GLuint(below(1 << 30)));
        break;
    }
  }

  void coordinates(int unit, const float (&four)[4], const GLdouble (&doubles)[4]) {
    const GLenum name = GL_TEXTURE0 + GLenum(unit);
    if (unit == 0 && below(3)) {
      switch (size_[0]) {
        case 1:
          return below(2) ? glTexCoord1fv(four) : glTexCoord1dv(doubles);
        case 2:
          return below(2) ? glTexCoord2fv(four) : glTexCoord2dv(doubles);
        case 3:
          return below(2) ? glTexCoord3fv(four) : glTexCoord3dv(doubles);
        default:
          return below(2) ? glTexCoord4fv(four) : glTexCoord4dv(doubles);
      }
    }
    switch (size_[unit]) {
      case 1:
        return glMultiTexCoord1fv(name, four);
      case 2:
        return below(2) ? glMultiTexCoord2fv(name, four) : glMultiTexCoord2dv(name, doubles);
      case 3:
        return glMultiTexCoord3fv(name, four);
      default:
        return glMultiTexCoord4fv(name, four);
    }
  }

  std::mt19937 engine_;
  bool mixed_sizes_, every_;
  int size_[4] = {2, 3, 4, 1}, colour_size_ = 4;
};

template <bool illegal, bool mixed_sizes>
void random_calls(unsigned first, unsigned seeds) {
  prepare_scene();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glNormal3f(0.25f, 0.5f, 0.75f);
  glSecondaryColor3f(0.75f, 0.25f, 0.5f);
  glEndList();
  for (unsigned seed = first; seed < first + seeds; ++seed) {
    Calls calls(seed, mixed_sizes);
    for (int i = 0; i < 6; ++i) {
      const std::string name = std::to_string(seed) + " " + std::to_string(i);
      calls.primitive(list, illegal ? 12 : 0);
      if (calls.below(3) == 0) glEnd();  // outside: an error
      if (calls.below(3) == 0) calls.outside();
      record("errors " + name, all_errors());
      if (calls.below(2)) glRasterPos2f(0, 0);
      record("values " + name, current_values());
      record("state " + name, other_state());
    }
  }
  all_errors();
}

// What is seen of them, whatever the attributes: each fragment adds the same.
void pictures_of_calls(unsigned first, unsigned seeds) {
  prepare_scene();
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_BLEND);
  glBlendColor(kTouch / 255.0f, kTouch / 255.0f, kTouch / 255.0f, 1);
  glBlendFunc(GL_CONSTANT_COLOR, GL_ONE);
  const GLuint list = glGenLists(1);
  for (unsigned seed = first; seed < first + seeds; ++seed) {
    Calls calls(seed, false, true);
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 3; ++i) calls.primitive(list, seed % 2 ? 20 : 0);
    record_picture("picture " + std::to_string(seed));
  }
  all_errors();
}

// Errors are not asked for until the end: the first of each primitive is kept, and is the native one.
void errors_at_last(unsigned first, unsigned seeds) {
  prepare_scene();
  for (unsigned seed = first; seed < first + seeds; ++seed) {
    Calls calls(seed, false);
    glEnable(seed % 2 ? 0xdead : GL_LIGHTING);
    for (int i = 0; i < 3; ++i) calls.primitive(0, 8);
    record("errors " + std::to_string(seed), all_errors());
    record("values " + std::to_string(seed), current_values());
  }
}

}  // namespace

const std::vector<Scene>& call_scenes() {
  static const std::vector<Scene> scenes = {
      {"legal_calls", random_calls<false, false>},
      {"illegal_calls", random_calls<true, false>},
      {"calls_of_mixed_sizes", random_calls<false, true>},
      {"errors_at_last", errors_at_last},
      {"pictures_of_calls", pictures_of_calls},
  };
  return scenes;
}

}  // namespace truequad::semantics
