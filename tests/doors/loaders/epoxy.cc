// libepoxy, which finds each command at its first call and asks which of GLX and EGL the process uses.
#include "glx_window.h"

// Epoxy's headers and GL's exclude each other; what it exports are variables, first for functions that find the others.
#define EPOXY(name) extern decltype(&::name) epoxy_##name;
#define EPOXY_COMMAND(name) EPOXY(gl##name)
extern "C" {
LOADERS_FUNCTIONS(EPOXY_COMMAND)
EPOXY(glXChooseVisual)
EPOXY(glXCreateContext)
EPOXY(glXMakeCurrent)
bool epoxy_has_glx(Display* display);
bool epoxy_is_desktop_gl();
int epoxy_gl_version();
}

int main() {
  using namespace loaders;
  Display* display = XOpenDisplay(nullptr);
  if (!display || !epoxy_has_glx(display)) return 3;
  if (!open_window({epoxy_glXChooseVisual, epoxy_glXCreateContext, epoxy_glXMakeCurrent})) return 4;
  if (!epoxy_is_desktop_gl() || epoxy_gl_version() < 20) return 5;
#define EPOXY_FUNCTION(name) epoxy_gl##name,
  return show({LOADERS_FUNCTIONS(EPOXY_FUNCTION)});
}
