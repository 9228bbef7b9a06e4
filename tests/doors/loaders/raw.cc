// raw local|global|deepbind [get-proc-address]: opens libGL with dlopen() and finds all of it with dlsym(), or just
// glXGetProcAddress.
#include <dlfcn.h>

#include <cstring>

#include "glx_window.h"

int main(int argc, char** argv) {
  using namespace loaders;
  const char* scope = argc > 1 ? argv[1] : "local";
  const int mode = !std::strcmp(scope, "global")     ? RTLD_GLOBAL
                   : !std::strcmp(scope, "deepbind") ? RTLD_LOCAL | RTLD_DEEPBIND
                                                     : RTLD_LOCAL;
  void* const library = dlopen("libGL.so.1", RTLD_LAZY | mode);
  if (!library) return std::fprintf(stderr, "%s\n", dlerror()), 3;
  const auto symbol = [library](const char* name) { return dlsym(library, name); };
  const auto get = reinterpret_cast<decltype(&::glXGetProcAddressARB)>(symbol("glXGetProcAddressARB"));
  const bool asks = argc > 2;
  const auto find = [&](const char* name) {
    return asks ? reinterpret_cast<void*>(get(reinterpret_cast<const GLubyte*>(name))) : symbol(name);
  };
  return open_window(find_glx(find)) ? show(find_functions(find)) : 4;
}
