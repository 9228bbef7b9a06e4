// Which commands change vertex arrays or the contents of buffer objects, or draw from them.
#pragma once

#include <string>

namespace truequad::generate {

// The macro that array_commands.inc has for the command's door, or nothing: it is none of these.
std::string array_macro(const std::string& name);

// Draws from arrays: their doors are written by hand (capture/array_calls.inc).
bool draws_from_arrays(const std::string& name);

}  // namespace truequad::generate
