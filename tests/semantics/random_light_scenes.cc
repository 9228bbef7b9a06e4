// Lighting with everything that it knows: lights, materials, normals and matrices at random. Flat shading shows the
// brightness of one corner at a time, so that the picture is the driver's lighting of that vertex.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "cases.h"
#include "scene_tools.h"
#include "values.h"

namespace truequad::semantics {
namespace {

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
    glMaterialf(face, GL_SHININESS, one_of(4) ? 0 : between(0, 60));
  }

  void model() {
    const float ambient[] = {between(0, 0.3f), between(0, 0.3f), between(0, 0.3f), 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, one_of(2));
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, one_of(2));
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, one_of(3) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    toggle(GL_NORMALIZE, one_of(2));
    toggle(GL_RESCALE_NORMAL, one_of(2));
    toggle(GL_COLOR_SUM, one_of(2));
    glFrontFace(one_of(2) ? GL_CCW : GL_CW);
    constexpr GLenum kFaces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
    constexpr GLenum kProperties[] = {GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    glColorMaterial(kFaces[engine_() % 3], kProperties[engine_() % 5]);
    toggle(GL_COLOR_MATERIAL, one_of(2));
  }

  std::string label;
  void draw(const Shape& shape) {
    glEnable(GL_LIGHTING);
    for (GLenum i = 0; i < 8; ++i) {
      glDisable(GL_LIGHT0 + i);
      if (one_of(3)) light(GL_LIGHT0 + i);
    }
    material(GL_FRONT);
    material(GL_BACK);
    model();
    GLint lv=0,ts=0,cc=0,cmf=0,cmp=0; GLfloat sh[2]; glGetIntegerv(GL_LIGHT_MODEL_LOCAL_VIEWER,&lv); glGetIntegerv(GL_LIGHT_MODEL_TWO_SIDE,&ts); glGetIntegerv(GL_LIGHT_MODEL_COLOR_CONTROL,&cc);
    glGetIntegerv(GL_COLOR_MATERIAL_FACE,&cmf);glGetIntegerv(GL_COLOR_MATERIAL_PARAMETER,&cmp);
    glGetMaterialfv(GL_FRONT,GL_SHININESS,sh);glGetMaterialfv(GL_BACK,GL_SHININESS,sh+1);
    std::fprintf(stderr,"F %s lv %d ts %d sep %d norm %d resc %d cm %d %x %x sh %g %g |",label.c_str(),lv,ts,cc==GL_SEPARATE_SPECULAR_COLOR,glIsEnabled(GL_NORMALIZE),glIsEnabled(GL_RESCALE_NORMAL),glIsEnabled(GL_COLOR_MATERIAL),cmf,cmp,sh[0],sh[1]);
    for (GLenum i=0;i<8;++i) if (glIsEnabled(GL_LIGHT0+i)) { GLfloat p[4],e,c; glGetLightfv(GL_LIGHT0+i,GL_POSITION,p);glGetLightfv(GL_LIGHT0+i,GL_SPOT_EXPONENT,&e);glGetLightfv(GL_LIGHT0+i,GL_SPOT_CUTOFF,&c); std::fprintf(stderr," w%g e%g c%g;",p[3],e,c);} std::fprintf(stderr,"\n");
    glProvokingVertex(one_of(2) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
    glColor4f(between(0, 1), between(0, 1), between(0, 1), between(0, 1));
    glSecondaryColor3f(between(0, 1), between(0, 1), between(0, 1));
    const bool normals = one_of(2), colours = one_of(2), materials = one_of(3);
    glNormal3f(between(-0.5f, 0.5f), between(-0.5f, 0.5f), 1);
    if (const char* o=getenv("ONLY")) for (GLenum i=0;i<8;++i) if (atoi(o)!=int(i)) glDisable(GL_LIGHT0+i);
    if (getenv("NOSPEC")) { float z[4]={0,0,0,1}; glMaterialfv(GL_FRONT_AND_BACK,GL_SPECULAR,z); }
    if (getenv("NODIFF")) { for (GLenum i=0;i<8;++i) {float z[4]={0,0,0,1}; glLightfv(GL_LIGHT0+i,GL_DIFFUSE,z);} }
    if (getenv("NOAMB")) { for (GLenum i=0;i<8;++i) {float z[4]={0,0,0,1}; glLightfv(GL_LIGHT0+i,GL_AMBIENT,z);} }
    std::fprintf(stderr,"G n%d c%d m%d prov %d\n",normals,colours,materials,0);
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
      lights.label=std::to_string(seed)+' '+std::to_string(drawn);
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
