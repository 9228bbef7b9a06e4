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

// Draws and records as it likes, for seeds `first` to `first` + `seeds` - 1 or, if it has no use for them,
// once.
struct Scene {
  const char* name;
  void (*draw)(unsigned first, unsigned seeds);
};
const std::vector<Scene>& colour_scenes();
const std::vector<Scene>& light_scenes();
const std::vector<Scene>& random_light_scenes();
const std::vector<Scene>& polygon_scenes();
const std::vector<Scene>& texture_scenes();
const std::vector<Scene>& query_scenes();
const std::vector<Scene>& state_scenes();
const std::vector<Scene>& call_scenes();
const std::vector<Scene>& hard_scenes();
const std::vector<Scene>& old_program_scenes();

}  // namespace truequad::semantics
