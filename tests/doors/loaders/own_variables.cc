// Exports variables of the functions' own names, for what it finds in a libGL that it opens, as many programs did. Also built
// as a plug-in, which plug_in_host loads.
#include <dlfcn.h>

#include "glx_window.h"

namespace loaders {
// The headers declare functions of these names.
#define LOADERS_OWN(name) [[gnu::visibility("default")]] decltype(&::gl##name) own_##name __asm__("gl" #name) = nullptr;
LOADERS_FUNCTIONS(LOADERS_OWN)
#undef LOADERS_OWN
}  // namespace loaders

extern "C" [[gnu::visibility("default")]] int contexts_main(int, char**) {
  using namespace loaders;
  void* const library = dlopen("libGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (!library) return std::fprintf(stderr, "%s\n", dlerror()), 3;
  const auto find = [library](const char* name) { return dlsym(library, name); };
#define LOADERS_FILL(name) own_##name = reinterpret_cast<decltype(own_##name)>(find("gl" #name));
  LOADERS_FUNCTIONS(LOADERS_FILL)
#undef LOADERS_FILL
#define LOADERS_OWN(name) own_##name,
  return open_window(find_glx(find)) ? show({LOADERS_FUNCTIONS(LOADERS_OWN)}) : 4;
#undef LOADERS_OWN
}

int main(int argc, char** argv) { return contexts_main(argc, argv); }
