// Linked with libGL, yet two functions of these names are its own: they count, and hand on to what comes next.
#include <dlfcn.h>

#include "glx_window.h"

namespace {
int begins = 0, vertices = 0;
}

extern "C" {
[[gnu::visibility("default")]] void glBegin(GLenum mode) {
  ++begins;
  reinterpret_cast<decltype(&glBegin)>(dlsym(RTLD_NEXT, "glBegin"))(mode);
}
[[gnu::visibility("default")]] void glVertex2f(GLfloat x, GLfloat y) {
  ++vertices;
  reinterpret_cast<decltype(&glVertex2f)>(dlsym(RTLD_NEXT, "glVertex2f"))(x, y);
}
}

int main() {
  using namespace loaders;
  if (!open_window({glXChooseVisual, glXCreateContext, glXMakeCurrent})) return 4;
#define LOADERS_LINKED(name) gl##name,
  const int status = show({LOADERS_FUNCTIONS(LOADERS_LINKED)});
#undef LOADERS_LINKED
  // Its own calls alone, whoever draws meshes behind.
  return begins == 1 && vertices == 4 ? status : 6;
}
