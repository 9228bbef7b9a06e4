// What the doors share: how a symbol is exported, and which door stands for a name.
#pragma once

#include <string_view>

#include "doors/provider.h"

#define TRUEQUAD_DOOR [[gnu::visibility("default")]]

namespace truequad {

// Our door for a GL command ("glVertex3f"), or null.
void* command_door(std::string_view name);

// Our door for a function of GLX, EGL or OSMesa, or null.
void* window_system_door(std::string_view name);

// What a getProcAddress answers: nothing where the driver has nothing, else our door if there is one.
inline void* answer(const char* name, void* real) {
  if (!real || !name) return real;
  if (void* door = command_door(name)) return door;
  if (void* door = window_system_door(name)) return door;
  return real;
}

}  // namespace truequad
