// Snapping and set-up rounding: docs/design.md "Rasterisers".
#include "rasteriser.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace truequad::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Roundings that count for one product of set-up. Of the three to four that enter, each at most one unit, millions
// of random triangles show no more than 0.9 units together.
constexpr double kSetupUnits = 0.75;
// The same for the evaluation of one plane a + b x + c y at a pixel.
constexpr double kEvaluationUnits = 2;
// Roundings of a window coordinate on its way from the vertex.
constexpr double kPositionUnits = 4;
// Roundings of a clip coordinate on its way from the vertex, in units of the magnitudes that are summed up in it. Of the
// five to eight that enter, hundreds of quads show no more than 0.8 together.
constexpr double kVertexUnits = 1.25;
// Farther than any screen is large; what is farther off is only said to be.
constexpr double kFarthestPx = 1e9;
// Rows of pixels of a triangle that is looked at one by one.
constexpr double kMostRows = 4096;

}  // namespace

Rasteriser make_rasteriser(const View& view) {
  const auto part = [](double value, double most) { return value > 0 ? std::min(value, most) : 0.0; };
  return {part(view.snap_px, 1),
          part(view.setup_rounding, 0x1p-8),
          view.viewport.x + view.viewport.width / 2,
          view.viewport.y + view.viewport.height / 2,
          std::fabs(view.viewport.x) + view.viewport.width, std::fabs(view.viewport.y) + view.viewport.height};
}

double Rasteriser::step_px() const {
  return snap_px / 2 + kPositionUnits * rounding * std::max(reach_x_px, reach_y_px);
}

double vertex_rounding_px(const Rasteriser& rasteriser, const Corners& position, const View& view, const ScreenQuad& quad) {
  if (rasteriser.exact()) return 0;
  // Of a corner, by which factor of 1 / w it may be moved. Between the corners it is no more than their interpolant.
  double moved[4];
  const std::array<double, 16>& m = view.clip_from_object;
  for (int i = 0; i < 4; ++i) {
    const Vec4& p = position[i];
    const auto size = [&](int r) {
      return std::fabs(m[r] * p.x) + std::fabs(m[4 + r] * p.y) + std::fabs(m[8 + r] * p.z) + std::fabs(m[12 + r] * p.w);
    };
    // A point of the viewport is at most half its size from the centre.
    const double w = size(3);
    moved[i] = kVertexUnits * rasteriser.rounding *
               glm::length(glm::dvec2(quad.half_width * (size(0) + w), quad.half_height * (size(1) + w)));
  }
  double largest = 0;
  for (int last = 0; last < 4; ++last) {
    const int index[3] = {(last + 1) % 4, (last + 2) % 4, (last + 3) % 4};
    const std::array<ScreenPoint, 3> c{quad.corner[index[0]], quad.corner[index[1]], quad.corner[index[2]]};
    const unsigned outside[3] = {quad.outcode(c[0]), quad.outcode(c[1]), quad.outcode(c[2])};
    if (outside[0] & outside[1] & outside[2]) continue;
    VisiblePart part;
    clip_triangle(quad, c[0], c[1], c[2], outside[0] | outside[1] | outside[2], part);
    const BarycentricWeights weights(c);
    for (const ScreenPoint& p : part.points()) {
      const glm::dvec3 b = weights.at(p);
      double sum = 0;
      // Weights of a triangle without area are not finite.
      for (int i = 0; i < 3; ++i) sum += (b[i] < 1 ? std::max(b[i], 0.0) : 1) * moved[index[i]];
      if (p.w > 0) largest = std::max(largest, sum / p.w);
    }
  }
  return std::min(largest, kFarthestPx);
}

void SnapMargin::include(const SnapMargin& other) {
  error = std::max(error, other.error);
  u = std::max(u, other.u);
  v = std::max(v, other.v);
  w = std::max(w, other.w);
}

namespace {

// At one corner of what is visible: the gradient of the interpolation error, and the steps of the parameters for both
// diagonals of the grid's square, but for the factor of w.
struct Steps {
  double error_u, error_v, du[2], dv[2];
};

// ratio: the largest part of w that a step may take from it.
template <std::size_t extent>
SnapMargin margin_of(std::span<const Steps, extent> at, double ratio) {
  if (!(ratio < 1)) return {kInfinity, kInfinity, kInfinity, kInfinity};
  SnapMargin margin;
  margin.w = 1 + ratio;
  const double grow = 1 / (1 - ratio);
  for (const Steps& from : at) {
    for (int d = 0; d < 2; ++d) {
      const double du = from.du[d] * grow, dv = from.dv[d] * grow;
      margin.u = std::max(margin.u, std::fabs(du));
      margin.v = std::max(margin.v, std::fabs(dv));
      for (const Steps& to : at) {
        const double grown = std::fabs(to.error_u * du + to.error_v * dv) + std::fabs(du * dv);
        if (!(grown <= margin.error)) margin.error = grown;
      }
    }
  }
  return margin;
}

}  // namespace

SnapMargin snap_margin(const Rasteriser& rasteriser, const TriangleCorners& corner, const WindowTriangle& window,
                       double gradient_u, double gradient_v) {
  const double step = rasteriser.step_px() / window.area;
  const MeshPoint& origin = *corner[0];
  double ratio = 0;
  std::array<Steps, 3> at;
  for (int k = 0; k < 3; ++k) at[k].error_u = corner[k]->v - gradient_u, at[k].error_v = corner[k]->u - gradient_v;
  for (int d = 0; d < 2; ++d) {
    // Steps of the weights' sum and of their means of the parameters, at unit w.
    double sum = 0, of_u = 0, of_v = 0;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2& side = window.side[i];
      const double weight = (d == 0 ? side.x - side.y : -side.x - side.y) * (step * corner[i]->q);
      sum += weight;
      of_u += weight * (corner[i]->u - origin.u);
      of_v += weight * (corner[i]->v - origin.v);
    }
    for (int k = 0; k < 3; ++k) {
      const double w = corner[k]->p.w;
      at[k].du[d] = w * (of_u - (corner[k]->u - origin.u) * sum);
      at[k].dv[d] = w * (of_v - (corner[k]->v - origin.v) * sum);
      const double part = std::fabs(w * sum);
      if (!(part <= ratio)) ratio = part;
    }
  }
  return margin_of(std::span<const Steps, 3>(at), ratio);
}

SnapMargin clipped_snap_margin(const Rasteriser& rasteriser, const TriangleCorners& corner,
                               double gradient_u, double gradient_v, std::span<const ScreenPoint> visible) {
  const BarycentricWeights weights({corner[0]->p, corner[1]->p, corner[2]->p});
  const double step = rasteriser.step_px();
  const glm::dvec3 diagonals[2] = {weights.step(step, step), weights.step(step, -step)};
  std::array<Steps, 9> at;
  const std::size_t count = std::min(visible.size(), at.size());
  double ratio = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 b = weights.at(visible[k]);
    const double u = b[0] * corner[0]->u + b[1] * corner[1]->u + b[2] * corner[2]->u,
                 v = b[0] * corner[0]->v + b[1] * corner[1]->v + b[2] * corner[2]->v;
    at[k] = {v - gradient_u, u - gradient_v, {}, {}};
    for (int d = 0; d < 2; ++d) {
      const glm::dvec3 n = visible[k].w * diagonals[d];
      for (int i = 0; i < 3; ++i) {
        at[k].du[d] += n[i] * (corner[i]->u - u);
        at[k].dv[d] += n[i] * (corner[i]->v - v);
      }
      const double part = std::fabs(n[0] + n[1] + n[2]);
      if (!(part <= ratio)) ratio = part;
    }
  }
  return margin_of(std::span<const Steps>(at.data(), count), ratio);
}

bool misses_pixels(const Rasteriser& rasteriser, std::span<const ScreenPoint> polygon) {
  // The vertices, so that centres of pixels are whole numbers.
  std::array<glm::dvec2, 9> at;
  const std::size_t count = std::min(polygon.size(), at.size());
  glm::dvec2 least(kInfinity), most(-kInfinity);
  for (std::size_t i = 0; i < count; ++i) {
    const ScreenPoint& p = polygon[i];
    if (!(p.w > 0)) return false;
    at[i] = {p.x / p.w + rasteriser.centre_x_px - 0.5, p.y / p.w + rasteriser.centre_y_px - 0.5};
    least = glm::min(least, at[i]);
    most = glm::max(most, at[i]);
  }
  // Along the shorter extent: rows of a high polygon are as good as columns.
  if (most.x - least.x < most.y - least.y) {
    for (std::size_t i = 0; i < count; ++i) std::swap(at[i].x, at[i].y);
    std::swap(least.x, least.y);
    std::swap(most.x, most.y);
  }
  const double low = least.y, high = most.y;
  const double step = rasteriser.step_px();
  if (!(high - low < kMostRows)) return false;
  for (double row = std::ceil(low - step); row <= high + step; ++row) {
    // The polygon between row - step and row + step.
    double left = kInfinity, right = -kInfinity;
    for (std::size_t i = 0; i < count; ++i) {
      glm::dvec2 p = at[i], q = at[(i + 1) % count];
      if (p.y > q.y) std::swap(p, q);
      if (q.y < row - step || p.y > row + step) continue;
      const auto x_at = [&](double y) { return p.y < q.y ? p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)) : p.x; };
      const double first = p.y < row - step ? x_at(row - step) : p.x;
      const double second = q.y > row + step ? x_at(row + step) : q.x;
      left = std::min({left, first, second});
      right = std::max({right, first, second});
    }
    if (std::ceil(left - step) <= right + step) return false;
  }
  return true;
}

std::array<double, 3> setup_px(const Rasteriser& rasteriser, const std::array<SetupVertex, 3>& vertex,
                               const WindowTriangle& window, bool t_drawn) {
  if (rasteriser.exact()) return {};
  using glm::dvec2;
  const auto& side = window.side;
  if (window.area == 0) return {kInfinity, kInfinity, kInfinity};
  const double of_area = 1 / window.area;
  // Gradients of the three planes.
  const auto gradient = [&](double SetupVertex::*of) {
    dvec2 g{0, 0};
    for (int i = 0; i < 3; ++i) g += (vertex[i].*of * of_area) * dvec2(-side[i].y, side[i].x);
    return g;
  };
  const dvec2 of_s = gradient(&SetupVertex::s), of_t = gradient(&SetupVertex::t), of_q = gradient(&SetupVertex::q);
  const glm::dvec3 v[3] = {{vertex[0].s, vertex[0].t, vertex[0].q},
                           {vertex[1].s, vertex[1].t, vertex[1].q},
                           {vertex[2].s, vertex[2].t, vertex[2].q}};
  const double det = std::fabs(glm::dot(v[0], glm::cross(v[1], v[2])) * of_area);
  // Pixels per unit of error of s and of t, and the largest s / q and t / q.
  double px_per_s = 0, px_per_t = 0, largest_s = 0, largest_t = 0, plane_s = 0, plane_t = 0, plane_q = 0;
  for (const SetupVertex& p : vertex) {
    const dvec2 along_t = p.q * of_t - p.t * of_q, along_s = p.q * of_s - p.s * of_q;
    px_per_s = std::max(px_per_s, glm::dot(along_t, along_t));
    px_per_t = std::max(px_per_t, glm::dot(along_s, along_s));
    const double w = 1 / p.q;
    largest_s = std::max(largest_s, std::fabs(p.s * w));
    largest_t = std::max(largest_t, std::fabs(p.t * w));
    plane_s = std::max(plane_s, std::fabs(p.s));
    plane_t = std::max(plane_t, std::fabs(p.t));
    plane_q = std::max(plane_q, std::fabs(p.q));
  }
  px_per_s = std::sqrt(px_per_s) / det;
  px_per_t = t_drawn ? std::sqrt(px_per_t) / det : 0;
  const double px_per_q = px_per_s * largest_s + px_per_t * largest_t;
  // An edge's differences of all three planes, each in pixels.
  double weight[3], length[3];
  for (int i = 0; i < 3; ++i) {
    const SetupVertex &from = vertex[(i + 1) % 3], &to = vertex[(i + 2) % 3];
    weight[i] = px_per_s * std::fabs(to.s - from.s) + px_per_t * std::fabs(to.t - from.t) +
                px_per_q * std::fabs(to.q - from.q);
    length[i] = glm::length(side[i]);
  }
  // At each vertex, whichever other one the planes are hung from.
  double thin[3] = {};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const dvec2 p{std::fabs(side[i].x), std::fabs(side[i].y)}, q{std::fabs(side[j].x), std::fabs(side[j].y)};
    const double scale = p.x * q.y + p.y * q.x, x = weight[i] * q.y + weight[j] * p.y,
                 y = weight[i] * q.x + weight[j] * p.x;
    // Sides i and j meet at vertex k; side i leads from it to vertex j, side j to vertex i.
    thin[j] = std::max(thin[j], scale * length[i] + x * p.x + y * p.y);
    thin[i] = std::max(thin[i], scale * length[j] + x * q.x + y * q.y);
  }
  const auto plane = [&](const dvec2& g, double largest) {
    return std::fabs(g.x) * rasteriser.reach_x_px + std::fabs(g.y) * rasteriser.reach_y_px + largest;
  };
  const double evaluation = px_per_s * plane(of_s, plane_s) + px_per_t * plane(of_t, plane_t) + px_per_q * plane(of_q, plane_q);
  std::array<double, 3> bound;
  for (int i = 0; i < 3; ++i) {
    const double px =
        rasteriser.rounding * (kSetupUnits * thin[i] * std::fabs(of_area) + kEvaluationUnits * evaluation);
    bound[i] = px >= 0 ? px : kInfinity;
  }
  return bound;
}

}  // namespace truequad::kernel
