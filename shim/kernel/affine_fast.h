// The test that every quad meets on the vertex path: a parallelogram in position and in texture coordinates,
// to the rounding of the floats themselves, is affine (docs/design.md "Nothing to do").
#pragma once

namespace truequad {

// The order of a quad's vertices, as the sign that the second pair's difference has in its residual: around it A B C D, or
// as a strip gives them, A B D C. A number, so that both orders are one piece of code on the vertex path.
inline constexpr float kAround = 1, kStrip = -1;

namespace fast {

// Four numbers at once. Always inline: a vertex call has no room for a call of its own, and there are hundreds of them.
using Four [[gnu::vector_size(16), gnu::may_alias]] = float;
using Mask [[gnu::vector_size(16)]] = int;

[[gnu::always_inline]] inline Four row(const float (&x)[4]) { return reinterpret_cast<const Four&>(x); }
[[gnu::always_inline]] inline Four magnitude(Four x) { return reinterpret_cast<Four>(reinterpret_cast<Mask>(x) & 0x7fffffff); }

[[gnu::always_inline]] inline bool all(Mask holds) {
#ifdef __SSE__
  return __builtin_ia32_movmskps(reinterpret_cast<Four>(holds)) == 15;
#else
  using Halves [[gnu::vector_size(16)]] = long long;
  const Halves halves = reinterpret_cast<Halves>(holds);
  return (halves[0] & halves[1]) == -1;
#endif
}

// By how much the four numbers of A - B + C - D exceed what rounding explains; not finite if a number is not, or if one is so
// large that their sum overflows. Two corners' magnitudes are enough to measure rounding by: the others' are about as large where
// the residual is small, and where they are not, classify() decides.
[[gnu::always_inline]] inline Four excess(const float (&x)[4][4], float order) {
  // classify() allows 4 units of 2^-24 of each coordinate of four; the residual's own rounding takes less than one of two.
  constexpr float kUnits = 0x1p-23f;
  const Four a = row(x[0]), c = row(x[2]);
  return magnitude((a - row(x[1])) + order * (c - row(x[3]))) - kUnits * (magnitude(a) + magnitude(c));
}

}  // namespace fast

// True only if classify() says kAffine, kConstant or kDegenerate for these corners in their order, each x y z w and
// s t r q, aligned to 16 bytes. False for NaN, infinity and sums that overflow: classify() decides these.
[[gnu::always_inline]] inline bool surely_affine(const float (&position)[4][4], const float (&texture)[4][4],
                                                 float order = kAround) {
  // Infinity less infinity is NaN, for which each comparison is false.
  return fast::all((fast::excess(position, order) <= 0) & (fast::excess(texture, order) <= 0));
}

}  // namespace truequad
