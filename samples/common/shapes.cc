#include "common/shapes.h"

#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace samples {
namespace {

bool listing = false;
nlohmann::json quads = nlohmann::json::array();

void vertex(const Vertex& v) {
  glTexCoord2f(v.s, v.t);
  glNormal3fv(v.normal.data());
  glVertex3f(v.x, v.y, v.z);
}

// Corners in the order of OpenGL 1.1, section 2.6.1: a strip's quad 2i-1, 2i, 2i+2, 2i+1.
void list(std::span<const Vertex> vertices, std::size_t step, std::array<std::size_t, 4> order) {
  if (!listing) return;
  GLfloat modelview[16], projection[16];
  std::array<GLint, 4> viewport;
  glGetFloatv(GL_MODELVIEW_MATRIX, modelview);
  glGetFloatv(GL_PROJECTION_MATRIX, projection);
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  const glm::dmat4 clip = glm::dmat4(glm::make_mat4(projection)) * glm::dmat4(glm::make_mat4(modelview));
  for (std::size_t first = 0; first + 4 <= vertices.size(); first += step) {
    nlohmann::json quad;
    for (std::size_t corner : order) {
      const Vertex& v = vertices[first + corner];
      quad["position"].push_back({v.x, v.y, v.z, 1});
      quad["texture"].push_back({v.s, v.t, 0, 1});
    }
    for (int i = 0; i < 16; ++i) quad["clip_from_object"].push_back(clip[i / 4][i % 4]);
    quad["viewport"] = viewport;
    quads.push_back(std::move(quad));
  }
}

}  // namespace

void draw_quads(std::span<const Vertex> vertices) {
  list(vertices, 4, {0, 1, 2, 3});
  glBegin(GL_QUADS);
  for (const Vertex& v : vertices) vertex(v);
  glEnd();
}

void draw_quad_strip(std::span<const Vertex> vertices) {
  list(vertices, 2, {0, 1, 3, 2});
  glBegin(GL_QUAD_STRIP);
  for (const Vertex& v : vertices) vertex(v);
  glEnd();
}

void list_quads() {
  listing = true;
  quads.clear();
}

void write_quads(const std::string& file) {
  std::ofstream stream(file);
  stream << quads.dump() << '\n';
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file);
}

}  // namespace samples
