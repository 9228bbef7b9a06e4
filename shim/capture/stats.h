// Counters: one block for each thread, added up when the process ends. JSON as in docs/semantics.md.
#pragma once

#include <atomic>
#include <cstdint>

#include "capture/reasons.h"
#include "config/options.h"

namespace truequad {

// Written by one thread only, read by the one that ends the process: relaxed loads and stores, never a locked
// instruction.
class Counter {
 public:
  // Always inline: on the path of every vertex call.
  [[gnu::always_inline]] void add(std::uint64_t n) { value_.store(get() + n, std::memory_order_relaxed); }
  void set(std::uint64_t n) { value_.store(n, std::memory_order_relaxed); }
  [[gnu::always_inline]] std::uint64_t get() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> value_{0};
};

struct Counters {
  Counter passed[kReasonCount];
  // Of both, by the way on which they came; the others are immediate mode.
  Counter listed;        // compiled into a display list, or called with it
  Counter from_arrays;   // vertex arrays in the client's memory
  Counter from_buffers;  // in buffer objects
  Counter rectangles;    // glRect
  Counter corrected;
  Counter capped;     // of the corrected ones: the promise exceeds the tolerance
  Counter triangles;  // drawn for corrected quads
  Counter flushes;    // the driver's glBegin of the program was cut for a correction
  std::atomic<double> bound_px_max{0}, bound_steps_max{0};

  Counters* next = nullptr;  // of the list of all threads

  // All that were seen.
  std::uint64_t quads() const {
    std::uint64_t sum = corrected.get();
    for (const Counter& counter : passed) sum += counter.get();
    return sum;
  }

  [[gnu::always_inline]] void pass(Reason reason) { passed[std::size_t(reason)].add(1); }
  void correct(int triangle_count, double bound_px, double bound_steps, bool is_capped);
};

// Notes that this process uses GL: only then does process_ends() write. Cheap when repeated.
void stats_engage();

// A thread's block joins the sum, or leaves it (its counts stay).
void stats_attach(Counters& counters);
void stats_detach(Counters& counters);

// Adds up all threads, ended ones included.
void stats_sum(Counters& sum);

}  // namespace truequad
