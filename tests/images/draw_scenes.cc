// draw_scenes_API FAMILY FIRST COUNT WIDTH HEIGHT FILE: draws the scenes of COUNT seeds with immediate-mode
// OpenGL and writes the raw pictures. A program like any other, which knows nothing of truequad.
//
// Each scene is drawn kPasses times. In the first passes the texture holds at texel (i, j) the bytes (i, j),
// with the texture matrix scaling by 1, 16 and 256, so that pixels tell their texture coordinates to 16 bits;
// the blue byte is the quad's mark. The last pass adds one for each time that a pixel is touched.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "canvas.h"
#include "picture_file.h"
#include "scenes.h"

namespace truequad::images {
namespace {

constexpr int kTexels = 256;

GLuint make_texture(bool coordinates) {
  std::vector<unsigned char> texels;
  for (int j = 0; j < kTexels; ++j) {
    for (int i = 0; i < kTexels; ++i) {
      const unsigned char s = coordinates ? (unsigned char)(i) : 1, t = coordinates ? (unsigned char)(j) : 1;
      const unsigned char rest = coordinates ? 255 : 1;
      texels.insert(texels.end(), {s, t, rest, rest});
    }
  }
  GLuint name;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kTexels, kTexels, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  return name;
}

// The shortest call that says it, as programs have it.
void send(const Vertex& v) {
  glColor3f(1, 1, v.mark / 255.0f);
  const auto& t = v.texture;
  if (t[3] == 1) {
    glTexCoord2f(t[0], t[1]);
  } else {
    glTexCoord4fv(t.data());
  }
  const auto& p = v.position;
  if (p[3] != 1) {
    glVertex4fv(p.data());
  } else if (p[2] != 0) {
    glVertex3f(p[0], p[1], p[2]);
  } else {
    glVertex2f(p[0], p[1]);
  }
}

void send(const Primitive& primitive) {
  constexpr GLenum kModes[] = {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};
  glBegin(kModes[int(primitive.mode)]);
  for (const Vertex& v : primitive.vertices) send(v);
  glEnd();
}

void draw(const Scene& scene, int pass, GLuint coordinates, GLuint ones) {
  glViewport(scene.viewport[0], scene.viewport[1], scene.viewport[2], scene.viewport[3]);
  glClear(GL_COLOR_BUFFER_BIT);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(scene.projection.data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(scene.modelview.data());
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  const bool layers = pass == kLayersPass;
  if (!layers) glScalef(kPassScales[pass], kPassScales[pass], 1);
  glBindTexture(GL_TEXTURE_2D, layers ? ones : coordinates);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, layers ? GL_REPLACE : GL_MODULATE);
  if (layers) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
  } else {
    glDisable(GL_BLEND);
  }
  const bool strip = scene.primitives.front().mode == Mode::kQuadStrip;
  glShadeModel(strip ? GL_FLAT : GL_SMOOTH);
  scene.depth_clamped ? glEnable(GL_DEPTH_CLAMP) : glDisable(GL_DEPTH_CLAMP);
  for (const Primitive& primitive : scene.primitives) send(primitive);
}

int run(int count, char** arguments) {
  if (count != 7) {
    std::fprintf(stderr, "usage: %s FAMILY FIRST COUNT WIDTH HEIGHT FILE\n", arguments[0]);
    return 2;
  }
  const Family& scenes = family(arguments[1]);
  const unsigned first = unsigned(std::atoi(arguments[2])), seeds = unsigned(std::atoi(arguments[3]));
  const int width = std::atoi(arguments[4]), height = std::atoi(arguments[5]);
  std::FILE* file = std::fopen(arguments[6], "wb");
  if (!file || seeds < 1 || width < 16 || height < 16) {
    std::fprintf(stderr, "%s: cannot write %s, or bad numbers\n", arguments[0], arguments[6]);
    return 2;
  }
  open_canvas(width, height);
  const GLuint coordinates = make_texture(true), ones = make_texture(false);
  glEnable(GL_TEXTURE_2D);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  GLint subpixel_bits = 0;
  glGetIntegerv(GL_SUBPIXEL_BITS, &subpixel_bits);

  const PictureHeader header{width, height, int(seeds), subpixel_bits};
  bool written = std::fwrite(&header, sizeof header, 1, file) == 1;
  std::vector<unsigned char> pixels(picture_bytes(header));
  for (unsigned seed = first; seed < first + seeds; ++seed) {
    const Scene scene = scenes.make(seed, width, height);
    for (int pass = 0; pass < kPasses; ++pass) {
      draw(scene, pass, coordinates, ones);
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
