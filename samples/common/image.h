// Pictures in memory: RGBA, 8 bits a channel, the bottom row first as OpenGL has it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace samples {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  Image() = default;
  Image(int width, int height) : width(width), height(height), rgba(std::size_t(width) * height * 4) {}
  std::uint8_t* at(int x, int y) { return &rgba[(std::size_t(y) * width + x) * 4]; }
  const std::uint8_t* at(int x, int y) const { return &rgba[(std::size_t(y) * width + x) * 4]; }
};

// Both throw std::runtime_error that names the file.
Image load_image(const std::string& file);
void save_png(const std::string& file, const Image& image);

Image resized(const Image& image, int width, int height);

}  // namespace samples
