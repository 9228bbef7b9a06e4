// Drawing a quad in the place of the program's own: as a mesh of triangles, or with projective texture coordinates.
#pragma once

#include "capture/state.h"

namespace truequad {

// The call that gives `size` floats (1 to 4) of a slot that is interpolated, or of the position.
RowId float_call(const Caps& caps, Slot slot, unsigned size);

// All four corners have the same value, bit for bit.
bool same_everywhere(const Capture& c, Slot slot, const Quad& quad);

// The corner whose colours flat shading shows.
unsigned provoking_corner(const Capture& c);

// Draws the mesh of the scratch's plan. The driver may be inside our glBegin(GL_TRIANGLES), and is afterwards.
void draw_mesh(Capture& c, const Quad& quad);

// Draws the corners with their texture coordinates multiplied by the plan's lambda; `units` (bit mask): those of the
// plan's sets, in order.
void draw_projected(Capture& c, const Quad& quad, unsigned units);

}  // namespace truequad
