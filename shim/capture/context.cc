#include "capture/context.h"

#include <mutex>
#include <new>

#include "capture/capture.h"
#include "capture/stats.h"

namespace truequad {

constinit thread_local Entry entry [[gnu::tls_model("initial-exec")]] = {
    &default_driver, nullptr, &default_driver, nullptr, nullptr, false, false};

namespace {

constinit std::mutex records_mutex;
constinit ContextRecord* records = nullptr;

// Both with records_mutex held.
ContextRecord** find(const void* handle) {
  ContextRecord** x = &records;
  while (*x && (*x)->handle != handle) x = &(*x)->next;
  return x;
}
void release(ContextRecord* record) {
  if (--record->users == 0 && record->destroyed.load(std::memory_order_relaxed)) delete record;
}

}  // namespace

void context_made_current(Entry& e, const void* context, const Driver* driver) {
  stats_engage();
  e.driver = driver ? driver : &default_driver;
  if (!e.active) e.dispatch = e.driver;
  if (e.context && e.context->handle == context && !e.context->destroyed.load(std::memory_order_relaxed)) return;
  set_active(e, nullptr);
  frame_ended(e);  // another context has other buffers
  const std::lock_guard lock(records_mutex);
  if (e.context) {
    e.context->inside = e.inside;
    e.context->list_open = e.list_open;
    release(e.context);
    e.context = nullptr;
  }
  e.inside = e.list_open = false;
  if (!context) return;
  ContextRecord* record = *find(context);
  if (!record) {
    record = new (std::nothrow) ContextRecord;
    if (!record) return;
    record->handle = context;
    record->next = records;
    records = record;
  }
  ++record->users;
  e.context = record;
  e.inside = record->inside;
  e.list_open = record->list_open;
}

void context_destroyed(const void* context) {
  const std::lock_guard lock(records_mutex);
  ContextRecord** x = find(context);
  if (!*x) return;
  ContextRecord* record = *x;
  // Out of the list at once: the next context may get the same handle while this one is still current somewhere.
  *x = record->next;
  record->destroyed.store(true, std::memory_order_relaxed);
  if (record->users == 0) delete record;
}

}  // namespace truequad
