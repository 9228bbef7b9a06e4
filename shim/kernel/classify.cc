// Rank test of a quad in homogeneous object space; derived in docs/design.md "Nothing to do".
//
// The quad is affine when D = a A + b B + c C implies T_D = a T_A + b T_B + c T_C. Elimination of the corners' matrix
// (rows A B C D, columns x y z w) with the texture columns carried along tests both at once. Every entry carries a
// bound on what single-precision rounding of the input can have done to it, so no absolute number is needed.
#include <algorithm>
#include <cmath>

#include "truequad/kernel.h"

namespace truequad {
namespace {

// Uncertainty of an input coordinate relative to its size: its own rounding and that of a few operations before.
constexpr double kInputRounding = 4 * 0x1p-24;
// Rounding of the elimination itself, in double precision.
constexpr double kOwnRounding = 4 * 0x1p-53;

struct Entry {
  double value = 0, error = 0;
};

Entry entry(double value) { return {value, kInputRounding * std::fabs(value)}; }

constexpr int kColumns = 8;
struct Rows {
  Entry at[4][kColumns];
};

// row -= factor * pivot_row, with first-order propagation of the errors.
void eliminate(Rows& rows, int row, int pivot_row, int pivot_column, const bool (&done)[4]) {
  const Entry pivot = rows.at[pivot_row][pivot_column];
  const Entry head = rows.at[row][pivot_column];
  const double factor = head.value / pivot.value;
  const double factor_error = (head.error + std::fabs(factor) * pivot.error) / std::fabs(pivot.value);
  for (int column = 0; column < kColumns; ++column) {
    if (column < 4 && done[column]) continue;
    Entry& x = rows.at[row][column];
    const Entry& y = rows.at[pivot_row][column];
    const double product = factor * y.value;
    x.error += std::fabs(factor) * y.error + factor_error * std::fabs(y.value) +
               kOwnRounding * (std::fabs(x.value) + std::fabs(product));
    x.value -= product;
  }
  rows.at[row][pivot_column] = {};
}

bool vanishes(const Entry& x) { return std::fabs(x.value) <= x.error; }

// Eliminates three pivots. Returns the row that is left and the position column that is left, or {-1, -1} if fewer
// than three independent corners exist.
struct Left {
  int row, column;
};
Left eliminate_three(Rows& rows) {
  bool row_done[4] = {}, column_done[4] = {};
  for (int step = 0; step < 3; ++step) {
    int pivot_row = -1, pivot_column = -1;
    double best = 1;  // value over error: at most 1 is indistinguishable from 0
    for (int column : {3, 0, 1, 2}) {  // w first: it is exact in most programs, and leaves differences of points
      if (column_done[column]) continue;
      int largest = -1;
      for (int row = 0; row < 4; ++row) {
        if (row_done[row]) continue;
        if (largest < 0 || std::fabs(rows.at[row][column].value) > std::fabs(rows.at[largest][column].value)) {
          largest = row;
        }
      }
      const Entry& x = rows.at[largest][column];
      if (std::fabs(x.value) > best * x.error * (1 + 1e-9)) {
        best = x.error > 0 ? std::fabs(x.value) / x.error : 0x1p1000;
        pivot_row = largest;
        pivot_column = column;
      }
    }
    if (pivot_row < 0) return {-1, -1};
    row_done[pivot_row] = true;
    for (int row = 0; row < 4; ++row) {
      if (!row_done[row]) eliminate(rows, row, pivot_row, pivot_column, column_done);
    }
    column_done[pivot_column] = true;
  }
  const auto first_open = [](const bool(&done)[4]) { return int(std::find(done, done + 4, false) - done); };
  return {first_open(row_done), first_open(column_done)};
}

bool finite(const Corners& x) {
  // A sum of finite doubles that overflows counts as infinite: nothing could be computed from it.
  double sum = 0;
  for (const Vec4& c : x) sum += std::fabs(c.x) + std::fabs(c.y) + std::fabs(c.z) + std::fabs(c.w);
  return std::isfinite(sum);
}

bool constant(const Corners& x) {
  for (int i = 1; i < 4; ++i) {
    if (x[i].x != x[0].x || x[i].y != x[0].y || x[i].z != x[0].z || x[i].w != x[0].w) return false;
  }
  return true;
}

void put(Rows& rows, const Corners& x, int column) {
  for (int row = 0; row < 4; ++row) {
    rows.at[row][column] = entry(x[row].x);
    rows.at[row][column + 1] = entry(x[row].y);
    rows.at[row][column + 2] = entry(x[row].z);
    rows.at[row][column + 3] = entry(x[row].w);
  }
}

}  // namespace

Shape classify(const Corners& position, std::span<const Corners> textures) {
  if (!finite(position)) return Shape::kNotFinite;
  bool varies = false;
  for (const Corners& texture : textures) {
    if (!finite(texture)) return Shape::kNotFinite;
    varies |= !constant(texture);
  }
  if (!varies) return Shape::kConstant;

  for (const Corners& texture : textures) {
    if (constant(texture)) continue;
    Rows rows;
    put(rows, position, 0);
    put(rows, texture, 4);
    const Left left = eliminate_three(rows);
    if (left.row < 0) return Shape::kDegenerate;
    if (!vanishes(rows.at[left.row][left.column])) return Shape::kWarped;
    for (int column = 4; column < kColumns; ++column) {
      if (!vanishes(rows.at[left.row][column])) return Shape::kWarped;
    }
  }
  return Shape::kAffine;
}

}  // namespace truequad
