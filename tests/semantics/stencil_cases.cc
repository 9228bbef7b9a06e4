// Passes whose pixels are chosen by the stencil buffer: masks, mirrors, counting, shadow volumes.
#include "cases.h"
#include "pass.h"
#include "record.h"

namespace truequad::semantics {
namespace {

using C = Coordinates;

void stencil(GLenum comparison, GLint reference, GLenum fail, GLenum depth_fail, GLenum depth_pass) {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(comparison, reference, 0xff);
  glStencilOp(fail, depth_fail, depth_pass);
}

void inside(GLint reference) { stencil(GL_EQUAL, reference, GL_KEEP, GL_KEEP, GL_KEEP); }

// A mask of the surface, then the surface inside of it and (blue) outside.
template <C mask, C surface>
void masked(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  glDepthMask(GL_FALSE);
  stencil(GL_ALWAYS, 1, GL_KEEP, GL_KEEP, GL_REPLACE);
  draw(shape, {.coordinates = mask});
  glDepthMask(GL_TRUE);
  inside(1);
  draw(shape, {.coordinates = surface, .depth = GL_LEQUAL, .channel = 1});
  inside(0);
  draw(shape, {.coordinates = surface, .depth = GL_ALWAYS, .channel = 2});
  glDisable(GL_STENCIL_TEST);
  record_picture(name);
}

// As OpenGL's own examples draw mirrors: the mirror marks its pixels, its depths are put to the far plane,
// what it reflects is drawn inside, and the glass restores the depths and is blended over by GL_EQUAL.
void mirror(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  stencil(GL_ALWAYS, 1, GL_KEEP, GL_KEEP, GL_REPLACE);
  draw(shape, {.coordinates = C::kWarped});
  inside(1);
  glDepthRange(1, 1);
  draw(shape, {.depth = GL_ALWAYS, .channel = kUnseen});
  glDepthRange(0, 1);
  // Something reflected that fills the window, behind everything.
  Shape world = shape;
  world.projection = world.modelview = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  world.primitives = {{GL_QUADS,
                       {{{-1, -1, 0.9375f}, 0, 0},
                        {{1, -1, 0.9375f}, 1, 0},
                        {{1, 1, 0.9375f}, 1, 1},
                        {{-1, 1, 0.9375f}, 0, 1}}}};
  for (const Shape* now : {static_cast<const Shape*>(&world), &shape}) {
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(now->projection.data());
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(now->modelview.data());
    if (now == &world) draw(world, {.channel = 1});
  }
  glDisable(GL_STENCIL_TEST);
  draw(shape, {.depth = GL_ALWAYS, .channel = kUnseen});
  draw(shape, {.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 2});
  record_picture(name);
}

// The stencil buffer itself, as touches in green: what failed the depth test adds, what passed subtracts.
void show_stencil() {
  std::vector<GLubyte> counts(std::size_t(kWidth) * kHeight);
  glReadPixels(0, 0, kWidth, kHeight, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, counts.data());
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
  for (GLubyte& count : counts) count = GLubyte(count * kTouch);
  glRasterPos2f(-1, -1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glDisable(GL_TEXTURE_2D);
  glDrawPixels(kWidth, kHeight, GL_LUMINANCE, GL_UNSIGNED_BYTE, counts.data());
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

// The later pass fails GL_LESS by being equal: one count for each fragment.
template <C first, C later>
void counted_failures(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  draw(shape, {.coordinates = first});
  stencil(GL_ALWAYS, 0, GL_KEEP, GL_INCR, GL_ZERO);
  draw(shape, {.coordinates = later, .channel = kUnseen});
  show_stencil();
  record_picture(name);
}

void counted_passes(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  stencil(GL_ALWAYS, 0, GL_KEEP, GL_KEEP, GL_INCR);
  draw(shape, {.coordinates = C::kWarped, .depth = GL_LESS});
  show_stencil();
  record_picture(name);
}

// Up for the textured passes, down for the untextured one, all by GL_EQUAL: two, less one.
void counted_up_and_down(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  draw(shape, {.coordinates = C::kWarped});
  stencil(GL_ALWAYS, 0, GL_KEEP, GL_KEEP, GL_INCR);
  draw(shape, {.coordinates = C::kTwisted, .depth = GL_EQUAL, .channel = kUnseen});
  draw(shape, {.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = kUnseen});
  stencil(GL_ALWAYS, 0, GL_KEEP, GL_KEEP, GL_DECR);
  draw(shape, {.depth = GL_EQUAL, .channel = kUnseen});
  show_stencil();
  record_picture(name);
}

// A shadow volume in eye space that cuts through the surface: a slab that stands upright before the eye, from
// the near plane to far away. Its faces wind outwards.
Shape volume(const Shape& of) {
  const float left = -0.3f, right = 0.45f, low = -5, high = 5, near_z = -0.3f, far_z = -12;
  const auto corner = [&](bool r, bool h, bool f) -> Vertex {
    // Slanted, so that its sides cross pixels at all places.
    const float z = f ? far_z : near_z, y = h ? high : low;
    return {{(r ? right : left) + 0.07f * z + 0.03f * y, y, z}, float(r), float(h)};
  };
  Primitive faces{GL_QUADS, {}};
  constexpr int kFaces[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
  for (const auto& face : kFaces) {
    for (const int c : face) faces.vertices.push_back(corner(c & 1, c & 2, c & 4));
  }
  Shape shape = of;
  shape.modelview = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  shape.primitives = {faces};
  return shape;
}

// Carmack's reverse: what lies behind the surface is counted. Green is lit, blue is in shadow.
void shadow(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  draw(shape, {.coordinates = C::kWarped});
  const Shape slab = volume(shape);
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(slab.modelview.data());
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  stencil(GL_ALWAYS, 0, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
  draw(slab, {.channel = kUnseen});
  glCullFace(GL_BACK);
  stencil(GL_ALWAYS, 0, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
  draw(slab, {.channel = kUnseen});
  glDisable(GL_CULL_FACE);
  glLoadMatrixf(shape.modelview.data());
  inside(0);
  draw(shape, {.coordinates = C::kWarped, .depth = GL_EQUAL, .channel = 1});
  stencil(GL_NOTEQUAL, 0, GL_KEEP, GL_KEEP, GL_KEEP);
  draw(shape, {.depth = GL_EQUAL, .channel = 2});
  glDisable(GL_STENCIL_TEST);
  glDepthMask(GL_TRUE);
  record_picture(name);
}

}  // namespace

const std::vector<PassesCase>& stencil_cases() {
  static const std::vector<PassesCase> cases = {
      {"mask_plain_surface_warped", masked<C::kNone, C::kWarped>},
      {"mask_warped_surface_plain", masked<C::kWarped, C::kNone>},
      {"mask_warped_surface_twisted", masked<C::kWarped, C::kTwisted>},
      {"mirror", mirror},
      {"counted_failures", counted_failures<C::kWarped, C::kNone>},
      {"counted_failures_warped", counted_failures<C::kNone, C::kWarped>},
      {"counted_passes", counted_passes},
      {"counted_up_and_down", counted_up_and_down},
      {"shadow", shadow},
  };
  return cases;
}

}  // namespace truequad::semantics
