// Density fit and cutting; derived in docs/design.md "Grid lines".
#include "lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace truequad::kernel {
namespace {

constexpr int kSteps = Density::kMaxSteps;
// A quad whose local error differs by less than this over the corners gets even lines.
constexpr double kEven = 1.05;
// So does one that takes no more cells than this if all are as small as the smallest, and half as many steps are enough for
// one that takes no more than that.
constexpr double kFewCells = 1, kSomeCells = 16;
// Where a texture map folds its determinant is taken as at least this part of its largest size: lines may not
// pile up at a place that no line can help.
constexpr double kFoldFloor = 1.0 / 32;

struct Sample {
  std::array<std::array<double, kSteps>, kSteps> at;  // [v step][u step]
};

// Largest displacement per unit of interpolation error at the given points.
double local_error(const TextureMap& map, double jacobian, std::span<const ScreenPoint> points,
                   double w_floor) {
  double largest = 0;
  for (const ScreenPoint& p : points) {
    const double w = std::max(p.w, w_floor);
    const double ratio = map.w / w;
    const double x = (map.x - p.x * ratio) / w, y = (map.y - p.y * ratio) / w;
    largest = std::max(largest, x * x + y * y);
  }
  const double error = std::sqrt(largest) / jacobian;
  return std::isfinite(error) ? error : 0;
}

class Sampler {
 public:
  explicit Sampler(const ErrorModel& model) : model_(model) {
    double largest_w = 0;
    for (const ScreenPoint& p : model.screen.corner) largest_w = std::max(largest_w, std::fabs(p.w));
    w_floor_ = std::max(largest_w * 1e-4, std::numeric_limits<double>::min());
    for (std::size_t i = 0; i < model.map_count; ++i) {
      const TextureMap& map = model.map[i];
      floor_[i] = kFoldFloor * std::max({std::fabs(map.constant), std::fabs(map.jacobian(1, 0)),
                                         std::fabs(map.jacobian(1, 1)), std::fabs(map.jacobian(0, 1))});
    }
  }

  // Over the visible part of a rectangle of the parameter square.
  double cell(double u0, double u1, double v0, double v1) const {
    const ScreenQuad& quad = model_.screen;
    const ScreenPoint p[4] = {quad.at(u0, v0), quad.at(u1, v0), quad.at(u1, v1), quad.at(u0, v1)};
    unsigned all = ~0u, any = 0;
    for (const ScreenPoint& q : p) {
      const unsigned code = quad.outcode(q);
      all &= code;
      any |= code;
    }
    if (all) return 0;
    if (!any) return over(u0, u1, v0, v1, p);
    VisiblePart half;
    clip_triangle(quad, p[0], p[1], p[2], any, half);
    const double first = over(u0, u1, v0, v1, half.points());
    clip_triangle(quad, p[0], p[2], p[3], any, half);
    return std::max(first, over(u0, u1, v0, v1, half.points()));
  }

 private:
  double over(double u0, double u1, double v0, double v1, std::span<const ScreenPoint> points) const {
    double largest = 0;
    for (std::size_t i = 0; i < model_.map_count; ++i) {
      const TextureMap& map = model_.map[i];
      const double at[4] = {map.jacobian(u0, v0), map.jacobian(u1, v0), map.jacobian(u1, v1),
                            map.jacobian(u0, v1)};
      const double low = *std::min_element(at, at + 4), high = *std::max_element(at, at + 4);
      const double jacobian = std::max({low, -high, floor_[i]});
      if (jacobian > 0) largest = std::max(largest, local_error(map, jacobian, points, w_floor_));
    }
    if (model_.colours.count == 0) return largest;
    const std::array<Param, 4> corner{Param{u0, v0}, Param{u1, v0}, Param{u1, v1}, Param{u0, v1}};
    return std::max(largest, colour_density(model_.colours, corner, points, w_floor_, kFoldFloor));
  }

  const ErrorModel& model_;
  double w_floor_;
  std::array<double, kMaxMaps> floor_;
};

void even(Density& density, int steps) {
  density.steps = steps;
  for (int i = 0; i <= steps; ++i) density.edge[i] = double(i) / steps;
}

// Least heights with u.height[i] v.height[j] >= g: alternating maxima from the rows' means.
void fit(const Sample& g, Density& u, Density& v) {
  for (int j = 0; j < v.steps; ++j) {
    double mean = 0;
    for (int i = 0; i < u.steps; ++i) mean += g.at[j][i] * (u.edge[i + 1] - u.edge[i]);
    v.height[j] = mean;
  }
  for (int i = 0; i < u.steps; ++i) {
    u.height[i] = 0;
    for (int j = 0; j < v.steps; ++j) {
      if (v.height[j] > 0) u.height[i] = std::max(u.height[i], g.at[j][i] / v.height[j]);
    }
  }
  for (int j = 0; j < v.steps; ++j) {
    v.height[j] = 0;
    for (int i = 0; i < u.steps; ++i) {
      if (u.height[i] > 0) v.height[j] = std::max(v.height[j], g.at[j][i] / u.height[i]);
    }
  }
}

// New steps such that each is worth the same; true if the old ones were far from that.
bool refine(Density& density) {
  GridLines lines;
  const int most = density.steps;
  const double share = share_for(density, 0, 1, most);
  const int cells = share > 0 ? cut(density, 0, 1, share, &lines) : 0;
  if (cells < 2 || cells > most) return false;
  density.steps = cells;
  std::copy_n(lines.at.begin(), cells + 1, density.edge.begin());
  return true;
}

}  // namespace

double Density::integral(double from, double to) const {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    sum += height[i] * std::max(0.0, std::min(to, edge[i + 1]) - std::max(from, edge[i]));
  }
  return sum;
}

void fit_densities(const ErrorModel& model, double error_px, Densities& densities) {
  const Sampler sampler(model);
  Density &u = densities.u, &v = densities.v;
  const double whole = sampler.cell(0, 1, 0, 1);
  const double point[4] = {sampler.cell(0, 0, 0, 0), sampler.cell(1, 1, 0, 0), sampler.cell(1, 1, 1, 1),
                           sampler.cell(0, 0, 1, 1)};
  const double cells = whole / (16 * error_px);
  if (cells <= kFewCells || whole <= kEven * *std::min_element(point, point + 4)) {
    even(u, 1);
    even(v, 1);
    u.height[0] = whole;
    v.height[0] = 1;
    return;
  }
  const int steps = cells <= kSomeCells ? kSteps / 2 : kSteps;
  even(u, steps);
  even(v, steps);
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0;; ++round) {
    Sample g;
    for (int j = 0; j < v.steps; ++j) {
      for (int i = 0; i < u.steps; ++i)
        g.at[j][i] = sampler.cell(u.edge[i], u.edge[i + 1], v.edge[j], v.edge[j + 1]);
    }
    fit(g, u, v);
    const double work = u.integral(0, 1) * v.integral(0, 1);
    if (round == 5 || !(work < 0.85 * before)) return;
    before = work;
    Densities next = densities;
    const bool u_refined = refine(next.u), v_refined = refine(next.v);
    if (!u_refined && !v_refined) return;
    densities = next;
  }
}

namespace {

constexpr double kEnd = 1e-12;

// cut(); returns with the number of cells the part of the last one's share that was used.
struct Cut {
  int cells;
  double used;
};
Cut cut_cells(const Density& density, double from, double to, double share, GridLines* lines) {
  share *= 1 + 1e-9;
  int cells = 0;
  double start = from, used = 1;
  if (lines) lines->at[0] = from;
  int step = 0;
  while (to - start > kEnd && cells < int(kMaxLines) - 1) {
    while (step + 1 < density.steps && density.edge[step + 1] <= start) ++step;
    double largest = density.height[step], end = to;
    // A cell ends where the largest height so far has used up the share, or where a higher step would.
    for (int i = step; i < density.steps && density.edge[i] < to; ++i) {
      const double next = std::max(largest, density.height[i]);
      if (i > step && next * (density.edge[i] - start) > share) {
        end = density.edge[i];
        break;
      }
      largest = next;
      const double reach = std::min(density.edge[i + 1], to);
      if (largest * (reach - start) > share) {
        end = start + share / largest;
        break;
      }
    }
    if (!(end > start)) end = to;
    if (to - end <= kEnd) end = to;
    ++cells;
    if (lines) lines->at[cells] = end;
    if (end == to) used = std::min(largest * (to - start) / share, 1.0);
    start = end;
  }
  if (to - start > kEnd) return {int(kMaxLines), 1};
  if (cells == 0) {
    cells = 1;
    if (lines) lines->at[1] = to;
  }
  if (lines) lines->count = std::size_t(cells) + 1;
  return {cells, used};
}

}  // namespace

int cut(const Density& density, double from, double to, double share, GridLines* lines) {
  return cut_cells(density, from, to, share, lines).cells;
}

double share_for(const Density& density, double from, double to, int cells) {
  // No more than nearly the least is asked for.
  constexpr double kStep = 1.002;
  const double least = density.integral(from, to) / cells;
  double share = least;
  for (int i = 0; i < 12; ++i) {
    const Cut made = cut_cells(density, from, to, share, nullptr);
    if (made.cells <= cells) return share;
    // As if all of the density shared the excess.
    share *= made.cells >= int(kMaxLines) ? 2 : std::max((made.cells - 1 + made.used) / cells, kStep);
  }
  while (cut(density, from, to, share, nullptr) > cells && share < 1e3 * least * cells) share *= 2;
  return share;
}

}  // namespace truequad::kernel
