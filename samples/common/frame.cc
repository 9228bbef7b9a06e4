#include "common/frame.h"

#include <GL/gl.h>

#include <algorithm>
#include <cstdio>

#include "common/image.h"
#include "common/shapes.h"

namespace samples {

void Frames::start() { sample_.start(options_); }

void Frames::draw(int width, int height) {
  Options now = options_;
  now.width = width;
  now.height = height;
  now.frame += int(times_ms_.size());
  if (!now.quads.empty()) list_quads();

  const auto begin = std::chrono::steady_clock::now();
  glViewport(0, 0, width, height);
  // Black where coordinates are drawn: a pixel without blue was not covered.
  const std::array<float, 3> background = now.bare() ? std::array{0.0f, 0.0f, 0.0f} : sample_.background();
  glClearColor(background[0], background[1], background[2], 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  // A power of two, so that both pictures of the coordinates come from the same bits.
  if (now.texture == TextureKind::kFineCoordinates) glScalef(256, 256, 1);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, now.bare() ? GL_REPLACE : GL_MODULATE);
  glColor3f(1, 1, 1);
  sample_.draw(now);
  glFinish();
  times_ms_.push_back(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
}

void Frames::write() const {
  if (!options_.out.empty()) {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    Image image(viewport[2], viewport[3]);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    save_png(options_.out, image);
  }
  if (!options_.quads.empty()) write_quads(options_.quads);
  if (options_.time) {
    std::vector<double> sorted = times_ms_;
    std::sort(sorted.begin(), sorted.end());
    std::fprintf(stderr, "%.4f ms per frame\n", sorted[sorted.size() / 2]);
  }
}

}  // namespace samples
