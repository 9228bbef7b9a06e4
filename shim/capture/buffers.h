// Buffer objects whose contents draws with quads need (GL 2.1 section 2.9): a copy of each, read from the driver and read
// again when the program made a call that may have changed it. Other buffers cost nothing but a load in such calls.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "driver/driver.h"

namespace truequad {

struct Caps;
struct ContextRecord;
struct Entry;

// What contexts that share buffers know of changes: a count for each buffer. Names that meet in a place have one count,
// which only makes copies be read again without need.
class BufferChanges {
 public:
  // From here on changes are counted: somebody has a copy.
  void watch() { watched_.store(true, std::memory_order_seq_cst); }
  bool watched() const { return watched_.load(std::memory_order_relaxed); }

  void changed(GLuint name) { of(name).fetch_add(1, std::memory_order_release); }
  void all_changed() { all_.fetch_add(1, std::memory_order_release); }
  // Another value after every change.
  std::uint64_t stamp(GLuint name) const {
    return const_cast<BufferChanges*>(this)->of(name).load(std::memory_order_acquire) + all_.load(std::memory_order_acquire);
  }

 private:
  static constexpr unsigned kPlaces = 1024;
  std::atomic<std::uint64_t>& of(GLuint name) { return counts_[name % kPlaces]; }

  std::atomic<bool> watched_{false};
  std::atomic<std::uint64_t> all_{0};
  std::atomic<std::uint64_t> counts_[kPlaces] = {};
};

struct BufferCopy {
  GLuint name = 0;
  std::uint64_t stamp = 0;
  std::uint64_t last_use = 0;
  unsigned char* bytes = nullptr;
  std::size_t size = 0, capacity = 0;
};

// The copies of one context. Bounded: the one that was not used for longest makes room.
class BufferCopies {
 public:
  ~BufferCopies();

  // The buffer's contents now; null if they cannot be known: it is mapped, or too large, or none of that name exists. The
  // driver must be outside of Begin/End. Another copy may be dropped, but none that was asked for since the last start().
  const BufferCopy* contents(const Driver& driver, const ContextRecord& context, GLuint name);
  // A draw begins.
  void start() { ++use_; }

  static constexpr std::size_t kMostBytes = std::size_t(256) << 20;  // of all
  static constexpr unsigned kMost = 64;

 private:
  BufferCopy* place_for(GLuint name);
  bool reserve(BufferCopy& copy, std::size_t size);

  std::uint64_t use_ = 0;
  std::size_t total_ = 0;
  BufferCopy copies_[kMost];
};

// The program is about to make, and has made, a call that changes buffers: the end of this object's life is after it.
class BufferChange {
 public:
  enum class Of { kTarget, kName, kPacked, kQueried, kAny };
  BufferChange(Entry& entry, Of of, GLuint which) : entry_(entry), of_(of), which_(which) {}
  ~BufferChange();

 private:
  Entry& entry_;
  Of of_;
  GLuint which_;
};

}  // namespace truequad
