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

void NotedVertices::note(const Vertex& vertex) {
  Noted noted{};
  glGetFloatv(GL_CURRENT_COLOR, noted.colour);
  glGetFloatv(GL_CURRENT_SECONDARY_COLOR, noted.secondary);
  glGetFloatv(GL_CURRENT_NORMAL, noted.normal);
  glGetFloatv(GL_CURRENT_FOG_COORD, &noted.fog);
  glGetBooleanv(GL_EDGE_FLAG, &noted.edge);
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glActiveTexture(GL_TEXTURE1);
  glGetFloatv(GL_CURRENT_TEXTURE_COORDS, noted.second);
  glActiveTexture(GLenum(active));
  noted.texture[0] = vertex.u;
  noted.texture[1] = vertex.v;
  std::copy(vertex.position.begin(), vertex.position.end(), noted.position);
  vertices_.push_back(noted);
}

void NotedVertices::draw(GLenum mode) const {
  constexpr GLenum kArrays[] = {GL_COLOR_ARRAY,     GL_SECONDARY_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_FOG_COORD_ARRAY,
                                GL_EDGE_FLAG_ARRAY, GL_TEXTURE_COORD_ARRAY,   GL_VERTEX_ARRAY};
  constexpr GLsizei kStride = sizeof(Noted);
  const Noted& first = vertices_.front();
  glColorPointer(4, GL_FLOAT, kStride, first.colour);
  glSecondaryColorPointer(3, GL_FLOAT, kStride, first.secondary);
  glNormalPointer(GL_FLOAT, kStride, first.normal);
  glFogCoordPointer(GL_FLOAT, kStride, &first.fog);
  glEdgeFlagPointer(kStride, &first.edge);
  glVertexPointer(3, GL_FLOAT, kStride, first.position);
  glTexCoordPointer(2, GL_FLOAT, kStride, first.texture);
  for (const GLenum array : kArrays) glEnableClientState(array);
  glClientActiveTexture(GL_TEXTURE1);
  glTexCoordPointer(4, GL_FLOAT, kStride, first.second);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glDrawArrays(mode, 0, GLsizei(vertices_.size()));
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
  for (const GLenum array : kArrays) glDisableClientState(array);
}

void send_warped_quad() {
  for (const Corner& c : kWarpedQuad) {
    glTexCoord2f(c.s, c.t);
    glVertex2f(c.x, c.y);
  }
}

}  // namespace truequad::semantics
