// The bound of docs/design.md "Colours"; names as there.
#include "colour.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace truequad::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// For the rounding of this computation itself.
constexpr double kRoundingSlack = 1 + 1e-9;
// How far a vertex may be moved by snapping, in widths of the grid.
constexpr double kSnapReach = 0.70711;
// Units of rounding, as for texture coordinates (rasteriser.cc).
constexpr double kSetupUnits = 1;
constexpr double kEvaluationUnits = 2;

glm::dvec3 xyw(const ScreenPoint& p) { return {p.x, p.y, p.w}; }
glm::dvec3 on_screen(const ScreenPoint& p) { return {p.x / p.w, p.y / p.w, 1}; }
double size_xy(const glm::dvec3& x) { return std::fabs(x.x) + std::fabs(x.y); }

bool warped(const Corners& position, const ColourChannel& colour) {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = {colour[i], 0, 0, 1};
  return classify(position, {&corners, 1}) == Shape::kWarped;
}

// Of the determinant at (u, v), as seen from a point of the screen.
struct Determinant {
  double constant, of_u, of_v;
  Determinant(const ColourModel& model, const glm::dvec3& point)
      : constant(glm::dot(point, model.constant)), of_u(glm::dot(point, model.of_u)), of_v(glm::dot(point, model.of_v)) {}
  double at(const Param& a) const { return constant + of_u * a.u + of_v * a.v; }
};

bool folds(const ColourModel& model, const ScreenQuad& screen) {
  bool positive = false, negative = false;
  for (int i = 0; i < 4; ++i) {
    // Times w, so that corners behind the eye say what the visible part near them does.
    const double at = Determinant(model, xyw(screen.corner[i])).at({i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0});
    positive |= !(at < 0);
    negative |= !(at > 0);
  }
  return positive && negative;
}

}  // namespace

bool add_colours(const Corners& position, std::span<const ColourChannel> colours, const ScreenQuad& screen,
                 ColourModel& model) {
  const glm::dvec3 along_u = xyw(screen.along_u), along_v = xyw(screen.along_v), twist = xyw(screen.twist);
  model.constant = glm::cross(along_u, along_v);
  model.of_u = glm::cross(along_u, twist);
  model.of_v = glm::cross(twist, along_v);
  model.count = 0;
  for (const ColourChannel& c : colours.first(std::min(colours.size(), kMaxColourChannels))) {
    if (!warped(position, c)) continue;
    ColourModel::Channel& out = model.channel[model.count++];
    out.corner = c;
    out.along_u = c[1] - c[0];
    out.along_v = c[3] - c[0];
    out.twist = (c[0] - c[1]) + (c[2] - c[3]);
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    out.range = *high - *low;
    out.largest = std::max(std::fabs(*low), std::fabs(*high));
    out.error = out.twist * model.constant - out.along_u * model.of_v - out.along_v * model.of_u;
  }
  model.folded = model.count > 0 && folds(model, screen);
  return model.count > 0;
}

double colour_px(const ColourModel& model, const ScreenQuad& screen, const ColourPart& part) {
  // At each point of the visible hull: the part's least determinant and the factors of the error. Between the points all
  // bounds are no larger than at them.
  struct At {
    glm::dvec3 point;
    double sigma;
  };
  std::array<At, 9> at;
  const std::size_t count = std::min(part.visible.size(), at.size());
  double sign = 0, balance = 1, least_root = kInfinity, largest_w = 0, shift_u = 0, shift_v = 0;
  bool known = true;
  for (std::size_t i = 0; i < count && known; ++i) {
    const ScreenPoint& p = part.visible[i];
    known = p.w > 0;
    if (!known) break;
    at[i].point = on_screen(p);
    const Determinant j(model, at[i].point);
    const double j_u = std::fabs(j.of_u) + part.step_px * size_xy(model.of_u),
                 j_v = std::fabs(j.of_v) + part.step_px * size_xy(model.of_v);
    if (i == 0) {
      sign = std::copysign(1.0, j.at(part.own));
      // Any factor is right; this one makes the mean below that of equal numbers.
      balance = j_u > 0 && j_v > 0 ? std::sqrt(j_v / j_u) : 1;
    }
    double least = kInfinity, moved = 0;
    for (const Param& a : part.corner) {
      least = std::min(least, sign * j.at(a));
      moved = std::max(moved, size_xy(model.constant + a.u * model.of_u + a.v * model.of_v));
    }
    moved *= part.step_px;
    const double determinant = least - moved - j_u * part.margin.u - j_v * part.margin.v;
    const double mean = (j_u * balance + j_v / balance) / 2;
    const double root = determinant * determinant - 4 * part.error * mean * mean;
    known = determinant > 0 && root > 0 && sign * j.at(part.own) > moved;
    at[i].sigma = 2 * part.error / (determinant + std::sqrt(root));
    least_root = std::min(least_root, root);
    largest_w = std::max(largest_w, p.w);
    shift_u = std::max(shift_u, at[i].sigma * j_v);
    shift_v = std::max(shift_v, at[i].sigma * j_u);
  }
  largest_w = largest_w * part.margin.w + std::fabs(screen.twist.w) * part.error;

  double worst = 0;
  for (const ColourModel::Channel& c : model.channels()) {
    double steps = kInfinity;
    if (known) {
      steps = 0;
      double steepest = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& p = at[i].point;
        steps = std::max(steps, at[i].sigma * (std::fabs(glm::dot(p, c.error)) + part.step_px * size_xy(c.error)));
        // The colour's gradient on the screen, at the exact place, is this over the determinant.
        const auto seen = [&](const ScreenPoint& x) { return glm::dvec2(x.x - p.x * x.w, x.y - p.y * x.w); };
        const glm::dvec2 q_u = seen(screen.along_u), q_v = seen(screen.along_v), q_t = seen(screen.twist);
        const glm::dvec2 g = c.along_u * q_v - c.along_v * q_u, g_u = c.along_u * q_t - c.twist * q_u,
                         g_v = c.twist * q_v - c.along_v * q_t;
        double largest = 0;
        for (const Param& a : part.corner) largest = std::max(largest, glm::length(g + a.u * g_u + a.v * g_v));
        steepest = std::max(steepest, largest + shift_u * glm::length(g_u) + shift_v * glm::length(g_v));
      }
      const double moved_px = kSnapReach * model.snap_px + model.rounding_px;
      if (moved_px > 0) steps += moved_px * largest_w * steepest / std::sqrt(least_root);
    }
    worst = std::max(worst, steps <= c.range ? steps : c.range);
  }
  return worst * model.px_per_step * kRoundingSlack;
}

std::array<double, 3> colour_setup_px(const ColourModel& model, const Rasteriser& rasteriser,
                                      const std::array<MeshPoint, 3>& triangle, const VisiblePart& part, bool clipped) {
  if (rasteriser.exact()) return {};
  // The triangle that is set up, in weights of the corners.
  std::array<ScreenPoint, 3> vertex{triangle[0].p, triangle[1].p, triangle[2].p};
  std::array<glm::dvec3, 3> of_corners{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  if (clipped) {
    const BarycentricWeights weights(vertex);
    std::array<int, 3> largest;
    if (!largest_triangle(part.points(), largest)) return {};
    for (int i = 0; i < 3; ++i) {
      vertex[i] = part.point[largest[i]];
      of_corners[i] = weights.at(vertex[i]);
    }
  }
  glm::dvec2 place[3], side[3];  // side i from vertex i + 1 to vertex i + 2
  double q[3];                   // 1 / w
  for (int i = 0; i < 3; ++i) {
    q[i] = 1 / vertex[i].w;
    place[i] = {vertex[i].x * q[i], vertex[i].y * q[i]};
  }
  for (int i = 0; i < 3; ++i) side[i] = place[(i + 2) % 3] - place[(i + 1) % 3];
  const double area = side[0].x * side[1].y - side[0].y * side[1].x;  // twice the triangle's
  const double least_q = std::min({q[0], q[1], q[2]}), largest_q = std::max({q[0], q[1], q[2]});
  std::array<double, 3> worst{};
  for (const ColourModel::Channel& c : model.channels()) {
    glm::dvec3 at_corners;
    for (int i = 0; i < 3; ++i) {
      at_corners[i] = interpolate(c.corner[0], c.corner[1], c.corner[2], c.corner[3], triangle[i].u, triangle[i].v);
    }
    // The planes of colour / w and of 1 / w: an error of the second counts as many steps as the colour has.
    double value[3], weight[3];
    for (int i = 0; i < 3; ++i) value[i] = q[i] * glm::dot(of_corners[i], at_corners);
    glm::dvec2 of_value{0, 0}, of_q{0, 0};
    for (int i = 0; i < 3; ++i) {
      const int from = (i + 1) % 3, to = (i + 2) % 3;
      weight[i] = std::fabs(value[to] - value[from]) + c.largest * std::fabs(q[to] - q[from]);
      of_value += (value[i] / area) * glm::dvec2(-side[i].y, side[i].x);
      of_q += (q[i] / area) * glm::dvec2(-side[i].y, side[i].x);
    }
    const auto plane = [&](const glm::dvec2& g, double largest) {
      return std::fabs(g.x) * rasteriser.reach_x_px + std::fabs(g.y) * rasteriser.reach_y_px + largest;
    };
    const double evaluation = plane(of_value, c.largest * largest_q) + c.largest * plane(of_q, largest_q);
    for (int i = 0; i < 3; ++i) {
      // At vertex i, the planes hung from the other end of either side that meets there.
      double thin = 0;
      for (const int to : {(i + 1) % 3, (i + 2) % 3}) {
        const int other = 3 - i - to;
        const glm::dvec2 p = glm::abs(side[to]), s = glm::abs(side[other]);
        thin = std::max(thin, (p.x * s.y + p.y * s.x) * weight[to] + (weight[to] * s.y + weight[other] * p.y) * p.x +
                                  (weight[to] * s.x + weight[other] * p.x) * p.y);
      }
      const double steps =
          rasteriser.rounding * (kSetupUnits * thin / std::fabs(area) + kEvaluationUnits * evaluation) / least_q;
      worst[i] = std::max(worst[i], model.px_per_step * (steps <= c.range ? steps : c.range));
    }
  }
  return worst;
}

double colour_density(const ColourModel& model, const std::array<Param, 4>& corner, std::span<const ScreenPoint> visible,
                      double w_floor, double fold_floor) {
  double largest = 0;
  for (const ScreenPoint& p : visible) {
    const double w = std::max(p.w, w_floor);
    const glm::dvec3 point(p.x / w, p.y / w, 1);
    const Determinant j(model, point);
    double low = kInfinity, high = -kInfinity, most = 0;
    for (const Param& a : corner) {
      low = std::min(low, j.at(a));
      high = std::max(high, j.at(a));
    }
    for (const Param& a : {Param{0, 0}, Param{1, 0}, Param{1, 1}, Param{0, 1}}) most = std::max(most, std::fabs(j.at(a)));
    const double determinant = std::max({low, -high, fold_floor * most});
    for (const ColourModel::Channel& c : model.channels()) {
      const double error = std::fabs(glm::dot(point, c.error)) / determinant;
      if (std::isfinite(error)) largest = std::max(largest, error);
    }
  }
  return largest * model.px_per_step;
}

}  // namespace truequad::kernel
