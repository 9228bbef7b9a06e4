// The triangles of a mesh, in one place for those who bound them and those who write them (docs/design.md
// "Mesh").
#pragma once

#include <algorithm>

#include "truequad/kernel.h"

namespace truequad::kernel {

// A vertex of the block: i, j number the grid lines; outside of [0, cells] it is the quad's corner on that side.
struct Node {
  int i, j;
};

// Vertices of a side's inner edge, numbered along it, without those that are the quad's own corners.
struct Chain {
  int first, last;
  int count() const { return last - first + 1; }
};

// Vertex of the chain whose triangle stands on the edge between those before `first` and after `last`.
inline int apex(int first, int last) { return first + (last - first) / 2; }

// The block of a plan in numbers of cells, and the sides on which it reaches the quad's own edge: AB, BC, CD,
// DA.
struct Block {
  int n, m;
  bool flush[4];

  Block(int n, int m, const std::array<bool, 4>& flush)
      : n(n), m(m), flush{flush[0], flush[1], flush[2], flush[3]} {}
  explicit Block(const Plan& plan)
      : Block(int(plan.u.count) - 1, int(plan.v.count) - 1,
              {plan.v.at[0] == 0, plan.u.at[plan.u.count - 1] == 1, plan.v.at[plan.v.count - 1] == 1,
               plan.u.at[0] == 0}) {}

  // A block that reaches one of the sides at a corner has that corner for its own.
  bool has_corner(int corner) const { return flush[corner] || flush[(corner + 3) % 4]; }
  int side_cells(int side) const { return side % 2 == 0 ? n : m; }
  Chain chain(int side) const {
    return {has_corner(side) ? 1 : 0, side_cells(side) - (has_corner((side + 1) % 4) ? 1 : 0)};
  }
  int triangles() const {
    int count = 4 * n * m;
    for (int side = 0; side < 4; ++side) count += flush[side] ? 0 : chain(side).count();
    return count;
  }
};

// The vertex of a side's inner edge with this number.
inline Node inner_node(const Block& block, int side, int t) {
  switch (side) {
    case 0:
      return {t, 0};
    case 1:
      return {block.n, t};
    case 2:
      return {block.n - t, block.m};
    default:
      return {0, block.m - t};
  }
}

// How far beyond the inset a vertex of the inner edge lies, so that each stands off the edge between its
// ancestors: one inset more for each level of the tree of triangles, and never more than `room`.
inline double extra_inset(const Chain& chain, int t, double inset, double room) {
  int levels = 0;
  for (int first = chain.first, last = chain.last; first <= last; ++levels) {
    const int middle = apex(first, last);
    if (middle == t) break;
    (t < middle ? last : first) = t < middle ? middle - 1 : middle + 1;
  }
  const double wanted = levels * inset;
  return wanted / (1 + wanted / room);
}

inline Param param(const Plan& plan, const Block& block, Node node) {
  const auto [i, j] = node;
  const int n = block.n, m = block.m;
  const bool left = i <= 0, right = i >= n, low = j <= 0, high = j >= m;
  const bool outside = i < 0 || i > n || j < 0 || j > m;
  if (outside || ((left || right) && (low || high))) {
    const int corner = low ? (left ? 0 : 1) : (left ? 3 : 2);
    // With one cell a node is at two corners' places; only the one that is meant counts.
    if (outside || block.has_corner(corner)) return {left ? 0.0 : 1.0, low ? 0.0 : 1.0};
  }
  double u = plan.u.at[std::size_t(i)], v = plan.v.at[std::size_t(j)];
  constexpr double kRoom = 1.0 / 3;  // of the cell at the border
  const auto extra = [&](int side, int t, const GridLines& lines, bool at_start) {
    const double inset = at_start ? lines.at[0] : 1 - lines.at[lines.count - 1];
    const double cell = at_start ? lines.at[1] - lines.at[0] : lines.at[lines.count - 1] - lines.at[lines.count - 2];
    return extra_inset(block.chain(side), t, inset, kRoom * cell);
  };
  double du = 0, dv = 0;
  if (low && !block.flush[0]) dv = extra(0, i, plan.v, true);
  if (high && !block.flush[2]) dv = -extra(2, n - i, plan.v, false);
  if (left && !block.flush[3]) du = extra(3, m - j, plan.u, true);
  if (right && !block.flush[1]) du = -extra(1, j, plan.u, false);
  return {u + du, v + dv};
}

// The centre of a cell's fan: in the middle of the lines, so that it is no farther from vertices that were moved inwards.
inline Param centre(const Plan& plan, int i, int j) {
  return {(plan.u.at[std::size_t(i)] + plan.u.at[std::size_t(i) + 1]) / 2,
          (plan.v.at[std::size_t(j)] + plan.v.at[std::size_t(j) + 1]) / 2};
}

// Calls f(p, q, top) for each triangle between one side of the quad and the block, with what vertex(Node) makes of its
// nodes: a binary tree of them, the outer edge at its root, so that each stands on a base that is half as long as the last.
template <typename Vertex, typename F>
void for_each_border_triangle(const Block& block, int side, Vertex&& vertex, F&& f) {
  const Node corner[4] = {{-1, -1}, {block.n + 1, -1}, {block.n + 1, block.m + 1}, {-1, block.m + 1}};
  const auto stand = [&](auto&& self, const auto& p, const auto& q, int first, int last) -> void {
    if (first > last) return;
    const int t = apex(first, last);
    const auto top = vertex(inner_node(block, side, t));
    f(p, q, top);
    self(self, p, top, first, t - 1);
    self(self, top, q, t + 1, last);
  };
  const Chain chain = block.chain(side);
  stand(stand, vertex(corner[side]), vertex(corner[(side + 1) % 4]), chain.first, chain.last);
}

}  // namespace truequad::kernel
