#include "capture/deletions.h"

#include "capture/context.h"
#include "capture/entry.h"
#include "capture/list_compile.h"
#include "capture/lists.h"

namespace truequad {
namespace {

GLuint bound_object(const ContextRecord& context, const Driver& driver) {
  GLint object = 0;
  if (context.caps.vertex_array_objects) driver.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &object);
  return GLuint(object);
}

}  // namespace

void BufferDeletions::deleted(GLuint name, Binder by) {
  std::atomic<Binder>& place = by_[name % kPlaces];
  Binder before = place.load(std::memory_order_relaxed);
  const auto both = [&] {
    if (before == 0 || before == by) return by;
    return (before | kAnyObject) == (by | kAnyObject) ? by | kAnyObject : kAnyBinder;
  };
  while (!place.compare_exchange_weak(before, both(), std::memory_order_relaxed)) {
  }
  time_[name % kPlaces].store(now_.fetch_add(1, std::memory_order_acq_rel) + 1, std::memory_order_release);
}

void note_deleted_buffers(Entry& e, GLsizei n, const GLuint* names) {
  // Between glBegin and glEnd it is an error.
  if (!e.context || !e.context->group || e.inside || n <= 0 || !names) return;
  const Driver& driver = *real_driver(e);
  Binder by = kAnyBinder;
  if (caps_of(*e.context, driver).supported) by = binder_of(e.context, bound_object(*e.context, driver));
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] != 0) e.context->group->deletions.deleted(names[i], by);
  }
}

void note_new_objects(Entry& e, GLsizei n, const GLuint* names) {
  if (!e.context || !e.context->group || e.inside || n <= 0 || !names) return;
  const BufferDeletions& deletions = e.context->group->deletions;
  if (!deletions.any()) return;
  for (GLsizei i = 0; i < n; ++i) e.context->ages.made(names[i], deletions.now());
}

void note_pushed_arrays(Entry& e) {
  if (e.context && e.context->group) e.context->ages.pushed(e.context->group->deletions.now());
}
void note_popped_arrays(Entry& e) {
  if (e.context && e.context->group) e.context->ages.popped(e.context->group->deletions.now());
}

bool may_be_deleted_in_arrays(const ContextRecord& context, const Driver& driver, GLuint name) {
  const BufferDeletions& deletions = context.group->deletions;
  const std::uint64_t last = deletions.last(name);
  if (last <= context.ages.context()) return false;
  const GLuint object = bound_object(context, driver);
  if (last <= context.ages.object(object)) return false;
  return context.ages.restored() || !deletions.only_by(name, binder_of(&context, object));
}

bool may_be_deleted_in_context(const ContextRecord& context, GLuint name) {
  const BufferDeletions& deletions = context.group->deletions;
  return deletions.last(name) > context.ages.context() && !deletions.only_in_context_of(name, binder_of(&context, 0));
}

}  // namespace truequad
