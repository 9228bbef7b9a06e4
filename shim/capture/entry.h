// What every exported GL function looks at first: one thread-local record.
#pragma once

#include "driver/driver.h"

namespace truequad {

struct Capture;
struct ContextRecord;
struct ListCompile;

struct Entry {
  const Driver* dispatch;  // where the program's calls go: `driver`, or `capturing` while `active`
  Capture* active;         // non-null only between a captured glBegin and its glEnd
  const Driver* driver;    // real functions of the current context; never null
  ContextRecord* context;  // null: none is current that we know of
  Capture* own;            // this thread's; allocated at the first captured glBegin
  bool inside;             // between glBegin and glEnd, as far as the program's calls tell
  ListCompile* list;       // non-null between glNewList and glEndList
  bool playing;            // the calls are those of a list that is called
  bool relisting;          // and quads that need no correction are compiled again (relist.h)
  int list_depth;          // lists that call each other
  // What context->arrays remembers is what the driver has (array_state.h): the arrays, what reads them, where indices are.
  bool arrays_known, readers_known, index_buffer_known;
  const ListCompile* executing;  // a list whose calls are made as they are compiled, while `list` is null for it
};

// The real functions while no context is current. Defined, and never unusable, by whoever links the capture: the doors,
// or a test's fake driver.
extern Driver default_driver;

// The table of calls inside a captured primitive (capturing.cc).
extern const Driver capturing;

// Initial-exec: the vertex path pays one load for it, and the library is in the process from its start.
extern thread_local constinit Entry entry [[gnu::tls_model("initial-exec")]];

inline void set_active(Entry& e, Capture* capture) {
  e.active = capture;
  e.dispatch = capture ? &capturing : e.driver;
}

}  // namespace truequad
