// Draws at the edges of what is defined: commands in memory and in buffers, right and wrong, indices beyond the arrays of a
// buffer, and arrays that are enabled where there is no memory and the draw does not read them.
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "execute.h"

namespace truequad::fuzz {
namespace {

GLenum mode(Random& random) { return pick(random, GL_QUADS, GL_QUADS, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON, GL_TRIANGLES); }

// A buffer of this name, with these contents, as an edge has them: what was bound is bound again.
constexpr GLuint kCommands = 11, kElements = 12;

GLint bound(GLenum binding) {
  GLint name = 0;
  gl.GetIntegerv(binding, &name);
  return name;
}

void fill(GLenum target, GLuint name, const void* bytes, std::size_t size) {
  GL(BindBuffer, target, name);
  GL(BufferData, target, GLsizeiptr(size), bytes, GLenum(GL_STATIC_DRAW));
}

void draw_indirect(Random& random) {
  // "count, instanceCount, first, baseInstance" and "count, instanceCount, firstIndex, baseVertex, baseInstance" (GL 4.6
  // compatibility section 10.4), for two draws.
  static GLuint commands[2][5];
  const bool indexed = random.chance(40), in_buffer = random.chance(60);
  const GLsizei stride = random.of({20, 20, 20, 0, 24, 2, -4});
  for (auto& command : commands) {
    command[0] = GLuint(4 * random.below(5));
    command[1] = GLuint(random.of({1, 1, 1, 2, 0}));
    command[2] = GLuint(4 * random.below(6));
    command[3] = command[4] = 0;
  }
  for (const auto& command : commands) print_note("command %u %u %u %u %u", command[0], command[1], command[2], command[3], command[4]);
  const void* from = commands;
  if (in_buffer) {
    fill(GL_DRAW_INDIRECT_BUFFER, kCommands, commands, sizeof commands);
    from = reinterpret_cast<const void*>(std::uintptr_t(random.of({0, 0, 0, 20, 2, 400})));
  }
  const GLint elements = bound(GL_ELEMENT_ARRAY_BUFFER_BINDING);
  if (indexed) {
    static GLushort indices[64];
    for (int i = 0; i < 64; ++i) indices[i] = GLushort(i % 48);
    if (random.chance(90)) fill(GL_ELEMENT_ARRAY_BUFFER, kElements, indices, sizeof indices);
    const GLenum type = pick(random, GL_UNSIGNED_SHORT);
    if (random.chance(50)) GL(DrawElementsIndirect, mode(random), type, from);
    else GL(MultiDrawElementsIndirect, mode(random), type, from, random.of({2, 1, 0, -1}), stride);
    GL(BindBuffer, GLenum(GL_ELEMENT_ARRAY_BUFFER), GLuint(elements));
  } else {
    if (random.chance(50)) GL(DrawArraysIndirect, mode(random), from);
    else GL(MultiDrawArraysIndirect, mode(random), from, random.of({2, 1, 0, -1}), stride);
  }
  if (in_buffer) GL(BindBuffer, GLenum(GL_DRAW_INDIRECT_BUFFER), 0u);
}

// What lies beyond a buffer is the driver's to say; both runs ask the same driver.
void far_indices(Random& random) {
  static const GLuint indices[2][8] = {{0, 1, 2, 100000, 4, 5, 6, 7}, {100000, 100001, 100002, 100003, 8, 9, 10, 11}};
  const GLint arrays = bound(GL_ARRAY_BUFFER_BINDING), elements = bound(GL_ELEMENT_ARRAY_BUFFER_BINDING);
  fill(GL_ELEMENT_ARRAY_BUFFER, kElements, indices, sizeof indices);
  GL(BindBuffer, GLenum(GL_ARRAY_BUFFER), 1u);
  GL(VertexPointer, 3, GLenum(GL_FLOAT), 0, nullptr);
  GL(EnableClientState, GLenum(GL_VERTEX_ARRAY));
  GL(DisableClientState, GLenum(GL_TEXTURE_COORD_ARRAY));
  for (GLenum array : {GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_EDGE_FLAG_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY}) GL(DisableClientState, array);
  switch (random.below(3)) {
    case 0: GL(DrawElements, mode(random), 8, GLenum(GL_UNSIGNED_INT), reinterpret_cast<const void*>(std::uintptr_t(random.of({0, 32})))); break;
    case 1: GL(DrawElementsBaseVertex, mode(random), 8, GLenum(GL_UNSIGNED_INT), nullptr, random.of({0, 1 << 20, 1 << 30})); break;
    default: GL(DrawElements, mode(random), 8, GLenum(GL_UNSIGNED_INT), reinterpret_cast<const void*>(std::uintptr_t(4096)));
  }
  GL(VertexPointer, 3, GLenum(GL_FLOAT), 0, nullptr);
  GL(BindBuffer, GLenum(GL_ARRAY_BUFFER), GLuint(arrays));
  GL(BindBuffer, GLenum(GL_ELEMENT_ARRAY_BUFFER), GLuint(elements));
}

// Memory that nobody may touch.
void* nowhere() {
  static void* const pages = ::mmap(nullptr, std::size_t(1) << 16, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return pages;
}

void arrays_nowhere(Random& random) {
  if (bound(GL_ARRAY_BUFFER_BINDING) != 0) return;
  const bool disabled = random.chance(50);
  switch (random.below(4)) {
    case 0: GL(NormalPointer, GLenum(GL_FLOAT), 0, nowhere()); GL(DisableClientState, GLenum(GL_NORMAL_ARRAY)); break;
    case 1: GL(SecondaryColorPointer, 3, GLenum(GL_UNSIGNED_BYTE), 4, nowhere()); GL(DisableClientState, GLenum(GL_SECONDARY_COLOR_ARRAY)); break;
    case 2: GL(IndexPointer, GLenum(GL_FLOAT), 0, nowhere()); if (disabled) GL(DisableClientState, GLenum(GL_INDEX_ARRAY)); else GL(EnableClientState, GLenum(GL_INDEX_ARRAY)); break;
    default: {
      // Of a unit that is not enabled.
      GL(ClientActiveTexture, GLenum(GL_TEXTURE0 + kUnits));
      GL(TexCoordPointer, 2, GLenum(GL_FLOAT), 0, nowhere());
      if (!disabled) GL(EnableClientState, GLenum(GL_TEXTURE_COORD_ARRAY));
      GL(ClientActiveTexture, GLenum(GL_TEXTURE0));
    }
  }
}

}  // namespace

void execute_edges(const Op& op) {
  Random random(op.seed);
  switch (op.step) {
    case Step::kDrawIndirect: return draw_indirect(random);
    case Step::kFarIndices: return far_indices(random);
    default: return arrays_nowhere(random);
  }
}

}  // namespace truequad::fuzz
