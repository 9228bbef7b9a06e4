// Any input has a defined plan that can be drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "../trials.h"
#include "measure.h"

namespace truequad::test {
namespace {

constexpr Mode kModes[] = {Mode::kBilinear, Mode::kProjective, Mode::kAuto, Mode::kPaper, Mode::kOff};

// What must hold of every plan, whatever the input.
void expect_drawable(const Plan& plan) {
  ASSERT_FALSE(std::isnan(plan.bound_px));
  ASSERT_GE(plan.bound_px, 0);
  ASSERT_GE(plan.triangles, 2);
  ASSERT_LE(plan.triangles, kMaxTriangles);
  ASSERT_EQ(plan.action == Action::kPass, plan.reason != PassReason::kNone);
  if (plan.action == Action::kMesh) {
    const Mesh mesh = mesh_of(plan);
    ASSERT_EQ(int(mesh.triangles.size()), plan.triangles);
    for (const Param& p : mesh.vertices) ASSERT_TRUE(p.u >= 0 && p.u <= 1 && p.v >= 0 && p.v <= 1);
    for (const Triangle& t : mesh.triangles) {
      ASSERT_LT(std::max({t.a, t.b, t.c}), mesh.vertices.size());
    }
  }
  if (plan.action == Action::kProject) {
    for (double l : plan.lambda[0]) ASSERT_TRUE(l > 0 && std::isfinite(l));
  }
}

TEST(HardCases, AnyBitsAnywhere) {
  Plan& p = scratch_plan();
  for (unsigned trial = 0; trial < trials(40000, 16); ++trial) {
    std::mt19937_64 engine(trial);
    const double special[] = {0,
                              -0.0,
                              1,
                              -1,
                              0.5,
                              1e30,
                              -1e30,
                              1e-30,
                              1e-45,
                              5e-324,
                              1e300,
                              1.7e308,
                              -1e308,
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()};
    const auto any = [&]() -> double {
      switch (engine() % 4) {
        case 0:
          return special[engine() % std::size(special)];
        case 1: {
          const std::uint64_t bits = engine();
          double x;
          std::memcpy(&x, &bits, sizeof x);
          return x;
        }
        default:
          return double(int(engine() % 9) - 4);
      }
    };
    // Wild everywhere would end at the first test of plan(); mostly a sound quad has a few wild numbers.
    Quad quad = random_quad(Kind(engine() % unsigned(Kind::kCount)), trial);
    double* const numbers[] = {&quad.position[engine() % 4].x, &quad.position[engine() % 4].w,
                               &quad.texture[engine() % 4].y,  &quad.view.clip_from_object[engine() % 16],
                               &quad.view.viewport.width,      &quad.view.snap_px};
    for (double* number : numbers) {
      if (engine() % 3 == 0) *number = any();
    }
    Limits limits;
    if (engine() % 3 == 0) limits.tolerance_px = any();
    if (engine() % 3 == 0) limits.max_triangles = int(std::uint32_t(engine()));
    if (engine() % 3 == 0) limits.paper = {any(), any(), any()};
    for (Mode mode : kModes) {
      plan(quad.position, {&quad.texture, 1}, quad.view, limits, mode, p);
      ASSERT_NO_FATAL_FAILURE(expect_drawable(p)) << "trial " << trial << " mode " << int(mode);
    }
  }
}

Quad sound() { return random_quad(Kind::kConvex, 7); }

const Plan& planned(const Quad& quad, Limits limits = {}) {
  plan(quad.position, {&quad.texture, 1}, quad.view, limits, Mode::kBilinear, scratch_plan());
  return scratch_plan();
}

TEST(HardCases, EmptyViewportsAreInvisible) {
  for (double size : {0.0, -0.0, -5.0}) {
    Quad quad = sound();
    quad.view.viewport.width = size;
    EXPECT_EQ(planned(quad).reason, PassReason::kInvisible);
    quad = sound();
    quad.view.viewport.height = size;
    EXPECT_EQ(planned(quad).reason, PassReason::kInvisible);
  }
}

TEST(HardCases, NotFiniteViewsPass) {
  Quad quad = sound();
  quad.view.clip_from_object[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(planned(quad).reason, PassReason::kNotFinite);
  quad = sound();
  quad.view.viewport.width = std::numeric_limits<double>::infinity();
  EXPECT_EQ(planned(quad).reason, PassReason::kNotFinite);
}

TEST(HardCases, OnePixelViewportsNeedNothing) {
  for (unsigned trial = 0; trial < 200; ++trial) {
    Quad quad = random_quad(Kind::kUnitTexture, trial);
    quad.view = pixel_view(1, 1);
    for (Vec4& p : quad.position) p.x *= 0.5, p.y *= 0.5;
    EXPECT_EQ(planned(quad).action, Action::kPass);
  }
}

// A driver takes vertices in single precision. Far from the origin that moves them by much of a pixel, and the promise says so.
TEST(HardCases, ThePromiseContainsTheRoundingOfVertices) {
  for (double far : {0.0, 0x1p17, 0x1p20, 0x1p22}) {
    Quad quad = sound();
    quad.view = pixel_view(640, 480);
    quad.view.setup_rounding = 0x1p-24;
    for (Vec4& p : quad.position) p = {std::round(100 * p.x) + far, std::round(100 * p.y), 0, 1};
    quad.view.clip_from_object[12] = -far * quad.view.clip_from_object[0];
    const Plan& p = planned(quad);
    ASSERT_EQ(p.action, Action::kMesh);
    const double step_px = far * 0x1p-23;
    EXPECT_GE(p.bound_px, step_px / 2) << far;
    EXPECT_LE(p.bound_px, 0.25 + 4 * step_px) << far;
    EXPECT_EQ(p.capped, p.bound_px > 0.25) << far;
    EXPECT_EQ(p.capped, step_px >= 0.125) << far;
  }
}

TEST(HardCases, BehindTheEyeIsInvisible) {
  Quad quad = sound();
  quad.view = pixel_view(100, 100);
  for (Vec4& p : quad.position) p.w = -1;
  EXPECT_EQ(planned(quad).reason, PassReason::kInvisible);
}

TEST(HardCases, OneMatrixElementOfZerosIsDrawnAsItComes) {
  for (int i = 0; i < 16; ++i) {
    Quad quad = sound();
    quad.view.clip_from_object[std::size_t(i)] = 0;
    ASSERT_NO_FATAL_FAILURE(expect_drawable(planned(quad)));
    quad.view.clip_from_object = {};
    ASSERT_NO_FATAL_FAILURE(expect_drawable(planned(quad)));
  }
}

TEST(HardCases, TheCapIsKeptAndReported) {
  for (int cap : {-5, 0, 4, 5, 11, 12, 13, 50, 171, 172, 400, 4096, kMaxTriangles, 1 << 30}) {
    for (unsigned trial = 0; trial < 100; ++trial) {
      Quad quad = random_quad(Kind::kConvex, trial);
      Limits limits;
      limits.max_triangles = cap;
      limits.tolerance_px = 0.1;
      const Plan& p = planned(quad, limits);
      ASSERT_LE(p.triangles, std::clamp(cap, 4, kMaxTriangles));
      ASSERT_NO_FATAL_FAILURE(expect_drawable(p));
      ASSERT_EQ(p.capped, !(p.bound_px <= 0.1));
      if (p.capped && std::isfinite(p.bound_px)) {
        ASSERT_LE(measure(quad, mesh_of(p), 50, trial).largest_px,
                  p.bound_px - quad.view.snap_px + 1e-9 * quad.view.viewport.width);
      }
    }
  }
}

// The bounds are for fragments at the centres of pixels.
TEST(HardCases, NothingIsPromisedUnderMultisampling) {
  for (const Mode mode : {Mode::kBilinear, Mode::kProjective, Mode::kPaper}) {
    for (unsigned trial = 0; trial < 50; ++trial) {
      Quad quad = random_quad(Kind::kConvex, trial);
      static Plan centres, sampled;
      const auto make = [&](Plan& out) {
        plan(quad.position, {&quad.texture, 1}, quad.view, Limits{}, mode, out);
      };
      make(centres);
      quad.view.multisampled = true;
      make(sampled);
      ASSERT_EQ(sampled.action, centres.action);
      ASSERT_EQ(sampled.triangles, centres.triangles);
      ASSERT_EQ(sampled.capped, sampled.action != Action::kPass);
      if (sampled.action != Action::kMesh) continue;
      bound_mesh(quad.position, {&quad.texture, 1}, quad.view, Limits{}, sampled);
      ASSERT_TRUE(sampled.capped);
    }
  }
}

TEST(HardCases, MoreTrianglesNeverPromiseLess) {
  for (unsigned trial = 0; trial < 200; ++trial) {
    const Quad quad = random_quad(Kind::kConvex, trial);
    double before = std::numeric_limits<double>::infinity();
    for (int cap : {4, 16, 64, 256, 1024, 4096}) {
      Limits limits;
      limits.max_triangles = cap;
      limits.tolerance_px = 0.1;
      const Plan& p = planned(quad, limits);
      // A cap four times as large must be worth something; a tenth is for rows and columns being whole
      // numbers.
      ASSERT_LE(p.bound_px, std::max(1.1 * before, 0.1)) << "trial " << trial << " cap " << cap;
      before = p.bound_px;
    }
  }
}

TEST(HardCases, OwnQPassesUnlessItIsTheSameAtAllCorners) {
  Quad quad = random_quad(Kind::kUnitTexture, 3);
  const Plan& same = planned(quad);
  const int triangles = same.triangles;
  const double bound = same.bound_px;
  Quad scaled = quad;
  for (Vec4& t : scaled.texture) t = {4 * t.x, 4 * t.y, 0, 4};
  EXPECT_EQ(planned(scaled).triangles, triangles);
  EXPECT_EQ(planned(scaled).bound_px, bound);
  scaled.texture[1].w = 3;
  EXPECT_EQ(planned(scaled).reason, PassReason::kOwnQ);
}

TEST(HardCases, SeveralSetsAreBoundTogether) {
  for (unsigned trial = 0; trial < 300; ++trial) {
    const Quad quad = random_quad(Kind::kConvex, trial), other = random_quad(Kind::kUnitTexture, trial);
    std::array<Corners, 3> sets{quad.texture, other.texture, quad.position};  // the last one is affine
    for (Vec4& t : sets[2]) t.z = 0;
    Plan& p = scratch_plan();
    plan(quad.position, sets, quad.view, {}, Mode::kBilinear, p);
    if (p.action != Action::kMesh || !std::isfinite(p.bound_px)) continue;
    for (const Corners& texture : sets) {
      Quad one = quad;
      one.texture = texture;
      ASSERT_LE(measure(one, mesh_of(p), 60, trial).largest_px,
                p.bound_px - quad.view.snap_px + 1e-9 * quad.view.viewport.width)
          << trial;
    }
  }
}

TEST(HardCases, PlansDoNotRememberEarlierOnes) {
  Plan& p = scratch_plan();
  for (unsigned trial = 0; trial < 500; ++trial) {
    const Quad quad = random_quad(Kind(trial % unsigned(Kind::kCount)), trial);
    plan(quad.position, {&quad.texture, 1}, quad.view, {}, Mode::kBilinear, p);
    const double bound = p.bound_px;
    const int triangles = p.triangles;
    const Mesh mesh = p.action == Action::kMesh ? mesh_of(p) : Mesh{};
    for (Mode mode : kModes) plan(sound().position, {&quad.texture, 1}, quad.view, {}, mode, p);
    plan(quad.position, {&quad.texture, 1}, quad.view, {}, Mode::kBilinear, p);
    ASSERT_EQ(p.bound_px, bound);
    ASSERT_EQ(p.triangles, triangles);
    if (p.action != Action::kMesh) continue;
    const Mesh again = mesh_of(p);
    ASSERT_EQ(std::memcmp(again.vertices.data(), mesh.vertices.data(), mesh.vertices.size() * sizeof(Param)),
              0);
  }
}

}  // namespace
}  // namespace truequad::test
