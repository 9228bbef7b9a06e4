// dlsym(3) and dlopen(3): how programs and toolkits find OpenGL that they are not linked with.
//
// The C library reads the return address to know who asks: RTLD_NEXT means "after the caller's library", RTLD_DEFAULT
// includes what the caller's library was loaded with, and run paths are the caller's. So these doors must not call the
// real functions, they must jump to them; a compiler makes a jump of a call in the last place, which is why this file
// is always optimised (CMakeLists.txt). It is never sanitized either: a sanitizer's runtime comes here before it works.
#include "doors/dynamic_linker.h"

#include <dlfcn.h>

#include <atomic>

#include "config/options.h"
#include "doors/doors.h"

#if defined(__has_cpp_attribute) && __has_cpp_attribute(clang::musttail)
#define TQ_JUMP [[clang::musttail]] return
#else
#define TQ_JUMP return
#endif

namespace truequad {
namespace {

// dlsym itself cannot be asked for dlsym. Versions: since glibc 2.34 these functions are part of libc; before that, and
// for programs linked then, they have the version of the architecture's first release.
template <typename Function>
Function real(std::atomic<Function>& kept, const char* name) {
  Function function = kept.load(std::memory_order_relaxed);
  if (function) [[likely]] return function;
  for (const char* version : {"GLIBC_2.34", "GLIBC_2.2.5", "GLIBC_2.17", "GLIBC_2.0"}) {
    function = reinterpret_cast<Function>(dlvsym(RTLD_NEXT, name, version));
    if (function) break;
  }
  kept.store(function, std::memory_order_relaxed);
  return function;
}

// Names such as glob, which a sanitizer's runtime asks for before anything of ours may run, must be told apart here.
bool may_have_door(const char* name) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (!name) return false;
  if (name[0] == 'g' && name[1] == 'l') return is_capital(name[2]);
  if (name[0] == 'e' && name[1] == 'g' && name[2] == 'l') return is_capital(name[3]);
  return name[0] == 'O' && name[1] == 'S' && name[2] == 'M';
}

}  // namespace

Dlsym real_dlsym() {
  static constinit std::atomic<Dlsym> kept = nullptr;
  return real(kept, "dlsym");
}

Dlopen real_dlopen() {
  static constinit std::atomic<Dlopen> kept = nullptr;
  return real(kept, "dlopen");
}

}  // namespace truequad

extern "C" {

TRUEQUAD_DOOR void* dlsym(void* __restrict handle, const char* __restrict name) noexcept {
  using namespace truequad;
  if (may_have_door(name) && options().dl != DynamicLinker::kOff) {
    // An explicit handle means the same for every caller, so it may be asked from here.
    if (handle != RTLD_NEXT && handle != RTLD_DEFAULT) {
      return symbol_of_handle(handle, name, __builtin_return_address(0));
    }
    if (is_ours_alone(handle, name)) return nullptr;
  }
  TQ_JUMP real_dlsym()(handle, name);
}

TRUEQUAD_DOOR void* dlopen(const char* file, int mode) noexcept {
  using namespace truequad;
  if ((mode & RTLD_DEEPBIND) && options().dl == DynamicLinker::kDlopen) mode &= ~RTLD_DEEPBIND;
  TQ_JUMP real_dlopen()(file, mode);
}

}  // extern "C"
