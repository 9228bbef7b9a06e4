// What a plan promises of colours is kept: on random quads of every shape, points that the mesh draws are compared with
// the colour of the bilinear surface at the same point of the screen, found by direct solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../trials.h"
#include "measure.h"

namespace truequad::test {
namespace {

using reference::Real;

std::vector<ColourChannel> random_colours(unsigned trial) {
  std::mt19937 engine(trial + 77);
  std::uniform_real_distribution<double> steps(0, 255);
  std::vector<ColourChannel> colours(1 + engine() % 4);
  for (ColourChannel& c : colours) {
    switch (engine() % 4) {
      case 0:  // one corner differs
        c.fill(steps(engine));
        c[engine() % 4] = steps(engine);
        break;
      case 1:  // nearly affine
        for (double& x : c) x = 100 + steps(engine) / 50;
        break;
      default:
        for (double& x : c) x = steps(engine);
    }
  }
  return colours;
}

Real bilinear(const std::array<double, 4>& x, Real u, Real v) {
  return (1 - u) * (1 - v) * x[0] + u * (1 - v) * x[1] + u * v * x[2] + (1 - u) * v * x[3];
}

struct Steps {
  double largest = 0;
  int compared = 0, nowhere = 0;  // visible points; those at which the surface has no colour
};

// The channels' largest difference at the point with these weights, from the nearest of the colours that the surface has there.
void compare(const Quad& quad, const std::vector<ColourChannel>& colours, const Mesh& mesh, const Triangle& triangle,
             const Real (&weight)[3], Steps& steps) {
  const auto clip = reference::clip_corners(quad.position, quad.view);
  Real p[4] = {};
  std::vector<Real> drawn(colours.size());
  const std::uint16_t index[3] = {triangle.a, triangle.b, triangle.c};
  for (int k = 0; k < 3; ++k) {
    const auto [u, v] = mesh.vertices[index[k]];
    for (std::size_t row = 0; row < 4; ++row) {
      p[row] += weight[k] * bilinear({double(clip[0][row]), double(clip[1][row]), double(clip[2][row]), double(clip[3][row])}, u, v);
    }
    for (std::size_t i = 0; i < colours.size(); ++i) drawn[i] += weight[k] * bilinear(colours[i], u, v);
  }
  if (!(p[3] > 0)) return;
  for (int row = 0; row < 3; ++row) {
    if (std::fabs(p[row]) > p[3]) return;
  }
  ++steps.compared;
  std::array<Real, 4> f, g;
  for (std::size_t i = 0; i < 4; ++i) {
    f[i] = clip[i][0] - p[0] / p[3] * clip[i][3];
    g[i] = clip[i][1] - p[1] / p[3] * clip[i][3];
  }
  Real nearest = INFINITY;
  for (const reference::Solution& at : reference::solve_bilinear(f, g)) {
    constexpr Real kSlack = 1e-7L;
    if (at.u < -kSlack || at.u > 1 + kSlack || at.v < -kSlack || at.v > 1 + kSlack) continue;
    Real worst = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      worst = std::max(worst, std::fabs(drawn[i] - bilinear(colours[i], at.u, at.v)));
    }
    nearest = std::min(nearest, worst);
  }
  if (nearest == INFINITY) ++steps.nowhere;
  else steps.largest = std::max(steps.largest, double(nearest));
}

Steps measure_steps(const Quad& quad, const std::vector<ColourChannel>& colours, const Mesh& mesh, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Steps steps;
  for (int i = 0; i < 48; ++i) {
    const Triangle& triangle = mesh.triangles[mesh.triangles.size() <= 48 ? std::size_t(i) % mesh.triangles.size()
                                                                          : engine() % mesh.triangles.size()];
    Real weight[3];
    if (i % 2 == 0) {
      const int edge = int(engine() % 3);
      const double t = engine() % 2 ? 0.5 : unit(engine);
      weight[edge] = t;
      weight[(edge + 1) % 3] = 1 - t;
      weight[(edge + 2) % 3] = 0;
    } else {
      const double r = std::sqrt(unit(engine)), t = unit(engine);
      weight[0] = 1 - r, weight[1] = r * (1 - t), weight[2] = r * t;
    }
    compare(quad, colours, mesh, triangle, weight, steps);
  }
  return steps;
}

// Its picture on the screen folds, or may: what is seen there is another sheet, and the promise ends at a channel's range.
bool may_fold(Kind kind) {
  return kind == Kind::kConcave || kind == Kind::kBowTie || kind == Kind::kNonPlanar || kind == Kind::kEqualCorners ||
         kind == Kind::kCollinear || kind == Kind::kBehindEye || kind == Kind::kFoldedTexture;
}

class ColourPromise : public testing::TestWithParam<int> {};

TEST_P(ColourPromise, HoldsAtEveryMeasuredPoint) {
  const Kind kind = Kind(GetParam());
  constexpr unsigned kTrials = trials(500);
  Plan& plan = scratch_plan();
  int planned = 0, kept = 0, compared = 0, nowhere = 0;
  double tightest = 0;
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    const Quad quad = random_quad(kind, trial);
    const std::vector<ColourChannel> colours = random_colours(trial);
    Limits limits;
    limits.tolerance_px = quad.tolerance_px;
    limits.colour_steps = trial % 3 == 0 ? 0.5 : std::ldexp(1.0, int(trial % 7) - 2);
    // With the texture or alone.
    const std::span<const Corners> textures(&quad.texture, trial % 2);
    truequad::plan(quad.position, textures, quad.view, limits, Mode::kBilinear, plan, colours);
    ASSERT_EQ(plan.capped, plan.action == Action::kMesh && !(plan.bound_px <= quad.tolerance_px &&
                                                             plan.bound_steps <= limits.colour_steps))
        << "trial " << trial;
    if (plan.action != Action::kMesh && plan.reason != PassReason::kWithinTolerance) continue;
    ++planned;
    kept += plan.bound_steps <= limits.colour_steps;
    ASSERT_LE(plan.triangles, limits.max_triangles);
    for (int i = 0; i < (plan.action == Action::kMesh ? 1 : 2); ++i) {
      const Mesh mesh = plan.action == Action::kMesh ? mesh_of(plan) : two_triangles(i == 0);
      const Steps steps = measure_steps(quad, colours, mesh, trial);
      compared += steps.compared;
      nowhere += steps.nowhere;
      // Affine channels (bound 0) are so to the rounding of single precision.
      const double promised = plan.bound_steps + 1e-4;
      ASSERT_LE(steps.largest, promised) << "trial " << trial << ", " << mesh.triangles.size() << " triangles";
      if (plan.bound_steps > 0.01) tightest = std::max(tightest, steps.largest / promised);
    }
  }
  printf("%s: %d of %d planned quads within tolerance, %d points, %d of them where the surface is not, tightest %.4f\n",
         name(kind).c_str(), kept, planned, compared, nowhere, tightest);
  EXPECT_GT(planned, int(kTrials) / 4);
  EXPECT_LE(nowhere, may_fold(kind) ? compared / 4 : 0);
  if (!may_fold(kind)) {
    // Not kept are those of which a pixel shows so many steps that the rasteriser's grid itself costs more.
    if (kind != Kind::kTextureCollinear) {
      EXPECT_GE(kept, planned * 0.85);
    }
    EXPECT_GT(tightest, 0.8);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ColourPromise, testing::Range(0, int(Kind::kCount)),
                         [](const auto& info) { return name(Kind(info.param)); });

// Of a square of colours 0 255 0 255 the two triangles are off by T/4, a centre fan by T/16, with T = 510 steps.
TEST(Colours, FiguresOfASquare) {
  const Corners square{Vec4{-50, -50, 0, 1}, Vec4{50, -50, 0, 1}, Vec4{50, 50, 0, 1}, Vec4{-50, 50, 0, 1}};
  const ColourChannel saddle[] = {{0, 255, 0, 255}};
  Plan& plan = scratch_plan();
  Limits limits;
  limits.colour_steps = 127.6;
  truequad::plan(square, {}, pixel_view(200, 200), limits, Mode::kBilinear, plan, saddle);
  EXPECT_EQ(plan.reason, PassReason::kWithinTolerance);
  EXPECT_NEAR(plan.bound_steps, 510.0 / 4, 1e-4);
  limits.colour_steps = 127.4;
  truequad::plan(square, {}, pixel_view(200, 200), limits, Mode::kBilinear, plan, saddle);
  EXPECT_EQ(plan.action, Action::kMesh);
  EXPECT_EQ(plan.triangles, 4);
  EXPECT_NEAR(plan.bound_steps, 510.0 / 16, 1e-4);
  limits.colour_steps = 0.5;
  truequad::plan(square, {}, pixel_view(200, 200), limits, Mode::kBilinear, plan, saddle);
  EXPECT_LE(plan.triangles, 320);
  EXPECT_LE(plan.bound_steps, 0.5);
}

TEST(Colours, WithoutAnyNothingChanges) {
  Plan& plan = scratch_plan();
  for (unsigned trial = 0; trial < 300; ++trial) {
    const Quad quad = random_quad(Kind(trial % unsigned(Kind::kCount)), trial);
    Limits limits;
    limits.tolerance_px = quad.tolerance_px;
    // A constant channel, and one that is affine over a quad of two equal edges alone.
    const ColourChannel constant[] = {{7, 7, 7, 7}};
    truequad::plan(quad.position, {&quad.texture, 1}, quad.view, limits, Mode::kBilinear, plan);
    const int triangles = plan.triangles;
    const double bound_px = plan.bound_px;
    truequad::plan(quad.position, {&quad.texture, 1}, quad.view, limits, Mode::kBilinear, plan, constant);
    EXPECT_EQ(plan.triangles, triangles);
    EXPECT_EQ(plan.bound_px, bound_px);
    EXPECT_EQ(plan.bound_steps, 0);
  }
}

TEST(Colours, ModesThatCannotMendThemLeaveThem) {
  const Quad quad = random_quad(Kind::kConvex, 3);
  const ColourChannel saddle[] = {{0, 255, 0, 255}};
  Plan& plan = scratch_plan();
  Limits limits;
  truequad::plan(quad.position, {}, quad.view, limits, Mode::kPaper, plan, saddle);
  EXPECT_EQ(plan.reason, PassReason::kConstant);
  truequad::plan(quad.position, {}, quad.view, limits, Mode::kOff, plan, saddle);
  EXPECT_EQ(plan.reason, PassReason::kModeOff);
  truequad::plan(quad.position, {&quad.texture, 1}, quad.view, limits, Mode::kProjective, plan, saddle);
  EXPECT_EQ(plan.action, Action::kProject);
  EXPECT_EQ(plan.bound_steps, 0);
  truequad::plan(quad.position, {}, quad.view, limits, Mode::kProjective, plan, saddle);
  EXPECT_EQ(plan.action, Action::kMesh);
}

}  // namespace
}  // namespace truequad::test
