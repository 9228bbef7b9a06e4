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

// Where along a side's inner edge the outer edge's triangle has its apex, from 0 at the side's start to 1 at its end: in the
// middle, but at the end where the quad has no width. There all nodes lie on one line with that end's corner, and a fan
// from it would have no area: what a rasteriser makes of its rounded vertices is arbitrary.
inline double apex_place(const bool (&flush)[4], int side) {
  const bool at_start = flush[(side + 3) % 4], at_end = flush[(side + 1) % 4];
  return at_start == at_end ? 0.5 : at_end ? 1 : 0;
}

// Calls f(Node, Node, Node) for each triangle between one side of the quad and the block: the outer edge with
// its apex on the inner one, and on both parts of the inner edge a fan from the corner.
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
  const int apex = int(cells * apex_place(block.flush, side));
  f(p, q, inner(apex));
  for (int t = 0; t < cells; ++t) f(t < apex ? p : q, inner(t + 1), inner(t));
}

}  // namespace truequad::kernel
