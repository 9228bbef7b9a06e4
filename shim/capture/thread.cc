// A thread's capture: allocated when it is first needed, freed when the thread ends.
#include <pthread.h>

#include <new>

#include "capture/capture.h"
#include "capture/correct.h"
#include "capture/settings.h"
#include "capture/state.h"

namespace truequad {
namespace {

void free_capture(void* own) {
  Capture* c = static_cast<Capture*>(own);
  // Other destructors of this thread may still use GL.
  entry.own = nullptr;
  set_active(entry, nullptr);
  stats_detach(c->counters);
  free_working_memory(*c);
  delete c;
}

}  // namespace

Capture* allocate_capture(Entry& e) {
  static pthread_key_t key;
  static const bool key_exists = ::pthread_key_create(&key, free_capture) == 0;
  Capture* c = new (std::nothrow) Capture;
  if (!c) return nullptr;
  c->entry = &e;
  c->options = &options();
  c->settings = c->chosen = settings_of(options());
  stats_engage();
  stats_attach(c->counters);
  if (key_exists) ::pthread_setspecific(key, c);
  e.own = c;
  return c;
}

Settings chosen_settings(const Entry& e) { return e.own ? e.own->chosen : settings_of(options()); }

bool choose_settings(Entry& e, const Settings& settings) {
  Capture* c = e.own ? e.own : allocate_capture(e);
  if (!c) return false;
  c->chosen = settings;
  if (!e.active) c->settings = settings;  // else when the next one begins
  return true;
}

}  // namespace truequad
