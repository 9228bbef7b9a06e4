// sdl [loader]: SDL2, which opens libGL itself; the commands by SDL_GL_GetProcAddress, or by SDL's loader of libraries.
#include <SDL.h>

#include "scene.h"

int main(int argc, char**) {
  using namespace loaders;
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return 3;
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_Window* window = SDL_CreateWindow("sdl", 0, 0, kSize, kSize, SDL_WINDOW_OPENGL);
  if (!window || !SDL_GL_CreateContext(window)) return std::fprintf(stderr, "%s\n", SDL_GetError()), 4;
  void* const library = argc > 1 ? SDL_LoadObject("libGL.so.1") : nullptr;
  const int status = show(find_functions([library](const char* name) {
    return library ? SDL_LoadFunction(library, name) : SDL_GL_GetProcAddress(name);
  }));
  return status;
}
