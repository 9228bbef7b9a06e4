// What a rasteriser adds to the error of a triangle: vertices snapped to a grid, and set-up in floating point.
// Derived in docs/design.md "Rasterisers".
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <span>

#include "screen.h"

namespace truequad::kernel {

struct Rasteriser {
  double snap_px = 0;   // View::snap_px
  double rounding = 0;  // View::setup_rounding
  // The viewport's centre, and the largest window coordinates that can be drawn.
  double centre_x_px = 0, centre_y_px = 0, reach_x_px = 0, reach_y_px = 0;

  bool exact() const { return rounding == 0; }
  // How far a vertex may be from where it is drawn, in x and in y.
  double step_px() const;
};
Rasteriser make_rasteriser(const View& view);

// How far, in pixels, the rounding of the vertices that are sent, and of their way to the screen, may move a visible point of
// the quad: much where their coordinates are large beside the quad, as those of a map are.
double vertex_rounding_px(const Rasteriser& rasteriser, const Corners& position, const View& view, const ScreenQuad& quad);

// Values that a rasteriser interpolates over a triangle: a window point, in pixels from the viewport's centre,
// s and t times q, and q, which is 1 / w times the q of the texture coordinates.
struct SetupVertex {
  double x, y, s, t, q;
};
// A triangle as set-up sees it.
struct WindowTriangle {
  std::array<glm::dvec2, 3> side;  // side i from vertex i + 1 to vertex i + 2
  double area;                     // twice the triangle's, with sign

  template <typename Point>
  WindowTriangle(const Point& a, const Point& b, const Point& c)
      : side{glm::dvec2(c.x - b.x, c.y - b.y), glm::dvec2(a.x - c.x, a.y - c.y), glm::dvec2(b.x - a.x, b.y - a.y)},
        area(side[0].x * side[1].y - side[0].y * side[1].x) {}
};

// How far outside of a triangle's own image its pixels may lie, since they are those of the snapped triangle
// while its values may be interpolated between the vertices before snapping.
struct SnapMargin {
  double error = 0;     // added to the interpolation error of uv
  double u = 0, v = 0;  // largest steps of the parameters
  double w = 1;         // factor that w may lose

  void include(const SnapMargin& other);
};
// gradient_u, gradient_v: of the linear interpolant of uv over the triangle, which is visible as a whole.
using TriangleCorners = std::array<const MeshPoint*, 3>;
SnapMargin snap_margin(const Rasteriser& rasteriser, const TriangleCorners& corner, const WindowTriangle& window,
                       double gradient_u, double gradient_v);
// The same for a triangle with this visible part.
SnapMargin clipped_snap_margin(const Rasteriser& rasteriser, const TriangleCorners& corner,
                               double gradient_u, double gradient_v, std::span<const ScreenPoint> visible);

// Largest displacement in pixels, at each vertex, of a texel that the rounding of set-up and evaluation causes. Between
// the vertices it is no more than their interpolant. t_drawn: false if only s is interpolated.
std::array<double, 3> setup_px(const Rasteriser& rasteriser, const std::array<SetupVertex, 3>& vertex,
                               const WindowTriangle& window, bool t_drawn);

// True if no pixel's centre can be in the convex polygon of these points, wherever its vertices are snapped to.
bool misses_pixels(const Rasteriser& rasteriser, std::span<const ScreenPoint> polygon);

}  // namespace truequad::kernel
