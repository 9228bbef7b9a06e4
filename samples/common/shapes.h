// Quads of glBegin/glEnd, drawn with a call for each vertex, and a list of them for whoever wants to know
// what the picture ought to show.
#pragma once

#include <GL/gl.h>

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace samples {

// A vertex: texture coordinates, normal, place.
struct Vertex {
  float s, t;
  float x, y, z = 0;
  std::array<float, 3> normal{0, 0, 1};
};

// Four vertices a quad.
void draw_quads(std::span<const Vertex> vertices);
inline void draw_quads(std::initializer_list<Vertex> vertices) {
  draw_quads({vertices.begin(), vertices.size()});
}

// Two vertices more with every quad.
void draw_quad_strip(std::span<const Vertex> vertices);

// Begins a list: what is drawn from now on is written to `file` by write_quads, one object a quad:
//   {"position": [[x,y,z,w] x4], "texture": [[s,t,r,q] x4], "clip_from_object": [16, by columns],
//    "viewport": [x,y,width,height]}
void list_quads();
// Throws std::runtime_error when the file cannot be written.
void write_quads(const std::string& file);

}  // namespace samples
