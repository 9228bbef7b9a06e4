// The library of program.cc: its run path leads to the plug-in, and another library with layer() comes behind it.
#include <dlfcn.h>

#include <cstdio>

extern "C" {
[[gnu::visibility("default")]] int layer() { return 2; }

[[gnu::visibility("default")]] void ask_from_library() {
  const auto call = [](void* function) { return function ? reinterpret_cast<int (*)()>(function)() : -1; };
  std::printf("library: next %d\n", call(dlsym(RTLD_NEXT, "layer")));
  void* const plug_in = dlopen("libtq_linker_plug_in.so", RTLD_LAZY | RTLD_LOCAL);
  std::printf("library: plug-in %s\n", plug_in ? "found" : dlerror());
  if (!plug_in) return;
  std::printf("library: plug-in's layer %d, glBegin %d\n", call(dlsym(plug_in, "layer")), call(dlsym(plug_in, "glBegin")));
  // Local: not to be seen from here, but from itself.
  std::printf("library: default %d\n", call(dlsym(RTLD_DEFAULT, "layer_of_plug_in")));
  std::printf("plug-in: default %d\n", call(dlsym(plug_in, "ask_default")));
}
}
