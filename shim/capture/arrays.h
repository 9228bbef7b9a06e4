// Quads drawn from vertex arrays (GL 2.1 section 2.8): the doors' side.
#pragma once

#include "capture/array_state.h"
#include "capture/buffers.h"
#include "capture/capture.h"

namespace truequad {

// How often a draw is made.
struct Instances {
  GLsizei count = 1;
  bool named = false;  // the call says so
  Instances() = default;
  Instances(GLsizei n) : count(n), named(true) {}
};

// A draw from arrays, of whatever entry point: glDrawArrays and glDrawElements are of one primitive.
struct ArrayDraw {
  GLenum mode;
  GLsizei primitives = 1;
  const GLsizei* count = nullptr;            // vertices of each
  const GLint* first = nullptr;              // without indices: the first element of each
  GLenum type = 0;                           // of the indices; 0: none
  const void* const* indices = nullptr;      // of each
  const GLint* base = nullptr;               // base vertex of each, if the call has one
  GLuint least = 0, most = ~GLuint(0);       // the range that the call promises of its indices
  Instances instances = {};
};

// Draws it, if some quad needs correction: quads that need none by draws of the same arrays. False: nothing was done, and
// the program's own call is to be forwarded, with its errors.
bool draw_quads(Entry& entry, const ArrayDraw& draw);

// Draws whose numbers are in memory; `type` is 0 without indices. Likewise.
bool draw_indirect_quads(Entry& entry, GLenum mode, GLenum type, const void* from, GLsizei draws, GLsizei stride);

// glArrayElement between glBegin and glEnd: true if its attributes and its vertex were sent on by calls of immediate mode.
bool element_in_primitive(Entry& entry, GLint element);
template <typename Own>
void array_element(Entry& e, GLint element, Own own) {
  if (e.inside && element_in_primitive(e, element)) return;
  own();
}

// True if this draw may have quads of ours; else its door forwards it at once.
inline bool may_have_quads(const Entry& entry, GLenum mode) { return has_quads(mode) && !entry.active && !entry.inside; }

// One primitive of `count` vertices. Each makes the program's call `own()` if nothing needs correction.
template <typename Own>
void draw_arrays(Entry& e, GLenum mode, GLint first, GLsizei count, Instances instances, Own own) {
  if (may_have_quads(e, mode) &&
      draw_quads(e, {.mode = mode, .count = &count, .first = &first, .instances = instances})) {
    return;
  }
  own();
}
struct IndexRange {
  GLuint least = 0, most = ~GLuint(0);
};
template <typename Own>
void draw_elements(Entry& e, GLenum mode, IndexRange range, GLsizei count, GLenum type, const void* indices, GLint base,
                   Instances instances, Own own) {
  if (may_have_quads(e, mode) && draw_quads(e, {.mode = mode,
                                                .count = &count,
                                                .type = type,
                                                .indices = &indices,
                                                .base = base != 0 ? &base : nullptr,
                                                .least = range.least,
                                                .most = range.most,
                                                .instances = instances})) {
    return;
  }
  own();
}
template <typename Own>
void multi_draw_arrays(Entry& e, GLenum mode, const GLint* first, const GLsizei* count, GLsizei primitives, Own own) {
  if (may_have_quads(e, mode) &&
      draw_quads(e, {.mode = mode, .primitives = primitives, .count = count, .first = first})) {
    return;
  }
  own();
}
template <typename Own>
void multi_draw_elements(Entry& e, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                         GLsizei primitives, const GLint* base, Own own) {
  if (may_have_quads(e, mode) && draw_quads(e, {.mode = mode,
                                                .primitives = primitives,
                                                .count = count,
                                                .type = type,
                                                .indices = indices,
                                                .base = base})) {
    return;
  }
  own();
}

template <typename Own>
void draw_indirect(Entry& e, GLenum mode, GLenum type, const void* from, GLsizei draws, GLsizei stride, Own own) {
  if (may_have_quads(e, mode) && draw_indirect_quads(e, mode, type, from, draws, stride)) return;
  own();
}

// The context's memory of arrays goes with it.
void free_array_memory(ContextRecord& context);

}  // namespace truequad
