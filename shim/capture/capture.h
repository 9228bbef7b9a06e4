// The doors' side of the capture: what has to be told to it, and when. Attribute and vertex calls are in record.h.
// No function here throws, locks on the vertex path, or raises a GL error that the program's own calls would not.
#pragma once

#include "capture/entry.h"

namespace truequad {

// The program called glBegin(mode). Forwards the call itself (now, or together with the first quad).
void begin(Entry& entry, GLenum mode);

// The program called glEnd. Forwards the call itself.
void end(Entry& entry);

// The program is about to make a call other than those of record.h while entry.active != nullptr. Afterwards the
// driver has seen everything before it; the caller forwards the call.
void barrier(Entry& entry);

// After glNewList and glEndList have been forwarded.
void list_opened(Entry& entry);
void list_closed(Entry& entry);

// After `context` (null: none) was made current on this thread; barrier() was called before if something was active.
// `driver` is its table and outlives it; with no context: the one to use until there is one.
void context_made_current(Entry& entry, const void* context, const Driver* driver);

// `context` was destroyed, on any thread, current or not.
void context_destroyed(const void* context);

// The process ends, by exit or _exit: writes the statistics once, if they were asked for. Any thread, any number of
// times; a forked child never writes over its parent's file.
void process_ends();

}  // namespace truequad
