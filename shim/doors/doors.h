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

// Either of these.
void* door(std::string_view name);

// What dlsym(handle, name) answers to `caller` (an address in its code): our door where the real answer is in a library
// that our doors lead to, else the real answer. For names that may have doors and handles of dlopen().
void* symbol_of_handle(void* handle, const char* name, const void* caller);

// True if our door is all that there is of `name` in a scope (RTLD_DEFAULT or RTLD_NEXT): natively there is no such
// name, and dlerror() now says so.
bool is_ours_alone(void* scope, const char* name);

// A process may have several copies of this library: preloaded, linked, by library path, as a vendor library. The first of
// the global scope works; in all others this makes every call pass. For paths that are taken seldom, before a context is known.
void let_first_copy_work();

// From the first GL call on, the end of the process is noticed: exit, quick_exit, _exit and _Exit.
void watch_exit();

}  // namespace truequad
