// Rank test of a quad in homogeneous object space; derived in docs/design.md "Nothing to do".
//
// The quad is affine when D = a A + b B + c C implies T_D = a T_A + b T_B + c T_C. Elimination of the
// corners' matrix (rows A B C D, columns x y z w) with the texture columns carried along tests both at once.
// Every entry carries a bound on what single-precision rounding of the input can have done to it, so no
// absolute number is needed.
#include <algorithm>
#include <cmath>

#include "truequad/kernel.h"

namespace truequad {
namespace {

// Uncertainty of an input coordinate relative to its size: its own rounding and that of a few operations
// before.
constexpr double kInputRounding = 4 * 0x1p-24;
// Rounding of the elimination itself, in double precision.
constexpr double kOwnRounding = 4 * 0x1p-53;

constexpr int kColumns = 8;  // x y z w of the position, s t r q of one texture set

// Values and bounds on their errors, apart from each other so that loops over columns vectorise.
struct Rows {
  double value[4][kColumns], error[4][kColumns];
  bool vanishes(int row, int column) const { return std::fabs(value[row][column]) <= error[row][column]; }
};

// Takes the pivot's multiple off a row, with first-order propagation of the errors. Columns of earlier pivots
// hold 0 in both rows and stay 0.
void eliminate(Rows& rows, int row, int pivot_row, int pivot_column) {
  double* const x = rows.value[row];
  double* const x_error = rows.error[row];
  const double* const y = rows.value[pivot_row];
  const double* const y_error = rows.error[pivot_row];
  const double factor = x[pivot_column] / y[pivot_column], size = std::fabs(factor);
  const double factor_error =
      (x_error[pivot_column] + size * y_error[pivot_column]) / std::fabs(y[pivot_column]);
  for (int column = 0; column < kColumns; ++column) {
    const double product = factor * y[column];
    x_error[column] += size * y_error[column] + factor_error * std::fabs(y[column]) +
                       kOwnRounding * (std::fabs(x[column]) + std::fabs(product));
    x[column] -= product;
  }
  x[pivot_column] = x_error[pivot_column] = 0;
}

// Eliminates three pivots. Returns the row and the position column that are left, or {-1, -1} if fewer than
// three independent corners exist.
struct Left {
  int row, column;
};
Left eliminate_three(Rows& rows) {
  bool row_done[4] = {}, column_done[4] = {};
  for (int step = 0; step < 3; ++step) {
    int pivot_row = -1, pivot_column = -1;
    // Value and error of the best pivot so far; a value not above its error is indistinguishable from 0.
    double best = 1, best_error = 1;
    for (int column :
         {3, 0, 1, 2}) {  // w first: it is exact in most programs, and leaves differences of points
      if (column_done[column]) continue;
      int largest = -1;
      for (int row = 0; row < 4; ++row) {
        if (row_done[row]) continue;
        if (largest < 0 || std::fabs(rows.value[row][column]) > std::fabs(rows.value[largest][column]))
          largest = row;
      }
      const double value = std::fabs(rows.value[largest][column]), error = rows.error[largest][column];
      // The slack lets w win among columns that are all as exact as their input.
      if (value > error && value * best_error > best * error * (1 + 1e-9)) {
        best = value;
        best_error = error;
        pivot_row = largest;
        pivot_column = column;
      }
    }
    if (pivot_row < 0) return {-1, -1};
    row_done[pivot_row] = column_done[pivot_column] = true;
    for (int row = 0; row < 4; ++row) {
      if (!row_done[row]) eliminate(rows, row, pivot_row, pivot_column);
    }
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

void put(Rows& rows, const Corners& x, int first_column) {
  const bool same_w = x[1].w == x[0].w && x[2].w == x[0].w && x[3].w == x[0].w;
  for (int row = 0; row < 4; ++row) {
    double* const value = rows.value[row] + first_column;
    value[0] = x[row].x;
    value[1] = x[row].y;
    value[2] = x[row].z;
    value[3] = x[row].w;
    for (int i = 0; i < 4; ++i) rows.error[row][first_column + i] = kInputRounding * std::fabs(value[i]);
    // The same at all corners, w and q are a choice and no result: 1 mostly. Their rounding would count for that of whole
    // coordinates, which are large far from the origin.
    if (same_w) rows.error[row][first_column + 3] = 0;
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
    if (!rows.vanishes(left.row, left.column)) return Shape::kWarped;
    for (int column = 4; column < kColumns; ++column) {
      if (!rows.vanishes(left.row, column)) return Shape::kWarped;
    }
  }
  return Shape::kAffine;
}

}  // namespace truequad
