// Vertices in arrays: what the ways of drawing from them are made of.
#pragma once

#include <cstddef>
#include <vector>

#include "ways.h"

namespace truequad::images {

// The vertices of one primitive as arrays hold them; glInterleavedArrays knows this as GL_T4F_C4F_N3F_V4F.
struct Element {
  GLfloat texture[4], color[4], normal[3], position[4];
};
constexpr GLsizei kStride = sizeof(Element);

inline GLsizei count_of(const Primitive& p) { return GLsizei(p.vertices.size()); }
std::vector<Element> elements_of(const Primitive& p);

// Of all primitives; `first` says where each begins.
std::vector<Element> all_elements(const Scene& scene, std::vector<GLint>& first, std::vector<GLsizei>& count);

// `base`: an address, or an offset in the buffer that is bound.
void point_at(const unsigned char* base, GLsizei stride = kStride);
void point_at(const std::vector<Element>& elements);
inline const unsigned char* offset(std::size_t bytes) { return reinterpret_cast<const unsigned char*>(bytes); }

// Of texture coordinates, colours and positions.
void enable_arrays();
void disable_arrays();

GLuint buffer_of(GLenum target, std::size_t size, const void* data, GLenum usage = GL_STATIC_DRAW);
void delete_buffer(GLuint name);

// Indices that put the elements in another order; `elements` is rearranged to match.
template <typename T>
std::vector<T> shuffled(std::vector<Element>& elements) {
  const std::size_t count = elements.size();
  std::vector<T> indices(count);
  std::vector<Element> moved(count);
  for (std::size_t i = 0; i < count; ++i) {
    indices[i] = T(count - 1 - i);
    moved[count - 1 - i] = elements[i];
  }
  elements = moved;
  return indices;
}

// Arrays of every type, whose numbers are integers: "typed_immediate" and others that draw the same.
void add_typed_ways(std::map<std::string, Way>& ways);

// Normals, colours, secondary colours and fog coordinates of every type: "lit_bytes", "lit_bytes_immediate", "colored_bytes" …
void add_attribute_ways(std::map<std::string, Way>& ways);

// Arrays in buffer objects, whose contents come about in many ways.
void add_buffer_ways(std::map<std::string, Way>& ways);

}  // namespace truequad::images
