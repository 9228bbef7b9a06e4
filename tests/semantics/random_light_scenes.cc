// Lighting with everything that it knows: lights, materials, normals and matrices at random. Flat shading shows the
// brightness of one corner at a time, so that the picture is the driver's lighting of that vertex.
#include <random>

#include "cases.h"
#include "scene_tools.h"
#include "values.h"

namespace truequad::semantics {
namespace {

// Left out is what Mesa 22.3 draws otherwise by one of its vertex paths than by the other, or than the same vertices with
// their materials given in full: a shininess of 0, back faces that alone follow the colour, and materials of the front
// alone that are set between glBegin and glEnd of two-sided surfaces.
class Lights {
 public:
  explicit Lights(unsigned seed) : engine_(seed) {}

  bool one_of(unsigned n) { return engine_() % n == 0; }
  float between(float low, float high) { return low + (high - low) * float(engine_() % 65536) / 65535; }

  void light(GLenum name) {
    colour(name, GL_AMBIENT, 0.2f);
    colour(name, GL_DIFFUSE, 1);
    colour(name, GL_SPECULAR, 1);
    const float position[] = {between(-2, 2), between(-2, 2), between(-4, 2), one_of(3) ? 0.f : 1.f};
    glLightfv(name, GL_POSITION, position);
    const float direction[] = {between(-1, 1), between(-1, 1), between(-1, 0)};
    glLightfv(name, GL_SPOT_DIRECTION, direction);
    glLightf(name, GL_SPOT_EXPONENT, one_of(2) ? 0 : between(0, 8));
    glLightf(name, GL_SPOT_CUTOFF, one_of(2) ? 180 : between(30, 90));
    glLightf(name, GL_CONSTANT_ATTENUATION, between(0.5f, 1));
    glLightf(name, GL_LINEAR_ATTENUATION, between(0, 0.3f));
    glLightf(name, GL_QUADRATIC_ATTENUATION, between(0, 0.1f));
    glEnable(name);
  }

  void material(GLenum face) {
    for (const GLenum property : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
      const float colour[] = {between(0, 0.9f), between(0, 0.9f), between(0, 0.9f), between(0, 1)};
      glMaterialfv(face, property, colour);
    }
    const float emission[] = {between(0, 0.1f), 0, between(0, 0.2f), 1};
    glMaterialfv(face, GL_EMISSION, emission);
    glMaterialf(face, GL_SHININESS, between(1, 60));
  }

  void model() {
    const float ambient[] = {between(0, 0.3f), between(0, 0.3f), between(0, 0.3f), 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, one_of(2));
    two_sided_ = one_of(2);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided_);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, one_of(3) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    toggle(GL_NORMALIZE, one_of(2));
    toggle(GL_RESCALE_NORMAL, one_of(2));
    toggle(GL_COLOR_SUM, one_of(2));
    glFrontFace(one_of(2) ? GL_CCW : GL_CW);
    constexpr GLenum kFaces[] = {GL_FRONT, GL_FRONT_AND_BACK};
    constexpr GLenum kProperties[] = {GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    glColorMaterial(kFaces[engine_() % 2], kProperties[engine_() % 5]);
    toggle(GL_COLOR_MATERIAL, one_of(2));
  }

  void draw(const Shape& shape) {
    glEnable(GL_LIGHTING);
    for (GLenum i = 0; i < 8; ++i) {
      glDisable(GL_LIGHT0 + i);
      if (one_of(3)) light(GL_LIGHT0 + i);
    }
    material(GL_FRONT);
    material(GL_BACK);
    model();
    glProvokingVertex(one_of(2) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
    glColor4f(between(0, 1), between(0, 1), between(0, 1), between(0, 1));
    glSecondaryColor3f(between(0, 1), between(0, 1), between(0, 1));
    const bool normals = one_of(2), colours = one_of(2), materials = one_of(3) && !two_sided_;
    glNormal3f(between(-0.5f, 0.5f), between(-0.5f, 0.5f), 1);
    send_with(shape, [&](const Vertex&, int) {
      if (normals) glNormal3f(between(-0.5f, 0.5f), between(-0.5f, 0.5f), between(0.3f, 1.5f));
      if (colours) glColor3f(between(0, 1), between(0, 1), between(0, 1));
      if (materials && one_of(2)) material(one_of(2) ? GL_FRONT : GL_FRONT_AND_BACK);
    });
  }

 private:
  void colour(GLenum name, GLenum property, float most) {
    const float value[] = {between(0, most), between(0, most), between(0, most), 1};
    glLightfv(name, property, value);
  }
  void toggle(GLenum name, bool on) { on ? glEnable(name) : glDisable(name); }

  std::mt19937 engine_;
  bool two_sided_ = false;
};

void flat_random_lights(unsigned first, unsigned seeds) {
  prepare_scene();
  glShadeModel(GL_FLAT);
  unsigned drawn = 0;
  for (unsigned seed = first; seed < first + seeds; ++seed) {
    Lights lights(seed);
    for_each_planar(seed, 1, "", [&](const Shape& shape) {
      // Matrices that scale normals.
      if (lights.one_of(2)) glScalef(lights.between(0.5f, 2), lights.between(0.5f, 2), 1);
      lights.draw(shape);
      const std::string number = std::to_string(drawn++);
      record("values " + number, current_values());
      record("state " + number, other_state());
    });
  }
}

}  // namespace

const std::vector<Scene>& random_light_scenes() {
  static const std::vector<Scene> scenes = {{"flat_random_lights", flat_random_lights}};
  return scenes;
}

}  // namespace truequad::semantics
