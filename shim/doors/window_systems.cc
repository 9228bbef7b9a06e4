// GLX, EGL and OSMesa: which context is current on which thread, and getProcAddress. The handles are opaque to us, so
// no window-system header is needed; signatures: GLX 1.4, EGL 1.5, GL/osmesa.h.
#include <atomic>

#include "capture/capture.h"
#include "doors/doors.h"

namespace truequad {
namespace {

// The real function behind a door, looked up once.
template <typename Function>
class Real {
 public:
  constexpr Real(Api api, const char* name) : api_(api), name_(name) {}
  Function get() {
    void* function = function_.load(std::memory_order_relaxed);
    if (!function) {
      function = interface_function(api_, name_);
      function_.store(function, std::memory_order_relaxed);
    }
    return reinterpret_cast<Function>(function);
  }

 private:
  Api api_;
  const char* name_;
  std::atomic<void*> function_ = nullptr;
};

// Whatever is still held goes to the context that it was meant for.
void settle() {
  if (entry.active) barrier(entry);
}

}  // namespace
}  // namespace truequad

// A door that only settles: `name` of type `result parameters`.
#define TQ_SETTLING_DOOR(api, result, name, parameters, arguments)                      \
  TRUEQUAD_DOOR result name parameters {                                           \
    static constinit truequad::Real<result(*) parameters> real(api, #name);             \
    truequad::settle();                                                            \
    const auto function = real.get();                                              \
    return function ? function arguments : result();                               \
  }

// A door that makes `context` current on this thread.
#define TQ_MAKE_CURRENT_DOOR(api, result, name, parameters, arguments, context)                             \
  TRUEQUAD_DOOR result name parameters {                                                                    \
    static constinit truequad::Real<result(*) parameters> real(api, #name);                                      \
    truequad::settle();                                                                                     \
    const auto function = real.get();                                                                       \
    const result done = function ? function arguments : result();                                           \
    if (done) truequad::context_made_current(truequad::entry, context, truequad::driver_of(api));           \
    return done;                                                                                            \
  }

// A door that destroys `context`.
#define TQ_DESTROY_DOOR(api, result, name, parameters, arguments, context)              \
  TRUEQUAD_DOOR result name parameters {                                           \
    static constinit truequad::Real<result(*) parameters> real(api, #name);             \
    truequad::settle();                                                            \
    const auto function = real.get();                                              \
    if (!function) return result();                                                \
    truequad::context_destroyed(context);                                          \
    return function arguments;                                                     \
  }

extern "C" {

// The casts only discard types that these doors never look into.
using Handle = void*;
using Drawable = unsigned long;
using Status = int;
using Boolean = unsigned int;
using Enum = unsigned int;
using Byte = unsigned char;

TQ_MAKE_CURRENT_DOOR(truequad::Api::kGlx, Status, glXMakeCurrent, (Handle display, Drawable drawable, Handle context),
                     (display, drawable, context), context)
TQ_MAKE_CURRENT_DOOR(truequad::Api::kGlx, Status, glXMakeContextCurrent,
                     (Handle display, Drawable draw, Drawable read, Handle context), (display, draw, read, context),
                     context)
TQ_MAKE_CURRENT_DOOR(truequad::Api::kGlx, Status, glXMakeCurrentReadSGI,
                     (Handle display, Drawable draw, Drawable read, Handle context), (display, draw, read, context),
                     context)
TQ_DESTROY_DOOR(truequad::Api::kGlx, void, glXDestroyContext, (Handle display, Handle context), (display, context), context)
TQ_SETTLING_DOOR(truequad::Api::kGlx, void, glXSwapBuffers, (Handle display, Drawable drawable), (display, drawable))
TQ_SETTLING_DOOR(truequad::Api::kGlx, void, glXWaitGL, (), ())
TQ_SETTLING_DOOR(truequad::Api::kGlx, void, glXCopyContext, (Handle display, Handle source, Handle target, unsigned long mask),
                 (display, source, target, mask))
TQ_SETTLING_DOOR(truequad::Api::kGlx, void, glXUseXFont, (unsigned long font, int first, int count, int base), (font, first, count, base))

TQ_MAKE_CURRENT_DOOR(truequad::Api::kEgl, Boolean, eglMakeCurrent,
                     (Handle display, Handle draw, Handle read, Handle context), (display, draw, read, context),
                     context)
TQ_MAKE_CURRENT_DOOR(truequad::Api::kEgl, Boolean, eglReleaseThread, (), (), nullptr)
TQ_DESTROY_DOOR(truequad::Api::kEgl, Boolean, eglDestroyContext, (Handle display, Handle context), (display, context), context)
TQ_SETTLING_DOOR(truequad::Api::kEgl, Boolean, eglTerminate, (Handle display), (display))
TQ_SETTLING_DOOR(truequad::Api::kEgl, Boolean, eglSwapBuffers, (Handle display, Handle surface), (display, surface))
TQ_SETTLING_DOOR(truequad::Api::kEgl, Boolean, eglSwapBuffersWithDamageEXT,
                 (Handle display, Handle surface, const int* rectangles, int count),
                 (display, surface, rectangles, count))
TQ_SETTLING_DOOR(truequad::Api::kEgl, Boolean, eglSwapBuffersWithDamageKHR,
                 (Handle display, Handle surface, const int* rectangles, int count),
                 (display, surface, rectangles, count))
TQ_SETTLING_DOOR(truequad::Api::kEgl, Boolean, eglWaitGL, (), ())
TQ_SETTLING_DOOR(truequad::Api::kEgl, Boolean, eglWaitClient, (), ())
TQ_SETTLING_DOOR(truequad::Api::kEgl, Boolean, eglCopyBuffers, (Handle display, Handle surface, Handle target), (display, surface, target))

TQ_MAKE_CURRENT_DOOR(truequad::Api::kOsmesa, Byte, OSMesaMakeCurrent,
                     (Handle context, Handle buffer, Enum type, int width, int height),
                     (context, buffer, type, width, height), context)
TQ_DESTROY_DOOR(truequad::Api::kOsmesa, void, OSMesaDestroyContext, (Handle context), (context), context)

#define TQ_GET_PROC_ADDRESS_DOOR(api, name, Name)                                      \
  TRUEQUAD_DOOR Handle name(Name symbol) {                                        \
    static constinit truequad::Real<Handle (*)(Name)> real(api, #name);                \
    const auto function = real.get();                                             \
    if (!function) return nullptr;                                                \
    return truequad::answer(reinterpret_cast<const char*>(symbol), function(symbol)); \
  }
TQ_GET_PROC_ADDRESS_DOOR(truequad::Api::kGlx, glXGetProcAddress, const unsigned char*)
TQ_GET_PROC_ADDRESS_DOOR(truequad::Api::kGlx, glXGetProcAddressARB, const unsigned char*)
TQ_GET_PROC_ADDRESS_DOOR(truequad::Api::kEgl, eglGetProcAddress, const char*)
TQ_GET_PROC_ADDRESS_DOOR(truequad::Api::kOsmesa, OSMesaGetProcAddress, const char*)

}  // extern "C"

namespace truequad {

void* window_system_door(std::string_view name) {
  struct Door {
    std::string_view name;
    void* function;
  };
#define TQ_DOOR(function) {#function, reinterpret_cast<void*>(&function)}
  static const Door doors[] = {
      TQ_DOOR(glXMakeCurrent),         TQ_DOOR(glXMakeContextCurrent),
      TQ_DOOR(glXMakeCurrentReadSGI),  TQ_DOOR(glXDestroyContext),
      TQ_DOOR(glXSwapBuffers),         TQ_DOOR(glXWaitGL),
      TQ_DOOR(glXCopyContext),         TQ_DOOR(glXUseXFont),
      TQ_DOOR(glXGetProcAddress),      TQ_DOOR(glXGetProcAddressARB),
      TQ_DOOR(eglMakeCurrent),         TQ_DOOR(eglReleaseThread),
      TQ_DOOR(eglDestroyContext),      TQ_DOOR(eglTerminate),
      TQ_DOOR(eglSwapBuffers),         TQ_DOOR(eglSwapBuffersWithDamageEXT),
      TQ_DOOR(eglSwapBuffersWithDamageKHR), TQ_DOOR(eglWaitGL),
      TQ_DOOR(eglWaitClient),          TQ_DOOR(eglCopyBuffers),
      TQ_DOOR(eglGetProcAddress),      TQ_DOOR(OSMesaMakeCurrent),
      TQ_DOOR(OSMesaDestroyContext),   TQ_DOOR(OSMesaGetProcAddress),
  };
#undef TQ_DOOR
  for (const Door& door : doors) {
    if (door.name == name) return door.function;
  }
  return nullptr;
}

}  // namespace truequad
