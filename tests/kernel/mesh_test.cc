// The pieces tile the quad: no crack, no overlap, no vertex on an outer edge, winding kept, corners exact.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <map>
#include <set>

#include "measure.h"
#include "screen.h"

namespace truequad::test {
namespace {

double doubled_area(const Param& a, const Param& b, const Param& c) {
  return (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
}

// Positive areas, every inner edge met once from either side, and the square as the boundary: such a mesh
// covers each point of the square exactly once (the winding number of the boundary is the number of triangles
// over a point).
void expect_tiling(const Mesh& mesh, const std::array<bool, 4>& collapsed) {
  double area = 0;
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    const int index[3] = {t.a, t.b, t.c};
    const double doubled = doubled_area(mesh.vertices[t.a], mesh.vertices[t.b], mesh.vertices[t.c]);
    ASSERT_GT(doubled, 0);
    area += doubled / 2;
    for (int k = 0; k < 3; ++k) {
      const int count = ++edges[{index[k], index[(k + 1) % 3]}];
      ASSERT_EQ(count, 1) << "an edge is used twice in one direction";
    }
  }
  ASSERT_NEAR(area, 1, 1e-12);
  int outer[4] = {};
  for (const auto& [edge, count] : edges) {
    if (edges.contains({edge.second, edge.first})) continue;
    const Param &p = mesh.vertices[std::size_t(edge.first)], &q = mesh.vertices[std::size_t(edge.second)];
    const int side = p.v == 0 && q.v == 0   ? 0
                     : p.u == 1 && q.u == 1 ? 1
                     : p.v == 1 && q.v == 1 ? 2
                     : p.u == 0 && q.u == 0 ? 3
                                            : -1;
    ASSERT_GE(side, 0) << "an inner edge has one triangle only";
    ++outer[side];
    if (!collapsed[std::size_t(side)]) {
      ASSERT_EQ(edge.first, side);
      ASSERT_EQ(edge.second, (side + 1) % 4);
    }
  }
  for (int side = 0; side < 4; ++side) {
    ASSERT_GE(outer[side], 1);
    if (!collapsed[std::size_t(side)]) {
      ASSERT_EQ(outer[side], 1);
    }
  }
  std::set<int> used;
  for (const Triangle& t : mesh.triangles) used.insert({t.a, t.b, t.c});
  ASSERT_EQ(used.size(), mesh.vertices.size()) << "vertices that no triangle needs";
}

class Tiling : public testing::TestWithParam<int> {};

TEST_P(Tiling, CoversTheParameterSquareOnce) {
  Plan& plan = scratch_plan();
  int meshes = 0;
  for (unsigned trial = 0; trial < 700; ++trial) {
    const Quad quad = random_quad(Kind(GetParam()), trial);
    Limits limits;
    limits.tolerance_px = quad.tolerance_px;
    limits.max_triangles = trial % 5 == 0 ? 4 + int(trial % 64) : trial % 5 == 1 ? kMaxTriangles : 1500;
    truequad::plan(quad.position, {&quad.texture, 1}, quad.view, limits, Mode::kBilinear, plan);
    if (plan.action != Action::kMesh) continue;
    ++meshes;
    const Mesh mesh = mesh_of(plan);
    ASSERT_EQ(int(mesh.triangles.size()), plan.triangles);
    ASSERT_LE(plan.triangles, limits.max_triangles);
    for (int corner = 0; corner < 4; ++corner) {
      ASSERT_EQ(mesh.vertices[std::size_t(corner)].u, corner == 1 || corner == 2 ? 1 : 0);
      ASSERT_EQ(mesh.vertices[std::size_t(corner)].v, corner >= 2 ? 1 : 0);
    }
    ASSERT_NO_FATAL_FAILURE(expect_tiling(mesh, plan.collapsed_edge)) << "trial " << trial;
  }
  EXPECT_GT(meshes, 50);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Tiling, testing::Range(0, int(Kind::kCount)),
                         [](const auto& info) { return name(Kind(info.param)); });

// However thin the triangles along an edge are wished to be, a rasteriser that moves their vertices to its grid, by half of
// its width at most, and the edge's ends with them, moves none beyond the edge: pixels there would be touched.
TEST(Inserted, VerticesStayInsideWhenTheyAreSnapped) {
  Plan& plan = scratch_plan();
  int meshes = 0;
  for (const Kind kind : {Kind::kConvex, Kind::kFoldedTexture, Kind::kTextureCollinear}) {
    for (unsigned trial = 0; trial < 300; ++trial) {
      Quad quad = random_quad(Kind::kConvex, trial);
      quad.texture = random_quad(kind, trial).texture;
      // Three corners of one colour, which is a map without inverse at them.
      if (trial % 3 == 0) quad.texture[1] = quad.texture[2] = quad.texture[3];
      quad.view.snap_px = 1.0 / 256;
      quad.view.setup_rounding = 0x1p-24;
      truequad::plan(quad.position, {&quad.texture, 1}, quad.view, {}, Mode::kBilinear, plan);
      kernel::ScreenQuad screen;
      ASSERT_TRUE(kernel::make_screen_quad(quad.position, quad.view, screen));
      if (plan.action != Action::kMesh || plan.u.count <= 2) continue;
      ++meshes;
      const auto snapped = [&](double u, double v) {
        const kernel::MeshPoint p = screen.mesh_point(u, v);
        return glm::dvec2(std::round(p.x * 256), std::round(p.y * 256));
      };
      const glm::dvec2 corner[] = {snapped(0, 0), snapped(1, 0), snapped(1, 1), snapped(0, 1)};
      for (const Param& p : mesh_of(plan).vertices) {
        const double to_side[] = {p.v, 1 - p.u, 1 - p.v, p.u};
        const glm::dvec2 at = snapped(p.u, p.v);
        for (int side = 0; side < 4; ++side) {
          if (to_side[side] == 0 || plan.collapsed_edge[std::size_t(side)]) continue;
          const glm::dvec2 a = corner[side], along = corner[(side + 1) % 4] - a, away = at - a;
          const glm::dvec2 far = corner[(side + 2) % 4] - a, other = corner[(side + 3) % 4] - a;
          const auto left = [&](const glm::dvec2& of) { return along.x * of.y - along.y * of.x; };
          ASSERT_GT(left(away) * (left(far) + left(other)), 0) << name(kind) << " " << trial << " side " << side;
        }
      }
    }
  }
  EXPECT_GT(meshes, 300);
}

TEST(Interpolate, IsBitExactAtTheCornersAndConstantAlongEqualEnds) {
  for (unsigned trial = 0; trial < 10000; ++trial) {
    std::mt19937 engine(trial);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto any = [&] { return std::ldexp(unit(engine), int(engine() % 60) - 30); };
    const float a = any(), b = any(), c = any(), d = any(), t = (unit(engine) + 1) / 2;
    EXPECT_EQ(interpolate(a, b, c, d, 0.f, 0.f), a);
    EXPECT_EQ(interpolate(a, b, c, d, 1.f, 0.f), b);
    EXPECT_EQ(interpolate(a, b, c, d, 1.f, 1.f), c);
    EXPECT_EQ(interpolate(a, b, c, d, 0.f, 1.f), d);
    EXPECT_EQ(interpolate(a, a, c, d, t, 0.f), a);
    EXPECT_EQ(interpolate(a, b, b, d, 1.f, t), b);
    EXPECT_EQ(interpolate(a, b, c, c, t, 1.f), c);
    EXPECT_EQ(interpolate(a, b, c, a, 0.f, t), a);
    EXPECT_EQ(interpolate(a, a, a, a, t, 1 - t), a);
  }
}

TEST(Paper, LeavesTileTheSquare) {
  Plan& plan = scratch_plan();
  for (unsigned trial = 0; trial < 500; ++trial) {
    const Quad quad = random_quad(Kind::kConvex, trial);
    truequad::plan(quad.position, {&quad.texture, 1}, quad.view, {}, Mode::kPaper, plan);
    if (plan.action != Action::kMesh) continue;
    ASSERT_LE(plan.triangles, Limits{}.max_triangles);
    double area = 0;
    for (std::size_t i = 0; i < plan.leaf_count; ++i) {
      const Leaf& leaf = plan.leaves[i];
      ASSERT_LT(leaf.u0, leaf.u1);
      ASSERT_EQ(leaf.u1 - leaf.u0, leaf.v1 - leaf.v0);
      area += double(leaf.u1 - leaf.u0) * double(leaf.v1 - leaf.v0);
    }
    ASSERT_EQ(area, 1) << "dyadic areas add up exactly";
    const Mesh mesh = mesh_of(plan);
    double of_triangles = 0;
    for (const Triangle& t : mesh.triangles) {
      const double doubled = doubled_area(mesh.vertices[t.a], mesh.vertices[t.b], mesh.vertices[t.c]);
      ASSERT_GT(doubled, 0);
      of_triangles += doubled / 2;
    }
    ASSERT_EQ(of_triangles, 1);
  }
}

}  // namespace
}  // namespace truequad::test
