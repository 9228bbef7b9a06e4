#include "common/picture.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
#include <stb/stb_image_resize.h>
#pragma GCC diagnostic pop

namespace samples {
namespace {

Picture resized(const Picture& picture, int width, int height) {
  Picture result{width, height, std::vector<unsigned char>(std::size_t(width) * std::size_t(height) * 4)};
  if (stbir_resize_uint8(picture.pixels.data(), picture.width, picture.height, 0, result.pixels.data(), width,
                         height, 0, 4) == 0) {
    throw std::runtime_error("not enough memory to scale a picture");
  }
  return result;
}

}  // namespace

Picture read_picture(const std::string& file) {
  int width = 0, height = 0, channels = 0;
  unsigned char* const pixels = stbi_load(file.c_str(), &width, &height, &channels, 4);
  if (pixels == nullptr) throw std::runtime_error("cannot read " + file + ": " + stbi_failure_reason());
  Picture picture{width, height, {pixels, pixels + std::size_t(width) * std::size_t(height) * 4}};
  stbi_image_free(pixels);
  return picture;
}

void write_png(const Picture& picture, const std::string& file, bool keep_alpha) {
  Picture copy = picture;
  if (!keep_alpha) {
    for (std::size_t i = 3; i < copy.pixels.size(); i += 4) copy.pixels[i] = 255;
  }
  if (stbi_write_png(file.c_str(), copy.width, copy.height, 4, copy.pixels.data(), copy.width * 4) == 0) {
    throw std::runtime_error("cannot write " + file);
  }
}

Picture checkerboard(int squares, int size_px) {
  const int size = squares * size_px;
  Picture picture{size, size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const bool dark = (x / size_px + y / size_px) % 2 == 0;
      const bool corner = x < size_px && y < size_px;
      const unsigned char colour[] = {corner ? (unsigned char)200
                                      : dark ? (unsigned char)30
                                             : (unsigned char)245,
                                      dark ? (unsigned char)40 : (unsigned char)240,
                                      dark ? (unsigned char)(corner ? 40 : 110) : (unsigned char)225, 255};
      picture.pixels.insert(picture.pixels.end(), colour, colour + 4);
    }
  }
  return picture;
}

GLuint make_texture(const Picture& picture, GLint wrap) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const auto power_of_two = [largest](int size) {
    return std::min(int(std::bit_ceil(unsigned(size))), int(largest));
  };
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  Picture level = resized(picture, power_of_two(picture.width), power_of_two(picture.height));
  for (GLint n = 0;; ++n) {
    glTexImage2D(GL_TEXTURE_2D, n, GL_RGBA, level.width, level.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 level.pixels.data());
    if (level.width == 1 && level.height == 1) return texture;
    level = resized(level, std::max(level.width / 2, 1), std::max(level.height / 2, 1));
  }
}

Picture sample_picture(const std::string& name) { return read_picture(SAMPLES_DATA "/" + name); }

}  // namespace samples
