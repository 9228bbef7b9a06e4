#include "elements.h"

#include <cstring>

namespace truequad::images {

std::vector<Element> elements_of(const Primitive& p) {
  std::vector<Element> elements;
  for (const Vertex& v : p.vertices) {
    Element e{{}, {1, 1, 1 - v.mark / 255.0f, 1}, {0, 0, 1}, {}};
    std::memcpy(e.texture, v.texture.data(), sizeof e.texture);
    std::memcpy(e.position, v.position.data(), sizeof e.position);
    elements.push_back(e);
  }
  return elements;
}

std::vector<Element> all_elements(const Scene& scene, std::vector<GLint>& first, std::vector<GLsizei>& count) {
  std::vector<Element> all;
  for (const Primitive& p : scene.primitives) {
    first.push_back(GLint(all.size()));
    count.push_back(count_of(p));
    const auto elements = elements_of(p);
    all.insert(all.end(), elements.begin(), elements.end());
  }
  return all;
}

void point_at(const unsigned char* base, GLsizei stride) {
  glTexCoordPointer(4, GL_FLOAT, stride, base + offsetof(Element, texture));
  glColorPointer(4, GL_FLOAT, stride, base + offsetof(Element, color));
  glVertexPointer(4, GL_FLOAT, stride, base + offsetof(Element, position));
}
void point_at(const std::vector<Element>& elements) {
  point_at(reinterpret_cast<const unsigned char*>(elements.data()));
}

namespace {
constexpr GLenum kArrays[] = {GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY, GL_VERTEX_ARRAY};
}  // namespace

void enable_arrays() {
  for (GLenum array : kArrays) glEnableClientState(array);
}
void disable_arrays() {
  for (GLenum array : kArrays) glDisableClientState(array);
}

GLuint buffer_of(GLenum target, std::size_t size, const void* data, GLenum usage) {
  GLuint name;
  glGenBuffers(1, &name);
  glBindBuffer(target, name);
  glBufferData(target, GLsizeiptr(size), data, usage);
  return name;
}
void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }

}  // namespace truequad::images
