#include "capture/context.h"

#include <mutex>
#include <new>

#include "capture/arrays.h"
#include "capture/capture.h"
#include "capture/list_compile.h"
#include "capture/stats.h"

namespace truequad {

constinit thread_local Entry entry [[gnu::tls_model("initial-exec")]] = {
    &default_driver, nullptr, &default_driver, nullptr, nullptr, false, nullptr, false, false, 0, false, false, false, nullptr};

namespace {

constinit std::mutex records_mutex;
constinit ContextRecord* records = nullptr;

// Both with records_mutex held.
ContextRecord** find(const void* handle) {
  ContextRecord** x = &records;
  while (*x && (*x)->handle != handle) x = &(*x)->next;
  return x;
}
void destroy(ContextRecord* record) {
  ShareGroup::release(record->group);
  drop_list(record->list);
  free_array_memory(*record);
  delete record;
}
void release(ContextRecord* record) {
  if (--record->users == 0 && record->destroyed.load(std::memory_order_relaxed)) destroy(record);
}
ContextRecord* add(const void* handle, ShareGroup* group) {
  ContextRecord* record = new (std::nothrow) ContextRecord;
  if (!record) return nullptr;
  record->handle = handle;
  record->group = group ? group : new (std::nothrow) ShareGroup;
  if (record->group) record->ages = BindingAges(record->group->deletions.now());
  record->next = records;
  records = record;
  return record;
}

}  // namespace

void context_made_current(Entry& e, const void* context, const Driver* driver) {
  stats_engage();
  e.driver = driver ? driver : &default_driver;
  if (!e.active) e.dispatch = e.driver;
  if (e.context && e.context->handle == context && !e.context->destroyed.load(std::memory_order_relaxed)) return;
  set_active(e, nullptr);
  forget_arrays(e);
  frame_ended(e);  // another context has other buffers
  const std::lock_guard lock(records_mutex);
  if (e.context) {
    e.context->inside = e.inside;
    e.context->list = e.list;
    release(e.context);
    e.context = nullptr;
  }
  e.inside = false;
  e.list = nullptr;
  if (!context) return;
  ContextRecord* record = *find(context);
  if (!record && !(record = add(context, nullptr))) return;
  ++record->users;
  e.context = record;
  e.inside = record->inside;
  e.list = record->list;
  record->list = nullptr;
  if (e.list && keeps(*e.list)) e.driver = e.dispatch = &keeping;
}

void context_created(const void* context, const void* share) {
  context_destroyed(context);
  const std::lock_guard lock(records_mutex);
  ContextRecord* const other = share ? *find(share) : nullptr;
  if (other && other->group) other->group->users.fetch_add(1, std::memory_order_relaxed);
  add(context, other ? other->group : nullptr);
}

void context_destroyed(const void* context) {
  const std::lock_guard lock(records_mutex);
  ContextRecord** x = find(context);
  if (!*x) return;
  ContextRecord* record = *x;
  // Out of the list at once: the next context may get the same handle while this one is still current somewhere.
  *x = record->next;
  record->destroyed.store(true, std::memory_order_relaxed);
  if (record->users == 0) destroy(record);
}

}  // namespace truequad
