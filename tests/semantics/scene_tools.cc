#include "scene_tools.h"

#include <algorithm>

namespace truequad::semantics {

void prepare_scene() {
  prepare_passes();
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_TEXTURE_2D);
  glColor3f(1, 1, 1);
}

Ramp::Ramp(const Shape& shape, float x, float y, float z) : direction_{x, y, z} {
  float high = low_ = along(shape.primitives[0].vertices[0]);
  for (const Primitive& primitive : shape.primitives) {
    for (const Vertex& v : primitive.vertices) {
      low_ = std::min(low_, along(v));
      high = std::max(high, along(v));
    }
  }
  size_ = high - low_;
}

float Ramp::along(const Vertex& v) const {
  return direction_[0] * v.position[0] + direction_[1] * v.position[1] + direction_[2] * v.position[2];
}

float Ramp::operator()(const Vertex& v) const { return 0.1f + 0.8f * (along(v) - low_) / size_; }

void send_warped_quad() {
  for (const Corner& c : kWarpedQuad) {
    glTexCoord2f(c.s, c.t);
    glVertex2f(c.x, c.y);
  }
}

}  // namespace truequad::semantics
