// The floating-point value of a number given to GL, by the rules of GL 2.1 section 2.14 table 2.9 (normalised
// integers), NV_half_float, OES_fixed_point and ARB_vertex_type_2_10_10_10_rev. It is used for new vertices inside a
// quad and for decisions; corners are always sent as the program gave them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "capture/rows.h"
#include "gl_enums.h"

namespace truequad {

struct alignas(16) Float4 {
  float at[4];
};

// Section 2.14.6.
inline void clamp_colour(Float4& x) {
  for (float& component : x.at) component = component > 0 ? (component < 1 ? component : 1) : 0;
}

// IEEE 754 half precision.
inline float from_half(std::uint16_t half) {
  const std::uint32_t sign = std::uint32_t(half & 0x8000u) << 16;
  const std::uint32_t exponent = (half >> 10) & 0x1fu, fraction = half & 0x3ffu;
  if (exponent == 0) {  // zero and denormals: fraction * 2^-24
    const float magnitude = float(fraction) * 0x1p-24f;
    return sign ? -magnitude : magnitude;
  }
  const std::uint32_t float_exponent = exponent == 31 ? 255 : exponent + 112;
  return std::bit_cast<float>(sign | (float_exponent << 23) | (fraction << 13));
}

// Table 2.9: unsigned c/(2^b-1), signed (2c+1)/(2^b-1). GL 4.2 has max(c/(2^(b-1)-1), -1) for signed ones; the two
// differ by less than the precision of the type.
template <typename T>
float from_normalized(T value) {
  constexpr double kSteps = double(std::numeric_limits<std::make_unsigned_t<T>>::max());
  if constexpr (std::is_signed_v<T>) return float((2.0 * double(value) + 1.0) / kSteps);
  else return float(double(value) / kSteps);
}

// A double beyond the floats becomes an infinity, as in the driver.
inline float from_double(double value) {
  constexpr double kMax = std::numeric_limits<float>::max();
  if (value > kMax) return value >= kMax * (1 + 0x1p-25) ? std::numeric_limits<float>::infinity() : float(kMax);
  if (value < -kMax) return -from_double(-value);
  return float(value);
}

template <Encoding encoding, bool normalized, typename T>
inline float to_float(T value) {
  if constexpr (encoding == Encoding::kHalf) return from_half(value);
  else if constexpr (encoding == Encoding::kFixed) return float(double(value) * 0x1p-16);
  else if constexpr (std::is_same_v<T, float>) return value;
  else if constexpr (std::is_same_v<T, double>) return from_double(value);
  else if constexpr (normalized) return from_normalized(value);
  else return float(value);
}

// 10F_11F_11F_REV: unsigned floats of 5 exponent bits.
inline float from_small_float(std::uint32_t bits_, int fraction_bits) {
  return from_half(std::uint16_t(bits_ << (10 - fraction_bits)));
}

// Components of a packed value. False: the driver will call `type` an invalid enum.
inline bool unpack(GLenum type, bool normalized, std::uint32_t value, Float4& out) {
  constexpr int kWidth[4] = {10, 10, 10, 2};
  switch (type) {
    case GL_UNSIGNED_INT_2_10_10_10_REV:
    case GL_INT_2_10_10_10_REV:
      for (int i = 0, shift = 0; i < 4; shift += kWidth[i++]) {
        const std::uint32_t steps = (1u << kWidth[i]) - 1;
        const std::uint32_t field = (value >> shift) & steps;
        if (type == GL_UNSIGNED_INT_2_10_10_10_REV) {
          out.at[i] = normalized ? float(field) / float(steps) : float(field);
        } else {
          const int number = int(field << (32 - kWidth[i])) >> (32 - kWidth[i]);
          out.at[i] = normalized ? float(2 * number + 1) / float(steps) : float(number);
        }
      }
      return true;
    case GL_UNSIGNED_INT_10F_11F_11F_REV:
      out = {{from_small_float(value & 0x7ffu, 6), from_small_float((value >> 11) & 0x7ffu, 6),
              from_small_float(value >> 22, 5), 1}};
      return true;
    default: return false;
  }
}

}  // namespace truequad
