// One table of real functions for each window-system interface that a process may use, filled as its functions are
// first called (docs/design.md "Doors").
#pragma once

#include <string_view>

#include "doors/libraries.h"
#include "driver/driver.h"

namespace truequad {

// The table of an API. Its members resolve themselves at their first call, which has to be made by a thread whose
// current context is of that API; a context's table is called by no other.
const Driver* driver_of(Api api);

}  // namespace truequad
