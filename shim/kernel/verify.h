// Every triangle of a mesh against a limit: docs/design.md "Choosing a mesh".
#pragma once

#include <array>

#include "error_model.h"
#include "truequad/kernel.h"

namespace truequad::kernel {

// What the triangles between one side of the quad and the block are found to do.
struct SideVerdict {
  bool keeps = true;  // all of them the limit
  double px = 0;      // bound of those that do
  Estimate worst;     // of those that do not
};
std::array<SideVerdict, 4> verify_sides(const ErrorModel& model, const Plan& plan, double limit_px);

struct BlockVerdict {
  bool keeps = true;    // all cells the limit, but for those that no mesh can
  bool all_keep = true;
  double px = 0;        // bound of those that do
  Estimate worst;       // of those that do not
};
BlockVerdict verify_block(const ErrorModel& model, const Plan& plan, double limit_px);

// Largest displacement of a texel by the block or fan of a plan, without the allowance of snapping. Triangles that keep the
// limit are looked at no further.
double block_bound(const ErrorModel& model, const Plan& plan, double limit_px);
// The same where the cells are known to keep `cells_px`.
double sides_bound(const ErrorModel& model, const Plan& plan, double limit_px, double cells_px);

}  // namespace truequad::kernel
