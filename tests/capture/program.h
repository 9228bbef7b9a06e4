// Programs for the tests: run once on the fake driver alone, once through the doors, and compared.
#pragma once

#include <functional>

#include "capture/capture.h"
#include "capture/drawn.h"
#include "capture/state.h"
#include "fake_gl.h"

namespace truequad::fake {

using Program = std::function<void(const Driver&)>;

// What the program does to `start` without truequad.
inline Gl natively(const Program& program, const Gl& start = Gl()) {
  reset(start);
  program(driver());
  return gl();
}

// The same through the doors, in a new context.
inline Gl through_doors(const Program& program, const Gl& start = Gl()) {
  reset(start);
  make_current();
  program(doors());
  return gl();
}

// As if this thread had drawn nothing yet.
inline void delete_thread_memory() {
  if (!entry.own) return;
  Drawn::free(entry.own->drawn);
  entry.own->drawn = nullptr;
  entry.own->unnoted = false;
}

// Counters of this thread, which only grow.
inline const Counters& counters() {
  static const Counters none;
  return entry.own ? entry.own->counters : none;
}
inline std::uint64_t passed(Reason reason) { return counters().passed[std::size_t(reason)].get(); }
inline std::uint64_t passed() {
  std::uint64_t sum = 0;
  for (const Counter& counter : counters().passed) sum += counter.get();
  return sum;
}
inline std::uint64_t corrected() { return counters().corrected.get(); }

// How much a program adds to a count.
template <typename F>
std::uint64_t growth(std::uint64_t (*count)(), F f) {
  const std::uint64_t before = count();
  f();
  return count() - before;
}

struct Point {
  float x, y;
};
// A quad whose texture patch is the unit square: s = u, t = v.
struct UnitPatch {
  Point corner[4];
  void vertex(const Driver& gl, int i) const {
    constexpr float kS[] = {0, 1, 1, 0}, kT[] = {0, 0, 1, 1};
    gl.TexCoord2f(kS[i], kT[i]);
    gl.Vertex2f(corner[i].x, corner[i].y);
  }
  void draw(const Driver& gl) const {
    for (int i = 0; i < 4; ++i) vertex(gl, i);
  }
};
inline constexpr UnitPatch kTrapezoid = {{{-0.9f, -0.9f}, {0.9f, -0.9f}, {0.3f, 0.9f}, {-0.3f, 0.9f}}};
inline constexpr UnitPatch kSquare = {{{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}};

}  // namespace truequad::fake
