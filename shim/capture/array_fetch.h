// The value of an array's element, as the driver converts it (GL 2.1 section 2.8, GL 4.6 compatibility section 10.3.6).
#pragma once

#include <cstring>

#include "capture/array_state.h"
#include "capture/values.h"

namespace truequad {

// An array at its place in memory.
struct ArraySource {
  const unsigned char* bytes;
  std::size_t stride;
  std::uint64_t elements;  // that lie inside of its buffer; client memory has no end that we could know
  GLenum type;
  std::uint8_t size;
  bool normalized, bgra;

  bool floats() const { return type == GL_FLOAT; }
};

// Of any type.
Float4 fetch_converted(const ArraySource& source, std::uint64_t element);

inline Float4 fetch(const ArraySource& source, std::uint64_t element) {
  if (!source.floats()) return fetch_converted(source, element);
  Float4 value{{0, 0, 0, 1}};
  const unsigned char* const from = source.bytes + source.stride * element;
  switch (source.size) {
    case 2: std::memcpy(value.at, from, 2 * sizeof(float)); break;
    case 3: std::memcpy(value.at, from, 3 * sizeof(float)); break;
    case 4: std::memcpy(value.at, from, 4 * sizeof(float)); break;
    default: std::memcpy(value.at, from, sizeof(float));
  }
  return value;
}

}  // namespace truequad
