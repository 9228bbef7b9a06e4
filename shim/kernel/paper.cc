// Oliveira, "Correcting Texture Mapping Errors Introduced by Graphics Hardware" (SIBGRAPI 2001): midpoint
// subdivision of a quad while it, or its texture patch, is not a parallelogram and its projected area is
// worth it. The area is that of the whole quad divided by four per level.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "planners.h"

namespace truequad::kernel {
namespace {

using Points = std::array<glm::dvec3, 4>;

Points euclidean(const Corners& corners) {
  Points points;
  for (int i = 0; i < 4; ++i) {
    const Vec4& c = corners[i];
    const double w = c.w != 0 ? c.w : 1;
    points[i] = {c.x / w, c.y / w, c.z / w};
  }
  return points;
}

Points leaf_of(const Points& p, const Leaf& leaf) {
  const auto at = [&](double u, double v) {
    return (1 - u) * (1 - v) * p[0] + u * (1 - v) * p[1] + u * v * p[2] + (1 - u) * v * p[3];
  };
  return {at(leaf.u0, leaf.v0), at(leaf.u1, leaf.v0), at(leaf.u1, leaf.v1), at(leaf.u0, leaf.v1)};
}

// Opposite sides are parallel: the dot product of their directions is within `threshold` of 1.
bool parallelogram(const Points& p, double threshold) {
  const auto parallel = [&](const glm::dvec3& a, const glm::dvec3& b) {
    const double lengths = glm::length(a) * glm::length(b);
    return !(lengths > 0) || 1 - glm::dot(a, b) / lengths <= threshold;
  };
  return parallel(p[1] - p[0], p[2] - p[3]) && parallel(p[3] - p[0], p[2] - p[1]);
}

// In square pixels; the whole viewport for a quad that reaches behind the eye, which the paper does not
// treat.
double projected_area(const ScreenQuad& quad) {
  double x[4], y[4];
  for (int i = 0; i < 4; ++i) {
    const ScreenPoint& p = quad.corner[i];
    if (!(p.w > 0)) return 4 * quad.half_width * quad.half_height;
    x[i] = p.x / p.w;
    y[i] = p.y / p.w;
  }
  const auto triangle = [&](int a, int b, int c) {
    return std::fabs((x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a])) / 2;
  };
  return triangle(0, 1, 2) + triangle(0, 2, 3);
}

std::array<MeshPoint, 4> points(const ErrorModel& model, const Leaf& leaf) {
  return {model.screen.mesh_point(leaf.u0, leaf.v0), model.screen.mesh_point(leaf.u1, leaf.v0),
          model.screen.mesh_point(leaf.u1, leaf.v1), model.screen.mesh_point(leaf.u0, leaf.v1)};
}

}  // namespace

double leaves_bound(const ErrorModel& model, const Plan& plan) {
  double bound = 0;
  for (const Leaf& leaf : std::span(plan.leaves.data(), plan.leaf_count)) {
    const auto [a, b, c, d] = points(model, leaf);
    bound = raised_bound(model, a, b, c, bound, 0);
    bound = raised_bound(model, a, c, d, bound, 0);
  }
  return bound;
}

void plan_paper(const Corners& position, std::span<const Corners> textures, const ErrorModel& model,
                const Budget& budget, Plan& plan) {
  const Points object = euclidean(position);
  const auto flat = [&](const Leaf& leaf) {
    if (!parallelogram(leaf_of(object, leaf), budget.paper.object)) return false;
    return std::all_of(textures.begin(), textures.end(), [&](const Corners& texture) {
      return parallelogram(leaf_of(euclidean(texture), leaf), budget.paper.texture);
    });
  };
  plan.leaves[0] = {0, 0, 1, 1};
  plan.leaf_count = 1;
  plan.capped = false;
  const std::size_t most = std::max<std::size_t>(1, std::size_t(budget.max_triangles) / 2);
  double area = projected_area(model.screen);
  float size = 1;
  for (bool split = true; split && area > budget.paper.area_px && size > 0x1p-20f; area /= 4, size /= 2) {
    split = false;
    const std::size_t count = plan.leaf_count;
    for (std::size_t i = 0; i < count; ++i) {
      Leaf& leaf = plan.leaves[i];
      if (leaf.u1 - leaf.u0 != size || flat(leaf)) continue;
      if (plan.leaf_count + 3 > most) {
        plan.capped = true;
        break;
      }
      const auto [u0, v0, u1, v1] = leaf;
      const float u = (u0 + u1) / 2, v = (v0 + v1) / 2;
      plan.leaves[plan.leaf_count++] = {u, v0, u1, v};
      plan.leaves[plan.leaf_count++] = {u, v, u1, v1};
      plan.leaves[plan.leaf_count++] = {u0, v, u, v1};
      leaf = {u0, v0, u, v};
      split = true;
    }
  }
  plan.action = plan.leaf_count == 1 ? Action::kPass : Action::kMesh;
  plan.reason = plan.leaf_count == 1 ? PassReason::kWithinTolerance : PassReason::kNone;
  plan.triangles = int(2 * plan.leaf_count);
  plan.bound_px = leaves_bound(model, plan);
  // A single leaf is drawn by the driver, which may choose the other diagonal.
  if (plan.leaf_count == 1) {
    const auto [a, b, c, d] = points(model, plan.leaves[0]);
    plan.bound_px = raised_bound(model, a, b, d, plan.bound_px, 0);
    plan.bound_px = raised_bound(model, b, c, d, plan.bound_px, 0);
  }
  plan.bound_px += budget.snap_px;
  // The published algorithm promises nothing: its leaves keep the tolerance or they do not.
  plan.capped |= plan.action == Action::kMesh && !(plan.bound_px <= budget.tolerance_px);
  if (plan.leaf_count == 1) plan.leaf_count = 0;
}

}  // namespace truequad::kernel
