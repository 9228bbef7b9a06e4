// TRUEQUAD_OVERLAY: the mesh drawn over its quad, as in the figures of Oliveira 2001.
#pragma once

#include <span>

#include "capture/state.h"

namespace truequad {

// Draws the edges of a mesh, or of the whole quad if the plan has none, as lines. The driver must be outside
// Begin/End; all its state is as before afterwards, depth and stencil buffers included. Draws nothing if the program
// has used up the attribute stack.
void draw_overlay(const Capture& c, const Quad& quad, const Plan& plan, std::span<const Param> params,
                  std::span<const Triangle> triangles);

}  // namespace truequad
