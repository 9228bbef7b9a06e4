// A plug-in that has a function of OpenGL's name which is none of OpenGL's.
#include <dlfcn.h>

extern "C" {
[[gnu::visibility("default")]] int layer() { return 4; }
[[gnu::visibility("default")]] int glBegin() { return 5; }
[[gnu::visibility("default")]] int layer_of_plug_in() { return 6; }
[[gnu::visibility("default")]] int ask_default() {
  void* const function = dlsym(RTLD_DEFAULT, "layer_of_plug_in");
  return function ? reinterpret_cast<int (*)()>(function)() : -1;
}
}
