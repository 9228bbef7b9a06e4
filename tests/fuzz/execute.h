// Makes the calls of steps, and writes down what the program can see of them.
#pragma once

#include "gl.h"
#include "ops.h"
#include "random.h"

namespace truequad::fuzz {

inline constexpr int kCanvas = 32;
inline constexpr int kUnits = 2;  // texture units that sequences use

// Where shapes lie: whole numbers, so that every type of every call says exactly the same.
struct Corner {
  int x, y, z, s, t;
};
Corner corner(std::uint32_t shape, int index, unsigned warp);

// Current values, in groups.
enum ValueGroup : unsigned { kColours = 1, kTextures = 2, kOtherValues = 4, kAllValues = 7 };
void set_values(unsigned values);  // execute_arrays.cc

// What is known of a list: the values that it sets outside of glBegin and glEnd, and between them, and those that are open in
// any case; the lists that it calls.
struct ListValues {
  unsigned loose = 0, in_primitives = 0, open = 0;
  std::uint32_t called = 0;
};

// What a step may look at: its own numbers, and what earlier steps of the trial left.
struct Player {
  GLuint generated[4] = {};  // first names of glGenLists
  int generated_count = 0, next_generated = 0;
  int depth_attrib = 0;
  int context = 0;
  bool listing = false;  // a list may be being compiled
  static constexpr int kLists = 32;
  ListValues lists[kLists];      // by name; 0: all others
  ListValues* compiled = nullptr;
  bool executed = false;         // as it is compiled
  bool redefined = false;        // there was such a list before
  bool programs = false;         // one that is no program may be enabled
  bool in_primitive = false;
  GLenum mode = GL_POINTS;       // of that primitive
  int vertices = 0;              // of it, so far
  // Colours of its primitives: of three numbers, and then of four.
  bool short_colour = false, colours_grew = false;
  void* mapped = nullptr;
  std::int64_t mapped_size = 0;
};

void execute(const Op& op, Player& player);

// list_values.cc
extern bool settling;  // values that are open are set anew also within lists
void note_new_list(Player& player, GLuint name, bool executed);
// These lists call the one that is being compiled, executed, and defined anew.
bool call_redefined(const Player& player, std::uint32_t called);
void note_end_list(Player& player);
void note_begin(Player& player, GLenum mode);
void note_end(Player& player);
void note_values(Player& player, unsigned values);
void note_colour(Player& player, int numbers);
// If `settling`: what the list that is compiled, or one that it calls, leaves open is set anew.
void settle_values(Player& player);
// And the last piece of a primitive that Mesa executes in pieces is executed.
void settle_pieces(const Player& player);
std::uint32_t list_bit(GLuint name);
void note_call(Player& player, std::uint32_t called);  // bits of lists
unsigned values_left_open(const Player& player, std::uint32_t called);

// Parts of execute(), a file for each.
void execute_vertex(const Op& op, Player& player);       // attributes.cc
void execute_attribute(const Op& op, Player& player);
void execute_material(const Op& op);
void execute_list(const Op& op, Player& player);   // execute_lists.cc
void execute_state(const Op& op, Player& player);  // execute_state.cc
void execute_other(const Op& op, Player& player);  // execute_other.cc
void execute_arrays(const Op& op, Player& player); // execute_arrays.cc
void execute_edges(const Op& op);                  // execute_edges.cc
void fill_arena();
void point_arrays();

// Names of lists that sequences use.
GLuint list_name(Random& random, const Player& player);

// An enum of those that are right, or now and then another.
template <typename... T>
GLenum pick(Random& random, T... choices) {
  const GLenum all[] = {GLenum(choices)...};
  if (random.chance(2)) return random.of<GLenum>({0, 1, GL_TRIANGLES, GL_TEXTURE_3D, 0x1234, 0xffffffff, GL_FLOAT, GL_BACK});
  return all[random.below(sizeof...(choices))];
}

// fuzz_program.cc: switches between two contexts that share lists; lines of the trace.
void make_current(int context);
void record(const char* format, ...) __attribute__((format(printf, 1, 2)));
void record_errors();

// digest.cc: everything that can be asked. Prints each answer if `verbose`, else one number of all.
// find_names(): which names have answers, once for all.
extern bool verbose;
void find_names();
void record_state();

extern float feedback_buffer[256];
extern GLuint selection_buffer[64];

}  // namespace truequad::fuzz
