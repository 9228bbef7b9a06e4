// The test that every quad meets on the vertex path: a parallelogram in position and in texture coordinates,
// to the rounding of the floats themselves, is affine (docs/design.md "Nothing to do").
#pragma once

#include <limits>

namespace truequad {

// The order of a quad's vertices, as the sign that the second pair's difference has in its residual: around it A B C D, or
// as a strip gives them, A B D C. A number, so that both orders are one piece of code on the vertex path.
inline constexpr float kAround = 1, kStrip = -1;

namespace fast {

// Four numbers at once. Always inline: a vertex call has no room for a call of its own, and there are hundreds of them.
using Four [[gnu::vector_size(16), gnu::aligned(alignof(float)), gnu::may_alias]] = float;
using Mask [[gnu::vector_size(16)]] = int;

[[gnu::always_inline]] inline Four row(const float (&x)[4]) { return reinterpret_cast<const Four&>(x); }
[[gnu::always_inline]] inline Four magnitude(Four x) { return reinterpret_cast<Four>(reinterpret_cast<Mask>(x) & 0x7fffffff); }
[[gnu::always_inline]] inline Four magnitudes(const float (&x)[4][4]) {
  return (magnitude(row(x[0])) + magnitude(row(x[1]))) + (magnitude(row(x[2])) + magnitude(row(x[3])));
}
[[gnu::always_inline]] inline Four residual(const float (&x)[4][4], float order) {
  return magnitude((row(x[0]) - row(x[1])) + order * (row(x[2]) - row(x[3])));
}

}  // namespace fast

// True only if classify() says kAffine, kConstant or kDegenerate for these corners in their order, each x y z w and
// s t r q. False for NaN, infinity and sums that overflow: classify() decides these.
[[gnu::always_inline]] inline bool surely_affine(const float (&position)[4][4], const float (&texture)[4][4],
                                                 float order = kAround) {
  // classify() allows 4 units of 2^-24 of each coordinate; the residual's own rounding takes less than one of
  // two.
  constexpr float kUnits = 0x1p-23f;
  const fast::Four p = fast::magnitudes(position), t = fast::magnitudes(texture);
  // Each comparison is false for NaN.
  const fast::Mask holds = (fast::residual(position, order) <= kUnits * p) & (fast::residual(texture, order) <= kUnits * t) &
                           (p + t <= std::numeric_limits<float>::max());
  using Halves [[gnu::vector_size(16)]] = long long;
  const Halves halves = reinterpret_cast<Halves>(holds);
  return (halves[0] & halves[1]) == -1;
}

}  // namespace truequad
