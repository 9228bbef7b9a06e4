// From error bounds to the smallest mesh that keeps the tolerance: docs/design.md "Choosing a mesh".
#include <algorithm>
#include <cmath>
#include <limits>

#include "lines.h"
#include "mesh.h"
#include "planners.h"

namespace truequad::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Deepest halving of one long triangle that looks for a tighter bound.
constexpr int kDepth = 6;
// The same to find how far beyond the limit a triangle is.
constexpr int kFarDepth = 3;
// As part of the limit: worth that search.
constexpr double kNear = 1.1;
// Largest part of the quad that lies between one side and the block.
constexpr double kMaxInset = 0.3;
// Smallest: an inserted vertex must stay off the edge when its position is rounded to single precision.
constexpr double kMinInset = 0x1p-20;
// Smallest mesh with a block that touches no side.
constexpr int kSmallestBlock = 12;
// Triangles spent on a quad whose texture map folds: no number of them gives a bound there.
constexpr int kFoldedTriangles = 512;
constexpr int kMaxRounds = 24;
// Triangles that are verified in all rounds together before the best mesh so far is taken.
constexpr int kMostWork = 8192;
// Lines and insets are made for a little less than what verification asks, or its rounding slack would refuse
// them.
constexpr double kMargin = 1 - 1e-6;
// The same for what a rasteriser usually adds.
constexpr double kRasteriserMargin = 0.99;
// Part of the aim that corrected insets are made for.
constexpr double kGoal = 0.99;
// Rounds that correct insets alone.
constexpr int kMaxSideRounds = 8;

double two_triangles(const ErrorModel& model, const std::array<MeshPoint, 4>& c, double limit_px) {
  double bound = 0;
  for (int i = 0; i < 4 && bound <= limit_px; ++i) {
    // The halves at diagonal AC, then those at BD: drivers differ.
    const int first = i / 2, second = i % 2;
    const int a = first, b = first + 1 + second, d = (first + 2 + second) % 4;
    bound = std::max(bound, triangle_bound(model, c[a], c[b], c[d], limit_px, kDepth));
  }
  return bound;
}

double fan(const ErrorModel& model, const std::array<MeshPoint, 4>& c, double limit_px, int depth) {
  const MeshPoint centre{0.5, 0.5, 0.25 * (c[0].p + c[1].p + c[2].p + c[3].p)};
  double bound = 0;
  for (int i = 0; i < 4 && bound <= limit_px; ++i) {
    bound = std::max(bound, triangle_bound(model, c[i], c[(i + 1) % 4], centre, limit_px, depth));
  }
  return bound;
}

// Widths between the four sides AB, BC, CD, DA and the block.
using Insets = std::array<double, 4>;

// Largest inset of the side at the start (`at_start`) or end of `across` with which the triangles along it
// keep `error_px`. On the segment from a corner to the apex above `middle` the interpolation error at u is at
// most inset u (1 - u / middle).
double inset_for(const Density& along, const Density& across, bool at_start, double middle, double error_px) {
  double worst = 0;
  for (int i = 0; i < along.steps; ++i) {
    const auto profile = [&](double from, double to, double span) {
      if (!(span > 0)) return 0.0;
      const double low = std::min(from, span), high = std::min(to, span),
                   peak = std::clamp(span / 2, low, high);
      return peak * (1 - peak / span);
    };
    const double left = profile(along.edge[i], along.edge[i + 1], middle);
    const double right = profile(1 - along.edge[i + 1], 1 - along.edge[i], 1 - middle);
    worst = std::max(worst, along.height[i] * std::max(left, right));
  }
  double inset = 0, highest = 0;
  for (int k = 0; k < across.steps; ++k) {
    const int j = at_start ? k : across.steps - 1 - k;
    const double far = at_start ? across.edge[j + 1] : 1 - across.edge[j];
    highest = std::max(highest, across.height[j]);
    const double allowed = worst * highest > 0 ? error_px / (worst * highest) : kInfinity;
    if (allowed <= far) return std::min(std::max(inset, allowed), kMaxInset);
    inset = far;
  }
  return kMaxInset;
}

// The parameter that halves the density's integral.
double median(const Density& density) {
  double rest = density.integral(0, 1) / 2;
  for (int i = 0; i < density.steps; ++i) {
    const double step = density.height[i] * (density.edge[i + 1] - density.edge[i]);
    if (step >= rest && step > 0) return density.edge[i] + rest / density.height[i];
    rest -= step;
  }
  return 0.5;
}

int block_triangles(int n, int m, const std::array<bool, 4>& flush) { return Block(n, m, flush).triangles(); }

// Chooses numbers of cells and writes the lines for error_px. Returns the number of triangles, which may
// exceed `cap`; then the lines are not valid.
int choose_lines(const Densities& densities, const Insets& inset, const std::array<bool, 4>& flush,
                 double error_px, int cap, Plan& plan) {
  const double u0 = inset[3], u1 = 1 - inset[1], v0 = inset[0], v1 = 1 - inset[2];
  const Density &du = densities.u, &dv = densities.v;
  const double product = 16 * error_px;
  const double cells = du.integral(u0, u1) * dv.integral(v0, v1) / product;
  if (!(4 * cells <= cap)) return cells < 1e8 ? int(4 * cells) + 1 : std::numeric_limits<int>::max();
  const int start = std::max(1, int(std::sqrt(cells)));
  int best = std::numeric_limits<int>::max(), best_n = 0, best_m = 0;
  const auto consider = [&](int n) {
    const double share = share_for(du, u0, u1, n);
    const int m = cut(dv, v0, v1, share > 0 ? product / share : kInfinity, nullptr);
    if (m >= int(kMaxLines)) return false;
    const int triangles = block_triangles(n, m, flush);
    if (triangles >= best) return false;
    best = triangles, best_n = n, best_m = m;
    return true;
  };
  // The count has one broad minimum; two steps without gain end the walk on either side.
  for (int direction : {1, -1}) {
    int n = direction > 0 ? start : start - 1;
    for (int misses = 0; misses < 2 && n >= 1 && n < int(kMaxLines) - 1; n += direction) {
      misses = consider(n) ? 0 : misses + 1;
    }
  }
  if (best_n == 0) return std::numeric_limits<int>::max();
  if (best > cap) return best;
  cut(du, u0, u1, share_for(du, u0, u1, best_n), &plan.u);
  cut(dv, v0, v1, share_for(dv, v0, v1, best_m), &plan.v);
  // Cutting may need fewer cells than asked for, and ends must be exact where they are a side of the quad.
  return block_triangles(int(plan.u.count) - 1, int(plan.v.count) - 1, flush);
}

struct Verdict {
  double block = 0, side[4] = {};
  double finite_block = 0;  // largest of those that are not infinite
  // Of the cells beyond the limit, what exact arithmetic would make of them.
  double exact_block = 0;
  double side_exact[4] = {};  // the same of the worst triangle of each side
  double worst() const { return std::max({block, side[0], side[1], side[2], side[3]}); }
};

// exact: the same model without a rasteriser.
void verify_sides(const ErrorModel& model, const ErrorModel& exact, const Plan& plan, double limit_px,
                  Verdict& verdict) {
  const Block block(plan);
  const auto point = [&](Node node) {
    const Param at = param(plan, block, node);
    return mesh_point(model, at.u, at.v);
  };
  for (int side = 0; side < 4; ++side) {
    if (block.flush[side]) continue;
    for_each_border_triangle(block, side, [&](Node a, Node b, Node c) {
      const MeshPoint p = point(a), q = point(b), r = point(c);
      double bound = triangle_bound(model, p, q, r, limit_px, kDepth), of_map = bound;
      if (!(bound > verdict.side[side])) return;
      if (bound > limit_px) {
        // Beyond the limit triangle_bound() has not looked for how far.
        const int look = bound > kNear * limit_px ? kFarDepth : 0;
        if (look > 0) bound = triangle_bound(model, p, q, r, kTightest, look);
        of_map = triangle_bound(exact, p, q, r, kTightest, look);
        if (!(bound > verdict.side[side])) return;
      }
      verdict.side[side] = bound;
      verdict.side_exact[side] = of_map;
    });
  }
}

void verify_block(const ErrorModel& model, const ErrorModel& exact, const Plan& plan, double limit_px,
                  Verdict& verdict) {
  const Block block(plan);
  const auto point = [&](Node node) {
    const Param at = param(plan, block, node);
    return mesh_point(model, at.u, at.v);
  };
  for (int j = 0; j < block.m; ++j) {
    std::array<MeshPoint, 2> left{point({0, j}), point({0, j + 1})};
    for (int i = 0; i < block.n; ++i) {
      const std::array<MeshPoint, 2> right{point({i + 1, j}), point({i + 1, j + 1})};
      const Param middle = centre(plan, i, j);
      const MeshPoint top = mesh_point(model, middle.u, middle.v);
      const std::array<MeshPoint, 4> corner{left[0], right[0], right[1], left[1]};
      const double bound = cell_bound(model, corner, top, limit_px);
      verdict.block = std::max(verdict.block, bound);
      if (bound < kInfinity) verdict.finite_block = std::max(verdict.finite_block, bound);
      if (bound > limit_px && !model.rasteriser.exact()) {
        verdict.exact_block = std::max(verdict.exact_block, cell_bound(exact, corner, top, limit_px));
      }
      left = right;
    }
  }
}

// Corrects the factors of insets whose sides are beyond the aim; false if none can be.
bool correct_insets(const Verdict& verdict, bool folded, double aim_px, Insets& factor) {
  bool changed = false;
  for (int side = 0; side < 4; ++side) {
    const double found_px = verdict.side[side];
    if (!(found_px > aim_px) || (folded && found_px == kInfinity)) continue;
    // The map's part of the error grows with the inset, the rasteriser's falls with it.
    const double map_px = verdict.side_exact[side], rest_px = found_px - map_px;
    const double goal_px = kGoal * aim_px, root = goal_px * goal_px - 4 * map_px * rest_px;
    double change;
    if (!(rest_px < kInfinity) || !(map_px < kInfinity) || rest_px < 0.01 * aim_px) {
      change = std::clamp(goal_px / found_px, 0.25, 0.95);
    } else if (root >= 0) {
      change = std::clamp((goal_px + std::sqrt(root)) / (2 * map_px), 0.25, 4.0);
    } else {
      // Out of reach for this shape, if the inset is already about the best.
      change = std::clamp(std::sqrt(rest_px / map_px), 0.25, 4.0);
      if (change > 0.9 && change < 1.1) continue;
    }
    factor[side] *= change;
    changed = true;
  }
  return changed;
}

void set_fan(Plan& plan, double bound) {
  for (GridLines* lines : {&plan.u, &plan.v}) {
    lines->at[0] = 0;
    lines->at[1] = 1;
    lines->count = 2;
  }
  plan.triangles = 4;
  plan.bound_px = bound;
}

// Looks for the smallest block that keeps the budget. Sets lines, triangles and bound_px; returns false if
// not even the smallest block fits under the cap.
bool plan_block(const ErrorModel& model, const Budget& budget, Plan& plan) {
  const bool folded = model.folded || model.colours.folded;
  const int cap = folded ? std::min(budget.max_triangles, kFoldedTriangles) : budget.max_triangles;
  if (cap < kSmallestBlock) return false;
  Densities densities;
  fit_densities(model, densities);

  const std::array<bool, 4>& flush = plan.collapsed_edge;
  double aim_px = budget.mesh_px;      // error that lines and insets are made for
  const double margin = model.rasteriser.exact() ? kMargin : kRasteriserMargin;
  double lines_px = margin * aim_px;   // the same for the lines alone, corrected by what verification found
  Insets shrink;                       // the same for insets, as a factor
  shrink.fill(margin);
  const double middle_u = median(densities.u), middle_v = median(densities.v);
  bool found = false, at_cap = false;
  int work = 0, side_rounds = 0;
  ErrorModel exact = model;
  exact.rasteriser = {};
  // The best mesh of those that do not keep the aim.
  double best_px = kInfinity, best_lines_px = 0;
  Insets best_inset{};
  for (int round = 0; round < kMaxRounds && work < kMostWork; ++round) {
    Insets inset;
    for (int side = 0; side < 4; ++side) {
      const bool along_u = side % 2 == 0;
      inset[side] =
          flush[side]
              ? 0
              : std::max(shrink[side] * inset_for(along_u ? densities.u : densities.v,
                                                  along_u ? densities.v : densities.u, side == 0 || side == 3,
                                                  along_u ? middle_u : middle_v, aim_px),
                         kMinInset);
    }
    const int triangles = choose_lines(densities, inset, flush, lines_px, cap, plan);
    if (triangles > cap) {
      // The cap allows no better than this: aim for what it does allow.
      const double factor = std::clamp(1.02 * triangles / cap, 1.05, 1e6);
      aim_px *= factor;
      lines_px *= factor;
      at_cap = true;
      found = false;
      continue;
    }
    found = true;
    plan.triangles = triangles;
    // Sides first: they are few triangles, and the insets that they ask for change the block.
    Verdict verdict;
    verify_sides(model, exact, plan, aim_px, verdict);
    const bool insets_changed = correct_insets(verdict, folded, aim_px, shrink);
    if (insets_changed && ++side_rounds <= kMaxSideRounds) continue;
    verify_block(model, exact, plan, aim_px, verdict);
    work += triangles;
    plan.bound_px = verdict.worst();
    if (plan.bound_px <= aim_px) break;
    if (plan.bound_px < best_px || best_lines_px == 0) {
      best_px = plan.bound_px;
      best_lines_px = lines_px;
      best_inset = inset;
    }
    const double block = folded ? verdict.finite_block : verdict.block;
    const bool correct_lines = block > aim_px && !at_cap;
    if (correct_lines) {
      // Slivers, which occur where the quad's picture folds, are no matter of size: other lines have others.
      const bool too_large = model.rasteriser.exact() || verdict.exact_block > aim_px;
      lines_px *= too_large ? std::clamp(0.99 * aim_px / block, 0.5, 0.98)
                            : std::clamp(0.998 * aim_px / block, 0.97, 0.998);
    }
    if (!correct_lines && !insets_changed) break;
  }
  if (best_lines_px > 0 && (!found || plan.bound_px > best_px)) {
    plan.triangles = choose_lines(densities, best_inset, flush, best_lines_px, cap, plan);
    plan.bound_px = best_px;
    found = true;
  }
  return found;
}

}  // namespace

double block_bound(const ErrorModel& model, const Budget& budget, const Plan& plan) {
  ErrorModel exact = model;
  exact.rasteriser = {};
  Verdict verdict;
  verify_sides(model, exact, plan, budget.mesh_px, verdict);
  verify_block(model, exact, plan, budget.mesh_px, verdict);
  return verdict.worst();
}

void plan_bilinear(const ErrorModel& model, const Budget& budget, Plan& plan) {
  const std::array<MeshPoint, 4> corner{mesh_point(model, 0, 0), mesh_point(model, 1, 0),
                                        mesh_point(model, 1, 1), mesh_point(model, 0, 1)};
  const double native = two_triangles(model, corner, budget.mesh_px);
  if (native <= budget.mesh_px) {
    plan.action = Action::kPass;
    plan.reason = PassReason::kWithinTolerance;
    plan.bound_px = native + budget.snap_px;
    return;
  }
  plan.action = Action::kMesh;
  for (int side = 0; side < 4; ++side) plan.collapsed_edge[side] = model.screen.collapsed_edge(side);
  const double one_fan = fan(model, corner, budget.mesh_px, kDepth);
  if (one_fan <= budget.mesh_px) {
    set_fan(plan, one_fan);
  } else if (!plan_block(model, budget, plan)) {
    set_fan(plan, fan(model, corner, kInfinity, 0));
  }
  plan.bound_px += budget.snap_px;
  plan.capped = !(plan.bound_px <= budget.tolerance_px);
}

}  // namespace truequad::kernel
