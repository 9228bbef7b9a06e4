// What a drawing program leaves for the test: named records of bytes, one after another in a file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace truequad::semantics {

inline constexpr int kWidth = 160, kHeight = 120;  // of every picture

// Opens the file, or ends the process.
void open_records(const char* path);
// Whether all was written.
bool close_records();

void record(const std::string& name, const void* bytes, std::size_t size);
template <typename T>
void record(const std::string& name, const std::vector<T>& values) {
  record(name, values.data(), values.size() * sizeof(T));
}
// The colour buffer, RGBA, bottom row first.
void record_picture(const std::string& name);

}  // namespace truequad::semantics
