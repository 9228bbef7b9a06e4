#include "attribute_grammar.h"

#include <array>
#include <regex>

namespace truequad::generate {
namespace {

struct Family {
  const char* name;
  const char* sizes;  // allowed size digits; empty: the name has none and the size is 1
  bool integers_normalized;
};

// GL 2.1 section 2.7; VertexAttrib forms: GL 4.6 compatibility section 10.2.1.
constexpr std::array kFamilies = {
    Family{"Vertex", "234", false},          Family{"TexCoord", "1234", false},
    Family{"MultiTexCoord", "1234", false},  Family{"Color", "34", true},
    Family{"SecondaryColor", "3", true},     Family{"Normal", "3", true},
    Family{"FogCoord", "", false},           Family{"Index", "", false},
    Family{"EdgeFlag", "", false},           Family{"Material", "", false},
    Family{"VertexAttrib", "1234", false},   Family{"VertexAttribI", "1234", false},
    Family{"VertexAttribL", "1234", false},
};

std::string type_of(const std::string& letters) {
  if (letters == "b") return "GLbyte";
  if (letters == "s") return "GLshort";
  if (letters == "i") return "GLint";
  if (letters == "f") return "GLfloat";
  if (letters == "d") return "GLdouble";
  if (letters == "ub") return "GLubyte";
  if (letters == "us") return "GLushort";
  if (letters == "ui") return "GLuint";
  if (letters == "h") return "GLhalfNV";
  if (letters == "x") return "GLfixed";
  if (letters == "i64") return "GLint64EXT";
  if (letters == "ui64") return "GLuint64EXT";
  return "";
}

std::string extension_of(const std::string& family, const std::string& letters, const std::string& suffix) {
  if (letters == "h") return "NV_half_float";
  if (letters == "x") return "OES_fixed_point";
  if (letters == "b" && suffix == "OES") return "OES_byte_coordinates";
  if (letters == "i64" || (letters == "ui64" && suffix == "NV")) return "NV_vertex_attrib_integer_64bit";
  if (letters == "ui64") return "ARB_bindless_texture";
  if (family == "VertexAttrib" && suffix == "NV") return "NV_vertex_program";
  return "Core";
}

}  // namespace

std::optional<AttributeCall> attribute_call(const std::string& name) {
  static const std::regex packed(
      "(Vertex|TexCoord|MultiTexCoord|Normal|Color|SecondaryColor|VertexAttrib)P([1-4])ui(v?)");
  static const std::regex edge_flag("EdgeFlag(v?)");
  static const std::regex plain(
      "(Vertex|TexCoord|MultiTexCoord|Color|SecondaryColor|Normal|FogCoord|Index|Material|VertexAttrib[IL]?)"
      "([1-4]?)(N?)(ub|us|ui64|ui|i64|[bsifdhx])(v?)(ARB|EXT|NV|OES)?");
  std::smatch match;
  if (std::regex_match(name, match, packed)) {
    const std::string family = match[1];
    const bool normalized = family == "Normal" || family == "Color" || family == "SecondaryColor";
    return AttributeCall{family == "VertexAttrib" ? "VertexAttribP" : family, match[2].str()[0] - '0', "Packed",
                         normalized, match[3].length() > 0, "Core"};
  }
  if (std::regex_match(name, match, edge_flag)) {
    return AttributeCall{"EdgeFlag", 1, "GLboolean", false, match[1].length() > 0, "Core"};
  }
  if (!std::regex_match(name, match, plain)) return std::nullopt;
  const std::string letters = match[4], suffix = match[6];
  for (const Family& family : kFamilies) {
    if (match[1] != family.name) continue;
    const bool sized = *family.sizes != '\0';
    if (sized != (match[2].length() > 0)) return std::nullopt;
    if (sized && std::string(family.sizes).find(match[2].str()) == std::string::npos) return std::nullopt;
    AttributeCall call;
    call.family = family.name;
    call.requires_ = extension_of(call.family, letters, suffix);
    if (call.family == "VertexAttrib" && suffix == "NV") call.family = "VertexAttribNV";
    call.size = sized ? match[2].str()[0] - '0' : call.family == "Material" ? 0 : 1;
    call.type = type_of(letters);
    const bool integer = letters.find_first_of("fdhx") == std::string::npos;
    // VertexAttrib4ubNV is normalised although its name has no N (NV_vertex_program, table "Vertex attributes").
    call.normalized = match[3].length() > 0 || (integer && family.integers_normalized) ||
                      (call.family == "VertexAttribNV" && letters == "ub");
    call.vector = match[5].length() > 0;
    return call;
  }
  return std::nullopt;
}

}  // namespace truequad::generate
