// truequad as a vendor of libglvnd (Linux OpenGL ABI proposal, libglvnd's libglxabi.h and libeglabi.h): libGLX and libEGL load it
// instead of the driver's vendor library, and it hands over that library's own table with one function changed, the
// one that finds all others. So it sees what programs call however they found libGL, and nothing is preloaded.
#include <dlfcn.h>
#include <glvnd/libeglabi.h>
#include <glvnd/libglxabi.h>

#include "config/log.h"
#include "config/options.h"
#include "doors/doors.h"
#include "doors/dynamic_linker.h"

namespace truequad {
namespace {

// True if our exports are in the global scope as well. Then they are in front of libGL already, and calls must not come by twice.
bool is_preloaded() {
  void* const program = real_dlopen()(nullptr, RTLD_LAZY);
  const void* const found = program ? real_dlsym()(program, __GLX_MAIN_PROTO_NAME) : nullptr;
  return found && is_ours(found);
}

// The driver's own library has its interface filled in; null if there is none.
template <typename Main>
Main main_of(const char* library, const char* name) {
  void* const handle = *library ? real_dlopen()(library, RTLD_LAZY) : nullptr;
  void* const found = handle ? real_dlsym()(handle, name) : nullptr;
  if (found && !is_ours(found)) return reinterpret_cast<Main>(found);
  log_warning("as vendor library: TRUEQUAD_VENDOR does not name the driver's (start programs by truequad --vendor)");
  return nullptr;
}

template <Api api, typename Character>
void* get_proc_address(const Character* name) {
  const char* const text = reinterpret_cast<const char*>(name);
  void* const real = vendor_symbol(api, text);
  void* const ours = real ? door(text) : nullptr;
  return ours ? ours : real;
}

template <Api api, typename Imports>
void stand_between(Imports& imports) {
  set_vendor(api, reinterpret_cast<GetProcAddress>(imports.getProcAddress));
  imports.getProcAddress = get_proc_address<api>;
  // A driver that rewrites libGL's own code to lead to itself would pass by us. These are optional.
  imports.isPatchSupported = nullptr;
  imports.initiatePatch = nullptr;
  imports.releasePatch = nullptr;
}

}  // namespace
}  // namespace truequad

extern "C" {

TRUEQUAD_DOOR Bool __glx_Main(uint32_t version, const __GLXapiExports* exports, __GLXvendorInfo* vendor,
                              __GLXapiImports* imports) {
  using namespace truequad;
  const auto real = main_of<__PFNGLXMAINPROC>(options().vendor_glx, __GLX_MAIN_PROTO_NAME);
  if (!real || !real(version, exports, vendor, imports)) return False;
  if (!is_preloaded()) stand_between<Api::kGlx>(*imports);
  return True;
}

TRUEQUAD_DOOR EGLBoolean __egl_Main(uint32_t version, const __EGLapiExports* exports, __EGLvendorInfo* vendor,
                                    __EGLapiImports* imports) {
  using namespace truequad;
  const auto real = main_of<__PFNEGLMAINPROC>(options().vendor_egl, __EGL_MAIN_PROTO_NAME);
  if (!real || !real(version, exports, vendor, imports)) return EGL_FALSE;
  if (!is_preloaded()) stand_between<Api::kEgl>(*imports);
  return EGL_TRUE;
}

}  // extern "C"
