// draw_semantics_API [compile:|execute:|arrays:]CASE FIRST COUNT FILE: draws a scene with immediate-mode OpenGL, or with each
// shape in a list or from arrays, for COUNT seeds and writes its records. A program like any other, which knows nothing of truequad.
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "canvas.h"
#include "cases.h"
#include "pass.h"
#include "record.h"
#include "scene_tools.h"

namespace truequad::semantics {
namespace {

bool draw_passes(const std::string& wanted, unsigned first, unsigned seeds) {
  for (const auto* cases : {&depth_cases(), &frame_cases(), &stencil_cases()}) {
    for (const PassesCase& known : *cases) {
      if (wanted != known.name) continue;
      prepare_passes();
      for (const std::string& name : shape_names()) {
        for (unsigned seed = first; seed < first + seeds; ++seed) {
          known.draw(make_shape(name, seed), name + " " + std::to_string(seed));
        }
      }
      return true;
    }
  }
  return false;
}

bool draw_scene(const std::string& wanted, unsigned first, unsigned seeds) {
  for (const auto* scenes : {&colour_scenes(), &light_scenes(), &random_light_scenes(), &polygon_scenes(), &texture_scenes(),
                             &query_scenes(), &state_scenes(), &call_scenes(), &hard_scenes(), &old_program_scenes()}) {
    for (const Scene& scene : *scenes) {
      if (wanted != scene.name) continue;
      scene.draw(first, seeds);
      return true;
    }
  }
  return false;
}

int run(int count, char** arguments) {
  if (count != 5) {
    std::fprintf(stderr, "usage: %s [compile:|execute:|arrays:]CASE FIRST COUNT FILE\n", arguments[0]);
    return 2;
  }
  std::string wanted = arguments[1];
  for (const auto& [prefix, way] : {std::pair{"compile:", Lists::kCompile}, {"execute:", Lists::kCompileAndExecute}}) {
    if (!wanted.starts_with(prefix)) continue;
    listing = way;
    wanted.erase(0, std::string(prefix).size());
  }
  if (constexpr std::string_view kArrays = "arrays:"; wanted.starts_with(kArrays)) {
    from_arrays = true;
    wanted.erase(0, kArrays.size());
  }
  images::open_canvas(kWidth, kHeight);
  open_records(arguments[4]);
  const unsigned first = unsigned(std::atoi(arguments[2])), seeds = unsigned(std::atoi(arguments[3]));
  if (!draw_passes(wanted, first, seeds) && !draw_scene(wanted, first, seeds)) {
    std::fprintf(stderr, "%s: there is no case named %s\n", arguments[0], arguments[1]);
    return 2;
  }
  if (const GLenum error = glGetError()) {
    std::fprintf(stderr, "%s: GL error 0x%x\n", arguments[0], error);
    return 1;
  }
  return close_records() ? 0 : 1;
}

}  // namespace
}  // namespace truequad::semantics

int main(int count, char** arguments) { return truequad::semantics::run(count, arguments); }
