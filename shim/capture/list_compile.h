// A display list while it is compiled. All calls go to the driver's own list until a quad may need correction; from there
// on the list is split: the quad and what follows it at once are kept with us, the next other call opens another list of
// the driver's.
#pragma once

#include "capture/lists.h"

namespace truequad {

struct Capture;

struct ListCompile {
  const GLuint name;
  const GLenum mode;           // GL_COMPILE or GL_COMPILE_AND_EXECUTE
  SplitList* split = nullptr;  // null: all is in the driver's own list so far
  bool existed = false;        // before it was split: the program has such a list until glEndList
  bool driver_open = true;     // the driver is compiling; else calls go to `keeping`
  bool opened_inside = false;     // its part began between glBegin and glEnd
  bool unmatched_end = false;     // and has a glEnd that no glBegin of the list goes before
  Part* driver_part = nullptr;    // null: as long as the list is not split
  Part* kept = nullptr;        // the calls that are being kept, if the last part is such
  bool kept_primitive = false;    // a glBegin is among them
  bool kept_inside = false;       // a vertex or glEnd came before it
  bool executed_inside = false;   // GL_COMPILE_AND_EXECUTE: what was made of them ends between glBegin and glEnd
  // Attributes before anything else, not yet given to the driver: if a vertex follows without a glBegin, the list is one
  // to be called between glBegin and glEnd, and is kept whole. Null: the driver has had something.
  Part* leading = nullptr;
  const Driver* driver;        // the real functions

  ListCompile(GLuint n, GLenum m, const Driver* d) : name(n), mode(m), driver(d) {}
};

// The program's own calls; each makes the driver's call itself.
void new_list(Entry& entry, GLuint list, GLenum mode);
void end_list(Entry& entry);

// glEnd outside of the list's own glBegin and glEnd.
void note_unmatched_end(ListCompile& list);

// For calls that are kept or not, while entry.list.

// The calls being kept; opens such a part. Null without memory.
KeptCalls* kept_calls(Entry& entry);
// A vertex comes outside of glBegin and glEnd.
void keep_leading(Entry& entry);

// The driver compiles again, into its next part, if it does not; returns its functions. (Between the glBegin and glEnd of
// GL_COMPILE_AND_EXECUTE it would not: then a call is only made, and the list lacks it.)
const Driver& open_driver_part(Entry& entry);

// The list is being compiled, and the driver has its first part already, but to the program there is no such list until
// glEndList.
bool is_unborn(const Entry& entry, GLuint name);

// The real functions, whatever entry.driver is while a list is compiled.
const Driver* real_driver(const Entry& entry);
// The driver's part ends here; what follows is kept. The driver must be outside Begin/End, unless in GL_COMPILE. False
// without memory: then nothing has changed.
bool end_driver_part(Entry& entry);
// glCallList or glCallLists becomes a part. Between the glBegin and glEnd that the driver executes it cannot; there the
// driver gets the calls of the list that is called. False without memory: the driver has to compile the call itself.
bool compile_call(Entry& entry, GLuint list);
bool compile_calls(Entry& entry, GLsizei count, GLenum type, const void* lists);

// True if calls go to `keeping`.
inline bool keeps(const ListCompile& list) { return !list.driver_open || list.leading; }
// True if glBegin(mode) of quads is kept without being looked at: it follows what is kept already.
bool keeps_quads(const Entry& entry);

// In GL_COMPILE_AND_EXECUTE: makes the kept calls that were not made yet.
void execute_kept(Entry& entry);

// A context ends while it compiles.
void drop_list(ListCompile* list);

}  // namespace truequad
