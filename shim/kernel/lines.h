// Uneven grid lines that follow the local error: derived in docs/design.md "Grid lines".
#pragma once

#include <array>

#include "error_model.h"
#include "truequad/kernel.h"

namespace truequad::kernel {

// A step function on [0, 1]: height[i] between edge[i] and edge[i + 1].
struct Density {
  static constexpr int kMaxSteps = 8;
  int steps = 1;
  std::array<double, kMaxSteps + 1> edge;
  std::array<double, kMaxSteps> height;

  double integral(double from, double to) const;
};

// Steps a(u), b(v) with a(u) b(v) >= displacement in px per unit of the interpolation error of uv, over the
// visible part.
struct Densities {
  Density u, v;
};
// error_px: what lines will be made for; a few cells need no fine steps.
void fit_densities(const ErrorModel& model, double error_px, Densities& densities);

// Cuts [from, to] into the fewest cells with (width of the cell) (largest height in it) <= share. Returns
// their number, at most kMaxLines; with more than that, kMaxLines. `lines` may be null.
int cut(const Density& density, double from, double to, double share, GridLines* lines);

// The least share (nearly) with which cut() needs no more than `cells`.
double share_for(const Density& density, double from, double to, int cells);

}  // namespace truequad::kernel
