// Vertex arrays in client memory and in buffer objects, right and wrong. What is read beyond the filled part of the arena
// is defined too: it is zero.
#include <cstring>

#include "execute.h"

namespace truequad::fuzz {
namespace {

constexpr int kVertices = 64;
constexpr int kSlab = 2048;  // kVertices of the longest type
constexpr int kTexturePlaces = 12 * kSlab, kColors = 24 * kSlab, kInterleaved = 26 * kSlab, kIndices = 28 * kSlab;
constexpr GLsizeiptr kBufferSize = 30 * kSlab;
constexpr GLenum kTypes[] = {GL_FLOAT, GL_SHORT, GL_INT, GL_DOUBLE};
constexpr int kTypeSize[] = {4, 2, 4, 8};

int slab(int type, int size) { return (type * 3 + size - 2) * kSlab; }

void put_number(int place, int type, int value) {
  const GLfloat as_float = GLfloat(value);
  const GLshort as_short = GLshort(value);
  const GLint as_int = value;
  const GLdouble as_double = value;
  const void* from[] = {&as_float, &as_short, &as_int, &as_double};
  std::memcpy(arena + place, from[type], std::size_t(kTypeSize[type]));
}

bool bound(GLenum binding) {
  GLint name = 0;
  if (gl.GetIntegerv) gl.GetIntegerv(binding, &name);
  return name != 0;
}

// Into the arena, or into the buffer that is bound.
const void* pointer_to(int place, bool to_buffer) {
  return to_buffer ? reinterpret_cast<const void*>(std::uintptr_t(place)) : arena + place;
}

// A call inside Begin/End must not be looked at by asking first: then the arena is meant.
bool array_buffer(const Player&) { return bound(GL_ARRAY_BUFFER_BINDING); }

void pointer(const Op& op, Random& random, const Player& player) {
  const int type = random.below(4), size = 2 + random.below(3), stride = random.of({0, 0, 0, kTypeSize[type] * size, kTypeSize[type] * size * 2});
  const bool to_buffer = array_buffer(player);
  const int what = op.index == 0 ? 0 : random.below(12);
  const auto place = [&](int at) { return pointer_to(at, to_buffer); };
  const GLsizei step = random.chance(2) ? -1 : stride;
  GLenum enabled = 0;
  switch (what) {
    case 0: case 1: GL(VertexPointer, random.chance(2) ? 5 : size, kTypes[type], step, place(slab(type, size))); enabled = GL_VERTEX_ARRAY; break;
    case 2: case 3: case 4:
      GL(TexCoordPointer, size, kTypes[type], step, place(kTexturePlaces + slab(type, size)));
      enabled = GL_TEXTURE_COORD_ARRAY;
      break;
    case 5: GL(ColorPointer, random.of<GLint>({3, 4, 4, GL_BGRA}), GL_UNSIGNED_BYTE, random.of({4, 0}), place(kColors)); enabled = GL_COLOR_ARRAY; break;
    case 6: GL(ColorPointer, 4, GL_FLOAT, 0, place(kColors)); enabled = GL_COLOR_ARRAY; break;
    case 7: GL(NormalPointer, kTypes[type], 0, place(slab(type, 3))); enabled = GL_NORMAL_ARRAY; break;
    case 8: GL(EdgeFlagPointer, 1, place(kColors)); enabled = GL_EDGE_FLAG_ARRAY; break;
    case 9: GL(SecondaryColorPointer, 3, GL_UNSIGNED_BYTE, 4, place(kColors)); enabled = GL_SECONDARY_COLOR_ARRAY; break;
    case 10: GL(FogCoordPointer, GL_FLOAT, 4, place(kTexturePlaces)); enabled = GL_FOG_COORD_ARRAY; break;
    default: {
      const GLuint attribute = GLuint(random.of({0, 1, 8, 9, 99}));
      GL(VertexAttribPointer, attribute, size, kTypes[type], GLboolean(0), 0, place(slab(type, size)));
      if (random.chance(50)) GL(EnableVertexAttribArray, attribute);
      return;
    }
  }
  if (op.warp & 1 || random.chance(60)) GL(EnableClientState, enabled);
}

void client_state(Random& random) {
  switch (random.below(6)) {
    case 0: return GL(ClientActiveTexture, GL_TEXTURE0 + GLuint(random.chance(5) ? 99 : random.below(kUnits)));
    case 1: return random.chance(50) ? GL(EnableVertexAttribArray, GLuint(random.below(3))) : GL(DisableVertexAttribArray, GLuint(random.below(3)));
    case 2: return GL(DisableClientState, pick(random, GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY));
    default: return GL(DisableClientState, pick(random, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_NORMAL_ARRAY, GL_EDGE_FLAG_ARRAY,
                                                GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY, GL_INDEX_ARRAY));
  }
}

GLenum draw_mode(Random& random) {
  return pick(random, GL_QUADS, GL_QUADS, GL_QUADS, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON, GL_TRIANGLES, GL_LINES, GL_POINTS);
}

int draw_count(Random& random) {
  if (random.chance(3)) return random.of({-1, 0});
  return random.chance(80) ? 4 * (1 + random.below(6)) : random.below(30);
}

void draw_arrays(Random& random) {
  static GLint firsts[3];
  static GLsizei counts[3];
  for (int i = 0; i < 3; ++i) firsts[i] = 4 * random.below(6), counts[i] = 4 * random.below(4);
  const GLenum mode = draw_mode(random);
  switch (random.below(8)) {
    case 0: return GL(MultiDrawArrays, mode, firsts, counts, random.of({3, 1, 0, 2}));
    case 1: return GL(DrawArraysInstanced, mode, 4 * random.below(5), draw_count(random), random.of({1, 2, 0}));
    default: return GL(DrawArrays, mode, random.chance(2) ? -1 : random.below(8) * (random.chance(70) ? 4 : 1), draw_count(random));
  }
}

void draw_elements(Random& random) {
  const int type = random.below(3);
  const GLenum types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};
  const int places[] = {kIndices, kIndices + 256, kIndices + 768}, sizes[] = {1, 2, 4};
  const GLenum index_type = random.chance(2) ? GLenum(GL_FLOAT) : types[type];
  const int place = places[type] + sizes[type] * (random.chance(80) ? 4 * random.below(16) : random.below(64));
  const GLenum mode = draw_mode(random);
  const void* const indices = pointer_to(place, bound(GL_ELEMENT_ARRAY_BUFFER_BINDING));
  const GLsizei count = draw_count(random);
  static const void* many[2];
  static GLsizei counts[2];
  switch (random.below(9)) {
    case 0: return GL(DrawRangeElements, mode, 0u, random.of({63u, 63u, 5u}), count, index_type, indices);
    case 1: return GL(DrawElementsBaseVertex, mode, count, index_type, indices, random.of({0, 4, 1}));
    case 2: return GL(DrawElementsInstanced, mode, count, index_type, indices, random.below(3));
    case 3:
      many[0] = many[1] = indices;
      counts[0] = 4, counts[1] = 8;
      return GL(MultiDrawElements, mode, counts, index_type, many, random.below(3));
    default: return GL(DrawElements, mode, count, index_type, indices);
  }
}

// "The current values are indeterminate after" a draw from arrays (GL 2.1 section 2.8): in lists Mesa leaves those of the
// last element.
void set_all_values(Player& player) {
  note_values(player, kAllValues);
  set_values(kAllValues);
}

void buffer(Random& random, Player& player) {
  const GLenum target = pick(random, GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER);
  static GLuint name;
  switch (random.below(9)) {
    case 0: case 1: case 2: GL(BindBuffer, target, name = GLuint(random.below(3))); return GL(BufferData, target, kBufferSize, arena, pick(random, GL_STATIC_DRAW, GL_STREAM_DRAW));
    case 3: return GL(BindBuffer, target, GLuint(random.below(3)));
    case 4: return GL(BufferSubData, target, random.of<GLintptr>({0, kTexturePlaces, 100, -4}), random.of<GLsizeiptr>({64, 512, kBufferSize}), arena + 4 * kSlab);
    case 5:
      // Arrays in a buffer that is deleted lie in client memory at a small address then, from where Mesa reads.
      name = 3;
      player.mapped = nullptr;
      return GL(DeleteBuffers, 1, &name);
    case 6: return GL(CopyBufferSubData, GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, 0, 0, 256);
    case 7: return GL(InvalidateBufferData, GLuint(5));
    default: return GL(BindBuffer, target, 0u);
  }
}

void map_buffer(Random& random, Player& player) {
  if (player.mapped) {
    const std::int64_t at = random.below(int(player.mapped_size / 2));
    std::memcpy(static_cast<char*>(player.mapped) + at, arena + 300, std::size_t(player.mapped_size - at < 64 ? player.mapped_size - at : 64));
    if (random.chance(60)) {
      player.mapped = nullptr;
      record("UnmapBuffer: %d", GL(UnmapBuffer, GL_ARRAY_BUFFER));
    }
    return;
  }
  void* mapped;
  std::int64_t size = kBufferSize;
  // Nothing may be mapped while the size is unknown: only buffers that this program has filled are long enough.
  GLint length = 0;
  if (gl.GetBufferParameteriv && bound(GL_ARRAY_BUFFER_BINDING)) gl.GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &length);
  if (random.chance(50)) {
    mapped = GL(MapBuffer, GL_ARRAY_BUFFER, pick(random, GL_WRITE_ONLY, GL_READ_WRITE));
  } else {
    size = 1024;
    mapped = GL(MapBufferRange, GL_ARRAY_BUFFER, GLintptr(random.below(3)) * 1024, GLsizeiptr(1024), GLbitfield(GL_MAP_WRITE_BIT));
  }
  record("MapBuffer: %d", mapped != nullptr);
  if (mapped && length >= size) player.mapped = mapped, player.mapped_size = size;
}

}  // namespace

void set_values(unsigned values) {
  if (values & kColours) GL(Color4f, 1.0f, 0.5f, 0.25f, 1.0f);
  if (values & kTextures) {
    for (int unit = 0; unit < kUnits; ++unit) GL(MultiTexCoord4f, GL_TEXTURE0 + GLuint(unit), 0.0f, 0.0f, 0.0f, 1.0f);
  }
  if (!(values & kOtherValues)) return;
  GL(SecondaryColor3f, 0.0f, 0.0f, 0.0f);
  GL(Normal3f, 0.0f, 0.0f, 1.0f);
  GL(FogCoordf, 0.0f);
  GL(EdgeFlag, GLboolean(1));
  GL(Indexf, 1.0f);
  for (GLuint attribute : {1u, 8u, 9u}) GL(VertexAttrib4f, attribute, 0.0f, 0.0f, 0.0f, 1.0f);
}

// Arrays that are enabled without a pointer are read from null by Mesa.
void point_arrays() {
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  for (GLuint name : {1u, 2u, 0u}) {
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    if (name) gl.BufferData(GL_ARRAY_BUFFER, kBufferSize, arena, GL_STATIC_DRAW);
  }
  for (int unit = kUnits - 1; unit >= 0; --unit) {
    gl.ClientActiveTexture(GL_TEXTURE0 + GLuint(unit));
    gl.TexCoordPointer(2, GL_FLOAT, 0, arena + kTexturePlaces);
  }
  gl.VertexPointer(2, GL_FLOAT, 0, arena);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, arena + kColors);
  gl.NormalPointer(GL_FLOAT, 0, arena + slab(0, 3));
  gl.EdgeFlagPointer(1, arena + kColors);
  gl.SecondaryColorPointer(3, GL_UNSIGNED_BYTE, 4, arena + kColors);
  gl.FogCoordPointer(GL_FLOAT, 4, arena + kTexturePlaces);
  gl.IndexPointer(GL_FLOAT, 0, arena);
  for (GLuint attribute = 0; attribute < 16; ++attribute) gl.VertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, 0, arena + slab(0, 4));
}

void fill_arena() {
  for (int vertex = 0; vertex < kVertices; ++vertex) {
    const Corner c = corner(1000u + unsigned(vertex / 4), vertex % 4, vertex < kVertices / 2 ? 0u : 1u << (vertex / 4 % 3));
    for (int type = 0; type < 4; ++type) {
      for (int size = 2; size <= 4; ++size) {
        const int position[] = {c.x, c.y, c.z, 1}, texture[] = {c.s, c.t, 0, 1};
        for (int i = 0; i < size; ++i) {
          put_number(slab(type, size) + (vertex * size + i) * kTypeSize[type], type, position[i]);
          put_number(kTexturePlaces + slab(type, size) + (vertex * size + i) * kTypeSize[type], type, texture[i]);
        }
      }
    }
    const int interleaved[] = {c.s, c.t, c.x, c.y, c.z};
    for (int i = 0; i < 5; ++i) put_number(kInterleaved + (vertex * 5 + i) * 4, 0, interleaved[i]);
    for (int i = 0; i < 4; ++i) arena[kColors + vertex * 4 + i] = (unsigned char)(i == 3 ? 255 : vertex * 37 * (i + 1));
    const int index = vertex < 48 ? vertex : (vertex * 11) % 53;
    arena[kIndices + vertex] = (unsigned char)index;
    const GLushort as_short = GLushort(index);
    const GLuint as_int = GLuint(index);
    std::memcpy(arena + kIndices + 256 + 2 * vertex, &as_short, 2);
    std::memcpy(arena + kIndices + 768 + 4 * vertex, &as_int, 4);
  }
}

void execute_arrays(const Op& op, Player& player) {
  Random random(op.seed);
  switch (op.step) {
    case Step::kPointer: return pointer(op, random, player);
    case Step::kClientState: return client_state(random);
    case Step::kDrawArrays: case Step::kDrawElements:
      // Mesa leaves out, or refuses, what comes after such a draw (README.md).
      if (op.index != 0 && player.compiled && player.colours_grew) return;
      if (op.index != 0) settle_values(player);
      op.step == Step::kDrawArrays ? draw_arrays(random) : draw_elements(random);
      if (op.index != 0) set_all_values(player);
      return;
    case Step::kArrayElement: return GL(ArrayElement, random.below(34));
    case Step::kInterleaved:
      return GL(InterleavedArrays, pick(random, GL_T2F_V3F, GL_T2F_V3F, GL_V2F, GL_V3F), random.of({0, 0, 20, -1}),
                pointer_to(kInterleaved, array_buffer(player)));
    case Step::kBuffer: return buffer(random, player);
    case Step::kMapBuffer: return map_buffer(random, player);
    case Step::kVertexArray: return GL(BindVertexArray, GLuint(random.below(2)));
    case Step::kRestart:
      if (random.chance(50)) return GL(PrimitiveRestartIndex, GLuint(random.of({4, 8, 255})));
      return random.chance(40) ? GL(Enable, GL_PRIMITIVE_RESTART) : GL(Disable, GL_PRIMITIVE_RESTART);
    default: return random.chance(50) ? GL(LockArraysEXT, 0, 64) : GL(UnlockArraysEXT);
  }
}

}  // namespace truequad::fuzz
