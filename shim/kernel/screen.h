// A quad in clip space as the screen sees it; clip volume of the OpenGL 2.1 specification, section 2.12.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "truequad/kernel.h"

namespace truequad::kernel {

// A clip-space point with x and y in pixels from the viewport's centre times w: x / w is a distance in
// pixels.
using ScreenPoint = glm::dvec4;

// A corner of a mesh triangle: parameters and the clip-space point drawn there. Where w > 0 also the window point, in pixels
// from the viewport's centre, and q = 1 / w.
struct MeshPoint {
  double u, v;
  ScreenPoint p;
  double x, y, q;
  unsigned outside;  // its outcode
};

struct ScreenQuad {
  std::array<ScreenPoint, 4> corner;
  // P(u,v) = corner[0] + along_u u + along_v v + twist uv.
  ScreenPoint along_u, along_v, twist;
  double half_width, half_height;  // of the viewport, px

  ScreenPoint at(double u, double v) const { return corner[0] + u * along_u + v * along_v + (u * v) * twist; }
  // One bit for each plane of the clip volume that the point is outside of.
  unsigned outcode(const ScreenPoint& p) const {
    return unsigned(p.x < -half_width * p.w) | unsigned(p.x > half_width * p.w) << 1 |
           unsigned(p.y < -half_height * p.w) << 2 | unsigned(p.y > half_height * p.w) << 3 |
           unsigned(p.z < -p.w) << 4 | unsigned(p.z > p.w) << 5;
  }
  MeshPoint mesh_point(double u, double v) const {
    const ScreenPoint p = at(u, v);
    const double q = 1 / p.w;
    return {u, v, p, p.x * q, p.y * q, q, outcode(p)};
  }
  // True if no part of the quad, nor of any mesh of it, can be inside the clip volume.
  bool invisible() const;
  // True if the ends of the edge from corner i to the next are so near on the screen that nothing along it
  // can be told apart.
  bool collapsed_edge(int i) const;
  // Part of the quad between the edge from corner i to the next and the nearest line of constant parameter whose ends, as
  // far as they can be, are `px` away from the edge. Nothing if that is beyond `most`.
  double parameter_at(int i, double px, double most) const;
};

// Weights of a triangle's corners, which sum to 1, at any homogeneous point of its plane.
class BarycentricWeights {
 public:
  explicit BarycentricWeights(const std::array<ScreenPoint, 3>& corner);
  glm::dvec3 at(const ScreenPoint& p) const;
  // How they change over a step of (x, y) pixels at unit w; the sum changes too.
  glm::dvec3 step(double x, double y) const { return {step_of(0, x, y), step_of(1, x, y), step_of(2, x, y)}; }

 private:
  double step_of(int i, double x, double y) const { return row_[i].x * x + row_[i].y * y; }
  glm::dvec3 row_[3];  // of the inverse of the corners' matrix
};

// The view of a quad. Returns false if a coordinate of it is not finite.
bool make_screen_quad(const Corners& position, const View& view, ScreenQuad& quad);

// The part of a triangle inside the clip volume: a convex polygon, perhaps empty.
struct VisiblePart {
  std::array<ScreenPoint, 9> point;  // three corners and one more for each of six planes
  int count = 0;
  std::span<const ScreenPoint> points() const { return {point.data(), std::size_t(count)}; }
};

// `planes`: the union of the three outcodes.
void clip_triangle(const ScreenQuad& quad, const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
                   unsigned planes, VisiblePart& part);

// The three of these points that span the largest triangle on the screen; false if there are fewer.
bool largest_triangle(std::span<const ScreenPoint> points, std::array<int, 3>& out);

}  // namespace truequad::kernel
