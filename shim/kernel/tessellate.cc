// Writes the vertices and triangles of a plan: docs/design.md "Mesh".
#include <algorithm>

#include "mesh.h"
#include "truequad/kernel.h"

namespace truequad {
namespace {

using kernel::Block;
using kernel::Node;

// Numbers of the vertices: the quad's corners, the block's nodes row by row (without those that are corners),
// the centres row by row.
class Numbering {
 public:
  explicit Numbering(const Block& block) : block_(block) {
    for (int corner = 0; corner < 4; ++corner) shared_[corner] = block.has_corner(corner);
  }
  std::uint16_t node(Node node) const {
    const auto [i, j] = node;
    const int n = block_.n, m = block_.m;
    if (i < 0 || i > n || j < 0 || j > m) return std::uint16_t(j < 0 ? (i < 0 ? 0 : 1) : (i < 0 ? 3 : 2));
    int skipped = 0;
    const struct { int corner, i, j; } in_order[4] = {{0, 0, 0}, {1, n, 0}, {3, 0, m}, {2, n, m}};
    for (const auto& c : in_order) {
      if (!shared_[c.corner]) continue;
      if (c.i == i && c.j == j) return std::uint16_t(c.corner);
      skipped += c.j < j || (c.j == j && c.i < i);
    }
    return std::uint16_t(4 + j * (n + 1) + i - skipped);
  }
  std::size_t first_centre() const {
    return std::size_t(4 + (block_.n + 1) * (block_.m + 1)) -
           std::size_t(std::count(shared_, shared_ + 4, true));
  }
  std::size_t vertices() const { return first_centre() + std::size_t(block_.n) * std::size_t(block_.m); }

 private:
  const Block& block_;
  bool shared_[4];
};

constexpr Param kCorner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

void write_leaves(const Plan& plan, std::span<Param> vertices, std::span<Triangle> triangles) {
  std::size_t next = 4, triangle = 0;
  for (std::size_t i = 0; i < plan.leaf_count; ++i) {
    const Leaf& leaf = plan.leaves[i];
    const auto first = std::uint16_t(next);
    for (const Param& corner : kCorner) {
      vertices[next++] = {corner.u == 0 ? leaf.u0 : leaf.u1, corner.v == 0 ? leaf.v0 : leaf.v1};
    }
    const auto vertex = [&](int k) { return std::uint16_t(first + k); };
    triangles[triangle++] = {vertex(0), vertex(1), vertex(2)};
    triangles[triangle++] = {vertex(0), vertex(2), vertex(3)};
  }
}

void write_block(const Plan& plan, std::span<Param> vertices, std::span<Triangle> triangles) {
  const Block block(plan);
  const Numbering number(block);
  std::size_t centre = number.first_centre(), triangle = 0;
  for (int j = 0; j <= block.m; ++j) {
    for (int i = 0; i <= block.n; ++i) vertices[number.node({i, j})] = kernel::param(plan, block, {i, j});
  }
  for (int j = 0; j < block.m; ++j) {
    for (int i = 0; i < block.n; ++i) {
      const std::uint16_t ring[4] = {number.node({i, j}), number.node({i + 1, j}),
                                     number.node({i + 1, j + 1}), number.node({i, j + 1})};
      vertices[centre] = kernel::centre(plan, i, j);
      for (int k = 0; k < 4; ++k) triangles[triangle++] = {ring[k], ring[(k + 1) % 4], std::uint16_t(centre)};
      ++centre;
    }
  }
  for (int side = 0; side < 4; ++side) {
    if (block.flush[side]) continue;
    kernel::for_each_border_triangle(
        block, side, [&](Node node) { return number.node(node); },
        [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) { triangles[triangle++] = {a, b, c}; });
  }
}

}  // namespace

MeshSize mesh_size(const Plan& plan) {
  if (plan.leaf_count > 0) return {4 + 4 * plan.leaf_count, 2 * plan.leaf_count};
  const Block block(plan);
  return {Numbering(block).vertices(), std::size_t(block.triangles())};
}

void tessellate(const Plan& plan, std::span<Param> vertices, std::span<Triangle> triangles) {
  std::copy(std::begin(kCorner), std::end(kCorner), vertices.begin());
  if (plan.leaf_count > 0) {
    write_leaves(plan, vertices, triangles);
  } else {
    write_block(plan, vertices, triangles);
  }
}

}  // namespace truequad
