#include "capture/array_state.h"

#include "capture/view.h"

namespace truequad {
namespace {

GLint get(const Driver& driver, GLenum name) {
  GLint value = 0;
  driver.GetIntegerv(name, &value);
  return value;
}

// Queries of one array; 0: it has no such parameter.
struct Names {
  GLenum array, size, type, stride, buffer, pointer;
};
constexpr Names kTextureNames = {GL_TEXTURE_COORD_ARRAY,        GL_TEXTURE_COORD_ARRAY_SIZE,
                                 GL_TEXTURE_COORD_ARRAY_TYPE,   GL_TEXTURE_COORD_ARRAY_STRIDE,
                                 GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, GL_TEXTURE_COORD_ARRAY_POINTER};

constexpr Names names_of(Slot slot) {
  switch (slot) {
    case kPosition:
      return {GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
              GL_VERTEX_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_POINTER};
    case kColor:
      return {GL_COLOR_ARRAY, GL_COLOR_ARRAY_SIZE, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE,
              GL_COLOR_ARRAY_BUFFER_BINDING, GL_COLOR_ARRAY_POINTER};
    case kSecondaryColor:
      return {GL_SECONDARY_COLOR_ARRAY,        GL_SECONDARY_COLOR_ARRAY_SIZE,
              GL_SECONDARY_COLOR_ARRAY_TYPE,   GL_SECONDARY_COLOR_ARRAY_STRIDE,
              GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, GL_SECONDARY_COLOR_ARRAY_POINTER};
    case kNormal:
      return {GL_NORMAL_ARRAY, 0, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, GL_NORMAL_ARRAY_BUFFER_BINDING,
              GL_NORMAL_ARRAY_POINTER};
    case kFogCoord:
      return {GL_FOG_COORD_ARRAY, 0, GL_FOG_COORD_ARRAY_TYPE, GL_FOG_COORD_ARRAY_STRIDE,
              GL_FOG_COORD_ARRAY_BUFFER_BINDING, GL_FOG_COORD_ARRAY_POINTER};
    case kIndex:
      return {GL_INDEX_ARRAY, 0, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE, GL_INDEX_ARRAY_BUFFER_BINDING,
              GL_INDEX_ARRAY_POINTER};
    case kEdgeFlag:
      return {GL_EDGE_FLAG_ARRAY, 0, 0, GL_EDGE_FLAG_ARRAY_STRIDE, GL_EDGE_FLAG_ARRAY_BUFFER_BINDING,
              GL_EDGE_FLAG_ARRAY_POINTER};
    default: return kTextureNames;
  }
}

// Table 2.4 and ARB_half_float_vertex, ARB_vertex_type_2_10_10_10_rev. 0: not a type of arrays.
GLuint element_bytes(GLenum type, GLuint size) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return size;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT: return 2 * size;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FIXED:
    case GL_FLOAT: return 4 * size;
    case GL_DOUBLE: return 8 * size;
    case GL_INT_2_10_10_10_REV:
    case GL_UNSIGNED_INT_2_10_10_10_REV: return 4;
    default: return 0;
  }
}

void read_array(const Driver& driver, const Caps& caps, Slot slot, ArrayState& out) {
  const Names names = names_of(slot);
  if (!driver.IsEnabled(names.array)) return;
  out.enabled |= bit(slot);
  VertexArray& array = out.array[slot];
  const GLint size = names.size ? get(driver, names.size) : slot == kNormal ? 3 : 1;
  array.bgra = size == GL_BGRA;
  array.size = std::uint8_t(array.bgra ? 4 : size);
  // Edge flags are booleans.
  array.type = names.type ? GLenum(get(driver, names.type)) : GL_UNSIGNED_BYTE;
  array.normalized = slot == kColor || slot == kSecondaryColor || slot == kNormal;
  array.bytes = element_bytes(array.type, array.size);
  // "A value of zero specifies that array elements are stored sequentially" (section 2.8).
  const GLint stride = get(driver, names.stride);
  array.stride = stride != 0 ? GLuint(stride) : array.bytes;
  // An error, and yet Mesa keeps it and reads backwards: no array that we read.
  if (stride < 0) array.bytes = 0;
  array.buffer = caps.buffers ? GLuint(get(driver, names.buffer)) : 0;
  void* pointer = nullptr;
  driver.GetPointerv(names.pointer, &pointer);
  array.pointer = static_cast<const unsigned char*>(pointer);
}

void select_unit(const Driver& driver, const Caps& caps, GLenum texture) {
  caps.multitexture_core ? driver.ClientActiveTexture(texture) : driver.ClientActiveTextureARB(texture);
}

void read_textures(const Driver& driver, const Caps& caps, ArrayState& out) {
  if (!caps.multitexture) return read_array(driver, caps, kTexture, out);
  const GLenum before = GLenum(get(driver, GL_CLIENT_ACTIVE_TEXTURE));
  GLenum now = before;
  const unsigned units = caps.texture_coords < kTextureUnits ? caps.texture_coords : kTextureUnits;
  for (unsigned unit = 0; unit < units; ++unit) {
    const GLenum texture = GL_TEXTURE0 + unit;
    if (now != texture) select_unit(driver, caps, now = texture);
    read_array(driver, caps, kTexture + unit, out);
  }
  if (now != before) select_unit(driver, caps, before);
}

bool is_generic(const Driver& driver, const Caps& caps, GLuint attribute) {
  GLint generic = 0;
  if (caps.generic_attributes_core) driver.GetVertexAttribiv(attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &generic);
  else if (caps.vertex_program_arb) driver.GetVertexAttribivARB(attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &generic);
  return generic != 0;
}

void read_restart(const Driver& driver, const Caps& caps, ArrayState& out) {
  if (caps.restart_core) out.restarts = driver.IsEnabled(GL_PRIMITIVE_RESTART);
  if (caps.restart_nv) out.restarts |= driver.IsEnabled(GL_PRIMITIVE_RESTART_NV) != GL_FALSE;
  if (out.restarts) {
    out.restart_index = GLuint(get(driver, caps.restart_core ? GL_PRIMITIVE_RESTART_INDEX : GL_PRIMITIVE_RESTART_INDEX_NV));
  }
  // "If both … are enabled, the fixed index is used" (GL 4.3 section 10.3.6).
  out.restarts_at_largest = caps.restart_fixed && driver.IsEnabled(GL_PRIMITIVE_RESTART_FIXED_INDEX);
}

}  // namespace

void read_arrays(Entry& e, const Driver& driver, const Caps& caps, ArrayState& out) {
  if (e.arrays_known) return;
  out.enabled = 0;
  out.restarts = out.restarts_at_largest = false;
  for (const Slot slot : {kPosition, kColor, kNormal, kIndex, kEdgeFlag}) read_array(driver, caps, slot, out);
  if (caps.secondary_color) read_array(driver, caps, kSecondaryColor, out);
  if (caps.fog_coord) read_array(driver, caps, kFogCoord, out);
  read_textures(driver, caps, out);
  read_restart(driver, caps, out);
  out.generic_position = is_generic(driver, caps, 0);
  out.any_generic = -1;
  out.unified = caps.unified_memory && driver.IsEnabled(GL_VERTEX_ATTRIB_ARRAY_UNIFIED_NV);
  e.arrays_known = true;
}

GLuint index_buffer(Entry& e, const Driver& driver, const Caps& caps, ArrayState& state) {
  if (!e.index_buffer_known) {
    state.index_buffer = caps.buffers ? GLuint(get(driver, GL_ELEMENT_ARRAY_BUFFER_BINDING)) : 0;
    e.index_buffer_known = true;
  }
  return state.index_buffer;
}

void read_readers(Entry& e, const Driver& driver, const Caps& caps, const ArrayState& state, ArrayReaders& out) {
  if (!e.readers_known) {
    out = {};
    out.program = program_bound(driver, caps);
    e.readers_known = true;
  }
  const unsigned units = unsigned((state.enabled & kTextureSlots) >> kTexture);
  if (out.program || !(units & ~out.units_read)) return;
  FrameView view;
  view.units_read = out.units_read;
  read_units(driver, caps, units, view);
  out.units_read = view.units_read;
  out.units_enabled |= view.units_enabled;
}

bool any_generic(const Driver& driver, const Caps& caps, ArrayState& state) {
  if (state.any_generic < 0) {
    state.any_generic = 0;
    for (GLuint i = 0; i < kGenericAttributes; ++i) state.any_generic |= is_generic(driver, caps, i);
  }
  return state.any_generic != 0;
}

}  // namespace truequad
