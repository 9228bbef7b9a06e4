// The doors' side of the capture: every call goes to entry.dispatch, but for the few that have functions here.
// No function here throws, locks on the vertex path, or raises a GL error that the program's own calls would not.
#pragma once

#include "capture/entry.h"
#include "gl_enums.h"

namespace truequad {

// Of a primitive of one of these modes we look at the quads (GL 2.1 section 2.6.1); a polygon is one if it has four vertices.
constexpr bool has_quads(GLenum mode) { return mode == GL_QUADS || mode == GL_QUAD_STRIP || mode == GL_POLYGON; }

// begin() and end() of what is or may be captured.
void begin_quads(Entry& entry, GLenum mode);
void end_quads(Entry& entry);
void note_unmatched_end(ListCompile& list);

// The program called glBegin(mode). Forwards the call itself (now, or together with the first quad). Inline, as all other
// modes pass here too.
inline void begin(Entry& entry, GLenum mode) {
  if (entry.active || has_quads(mode)) return begin_quads(entry, mode);
  // Not inside after an unknown mode; a mode that this driver lacks makes us pass what follows, no more.
  if (mode <= GL_PATCHES) entry.inside = true;
  entry.driver->Begin(mode);
}

// The program called glEnd. Forwards the call itself.
inline void end(Entry& entry) {
  if (entry.active) return end_quads(entry);
  if (entry.list && !entry.inside) [[unlikely]] note_unmatched_end(*entry.list);
  entry.inside = false;
  entry.driver->End();
}

// The program is about to make a call that could notice what is held, other than an OpenGL command (glXSwapBuffers …).
// Afterwards the driver has seen everything before it; the caller forwards the call.
void barrier(Entry& entry);

// The program called one of these. Forward the call themselves; what they note: drawn.h.
void clear(Entry& entry, GLbitfield mask);
void depth_func(Entry& entry, GLenum function);
void stencil_op(Entry& entry, GLenum fail, GLenum depth_fail, GLenum pass);
void stencil_op_separate(Entry& entry, GLenum face, GLenum fail, GLenum depth_fail, GLenum pass);

// A frame was finished: the buffers are swapped.
void frame_ended(Entry& entry);

// After `context` (null: none) was made current on this thread; barrier() was called before if something was active.
// `driver` is its table and outlives it; with no context: the one to use until there is one.
void context_made_current(Entry& entry, const void* context, const Driver* driver);

// `context` was created, and shares lists with `share` (null: with none). Its handle may be one that a context had which
// went away unnoticed (eglTerminate, XCloseDisplay).
void context_created(const void* context, const void* share);

// `context` was destroyed, on any thread, current or not.
void context_destroyed(const void* context);

// The process ends, by exit or _exit: writes the statistics once, if they were asked for. Any thread, any number of
// times; a forked child never writes over its parent's file.
void process_ends();

}  // namespace truequad
