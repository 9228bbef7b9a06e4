// Random quads of every shape of docs/design.md "Hard cases"; the trial number is the seed.
#pragma once

#include <random>
#include <string>

#include "truequad/kernel.h"

namespace truequad::test {

enum class Kind {
  kConvex,            // planar and convex in position, convex texture patch
  kUnitTexture,       // the same with the unit square as texture
  kConcave,           // concave position
  kBowTie,            // crossing position
  kNonPlanar,         //
  kNearlyAffine,      // parallelogram on parallelogram, disturbed by 1e-7 to 1e-2
  kEqualCorners,      // two corners of the position are one
  kCollinear,         // three corners of the position on a line
  kBehindEye,         // some corners behind the eye, or all
  kSteep,             // w differs by a factor of up to 1000
  kScaled,            // units of 1e-30 to 1e30
  kTextureFar,        // texture coordinates in the thousands
  kFoldedTexture,     // concave or crossing texture patch
  kTextureCollinear,  // three texture corners on a line, or two of them one
  kOneDimensional,    // only s varies
  kHomogeneous,       // corners with their own w
  kCount
};
std::string name(Kind kind);

struct Quad {
  Corners position;
  Corners texture;
  View view;
  double tolerance_px;
};
Quad random_quad(Kind kind, unsigned trial);

inline constexpr Corners kUnitSquare{Vec4{0, 0, 0, 1}, Vec4{1, 0, 0, 1}, Vec4{1, 1, 0, 1}, Vec4{0, 1, 0, 1}};
// Object coordinates are pixels from the viewport's centre.
View pixel_view(double width, double height);

}  // namespace truequad::test
