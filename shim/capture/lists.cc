#include "capture/lists.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace truequad {

Part::~Part() { std::free(names); }

SplitList::~SplitList() {
  while (first) {
    Part* const part = first;
    first = part->next;
    delete part;
  }
}

Part* SplitList::add(Part::Kind kind) {
  Part* part = new (std::nothrow) Part(kind);
  if (!part) return nullptr;
  *end = part;
  end = &part->next;
  return part;
}

void SplitList::release(SplitList* list) {
  if (list && list->users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete list;
}

void ShareGroup::release(ShareGroup* group) {
  if (group && group->users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete group;
}

ShareGroup::~ShareGroup() {
  // The driver's lists went with the last context.
  for (SplitList* list : buckets_) {
    while (list) {
      SplitList* const next = list->next;
      SplitList::release(list);
      list = next;
    }
  }
}

SplitList* ShareGroup::find(GLuint name) {
  if (!any_split()) return nullptr;
  const std::lock_guard lock(mutex_);
  for (SplitList* list = *bucket(name); list; list = list->next) {
    if (list->name != name) continue;
    list->users.fetch_add(1, std::memory_order_relaxed);
    return list;
  }
  return nullptr;
}

SplitList* ShareGroup::take_locked(SplitList** place) {
  SplitList* const list = *place;
  *place = list->next;
  list->next = nullptr;
  splits_.fetch_sub(1, std::memory_order_relaxed);
  return list;
}

SplitList* ShareGroup::put(GLuint name, SplitList* list) {
  if (!list && !any_split()) return nullptr;
  const std::lock_guard lock(mutex_);
  SplitList* old = nullptr;
  for (SplitList** place = bucket(name); *place; place = &(*place)->next) {
    if ((*place)->name != name) continue;
    old = take_locked(place);
    break;
  }
  if (list) {
    list->next = *bucket(name);
    *bucket(name) = list;
    splits_.fetch_add(1, std::memory_order_relaxed);
  }
  return old;
}

SplitList* ShareGroup::take(GLuint first, GLuint count) {
  if (!any_split()) return nullptr;
  const std::lock_guard lock(mutex_);
  // A few names: their buckets; many: all buckets.
  const unsigned buckets = unsigned(std::min<std::uint64_t>(count, kBuckets));
  for (unsigned i = 0; i < buckets; ++i) {
    for (SplitList** place = bucket(first + i); *place; place = &(*place)->next) {
      if ((*place)->name - first < count) return take_locked(place);
    }
  }
  return nullptr;
}

GLuint ShareGroup::hidden_name(const Driver& driver) {
  GLuint name;
  do {
    name = next_hidden_.fetch_add(1, std::memory_order_relaxed);
    if (name >= kHiddenEnd) {
      next_hidden_.store(kHiddenEnd, std::memory_order_relaxed);
      return 0;
    }
  } while (driver.IsList(name));
  return name;
}

void ShareGroup::note_name(GLuint name) {
  GLuint before = largest_name();
  while (name > before && !largest_name_.compare_exchange_weak(before, name, std::memory_order_relaxed)) {
  }
}

}  // namespace truequad
