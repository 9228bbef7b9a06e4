#include "capture/array_fetch.h"

#include <utility>

namespace truequad {
namespace {

// Arrays are converted as GL 4.2 has it for all: max(c / (2^(b-1) - 1), -1). That is what drivers' vertex fetch does,
// whatever their glNormal3b does; so a corrected quad has the colours of its neighbours that pass.
template <typename T>
float normalized(T value) {
  if constexpr (std::is_signed_v<T>) {
    return std::max(float(double(value) / double(std::numeric_limits<T>::max())), -1.0f);
  } else {
    return from_normalized(value);
  }
}

template <Encoding encoding, typename T>
void convert(const ArraySource& source, const unsigned char* from, Float4& out) {
  for (unsigned i = 0; i < source.size; ++i) {
    T number;
    std::memcpy(&number, from + i * sizeof(T), sizeof(T));
    if constexpr (encoding == Encoding::kPlain && std::is_integral_v<T>) {
      out.at[i] = source.normalized ? normalized(number) : float(number);
    } else {
      out.at[i] = to_float<encoding, false>(number);
    }
  }
}

void convert_packed(const ArraySource& source, const unsigned char* from, Float4& out) {
  constexpr int kWidth[4] = {10, 10, 10, 2};
  GLuint bits_;
  std::memcpy(&bits_, from, sizeof bits_);
  Float4 all;
  unpack(source.type, source.normalized && source.type == GL_UNSIGNED_INT_2_10_10_10_REV, bits_, all);
  for (unsigned i = 0; i < source.size; ++i) {
    out.at[i] = all.at[i];
    if (source.normalized && source.type == GL_INT_2_10_10_10_REV) {
      out.at[i] = std::max(all.at[i] / float((1 << (kWidth[i] - 1)) - 1), -1.0f);
    }
  }
}

}  // namespace

Float4 fetch_converted(const ArraySource& source, std::uint64_t element) {
  Float4 value{{0, 0, 0, 1}};
  const unsigned char* const from = source.bytes + source.stride * element;
  switch (source.type) {
    case GL_BYTE: convert<Encoding::kPlain, GLbyte>(source, from, value); break;
    case GL_UNSIGNED_BYTE: convert<Encoding::kPlain, GLubyte>(source, from, value); break;
    case GL_SHORT: convert<Encoding::kPlain, GLshort>(source, from, value); break;
    case GL_UNSIGNED_SHORT: convert<Encoding::kPlain, GLushort>(source, from, value); break;
    case GL_INT: convert<Encoding::kPlain, GLint>(source, from, value); break;
    case GL_UNSIGNED_INT: convert<Encoding::kPlain, GLuint>(source, from, value); break;
    case GL_FLOAT: convert<Encoding::kPlain, GLfloat>(source, from, value); break;
    case GL_DOUBLE: convert<Encoding::kPlain, GLdouble>(source, from, value); break;
    case GL_HALF_FLOAT: convert<Encoding::kHalf, GLhalfNV>(source, from, value); break;
    case GL_FIXED: convert<Encoding::kFixed, GLfixed>(source, from, value); break;
    default: convert_packed(source, from, value); break;
  }
  if (source.bgra) std::swap(value.at[0], value.at[2]);
  return value;
}

}  // namespace truequad
