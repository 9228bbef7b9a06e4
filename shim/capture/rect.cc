#include "capture/rect.h"

#include "capture/colours.h"
#include "capture/correct.h"
#include "capture/draw.h"
#include "capture/quads.h"

namespace truequad {

bool rectangle(Entry& e, float x1, float y1, float x2, float y2) {
  Capture* const c = capturing_thread(e);
  if (!c) return false;
  // Drivers draw it as a quad, in the order of GL 2.1 section 2.10.
  start(*c, e, GL_QUADS);
  c->counters.rectangles.add(1);
  if (c->state == State::kPassive) {
    c->counters.pass(c->passive_reason);
    return false;
  }
  constexpr Quad kQuad = {{0, 1, 2, 3}};
  c->at[kPosition][0] = {{x1, y1, 0, 1}};
  c->at[kPosition][1] = {{x2, y1, 0, 1}};
  c->at[kPosition][2] = {{x2, y2, 0, 1}};
  c->at[kPosition][3] = {{x1, y2, 0, 1}};
  for (unsigned i = 0; i < 4; ++i) {
    c->row[kPosition][i] = kRowVertex2fv;
    c->present[i] = 0;
  }
  const bool colours = colours_may_kink(*c, kQuad);
  if ((colours || may_be_mesh(*c, kQuad)) && correct(*c, kQuad, 0, colours) == Reason::kNone) {
    close_mesh(*c);
    return true;
  }
  c->counters.pass(Reason::kNoTextureVaries);
  if (c->watch != Watch::kNothing) note_triangles(*c, kQuad);
  return false;
}

}  // namespace truequad
