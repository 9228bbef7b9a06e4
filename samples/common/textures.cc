#include "common/textures.h"

#include <algorithm>
#include <bit>

namespace samples {
namespace {

constexpr int kSide = 512;

void put(std::uint8_t* texel, int red, int green, int blue) {
  texel[0] = std::uint8_t(red);
  texel[1] = std::uint8_t(green);
  texel[2] = std::uint8_t(blue);
  texel[3] = 255;
}

// Eight bits of s in red and of t in green. Nearest texel: a digit must not be mixed with its neighbour.
Image coordinates() {
  Image image(256, 256);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) put(image.at(x, y), x, y, 255);
  }
  return image;
}

void upload(int level, const Image& image) {
  glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.rgba.data());
}

}  // namespace

Image checkerboard(int squares) {
  Image image(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int column = x * squares / kSide, row = y * squares / kSide;
      if (column == 0 && row == 0) {
        put(image.at(x, y), 208, 48, 40);
      } else if ((column + row) % 2 == 0) {
        put(image.at(x, y), 28, 40, 72);
      } else {
        put(image.at(x, y), 236, 232, 216);
      }
    }
  }
  return image;
}

Image bricks() {
  constexpr int kRows = 8, kColumns = 4, kMortar = 5;
  constexpr int kHeight = kSide / kRows, kWidth = kSide / kColumns;
  Image image(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    const int row = y / kHeight;
    for (int x = 0; x < kSide; ++x) {
      const int shifted = (x + row % 2 * kWidth / 2) % kSide, brick = shifted / kWidth;
      const bool mortar = y % kHeight < kMortar || shifted % kWidth < kMortar;
      const int tone = (brick * 37 + row * 61) % 40;
      if (mortar) {
        put(image.at(x, y), 225, 220, 208);
      } else {
        put(image.at(x, y), 150 + tone, 70 + tone / 2, 50 + tone / 3);
      }
    }
  }
  return image;
}

GLuint make_texture(const Image& image, const Options& options) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  if (options.bare()) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    upload(0, coordinates());
    return name;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  Image level = resized(image, std::bit_ceil(unsigned(image.width)), std::bit_ceil(unsigned(image.height)));
  for (int number = 0;; ++number) {
    upload(number, level);
    if (level.width == 1 && level.height == 1) return name;
    level = resized(level, std::max(level.width / 2, 1), std::max(level.height / 2, 1));
  }
}

}  // namespace samples
