// Everything that OpenGL keeps as current values, and everything else that a correction could leave changed.
#pragma once

#include <vector>

#include "gl.h"

namespace truequad::semantics {

// Colour, normal, coordinates of every unit, materials, raster position and the like, as bits.
std::vector<GLfloat> current_values();
// Enables, bindings, modes, matrices and stack depths.
std::vector<GLfloat> other_state();
// Errors, oldest first, until there is none.
std::vector<GLenum> all_errors();

}  // namespace truequad::semantics
