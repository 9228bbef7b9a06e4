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
#include "doors/doors.h"
#include "doors/dynamic_linker.h"
#include "doors/loaded.h"

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
constinit std::array<std::atomic<GetProcAddress>, kApiCount> vendors = {};

GetProcAddress vendor_of(Api api) { return vendors[std::size_t(api)].load(std::memory_order_relaxed); }

void* symbol_in(void* library, const char* name) { return real_dlsym()(library, name); }

// The loaded library that an address belongs to, or null. dladdr(3) would look through all its symbols.
const link_map* library_at(const void* address) {
  dl_find_object found;
  return _dl_find_object(const_cast<void*>(address), &found) == 0 ? found.dlfo_link_map : nullptr;
}

// The function, unless it is our own: calling that would never end.
void* unless_ours(void* function, const char* name) {
  if (!function || !is_ours(function)) return function;
  static constinit std::atomic<bool> said = false;
  options();  // whether anything shall be said
  if (!said.exchange(true)) log_warning("%s of the driver leads back to truequad; looking elsewhere", name);
  return nullptr;
}

// What follows us in the global scope. Libraries of the program may have variables of the same name, for pointers that
// getProcAddress gave; only functions count.
void* follower(const char* name) {
  void* function = unless_ours(symbol_in(RTLD_NEXT, name), name);
  Dl_info info;
  void* entry = nullptr;
  if (!function || !dladdr1(function, &info, &entry, RTLD_DL_SYMENT) || !entry) return nullptr;
  // The same bits in 32-bit files.
  return ELF64_ST_TYPE(static_cast<const ElfW(Sym)*>(entry)->st_info) == STT_FUNC ? function : nullptr;
}

void* loaded_library(const char* name) { return real_dlopen()(name, RTLD_LAZY | RTLD_LOCAL | RTLD_NOLOAD); }

void* in_libraries(Api api, const char* name) {
  for (const char* library_name : interface_of(api).libraries) {
    void* library = is_loaded(library_name) ? loaded_library(library_name) : nullptr;
    if (!library) continue;
    // A front end (front_ends/) has the name of a driver's library.
    void* function = symbol_in(library, name);
    if (function && !is_ours(function)) return function;
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
  const link_map* map = function ? library_at(function) : nullptr;
  if (!map) return nullptr;
  void* library = loaded_library(map->l_name);
  // Another thread may have stored the same handle; it is then counted twice, and stays open just so.
  slot.store(library, std::memory_order_relaxed);
  return library;
}

// True if a library holds the commands of an API.
bool serves(Api api, const link_map* library) {
  const void* make_current = next_symbol(api, interface_of(api).make_current);
  if (make_current && library_at(make_current) == library) return true;
  for (const char* library_name : interface_of(api).libraries) {
    // There may be two of a name; the first is the one that our calls go to.
    void* loaded = name_of(library) == library_name ? loaded_library(library_name) : nullptr;
    if (!loaded) continue;
    const link_map* map = nullptr;
    const bool same = dlinfo(loaded, RTLD_DI_LINKMAP, &map) == 0 && map == library;
    dlclose(loaded);
    if (same) return true;
  }
  return false;
}

bool serves_any(const link_map* library) {
  for (Api api : kRealApis) {
    if (serves(api, library)) return true;
  }
  return false;
}

// True if a function is the same command of another API's library: it would draw into that one's context.
bool is_foreign(Api api, const void* function) {
  const link_map* library = library_at(function);
  if (!library || serves(api, library)) return false;
  for (Api other : kRealApis) {
    if (other != api && serves(other, library)) return true;
  }
  return false;
}

// True for what a program without a handle finds: it is ours, or of a hook before us that leads to us. (A second copy
// of this library, and a driver that looks for itself in the global scope, would send each other round for ever.)
bool leads_to_us(const void* function, const char* name) { return function == symbol_in(RTLD_DEFAULT, name); }

// What the API's getProcAddress says.
void* ask(Api api, const char* name) {
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

void let_first_copy_work() {
  static constinit std::atomic<bool> asked = false;
  if (asked.load(std::memory_order_relaxed) || asked.exchange(true)) return;
  // A front end does not export the control API, and is never before the libraries that do.
  const void* const first = symbol_in(RTLD_DEFAULT, "truequad_read_statistics");
  if (first && !is_ours(first)) stand_back();
}

bool is_looking_up() { return looking_up; }

bool is_ours(const void* address) { return library_at(address) == library_at(&kInterfaces); }

bool is_behind_us(const char* name) {
  if (follower(name)) return true;
  for (Api api : kRealApis) {
    if (in_libraries(api, name)) return true;
  }
  return false;
}

bool leads_to_driver(const char* name, const void* function) {
  const link_map* library = library_at(function);
  const void* next = follower(name);
  return library && ((next && library_at(next) == library) || serves_any(library));
}

void* next_symbol(Api api, const char* name) {
  if (void* function = follower(name)) return function;
  return in_libraries(api, name);
}

void set_vendor(Api api, GetProcAddress get) {
  vendors[std::size_t(api)] = get;
  vendors[std::size_t(Api::kNext)] = get;
}

void* vendor_symbol(Api api, const char* name) {
  const bool outer = looking_up;
  looking_up = true;
  void* function = vendor_of(api)(name);
  looking_up = outer;
  return unless_ours(function, name);
}

void* command_symbol(Api api, const char* name) {
  if (vendor_of(api)) return vendor_symbol(api, name);
  if (api == Api::kNext) return next_symbol(api, name);
  void* function = follower(name);
  if (function && !is_foreign(api, function)) return function;
  if (void* library = library_of(api)) {
    if ((function = unless_ours(symbol_in(library, name), name))) return function;
  }
  if ((function = ask(api, name))) return function;
  return in_libraries(api, name);
}

void* interface_symbol(Api api, const char* name) {
  if (vendor_of(api)) return vendor_symbol(api, name);
  if (void* function = next_symbol(api, name)) return function;
  return ask(api, name);
}

}  // namespace truequad
