// How samples draw: vertices between glBegin and glEnd, one call after the other. Here also, outside of the
// scenes, is what makes their pictures measurable: a list of the quads that were drawn, and a texture that
// tells its coordinates.
#pragma once

#include <GL/gl.h>

#include <array>
#include <span>
#include <string>

#include "common/sample.h"

namespace samples {

struct Vertex {
  std::array<float, 3> position;
  std::array<float, 2> texture;
  std::array<float, 3> normal{0, 0, 1};
};

// Draws with the texture that is bound and enabled. mode: GL_QUADS, GL_QUAD_STRIP, or GL_POLYGON with four
// vertices.
void draw_quads(GLenum mode, std::span<const Vertex> vertices);

// Before each frame: which texture draw_quads uses instead of the scene's, and whether it keeps a list.
void begin_frame(Coordinates coordinates, bool keep_list);

// Writes the list of this frame as JSON:
//   {"quads": [{"clip_from_object": [16, column-major], "viewport": [x, y, width, height],
//               "position": [4 corners of x, y, z, w], "texture": [4 corners of s, t, r, q]}, …]}
// with the corners in drawing order around the quad. Quad n of the list (from 1) has the colour (blue, alpha)
// = (n mod 256, n / 256) in pictures of coordinates, where 0 is no quad.
void write_quads(const std::string& file);

}  // namespace samples
