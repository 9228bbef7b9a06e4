// The test that every quad meets on the vertex path: a parallelogram in position and in texture coordinates,
// to the rounding of the floats themselves, is affine (docs/design.md "Nothing to do").
#pragma once

#include <cmath>
#include <limits>

namespace truequad {

// Order of a quad's vertices: around it, or as a strip gives them, A B D C.
enum class Order { kAround, kStrip };

// True only if classify() says kAffine, kConstant or kDegenerate for these corners in their order, each x y z w and
// s t r q. False for NaN, infinity and sums that overflow: classify() decides these.
template <Order order = Order::kAround>
bool surely_affine(const float (&position)[4][4], const float (&texture)[4][4]) {
  // classify() allows 4 units of 2^-24 of each coordinate; the residual's own rounding takes less than one of
  // two.
  constexpr float kUnits = 0x1p-23f;
  int failed = 0;
  const auto test = [&failed](const float(&x)[4][4]) {
    for (int i = 0; i < 4; ++i) {
      const float one = x[0][i] - x[1][i], other = x[2][i] - x[3][i];
      const float residual = std::fabs(order == Order::kAround ? one + other : one - other);
      const float sum = (std::fabs(x[0][i]) + std::fabs(x[1][i])) + (std::fabs(x[2][i]) + std::fabs(x[3][i]));
      // Bitwise, so that the loop has no branch; each comparison is false for NaN.
      failed |= int(!(residual <= kUnits * sum)) | int(!(sum <= std::numeric_limits<float>::max()));
    }
  };
  test(position);
  test(texture);
  return failed == 0;
}

}  // namespace truequad
