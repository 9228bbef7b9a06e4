// Drawing a quad in the place of the program's own: as a mesh of triangles, or with projective texture coordinates.
#pragma once

#include "capture/state.h"

namespace truequad {

// Gives the corners that lack a slot of `slots` the driver's current value, which is what they had: the slot was
// first set after them, and not sent since. The capture must be held.
void fill_absent(Capture& c, const Quad& quad, SlotMask slots);

// Plans the quad for the present view and draws it if it needs correction. `warped`: texture slots that show the
// diagonal. kNone: drawn. Else nothing was drawn, for this reason. The capture must be held.
Reason correct(Capture& c, const Quad& quad, SlotMask warped);

void free_scratch(Scratch* scratch);

}  // namespace truequad
