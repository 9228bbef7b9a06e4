// Display lists that are split: what the driver can keep lies in lists of the driver's, what may need correction with us,
// and both are played in order (docs/semantics.md "Display lists"). A list that is not here is wholly the driver's.
#pragma once

#include <atomic>
#include <mutex>

#include "capture/buffers.h"
#include "capture/deletions.h"
#include "capture/kept_calls.h"

namespace truequad {

// A piece of a split list.
struct Part {
  enum class Kind : std::uint8_t {
    kDriver,     // a list of the driver's
    kKept,       // calls that are made again
    kCall,       // glCallList
    kCallMany,   // glCallLists
  };
  // What a list of the driver's leaves behind that has a glBegin or glEnd without the other.
  enum class Half : std::uint8_t { kNone, kBegins, kEnds };

  Kind kind;
  Half half = Half::kNone;
  GLuint name = 0;     // of the driver's (0: nothing) or the called list; kCallMany: their count
  GLenum type = 0;     // kCallMany: of the names, which are in `names`
  unsigned char* names = nullptr;
  KeptCalls kept;
  bool opens = false;  // kKept: has a glBegin before any vertex or glEnd
  bool inside = false;   // kKept: the calls so far end between glBegin and glEnd
  bool paired = true;    // and each vertex was between a glBegin and the next glEnd
  Part* next = nullptr;

  explicit Part(Kind k) : kind(k) {}
  ~Part();
};

struct SplitList {
  const GLuint name;
  Part* first = nullptr;
  Part** end = &first;
  bool whole = false;  // the driver has all of it as well, under the program's own name
  std::atomic<int> users{1};
  SplitList* next = nullptr;  // in its bucket

  explicit SplitList(GLuint n) : name(n) {}
  ~SplitList();

  // Null if there is no memory.
  Part* add(Part::Kind kind);

  static void release(SplitList* list);
};

// A list of the driver's that the program does not know.
inline bool is_hidden_part(const Part& part, const SplitList& list) {
  return part.kind == Part::Kind::kDriver && part.name != 0 && part.name != list.name;
}

// Contexts that share lists and buffers.
class ShareGroup {
 public:
  std::atomic<int> users{1};
  BufferChanges buffers;
  BufferDeletions deletions;
  // Some list that was compiled has glListBase or glPopAttrib, so that calling it may change the base.
  std::atomic<bool> base_in_lists{false}, pop_in_lists{false};
  static void release(ShareGroup* group);
  ~ShareGroup();

  // True if some list is split: only then need calls be looked at.
  bool any_split() const { return splits_.load(std::memory_order_relaxed) != 0; }

  // The split list of that name, to be released by the caller; null if it is the driver's own.
  SplitList* find(GLuint name);
  // Replaces what was there; `list` may be null. Returns the old one, to be released by the caller.
  SplitList* put(GLuint name, SplitList* list);
  // Takes some list of [first, first + count) out; null when there is none left.
  SplitList* take(GLuint first, GLuint count);

  // Names for parts, from a range that programs do not reach by counting. `is_list` is the driver's.
  GLuint hidden_name(const Driver& driver);
  bool is_hidden(GLuint name) const {
    return name >= kHidden && name < next_hidden_.load(std::memory_order_relaxed);
  }
  bool any_hidden() const { return next_hidden_.load(std::memory_order_relaxed) != kHidden; }

  // The largest name that the program has used so far, to give out names as if there were no hidden ones.
  void note_name(GLuint name);
  GLuint largest_name() const { return largest_name_.load(std::memory_order_relaxed); }

  static constexpr GLuint kHidden = 0x5a000000, kHiddenEnd = 0x7a000000;

 private:
  static constexpr unsigned kBuckets = 1024;
  SplitList** bucket(GLuint name) { return &buckets_[name % kBuckets]; }
  SplitList* take_locked(SplitList** place);

  std::mutex mutex_;
  std::atomic<unsigned> splits_{0};
  std::atomic<GLuint> next_hidden_{kHidden}, largest_name_{0};
  SplitList* buckets_[kBuckets] = {};
};

}  // namespace truequad
