// The scenes of the drawing programs, by name.
#pragma once

#include <string>
#include <vector>

#include "shapes.h"

namespace truequad::semantics {

// Draws a shape in several passes and records one picture or more: `name`, or `name` and more words.
struct PassesCase {
  const char* name;
  void (*draw)(const Shape& shape, const std::string& name);
};
const std::vector<PassesCase>& depth_cases();
const std::vector<PassesCase>& frame_cases();
const std::vector<PassesCase>& stencil_cases();

}  // namespace truequad::semantics
