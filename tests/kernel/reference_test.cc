// The yardstick itself: forward and inverse maps undo each other.
#include <gtest/gtest.h>

#include "measure.h"

namespace truequad::test {
namespace {

TEST(Reference, TheInverseUndoesTheBilinearMap) {
  for (Kind kind : {Kind::kConvex, Kind::kUnitTexture, Kind::kConcave, Kind::kBowTie, Kind::kSteep,
                    Kind::kNonPlanar, Kind::kTextureFar, Kind::kHomogeneous}) {
    for (unsigned trial = 0; trial < 2000; ++trial) {
      const Quad quad = random_quad(kind, trial);
      std::mt19937 engine(trial);
      std::uniform_real_distribution<double> unit(0, 1);
      const double u = unit(engine), v = unit(engine);
      const auto clip = reference::clip_corners(quad.position, quad.view);
      const auto window = reference::window_point(clip, quad.view, u, v);
      if (!window) continue;
      const auto at = [&](double Vec4::*of) {
        const Corners& t = quad.texture;
        return interpolate<reference::Real>(t[0].*of, t[1].*of, t[2].*of, t[3].*of, u, v);
      };
      EXPECT_LE(reference::bilinear_displacement(quad.position, quad.texture, quad.view, *window,
                                                 at(&Vec4::x), at(&Vec4::y)),
                1e-9L * quad.view.viewport.width)
          << name(kind) << " " << trial;
    }
  }
}

TEST(Reference, ForwardSeesTheNearestSheet) {
  for (unsigned trial = 0; trial < 2000; ++trial) {
    const Quad quad = random_quad(Kind::kNonPlanar, trial);
    std::mt19937 engine(trial);
    std::uniform_real_distribution<double> unit(0, 1);
    const double u = unit(engine), v = unit(engine);
    const auto clip = reference::clip_corners(quad.position, quad.view);
    const auto window = reference::window_point(clip, quad.view, u, v);
    if (!window) continue;
    const auto row = [&](std::size_t r) {
      return interpolate<reference::Real>(clip[0][r], clip[1][r], clip[2][r], clip[3][r], u, v);
    };
    const auto depth = row(2) / row(3);
    if (std::fabs(double(depth)) > 1) continue;
    const auto seen = reference::bilinear_at(quad.position, quad.texture, quad.view, *window);
    ASSERT_TRUE(seen) << trial;
    EXPECT_LE(seen->depth, depth + 1e-12L);
    if (std::fabs(double(seen->depth - depth)) < 1e-12) {
      EXPECT_NEAR(double(seen->u), u, 1e-6);
      EXPECT_NEAR(double(seen->v), v, 1e-6);
    }
  }
}

TEST(Reference, HomographyTakesCornersToCorners) {
  for (unsigned trial = 0; trial < 2000; ++trial) {
    const Quad quad = random_quad(Kind::kConvex, trial);
    const reference::ProjectiveMap map(quad.position, quad.texture, quad.view);
    const auto clip = reference::clip_corners(quad.position, quad.view);
    for (int i = 0; i < 4; ++i) {
      const auto window = reference::window_point(clip, quad.view, i == 1 || i == 2, i >= 2);
      if (!window) continue;
      const auto texel = map.texel_at(*window);
      EXPECT_NEAR(double(texel.x), quad.texture[i].x, 1e-9);
      EXPECT_NEAR(double(texel.y), quad.texture[i].y, 1e-9);
    }
  }
}

}  // namespace
}  // namespace truequad::test
