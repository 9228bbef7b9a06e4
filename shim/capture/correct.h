// A quad that needs another picture than its two triangles: why not, or what is drawn.
#pragma once

#include "capture/state.h"

namespace truequad {

// What the current context can be asked; read at the first need.
const Caps& caps_of(Capture& c);

// Gives the corners that lack a slot of `slots` the driver's current value, which is what they had: the slot was
// first set after them, and not sent since. The capture must be held.
void fill_absent(Capture& c, const Quad& quad, SlotMask slots);

// Makes the driver's current values of `slots` the capture's, to be sent again after the drawing (replay_now()). The driver
// must be outside of Begin/End.
void keep_current(Capture& c, SlotMask slots);

// Plans the quad for the present view and draws it, if it needs correction or an earlier pass drew it as a mesh.
// `warped`: texture slots that show the diagonal, perhaps none. `colours`: they may show it. kNone: drawn. Else nothing
// was drawn, for this reason; without anything warped it is kAffine. The capture must be held.
Reason correct(Capture& c, const Quad& quad, SlotMask warped, bool colours);

// The quad goes to the driver as it is.
void note_triangles(Capture& c, const Quad& quad);

void free_working_memory(Capture& c);

}  // namespace truequad
