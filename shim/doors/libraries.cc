// Symbol lookup with dlsym(3) and dladdr1(3). A library that was found stays open: its functions stand in our tables,
// so it must not go away; the program's own dlclose() then merely leaves it loaded.
#include "doors/libraries.h"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <array>
#include <atomic>
#include <span>

#include "config/log.h"
#include "config/options.h"

namespace truequad {
namespace {

struct Interface {
  std::span<const char* const> libraries;  // where its commands may be found
  const char* make_current;                // whichever library has this has the API
  std::array<const char*, 2> get_proc_address;
};

// Names: Linux OpenGL ABI, section 3.2; libglvnd; Mesa's OSMesa. Both GLX and EGL serve the commands of libGL.
constexpr const char* kNextLibraries[] = {"libGL.so.1",     "libOpenGL.so.0", "libOSMesa.so.8",
                                          "libOSMesa.so.6", "libGLESv2.so.2", "libGLESv1_CM.so.1"};
constexpr const char* kGlxLibraries[] = {"libGL.so.1", "libGLX.so.0", "libOpenGL.so.0"};
constexpr const char* kEglLibraries[] = {"libEGL.so.1", "libGL.so.1", "libOpenGL.so.0", "libGLESv2.so.2",
                                         "libGLESv1_CM.so.1"};
constexpr const char* kOsmesaLibraries[] = {"libOSMesa.so.8", "libOSMesa.so.6"};

constexpr Interface kInterfaces[] = {
    {kNextLibraries, nullptr, {}},
    {kGlxLibraries, "glXMakeCurrent", {"glXGetProcAddressARB", "glXGetProcAddress"}},
    {kEglLibraries, "eglMakeCurrent", {"eglGetProcAddress"}},
    {kOsmesaLibraries, "OSMesaMakeCurrent", {"OSMesaGetProcAddress"}},
};
constexpr std::size_t kApiCount = std::size(kInterfaces);
constexpr Api kRealApis[] = {Api::kGlx, Api::kEgl, Api::kOsmesa};

const Interface& interface_of(Api api) { return kInterfaces[std::size_t(api)]; }

constinit thread_local bool looking_up = false;

// Where the library of an address is loaded, or null.
const void* base_of(const void* address) {
  Dl_info info;
  return dladdr(address, &info) ? info.dli_fbase : nullptr;
}

// The function, unless it is our own: calling that would never end.
void* unless_ours(void* function, const char* name) {
  if (!function || base_of(function) != base_of(&kInterfaces)) return function;
  static constinit std::atomic<bool> said = false;
  options();  // whether anything shall be said
  if (!said.exchange(true)) log_warning("%s of the driver leads back to truequad; looking elsewhere", name);
  return nullptr;
}

// What follows us in the global scope. Libraries of the program may have variables of the same name, for pointers that
// getProcAddress gave; only functions count.
void* follower(const char* name) {
  void* function = unless_ours(dlsym(RTLD_NEXT, name), name);
  Dl_info info;
  void* entry = nullptr;
  if (!function || !dladdr1(function, &info, &entry, RTLD_DL_SYMENT) || !entry) return nullptr;
  // The same bits in 32-bit files.
  return ELF64_ST_TYPE(static_cast<const ElfW(Sym)*>(entry)->st_info) == STT_FUNC ? function : nullptr;
}

void* loaded_library(const char* name) { return dlopen(name, RTLD_LAZY | RTLD_LOCAL | RTLD_NOLOAD); }

void* in_libraries(Api api, const char* name) {
  for (const char* library_name : interface_of(api).libraries) {
    void* library = loaded_library(library_name);
    if (!library) continue;
    if (void* function = unless_ours(dlsym(library, name), name)) return function;
    dlclose(library);
  }
  return nullptr;
}

// The library of an API, once the process has loaded it.
void* library_of(Api api) {
  static constinit std::array<std::atomic<void*>, kApiCount> kept = {};
  std::atomic<void*>& slot = kept[std::size_t(api)];
  if (void* library = slot.load(std::memory_order_relaxed)) return library;
  const char* make_current = interface_of(api).make_current;
  void* function = make_current ? next_symbol(api, make_current) : nullptr;
  Dl_info info;
  if (!function || !dladdr(function, &info) || !info.dli_fname) return nullptr;
  void* library = loaded_library(info.dli_fname);
  // Another thread may have stored the same handle; it is then counted twice, and stays open just so.
  slot.store(library, std::memory_order_relaxed);
  return library;
}

// True if the library at `base` holds the commands of an API.
bool serves(Api api, const void* base) {
  const void* make_current = next_symbol(api, interface_of(api).make_current);
  if (make_current && base_of(make_current) == base) return true;
  for (const char* library_name : interface_of(api).libraries) {
    void* library = loaded_library(library_name);
    if (!library) continue;
    const link_map* map = nullptr;
    const void* found = dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 ? base_of(map->l_ld) : nullptr;
    dlclose(library);
    if (found && found == base) return true;
  }
  return false;
}

// True if a function is the same command of another API's library: it would draw into that one's context.
bool is_foreign(Api api, const void* function) {
  const void* base = base_of(function);
  if (serves(api, base)) return false;
  for (Api other : kRealApis) {
    if (other != api && serves(other, base)) return true;
  }
  return false;
}

// True for what a program without a handle finds: it is ours, or of a hook before us that leads to us. (A second copy
// of this library, and a driver that looks for itself in the global scope, would send each other round for ever.)
bool leads_to_us(const void* function, const char* name) { return function == dlsym(RTLD_DEFAULT, name); }

// What the API's getProcAddress says.
void* ask(Api api, const char* name) {
  using GetProcAddress = void* (*)(const char*);
  for (const char* get_proc_address : interface_of(api).get_proc_address) {
    if (!get_proc_address) continue;
    const auto get = reinterpret_cast<GetProcAddress>(next_symbol(api, get_proc_address));
    if (!get) continue;
    const bool outer = looking_up;
    looking_up = true;
    void* function = get(name);
    looking_up = outer;
    if ((function = unless_ours(function, name)) && !leads_to_us(function, name)) return function;
  }
  return nullptr;
}

}  // namespace

bool is_looking_up() { return looking_up; }

void* next_symbol(Api api, const char* name) {
  if (void* function = follower(name)) return function;
  return in_libraries(api, name);
}

void* command_symbol(Api api, const char* name) {
  if (api == Api::kNext) return next_symbol(api, name);
  void* function = follower(name);
  if (function && !is_foreign(api, function)) return function;
  if (void* library = library_of(api)) {
    if ((function = unless_ours(dlsym(library, name), name))) return function;
  }
  if ((function = ask(api, name))) return function;
  return in_libraries(api, name);
}

void* interface_symbol(Api api, const char* name) {
  if (void* function = next_symbol(api, name)) return function;
  return ask(api, name);
}

}  // namespace truequad
