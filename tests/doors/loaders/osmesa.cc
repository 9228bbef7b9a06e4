// osmesa local|global|deepbind|linked: draws into memory, with libOSMesa opened by dlopen() or linked.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstring>
#include <string>

#include "scene.h"

namespace {

template <typename Create, typename MakeCurrent>
bool open(Create create, MakeCurrent make_current) {
  static unsigned char picture[loaders::kSize * loaders::kSize * 4];
  const OSMesaContext context = create(OSMESA_RGBA, nullptr);
  return context && make_current(context, picture, GL_UNSIGNED_BYTE, loaders::kSize, loaders::kSize);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace loaders;
  const std::string scope = argc > 1 ? argv[1] : "";
#ifdef LOADERS_OSMESA_LINKED
  if (!open(OSMesaCreateContext, OSMesaMakeCurrent)) return 4;
#define LOADERS_FUNCTION(name) gl##name,
  return show({LOADERS_FUNCTIONS(LOADERS_FUNCTION)});
#else
  const int mode = scope == "global" ? RTLD_GLOBAL : scope == "deepbind" ? RTLD_LOCAL | RTLD_DEEPBIND : RTLD_LOCAL;
  void* const library = dlopen("libOSMesa.so.8", RTLD_LAZY | mode);
  if (!library) return std::fprintf(stderr, "%s\n", dlerror()), 3;
  const auto find = [library](const char* name) { return dlsym(library, name); };
  if (!open(reinterpret_cast<decltype(&::OSMesaCreateContext)>(find("OSMesaCreateContext")),
            reinterpret_cast<decltype(&::OSMesaMakeCurrent)>(find("OSMesaMakeCurrent")))) {
    return 4;
  }
  return show(find_functions(find));
#endif
}
