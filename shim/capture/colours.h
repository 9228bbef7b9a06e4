// The colours of a quad as the kernel takes them, for TRUEQUAD_COLOR=1: docs/semantics.md "Colours".
#pragma once

#include "capture/drawn.h"
#include "capture/state.h"

namespace truequad {

// Looks at the quad alone: true if two triangles would show its colours with a kink under smooth shading. While lighting
// is enabled only the corners' lit colours can tell.
bool colours_may_kink(const Capture& c, const Quad& quad);

// What the driver makes of colours now besides lighting and shading: reads it at the first need of a Begin.
void read_colour_state(const Driver& driver, const Caps& caps, FrameView& out);

// Writes the channels that vary over the corners: lit or given colours, clamped if the driver would, and fog. None if
// shading is flat. The corners must have all that is live (fill_absent). The driver may be inside our
// glBegin(GL_TRIANGLES), or is afterwards outside.
void find_colours(Capture& c, const Quad& quad, PlannedFor& out);

}  // namespace truequad
