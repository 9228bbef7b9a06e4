// Display lists, and the numbers that they have.
#include <cstring>

#include "execute.h"

namespace truequad::fuzz {

GLuint list_name(Random& random, const Player& player) {
  if (player.generated_count > 0 && random.chance(15)) {
    return player.generated[random.below(player.generated_count)] + GLuint(random.below(2));
  }
  if (random.chance(2)) return random.of<GLuint>({0, 1000, 0x7fffffff, 0xffffffff});
  return GLuint(1 + random.below(6));
}

namespace {

template <typename T>
void put(unsigned char* to, T value) {
  std::memcpy(to, &value, sizeof value);
}

void call_lists(Random& random, const Player& player) {
  const GLenum type = pick(random, GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_2_BYTES,
                           GL_3_BYTES, GL_4_BYTES);
  const int count = random.chance(3) ? -1 : random.below(4);
  static unsigned char names[64];
  std::memset(names, 0, sizeof names);
  for (int i = 0; i < 4; ++i) {
    const GLuint name = list_name(random, player);
    print_note("name %u", name);
    switch (type) {
      case GL_BYTE: case GL_UNSIGNED_BYTE: names[i] = (unsigned char)(name); break;
      case GL_SHORT: case GL_UNSIGNED_SHORT: put(names + 2 * i, GLushort(name)); break;
      case GL_FLOAT: put(names + 4 * i, GLfloat(GLint(name)) + (random.chance(10) ? 0.75f : 0)); break;
      case GL_2_BYTES: names[2 * i] = (unsigned char)(name >> 8), names[2 * i + 1] = (unsigned char)(name); break;
      case GL_3_BYTES: names[3 * i + 1] = (unsigned char)(name >> 8), names[3 * i + 2] = (unsigned char)(name); break;
      case GL_4_BYTES: names[4 * i + 2] = (unsigned char)(name >> 8), names[4 * i + 3] = (unsigned char)(name); break;
      default: put(names + 4 * i, name);
    }
  }
  GL(CallLists, count, type, names);
}

// A list that calls itself, in the midst of its calls or as the last, to the depth limit.
void nest(const Op& op, Random& random, Player& player) {
  if (player.compiled) return;
  constexpr GLuint kName = 30;
  note_new_list(player, kName, false);
  GL(NewList, kName, GLenum(GL_COMPILE));
  GL(Translatef, 0.0625f, 0.0f, 0.0f);
  const bool warped = op.warp & (kWarpPosition | kWarpTexture | kWarpDepth);
  GL(Begin, GLenum(GL_QUADS));
  static const float corners[4][2] = {{2, 2}, {12, 2}, {12, 9}, {2, 9}};
  for (const auto& [x, y] : corners) {
    GL(TexCoord2f, x, y);
    GL(Vertex2f, warped && x > 2 && y > 2 ? x - 3 : x, y);
  }
  GL(End);
  const GLubyte names[] = {kName, 3};
  if (random.chance(70)) GL(CallList, kName);
  else GL(CallLists, 2, GLenum(GL_UNSIGNED_BYTE), names);
  if (random.chance(50)) GL(Color3f, 0.5f, 1.0f, 0.25f);
  GL(EndList);
  note_end_list(player);
  GL(PushMatrix);
  GL(CallList, kName);
  note_call(player, list_bit(kName) | list_bit(3));
  record_errors();
  GL(PopMatrix);
}

}  // namespace

void execute_list(const Op& op, Player& player) {
  Random random(op.seed);
  switch (op.step) {
    case Step::kNewList: {
      player.listing = true;
      const GLuint name = op.shape || random.chance(85) ? GLuint(1 + op.index) : list_name(random, player);
      const GLenum mode = pick(random, op.warp & 1 ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
      if (!player.compiled) note_new_list(player, name, mode == GL_COMPILE_AND_EXECUTE);
      return GL(NewList, name, mode);
    }
    case Step::kEndList:
      player.listing = false;
      GL(EndList);
      return note_end_list(player);
    case Step::kCallList: {
      const GLuint name = op.index > 0 ? GLuint(op.index) : list_name(random, player);
      if (call_redefined(player, list_bit(name))) return;
      GL(CallList, name);
      return note_call(player, list_bit(name));
    }
    case Step::kCallLists:
      if (call_redefined(player, ~0u)) return;
      call_lists(random, player);
      return note_call(player, ~0u);
    case Step::kDeleteLists: {
      const int count = random.of({1, 1, 1, 2, 3, 0, -1});
      return GL(DeleteLists, list_name(random, player), count);
    }
    case Step::kGenLists: {
      if (random.chance(40)) {
        const GLuint name = list_name(random, player);
        record("IsList %u: %d", name, GL(IsList, name));
        return;
      }
      const GLuint first = GL(GenLists, random.of({1, 1, 2, 3, 0, -1}));
      record("GenLists: %u", first);
      if (first) {
        player.generated[player.next_generated] = first;
        player.next_generated = (player.next_generated + 1) % 4;
        player.generated_count = player.generated_count < 4 ? player.generated_count + 1 : 4;
      }
      return;
    }
    case Step::kNest: return nest(op, random, player);
    default: return GL(ListBase, random.of<GLuint>({0, 0, 0, 1, 2, 0xffffffff}));
  }
}

}  // namespace truequad::fuzz
