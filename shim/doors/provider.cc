// Lazy resolution. A slot of a table first holds a thunk that finds the real function, stores it and calls it; so the
// vertex path is one indirect call, and nothing is looked up that the program does not use.
#include "doors/provider.h"

#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cstdlib>

#include "capture/capture.h"
#include "config/log.h"

namespace truequad {
namespace {

void* resolve(CommandIndex index);

template <CommandIndex index, typename Function>
struct Thunk;
template <CommandIndex index, typename Result, typename... Parameters>
struct Thunk<index, Result (*)(Parameters...)> {
  static Result call(Parameters... parameters) {
    return reinterpret_cast<Result (*)(Parameters...)>(resolve(index))(parameters...);
  }
};

// Stands for what the driver lacks. Without us the program could not even have been linked; so it gets a call without
// effect.
template <typename Function>
struct Missing;
template <typename Result, typename... Parameters>
struct Missing<Result (*)(Parameters...)> {
  static Result call(Parameters...) { return Result(); }
};

constexpr Driver make_thunks() {
  return Driver{
#define TQ_COMMAND(name, result, parameters, arguments) \
  .name = Thunk<kCommand##name, result(*) parameters>::call,
#include "gl_commands.inc"
#undef TQ_COMMAND
  };
}

constexpr Driver make_missing() {
  return Driver{
#define TQ_COMMAND(name, result, parameters, arguments) .name = Missing<result(*) parameters>::call,
#include "gl_commands.inc"
#undef TQ_COMMAND
  };
}

constexpr const char* kNames[] = {
#define TQ_COMMAND(name, result, parameters, arguments) "gl" #name,
#include "gl_commands.inc"
#undef TQ_COMMAND
};

constexpr Driver kMissing = make_missing();
constinit Driver glx_driver = make_thunks();
constinit Driver egl_driver = make_thunks();
constinit Driver osmesa_driver = make_thunks();

// The table as the array of function pointers that it is.
void* const* slots(const Driver& driver) { return reinterpret_cast<void* const*>(&driver); }
static_assert(sizeof(Driver) == kCommandCount * sizeof(void*));

struct Interface {
  const char* make_current;  // who has this has the interface
  const char* get_proc_address;
};
constexpr std::array<Interface, 4> kInterfaces = {{{nullptr, nullptr},
                                                   {"glXMakeCurrent", "glXGetProcAddressARB"},
                                                   {"eglMakeCurrent", "eglGetProcAddress"},
                                                   {"OSMesaMakeCurrent", "OSMesaGetProcAddress"}}};

Api api_of(const Driver* driver) {
  if (driver == &glx_driver) return Api::kGlx;
  if (driver == &egl_driver) return Api::kEgl;
  if (driver == &osmesa_driver) return Api::kOsmesa;
  return Api::kNext;
}

// The library that holds the interface, already loaded by the process.
void* library_of(const Interface& interface) {
  void* function = next_symbol(interface.make_current);
  Dl_info info;
  if (!function || !dladdr(function, &info) || !info.dli_fname) return nullptr;
  return dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD | RTLD_LOCAL);
}

// What the interface's getProcAddress says.
void* ask(const Interface& interface, const char* name) {
  using GetProcAddress = void* (*)(const char*);
  const auto get = reinterpret_cast<GetProcAddress>(next_symbol(interface.get_proc_address));
  void* function = get ? get(name) : nullptr;
  return function && !is_ours(function) ? function : nullptr;
}

// The same name may stand in several libraries of a process (libOSMesa beside libGL): the interface's own library
// comes first, then what it says itself, then whatever follows us.
void* find(Api api, const char* name) {
  if (api != Api::kNext) {
    const Interface& interface = kInterfaces[std::size_t(api)];
    if (void* library = library_of(interface)) {
      void* function = dlsym(library, name);
      dlclose(library);
      if (function && !is_ours(function)) return function;
    }
    if (void* function = ask(interface, name)) return function;
  }
  return next_symbol(name);
}

// exit() runs this; _exit has a door of its own (process.cc).
void register_end() {
  static std::atomic<bool> registered = false;
  if (!registered.exchange(true)) std::atexit(process_ends);
}

void* resolve(CommandIndex index) {
  register_end();
  const Driver* driver = entry.driver;
  void* function = find(api_of(driver), kNames[index]);
  if (!function) {
    log_warning("the driver has no %s; calls to it do nothing", kNames[index]);
    function = slots(kMissing)[index];
  }
  // Threads that meet here store the same pointer.
  __atomic_store_n(const_cast<void**>(slots(*driver)) + index, function, __ATOMIC_RELAXED);
  return function;
}

}  // namespace

constinit Driver default_driver = make_thunks();

const Driver* driver_of(Api api) {
  switch (api) {
    case Api::kGlx: return &glx_driver;
    case Api::kEgl: return &egl_driver;
    case Api::kOsmesa: return &osmesa_driver;
    case Api::kNext: break;
  }
  return &default_driver;
}

void* interface_function(Api api, const char* name) {
  if (void* function = next_symbol(name)) return function;
  return ask(kInterfaces[std::size_t(api)], name);
}

bool is_ours(const void* address) {
  Dl_info theirs, ours;
  return dladdr(address, &theirs) && dladdr(reinterpret_cast<const void*>(&is_ours), &ours) &&
         theirs.dli_fbase == ours.dli_fbase;
}

void* next_symbol(const char* name) {
  void* function = dlsym(RTLD_NEXT, name);
  if (function && is_ours(function)) {
    static std::atomic<bool> said = false;
    if (!said.exchange(true)) log_warning("%s resolves to truequad itself; is it loaded twice?", name);
    return nullptr;
  }
  return function;
}

}  // namespace truequad
