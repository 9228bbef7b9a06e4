#include <GL/glx.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>

#include "canvas.h"

namespace truequad::images {

void open_canvas(int width, int height) {
  Display* display = XOpenDisplay(nullptr);
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        GLX_PBUFFER_BIT,
                        GLX_RENDER_TYPE,
                        GLX_RGBA_BIT,
                        GLX_RED_SIZE,
                        8,
                        GLX_GREEN_SIZE,
                        8,
                        GLX_BLUE_SIZE,
                        8,
                        GLX_ALPHA_SIZE,
                        8,
                        GLX_DEPTH_SIZE,
                        24,
                        GLX_STENCIL_SIZE,
                        8,
                        None};
  const int size[] = {GLX_PBUFFER_WIDTH, width, GLX_PBUFFER_HEIGHT, height, None};
  int count = 0;
  GLXFBConfig* configs =
      display ? glXChooseFBConfig(display, DefaultScreen(display), wanted, &count) : nullptr;
  if (count > 0) {
    const GLXPbuffer surface = glXCreatePbuffer(display, configs[0], size);
    const GLXContext context = glXCreateNewContext(display, configs[0], GLX_RGBA_TYPE, nullptr, True);
    if (context && glXMakeContextCurrent(display, surface, surface, context)) return;
  }
  std::fprintf(stderr, "no GLX context\n");
  std::exit(70);
}

}  // namespace truequad::images
