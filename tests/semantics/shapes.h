// The surfaces that are drawn several times over: immediate-mode primitives whose unit-square texture
// coordinates are warped on the screen. The seed is the number of the trial.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gl.h"

namespace truequad::semantics {

struct Vertex {
  std::array<float, 3> position;
  float u, v;  // of the surface's own grid: whole numbers at its corners
};

struct Primitive {
  GLenum mode;
  std::vector<Vertex> vertices;
};

using Matrix = std::array<float, 16>;  // column-major

struct Shape {
  std::vector<Primitive> primitives;
  Matrix projection, modelview;
};

// The names, in the order of the tables:
//   trapezoid   planar, in the plane z = 0 of its own space, seen in perspective
//   tilted      planar to the rounding of its vertices only, as a wall of a house model is
//   floor       planar, from ahead of the eye to behind it
//   non_planar  its picture is convex, so two triangles and the bilinear surface cover the same pixels
//   folded      non-planar, and its picture is not convex
//   mixed       trapezoids and parallelograms side by side in one glBegin
//   strip       the like as GL_QUAD_STRIP
//   polygon     GL_POLYGON of four vertices
const std::vector<std::string>& shape_names();
Shape make_shape(const std::string& name, unsigned seed);

}  // namespace truequad::semantics
