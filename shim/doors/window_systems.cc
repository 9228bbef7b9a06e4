// GLX, EGL and OSMesa: which context is current on which thread, and getProcAddress. The functions are listed in
// window_system_doors.inc.
#include <atomic>
#include <cstdint>

#include "capture/capture.h"
#include "capture/list_compile.h"
#include "capture/list_play.h"
#include "config/log.h"
#include "config/options.h"
#include "doors/doors.h"
#include "doors/provider.h"

namespace truequad {
namespace {

// The real function behind a door, looked up once. Calls to one that does not exist return zero: a program was linked with us,
// but not with what we stand for.
template <typename Function>
class Real;
template <typename Result, typename... Parameters>
class Real<Result (*)(Parameters...)> {
 public:
  constexpr Real(Api api, const char* name) : api_(api), name_(name) {}
  Result operator()(Parameters... arguments) {
    void* function = function_.load(std::memory_order_relaxed);
    if (!function) {
      function = interface_symbol(api_, name_);
      function_.store(function, std::memory_order_relaxed);
    }
    if (function) return reinterpret_cast<Result (*)(Parameters...)>(function)(arguments...);
    if (!said_.exchange(true, std::memory_order_relaxed)) {
      options();  // whether anything shall be said
      log_warning("no library of this process has %s; calls to it do nothing", name_);
    }
    return Result();
  }

 private:
  Api api_;
  const char* name_;
  std::atomic<void*> function_ = nullptr;
  std::atomic<bool> said_ = false;
};

// Whatever is still held goes to the context that it was meant for.
void settle() { barrier(entry); }

void made_current(Api api, const void* context) {
  let_first_copy_work();
  // A thread may release an API that is not the one it draws with.
  if (!context && real_driver(entry) != driver_of(api)) return;
  context_made_current(entry, context, driver_of(api));
}

// What a getProcAddress answers: nothing where the driver has nothing, else our door if there is one.
void* answer(const char* name, void* real) {
  if (!real || !name || is_looking_up()) return real;
  void* ours = door(name);
  return ours ? ours : real;
}

}  // namespace
}  // namespace truequad

// What the signatures are made of; only the sizes matter.
using Handle = void*;
using Drawable = unsigned long;
using Status = int;
using Boolean = unsigned int;
using Enum = unsigned int;
using Byte = unsigned char;
using Count = std::int64_t;

#define TQ_REAL(api, result, name, parameters) \
  static constinit truequad::Real<result(*) parameters> tq_real(truequad::Api::api, #name)

#define TQ_SETTLE(api, result, name, parameters, arguments) \
  TRUEQUAD_DOOR result name parameters {                    \
    TQ_REAL(api, result, name, parameters);                 \
    truequad::settle();                                     \
    return tq_real arguments;                               \
  }

#define TQ_MAKE_LISTS(api, name, parameters, arguments, base, count) \
  TRUEQUAD_DOOR void name parameters {                               \
    TQ_REAL(api, void, name, parameters);                            \
    truequad::settle();                                              \
    tq_real arguments;                                               \
    truequad::lists_made(truequad::entry, GLuint(base), count);      \
  }

#define TQ_SWAP(api, result, name, parameters, arguments) \
  TRUEQUAD_DOOR result name parameters {                  \
    TQ_REAL(api, result, name, parameters);               \
    truequad::settle();                                   \
    truequad::frame_ended(truequad::entry);               \
    return tq_real arguments;                             \
  }

#define TQ_MAKE_CURRENT(api, result, name, parameters, arguments, context) \
  TRUEQUAD_DOOR result name parameters {                                   \
    TQ_REAL(api, result, name, parameters);                                \
    truequad::settle();                                                    \
    const result tq_done = tq_real arguments;                              \
    if (tq_done) truequad::made_current(truequad::Api::api, context);      \
    return tq_done;                                                        \
  }

#define TQ_CREATE(api, name, parameters, arguments, share)               \
  TRUEQUAD_DOOR Handle name parameters {                                 \
    TQ_REAL(api, Handle, name, parameters);                              \
    truequad::settle();                                                  \
    const Handle tq_context = tq_real arguments;                         \
    if (tq_context) truequad::context_created(tq_context, share);        \
    return tq_context;                                                   \
  }

// Told before it happens: afterwards another thread may already have got a new context with this handle.
#define TQ_DESTROY(api, result, name, parameters, arguments, context) \
  TRUEQUAD_DOOR result name parameters {                              \
    TQ_REAL(api, result, name, parameters);                           \
    truequad::settle();                                               \
    truequad::context_destroyed(context);                             \
    return tq_real arguments;                                         \
  }

#define TQ_GET_PROC_ADDRESS(api, name, Name)                                            \
  TRUEQUAD_DOOR Handle name(Name tq_name) {                                             \
    TQ_REAL(api, Handle, name, (Name));                                                 \
    return truequad::answer(reinterpret_cast<const char*>(tq_name), tq_real(tq_name));  \
  }

extern "C" {
#include "doors/window_system_doors.inc"
}

#undef TQ_MAKE_LISTS
#undef TQ_SWAP
#undef TQ_SETTLE
#undef TQ_MAKE_CURRENT
#undef TQ_CREATE
#undef TQ_DESTROY
#undef TQ_GET_PROC_ADDRESS

namespace truequad {

void* window_system_door(std::string_view name) {
  struct Door {
    const char* name;
    void* function;
  };
#define TQ_DOOR(function) {#function, reinterpret_cast<void*>(&function)},
#define TQ_MAKE_LISTS(api, name, ...) TQ_DOOR(name)
#define TQ_SWAP(api, result, name, ...) TQ_DOOR(name)
#define TQ_SETTLE(api, result, name, ...) TQ_DOOR(name)
#define TQ_MAKE_CURRENT(api, result, name, ...) TQ_DOOR(name)
#define TQ_CREATE(api, name, ...) TQ_DOOR(name)
#define TQ_DESTROY(api, result, name, ...) TQ_DOOR(name)
#define TQ_GET_PROC_ADDRESS(api, name, ...) TQ_DOOR(name)
  static const Door doors[] = {
#include "doors/window_system_doors.inc"
  };
  for (const Door& door : doors) {
    if (name == door.name) return door.function;
  }
  return nullptr;
}

}  // namespace truequad
