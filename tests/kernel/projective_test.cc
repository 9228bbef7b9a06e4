// The projective map: Reed's factors, Turkowski's example, agreement with a homography, and where it must not
// be used.
#include <gtest/gtest.h>

#include <cmath>

#include "measure.h"

namespace truequad::test {
namespace {

const Plan& planned(const Corners& position, const Corners& texture, Mode mode, const View& view) {
  plan(position, {&texture, 1}, view, {}, mode, scratch_plan());
  return scratch_plan();
}

TEST(Projective, ReproducesReedsDiagonalFormula) {
  for (unsigned trial = 0; trial < 5000; ++trial) {
    Quad quad = random_quad(Kind::kUnitTexture, trial);
    const Plan& p = planned(quad.position, kUnitSquare, Mode::kProjective, pixel_view(100, 100));
    if (p.action == Action::kPass) continue;
    ASSERT_EQ(p.action, Action::kProject);
    // d_i: from corner i to the point where the diagonals meet; q_i = (d_i + d_{i+2}) / d_{i+2}.
    const auto& c = quad.position;
    const double ax = c[2].x - c[0].x, ay = c[2].y - c[0].y, bx = c[3].x - c[1].x, by = c[3].y - c[1].y;
    const double cross = ax * by - ay * bx;
    const double r = ((c[1].x - c[0].x) * by - (c[1].y - c[0].y) * bx) / cross;  // along AC
    const double s = ((c[1].x - c[0].x) * ay - (c[1].y - c[0].y) * ax) / cross;  // along BD
    const double q[4] = {1 / (1 - r), 1 / (1 - s), 1 / r, 1 / s};
    for (int i = 0; i < 4; ++i)
      ASSERT_NEAR(p.lambda[0][i] / p.lambda[0][3], q[i] / q[3], 1e-9 * q[i] / q[3]) << trial;
  }
}

TEST(Projective, ReproducesTurkowskisExample) {
  const Corners position{Vec4{-5, 1, 2, 1}, Vec4{-2, -3, 6, 1}, Vec4{2, -1, 4, 1}, Vec4{1, 4, -1, 1}};
  const Corners texture{Vec4{.2, .4, 0, 1}, Vec4{.4, .2, 0, 1}, Vec4{.8, .3, 0, 1}, Vec4{.7, .5, 0, 1}};
  const Plan& p = planned(position, texture, Mode::kProjective, pixel_view(100, 100));
  ASSERT_EQ(p.action, Action::kProject);
  const auto& l = p.lambda[0];
  // One linear map takes three corners to their homogeneous texels; the fourth must follow.
  using reference::Real;
  const auto det = [](const std::array<Real, 3>& a, const std::array<Real, 3>& b,
                      const std::array<Real, 3>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  // The quad lies in a plane through no axis: (x, y, 1) are coordinates in it.
  std::array<std::array<Real, 3>, 4> flat;
  for (std::size_t i = 0; i < 4; ++i) flat[i] = {position[i].x, position[i].y, 1};
  const Real whole = det(flat[0], flat[1], flat[2]);
  const Real weight[3] = {det(flat[3], flat[1], flat[2]) / whole, det(flat[0], flat[3], flat[2]) / whole,
                          det(flat[0], flat[1], flat[3]) / whole};
  Real s = 0, t = 0, q = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    s += weight[i] * l[i] * texture[i].x;
    t += weight[i] * l[i] * texture[i].y;
    q += weight[i] * l[i];
  }
  EXPECT_NEAR(double(s / q), .7, 1e-12);
  EXPECT_NEAR(double(t / q), .5, 1e-12);
  // The point where the diagonals meet is where the texels' diagonals meet.
  const auto meet = [](const std::array<std::array<Real, 2>, 4>& x) {
    const Real ax = x[2][0] - x[0][0], ay = x[2][1] - x[0][1], bx = x[3][0] - x[1][0], by = x[3][1] - x[1][1];
    const Real r = ((x[1][0] - x[0][0]) * by - (x[1][1] - x[0][1]) * bx) / (ax * by - ay * bx);
    return std::array<Real, 3>{x[0][0] + r * ax, x[0][1] + r * ay, r};
  };
  const auto in_position = meet({{{-5, 1}, {-2, -3}, {2, -1}, {1, 4}}});
  const auto in_texture = meet({{{.2L, .4L}, {.4L, .2L}, {.8L, .3L}, {.7L, .5L}}});
  const Real r = in_position[2];
  const Real qa = (1 - r) * l[0] + r * l[2];
  EXPECT_NEAR(double(((1 - r) * l[0] * texture[0].x + r * l[2] * texture[2].x) / qa), double(in_texture[0]),
              1e-12);
  EXPECT_NEAR(double(((1 - r) * l[0] * texture[0].y + r * l[2] * texture[2].y) / qa), double(in_texture[1]),
              1e-12);
}

TEST(Projective, DrawsTheHomography) {
  int projected = 0;
  for (unsigned trial = 0; trial < 3000; ++trial) {
    const Quad quad = random_quad(Kind::kConvex, trial);
    const Plan& p = planned(quad.position, quad.texture, Mode::kProjective, quad.view);
    if (p.action != Action::kProject) continue;
    ++projected;
    EXPECT_EQ(p.bound_px, quad.view.snap_px);
    EXPECT_EQ(p.triangles, 2);
    const reference::ProjectiveMap exact(quad.position, quad.texture, quad.view);
    ASSERT_TRUE(exact.valid());
    Quad sent = quad;
    for (int i = 0; i < 4; ++i) {
      const double l = p.lambda[0][i];
      sent.texture[i] = {quad.texture[i].x * l, quad.texture[i].y * l, 0, l};
    }
    std::mt19937 engine(trial);
    std::uniform_real_distribution<double> unit(0, 1);
    const Mesh halves = two_triangles(true);
    for (const Triangle& t : halves.triangles) {
      const double b1 = unit(engine) / 2, b2 = unit(engine) / 2, b0 = 1 - b1 - b2;
      // s and t divided by the interpolated q.
      Quad for_q = sent;
      for (Vec4& x : for_q.texture) x = {x.w, 0, 0, 1};
      Quad for_st = sent;
      for (Vec4& x : for_st.texture) x.w = 1;
      const Drawn st = drawn_point(for_st, halves, t, b0, b1, b2);
      const auto q = drawn_point(for_q, halves, t, b0, b1, b2).s;
      if (!st.visible) continue;
      EXPECT_LE(exact.displacement(st.window, st.s / q, st.t / q), 1e-5L * quad.view.viewport.width) << trial;
    }
  }
  EXPECT_GT(projected, 2000);
}

TEST(Projective, FallsBackToBilinearWhereNoMapIsValid) {
  for (Kind kind : {Kind::kConcave, Kind::kBowTie, Kind::kNonPlanar, Kind::kFoldedTexture,
                    Kind::kTextureCollinear, Kind::kOneDimensional, Kind::kEqualCorners}) {
    for (unsigned trial = 0; trial < 300; ++trial) {
      const Quad quad = random_quad(kind, trial);
      Plan& plan = scratch_plan();
      truequad::plan(quad.position, {&quad.texture, 1}, quad.view, {}, Mode::kProjective, plan);
      ASSERT_NE(plan.action, Action::kProject) << name(kind) << " " << trial;
      const int triangles = plan.triangles;
      const PassReason reason = plan.reason;
      const double bound = plan.bound_px;
      truequad::plan(quad.position, {&quad.texture, 1}, quad.view, {}, Mode::kBilinear, plan);
      ASSERT_EQ(plan.triangles, triangles);
      ASSERT_EQ(plan.reason, reason);
      ASSERT_EQ(plan.bound_px, bound);
    }
  }
}

TEST(Auto, TakesTheProjectiveMapUpToAFourfoldFactor) {
  const View view = pixel_view(1000, 1000);
  const auto trapezoid = [](double top) {
    return Corners{Vec4{-200, -200, 0, 1}, Vec4{200, -200, 0, 1}, Vec4{200 * top, 200, 0, 1},
                   Vec4{-200 * top, 200, 0, 1}};
  };
  EXPECT_EQ(planned(trapezoid(1 / 3.9), kUnitSquare, Mode::kAuto, view).action, Action::kProject);
  EXPECT_EQ(planned(trapezoid(1 / 4.1), kUnitSquare, Mode::kAuto, view).action, Action::kMesh);
}

TEST(Projective, AllSetsOrNone) {
  const Quad quad = random_quad(Kind::kConvex, 1);
  Corners folded = kUnitSquare;
  std::swap(folded[0], folded[1]);
  const std::array<Corners, 2> sets{kUnitSquare, folded};
  Plan& p = scratch_plan();
  plan(quad.position, std::span(sets).first(1), quad.view, {}, Mode::kProjective, p);
  EXPECT_EQ(p.action, Action::kProject);
  plan(quad.position, sets, quad.view, {}, Mode::kProjective, p);
  EXPECT_NE(p.action, Action::kProject);
}

}  // namespace
}  // namespace truequad::test
