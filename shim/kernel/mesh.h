// The triangles of a mesh, in one place for those who bound them and those who write them (docs/design.md
// "Mesh").
#pragma once

#include "truequad/kernel.h"

namespace truequad::kernel {

// A vertex of the block and its surroundings: i, j number the grid lines; outside of [0, cells] it is the
// quad's corner on that side.
struct Node {
  int i, j;
};

// The block of a plan in numbers of cells, and the sides on which it reaches the quad's own edge: AB, BC, CD,
// DA.
struct Block {
  int n, m;
  bool flush[4];

  explicit Block(const Plan& plan)
      : n(int(plan.u.count) - 1),
        m(int(plan.v.count) - 1),
        flush{plan.v.at[0] == 0, plan.u.at[n] == 1, plan.v.at[m] == 1, plan.u.at[0] == 0} {}

  int side_cells(int side) const { return side % 2 == 0 ? n : m; }
  int triangles() const {
    int count = 4 * n * m;
    for (int side = 0; side < 4; ++side) count += flush[side] ? 0 : side_cells(side) + 1;
    return count;
  }
};

inline Param param(const Plan& plan, const Block& block, Node node) {
  const auto at = [](const GridLines& lines, int i, int cells) {
    return i < 0 ? 0.0 : i > cells ? 1.0 : lines.at[std::size_t(i)];
  };
  return {at(plan.u, node.i, block.n), at(plan.v, node.j, block.m)};
}

// Calls f(Node, Node, Node) for each triangle between one side of the quad and the block: the outer edge with
// the middle node of the inner one as apex, and on both halves of the inner edge a fan from the corner.
template <typename F>
void for_each_border_triangle(const Block& block, int side, F&& f) {
  const int n = block.n, m = block.m;
  const Node corner[4] = {{-1, -1}, {n + 1, -1}, {n + 1, m + 1}, {-1, m + 1}};
  const int cells = block.side_cells(side);
  const auto inner = [&](int t) {
    switch (side) {
      case 0:
        return Node{t, 0};
      case 1:
        return Node{n, t};
      case 2:
        return Node{n - t, m};
      default:
        return Node{0, m - t};
    }
  };
  const Node p = corner[side], q = corner[(side + 1) % 4];
  const int apex = cells / 2;
  f(p, q, inner(apex));
  for (int t = 0; t < cells; ++t) f(t < apex ? p : q, inner(t + 1), inner(t));
}

}  // namespace truequad::kernel
