// The planners behind plan(): each fills action, reason, bound, cap, triangle count and what its action
// needs.
#pragma once

#include <span>

#include "error_model.h"
#include "truequad/kernel.h"

namespace truequad::kernel {

// Limits in their valid range, with the part of the tolerance that is left to the mesh once its vertices have been rounded
// and snapped, which moves what is drawn by `snap_px`; `rounding_px` of it by rounding.
// `native_px` of it is left to the two triangles if they shall stay.
struct Budget {
  double tolerance_px, snap_px, rounding_px, native_px, mesh_px, colour_steps;
  int max_triangles;
  PaperThresholds paper;
};
Budget make_budget(const Limits& limits, const View& view, double rounding_px);

// Passes if two triangles are enough, else meshes. model: screen and maps of the sets that are neither
// constant nor affine.
void plan_bilinear(const ErrorModel& model, const Budget& budget, Plan& plan);

// The same by the leaves of a plan.
double leaves_bound(const ErrorModel& model, const Plan& plan);

// Oliveira 2001 as published.
void plan_paper(const Corners& position, std::span<const Corners> textures, const ErrorModel& model,
                const Budget& budget, Plan& plan);

// Fills plan.lambda; false if some set has no valid projective map, or a rasteriser would not keep the tolerance.
// model: screen and rasteriser. `spread`: the largest ratio of two factors of a set.
bool plan_projective(const Corners& position, std::span<const Corners> textures, const ErrorModel& model,
                     const Budget& budget, Plan& plan, double& spread);

}  // namespace truequad::kernel
