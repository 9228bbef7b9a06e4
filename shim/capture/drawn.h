// What earlier passes drew. A later pass over the same vertices must land on the same depths and pixels (GL_EQUAL,
// GL_LEQUAL, stencil), and two triangles and a mesh do not, but for rounding. So quads that were drawn as meshes are
// drawn so again, whatever their texture coordinates, and what lies in the buffers as two triangles stays two
// triangles: docs/semantics.md "Later passes".
#pragma once

#include <cstdint>
#include <cstring>

#include "capture/context.h"
#include "capture/view.h"
#include "capture/slots.h"
#include "capture/values.h"

namespace truequad {

struct Capture;
struct Quad;

// A hash of what must be equal for two passes to meet. 64 bits: among a million quads two differ in everything but it
// with a chance of 1 in 40 million.
using PassKey = std::uint64_t;

// The positions of the corners, bit for bit, or these as seen in a view.
PassKey positions_key(const Capture& c, const Quad& quad);
PassKey with_view(PassKey positions, const View& view);

// The texture coordinates and colours that a mesh was planned for, and whether depths were clamped: with them, the same plan can
// be made again.
struct PlannedFor {
  PassKey key;
  bool depth_clamped;
  unsigned units;  // bit mask
  Float4 texture[kTextureUnits][4];
  unsigned colours;  // channels, in steps of 1/255
  float colour[kMaxColourChannels][4];
};

// A set of keys that never forgets one and sometimes knows one that it was not told: B. Bloom, "Space/time trade-offs in
// hash coding with allowable errors" (CACM 1970), each key in one word, so that it costs one line of the cache.
template <unsigned bits_>
class KeySet {
 public:
  void add(PassKey key) {
    any_ = true;
    words_[key % kWords] |= pattern(key);
  }
  bool has(PassKey key) const { return any_ && (~words_[key % kWords] & pattern(key)) == 0; }
  bool empty() const { return !any_; }
  void clear() {
    if (any_) std::memset(words_, 0, sizeof words_);
    any_ = false;
  }

 private:
  static constexpr unsigned kWords = bits_ / 64;
  static std::uint64_t pattern(PassKey key) {
    const auto one = [key](unsigned shift) { return std::uint64_t(1) << (key >> shift & 63); };
    return one(40) | one(46) | one(52);
  }
  bool any_;
  std::uint64_t words_[kWords];
};

// One thread's memory: of fixed size, all zero at first.
class Drawn {
 public:
  // Null if there is no memory.
  static Drawn* allocate();
  static void free(Drawn* drawn);

  // Nothing drawn so far can meet a later pass: the buffers were cleared, or are others.
  void forget();

  // True if a quad that needs no correction may have to be drawn as a mesh: nothing is asked of the driver for this.
  bool may_be_mesh(PassKey positions) const { return mesh_positions_.has(positions) || wanted(positions); }
  bool any_mesh() const { return !mesh_positions_.empty() || wanted_; }
  bool empty() const { return mesh_positions_.empty() && triangles_.empty(); }

  // Two triangles that are in the buffers now; the key of positions alone where the view is not known.
  void note_triangles(PassKey key) { triangles_.add(key); }
  bool has_triangles(PassKey key) const { return triangles_.has(key); }

  // A mesh that is in the buffers now. can_keep() is false if there is no room for one more.
  bool can_keep(PassKey key) const { return find(key).free; }
  void keep_mesh(PassKey positions, const PlannedFor& sets);
  const PlannedFor* mesh(PassKey key) const;

  // A quad stayed two triangles because an earlier pass had drawn them, or got a mesh that is not fine enough: from the next
  // frame on the earlier pass draws the mesh that is wanted here. `sets.key` is that of the positions. Forgotten at once if
  // there is no room.
  void want_mesh(const PlannedFor& sets);
  const PlannedFor* wanted(PassKey positions) const {
    const Wish* const wish = wanted_ ? find_wish(positions) : nullptr;
    return wish ? &wanted_of_[wish - wishes_] : nullptr;
  }
  // The earlier pass drew what is wanted; the pass that wanted it drew it.
  void use_wish(PassKey positions);
  void meet_wish(PassKey positions);
  // What is wanted was drawn for a pass that came no more: coordinates move, say.
  bool wish_is_stale(PassKey positions) const;

 private:
  static constexpr unsigned kMeshes = 1 << 14, kWays = 4, kWishes = 1 << 14;
  struct Slot {
    PassKey key;
    std::uint64_t generation;  // another than the present: free
  };
  // Two clears or three may be a frame's.
  static constexpr std::uint64_t kPatience = 8;
  struct Wish {
    PassKey key;
    std::uint64_t used, met;  // generations; 0: free
  };
  struct Place {
    unsigned index;
    bool found, free;
  };
  Place find(PassKey key) const;
  const Wish* find_wish(PassKey key) const {
    const Wish* const first = wishes_ + key % kWishes / kWays * kWays;
    for (const Wish* wish = first; wish < first + kWays; ++wish) {
      if (wish->key == key && wish->used != 0) return wish;
    }
    return nullptr;
  }
  Wish* find_wish(PassKey key) { return const_cast<Wish*>(static_cast<const Drawn*>(this)->find_wish(key)); }

  std::uint64_t generation_;
  bool wanted_;
  KeySet<1 << 17> mesh_positions_;
  KeySet<1 << 22> triangles_;
  Slot slots_[kMeshes];
  Wish wishes_[kWishes];
  PlannedFor mesh_of_[kMeshes], wanted_of_[kWishes];
};

// True once the program has asked for a depth function or stencil operation with which passes meet: from then on what
// is drawn as two triangles is noted. For the process, as contexts share lists that may hold such calls.
bool passes_meet();
void depth_func_called(GLenum function);
void stencil_op_called();

}  // namespace truequad
