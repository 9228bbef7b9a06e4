// The instrument itself, on the driver alone: what the pictures say without truequad is what the theory says.
#include <gtest/gtest.h>

#include <cmath>

#include "measure_pictures.h"

namespace truequad::images {
namespace {

class Native : public testing::TestWithParam<const char*> {};

TEST_P(Native, ShowsAffineQuadsExactly) {
  const Job job{GetParam(), "affine", 0, 60, 200, 150};
  const Pictures pictures = draw(job, std::nullopt);
  const Measurement measured = measure(job, pictures, {});
  EXPECT_GT(measured.pixels, 100'000);
  EXPECT_EQ(measured.unmeasured, 0);
  EXPECT_EQ(measured.corrected, 0);
  // What is left is the snapping of vertices to the rasteriser's grid.
  EXPECT_LE(measured.largest_px, std::sqrt(0.5) * std::ldexp(1.0, -pictures.header.subpixel_bits) + 1e-3)
      << "seed " << measured.worst_seed;
}

// docs/design.md: two triangles of a flat quad are wrong by a quarter of its twist, at the middle of the
// diagonal.
TEST_P(Native, ShowsTheSeamOfATrapezoid) {
  const Job job{GetParam(), "trapezoid", 0, 20, 200, 150};
  const Pictures pictures = draw(job, std::nullopt);
  const double snap_px = std::ldexp(1.0, -pictures.header.subpixel_bits);
  for (int trial = 0; trial < job.seeds; ++trial) {
    const DrawnQuad quad =
        quads_of(family(job.family).make(unsigned(trial), job.width, job.height), snap_px)[0];
    // The texture is a parallelogram, so the twist is that of the window positions alone.
    const auto& p = quad.position;
    const double twist_px = std::hypot((p[0].x - p[1].x + p[2].x - p[3].x) * quad.view.viewport.width / 2,
                                       (p[0].y - p[1].y + p[2].y - p[3].y) * quad.view.viewport.height / 2);
    double largest_px = 0;
    for (int y = 0; y < job.height; ++y) {
      for (int x = 0; x < job.width; ++x) {
        if (const auto texel = texel_at(pictures, trial, x, y)) {
          largest_px = std::max(largest_px, displacement_px(quad, false, x + 0.5, y + 0.5, *texel, largest_px));
        }
      }
    }
    EXPECT_LE(largest_px, twist_px / 4 + snap_px) << "seed " << trial;
    EXPECT_GE(largest_px, twist_px / 4 * 0.98) << "seed " << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(Driver, Native, testing::Values("osmesa", "egl", "glx"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace truequad::images
