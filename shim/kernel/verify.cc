// Verification of meshes: the theorem of docs/design.md "Error of a triangle" for each of their triangles.
#include "verify.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh.h"

namespace truequad::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Deepest halving of one long triangle that looks for a tighter bound.
constexpr int kDepth = 6;
// The same to find how far beyond the limit a triangle is, and what is asked of it at least.
constexpr int kFarDepth = 3;
constexpr double kMore = 1.02;
// A side of a cell is as good as none if it is so much shorter than the opposite one.
constexpr double kShort = 1e-3;

template <typename F>
void for_each_triangle_of_side(const ErrorModel& model, const Plan& plan, const Block& block, int side, F&& f) {
  const auto vertex = [&](Node node) {
    const Param at = param(plan, block, node);
    return model.screen.mesh_point(at.u, at.v);
  };
  for_each_border_triangle(block, side, vertex, f);
}

// Calls f(corners, centre) for each cell.
template <typename F>
void for_each_cell(const ErrorModel& model, const Plan& plan, const Block& block, F&& f) {
  const auto vertex = [&](int i, int j) {
    const Param at = param(plan, block, {i, j});
    return model.screen.mesh_point(at.u, at.v);
  };
  for (int j = 0; j < block.m; ++j) {
    std::array<MeshPoint, 2> left{vertex(0, j), vertex(0, j + 1)};
    for (int i = 0; i < block.n; ++i) {
      const std::array<MeshPoint, 2> right{vertex(i + 1, j), vertex(i + 1, j + 1)};
      const Param middle = centre(plan, i, j);
      f(std::array<MeshPoint, 4>{left[0], right[0], right[1], left[1]}, model.screen.mesh_point(middle.u, middle.v));
      left = right;
    }
  }
}

// Of side i of a cell on the screen. Behind the eye it has no meaning, and does no harm.
double length(const std::array<MeshPoint, 4>& corner, int i) {
  const MeshPoint &a = corner[std::size_t(i)], &b = corner[std::size_t(i + 1) % 4];
  return std::hypot(b.x - a.x, b.y - a.y);
}

// Of a triangle that does not keep the limit.
Estimate estimate_beyond(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c,
                         double limit_px) {
  Estimate estimate = triangle_estimate(model, a, b, c);
  if (estimate.px() > limit_px) return estimate;
  // The proof asks for more than what is likely.
  const double proven_px = triangle_bound(model, a, b, c, kTightest, kFarDepth);
  estimate.map_px += std::max(proven_px, kMore * limit_px) - estimate.px();
  return estimate;
}

// Raises a bound to that of a triangle.
void raise(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c, double limit_px, int depth,
           double& bound) {
  if (bound == kInfinity) return;
  const double limit = std::max(bound, limit_px), px = triangle_bound(model, a, b, c, limit, depth);
  bound = std::max(bound, px <= limit ? px : triangle_bound(model, a, b, c, kTightest, depth));
}

}  // namespace

std::array<SideVerdict, 4> verify_sides(const ErrorModel& model, const Plan& plan, double limit_px) {
  std::array<SideVerdict, 4> verdict;
  const Block block(plan);
  for (int side = 0; side < 4; ++side) {
    if (block.flush[side]) continue;
    SideVerdict& of = verdict[side];
    for_each_triangle_of_side(model, plan, block, side, [&](const MeshPoint& a, const MeshPoint& b, const MeshPoint& c) {
      const double px = triangle_bound(model, a, b, c, limit_px, kDepth);
      if (px <= limit_px) {
        of.px = std::max(of.px, px);
        return;
      }
      const Estimate estimate = estimate_beyond(model, a, b, c, limit_px);
      if (of.keeps || estimate.px() > of.worst.px()) of.worst = estimate;
      of.keeps = false;
    });
  }
  return verdict;
}

BlockVerdict verify_block(const ErrorModel& model, const Plan& plan, double limit_px) {
  BlockVerdict verdict;
  for_each_cell(model, plan, Block(plan), [&](const std::array<MeshPoint, 4>& corner, const MeshPoint& centre) {
    const double px = cell_bound(model, corner, centre, limit_px);
    if (px <= limit_px) {
      verdict.px = std::max(verdict.px, px);
      return;
    }
    verdict.all_keep = false;
    // No lines help where the map folds.
    if ((model.folded || model.colours.folded) && px == kInfinity) return;
    // Opposite triangles are alike, but for one towards a side of the quad without length: it is no measure of others.
    for (int i = 0; i < 2; ++i) {
      const int side = length(corner, i) < kShort * length(corner, i + 2) ? i + 2 : i;
      const Estimate estimate = triangle_estimate(model, corner[side], corner[(side + 1) % 4], centre);
      if (verdict.keeps || estimate.px() > verdict.worst.px()) verdict.worst = estimate;
      verdict.keeps = false;
    }
  });
  if (!verdict.keeps && verdict.worst.px() < kMore * limit_px) verdict.worst.map_px += kMore * limit_px - verdict.worst.px();
  return verdict;
}

double block_bound(const ErrorModel& model, const Plan& plan, double limit_px) {
  double bound = 0;
  for_each_cell(model, plan, Block(plan), [&](const std::array<MeshPoint, 4>& corner, const MeshPoint& centre) {
    const double limit = std::max(bound, limit_px), px = cell_bound(model, corner, centre, limit);
    if (px <= limit) {
      bound = std::max(bound, px);
    } else {
      for (int i = 0; i < 4; ++i) raise(model, corner[i], corner[(i + 1) % 4], centre, limit_px, kFarDepth, bound);
    }
  });
  return sides_bound(model, plan, limit_px, bound);
}

double sides_bound(const ErrorModel& model, const Plan& plan, double limit_px, double cells_px) {
  const Block block(plan);
  double bound = cells_px;
  for (int side = 0; side < 4; ++side) {
    if (block.flush[side]) continue;
    for_each_triangle_of_side(model, plan, block, side, [&](const MeshPoint& a, const MeshPoint& b, const MeshPoint& c) {
      raise(model, a, b, c, limit_px, kDepth, bound);
    });
  }
  return bound;
}

}  // namespace truequad::kernel
