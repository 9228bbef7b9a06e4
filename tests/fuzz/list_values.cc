// Which current values a list leaves as Mesa has them rather than OpenGL: those that it sets outside of glBegin and glEnd and
// in a primitive too, and all after a primitive whose last vertices draw nothing, or which cannot be drawn (README.md). The sequence sets these anew,
// so that what follows is defined.
#include "execute.h"

namespace truequad::fuzz {

bool settling = false;

namespace {

int place_of_list(GLuint name) { return name < Player::kLists ? int(name) : 0; }

}  // namespace

void note_new_list(Player& player, GLuint name, bool executed) {
  player.compiled = &player.lists[place_of_list(name)];
  *player.compiled = {};
  player.executed = executed;
  player.redefined = executed && gl.IsList(name);
  player.in_primitive = player.short_colour = player.colours_grew = false;
}

void note_values(Player& player, unsigned values) {
  if (!player.compiled) return;
  (player.in_primitive ? player.compiled->in_primitives : player.compiled->loose) |= values;
}

void note_colour(Player& player, int numbers) {
  if (!player.compiled || !player.in_primitive) return;
  if (numbers < 4) player.short_colour = true;
  else player.colours_grew |= player.short_colour;
}

void note_begin(Player& player, GLenum mode) {
  player.in_primitive = true;
  player.mode = mode;
  player.vertices = 0;
}

namespace {

bool last_vertices_draw(GLenum mode, int vertices) {
  switch (mode) {
    case GL_POINTS: return vertices > 0;
    case GL_LINES: return vertices > 0 && vertices % 2 == 0;
    case GL_LINE_STRIP: case GL_LINE_LOOP: return vertices > 1;
    case GL_TRIANGLES: return vertices > 0 && vertices % 3 == 0;
    case GL_QUADS: return vertices > 0 && vertices % 4 == 0;
    case GL_QUAD_STRIP: return vertices > 3 && vertices % 2 == 0;
    default: return vertices > 2;
  }
}

}  // namespace

void note_end(Player& player) {
  const bool matched = player.in_primitive;
  player.in_primitive = false;
  if (player.compiled && (!matched || !last_vertices_draw(player.mode, player.vertices))) player.compiled->open = kAllValues;
}

void note_call(Player& player, std::uint32_t called) {
  if (player.compiled) player.compiled->called |= called;
  if (player.compiled && !player.executed && !settling) return;
  const unsigned open = values_left_open(player, called);
  note_values(player, open);
  set_values(open);
}

std::uint32_t list_bit(GLuint name) { return 1u << place_of_list(name); }

// With all lists that they call.
std::uint32_t closure(const Player& player, std::uint32_t called) {
  for (std::uint32_t before = 0; before != called;) {
    before = called;
    for (int i = 0; i < Player::kLists; ++i) {
      if (called >> i & 1) called |= player.lists[i].called;
    }
  }
  return called;
}

bool call_redefined(const Player& player, std::uint32_t called) {
  return player.compiled && player.redefined && (closure(player, called) >> (player.compiled - player.lists) & 1);
}

unsigned values_left_open(const Player& player, std::uint32_t called) {
  if (player.programs) return kAllValues;
  called = closure(player, called);
  unsigned loose = 0, in_primitives = 0, open = 0;
  for (int i = 0; i < Player::kLists; ++i) {
    if (!(called >> i & 1)) continue;
    loose |= player.lists[i].loose;
    in_primitives |= player.lists[i].in_primitives;
    open |= player.lists[i].open;
  }
  return open | (loose & in_primitives);
}

void settle_values(Player& player) {
  if (!settling || !player.compiled || player.in_primitive) return;
  const unsigned open = values_left_open(player, 1u << (player.compiled - player.lists));
  note_values(player, open);
  set_values(open);
}

void settle_pieces(const Player& player) {
  // Any call would do that changes nothing.
  if (settling && player.compiled && player.executed && player.colours_grew) GL(PixelZoom, 1.0f, 1.0f);
}

void note_end_list(Player& player) {
  if (!player.compiled) return;
  if (player.in_primitive) note_end(player);
  const std::uint32_t list = 1u << (player.compiled - player.lists);
  player.compiled = nullptr;
  if (player.executed) set_values(values_left_open(player, list));
}

}  // namespace truequad::fuzz
