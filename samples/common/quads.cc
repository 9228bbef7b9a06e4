#include "common/quads.h"

#include <fstream>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace samples {
namespace {

constexpr int kDigits = 256;  // values of one channel, hence texels of the coordinate texture

struct Frame {
  Coordinates coordinates = Coordinates::kNone;
  bool keep_list = false;
  unsigned count = 0;
  nlohmann::json quads = nlohmann::json::array();
} frame;

// Texel (i, j) has red i and green j; blue and alpha are left to the colour of the quad.
GLuint coordinate_texture() {
  static const GLuint texture = [] {
    std::vector<unsigned char> texels;
    for (int j = 0; j < kDigits; ++j) {
      for (int i = 0; i < kDigits; ++i) {
        for (const int value : {i, j, 255, 255}) texels.push_back((unsigned char)value);
      }
    }
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, wrap, GL_REPEAT);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kDigits, kDigits, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    return name;
  }();
  return texture;
}

// Everything that would change a texel's value on its way into the picture is switched off.
void show_coordinates() {
  for (const GLenum effect : {GL_LIGHTING, GL_FOG, GL_BLEND, GL_DITHER, GL_ALPHA_TEST}) glDisable(effect);
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, coordinate_texture());
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  // The last vertex of each quad alone gives its colour, so that strips can be numbered too (GL 2.1,
  // table 2.12).
  glShadeModel(GL_FLAT);
  const float scale = frame.coordinates == Coordinates::kFine ? kDigits : 1;
  glMatrixMode(GL_TEXTURE);
  glPushMatrix();
  glLoadIdentity();
  glScalef(scale, scale, 1);
  glMatrixMode(GL_MODELVIEW);
}

void hide_coordinates() {
  glMatrixMode(GL_TEXTURE);
  glPopMatrix();
  glMatrixMode(GL_MODELVIEW);
}

void list_quads(GLenum mode, std::span<const Vertex> vertices) {
  glm::mat4 modelview, projection;
  std::array<GLint, 4> viewport;
  glGetFloatv(GL_MODELVIEW_MATRIX, glm::value_ptr(modelview));
  glGetFloatv(GL_PROJECTION_MATRIX, glm::value_ptr(projection));
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  const glm::dmat4 clip_from_object = glm::dmat4(projection) * glm::dmat4(modelview);
  const bool strip = mode == GL_QUAD_STRIP;
  // A strip's pairs run across it: around the quad its last two vertices come in the opposite order.
  const std::array<std::size_t, 4> around =
      strip ? std::array<std::size_t, 4>{0, 1, 3, 2} : std::array<std::size_t, 4>{0, 1, 2, 3};
  for (std::size_t first = 0; first + 4 <= vertices.size(); first += strip ? 2 : 4) {
    nlohmann::json position, texture;
    for (const std::size_t i : around) {
      const Vertex& v = vertices[first + i];
      position.push_back({v.position[0], v.position[1], v.position[2], 1});
      texture.push_back({v.texture[0], v.texture[1], 0, 1});
    }
    frame.quads.push_back({{"clip_from_object", std::vector<double>(glm::value_ptr(clip_from_object),
                                                                    glm::value_ptr(clip_from_object) + 16)},
                           {"viewport", viewport},
                           {"position", position},
                           {"texture", texture}});
  }
}

}  // namespace

void begin_frame(Coordinates coordinates, bool keep_list) {
  frame = {coordinates, keep_list, 0, nlohmann::json::array()};
}

void draw_quads(GLenum mode, std::span<const Vertex> vertices) {
  if (frame.keep_list) list_quads(mode, vertices);
  const bool coordinates = frame.coordinates != Coordinates::kNone;
  if (coordinates) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    show_coordinates();
  }
  glBegin(mode);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex& v = vertices[i];
    if (coordinates && i % (mode == GL_QUAD_STRIP ? 2 : 4) == 0) {
      if (mode != GL_QUAD_STRIP || i > 0) ++frame.count;
      glColor4ub(255, 255, GLubyte(frame.count % kDigits), GLubyte(frame.count / kDigits));
    }
    glNormal3fv(v.normal.data());
    glTexCoord2fv(v.texture.data());
    glVertex3fv(v.position.data());
  }
  glEnd();
  if (coordinates) {
    hide_coordinates();
    glPopAttrib();
  }
}

void write_quads(const std::string& file) {
  std::ofstream out(file);
  out << nlohmann::json{{"quads", frame.quads}} << '\n';
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + file);
}

}  // namespace samples
