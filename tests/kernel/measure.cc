#include "measure.h"

#include <cmath>
#include <memory>

namespace truequad::test {

using reference::Real;

Mesh mesh_of(const Plan& plan) {
  const MeshSize size = mesh_size(plan);
  Mesh mesh{std::vector<Param>(size.vertices), std::vector<Triangle>(size.triangles)};
  tessellate(plan, mesh.vertices, mesh.triangles);
  return mesh;
}

Mesh two_triangles(bool along_ac) {
  Mesh mesh{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};
  if (along_ac) {
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  } else {
    mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
  }
  return mesh;
}

namespace {

Real bilinear(Real a, Real b, Real c, Real d, Real u, Real v) {
  return (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d;
}

}  // namespace

Drawn drawn_point(const Quad& quad, const Mesh& mesh, const Triangle& triangle, Real b0, Real b1, Real b2) {
  const auto clip = reference::clip_corners(quad.position, quad.view);
  Real p[4] = {}, s = 0, t = 0;
  const Real weight[3] = {b0, b1, b2};
  const std::uint16_t index[3] = {triangle.a, triangle.b, triangle.c};
  for (int k = 0; k < 3; ++k) {
    const auto [u, v] = mesh.vertices[index[k]];
    for (std::size_t row = 0; row < 4; ++row) {
      p[row] += weight[k] * bilinear(clip[0][row], clip[1][row], clip[2][row], clip[3][row], u, v);
    }
    const Corners& x = quad.texture;
    s += weight[k] * bilinear(x[0].x, x[1].x, x[2].x, x[3].x, u, v);
    t += weight[k] * bilinear(x[0].y, x[1].y, x[2].y, x[3].y, u, v);
  }
  const Viewport& view = quad.view.viewport;
  Drawn drawn{{0, 0}, s / quad.texture[0].w, t / quad.texture[0].w, false};
  if (!(p[3] > 0)) return drawn;
  drawn.visible = std::fabs(p[0]) <= p[3] && std::fabs(p[1]) <= p[3] && std::fabs(p[2]) <= p[3];
  drawn.window = {view.x + view.width / 2 * (1 + p[0] / p[3]), view.y + view.height / 2 * (1 + p[1] / p[3])};
  return drawn;
}

namespace {

// Displacement of the point, or -1 if it is not seen.
Real displacement(const Quad& quad, const Drawn& drawn) {
  if (!drawn.visible) return -1;
  const Corners& t = quad.texture;
  const bool one_dimensional = t[0].y == t[1].y && t[1].y == t[2].y && t[2].y == t[3].y;
  return one_dimensional
             ? reference::bilinear_displacement_1d(quad.position, t, quad.view, drawn.window, drawn.s)
             : reference::bilinear_displacement(quad.position, t, quad.view, drawn.window, drawn.s, drawn.t);
}

void add(Measured& measured, Real px) {
  if (px < 0) return;
  ++measured.visible;
  measured.largest_px = std::max(measured.largest_px, double(px));
}

}  // namespace

Measured measure(const Quad& quad, const Mesh& mesh, int samples, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Measured measured;
  for (int i = 0; i < samples; ++i) {
    const bool all = samples >= int(mesh.triangles.size());
    const std::size_t k =
        all ? std::size_t(i) % mesh.triangles.size()
            : std::uniform_int_distribution<std::size_t>(0, mesh.triangles.size() - 1)(engine);
    Real b[3];
    if (i % 2 == 0) {
      // Where the interpolation error is largest: the middle of an edge, an odd part of the time slightly
      // beside it.
      const int edge = int(engine() % 3);
      const double t = engine() % 2 ? 0.5 : unit(engine);
      b[edge] = t;
      b[(edge + 1) % 3] = 1 - t;
      b[(edge + 2) % 3] = 0;
    } else {
      const double r = std::sqrt(unit(engine)), t = unit(engine);
      b[0] = 1 - r, b[1] = r * (1 - t), b[2] = r * t;
    }
    add(measured, displacement(quad, drawn_point(quad, mesh, mesh.triangles[k], b[0], b[1], b[2])));
  }
  return measured;
}

double measure_finely(const Quad& quad, const Mesh& mesh, int divisions) {
  Measured measured;
  for (const Triangle& triangle : mesh.triangles) {
    for (int i = 0; i <= divisions; ++i) {
      for (int j = 0; i + j <= divisions; ++j) {
        const Real b1 = Real(i) / divisions, b2 = Real(j) / divisions;
        add(measured, displacement(quad, drawn_point(quad, mesh, triangle, 1 - b1 - b2, b1, b2)));
      }
    }
  }
  return measured.largest_px;
}

Plan& scratch_plan() {
  static const std::unique_ptr<Plan> plan = std::make_unique<Plan>();
  return *plan;
}

}  // namespace truequad::test
