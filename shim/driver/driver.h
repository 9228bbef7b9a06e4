// The real OpenGL, as one table of typed functions: the only way out of truequad, and the seam where tests put a fake.
// Generated from the Khronos registry at build time, a member for every command.
#pragma once

#include "gl_enums.h"
#include "gl_types.h"

namespace truequad {

// Every member can be called at any time: what the driver lacks does nothing and returns zero.
struct Driver {
#define TQ_COMMAND(name, result, parameters, arguments) result(GLAPIENTRY* name) parameters;
#include "gl_commands.inc"
#undef TQ_COMMAND
};

// Place of a command in the table.
enum CommandIndex : unsigned {
#define TQ_COMMAND(name, result, parameters, arguments) kCommand##name,
#include "gl_commands.inc"
#undef TQ_COMMAND
  kCommandCount
};

}  // namespace truequad
