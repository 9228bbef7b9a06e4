// egl local|deepbind: EGL without a display, opened by dlopen(); the commands by eglGetProcAddress.
#include <EGL/egl.h>
#include <dlfcn.h>

#include <string>

#include "scene.h"

int main(int argc, char** argv) {
  using namespace loaders;
  const bool deep = argc > 1 && std::string(argv[1]) == "deepbind";
  void* const library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL | (deep ? RTLD_DEEPBIND : 0));
  if (!library) return std::fprintf(stderr, "%s\n", dlerror()), 3;
#define EGL(name) reinterpret_cast<decltype(&::egl##name)>(dlsym(library, "egl" #name))
  const EGLDisplay display = EGL(GetDisplay)(EGL_DEFAULT_DISPLAY);
  EGL(Initialize)(display, nullptr, nullptr);
  EGL(BindAPI)(EGL_OPENGL_API);
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8,
                           EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  EGL(ChooseConfig)(display, wanted, &config, 1, &count);
  if (count < 1) return 4;
  const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  const EGLSurface surface = EGL(CreatePbufferSurface)(display, config, size);
  const EGLContext context = EGL(CreateContext)(display, config, EGL_NO_CONTEXT, nullptr);
  if (!EGL(MakeCurrent)(display, surface, surface, context)) return 4;
  const auto get = EGL(GetProcAddress);
  return show(find_functions([get](const char* name) { return reinterpret_cast<void*>(get(name)); }));
#undef EGL
}
