// glRect: a rectangle in the plane z = 0, whose vertices have one texture coordinate. So it needs no correction of its own, but
// an earlier pass over its corners may have drawn a mesh (drawn.h).
#pragma once

#include "capture/capture.h"

namespace truequad {

// True: it was drawn. False: the program's call is to be forwarded.
bool rectangle(Entry& entry, float x1, float y1, float x2, float y2);

template <typename T, typename Own>
void draw_rectangle(Entry& e, T x1, T y1, T x2, T y2, Own own) {
  if (!e.active && !e.inside && !e.list && rectangle(e, float(x1), float(y1), float(x2), float(y2))) return;
  own();
}

// Corners behind pointers: they are read only where the driver would read them to draw.
template <typename T, typename Own>
void draw_rectangle(Entry& e, const T* v1, const T* v2, Own own) {
  if (e.active || e.inside || e.list || !e.context) return own();
  draw_rectangle(e, v1[0], v1[1], v2[0], v2[1], own);
}

}  // namespace truequad
