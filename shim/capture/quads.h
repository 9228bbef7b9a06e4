// What immediate mode (primitive.cc) and other ways to draw quads share.
#pragma once

#include "capture/state.h"

namespace truequad {

// This thread's capture, if quads are to be looked at or counted; null also without memory.
Capture* capturing_thread(Entry& entry);

// A primitive begins.
void start(Capture& c, const Entry& entry, GLenum mode);

// Open to held: the driver drops the vertices of the window, and is outside of Begin/End.
void cut(Capture& c);

// Looks at the quad alone. kNone: the textures of `warped` (slots) show its diagonal.
Reason judge(Capture& c, const Quad& quad, SlotMask& warped);

// True if an earlier pass drew, or a later one will want, a mesh over these vertices.
bool may_be_mesh(const Capture& c, const Quad& quad);

// Its position alone: affine whatever affine texture it gets.
bool parallelogram(const Capture& c, const Quad& quad);

}  // namespace truequad
