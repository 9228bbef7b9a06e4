// The one list of entry points that set a vertex or an attribute (attribute_calls.inc, made from the Khronos registry
// at build time), as values that templates can take.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "driver/driver.h"

namespace truequad {

enum class Family : std::uint8_t {
  Vertex, TexCoord, MultiTexCoord, Color, SecondaryColor, Normal, FogCoord, Index, EdgeFlag, Material,
  VertexAttrib, VertexAttribI, VertexAttribL, VertexAttribP, VertexAttribNV,
};

// How the numbers of a call are kept. Half and fixed are integers to the C++ type system.
enum class Encoding : std::uint8_t { kPlain, kHalf, kFixed, kPacked };

using RowId = std::uint16_t;

struct Row {
  RowId id;
  Family family;
  std::uint8_t size;  // components; 0: as the parameter name says (glMaterial)
  Encoding encoding;
  bool normalized;
  bool vector;
  std::int8_t extension;  // index in kExtensions, or -1: every driver has it
};

namespace rows {

constexpr Encoding encoding_of(std::string_view type) {
  if (type == "GLhalfNV") return Encoding::kHalf;
  if (type == "GLfixed") return Encoding::kFixed;
  if (type == "Packed") return Encoding::kPacked;
  return Encoding::kPlain;
}

inline constexpr std::string_view kRequired[] = {
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_) #requires_,
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
};

struct Extensions {
  std::array<std::string_view, 32> name{};
  std::size_t count = 0;
};
constexpr Extensions find_extensions() {
  Extensions found;
  for (std::string_view name : kRequired) {
    bool known = name == "Core";
    for (std::size_t i = 0; i < found.count; ++i) known |= found.name[i] == name;
    if (!known) found.name[found.count++] = name;
  }
  return found;
}

}  // namespace rows

// Extensions without which a driver lacks some of the entry points, without "GL_".
inline constexpr rows::Extensions kExtensions = rows::find_extensions();

constexpr std::int8_t extension_index(std::string_view name) {
  for (std::size_t i = 0; i < kExtensions.count; ++i) {
    if (kExtensions.name[i] == name) return std::int8_t(i);
  }
  return -1;
}

// kRowVertex3f …: position in the list.
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_) kRow##Name,
enum : RowId {
#include "attribute_calls.inc"
  kRowCount
};
#undef TQ_ATTRIBUTE

inline constexpr Row kRows[] = {
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_)                                       \
  Row{kRow##Name, Family::family, size, rows::encoding_of(#type), (normalized) != 0, (vector) != 0,                 \
      extension_index(#requires_)},
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
};

}  // namespace truequad
