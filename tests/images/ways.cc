#include "ways.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace truequad::images {

int canvas_width, canvas_height;
OSMesaContext first_context, second_context;

namespace {

std::vector<unsigned char> canvas;

// Both contexts have the texture bound.
void make_texture() {
  constexpr int kTexels = 256;
  std::vector<unsigned char> texels;
  for (int j = 0; j < kTexels; ++j) {
    for (int i = 0; i < kTexels; ++i) {
      texels.insert(texels.end(), {(unsigned char)(i), (unsigned char)(j), (unsigned char)(i ^ j), 255});
    }
  }
  GLuint name;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kTexels, kTexels, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  make_current(second_context);
  glBindTexture(GL_TEXTURE_2D, name);
  make_current(first_context);
}

}  // namespace

void make_current(OSMesaContext context) {
  OSMesaMakeCurrent(context, canvas.data(), GL_UNSIGNED_BYTE, canvas_width, canvas_height);
}

GLenum mode_of(const Primitive& primitive) {
  constexpr GLenum kModes[] = {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};
  return kModes[int(primitive.mode)];
}

void look(const Scene& scene) {
  glViewport(scene.viewport[0], scene.viewport[1], scene.viewport[2], scene.viewport[3]);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(scene.projection.data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(scene.modelview.data());
  glShadeModel(scene.primitives.front().mode == Mode::kQuadStrip ? GL_FLAT : GL_SMOOTH);
  glEnable(GL_TEXTURE_2D);
}

int draw_in_a_way(const std::map<std::string, Way>& ways, int count, char** arguments) {
  const auto way = count == 7 ? ways.find(arguments[5]) : ways.end();
  if (way == ways.end()) {
    std::fprintf(stderr, "usage: %s FAMILIES COUNT WIDTH HEIGHT WAY FILE\n", arguments[0]);
    return 2;
  }
  const unsigned seeds = unsigned(std::atoi(arguments[2]));
  canvas_width = std::atoi(arguments[3]);
  canvas_height = std::atoi(arguments[4]);
  canvas.resize(std::size_t(canvas_width) * std::size_t(canvas_height) * 4);
  std::FILE* file = std::fopen(arguments[6], "wb");
  first_context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  second_context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, first_context);
  if (!file || !first_context || !second_context) return 70;
  make_current(first_context);
  make_texture();
  bool written = true;
  std::istringstream names(arguments[1]);
  for (std::string name; std::getline(names, name, ',');) {
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const Scene scene = family(name).make(seed, canvas_width, canvas_height);
      glClear(GL_COLOR_BUFFER_BIT);
      look(scene);
      way->second(scene);
      glFinish();
      written = written && std::fwrite(canvas.data(), canvas.size(), 1, file) == 1;
    }
  }
  for (OSMesaContext context : {second_context, first_context}) {
    make_current(context);
    if (const GLenum error = glGetError()) {
      std::fprintf(stderr, "%s: GL error 0x%x\n", arguments[0], error);
      return 1;
    }
  }
  return std::fclose(file) == 0 && written ? 0 : 1;
}

}  // namespace truequad::images
