// Elements of every type that arrays may have, against values worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "capture/array_fetch.h"

namespace truequad {
namespace {

template <typename T>
Float4 of(GLenum type, std::initializer_list<T> numbers, bool normalized, bool bgra = false) {
  // Behind another element, at an odd address.
  constexpr std::size_t kStride = 37;
  unsigned char bytes[1 + 2 * kStride] = {};
  std::memcpy(bytes + 1 + kStride, numbers.begin(), numbers.size() * sizeof(T));
  const bool packed = type == GL_INT_2_10_10_10_REV || type == GL_UNSIGNED_INT_2_10_10_10_REV;
  return fetch({bytes + 1, kStride, 2, type, std::uint8_t(packed ? 4 : numbers.size()), normalized, bgra}, 1);
}

void expect(const Float4& value, float x, float y, float z, float w) {
  EXPECT_EQ(value.at[0], x);
  EXPECT_EQ(value.at[1], y);
  EXPECT_EQ(value.at[2], z);
  EXPECT_EQ(value.at[3], w);
}

TEST(Fetch, FillsUpWithDefaults) {
  expect(of<GLfloat>(GL_FLOAT, {0.25f}, false), 0.25f, 0, 0, 1);
  expect(of<GLfloat>(GL_FLOAT, {0.25f, 2}, false), 0.25f, 2, 0, 1);
  expect(of<GLfloat>(GL_FLOAT, {0.25f, 2, -3}, false), 0.25f, 2, -3, 1);
  expect(of<GLfloat>(GL_FLOAT, {0.25f, 2, -3, 0.5f}, false), 0.25f, 2, -3, 0.5f);
}

TEST(Fetch, TakesNumbersAsTheyAre) {
  expect(of<GLshort>(GL_SHORT, {-32768, 32767, 7, 0}, false), -32768, 32767, 7, 0);
  expect(of<GLint>(GL_INT, {-5, 1 << 24}, false), -5, 16777216, 0, 1);
  expect(of<GLbyte>(GL_BYTE, {-128, 127}, false), -128, 127, 0, 1);
  expect(of<GLdouble>(GL_DOUBLE, {0.1, -1e300}, false), 0.1f, -std::numeric_limits<float>::infinity(), 0, 1);
  expect(of<GLushort>(GL_HALF_FLOAT, {0x3c00, 0xc000, 0x3800, 0x7bff}, false), 1, -2, 0.5f, 65504);
  expect(of<GLint>(GL_FIXED, {0x18000, -0x8000}, false), 1.5f, -0.5f, 0, 1);
}

TEST(Fetch, Normalizes) {
  expect(of<GLubyte>(GL_UNSIGNED_BYTE, {0, 255, 51, 102}, true), 0, 1, 0.2f, 0.4f);
  expect(of<GLushort>(GL_UNSIGNED_SHORT, {65535, 13107, 0}, true), 1, 0.2f, 0, 1);
  expect(of<GLuint>(GL_UNSIGNED_INT, {4294967295u, 858993459u, 0}, true), 1, 0.2f, 0, 1);
  expect(of<GLbyte>(GL_BYTE, {127, -128, -127}, true), 1, -1, -1, 1);
  expect(of<GLshort>(GL_SHORT, {32767, -32768, 0}, true), 1, -1, 0, 1);
  expect(of<GLint>(GL_INT, {2147483647, -2147483647 - 1, 0}, true), 1, -1, 0, 1);
}

TEST(Fetch, UnpacksWordsAndTurnsBgraRound) {
  const GLuint word = 1023u | 0u << 10 | 341u << 20 | 2u << 30;
  expect(of<GLuint>(GL_UNSIGNED_INT_2_10_10_10_REV, {word}, false), 1023, 0, 341, 2);
  expect(of<GLuint>(GL_UNSIGNED_INT_2_10_10_10_REV, {word}, true), 1, 0, float(341 / 1023.0), float(2 / 3.0));
  const GLuint negative = 0x201u | 0x1ffu << 10 | 0u << 20 | 3u << 30;
  expect(of<GLuint>(GL_INT_2_10_10_10_REV, {negative}, false), -511, 511, 0, -1);
  expect(of<GLuint>(GL_INT_2_10_10_10_REV, {negative}, true), -1, 1, 0, -1);
  expect(of<GLubyte>(GL_UNSIGNED_BYTE, {0, 51, 255, 102}, true, true), 1, 0.2f, 0, 0.4f);
}

}  // namespace
}  // namespace truequad
