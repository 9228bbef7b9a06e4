// The geometry of truequad without OpenGL: what to draw in place of a quadrilateral, for renderers of one's own.
#include <truequad/kernel.h>

#include <cstdio>
#include <memory>
#include <vector>

int main() {
  // Corners in drawing order, and the texture coordinates of each.
  const truequad::Corners position = {{{-0.9, -0.9, 0, 1}, {0.9, -0.9, 0, 1}, {0.3, 0.9, 0, 1}, {-0.3, 0.9, 0, 1}}};
  const truequad::Corners texture[] = {{{{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}}}};

  truequad::View view;
  for (int i = 0; i < 4; ++i) view.clip_from_object[5 * i] = 1;
  view.viewport = {0, 0, 640, 480};
  truequad::Limits limits;
  limits.tolerance_px = 0.5;

  const auto plan = std::make_unique<truequad::Plan>();  // large
  truequad::plan(position, texture, view, limits, truequad::Mode::kBilinear, *plan);
  if (plan->action != truequad::Action::kMesh) return 1;

  const truequad::MeshSize size = truequad::mesh_size(*plan);
  std::vector<truequad::Param> vertices(size.vertices);
  std::vector<truequad::Triangle> triangles(size.triangles);
  truequad::tessellate(*plan, vertices, triangles);

  std::printf("%zu triangles, no texel more than %.3f px out of place\n", triangles.size(), plan->bound_px);
  const truequad::Param& inner = vertices.back();
  std::printf("last vertex: x %.4f, y %.4f\n",
              truequad::interpolate(position[0].x, position[1].x, position[2].x, position[3].x, inner.u, inner.v),
              truequad::interpolate(position[0].y, position[1].y, position[2].y, position[3].y, inner.u, inner.v));
  return plan->bound_px <= limits.tolerance_px ? 0 : 1;
}
