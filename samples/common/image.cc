#include "common/image.h"

#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image.h>
#include <stb/stb_image_resize.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace samples {

Image load_image(const std::string& file) {
  int width = 0, height = 0, channels = 0;
  stbi_set_flip_vertically_on_load(1);
  stbi_uc* pixels = stbi_load(file.c_str(), &width, &height, &channels, 4);
  if (!pixels) throw std::runtime_error("cannot read " + file + ": " + stbi_failure_reason());
  Image image(width, height);
  image.rgba.assign(pixels, pixels + image.rgba.size());
  stbi_image_free(pixels);
  return image;
}

void save_png(const std::string& file, const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) rgb.insert(rgb.end(), image.at(x, y), image.at(x, y) + 3);
  }
  if (!stbi_write_png(file.c_str(), image.width, image.height, 3, rgb.data(), image.width * 3)) {
    throw std::runtime_error("cannot write " + file);
  }
}

Image resized(const Image& image, int width, int height) {
  Image result(width, height);
  if (!stbir_resize_uint8(image.rgba.data(), image.width, image.height, 0, result.rgba.data(), width, height,
                          0, 4)) {
    throw std::runtime_error("not enough memory to scale a picture");
  }
  return result;
}

}  // namespace samples
