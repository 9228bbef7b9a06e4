// Passes over the same vertices while something else moves: the camera, the object, the viewport, the depth
// range, the polygon offset.
#include <cmath>

#include "cases.h"
#include "pass.h"
#include "record.h"

namespace truequad::semantics {
namespace {

using C = Coordinates;

constexpr Pass kWall = {.coordinates = C::kWarped};
constexpr Pass kLight = {.depth = GL_EQUAL, .channel = 1};
constexpr Pass kLightMap = {.coordinates = C::kOther, .depth = GL_EQUAL, .channel = 2};

void all_passes(const Shape& shape) {
  draw(shape, kWall);
  draw(shape, kLight);
  draw(shape, kLightMap);
}

void same_frames(const Shape& shape, const std::string& name) {
  for (int frame = 0; frame < 3; ++frame) {
    begin_frame(shape);
    all_passes(shape);
    record_picture(name + " " + std::to_string(frame));
  }
}

// What an earlier frame left behind must not be taken for this one's.
void moving_camera(const Shape& shape, const std::string& name) {
  for (int frame = 0; frame < 4; ++frame) {
    begin_frame(shape);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0625f * float(frame), 0, -0.125f * float(frame));
    glRotatef(3.0f * float(frame), 0, 1, 0);
    glMultMatrixf(shape.modelview.data());
    all_passes(shape);
    record_picture(name + " " + std::to_string(frame));
  }
}

// Copies at several places, in parallel planes, so that none cuts another.
void instance(const Shape& shape, int number, const Pass& pass) {
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glLoadIdentity();
  glTranslatef(0.75f * float(number - 1), 0.25f * float(number), -1.5f * float(number));
  glMultMatrixf(shape.modelview.data());
  draw(shape, pass);
  glPopMatrix();
}

void instances(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  for (const Pass& pass : {kWall, kLight, kLightMap}) {
    for (int i = 0; i < 3; ++i) instance(shape, i, pass);
  }
  record_picture(name);
}

void instances_in_turn(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  for (int i = 2; i >= 0; --i) {
    for (const Pass& pass : {kWall, kLight}) instance(shape, i, pass);
  }
  record_picture(name);
}

void viewports(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  for (const Pass& pass : {kWall, kLight, kLightMap}) {
    for (int i = 0; i < 2; ++i) {
      glViewport(i * kWidth / 2, i ? 7 : 0, kWidth / 2, i ? kHeight / 3 : kHeight);
      draw(shape, pass);
    }
  }
  record_picture(name);
}

void depth_range(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  glDepthRange(0.25, 0.625);
  all_passes(shape);
  record_picture(name);
  glDepthRange(0, 1);
}

// A projection that changes in the third decimal between passes and back again.
void projection_and_back(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  draw(shape, kWall);
  glMatrixMode(GL_PROJECTION);
  glPushMatrix();
  glScalef(1.001f, 1, 1);
  draw(shape, {.coordinates = C::kWarped, .depth = GL_NEVER});
  glPopMatrix();
  draw(shape, kLight);
  draw(shape, kLightMap);
  record_picture(name);
}

// Scissored: half of the wall at a time.
void scissor(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  draw(shape, kWall);
  glEnable(GL_SCISSOR_TEST);
  for (int half = 0; half < 2; ++half) {
    glScissor(half * kWidth / 2, 0, kWidth / 2, kHeight);
    draw(shape, kLight);
    draw(shape, kLightMap);
  }
  glDisable(GL_SCISSOR_TEST);
  record_picture(name);
}

template <int factor, int units, GLenum comparison>
void offset_second(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  draw(shape, kWall);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(factor, units);
  draw(shape, {.depth = comparison, .channel = 1});
  glDisable(GL_POLYGON_OFFSET_FILL);
  record_picture(name);
}

// The wall is pushed away; its second pass, which is not, lies before it.
void offset_first(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  draw(shape, kWall);
  glDisable(GL_POLYGON_OFFSET_FILL);
  draw(shape, {.depth = GL_LESS, .channel = 1});
  record_picture(name);
}

void offset_both(const Shape& shape, const std::string& name) {
  begin_frame(shape);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  all_passes(shape);
  glDisable(GL_POLYGON_OFFSET_FILL);
  record_picture(name);
}

// A smaller picture of the surface in its own plane, pulled forward: red is the decal alone, blue the wall,
// green the decal on the wall.
template <C wall, C picture>
void decal(const Shape& shape, const std::string& name) {
  Shape smaller = shape;
  for (Primitive& primitive : smaller.primitives) {
    const Vertex centre = primitive.vertices[0];
    for (Vertex& v : primitive.vertices) {
      // Only these lie in one plane to the last bit.
      if (v.position[2] != 0) return;
      for (const std::size_t i : {0u, 1u}) {
        v.position[i] =
            0.5f * v.position[i] + (shape.primitives[0].mode == GL_QUADS ? 0.25f * centre.position[i] : 0);
      }
    }
  }
  begin_frame(shape);
  glDisable(GL_DEPTH_TEST);
  draw(smaller, {.coordinates = picture});
  glEnable(GL_DEPTH_TEST);
  draw(shape, {.coordinates = wall, .channel = 2});
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -1);
  draw(smaller, {.coordinates = picture, .depth = GL_LEQUAL, .channel = 1});
  glDisable(GL_POLYGON_OFFSET_FILL);
  record_picture(name);
}

}  // namespace

const std::vector<PassesCase>& frame_cases() {
  static const std::vector<PassesCase> cases = {
      {"same_frames", same_frames},
      {"moving_camera", moving_camera},
      {"instances", instances},
      {"instances_in_turn", instances_in_turn},
      {"viewports", viewports},
      {"depth_range", depth_range},
      {"projection_and_back", projection_and_back},
      {"scissor", scissor},
      {"offset_decal_less", offset_second<-1, -1, GL_LESS>},
      {"offset_decal_lequal", offset_second<-1, -1, GL_LEQUAL>},
      {"offset_behind", offset_second<1, 1, GL_LEQUAL>},
      {"offset_first", offset_first},
      {"offset_both", offset_both},
      {"decal_plain_on_warped", decal<C::kWarped, C::kNone>},
      {"decal_affine_on_warped", decal<C::kWarped, C::kAffine>},
      {"decal_warped_on_plain", decal<C::kNone, C::kWarped>},
      {"decal_warped_on_warped", decal<C::kOther, C::kWarped>},
  };
  return cases;
}

}  // namespace truequad::semantics
