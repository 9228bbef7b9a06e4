// The capture's conversions against the formulas of the specifications, written out.
#include "capture/values.h"

#include <gtest/gtest.h>

#include <cmath>

namespace truequad {
namespace {

TEST(Values, EveryHalfIsItsFormula) {
  for (unsigned h = 0; h < 0x10000; ++h) {
    const int exponent = h >> 10 & 31, fraction = h & 1023;
    double expected = exponent ? std::ldexp(1024 + fraction, exponent - 25) : std::ldexp(fraction, -24);
    if (exponent == 31) expected = fraction ? NAN : INFINITY;
    if (h & 0x8000) expected = -expected;
    const float value = from_half(std::uint16_t(h));
    if (std::isnan(expected)) EXPECT_TRUE(std::isnan(value)) << h;
    else EXPECT_EQ(value, expected) << h;
    EXPECT_EQ(std::signbit(value), (h & 0x8000) != 0) << h;
  }
}

TEST(Values, NormalizedIntegersReachTheirEnds) {
  EXPECT_EQ(from_normalized<std::uint8_t>(255), 1);
  EXPECT_EQ(from_normalized<std::uint8_t>(0), 0);
  EXPECT_EQ(from_normalized<std::int8_t>(127), 1);
  EXPECT_EQ(from_normalized<std::int8_t>(-128), -1);
  EXPECT_EQ(from_normalized<std::int16_t>(-32768), -1);
  EXPECT_EQ(from_normalized<std::uint32_t>(0xffffffffu), 1);
  EXPECT_EQ(from_normalized<std::int32_t>(INT32_MIN), -1);
  EXPECT_FLOAT_EQ(from_normalized<std::uint8_t>(51), 0.2f);
}

TEST(Values, DoublesBeyondTheFloatsAreInfinite) {
  constexpr double kMax = std::numeric_limits<float>::max();
  EXPECT_EQ(from_double(1e300), INFINITY);
  EXPECT_EQ(from_double(-1e300), -INFINITY);
  EXPECT_EQ(from_double(kMax), float(kMax));
  EXPECT_EQ(from_double(kMax * (1 + 0x1p-26)), float(kMax));
  EXPECT_EQ(from_double(-kMax * (1 + 0x1p-24)), -INFINITY);
  EXPECT_TRUE(std::isnan(from_double(NAN)));
  EXPECT_EQ(from_double(0.1), 0.1f);
}

TEST(Values, PackedFieldsAreSignExtendedAndScaled) {
  Float4 v;
  ASSERT_TRUE(unpack(GL_INT_2_10_10_10_REV, false, 0x200u | 0x1ffu << 10 | 0x3ffu << 20 | 2u << 30, v));
  EXPECT_EQ(v.at[0], -512);
  EXPECT_EQ(v.at[1], 511);
  EXPECT_EQ(v.at[2], -1);
  EXPECT_EQ(v.at[3], -2);
  ASSERT_TRUE(unpack(GL_UNSIGNED_INT_2_10_10_10_REV, true, 0xffffffffu, v));
  for (float x : v.at) EXPECT_EQ(x, 1);
  ASSERT_TRUE(unpack(GL_UNSIGNED_INT_10F_11F_11F_REV, false, 0x3c0u | 0x400u << 11 | 0x1c0u << 22, v));
  EXPECT_EQ(v.at[0], 1);
  EXPECT_EQ(v.at[1], 2);
  EXPECT_EQ(v.at[2], 0.5f);
  EXPECT_FALSE(unpack(GL_FLOAT, false, 0, v));
}

}  // namespace
}  // namespace truequad
