#include "pass.h"

#include "record.h"

namespace truequad::semantics {
namespace {

std::array<float, 2> coordinates_of(Coordinates kind, const Vertex& v) {
  const float u = v.u, w = v.v;
  switch (kind) {
    case Coordinates::kAffine:
      return {0.5f * v.position[0], 0.5f * v.position[1]};
    case Coordinates::kOther:
      return {0.75f * u + 0.25f * w + 0.5f * u * w, w - 0.5f * u * w};
    case Coordinates::kTwisted:
      return {12 * u - 20 * u * w, 9 * w + 16 * u * w};
    default:
      return {u, w};
  }
}

// The pass's touch, with the alpha of the vertex of this number.
std::array<GLubyte, 4> kinked_colour(const Pass& pass, std::size_t number) {
  std::array<GLubyte, 4> colour{0, 0, 0, GLubyte(number * 59 % 4 * 20)};
  if (pass.channel != kUnseen) colour[std::size_t(pass.channel)] = kTouch;
  return colour;
}

void send(const Vertex& v, const Pass& pass, std::size_t number) {
  if (pass.kinked) glColor4ubv(kinked_colour(pass, number).data());
  if (pass.coordinates != Coordinates::kNone) {
    const auto t = coordinates_of(pass.coordinates, v);
    if (pass.way == Way::kDoubles)
      glTexCoord2d(t[0], t[1]);
    else
      glTexCoord2f(t[0], t[1]);
  }
  if (pass.second != Coordinates::kNone) {
    const auto t = coordinates_of(pass.second, v);
    glMultiTexCoord2f(GL_TEXTURE1, t[0], t[1]);
  }
  const auto& p = v.position;
  if (pass.way == Way::kDoubles) {
    const double values[] = {p[0], p[1], p[2]};
    glVertex3dv(values);
  } else {
    glVertex3f(p[0], p[1], p[2]);
  }
}

void send_arrays(const Primitive& primitive, const Pass& pass) {
  std::vector<std::array<float, 2>> texture;
  std::vector<std::array<GLubyte, 4>> colours;
  for (const Vertex& v : primitive.vertices) {
    texture.push_back(coordinates_of(pass.coordinates, v));
    colours.push_back(kinked_colour(pass, colours.size()));
  }
  if (pass.kinked) {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colours.data());
  }
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), primitive.vertices.data()->position.data());
  if (pass.coordinates != Coordinates::kNone) {
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, 0, texture.data());
  }
  glDrawArrays(primitive.mode, 0, GLsizei(primitive.vertices.size()));
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glDisableClientState(GL_COLOR_ARRAY);
}

void texturing(GLenum unit, Coordinates coordinates) {
  glActiveTexture(unit);
  if (coordinates == Coordinates::kNone || coordinates == Coordinates::kUnused)
    glDisable(GL_TEXTURE_2D);
  else
    glEnable(GL_TEXTURE_2D);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace

void prepare_passes() {
  const unsigned char white[] = {255, 255, 255, 255};
  GLuint texture = 0;
  glGenTextures(1, &texture);
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, texture);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glEnable(GL_DEPTH_TEST);
}

void begin_frame(const Shape& shape) {
  glViewport(0, 0, kWidth, kHeight);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(shape.projection.data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(shape.modelview.data());
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void send(const Shape& shape, const Pass& pass) {
  for (const Primitive& primitive : shape.primitives) {
    const bool apart = pass.way == Way::kBeginForEach && primitive.mode == GL_QUADS;
    if (pass.way == Way::kArrays) {
      send_arrays(primitive, pass);
      continue;
    }
    glBegin(primitive.mode);
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
      if (apart && i > 0 && i % 4 == 0) {
        glEnd();
        glBegin(primitive.mode);
      }
      send(primitive.vertices[i], pass, i);
    }
    glEnd();
  }
}

void draw(const Shape& shape, const Pass& pass) {
  texturing(GL_TEXTURE0, pass.coordinates);
  texturing(GL_TEXTURE1, pass.second);
  glDepthFunc(pass.depth);
  const GLboolean seen = pass.channel != kUnseen;
  glColorMask(seen, seen, seen, seen);
  GLubyte colour[4] = {0, 0, 0, 0};
  if (seen) colour[pass.channel] = kTouch;
  glColor4ubv(colour);
  if (pass.way == Way::kList) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    send(shape, pass);
    glEndList();
    glCallList(list);
    glDeleteLists(list, 1);
  } else {
    send(shape, pass);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace truequad::semantics
