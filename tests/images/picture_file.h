// The file between a drawing program and the test: a header, then for each seed kPasses pictures, RGBA,
// bottom row first.
#pragma once

#include <cstddef>

namespace truequad::images {

struct PictureHeader {
  int width, height, seeds, subpixel_bits;
};

// Each pass tells the coordinates to 8 bits modulo 1 / scale; four bits of each are known from the pass
// before it.
inline constexpr float kPassScales[] = {1, 16, 256};
inline constexpr int kLayersPass = 3;
inline constexpr int kPasses = 4;

constexpr std::size_t picture_bytes(const PictureHeader& header) {
  return std::size_t(header.width) * std::size_t(header.height) * 4;
}

}  // namespace truequad::images
