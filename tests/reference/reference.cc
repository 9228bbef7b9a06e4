// Inverse bilinear map by its quadratic; homography from four points after Heckbert (1989), section 2.2.3.
#include "truequad_reference/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace truequad::reference {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

struct Bilinear {
  Real constant, of_u, of_v, twist;
  explicit Bilinear(const std::array<Real, 4>& f)
      : constant(f[0]), of_u(f[1] - f[0]), of_v(f[3] - f[0]), twist((f[0] - f[1]) + (f[2] - f[3])) {}
  Real at(Real u, Real v) const { return constant + of_u * u + of_v * v + twist * u * v; }
  Real size() const { return std::fabs(constant) + std::fabs(of_u) + std::fabs(of_v) + std::fabs(twist); }
};

std::vector<Real> roots(Real a, Real b, Real c) {
  const Real square = b * b - 4 * a * c;
  // A double root that rounding has made complex.
  const Real root = std::sqrt(std::max(square, Real(0)));
  if (square < -1e-15L * (b * b + std::fabs(4 * a * c))) return {};
  const Real q = -(b + std::copysign(root, b)) / 2;
  std::vector<Real> result;
  if (q != 0) result.push_back(c / q);
  if (a != 0) result.push_back(q / a);
  return result;
}

// Newton's iteration takes away what cancellation in the quadratic has left.
Solution polish(const Bilinear& f, const Bilinear& g, Solution x) {
  for (int i = 0; i < 4; ++i) {
    const Real fu = f.of_u + f.twist * x.v, fv = f.of_v + f.twist * x.u;
    const Real gu = g.of_u + g.twist * x.v, gv = g.of_v + g.twist * x.u;
    const Real det = fu * gv - fv * gu, f0 = f.at(x.u, x.v), g0 = g.at(x.u, x.v);
    if (det == 0) break;
    const Solution next{x.u - (f0 * gv - g0 * fv) / det, x.v - (fu * g0 - gu * f0) / det};
    if (!(std::fabs(next.u - x.u) + std::fabs(next.v - x.v) < 1e-3L)) break;
    x = next;
  }
  return x;
}

}  // namespace

std::vector<Solution> solve_bilinear(const std::array<Real, 4>& f_corner,
                                     const std::array<Real, 4>& g_corner) {
  const Bilinear f(f_corner), g(g_corner);
  std::vector<Solution> candidates;
  // f = (c + a u) + v (b + k u), the same for g: their determinant is a quadratic in u. Likewise in v.
  const auto collect = [&](bool swap) {
    const Real fa = swap ? f.of_v : f.of_u, fb = swap ? f.of_u : f.of_v;
    const Real ga = swap ? g.of_v : g.of_u, gb = swap ? g.of_u : g.of_v;
    const Real a = fa * g.twist - ga * f.twist;
    const Real b = f.constant * g.twist + fa * gb - g.constant * f.twist - ga * fb;
    const Real c = f.constant * gb - g.constant * fb;
    for (Real u : roots(a, b, c)) {
      const Real fd = fb + f.twist * u, gd = gb + g.twist * u;
      const Real fn = f.constant + fa * u, gn = g.constant + ga * u;
      const Real square = fd * fd + gd * gd;
      if (!(square > 0)) continue;
      const Real v = -(fn * fd + gn * gd) / square;
      candidates.push_back(polish(f, g, swap ? Solution{v, u} : Solution{u, v}));
    }
  };
  collect(false);
  collect(true);
  std::vector<Solution> result;
  for (const Solution& x : candidates) {
    const Real reach = 1 + std::fabs(x.u) + std::fabs(x.v) + std::fabs(x.u * x.v);
    if (!(std::fabs(f.at(x.u, x.v)) <= 1e-12L * f.size() * reach)) continue;
    if (!(std::fabs(g.at(x.u, x.v)) <= 1e-12L * g.size() * reach)) continue;
    const bool known = std::any_of(result.begin(), result.end(), [&](const Solution& y) {
      return std::fabs(x.u - y.u) + std::fabs(x.v - y.v) <= 1e-12L * reach;
    });
    if (!known) result.push_back(x);
  }
  return result;
}

std::array<ClipCorner, 4> clip_corners(const Corners& position, const View& view) {
  std::array<ClipCorner, 4> clip;
  for (std::size_t i = 0; i < 4; ++i) {
    const Real p[4] = {position[i].x, position[i].y, position[i].z, position[i].w};
    for (std::size_t row = 0; row < 4; ++row) {
      clip[i][row] = 0;
      for (std::size_t k = 0; k < 4; ++k) clip[i][row] += Real(view.clip_from_object[4 * k + row]) * p[k];
    }
  }
  return clip;
}

namespace {

std::array<Real, 4> clip_column(const std::array<ClipCorner, 4>& clip, std::size_t row) {
  return {clip[0][row], clip[1][row], clip[2][row], clip[3][row]};
}

ClipCorner clip_at(const std::array<ClipCorner, 4>& clip, Real u, Real v) {
  ClipCorner p;
  for (std::size_t row = 0; row < 4; ++row) p[row] = Bilinear(clip_column(clip, row)).at(u, v);
  return p;
}

Real half_width(const View& view) { return Real(view.viewport.width) / 2; }
Real half_height(const View& view) { return Real(view.viewport.height) / 2; }

bool on_quad(const Solution& x, Real slack) {
  return x.u >= -slack && x.u <= 1 + slack && x.v >= -slack && x.v <= 1 + slack;
}

}  // namespace

std::optional<Point> window_point(const std::array<ClipCorner, 4>& clip, const View& view, Real u, Real v) {
  const ClipCorner p = clip_at(clip, u, v);
  if (!(p[3] > 0)) return std::nullopt;
  return Point{view.viewport.x + half_width(view) * (1 + p[0] / p[3]),
               view.viewport.y + half_height(view) * (1 + p[1] / p[3])};
}

Real bilinear_displacement(const Corners& position, const Corners& texture, const View& view, Point drawn,
                           Real s, Real t, Real slack) {
  std::array<Real, 4> f, g;
  for (std::size_t i = 0; i < 4; ++i) {
    f[i] = texture[i].x / Real(texture[i].w) - s;
    g[i] = texture[i].y / Real(texture[i].w) - t;
  }
  const auto clip = clip_corners(position, view);
  Real nearest = kInfinity;
  for (const Solution& x : solve_bilinear(f, g)) {
    if (!on_quad(x, slack)) continue;
    if (const auto place = window_point(clip, view, x.u, x.v)) {
      nearest = std::min(nearest, std::hypot(place->x - drawn.x, place->y - drawn.y));
    }
  }
  return nearest;
}

Real bilinear_displacement_1d(const Corners& position, const Corners& texture, const View& view, Point drawn,
                              Real s) {
  std::array<Real, 4> corner;
  for (std::size_t i = 0; i < 4; ++i) corner[i] = texture[i].x / Real(texture[i].w) - s;
  const Bilinear f(corner);
  const auto clip = clip_corners(position, view);
  // The curve is a graph over u where |f_v| > 0 and over v where |f_u| > 0.
  const auto distance = [&](bool over_u, Real x) {
    constexpr Real kSlack = 1e-9L;
    const Real slope = over_u ? f.of_v + f.twist * x : f.of_u + f.twist * x;
    if (slope == 0) return kInfinity;
    const Real y = -(f.constant + (over_u ? f.of_u : f.of_v) * x) / slope;
    const Solution on = over_u ? Solution{x, y} : Solution{y, x};
    if (!on_quad(on, kSlack)) return kInfinity;
    const auto place = window_point(clip, view, on.u, on.v);
    return place ? std::hypot(place->x - drawn.x, place->y - drawn.y) : kInfinity;
  };
  Real nearest = kInfinity;
  for (bool over_u : {true, false}) {
    constexpr int kSamples = 500;
    Real best = kInfinity, at = 0;
    for (int i = 0; i <= kSamples; ++i) {
      const Real x = Real(i) / kSamples, d = distance(over_u, x);
      if (d < best) best = d, at = x;
    }
    if (best == kInfinity) continue;
    Real low = std::max(at - Real(1) / kSamples, Real(0)), high = std::min(at + Real(1) / kSamples, Real(1));
    for (int i = 0; i < 60; ++i) {
      const Real first = low + (high - low) / 3, second = high - (high - low) / 3;
      (distance(over_u, first) < distance(over_u, second) ? high : low) =
          distance(over_u, first) < distance(over_u, second) ? second : first;
    }
    nearest = std::min({nearest, best, distance(over_u, (low + high) / 2)});
  }
  return nearest;
}

std::optional<Seen> bilinear_at(const Corners& position, const Corners& texture, const View& view,
                                Point window, Real slack) {
  const auto clip = clip_corners(position, view);
  const Real x = (window.x - view.viewport.x) / half_width(view) - 1;
  const Real y = (window.y - view.viewport.y) / half_height(view) - 1;
  std::array<Real, 4> f, g;
  for (std::size_t i = 0; i < 4; ++i) {
    f[i] = clip[i][0] - x * clip[i][3];
    g[i] = clip[i][1] - y * clip[i][3];
  }
  std::optional<Seen> seen;
  for (const Solution& at : solve_bilinear(f, g)) {
    if (!on_quad(at, slack)) continue;
    const ClipCorner p = clip_at(clip, at.u, at.v);
    if (!(p[3] > 0) || std::fabs(p[2]) > p[3]) continue;
    const Real depth = p[2] / p[3];
    if (seen && !(depth < seen->depth)) continue;
    std::array<Real, 4> s, t;
    for (std::size_t i = 0; i < 4; ++i) {
      s[i] = texture[i].x / Real(texture[i].w);
      t[i] = texture[i].y / Real(texture[i].w);
    }
    seen = Seen{at.u, at.v, Bilinear(s).at(at.u, at.v), Bilinear(t).at(at.u, at.v), depth};
  }
  return seen;
}

namespace {

using Matrix = std::array<std::array<Real, 3>, 3>;  // [row][column]

Matrix adjugate(const Matrix& m) {
  Matrix a;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t r1 = (c + 1) % 3, r2 = (c + 2) % 3, c1 = (r + 1) % 3, c2 = (r + 2) % 3;
      a[r][c] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    }
  }
  return a;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

std::array<Real, 3> apply(const Matrix& m, const std::array<Real, 3>& x) {
  std::array<Real, 3> y{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) y[i] += m[i][k] * x[k];
  }
  return y;
}

// Columns A B C, scaled so that their sum is D: maps the unit triangle's projective frame to the four points.
Matrix frame(const std::array<std::array<Real, 3>, 4>& p) {
  Matrix m;
  for (std::size_t r = 0; r < 3; ++r) m[r] = {p[0][r], p[1][r], p[2][r]};
  const std::array<Real, 3> scale = apply(adjugate(m), p[3]);
  for (auto& row : m) {
    for (std::size_t c = 0; c < 3; ++c) row[c] *= scale[c];
  }
  return m;
}

}  // namespace

ProjectiveMap::ProjectiveMap(const Corners& position, const Corners& texture, const View& view) {
  const auto clip = clip_corners(position, view);
  std::array<std::array<Real, 3>, 4> window, texel;
  for (std::size_t i = 0; i < 4; ++i) {
    const Real w = clip[i][3];
    window[i] = {view.viewport.x * w + half_width(view) * (w + clip[i][0]),
                 view.viewport.y * w + half_height(view) * (w + clip[i][1]), w};
    texel[i] = {texture[i].x, texture[i].y, texture[i].w};
  }
  const Matrix from = frame(window), to = frame(texel);
  texel_from_window_ = product(to, adjugate(from));
  window_from_texel_ = product(from, adjugate(to));
  Real sum = 0;
  for (const auto& row : texel_from_window_) {
    for (Real x : row) sum += std::fabs(x);
  }
  valid_ = sum > 0 && std::isfinite(sum);
}

Point ProjectiveMap::texel_at(Point window) const {
  const auto t = apply(texel_from_window_, {window.x, window.y, 1});
  return {t[0] / t[2], t[1] / t[2]};
}

Real ProjectiveMap::displacement(Point drawn, Real s, Real t) const {
  const auto p = apply(window_from_texel_, {s, t, 1});
  return std::hypot(p[0] / p[2] - drawn.x, p[1] / p[2] - drawn.y);
}

}  // namespace truequad::reference
