// What a plan promises is kept: on random quads of every shape, points of the mesh are compared with the
// exact map.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "measure.h"

namespace truequad::test {
namespace {

class Promise : public testing::TestWithParam<int> {};

TEST_P(Promise, HoldsAtEveryMeasuredPoint) {
  const Kind kind = Kind(GetParam());
  // Together over all kinds at least 100,000; the one-dimensional reference samples curves and is slow.
  const unsigned trials = kind == Kind::kOneDimensional ? 300 : 6700;
  Plan& plan = scratch_plan();
  int meshes = 0, finite = 0, passes = 0, within = 0;
  double tightest = 0;
  for (unsigned trial = 0; trial < trials; ++trial) {
    const Quad quad = random_quad(kind, trial);
    Limits limits;
    limits.tolerance_px = quad.tolerance_px;
    truequad::plan(quad.position, {&quad.texture, 1}, quad.view, limits, Mode::kBilinear, plan);
    ASSERT_EQ(plan.capped, plan.action == Action::kMesh && !(plan.bound_px <= quad.tolerance_px))
        << "trial " << trial;
    if (plan.action == Action::kMesh) {
      ++meshes;
      ASSERT_LE(plan.triangles, limits.max_triangles) << "trial " << trial;
      if (!std::isfinite(plan.bound_px)) continue;
      ++finite;
      within += plan.bound_px <= quad.tolerance_px;
    } else if (plan.reason != PassReason::kWithinTolerance) {
      continue;
    } else {
      ++passes;
    }
    // Snapping is the rasteriser's share of the bound; the mesh must keep the rest. The reference and the
    // corners are exact to about 1e-12 of the viewport's width.
    const double promised = plan.bound_px - quad.view.snap_px + 1e-9 * quad.view.viewport.width;
    const int meshes_of_pass = plan.action == Action::kMesh ? 1 : 2;
    for (int i = 0; i < meshes_of_pass; ++i) {
      const Mesh mesh = plan.action == Action::kMesh ? mesh_of(plan) : two_triangles(i == 0);
      const Measured measured = measure(quad, mesh, kind == Kind::kOneDimensional ? 24 : 48, trial);
      ASSERT_LE(measured.largest_px, promised)
          << "trial " << trial << ", " << mesh.triangles.size() << " triangles";
      tightest = std::max(tightest, measured.largest_px / promised);
    }
  }
  printf("%s: %d meshes, %d with a finite bound, %d within tolerance, %d passes, tightest %.4f\n",
         name(kind).c_str(), meshes, finite, within, passes, tightest);
  // A bound that is infinite or far from the truth is kept by anything.
  EXPECT_GT(meshes + passes, int(trials) / 2);
  if (kind != Kind::kFoldedTexture && kind != Kind::kTextureCollinear && kind != Kind::kOneDimensional) {
    EXPECT_GE(finite, meshes * 0.99);
    EXPECT_GE(within, meshes * 0.8);
    EXPECT_GT(tightest, 0.9);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Promise, testing::Range(0, int(Kind::kCount)),
                         [](const auto& info) { return name(Kind(info.param)); });

}  // namespace
}  // namespace truequad::test
