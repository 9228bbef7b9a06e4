// Buffer objects whose names were deleted. "If a buffer object is deleted while it is bound, all bindings to that object in the
// current context (i.e. in the thread that called DeleteBuffers) are reset to zero. Bindings to that buffer in other contexts and
// other threads are not affected" (GL 3.0 section 2.9), nor are those of vertex array objects that are not bound. These keep
// the old buffer, while its name may become another's: by the name it could no longer be read.
#pragma once

#include <atomic>
#include <cstdint>

#include "driver/driver.h"

namespace truequad {

struct ContextRecord;
struct Entry;

// The vertex array object that is bound, of which context; 0 is none of them.
using Binder = std::uint64_t;
inline constexpr unsigned kObjectBits = 21;
inline constexpr Binder kAnyObject = (Binder(1) << kObjectBits) - 1, kAnyBinder = ~Binder(0);
inline Binder binder_of(const ContextRecord* context, GLuint object) {
  return Binder(reinterpret_cast<std::uintptr_t>(context) >> 4) << kObjectBits | (object < kAnyObject ? object : kAnyObject);
}

// Of contexts that share buffers. Time is the number of deletions. Names that meet in a place are taken for one, which only
// leaves quads alone without need.
class BufferDeletions {
 public:
  bool any() const { return now() != 0; }
  std::uint64_t now() const { return now_.load(std::memory_order_acquire); }

  void deleted(GLuint name, Binder by);
  // When it was deleted last; 0: never.
  std::uint64_t last(GLuint name) const { return time_[name % kPlaces].load(std::memory_order_acquire); }
  // True if only with `binder` bound, whose own bindings were reset.
  bool only_by(GLuint name, Binder binder) const {
    const Binder by = by_[name % kPlaces].load(std::memory_order_relaxed);
    return by == binder && (by & kAnyObject) != kAnyObject;
  }
  // True if only in its context, whatever object was bound.
  bool only_in_context_of(GLuint name, Binder binder) const {
    return (by_[name % kPlaces].load(std::memory_order_relaxed) | kAnyObject) == (binder | kAnyObject);
  }

 private:
  static constexpr unsigned kPlaces = 1024;
  std::atomic<std::uint64_t> now_{0};
  std::atomic<std::uint64_t> time_[kPlaces] = {};
  std::atomic<Binder> by_[kPlaces] = {};
};

// What a context knows of the ages of its bindings: none in a vertex array object is older than the object, unless
// glPopClientAttrib brought it back.
class BindingAges {
 public:
  explicit BindingAges(std::uint64_t now = 0) : context_(now) {}
  std::uint64_t context() const { return context_; }
  // Without a note the object may be as old as the context.
  std::uint64_t object(GLuint name) const {
    const Object& place = objects_[name % kPlaces];
    return name != 0 && place.name == name ? place.made : context_;
  }
  bool restored() const { return restored_; }

  void made(GLuint name, std::uint64_t now) { objects_[name % kPlaces] = {name, now}; }
  void pushed(std::uint64_t now) {
    if (depth_++ == 0) pushed_ = now;
  }
  void popped(std::uint64_t now) {
    if (depth_ == 0) return;
    --depth_;
    restored_ |= now != pushed_;
  }

 private:
  struct Object {
    GLuint name = 0;
    std::uint64_t made = 0;
  };
  static constexpr unsigned kPlaces = 256;
  std::uint64_t context_, pushed_ = 0;
  unsigned depth_ = 0;
  bool restored_ = false;
  Object objects_[kPlaces];
};

// The program has made, or is about to make, these calls.
void note_deleted_buffers(Entry& entry, GLsizei n, const GLuint* names);
void note_new_objects(Entry& entry, GLsizei n, const GLuint* names);
void note_pushed_arrays(Entry& entry);
void note_popped_arrays(Entry& entry);

// True if what has the name in the vertex array object that is bound, or in a binding of the context itself, may be a buffer
// that was deleted. The driver must be outside of Begin/End.
bool may_be_deleted_in_arrays(const ContextRecord& context, const Driver& driver, GLuint name);
bool may_be_deleted_in_context(const ContextRecord& context, GLuint name);

}  // namespace truequad
