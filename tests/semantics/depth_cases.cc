// Two and three passes over the same vertices, the later ones by comparison with the depths of the first.
#include "cases.h"
#include "pass.h"
#include "record.h"

namespace truequad::semantics {
namespace {

using C = Coordinates;

constexpr Pass kFirst = {.coordinates = C::kWarped};

template <Pass first, Pass... later>
void passes(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  draw(shape, first);
  (draw(shape, later), ...);
  record_picture(name);
}

// Far is zero: what is nearer has the larger depth.
void reversed(const Shape& shape, const std::string& name) {
  glClearDepth(0);
  begin_frame(shape);
  glDepthRange(1, 0);
  draw(shape, {.coordinates = C::kWarped, .depth = GL_GREATER});
  draw(shape, {.depth = GL_GEQUAL, .channel = 1});
  record_picture(name);
  glDepthRange(0, 1);
  glClearDepth(1);
}
// Mesa gives GL_QUADS in a list another diagonal than immediate ones, so natively only the others agree.
template <Pass first, Pass later>
void passes_from_list(const Shape& shape, const std::string& name) {
  if (shape.primitives[0].mode == GL_QUADS) return;
  passes<first, later>(shape, name);
  // What was two triangles in the first frame may be a mesh from the second on.
  passes<first, later>(shape, name + " again");
}

// Drawn though it lies behind what is there, and drawn though something nearer is.
template <GLenum comparison>
void over_nearer(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-4, -4);
  draw(shape, {.channel = kUnseen});
  glDisable(GL_POLYGON_OFFSET_FILL);
  draw(shape, {.coordinates = C::kWarped, .depth = comparison});
  draw(shape, {.depth = GL_EQUAL, .channel = 1});
  record_picture(name);
}

// The first pass leaves no depths, so the second is drawn as if it were the first.
template <bool test>
void no_depths(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  if (test)
    glDepthMask(GL_FALSE);
  else
    glDisable(GL_DEPTH_TEST);
  draw(shape, kFirst);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  draw(shape, {.depth = GL_LESS, .channel = 1});
  record_picture(name);
}

// Fragments without alpha are discarded and leave no depths.
void alpha_discarded(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.5f);
  draw(shape, kFirst);
  glDisable(GL_ALPHA_TEST);
  draw(shape, {.depth = GL_LESS, .channel = 1});
  record_picture(name);
}

// A grating whose holes the second pass fills: blue is the whole surface, each pixel of it is red or green.
void alpha_grating(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  glDisable(GL_DEPTH_TEST);
  draw(shape, {.channel = 2});
  glEnable(GL_DEPTH_TEST);
  GLint white = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &white);
  GLuint grating = 0;
  glGenTextures(1, &grating);
  glBindTexture(GL_TEXTURE_2D, grating);
  const unsigned char bars[] = {255, 255, 255, 255, 255, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255, 0};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bars);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA, GL_TEXTURE);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.5f);
  draw(shape, kFirst);
  glDisable(GL_ALPHA_TEST);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  draw(shape, {.depth = GL_LESS, .channel = 1});
  glBindTexture(GL_TEXTURE_2D, GLuint(white));
  glDeleteTextures(1, &grating);
  record_picture(name);
}

void depth_clamp(const Shape& shape, const std::string& name) {
  glEnable(GL_DEPTH_CLAMP);
  passes<kFirst, Pass{.depth = GL_EQUAL, .channel = 1}>(shape, name);
  glDisable(GL_DEPTH_CLAMP);
}

// With TRUEQUAD_COLOR=1 a pass may need a mesh for its colours alone. Two frames: what was two triangles in the first may be a
// mesh in the second.
template <Pass first, Pass... later>
void colour_passes(const Shape& shape, const std::string& name) {
  passes<first, later...>(shape, name);
  passes<first, later...>(shape, name + " again");
}

void clip_plane(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  const GLdouble plane[] = {0.6, 0.8, 0.1, 0.2};
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glLoadIdentity();
  glClipPlane(GL_CLIP_PLANE0, plane);
  glPopMatrix();
  glEnable(GL_CLIP_PLANE0);
  draw(shape, kFirst);
  draw(shape, {.depth = GL_EQUAL, .channel = 1});
  glDisable(GL_CLIP_PLANE0);
  record_picture(name);
}

}  // namespace

const std::vector<PassesCase>& depth_cases() {
  static const std::vector<PassesCase> cases = {
      {"equal_untextured", passes<kFirst, Pass{.depth = GL_EQUAL, .channel = 1}>},
      {"equal_same", passes<kFirst, Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1}>},
      {"equal_affine", passes<kFirst, Pass{.coordinates = C::kAffine, .depth = GL_EQUAL, .channel = 1}>},
      {"equal_other", passes<kFirst, Pass{.coordinates = C::kOther, .depth = GL_EQUAL, .channel = 1}>},
      {"equal_twisted", passes<kFirst, Pass{.coordinates = C::kTwisted, .depth = GL_EQUAL, .channel = 1}>},
      {"equal_unused", passes<kFirst, Pass{.coordinates = C::kUnused, .depth = GL_EQUAL, .channel = 1}>},
      {"equal_two_units",
       passes<kFirst,
              Pass{.coordinates = C::kWarped, .second = C::kTwisted, .depth = GL_EQUAL, .channel = 1}>},
      {"equal_second_unit", passes<kFirst, Pass{.second = C::kOther, .depth = GL_EQUAL, .channel = 1}>},
      {"equal_begin_each", passes<kFirst, Pass{.depth = GL_EQUAL, .channel = 1, .way = Way::kBeginForEach}>},
      {"equal_begin_each_other",
       passes<kFirst,
              Pass{.coordinates = C::kOther, .depth = GL_EQUAL, .channel = 1, .way = Way::kBeginForEach}>},
      {"equal_doubles",
       passes<kFirst, Pass{.coordinates = C::kOther, .depth = GL_EQUAL, .channel = 1, .way = Way::kDoubles}>},
      {"equal_arrays", passes<kFirst, Pass{.depth = GL_EQUAL, .channel = 1, .way = Way::kArrays}>},
      {"equal_arrays_warped",
       passes<kFirst, Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1, .way = Way::kArrays}>},
      {"equal_list", passes_from_list<kFirst, Pass{.depth = GL_EQUAL, .channel = 1, .way = Way::kList}>},
      {"lequal_untextured", passes<kFirst, Pass{.depth = GL_LEQUAL, .channel = 1}>},
      {"lequal_other", passes<kFirst, Pass{.coordinates = C::kOther, .depth = GL_LEQUAL, .channel = 1}>},
      {"gequal_untextured", passes<kFirst, Pass{.depth = GL_GEQUAL, .channel = 1}>},
      {"gequal_reversed", reversed},
      {"less_untextured", passes<kFirst, Pass{.depth = GL_LESS, .channel = 1}>},
      {"less_twisted", passes<kFirst, Pass{.coordinates = C::kTwisted, .depth = GL_LESS, .channel = 1}>},
      {"greater_untextured", passes<kFirst, Pass{.depth = GL_GREATER, .channel = 1}>},
      {"notequal_other", passes<kFirst, Pass{.coordinates = C::kOther, .depth = GL_NOTEQUAL, .channel = 1}>},
      {"prepass_equal",
       passes<Pass{.channel = kUnseen}, Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1}>},
      {"prepass_lequal",
       passes<Pass{.channel = kUnseen}, Pass{.coordinates = C::kWarped, .depth = GL_LEQUAL, .channel = 1}>},
      {"prepass_affine_equal", passes<Pass{.coordinates = C::kAffine, .channel = kUnseen},
                                      Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1}>},
      {"prepass_list_equal",
       passes_from_list<Pass{.channel = kUnseen, .way = Way::kList},
                        Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1}>},
      {"untextured_then_warped",
       passes<Pass{}, Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1}>},
      {"prepass_colour_light",
       passes<Pass{.channel = kUnseen}, Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1},
              Pass{.coordinates = C::kOther, .depth = GL_EQUAL, .channel = 2}>},
      {"colour_light_fog", passes<kFirst, Pass{.coordinates = C::kTwisted, .depth = GL_EQUAL, .channel = 1},
                                  Pass{.depth = GL_EQUAL, .channel = 2}>},
      {"always_over_nearer", over_nearer<GL_ALWAYS>},
      {"greater_over_nearer", over_nearer<GL_GREATER>},
      {"depth_mask_off", no_depths<true>},
      {"depth_test_off", no_depths<false>},
      {"alpha_discarded", alpha_discarded},
      {"alpha_grating", alpha_grating},
      {"depth_clamp", depth_clamp},
      {"clip_plane", clip_plane},
      {"colours_then_plain",
       colour_passes<Pass{.kinked = true}, Pass{.depth = GL_EQUAL, .channel = 1}>},
      {"plain_then_colours", colour_passes<Pass{}, Pass{.depth = GL_EQUAL, .channel = 1, .kinked = true}>},
      {"colours_then_texture",
       colour_passes<Pass{.kinked = true}, Pass{.coordinates = C::kTwisted, .depth = GL_EQUAL, .channel = 1}>},
      {"texture_then_colours",
       colour_passes<kFirst, Pass{.depth = GL_EQUAL, .channel = 1, .kinked = true}>},
      {"colours_then_both", colour_passes<Pass{.kinked = true}, Pass{.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1,
                                                                    .kinked = true}>},
      {"prepass_colours",
       colour_passes<Pass{.channel = kUnseen}, Pass{.depth = GL_EQUAL, .channel = 1, .kinked = true}>},
      {"colours_arrays", colour_passes<Pass{.kinked = true}, Pass{.depth = GL_EQUAL, .channel = 1, .way = Way::kArrays, .kinked = true}>},
  };
  return cases;
}

}  // namespace truequad::semantics
