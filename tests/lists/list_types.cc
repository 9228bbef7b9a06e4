// Names of lists of every type that glCallLists takes.
#include <cstdint>

#include "list_ways.h"

namespace truequad::images {
namespace {

// A name that needs two bytes.
constexpr GLuint kName = 1100;

// By an offset from `base`, which must fit into T.
template <typename T, GLenum kType, GLuint kBase>
void call_by_offset(const Scene& scene) {
  glNewList(kName, GL_COMPILE);
  primitives(scene);
  glEndList();
  // One that there is not, between two calls: each is drawn over the other.
  const T names[] = {T(std::int64_t(kName) - kBase), T(7), T(std::int64_t(kName) - kBase)};
  glListBase(kBase);
  glCallLists(3, kType, names);
  glListBase(0);
}

// OpenGL 2.1, 5.4: bytes of a name, the highest first.
template <unsigned kBytes>
void call_by_bytes(const Scene& scene) {
  constexpr GLenum kTypes[] = {GL_2_BYTES, GL_3_BYTES, GL_4_BYTES};
  glNewList(kName, GL_COMPILE);
  primitives(scene);
  glEndList();
  GLubyte names[2 * kBytes];
  for (unsigned i = 0; i < 2 * kBytes; ++i) names[i] = GLubyte((kName - 3) >> 8 * (kBytes - 1 - i % kBytes));
  glListBase(3);
  glCallLists(2, kTypes[kBytes - 2], names);
  glListBase(0);
}

}  // namespace

void add_types(std::map<std::string, Way>& ways) {
  ways["type_byte"] = call_by_offset<GLbyte, GL_BYTE, 1150>;
  ways["type_unsigned_byte"] = call_by_offset<GLubyte, GL_UNSIGNED_BYTE, 900>;
  ways["type_short"] = call_by_offset<GLshort, GL_SHORT, 31000>;
  ways["type_unsigned_short"] = call_by_offset<GLushort, GL_UNSIGNED_SHORT, 0>;
  ways["type_int"] = call_by_offset<GLint, GL_INT, 70000>;
  ways["type_unsigned_int"] = call_by_offset<GLuint, GL_UNSIGNED_INT, 1000>;
  ways["type_float"] = call_by_offset<GLfloat, GL_FLOAT, 2000>;
  ways["type_2_bytes"] = call_by_bytes<2>;
  ways["type_3_bytes"] = call_by_bytes<3>;
  ways["type_4_bytes"] = call_by_bytes<4>;
}

}  // namespace truequad::images
