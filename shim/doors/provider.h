// Where the real functions come from: one table for each window-system interface that a process may use, each filled
// as its functions are first called (docs/design.md "Doors").
#pragma once

#include "driver/driver.h"

namespace truequad {

enum class Api : unsigned char {
  kNext,    // whatever follows us in the global scope; until a context is current
  kGlx,
  kEgl,
  kOsmesa,
};

// The table of an interface. Its members resolve themselves at their first call.
const Driver* driver_of(Api api);

// A function of the interface itself (glX…, egl…, OSMesa…) or of the C library, behind us in the global scope; null if
// the process has none. Never loads a library.
void* next_symbol(const char* name);

// A function of the interface itself that may be an extension: behind us in the global scope, else what the interface's
// own getProcAddress says; null if there is none.
void* interface_function(Api api, const char* name);

// True if the address lies in this library.
bool is_ours(const void* address);

}  // namespace truequad
