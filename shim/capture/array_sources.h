// Where the vertices of a draw are: its arrays and indices as addresses, in the client's memory or in copies of buffer
// objects. Only what the driver itself would read for these vertices is read.
#pragma once

#include "capture/array_fetch.h"
#include "capture/arrays.h"
#include "capture/state.h"

namespace truequad {

// Quads of a primitive of `count` vertices (GL 2.1 section 2.6.1), and where each begins and ends.
constexpr GLsizei quads_in(GLenum mode, GLsizei count) {
  if (mode == GL_QUADS) return count / 4;
  if (mode == GL_QUAD_STRIP) return count < 4 ? 0 : count / 2 - 1;
  return count == 4 ? 1 : 0;
}
constexpr GLsizei quad_step(GLenum mode) { return mode == GL_QUAD_STRIP ? 2 : 4; }

// The window's places are in the order of the vertices.
constexpr Quad quad_of(GLenum mode) { return mode == GL_QUAD_STRIP ? Quad{{0, 1, 3, 2}} : Quad{{0, 1, 2, 3}}; }

// The indices of one primitive.
struct Elements {
  const unsigned char* indices = nullptr;  // null: elements follow each other
  GLenum type = 0;
  std::int64_t base = 0;  // first element, or base vertex

  // Of the vertex `i`: without base.
  GLuint index(GLsizei i) const {
    switch (type) {
      case GL_UNSIGNED_BYTE: return indices[i];
      case GL_UNSIGNED_SHORT: {
        GLushort value;
        std::memcpy(&value, indices + std::size_t(i) * sizeof value, sizeof value);
        return value;
      }
      case GL_UNSIGNED_INT: {
        GLuint value;
        std::memcpy(&value, indices + std::size_t(i) * sizeof value, sizeof value);
        return value;
      }
      default: return GLuint(i);
    }
  }
};

constexpr unsigned index_bytes(GLenum type) {
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : type == GL_UNSIGNED_INT ? 4 : 0;
}

// Primitive restart (GL 4.6 compatibility section 10.3.6).
struct Restart {
  bool on = false;
  GLuint index = 0;
};
inline Restart restart_of(const ArrayState& state, GLenum type) {
  // "If both … are enabled, the index value … is the fixed one".
  if (type != 0 && state.restarts_at_largest) return {true, ~GLuint(0) >> (32 - 8 * index_bytes(type))};
  return {state.restarts, state.restart_index};
}

// Calls f(begin, end) for the vertices between two restarts.
template <typename F>
void for_each_segment(const Elements& elements, Restart restart, GLsizei count, F f) {
  if (!restart.on || elements.type == 0) return f(0, count);
  for (GLsizei begin = 0; begin < count;) {
    GLsizei end = begin;
    while (end < count && elements.index(end) != restart.index) ++end;
    f(begin, end);
    begin = end + 1;
  }
}

class ArraySources {
 public:
  // Reads the state of the arrays, those of `entry`'s context. The driver must be outside of Begin/End, now and in the
  // functions below.
  Reason open(Entry& entry, const Driver& driver);

  const Caps& caps() const { return *caps_; }
  const ArrayState& state() const { return *state_; }
  const ArraySource& operator[](Slot slot) const { return source_[slot]; }
  SlotMask ready() const { return ready_; }

  // Finds the arrays of `slots`, which are enabled. Not kNone: they cannot be read.
  Reason find(SlotMask slots);
  // The indices of a primitive.
  Reason find(const ArrayDraw& draw, GLsizei primitive, Elements& out);
  // True if all enabled arrays lie in memory that can be read, so that the driver's draw is no error.
  bool all_readable();
  bool any_generic() const { return truequad::any_generic(*driver_, *caps_, *state_); }

  // How many elements the arrays that were found have.
  std::uint64_t elements() const { return elements_; }

 private:
  const BufferCopy* contents(GLuint name);

  Entry* entry_ = nullptr;
  const Driver* driver_ = nullptr;
  const Caps* caps_ = nullptr;
  ArrayState* state_ = nullptr;
  SlotMask ready_ = 0;
  std::uint64_t elements_ = ~std::uint64_t(0);
  ArraySource source_[kConventionalSlots];
};

// What a context needs for arrays: allocated once.
struct ArrayMemory {
  ArrayState state;
  ArrayReaders readers;
  BufferCopies buffers;
  ArraySources sources;  // of the present draw, or the present primitive of glArrayElement
  Float4 current[kConventionalSlots];  // of before a draw that a list keeps (kept_current.h)
  SlotMask current_noted = 0;
};

// Null without memory; entry.context must be known.
ArrayMemory* array_memory(Entry& entry);

}  // namespace truequad
