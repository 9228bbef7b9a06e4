#include "capture/drawn.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>

#include "capture/state.h"

namespace truequad {
namespace {

// Multiply and fold, as in wyhash: each step takes two words.
std::uint64_t fold(std::uint64_t a, std::uint64_t b) {
  const unsigned __int128 product = static_cast<unsigned __int128>(a) * b;
  return std::uint64_t(product) ^ std::uint64_t(product >> 64);
}
constexpr std::uint64_t kOdd[] = {0xa0761d6478bd642f, 0xe7037ed1a0b428db, 0x8ebc6af09c88c6e3, 0x589965cc75374cc3};

constinit std::atomic<bool> passes_may_meet{false};

}  // namespace

PassKey positions_key(const Capture& c, const Quad& quad) {
  PassKey key = 0;
  for (int i = 0; i < 4; ++i) {
    std::uint64_t words[2];
    std::memcpy(words, c.at[kPosition][quad.corner[i]].at, sizeof words);
    // Corners are folded apart, so that the processor does them at once.
    key ^= std::rotl(fold(words[0] ^ kOdd[i], words[1] ^ kOdd[3 - i]), 13 * i);
  }
  return fold(key, kOdd[1]);
}

PassKey with_view(PassKey key, const View& view) {
  const auto add = [&](double x) { key = fold(key ^ std::bit_cast<std::uint64_t>(x), kOdd[2]) + kOdd[0]; };
  for (double element : view.clip_from_object) add(element);
  for (double x : {view.viewport.x, view.viewport.y, view.viewport.width, view.viewport.height}) add(x);
  return key;
}

Drawn* Drawn::allocate() {
  static_assert(std::is_trivial_v<Drawn>);
  // Pages that nothing is written to are never backed by memory.
  Drawn* drawn = static_cast<Drawn*>(std::calloc(1, sizeof(Drawn)));
  if (drawn) drawn->generation_ = 1;
  return drawn;
}

void Drawn::free(Drawn* drawn) { std::free(drawn); }

void Drawn::forget() {
  ++generation_;
  mesh_positions_.clear();
  triangles_.clear();
}

Drawn::Place Drawn::find(PassKey key) const {
  const unsigned first = unsigned(key % kMeshes) / kWays * kWays;
  Place place{first, false, false};
  for (unsigned i = first; i < first + kWays; ++i) {
    if (slots_[i].generation != generation_) {
      place = {i, false, true};
    } else if (slots_[i].key == key) {
      return {i, true, true};
    }
  }
  return place;
}

void Drawn::keep_mesh(PassKey positions, const PlannedFor& sets) {
  const Place place = find(sets.key);
  if (!place.free) return;
  mesh_positions_.add(positions);
  slots_[place.index] = {sets.key, generation_};
  mesh_of_[place.index] = sets;
}

const PlannedFor* Drawn::mesh(PassKey key) const {
  if (mesh_positions_.empty()) return nullptr;
  const Place place = find(key);
  return place.found ? &mesh_of_[place.index] : nullptr;
}

void Drawn::want_mesh(const PlannedFor& sets) {
  Wish* place = find_wish(sets.key);
  if (!place) {
    Wish* const first = wishes_ + sets.key % kWishes / kWays * kWays;
    place = std::min_element(first, first + kWays, [](const Wish& a, const Wish& b) { return a.used < b.used; });
    // Another's that is met frame by frame: if each took the place from the other, each were a mesh in every second frame.
    if (place->used != 0 && generation_ - place->used <= kPatience) return;
  }
  wanted_ = true;
  *place = {sets.key, generation_, generation_};
  wanted_of_[place - wishes_] = sets;
}

void Drawn::use_wish(PassKey positions) {
  if (Wish* const wish = find_wish(positions)) wish->used = generation_;
}

void Drawn::meet_wish(PassKey positions) {
  if (!wanted_) return;
  if (Wish* const wish = find_wish(positions)) wish->met = generation_;
}

bool Drawn::wish_is_stale(PassKey positions) const {
  const Wish* const wish = wanted_ ? find_wish(positions) : nullptr;
  return wish && generation_ - wish->met > kPatience;
}

bool passes_meet() { return passes_may_meet.load(std::memory_order_relaxed); }

void depth_func_called(GLenum function) {
  if (function == GL_EQUAL || function == GL_LEQUAL || function == GL_GEQUAL || function == GL_NOTEQUAL) {
    passes_may_meet.store(true, std::memory_order_relaxed);
  }
}
void stencil_op_called() { passes_may_meet.store(true, std::memory_order_relaxed); }

}  // namespace truequad
