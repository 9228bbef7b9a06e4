// Lazy resolution. A slot of a table first holds a thunk that finds the real function, stores it and calls it; so the
// vertex path is one indirect call, and nothing is looked up that the program does not use.
#include "doors/provider.h"

#include "capture/entry.h"
#include "capture/list_compile.h"
#include "config/log.h"
#include "config/options.h"
#include "doors/doors.h"

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

// Stands for what the driver lacks: a call without effect, so that our exports promise nothing that could crash.
template <typename Function>
struct Missing;
template <typename Result, typename... Parameters>
struct Missing<Result (*)(Parameters...)> {
  static Result call(Parameters...) { return Result(); }
};

constexpr Driver make_thunks() {
  return Driver{
#define TQ_COMMAND(name, result, parameters, arguments) .name = Thunk<kCommand##name, result(*) parameters>::call,
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

Api api_of(const Driver* driver) {
  if (driver == &glx_driver) return Api::kGlx;
  if (driver == &egl_driver) return Api::kEgl;
  if (driver == &osmesa_driver) return Api::kOsmesa;
  return Api::kNext;
}

// Other threads load from the table by plain loads, so that a door is one instruction and a jump. That is a race in the language; on
// every machine a pointer is stored as a whole, and whether they still find the thunk does not matter: it stores the same pointer.
[[gnu::noinline, gnu::no_sanitize("thread")]] void store_function(void* volatile* slot, void* function) { *slot = function; }

void* resolve(CommandIndex index) {
  let_first_copy_work();
  watch_exit();
  const Driver* driver = real_driver(entry);
  const Api api = api_of(driver);
  void* function = command_symbol(api, kNames[index]);
  if (!function) {
    options();  // whether anything shall be said
    log_warning("the driver has no %s; calls to it do nothing", kNames[index]);
    function = slots(kMissing)[index];
  }
  store_function(const_cast<void**>(slots(*driver)) + index, function);
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

}  // namespace truequad
