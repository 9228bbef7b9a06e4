// What the doors share: how a symbol is exported, and which door stands for a name.
#pragma once

#include <string_view>

#include "doors/libraries.h"

#define TRUEQUAD_DOOR [[gnu::visibility("default")]]

namespace truequad {

// Our door for a GL command ("glVertex3f"), or null.
void* command_door(std::string_view name);

// Our door for a function of GLX, EGL or OSMesa, or null.
void* window_system_door(std::string_view name);

// From the first GL call on, the end of the process is noticed: exit, quick_exit, _exit and _Exit.
void watch_exit();

}  // namespace truequad
