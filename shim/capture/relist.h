// The driver's own part of a primitive that a split list holds with us. Drivers may cut a quad that was compiled along the
// other diagonal than one in immediate mode (Mesa does, of GL_QUADS), so what needs no correction there is compiled once
// more, and called: then it is drawn as natively. Strips and polygons have but one diagonal in the drivers we know.
#pragma once

#include "capture/lists.h"
#include "capture/state.h"

namespace truequad {

// The name that a primitive of this mode needs now; 0: none, or there is none to be had.
inline GLuint relist_name(const Entry& e, GLenum mode) {
  if (!e.relisting || mode != GL_QUADS || !e.context || !e.context->group) return 0;
  GLuint& name = e.context->relist_name;
  if (!name) name = e.context->group->hidden_name(*e.driver);
  return name;
}

inline void begin_in_driver(const Capture& c) {
  if (c.relist) c.driver->NewList(c.relist, GL_COMPILE);
  c.driver->Begin(c.mode);
}

inline void end_in_driver(const Capture& c) {
  c.driver->End();
  if (!c.relist) return;
  c.driver->EndList();
  c.driver->CallList(c.relist);
  // Contexts that come and go leave nothing behind.
  c.driver->DeleteLists(c.relist, 1);
}

}  // namespace truequad
