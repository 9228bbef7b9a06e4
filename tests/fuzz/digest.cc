// All that OpenGL can be asked at a point of a sequence: every number that glGet knows, every enable, and what has queries
// of its own.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "execute.h"

namespace truequad::fuzz {

bool verbose = false;

namespace {

struct Named {
  const char* name;
  GLenum value;
};

std::uint64_t digest;

void mix(const void* bytes, std::size_t size) {
  const auto* at = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < size; ++i) digest = (digest ^ at[i]) * 0x100000001b3u;
}

// Answers that are unlike the sentinel that was there before.
constexpr double kUntouched = -123456789;
constexpr int kMost = 64;

template <typename F>
void answer(const char* query, unsigned name, F f) {
  static double values[kMost];
  std::fill(std::begin(values), std::end(values), kUntouched);
  f(values);
  int count = kMost;
  while (count > 0 && values[count - 1] == kUntouched) --count;
  if (count == 0) return;
  if (!verbose) {
    mix(&name, sizeof name);
    return mix(values, std::size_t(count) * sizeof *values);
  }
  std::string line;
  char text[40];
  for (int i = 0; i < std::min(count, 16); ++i) {
    std::snprintf(text, sizeof text, " %.9g", values[i]);
    line += text;
  }
  record("%s %x:%s", query, name, line.c_str());
}

template <typename T, typename F>
void answer_as(const char* query, unsigned name, F f) {
  answer(query, name, [&](double* values) {
    T own[kMost];
    std::fill(std::begin(own), std::end(own), T(kUntouched));
    f(own);
    for (int i = 0; i < kMost; ++i) {
      if (own[i] != T(kUntouched)) values[i] = double(own[i]);
    }
  });
}

// Every value that has a name, once; those only whose answer tells of this process rather than of the state are left out.
const std::vector<GLenum>& all_names() {
  static const std::vector<GLenum> names = [] {
    std::vector<GLenum> all;
    for (GLenum name = 0x0b00; name < 0x0e00; ++name) all.push_back(name);   // OpenGL 1.0
    for (GLenum name = 0x1400; name < 0x2a11; ++name) {
      if (name >= 0x1700 && name < 0x2a00 && (name & 0xff00) != 0x2800) continue;
      all.push_back(name);
    }
    for (GLenum name = 0x8000; name < 0x9400; ++name) all.push_back(name);
    return all;
  }();
  return names;
}

bool left_out(GLenum name) {
  switch (name) {
    case 0x8e28:                                      // GL_TIMESTAMP
    case 0x9047: case 0x9048: case 0x9049: case 0x904a: case 0x904b:  // NVX_gpu_memory_info
    case 0x87fb: case 0x87fc: case 0x87fd:            // ATI_meminfo
    case 0x87fe: case 0x87ff: case 0x8741: case 0x86a2: case 0x86a3:  // lists of formats, as long as there are
    case 0x9270: case 0x8df8: case 0x8df9: case 0x9553:
      return true;
    default: return false;
  }
}

// Which names have answers, and which can be asked for as enables, is the context's: found once.
const std::vector<GLenum>& names_with(bool enables) {
  static std::vector<GLenum> known[2];
  static bool found = false;
  if (!found) {
    found = true;
    for (GLenum name : all_names()) {
      if (left_out(name)) continue;
      GLdouble values[4096];
      gl.GetError();
      gl.GetDoublev(name, values);
      if (gl.GetError() == GL_NO_ERROR) known[0].push_back(name);
      gl.IsEnabled(name);
      if (gl.GetError() == GL_NO_ERROR) known[1].push_back(name);
    }
  }
  return known[enables];
}

void numbers() {
  for (GLenum name : names_with(false)) answer("get", name, [&](double* values) { gl.GetDoublev(name, values); });
  for (GLenum name : names_with(true)) {
    answer("enabled", name, [&](double* values) { values[0] = gl.IsEnabled(name); });
  }
}

void lights_and_materials() {
  for (GLenum face : {GL_FRONT, GL_BACK}) {
    for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES}) {
      answer_as<GLfloat>("material", face << 16 | name, [&](GLfloat* values) { gl.GetMaterialfv(face, name, values); });
    }
  }
  for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_CUTOFF, GL_LINEAR_ATTENUATION}) {
    for (GLenum light : {GL_LIGHT0, GL_LIGHT1}) {
      answer_as<GLfloat>("light", light << 16 | name, [&](GLfloat* values) { gl.GetLightfv(light, name, values); });
    }
  }
}

void textures() {
  GLint active = 0, client = 0;
  gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  gl.GetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &client);
  for (int unit = 0; unit < kUnits; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + GLuint(unit));
    gl.ClientActiveTexture(GL_TEXTURE0 + GLuint(unit));
    for (GLenum name : {GL_CURRENT_TEXTURE_COORDS, GL_TEXTURE_MATRIX, GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T,
                        GL_TEXTURE_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY_SIZE, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING}) {
      answer("unit", GLenum(unit) << 16 | name, [&](double* values) { gl.GetDoublev(name, values); });
    }
    answer_as<GLint>("environment", GLenum(unit), [&](GLint* values) { gl.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, values); });
    for (GLenum name : {GL_S, GL_T, GL_R, GL_Q}) {
      answer_as<GLint>("generation", GLenum(unit) << 16 | name, [&](GLint* values) { gl.GetTexGeniv(name, GL_TEXTURE_GEN_MODE, values); });
      answer("plane", GLenum(unit) << 16 | name, [&](double* values) { gl.GetTexGendv(name, GL_EYE_PLANE, values); });
    }
  }
  gl.ActiveTexture(GLenum(active));
  gl.ClientActiveTexture(GLenum(client));
}

void arrays() {
  for (GLenum name : {GL_VERTEX_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER,
                      GL_EDGE_FLAG_ARRAY_POINTER, GL_SECONDARY_COLOR_ARRAY_POINTER, GL_FOG_COORD_ARRAY_POINTER}) {
    void* pointer = nullptr;
    gl.GetPointerv(name, &pointer);
    answer("pointer", name, [&](double* values) { values[0] = double(place_of(pointer)); });
  }
  for (GLuint attribute = 0; attribute < 16; ++attribute) {
    for (GLenum name : {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
                        GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_CURRENT_VERTEX_ATTRIB}) {
      if (attribute == 0 && name == GL_CURRENT_VERTEX_ATTRIB) continue;
      answer("attribute", attribute << 16 | name, [&](double* values) { gl.GetVertexAttribdv(attribute, name, values); });
    }
  }
  for (GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER}) {
    answer_as<GLint>("buffer size", target, [&](GLint* values) { gl.GetBufferParameteriv(target, GL_BUFFER_SIZE, values); });
    answer_as<GLint>("buffer mapped", target, [&](GLint* values) { gl.GetBufferParameteriv(target, GL_BUFFER_MAPPED, values); });
  }
}

void lists_and_buffers() {
  for (GLuint name = 0; name < 24; ++name) {
    answer("list", name, [&](double* values) { values[0] = gl.IsList(name); });
  }
  for (const float& x : feedback_buffer) {
    if (x != 0) answer("feedback", unsigned(&x - feedback_buffer), [&](double* values) { values[0] = x; });
  }
  for (const GLuint& x : selection_buffer) {
    if (x != 0) answer("selection", unsigned(&x - selection_buffer), [&](double* values) { values[0] = x; });
  }
}

}  // namespace

void find_names() { names_with(false); }

void record_state() {
  digest = 0xcbf29ce484222325u;
  print_note("everything is asked");
  record_errors();
  numbers();
  lights_and_materials();
  textures();
  arrays();
  lists_and_buffers();
  if (!verbose) record("state %016llx", static_cast<unsigned long long>(digest));
  record_errors();
}

}  // namespace truequad::fuzz
