// The bound of docs/design.md "Error of a triangle"; names as there.
#include "error_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace truequad::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// For the rounding of this computation itself.
constexpr double kRoundingSlack = 1 + 1e-9;

// A bilinear function of the parameters: along_u u + along_v v + twist uv (its constant does not matter).
struct Bilinear {
  double along_u, along_v, twist;
};

Bilinear component(const Corners& x, double Vec4::*of) {
  return {x[1].*of - x[0].*of, x[3].*of - x[0].*of, (x[0].*of - x[1].*of) + (x[2].*of - x[3].*of)};
}

bool varies(const Bilinear& f) { return f.along_u != 0 || f.along_v != 0 || f.twist != 0; }

// N = (J_T at the origin) K - (K_T x T_v) P_u - (T_u x K_T) P_v, and the determinant's coefficients.
TextureMap make_map(const ScreenQuad& quad, const Bilinear& s, const Bilinear& t) {
  TextureMap map;
  map.constant = s.along_u * t.along_v - t.along_u * s.along_v;
  map.of_v = s.twist * t.along_v - t.twist * s.along_v;
  map.of_u = s.along_u * t.twist - t.along_u * s.twist;
  const ScreenPoint n = map.constant * quad.twist - map.of_v * quad.along_u - map.of_u * quad.along_v;
  map.x = n.x;
  map.y = n.y;
  map.w = n.w;
  return map;
}

// Are the corners of (s, t) on one line, to the rounding of the doubles?
bool collinear(const Bilinear& s, const Bilinear& t) {
  const auto small = [](double a, double b) {
    return std::fabs(a - b) <= 0x1p-40 * (std::fabs(a) + std::fabs(b));
  };
  return small(s.along_u * t.along_v, t.along_u * s.along_v) &&
         small(s.along_u * t.twist, t.along_u * s.twist) && small(s.along_v * t.twist, t.along_v * s.twist);
}

// The determinant is 0 or changes sign in the unit square.
bool folds(const TextureMap& map) {
  const double at[4] = {map.constant, map.jacobian(1, 0), map.jacobian(1, 1), map.jacobian(0, 1)};
  return !(*std::min_element(at, at + 4) > 0) && !(*std::max_element(at, at + 4) < 0);
}

// Only `s` is told apart: a texel is a curve of constant s, and any second function may choose which point of
// the curve counts as its place. This one has a gradient orthogonal to that of s in the middle of the quad,
// and the twist that makes the displacement least there, or as much of it as does not fold the map.
TextureMap make_curve_map(const ScreenQuad& quad, const Bilinear& s) {
  const double gradient_u = s.along_u + s.twist / 2, gradient_v = s.along_v + s.twist / 2;
  const auto with_twist = [&](double twist) {
    return make_map(quad, s, {-gradient_v - twist / 2, gradient_u - twist / 2, twist});
  };
  const TextureMap plain = with_twist(0);
  const ScreenPoint middle = quad.at(0.5, 0.5);
  if (!(middle.w > 0)) return plain;
  // The displacement is linear in the twist.
  const auto shift = [&](const TextureMap& map) {
    return std::array<double, 2>{map.x - middle.x / middle.w * map.w, map.y - middle.y / middle.w * map.w};
  };
  const double unit = std::max(std::fabs(gradient_u), std::fabs(gradient_v));
  const auto at_zero = shift(plain), at_unit = shift(with_twist(unit));
  const double dx = at_unit[0] - at_zero[0], dy = at_unit[1] - at_zero[1], square = dx * dx + dy * dy;
  if (!(square > 0)) return plain;
  const double best = -unit * ((at_zero[0] * dx + at_zero[1] * dy) / square);
  for (double part : {1.0, 0.75, 0.5, 0.25}) {
    const TextureMap map = with_twist(part * best);
    if (!folds(map)) return map;
  }
  return plain;
}

void add_map(ErrorModel& model, const Bilinear& s, const Bilinear& t) {
  if (!varies(s) && !varies(t)) return;
  const auto size = [](const Bilinear& f) {
    return std::fabs(f.along_u) + std::fabs(f.along_v) + std::fabs(f.twist);
  };
  const TextureMap map = collinear(s, t) ? make_curve_map(model.screen, size(s) >= size(t) ? s : t)
                                         : make_map(model.screen, s, t);
  model.folded |= folds(map);
  model.map[model.map_count++] = map;
}

// Part of a triangle: e, the interpolation error of uv, is known at its corners.
struct Corner {
  double u, v, e;
  ScreenPoint p;
};

// Distance in pixels that `map` moves a texel which is drawn in the hull of `points`, when |e| <= error there
// and the determinant is at least `jacobian` in size.
double displacement(const TextureMap& map, double error, double jacobian,
                    std::span<const ScreenPoint> points) {
  if (!(jacobian > 0)) return kInfinity;
  const double root = jacobian * jacobian - 4 * std::fabs(map.of_u * map.of_v) * error;
  if (!(root >= 0)) return kInfinity;
  const double sigma = 2 * error / (jacobian + std::sqrt(root));
  double least_w = kInfinity, largest = 0;
  for (const ScreenPoint& p : points) {
    if (!(p.w > 0)) return kInfinity;
    least_w = std::min(least_w, p.w);
    const double ratio = map.w / p.w;
    const double x = map.x - p.x * ratio, y = map.y - p.y * ratio;
    largest = std::max(largest, x * x + y * y);
  }
  const double w = least_w - std::fabs(map.w) * sigma;
  if (!(w > 0)) return kInfinity;
  const double bound = sigma * std::sqrt(largest) / w * kRoundingSlack;
  return bound >= 0 ? bound : kInfinity;
}

// Least size of the determinant at the corners, 0 if its sign differs among them or from `sign`.
template <typename AnyCorner, std::size_t n>
double least_jacobian(const TextureMap& map, const std::array<AnyCorner, n>& corner, double sign) {
  double least = kInfinity;
  for (const AnyCorner& c : corner)
    least = std::min(least, std::copysign(1.0, sign) * map.jacobian(c.u, c.v));
  return std::max(least, 0.0);
}

struct Visible {
  VisiblePart part;
  // False: nothing is visible.
  bool of(const ScreenQuad& quad, const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    const unsigned at[3] = {quad.outcode(a), quad.outcode(b), quad.outcode(c)};
    if (at[0] & at[1] & at[2]) return false;
    clip_triangle(quad, a, b, c, at[0] | at[1] | at[2], part);
    return part.count > 0;
  }
};

double largest_product(const std::array<Corner, 3>& c) {
  const auto product = [](const Corner& p, const Corner& q) { return std::fabs((p.u - q.u) * (p.v - q.v)); };
  return std::max({product(c[0], c[1]), product(c[1], c[2]), product(c[2], c[0])});
}

// Bound over a part of a triangle whose own determinants (docs/design.md: det M) are `own`.
double part_bound(const ErrorModel& model, const std::array<double, kMaxMaps>& own,
                  const std::array<Corner, 3>& c, double limit_px, int depth) {
  Visible visible;
  if (!visible.of(model.screen, c[0].p, c[1].p, c[2].p)) return 0;
  const double error =
      std::max({std::fabs(c[0].e), std::fabs(c[1].e), std::fabs(c[2].e)}) + largest_product(c) / 4;
  double bound = 0;
  for (std::size_t i = 0; i < model.map_count; ++i) {
    const double jacobian = least_jacobian(model.map[i], c, own[i]);
    bound = std::max(bound, displacement(model.map[i], error, jacobian, visible.part.points()));
  }
  if (bound <= limit_px || depth == 0) return bound;

  // Halve the longest side in the parameter square.
  int longest = 0;
  double length = -1;
  for (int i = 0; i < 3; ++i) {
    const Corner &p = c[i], &q = c[(i + 1) % 3];
    const double l = std::max(std::fabs(p.u - q.u), std::fabs(p.v - q.v));
    if (l > length) length = l, longest = i;
  }
  const Corner &p = c[longest], &q = c[(longest + 1) % 3], &far = c[(longest + 2) % 3];
  const Corner middle{(p.u + q.u) / 2, (p.v + q.v) / 2, (p.e + q.e) / 2 - (p.u - q.u) * (p.v - q.v) / 4,
                      0.5 * (p.p + q.p)};
  const double first = part_bound(model, own, {p, middle, far}, limit_px, depth - 1);
  if (first > limit_px) return bound;
  const double second = part_bound(model, own, {middle, q, far}, limit_px, depth - 1);
  return second > limit_px ? bound : std::max(first, second);
}

}  // namespace

bool add_texture_maps(const Corners& position, std::span<const Corners> textures, ErrorModel& model) {
  model.map_count = 0;
  model.folded = false;
  for (const Corners& texture : textures.first(std::min(textures.size(), kMaxTextureSets))) {
    for (int i = 1; i < 4; ++i) {
      if (texture[i].w != texture[0].w) return false;
    }
    // A single set has been found warped by the caller.
    if (textures.size() > 1 && classify(position, {&texture, 1}) != Shape::kWarped) continue;
    const Bilinear s = component(texture, &Vec4::x), t = component(texture, &Vec4::y),
                   r = component(texture, &Vec4::z);
    if (!varies(r)) {
      add_map(model, s, t);
    } else {
      if (varies(s) && varies(t)) add_map(model, s, t);
      if (varies(t)) add_map(model, t, r);
      if (varies(s) || !varies(t)) add_map(model, s, r);
    }
  }
  return true;
}

MeshPoint mesh_point(const ErrorModel& model, double u, double v) { return {u, v, model.screen.at(u, v)}; }

double triangle_bound(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c,
                      double limit_px, int depth) {
  const double u1 = b.u - a.u, v1 = b.v - a.v, u2 = c.u - a.u, v2 = c.v - a.v;
  const double area = u1 * v2 - u2 * v1;
  if (area == 0) return 0;  // draws nothing
  // Gradient (L_u, L_v) of the linear interpolant of uv.
  const double f1 = b.u * b.v - a.u * a.v, f2 = c.u * c.v - a.u * a.v;
  const double gradient_u = (f1 * v2 - f2 * v1) / area, gradient_v = (u1 * f2 - u2 * f1) / area;
  std::array<double, kMaxMaps> own;
  for (std::size_t i = 0; i < model.map_count; ++i) own[i] = model.map[i].jacobian(gradient_v, gradient_u);
  return part_bound(model, own,
                    {Corner{a.u, a.v, 0, a.p}, Corner{b.u, b.v, 0, b.p}, Corner{c.u, c.v, 0, c.p}}, limit_px,
                    depth);
}

double cell_bound(const ErrorModel& model, const std::array<MeshPoint, 4>& corner, double limit_px) {
  unsigned all = ~0u, any = 0;
  for (const MeshPoint& c : corner) {
    const unsigned at = model.screen.outcode(c.p);
    all &= at;
    any |= at;
  }
  if (all) return 0;
  const double error = (corner[1].u - corner[0].u) * (corner[3].v - corner[0].v) / 16;
  if (!any) {
    // The four triangles together: their own determinants are those of edge midpoints, within the corners'
    // range.
    const ScreenPoint points[4] = {corner[0].p, corner[1].p, corner[2].p, corner[3].p};
    double bound = 0;
    for (const TextureMap& map : model.maps()) {
      const double jacobian = least_jacobian(map, corner, map.jacobian(corner[0].u, corner[0].v));
      bound = std::max(bound, displacement(map, error, jacobian, points));
    }
    if (bound <= limit_px) return bound;
  }
  const MeshPoint centre{(corner[0].u + corner[1].u) / 2, (corner[0].v + corner[3].v) / 2,
                         0.25 * (corner[0].p + corner[1].p + corner[2].p + corner[3].p)};
  double bound = 0;
  for (int i = 0; i < 4; ++i) {
    bound = std::max(bound, triangle_bound(model, corner[i], corner[(i + 1) % 4], centre, limit_px, 2));
  }
  return bound;
}

}  // namespace truequad::kernel
