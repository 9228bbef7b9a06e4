// Vertices of arrays as calls of immediate mode: glArrayElement, and draws that a display list keeps.
#pragma once

#include "capture/array_sources.h"
#include "capture/capture.h"

namespace truequad {

// "The effect of ArrayElement(i) is the same as … " the calls of all enabled arrays, positions last (GL 2.1 section 2.8): by
// calls of the arrays' own types, on the program's way to the driver. All enabled arrays must have been found.
void send_element(Entry& entry, const ArraySources& sources, std::uint64_t element);

// Of a draw while a list is compiled: true if the list keeps it, as some quad may need correction.
bool compile_quads(Entry& entry, Capture& c, const ArrayDraw& draw);

}  // namespace truequad
