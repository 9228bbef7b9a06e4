// draw_colours_API [passes:]FAMILY FIRST COUNT WIDTH HEIGHT FILE: draws the scenes of COUNT seeds, a colour at each vertex, and
// writes the raw pictures: one for each ColourKind. With `passes:` the colours are a second pass by GL_EQUAL over the same
// vertices without them, and the picture is that of the second frame. A program like any other, which knows nothing of truequad.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "canvas.h"
#include "corner_colours.h"
#include "picture_file.h"
#include "scenes.h"

namespace truequad::images {
namespace {

static_assert(kColourKinds == kPasses);

void give(ColourKind kind, const std::array<float, 4>& colour) {
  switch (kind) {
    case kPrimary: return glColor4fv(colour.data());
    case kSecondary: return glSecondaryColor3fv(colour.data());
    case kFog: return glFogCoordf(colour[0]);
    default: return glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, colour.data());
  }
}

void enable(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

void send(const Scene& scene, unsigned seed, ColourKind kind, bool coloured) {
  // Textured in one half of the pictures, with coordinates that need correction too.
  const bool textured = coloured && kind >= kFog;
  enable(GL_COLOR_SUM, coloured && kind == kSecondary);
  enable(GL_FOG, coloured && kind == kFog);
  enable(GL_LIGHTING, coloured && kind == kEmission);
  enable(GL_TEXTURE_2D, textured);
  glColor4f(0, 0, 0, 1);
  for (unsigned p = 0; p < scene.primitives.size(); ++p) {
    constexpr GLenum kModes[] = {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};
    const Primitive& primitive = scene.primitives[p];
    glBegin(kModes[int(primitive.mode)]);
    for (unsigned i = 0; i < primitive.vertices.size(); ++i) {
      const Vertex& v = primitive.vertices[i];
      if (coloured) give(kind, vertex_colour(seed, p, i));
      if (textured) glTexCoord2fv(v.texture.data());
      glVertex4fv(v.position.data());
    }
    glEnd();
  }
}

void draw(const Scene& scene, unsigned seed, ColourKind kind, bool passes) {
  glViewport(scene.viewport[0], scene.viewport[1], scene.viewport[2], scene.viewport[3]);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(scene.projection.data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(scene.modelview.data());
  for (int frame = 0; frame < (passes ? 2 : 1); ++frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    enable(GL_DEPTH_TEST, passes);
    if (passes) {
      glDepthFunc(GL_LESS);
      glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
      send(scene, seed, kind, false);
      glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      glDepthFunc(GL_EQUAL);
    }
    send(scene, seed, kind, true);
  }
}

int run(int count, char** arguments) {
  if (count != 7) {
    std::fprintf(stderr, "usage: %s [passes:]FAMILY FIRST COUNT WIDTH HEIGHT FILE\n", arguments[0]);
    return 2;
  }
  std::string_view name = arguments[1];
  constexpr std::string_view kSecondPasses = "passes:";
  const bool passes = name.starts_with(kSecondPasses);
  if (passes) name.remove_prefix(kSecondPasses.size());
  const Family& scenes = family(name);
  const unsigned first = unsigned(std::atoi(arguments[2])), seeds = unsigned(std::atoi(arguments[3]));
  const int width = std::atoi(arguments[4]), height = std::atoi(arguments[5]);
  std::FILE* file = std::fopen(arguments[6], "wb");
  if (!file || seeds < 1 || width < 16 || height < 16) {
    std::fprintf(stderr, "%s: cannot write %s, or bad numbers\n", arguments[0], arguments[6]);
    return 2;
  }
  open_canvas(width, height);
  const GLubyte white[4] = {255, 255, 255, 255};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glDisable(GL_DITHER);
  // Black under white fog, whose coordinate is its density; and lit by nothing.
  const GLfloat ones[4] = {1, 1, 1, 1}, black[4] = {0, 0, 0, 1};
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glFogfv(GL_FOG_COLOR, ones);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  GLint subpixel_bits = 0;
  glGetIntegerv(GL_SUBPIXEL_BITS, &subpixel_bits);

  const PictureHeader header{width, height, int(seeds), subpixel_bits};
  bool written = std::fwrite(&header, sizeof header, 1, file) == 1;
  std::vector<unsigned char> pixels(picture_bytes(header));
  for (unsigned seed = first; seed < first + seeds; ++seed) {
    for (int kind = 0; kind < kColourKinds; ++kind) {
      const Scene scene = scenes.make(scene_seed(seed, ColourKind(kind), passes), width, height);
      draw(scene, seed, ColourKind(kind), passes);
      glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
      written = written && std::fwrite(pixels.data(), pixels.size(), 1, file) == 1;
    }
  }
  if (const GLenum error = glGetError()) {
    std::fprintf(stderr, "%s: GL error 0x%x\n", arguments[0], error);
    return 1;
  }
  return std::fclose(file) == 0 && written ? 0 : 1;
}

}  // namespace
}  // namespace truequad::images

int main(int count, char** arguments) { return truequad::images::run(count, arguments); }
