// From error bounds to the smallest mesh that keeps the tolerance: docs/design.md "Choosing a mesh".
#include <algorithm>
#include <cmath>
#include <limits>

#include "lines.h"
#include "mesh.h"
#include "planners.h"
#include "verify.h"

namespace truequad::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Deepest halving of one long triangle that looks for a tighter bound.
constexpr int kDepth = 6;
// Largest part of the quad that lies between one side and the block.
constexpr double kMaxInset = 0.3;
// Smallest: an inserted vertex must stay off the edge when its position is rounded to single precision.
constexpr double kMinInset = 0x1p-20;
// And when it is rounded, and a rasteriser snaps it, or its triangles would cover pixels beyond the edge. In widths of the grid
// and what rounding moves: each vertex, and each end of the edge, moves by half a width in x and in y.
constexpr double kMinInsetSteps = 1.5;
// Smallest mesh with a block that touches no side.
constexpr int kSmallestBlock = 12;
// Triangles spent on a quad whose texture map folds: no number of them gives a bound there.
constexpr int kFoldedTriangles = 512;
constexpr int kMaxRounds = 12;
// Of these, rounds that only look for lines without slivers.
constexpr int kMaxSliverRounds = 3;
// Lines and insets are made for a little less than what verification asks, or its rounding slack would refuse
// them.
constexpr double kMargin = 1 - 1e-6;
// The same for what a rasteriser usually adds.
constexpr double kRasteriserMargin = 0.99;
// The same for corrected lines.
constexpr double kGoal = 0.99;
// And for insets: they cost next to nothing, and a triangle well within the limit is proven so with few halvings.
constexpr double kInsetMargin = 0.92;
// Rounds that correct insets alone.
constexpr int kMaxSideRounds = 8;
// By so much less in each of them.
constexpr double kGoalStep = 0.005;
// Insets that move by more than this together ask for other lines.
constexpr double kMoved = 0.05;
// Part of the error that lines are made for next when those chosen have slivers.
constexpr double kSliverStep = 0.97;
constexpr int kMaxSame = 16;
// Slivers by chance differ by more than this from lines to lines.
constexpr double kAlike = 0.1;
constexpr int kMaxApexRounds = 2;

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
  const MeshPoint centre = model.screen.mesh_point(0.5, 0.5);
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

// Factor for the inset of a side that does not keep the goal, 1 if none helps: the map's part of the error grows with the
// inset, the rasteriser's falls with it. `reachable`: false if the least of their sum is beyond the goal.
double inset_change(const Estimate& found, double goal_px, bool& reachable) {
  const double map_px = found.map_px, rest_px = found.rasteriser_px;
  const double root = goal_px * goal_px - 4 * map_px * rest_px;
  // A smaller inset makes this worse, until the block's vertices are snapped to the edge and cover other pixels.
  if (!(rest_px < kInfinity)) {
    reachable = false;
    return 1;
  }
  if (!(map_px < kInfinity) || rest_px < 0.01 * goal_px) {
    return std::clamp(goal_px / found.px(), 0.25, 0.98);
  }
  if (root >= 0) return std::clamp((goal_px + std::sqrt(root)) / (2 * map_px), 0.25, 4.0);
  reachable = false;
  const double change = std::clamp(std::sqrt(rest_px / map_px), 0.25, 4.0);
  return change > 0.9 && change < 1.1 ? 1 : change;
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

// Moves the ends of the lines to the insets, and the lines between them in proportion.
void move_ends(GridLines& lines, double low, double high) {
  const double from = lines.at[0], scale = (high - low) / (lines.at[lines.count - 1] - from);
  for (std::size_t i = 0; i < lines.count; ++i) lines.at[i] = low + (lines.at[i] - from) * scale;
  lines.at[lines.count - 1] = high;
}
void copy(const GridLines& from, GridLines& to) {
  to.count = from.count;
  std::copy_n(from.at.begin(), from.count, to.at.begin());
}
// Where along a side the triangle on the quad's edge has its apex.
double apex_of(const Plan& plan, int side) {
  const Block block(plan);
  const Chain chain = block.chain(side);
  const Param at = param(plan, block, inner_node(block, side, apex(chain.first, chain.last)));
  return side % 2 == 0 ? at.u : at.v;
}

// The search for the smallest block that keeps the budget.
class BlockSearch {
 public:
  BlockSearch(const ErrorModel& model, const Budget& budget, Plan& plan)
      : model_(model),
        plan_(plan),
        folded_(model.folded || model.colours.folded),
        cap_(folded_ ? std::min(budget.max_triangles, kFoldedTriangles) : budget.max_triangles),
        aim_px_(budget.mesh_px),
        lines_px_((model.rasteriser.exact() ? kMargin : kRasteriserMargin) * aim_px_) {
    shrink_.fill(model.rasteriser.exact() ? kMargin : kInsetMargin);
    for (int side = 0; side < 4; ++side) {
      const double off_px = kMinInsetSteps * budget.snap_px;
      least_inset_[std::size_t(side)] = std::max(kMinInset, model.screen.parameter_at(side, off_px, kMaxInset));
    }
  }

  // Sets lines, triangles and bound_px; returns false if not even the smallest block fits under the cap.
  bool run() {
    if (cap_ < kSmallestBlock) return false;
    fit_densities(model_, aim_px_, densities_);
    apex_ = {median(densities_.u), median(densities_.v), median(densities_.u), median(densities_.v)};
    for (int round = 0; round < kMaxRounds; ++round) {
      if (!(round == 0 || at_cap_ ? choose() : choose_others())) continue;
      // Sides first: they are few triangles, and cheap to correct.
      const bool sides_keep = settle_sides();
      const BlockVerdict block = verify_block(model_, plan_, aim_px_);
      if (sides_keep && block.all_keep) {
        plan_.triangles = Block(plan_).triangles();
        plan_.bound_px = std::max(block.px, sides_px_);
        return true;
      }
      remember(block);
      if (at_cap_ || block.keeps || !correct_lines(block.worst)) break;
    }
    if (!found_) return false;
    copy(best_u_, plan_.u);
    copy(best_v_, plan_.v);
    plan_.triangles = Block(plan_).triangles();
    plan_.bound_px = best_cells_px_ < kInfinity ? sides_bound(model_, plan_, best_cells_px_, best_cells_px_)
                                                : block_bound(model_, plan_, std::min(best_px_, 4 * aim_px_));
    return true;
  }

 private:
  // Returns how far they moved together.
  double set_insets() {
    double moved = 0;
    for (int side = 0; side < 4; ++side) {
      const bool along_u = side % 2 == 0, at_start = side == 0 || side == 3;
      const Density &along = along_u ? densities_.u : densities_.v, &across = along_u ? densities_.v : densities_.u;
      const double estimate = inset_for(along, across, at_start, apex_[std::size_t(side)], aim_px_);
      const double inset =
          plan_.collapsed_edge[side] ? 0 : std::clamp(shrink_[side] * estimate, least_inset_[side], kMaxInset);
      moved += std::fabs(inset - inset_[side]);
      inset_[side] = inset;
    }
    return moved;
  }

  // False if the cap does not allow what is aimed for: then the aim is raised.
  bool choose() {
    set_insets();
    // Apexes are known from the lines, and insets from apexes.
    for (int i = 0; i < kMaxApexRounds; ++i) {
      const int triangles = choose_lines(densities_, inset_, plan_.collapsed_edge, lines_px_, cap_, plan_);
      if (triangles > cap_) {
        const double factor = std::clamp(1.02 * triangles / cap_, 1.05, 1e6);
        aim_px_ *= factor;
        lines_px_ *= factor;
        at_cap_ = true;
        return false;
      }
      for (int side = 0; side < 4; ++side) {
        if (!plan_.collapsed_edge[side]) apex_[std::size_t(side)] = apex_of(plan_, side);
      }
      if (set_insets() <= kMoved) break;
    }
    move_ends();
    return true;
  }

  void move_ends() {
    kernel::move_ends(plan_.u, inset_[3], 1 - inset_[1]);
    kernel::move_ends(plan_.v, inset_[0], 1 - inset_[2]);
  }

  // Other numbers of lines, if need be for an error that is smaller yet.
  bool choose_others() {
    const std::size_t columns = plan_.u.count, rows = plan_.v.count;
    for (int i = 0; i < kMaxSame; ++i, lines_px_ *= kSliverStep) {
      if (!choose()) return false;
      if (plan_.u.count != columns || plan_.v.count != rows) break;
    }
    return true;
  }

  // Slivers along a side that no inset helps may be none with other lines.
  bool settle_sides() {
    if (correct_sides()) return true;
    if (at_cap_ || folded_ || reachable_) return false;
    const double lines_px = lines_px_;
    const Insets shrink = shrink_;
    for (int i = 0; i < kMaxSliverRounds; ++i) {
      const double before_px = sides_px_;
      lines_px_ *= kSliverStep;
      shrink_ = shrink;
      if (!choose_others()) break;
      if (correct_sides()) return true;
      // Not by chance, then.
      if (std::fabs(sides_px_ - before_px) < kAlike * before_px) break;
    }
    if (at_cap_) return false;
    lines_px_ = lines_px;
    shrink_ = shrink;
    return choose() && correct_sides();
  }

  bool correct_sides() {
    reachable_ = true;
    for (int round = 0; round < kMaxSideRounds; ++round) {
      const auto verdict = verify_sides(model_, plan_, aim_px_);
      bool keep = true, changed = false;
      sides_px_ = 0;
      for (int side = 0; side < 4; ++side) {
        const SideVerdict& of = verdict[std::size_t(side)];
        sides_px_ = std::max({sides_px_, of.px, of.worst.px()});
        if (of.keeps) continue;
        keep = false;
        if (folded_ && of.worst.px() == kInfinity) continue;
        // Less is asked for each time, or two sides might take turns.
        const double change = inset_change(of.worst, (kInsetMargin - kGoalStep * round) * aim_px_, reachable_);
        shrink_[side] *= change;
        changed |= change != 1;
      }
      if (keep || !changed) return keep;
      if (!(set_insets() > kMoved && choose())) move_ends();
    }
    return false;
  }

  // False if other lines are not worth a try.
  bool correct_lines(const Estimate& worst) {
    // One try for a mesh that will not keep the aim for its sides.
    if (!reachable_ && ++sliver_rounds_ > kMaxSliverRounds) return false;
    const double left_px = aim_px_ - worst.rasteriser_px;
    double factor = kSliverStep;
    if (left_px > aim_px_ / 2) {
      factor = std::clamp(kGoal * left_px / worst.map_px, 0.5, 0.98);
    } else if (++sliver_rounds_ > kMaxSliverRounds) {
      // Slivers, which occur where the quad's picture folds, are no matter of size: other lines have others.
      return false;
    }
    lines_px_ *= factor;
    return true;
  }

  void remember(const BlockVerdict& block) {
    const double px = std::max({block.px, block.worst.px(), sides_px_});
    if (found_ && !(px < best_px_)) return;
    best_cells_px_ = block.all_keep ? block.px : kInfinity;
    found_ = true;
    best_px_ = px;
    copy(plan_.u, best_u_);
    copy(plan_.v, best_v_);
  }

  const ErrorModel& model_;
  Plan& plan_;
  const bool folded_;
  const int cap_;
  double aim_px_;    // error that lines and insets are made for
  double lines_px_;  // the same for the lines alone, corrected by what verification found
  Insets shrink_;    // the same for insets, as a factor
  Densities densities_;
  Insets least_inset_, inset_{}, apex_{};
  double sides_px_ = 0;
  bool at_cap_ = false, reachable_ = true, found_ = false;
  int sliver_rounds_ = 0;
  // The best mesh of those that do not keep the aim.
  double best_px_ = kInfinity, best_cells_px_ = kInfinity;
  GridLines best_u_, best_v_;
};

}  // namespace

void plan_bilinear(const ErrorModel& model, const Budget& budget, Plan& plan) {
  const std::array<MeshPoint, 4> corner{model.screen.mesh_point(0, 0), model.screen.mesh_point(1, 0),
                                        model.screen.mesh_point(1, 1), model.screen.mesh_point(0, 1)};
  const double native = two_triangles(model, corner, budget.native_px);
  if (native <= budget.native_px) {
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
  } else if (!BlockSearch(model, budget, plan).run()) {
    set_fan(plan, fan(model, corner, kInfinity, 0));
  }
  plan.bound_px += budget.snap_px;
  plan.capped = !(plan.bound_px <= budget.tolerance_px);
}

}  // namespace truequad::kernel
