// How far from its exact value a mesh triangle draws a colour: derived, with proofs, in docs/design.md "Colours".
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "rasteriser.h"
#include "screen.h"
#include "truequad/kernel.h"

namespace truequad::kernel {

// The channels of a quad that two triangles show with a kink, and what all of them need of the quad's view.
struct ColourModel {
  struct Channel {
    double along_u, along_v, twist;  // of the bilinear function
    ColourChannel corner;
    double range, largest;  // between two corners; of their sizes
    glm::dvec3 error;       // steps per unit of s: error . (x, y, 1)
  };
  // Jacobian determinant of the screen map at (u, v) as seen from the point (x, y): (constant + of_u u + of_v v) . (x, y, 1).
  glm::dvec3 constant, of_u, of_v;
  std::array<Channel, kMaxColourChannels> channel;
  std::size_t count = 0;
  // What a step counts in a bound in pixels: the tolerances of both.
  double px_per_step = 0;
  // The rasteriser's grid; what rounding moves vertices by.
  double snap_px = 0, rounding_px = 0;
  // The determinant vanishes or changes sign on the quad: there its picture folds.
  bool folded = false;

  std::span<const Channel> channels() const { return {channel.data(), count}; }
};

// Adds the channels that are warped over this position. False if there are none.
bool add_colours(const Corners& position, std::span<const ColourChannel> colours, const ScreenQuad& screen, ColourModel& model);

// A part of a triangle, or of triangles whose own determinants are within those of the part's corners.
struct ColourPart {
  double error;                          // largest of the interpolation error of uv
  std::span<const Param> corner;
  Param own;                             // (L_v, L_u), where the determinant of the triangle's map is that of the quad's
  std::span<const ScreenPoint> visible;  // hull of what is drawn
  const SnapMargin& margin;
  double step_px;                        // pixels may be so far outside of it
};

// The largest difference between what is drawn there and the exact colour of the same point of the screen, in pixels of
// ColourModel::px_per_step. Never infinite: no colour differs by more than a channel's range.
double colour_px(const ColourModel& model, const ScreenQuad& screen, const ColourPart& part);

// What the rounding of a rasteriser's set-up adds to that at each corner of a triangle; where it is clipped, the largest at
// all of them.
std::array<double, 3> colour_setup_px(const ColourModel& model, const Rasteriser& rasteriser,
                                      const std::array<MeshPoint, 3>& triangle, const VisiblePart& part, bool clipped);

// The same as colour_px() per unit of the interpolation error, over a rectangle of the parameter square; an estimate, where
// w is taken as at least `w_floor` and the determinant as at least the part `fold_floor` of its largest on the quad.
double colour_density(const ColourModel& model, const std::array<Param, 4>& corner, std::span<const ScreenPoint> visible,
                      double w_floor, double fold_floor);

}  // namespace truequad::kernel
