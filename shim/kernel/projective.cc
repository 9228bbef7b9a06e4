// The projective map of a planar quad: Heckbert, "Fundamentals of Texture Mapping and Image Warping" (1989);
// Turkowski, "The Differential Geometry of Texture-Mapping and Shading" (1989); Reed, "Quadrilateral
// interpolation" (2012) is the case of the unit square. Derived in docs/design.md "Projective".
#include <algorithm>
#include <cmath>

#include "planners.h"

namespace truequad::kernel {
namespace {

// A position off its plane by more than this part of the coordinates that enter is not planar: some
// operations in single precision, which programs use to build their quads.
constexpr double kPlanar = 64 * 0x1p-24;
// Factors that differ by more leave nothing of single-precision texture coordinates.
constexpr double kMaxSpread = 1e4;

// D = a A + b B + c C.
struct Weights {
  double a, b, c;
};

// Solves for the weights of the last corner in the others, by elimination with complete pivoting on the
// columns `dimension`; false if the three corners are dependent or the fourth is off their span.
bool solve(const Corners& corners, Weights& weights) {
  // Rows: coordinates; columns: A B C D. Rows are scaled to size 1: x y z w have no common unit.
  double m[4][4], size[4];
  for (int r = 0; r < 4; ++r) {
    double Vec4::*const of[4] = {&Vec4::x, &Vec4::y, &Vec4::z, &Vec4::w};
    size[r] = 0;
    for (int c = 0; c < 4; ++c) size[r] = std::max(size[r], std::fabs(corners[c].*of[r]));
    for (int c = 0; c < 4; ++c) m[r][c] = size[r] > 0 ? corners[c].*of[r] / size[r] : 0;
  }
  int order[3];  // row that solves for column
  bool used[4] = {};
  bool solved[3] = {};
  for (int step = 0; step < 3; ++step) {
    int row = -1, column = -1;
    double best = kPlanar;
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c < 3; ++c) {
        if (!used[r] && !solved[c] && std::fabs(m[r][c]) > best)
          best = std::fabs(m[r][c]), row = r, column = c;
      }
    }
    if (row < 0) return false;
    used[row] = solved[column] = true;
    order[column] = row;
    for (int r = 0; r < 4; ++r) {
      if (r == row) continue;
      const double factor = m[r][column] / m[row][column];
      for (int c = 0; c < 4; ++c) m[r][c] -= factor * m[row][c];
      m[r][column] = 0;
    }
  }
  const auto weight = [&](int c) { return m[order[c]][3] / m[order[c]][c]; };
  weights = {weight(0), weight(1), weight(2)};
  const double scale = 1 + std::fabs(weights.a) + std::fabs(weights.b) + std::fabs(weights.c);
  for (int r = 0; r < 4; ++r) {
    if (!used[r] && std::fabs(m[r][3]) > kPlanar * scale) return false;
  }
  return true;
}

// Convex, in drawing order, with all homogeneous coordinates on one side of 0.
bool convex(const Corners& corners, const Weights& weights) {
  const double sign = corners[0].w > 0 ? 1 : -1;
  for (const Vec4& c : corners) {
    if (!(sign * c.w > 0)) return false;
  }
  return weights.a > 0 && weights.b < 0 && weights.c > 0;
}

}  // namespace

bool plan_projective(const Corners& position, std::span<const Corners> textures, const ErrorModel& model,
                     const Budget& budget, Plan& plan, double& spread) {
  Weights p;
  if (!solve(position, p) || !convex(position, p)) return false;
  spread = 1;
  double bound_px = 0;
  for (std::size_t set = 0; set < std::min(textures.size(), kMaxTextureSets); ++set) {
    std::array<double, 4>& lambda = plan.lambda[set];
    if (classify(position, textures.subspan(set, 1)) != Shape::kWarped) {
      lambda = {1, 1, 1, 1};
      continue;
    }
    Weights t;
    if (!solve(textures[set], t) || !convex(textures[set], t)) return false;
    lambda = {t.a / p.a, t.b / p.b, t.c / p.c, 1};
    const double low = *std::min_element(lambda.begin(), lambda.end());
    const double high = *std::max_element(lambda.begin(), lambda.end());
    if (!(low > 0) || !(high <= kMaxSpread * low)) return false;
    spread = std::max(spread, high / low);
    bound_px = std::max(bound_px, projected_px(model, textures[set], lambda, budget.mesh_px));
  }
  if (bound_px > budget.mesh_px) return false;
  plan.action = Action::kProject;
  plan.triangles = 2;
  plan.bound_px = bound_px + budget.snap_px;
  plan.capped = false;
  return true;
}

}  // namespace truequad::kernel
