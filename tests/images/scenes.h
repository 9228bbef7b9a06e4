// What the image tests draw, as data: the drawing programs send it to a driver, the test measures the
// pictures against the exact maps of the same quads. The seed is the number of the trial.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "truequad/kernel.h"

namespace truequad::images {

struct Vertex {
  std::array<float, 4> position, texture;
  float mark;  // of the quad whose provoking vertex this is, else any
};

enum class Mode { kQuads, kQuadStrip, kPolygon };

struct Primitive {
  Mode mode = Mode::kQuads;
  std::vector<Vertex> vertices;
};

struct Scene {
  int width = 0, height = 0;                    // of the picture
  std::array<int, 4> viewport{};                // as glViewport takes it
  std::array<float, 16> projection, modelview;  // column-major
  std::vector<Primitive> primitives;
  bool depth_clamped = false;                   // GL_DEPTH_CLAMP
};

// A family of scenes: one for each seed.
struct Family {
  std::string_view name;
  Scene (*make)(unsigned seed, int width, int height);
  bool affine;         // every quad's map is affine: nothing to correct
  bool planar_convex;  // on the screen too: the two triangles cover exactly the quad
};
const std::vector<Family>& families();
// Of these or "far_away"; ends the process with a message if there is none of that name.
const Family& family(std::string_view name);

// Texture coordinates lie inside of (0, 1), since the pictures encode them by position in that square.
//
// One quad of a scene, corners in drawing order, and the mark by which its pixels are known.
struct DrawnQuad {
  Corners position, texture;
  View view;
  int mark = 0;
};
std::vector<DrawnQuad> quads_of(const Scene& scene, double snap_px);

}  // namespace truequad::images
