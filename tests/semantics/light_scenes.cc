// Lighting. With one normal and a light from one direction a surface has one brightness, corrected or not;
// where brightness varies, it must not break along an edge that a corrected quad shares with one that is
// passed.
#include <cmath>

#include "cases.h"
#include "scene_tools.h"

namespace truequad::semantics {
namespace {

void light(float x, float y, float z, float w) {
  const float position[] = {x, y, z, w}, white[] = {1, 1, 1, 1}, dim[] = {0.1f, 0.1f, 0.1f, 1};
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glLoadIdentity();
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glPopMatrix();
  glLightfv(GL_LIGHT0, GL_DIFFUSE, white);
  glLightfv(GL_LIGHT0, GL_AMBIENT, dim);
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHTING);
}

void prepare_light() {
  prepare_scene();
  light(0.3f, 0.4f, 1, 0);
}

void directional(unsigned first, unsigned seeds) {
  prepare_light();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glNormal3f(0, 0.6f, 0.8f);
    send_with(shape, [](const Vertex&, int) {});
  });
}

// Normals that the program gives without unit length, as GL_NORMALIZE allows, for each vertex.
void normals_of_any_length(unsigned first, unsigned seeds) {
  prepare_light();
  glEnable(GL_NORMALIZE);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    send_with(shape, [](const Vertex&, int number) {
      const float length = float(1 + 5 * (number % 3));
      glNormal3f(0, 0.6f * length, 0.8f * length);
    });
  });
}

// Without GL_NORMALIZE brightness is linear in the normal: lengths that are linear in the position show as
// such.
void normals_by_length(unsigned first, unsigned seeds) {
  prepare_light();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp ramp(shape, 1, 0.5f, 0.2f);
    send_with(shape, [&](const Vertex& v, int) { glNormal3f(0, 0.6f * ramp(v), 0.8f * ramp(v)); });
  });
}

void materials() {
  const float front[] = {0.9f, 0.2f, 0.1f, 1}, back[] = {0.1f, 0.8f, 0.3f, 1};
  glMaterialfv(GL_FRONT, GL_DIFFUSE, front);
  glMaterialfv(GL_BACK, GL_DIFFUSE, back);
}

void two_sided(unsigned first, unsigned seeds) {
  prepare_light();
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  materials();
  for (const GLenum winding : {GL_CCW, GL_CW}) {
    glFrontFace(winding);
    for (const GLenum model : {GL_SMOOTH, GL_FLAT}) {
      glShadeModel(model);
      const std::string name =
          std::string(winding == GL_CCW ? "ccw" : "cw") + (model == GL_FLAT ? " flat " : " smooth ");
      for_each_planar(first, seeds, name, [](const Shape& shape) {
        send_with(shape, [](const Vertex&, int) { glNormal3f(0, 0.6f, 0.8f); });
      });
    }
  }
}

void material_for_each_vertex(unsigned first, unsigned seeds) {
  prepare_light();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp red(shape, 1, 0.5f, 0.2f), green(shape, -0.5f, 1, 0.1f);
    glNormal3f(0, 0, 1);
    send_with(shape, [&](const Vertex& v, int) {
      const float diffuse[] = {red(v), green(v), 0.5f, 1}, emission[] = {0, 0, 0.3f * red(v), 1};
      glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
      glMaterialfv(GL_FRONT, GL_EMISSION, emission);
    });
  });
}

void colour_material(unsigned first, unsigned seeds) {
  prepare_light();
  glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  glEnable(GL_COLOR_MATERIAL);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp red(shape, 1, 0.5f, 0.2f), green(shape, -0.5f, 1, 0.1f);
    glNormal3f(0, 0, 1);
    // Brightness beyond 1, which is clamped at vertices, is no ramp any more: see seam_saturated.
    send_with(shape, [&](const Vertex& v, int) { glColor3f(0.5f * red(v), 0.5f * green(v), 0.25f); });
  });
  glDisable(GL_COLOR_MATERIAL);
}

// A lamp near the surface: under flat shading each quad has the brightness of one vertex.
template <GLenum convention>
void flat_lamp(unsigned first, unsigned seeds) {
  prepare_scene();
  glShadeModel(GL_FLAT);
  glProvokingVertex(convention);
  light(0.5f, 0.25f, -1, 1);
  glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.5f);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glNormal3f(0, 0, 1);
    send_with(shape, [](const Vertex&, int) {});
  });
}

// A highlight, likewise.
void flat_highlight(unsigned first, unsigned seeds) {
  prepare_scene();
  glShadeModel(GL_FLAT);
  light(0.5f, 0.25f, 1, 0);
  const float white[] = {1, 1, 1, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 8);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glNormal3f(0, 0, 1);
    send_with(shape, [](const Vertex&, int) {});
  });
}

// Normals all over the place, a lamp, a highlight of its own and fog.
void bent_normals(unsigned first, unsigned seeds) {
  prepare_scene();
  light(0.5f, 0.25f, -1, 1);
  const float white[] = {1, 1, 1, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 6);
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  glEnable(GL_NORMALIZE);
  glEnable(GL_FOG);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    send_with(shape, [](const Vertex&, int number) {
      glNormal3f(float(number * 5 % 7) - 3, float(number * 3 % 5) - 2, 2);
    });
  });
}

// A trapezoid, corrected, and right of it a rectangle, passed, with the edge x = 0 between two columns of
// pixels. The attributes of the edge's ends differ, and do not depend on x.
template <typename F>
void seam(const std::string& name, F attributes) {
  Shape shape = make_shape("trapezoid", 0);
  shape.projection = shape.modelview = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  shape.primitives = {{GL_QUADS,
                       {{{-0.9f, -0.4f, 0}, 0, 0},
                        {{0, -0.9f, 0}, 1, 0},
                        {{0, 0.9f, 0}, 1, 1},
                        {{-0.9f, 0.4f, 0}, 0, 1},
                        {{0, -0.9f, 0}, 0, 0},
                        {{0.9f, -0.9f, 0}, 1, 0},
                        {{0.9f, 0.9f, 0}, 1, 1},
                        {{0, 0.9f, 0}, 0, 1}}}};
  begin_frame(shape);
  send_with(shape, attributes);
  record_picture(name);
}

void seam_colours(unsigned, unsigned) {
  prepare_scene();
  seam("seam", [](const Vertex& v, int) { v.v > 0 ? glColor3f(1, 0.8f, 0.1f) : glColor3f(0, 0.2f, 0.9f); });
}

void turned_normal(const Vertex& v, int) { glNormal3f(0, v.v > 0 ? 0.8f : -0.8f, 0.6f); }

void seam_normals(unsigned, unsigned) {
  prepare_scene();
  light(0, 0.3f, 1, 0);
  seam("seam", turned_normal);
}

void seam_normalized(unsigned, unsigned) {
  prepare_scene();
  light(0, 0.3f, 1, 0);
  glEnable(GL_NORMALIZE);
  seam("seam", turned_normal);
}

void seam_lamp(unsigned, unsigned) {
  prepare_scene();
  light(0, 0.2f, 0.4f, 1);
  glNormal3f(0, 0, 1);
  seam("seam", [](const Vertex&, int) {});
}

void seam_highlight(unsigned, unsigned) {
  prepare_scene();
  light(0, 0.3f, 1, 0);
  const float white[] = {1, 1, 1, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 10);
  seam("seam", turned_normal);
}

// Twice as bright as can be shown at one end: clamped at vertices (GL 2.1 section 2.14.6), so along the edge
// the clamped values are interpolated.
void seam_saturated(unsigned, unsigned) {
  prepare_scene();
  light(0, 0, 1, 0);
  glEnable(GL_COLOR_MATERIAL);
  const float bright[] = {2, 2, 2, 1};
  glLightfv(GL_LIGHT0, GL_DIFFUSE, bright);
  glNormal3f(0, 0, 1);
  seam("seam", [](const Vertex& v, int) { v.v > 0 ? glColor3f(1, 0.8f, 0.1f) : glColor3f(0, 0.2f, 0.9f); });
}

void seam_two_sided(unsigned, unsigned) {
  prepare_scene();
  // Seen from behind: lit by the reversed normals.
  light(0, 0.3f, -1, 0);
  glFrontFace(GL_CW);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  seam("seam", turned_normal);
}

}  // namespace

const std::vector<Scene>& light_scenes() {
  static const std::vector<Scene> scenes = {
      {"directional", directional},
      {"normals_of_any_length", normals_of_any_length},
      {"normals_by_length", normals_by_length},
      {"two_sided", two_sided},
      {"material_for_each_vertex", material_for_each_vertex},
      {"colour_material", colour_material},
      {"flat_lamp_last", flat_lamp<GL_LAST_VERTEX_CONVENTION>},
      {"flat_lamp_first", flat_lamp<GL_FIRST_VERTEX_CONVENTION>},
      {"flat_highlight", flat_highlight},
      {"bent_normals", bent_normals},
      {"seam_colours", seam_colours},
      {"seam_normals", seam_normals},
      {"seam_normalized", seam_normalized},
      {"seam_lamp", seam_lamp},
      {"seam_highlight", seam_highlight},
      {"seam_saturated", seam_saturated},
      {"seam_two_sided", seam_two_sided},
  };
  return scenes;
}

}  // namespace truequad::semantics
