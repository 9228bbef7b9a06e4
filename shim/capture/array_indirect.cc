// Draws whose counts are in memory (GL 4.6 compatibility section 10.4: DrawArraysIndirect …): taken for the draws that they
// stand for.
#include <cstring>

#include "capture/array_sources.h"
#include "capture/arrays.h"
#include "capture/lists.h"
#include "capture/quads.h"
#include "capture/view.h"

namespace truequad {
namespace {

// "typedef struct { uint count; uint instanceCount; uint first; uint baseInstance; } DrawArraysIndirectCommand", and with
// indices "… uint firstIndex; int baseVertex; uint baseInstance".
struct Command {
  GLuint count, instances, first;
  GLint base;
};

// False: the driver has to say what is wrong, or the contents cannot be known.
bool read_command(Entry& e, const void* from, bool indexed, Command& out) {
  const std::size_t size = (indexed ? 5 : 4) * sizeof(GLuint);
  const auto* bytes = static_cast<const unsigned char*>(from);
  GLint buffer = 0;
  e.driver->GetIntegerv(GL_DRAW_INDIRECT_BUFFER_BINDING, &buffer);
  if (buffer != 0) {
    const std::uint64_t offset = reinterpret_cast<std::uintptr_t>(from);
    if (may_be_deleted_in_context(*e.context, GLuint(buffer))) return false;
    const BufferCopy* const copy = e.context->arrays->buffers.contents(*e.driver, *e.context, GLuint(buffer));
    if (!copy || offset > copy->size || size > copy->size - offset) return false;
    bytes = copy->bytes + offset;
  }
  if (!bytes || reinterpret_cast<std::uintptr_t>(from) % sizeof(GLuint) != 0) return false;
  std::memcpy(&out, bytes, sizeof out);
  constexpr GLuint kMost = 0x7fffffff;
  return out.count <= kMost && out.instances <= kMost && (indexed || out.first <= kMost);
}

bool draw(Entry& e, GLenum mode, GLenum type, const void* from) {
  Command command;
  if (!read_command(e, from, type != 0, command)) return false;
  const GLsizei count = GLsizei(command.count);
  ArrayDraw draw{.mode = mode, .count = &count, .instances = GLsizei(command.instances)};
  if (type == 0) {
    const GLint first = GLint(command.first);
    draw.first = &first;
    return draw_quads(e, draw);
  }
  // "If no element array buffer is bound, an INVALID_OPERATION error is generated."
  GLint elements = 0;
  e.driver->GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &elements);
  if (elements == 0) return false;
  const void* const indices = reinterpret_cast<const void*>(std::uintptr_t(command.first) * index_bytes(type));
  draw.type = type;
  draw.indices = &indices;
  draw.base = command.base != 0 ? &command.base : nullptr;
  return draw_quads(e, draw);
}

void draw_own(const Driver& driver, GLenum mode, GLenum type, const void* from) {
  type == 0 ? driver.DrawArraysIndirect(mode, from) : driver.DrawElementsIndirect(mode, type, from);
}

}  // namespace

bool draw_indirect_quads(Entry& e, GLenum mode, GLenum type, const void* from, GLsizei draws, GLsizei stride) {
  if (e.list || !e.context || !e.context->group || draws <= 0 || stride < 0 || stride % 4 != 0) return false;
  if (type != 0 && index_bytes(type) == 0) return false;
  if (!capturing_thread(e) || !array_memory(e)) return false;
  const Caps& caps = caps_of(*e.context, *e.driver);
  if (!caps.supported || caps.version < 40) return false;
  const std::size_t step = stride != 0 ? std::size_t(stride) : (type != 0 ? 5 : 4) * sizeof(GLuint);
  const auto at = [&](GLsizei i) { return static_cast<const unsigned char*>(from) + std::size_t(i) * step; };
  // Programs draw by the thousands this way; of fixed function one by one is as good.
  if (program_bound(*e.driver, caps)) return false;
  e.context->arrays->buffers.start();
  if (draws == 1) return draw(e, mode, type, from);
  for (GLsizei i = 0; i < draws; ++i) {
    if (!draw(e, mode, type, at(i))) draw_own(*e.driver, mode, type, at(i));
  }
  return true;
}

}  // namespace truequad
