#include "record.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "gl.h"

namespace truequad::semantics {
namespace {

std::FILE* file = nullptr;
bool written = true;

void write(const void* bytes, std::size_t size) {
  written = written && (size == 0 || std::fwrite(bytes, size, 1, file) == 1);
}

}  // namespace

void open_records(const char* path) {
  file = std::fopen(path, "wb");
  if (!file) {
    std::perror(path);
    std::exit(2);
  }
}

bool close_records() { return std::fclose(file) == 0 && written; }

void record(const std::string& name, const void* bytes, std::size_t size) {
  const std::uint32_t sizes[] = {std::uint32_t(name.size()), std::uint32_t(size)};
  write(sizes, sizeof sizes);
  write(name.data(), name.size());
  write(bytes, size);
}

void record_picture(const std::string& name) {
  std::vector<unsigned char> pixels(std::size_t(kWidth) * kHeight * 4);
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  record(name, pixels);
}

}  // namespace truequad::semantics
