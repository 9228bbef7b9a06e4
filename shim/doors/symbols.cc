// What dlsym(3) answers for names that have doors.
#include <dlfcn.h>

#include "doors/doors.h"
#include "doors/dynamic_linker.h"

namespace truequad {
namespace {

// Null, with the dynamic linker's own words for it in dlerror(). Not by a call in the last place: that would be a jump,
// and RTLD_NEXT what comes after the program, which is our door.
void* nothing(const char* name) {
  real_dlsym()(RTLD_NEXT, name);
  return nullptr;
}

}  // namespace

void* door(std::string_view name) {
  if (void* found = command_door(name)) return found;
  return window_system_door(name);
}

void* symbol_of_handle(void* handle, const char* name, const void* caller) {
  void* const real = real_dlsym()(handle, name);
  if (!real || is_looking_up()) return real;
  void* answer = real;
  if (is_ours(real)) {
    // The program itself as handle: the global scope, which has our doors for everything.
    if (!is_behind_us(name)) return nothing(name);
  } else if (leads_to_driver(name, real) && !leads_to_driver(name, caller)) {
    // A driver, or a hook that our doors lead to, asks for what is behind it: our door would send it round for ever.
    if (void* ours = door(name)) answer = ours;
  }
  // Where we looked and found nothing is not the program's failure: programs ask dlerror() whether dlsym() succeeded.
  dlerror();
  return answer;
}

bool is_ours_alone(void* scope, const char* name) {
  // A program's own function of the name is in the global scope, but never next.
  const void* found = scope == RTLD_DEFAULT ? real_dlsym()(RTLD_DEFAULT, name) : nullptr;
  if ((!found || is_ours(found)) && !is_behind_us(name)) return nothing(name) == nullptr;
  dlerror();
  return false;
}

}  // namespace truequad
