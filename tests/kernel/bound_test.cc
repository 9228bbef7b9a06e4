// What a plan promises is kept: on random quads of every shape, points of the mesh are compared with the
// exact map.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "../trials.h"
#include "error_model.h"
#include "measure.h"

namespace truequad::test {
namespace {

class Promise : public testing::TestWithParam<int> {};

TEST_P(Promise, HoldsAtEveryMeasuredPoint) {
  const Kind kind = Kind(GetParam());
  // Together over all kinds at least 100,000; the one-dimensional reference samples curves and is slow.
  const unsigned count = trials(kind == Kind::kOneDimensional ? 300 : 6700);
  Plan& plan = scratch_plan();
  int meshes = 0, finite = 0, passes = 0, within = 0;
  double tightest = 0;
  for (unsigned trial = 0; trial < count; ++trial) {
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
  EXPECT_GT(meshes + passes, int(count) / 2);
  if (kind != Kind::kFoldedTexture && kind != Kind::kTextureCollinear && kind != Kind::kOneDimensional) {
    EXPECT_GE(finite, meshes * 0.99);
    EXPECT_GE(within, meshes * 0.8);
    EXPECT_GT(tightest, 0.9);
  }
}

// Next to a side of the quad without length a cell's centre is not in its middle.
TEST(Cell, IsNoBetterThanItsTrianglesWhereverItsCentreIs) {
  for (unsigned trial = 0; trial < 2000; ++trial) {
    const Quad quad = random_quad(trial % 2 ? Kind::kConvex : Kind::kNonPlanar, trial);
    kernel::ErrorModel model;
    ASSERT_TRUE(kernel::make_screen_quad(quad.position, quad.view, model.screen));
    ASSERT_TRUE(kernel::add_texture_maps(quad.position, {&quad.texture, 1}, model));
    std::mt19937 engine(trial);
    std::uniform_real_distribution<double> unit(0.05, 0.95);
    const auto [u0, u1] = std::minmax({unit(engine), unit(engine)});
    const auto [v0, v1] = std::minmax({unit(engine), unit(engine)});
    const std::array<kernel::MeshPoint, 4> corner{model.screen.mesh_point(u0, v0), model.screen.mesh_point(u1, v0),
                                                  model.screen.mesh_point(u1, v1), model.screen.mesh_point(u0, v1)};
    const kernel::MeshPoint centre =
        model.screen.mesh_point(u0 + (u1 - u0) * unit(engine), v0 + (v1 - v0) * unit(engine));
    double worst = 0;
    for (int i = 0; i < 4; ++i) {
      const Mesh mesh{{{corner[i].u, corner[i].v}, {corner[(i + 1) % 4].u, corner[(i + 1) % 4].v}, {centre.u, centre.v}},
                      {{0, 1, 2}}};
      worst = std::max(worst, measure(quad, mesh, 12, trial).largest_px);
    }
    const double bound = cell_bound(model, corner, centre, 1e9);
    ASSERT_LE(worst, bound + 1e-9 * quad.view.viewport.width) << "trial " << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Promise, testing::Range(0, int(Kind::kCount)),
                         [](const auto& info) { return name(Kind(info.param)); });

}  // namespace
}  // namespace truequad::test
