// A window with a context by GLX, whose functions the program finds in its own way.
#pragma once

#include <GL/glx.h>

#include "scene.h"

namespace loaders {

struct Glx {
  decltype(&::glXChooseVisual) ChooseVisual;
  decltype(&::glXCreateContext) CreateContext;
  decltype(&::glXMakeCurrent) MakeCurrent;
};

template <typename Find>
Glx find_glx(const Find& find) {
  return {reinterpret_cast<decltype(&::glXChooseVisual)>(find("glXChooseVisual")),
          reinterpret_cast<decltype(&::glXCreateContext)>(find("glXCreateContext")),
          reinterpret_cast<decltype(&::glXMakeCurrent)>(find("glXMakeCurrent"))};
}

// False if there is no display or no context.
inline bool open_window(const Glx& glx) {
  Display* display = XOpenDisplay(nullptr);
  if (!display) return false;
  int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, None};
  XVisualInfo* visual = glx.ChooseVisual(display, DefaultScreen(display), attributes);
  if (!visual) return false;
  XSetWindowAttributes wanted = {};
  const Window root = RootWindow(display, visual->screen);
  wanted.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
  const Window window = XCreateWindow(display, root, 0, 0, kSize, kSize, 0, visual->depth, InputOutput, visual->visual,
                                      CWColormap | CWBorderPixel, &wanted);
  XMapWindow(display, window);
  XSync(display, False);
  const GLXContext context = glx.CreateContext(display, visual, nullptr, True);
  return context && glx.MakeCurrent(display, window, context);
}

}  // namespace loaders
