// The exact maps of a quadrilateral, by direct solution in extended precision and sharing nothing with the
// kernel but its plain structs. Window coordinates are OpenGL's: x right, y up, pixel (i, j) has its centre
// at (i + 0.5, j + 0.5).
#pragma once

#include <optional>
#include <vector>

#include "truequad/kernel.h"

namespace truequad::reference {

using Real = long double;

struct Point {
  Real x, y;
};

// Parameters at which two bilinear functions vanish, given by their values at the corners A B C D: at most
// two, anywhere in the plane; none if they vanish on a curve.
struct Solution {
  Real u, v;
};
std::vector<Solution> solve_bilinear(const std::array<Real, 4>& f, const std::array<Real, 4>& g);

// Clip coordinates of the corners: matrix times position.
using ClipCorner = std::array<Real, 4>;
std::array<ClipCorner, 4> clip_corners(const Corners& position, const View& view);

// The window point of the bilinear surface at (u, v); none at or behind the eye.
std::optional<Point> window_point(const std::array<ClipCorner, 4>& clip, const View& view, Real u, Real v);

// Bilinear map: distance in pixels from `drawn` to the nearest exact place of texel (s, t) on the quad.
// `slack`: how far outside of the unit square parameters still count. Infinite if the texel has no place on
// it in front of the eye.
Real bilinear_displacement(const Corners& position, const Corners& texture, const View& view, Point drawn,
                           Real s, Real t, Real slack = 1e-6L);

// The same where only s is told apart: distance to the nearest point of the curve of that s, found by
// sampling the curve and refining at the nearest sample (never below the true distance).
Real bilinear_displacement_1d(const Corners& position, const Corners& texture, const View& view, Point drawn,
                              Real s);

// Bilinear map, forward: what is seen at a window point. The nearest of several sheets is seen.
struct Seen {
  Real u, v, s, t, depth;  // depth: z / w
};
std::optional<Seen> bilinear_at(const Corners& position, const Corners& texture, const View& view,
                                Point window, Real slack = 0);

// The projective map (homography) from the quad's four window points to its four texels.
class ProjectiveMap {
 public:
  ProjectiveMap(const Corners& position, const Corners& texture, const View& view);
  bool valid() const { return valid_; }
  Point texel_at(Point window) const;
  Real displacement(Point drawn, Real s, Real t) const;

 private:
  std::array<std::array<Real, 3>, 3> texel_from_window_{}, window_from_texel_{};
  bool valid_ = false;
};

}  // namespace truequad::reference
