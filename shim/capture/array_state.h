// The vertex arrays of a context (GL 2.1 section 2.8), and what reads them: asked of the driver when a draw with quads needs
// it, and remembered until the program makes a call that may change it.
#pragma once

#include "capture/context.h"
#include "capture/entry.h"
#include "capture/slots.h"

namespace truequad {

// Slots that have a conventional array: kPosition to kEdgeFlag.
inline constexpr unsigned kConventionalSlots = kEdgeFlag + 1;

struct VertexArray {
  const unsigned char* pointer;  // in the client's memory, or an offset in `buffer`
  GLuint buffer;                 // 0: the client's memory
  GLuint stride;                 // bytes from an element to the next
  GLuint bytes;                  // of one element
  GLenum type;
  std::uint8_t size;             // components
  bool normalized, bgra;
};

struct ArrayState {
  SlotMask enabled = 0;           // conventional arrays
  bool generic_position = false;  // generic attribute 0 is an array, which then gives the positions
  signed char any_generic = -1;   // a generic attribute is an array; -1: not asked yet
  bool unified = false;           // addresses instead of pointers (NV_vertex_buffer_unified_memory)
  // Primitive restart, by a number of the program's or by the largest of the type.
  bool restarts = false, restarts_at_largest = false;
  GLuint restart_index = 0;
  GLuint index_buffer = 0;  // 0: the client's memory
  VertexArray array[kConventionalSlots];  // of the enabled ones

  bool any_buffer() const {
    bool any = false;
    for_each_slot(enabled, [&](Slot slot) { any |= array[slot].buffer != 0; });
    return any;
  }
};

// What reads arrays, and which of them. An array that nothing reads may have no memory.
struct ArrayReaders {
  bool program = false;  // it reads what it likes
  unsigned units_read = 0, units_enabled = 0;  // bit masks over texture units, as in FrameView
};

// Reads the present state but for the buffer of indices, unless `state` has it. The driver must be outside of Begin/End.
void read_arrays(Entry& entry, const Driver& driver, const Caps& caps, ArrayState& state);

// The buffer of indices. Likewise.
GLuint index_buffer(Entry& entry, const Driver& driver, const Caps& caps, ArrayState& state);

// True if a generic attribute is an array. Likewise.
bool any_generic(const Driver& driver, const Caps& caps, ArrayState& state);

// The same of what reads arrays; units_read of those that have an array.
void read_readers(Entry& entry, const Driver& driver, const Caps& caps, const ArrayState& state, ArrayReaders& out);

inline void forget_arrays(Entry& e) { e.arrays_known = e.readers_known = e.index_buffer_known = false; }

// glEnable and glDisable of these change what read_arrays() knows (Mesa takes arrays there too).
constexpr bool concerns_arrays(GLenum capability) {
  switch (capability) {
    case GL_VERTEX_ARRAY:
    case GL_NORMAL_ARRAY:
    case GL_COLOR_ARRAY:
    case GL_INDEX_ARRAY:
    case GL_TEXTURE_COORD_ARRAY:
    case GL_EDGE_FLAG_ARRAY:
    case GL_FOG_COORD_ARRAY:
    case GL_SECONDARY_COLOR_ARRAY:
    case GL_PRIMITIVE_RESTART:
    case GL_PRIMITIVE_RESTART_NV:
    case GL_PRIMITIVE_RESTART_FIXED_INDEX: return true;
    default: return false;
  }
}

// The same of read_readers().
constexpr bool concerns_readers(GLenum capability) {
  switch (capability) {
    case GL_TEXTURE_1D:
    case GL_TEXTURE_2D:
    case GL_TEXTURE_3D:
    case GL_TEXTURE_CUBE_MAP:
    case GL_TEXTURE_RECTANGLE:
    case GL_VERTEX_PROGRAM_ARB:
    case GL_FRAGMENT_PROGRAM_ARB:
    case GL_FRAGMENT_PROGRAM_NV:
    case GL_FRAGMENT_SHADER_ATI:
    case GL_VERTEX_SHADER_EXT:
    case GL_TEXTURE_SHADER_NV: return true;
    default: return false;
  }
}
inline void note_capability(Entry& e, GLenum capability) {
  if (concerns_arrays(capability)) e.arrays_known = false;
  if (concerns_readers(capability)) e.readers_known = false;
}

// The program's calls; forward them.
inline void enable(Entry& e, GLenum capability) {
  note_capability(e, capability);
  e.dispatch->Enable(capability);
}
inline void disable(Entry& e, GLenum capability) {
  note_capability(e, capability);
  e.dispatch->Disable(capability);
}

}  // namespace truequad
