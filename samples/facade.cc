// The façade of a photograph on a rectangle: the situation of figures 1 to 3 of Oliveira, "Correcting Texture
// Mapping Errors Introduced by Graphics Hardware" (SIBGRAPI 2001). Figure 1 is the photograph with the
// façade's quadrilateral, 2 that quadrilateral on a rectangle, 3 a turned view of a house with two such
// walls.
#include <GL/gl.h>

#include <CLI/CLI.hpp>
#include <array>

#include "common/picture.h"
#include "common/quads.h"
#include "common/sample.h"
#include "common/view.h"

namespace {

using samples::Vertex;

// The photograph's size, and the corners of two storeys by six bays in it, in pixels from its upper left
// corner, counter- clockwise from the lower left: chosen by eye on ledges and window frames.
constexpr float kWidth_px = 868, kHeight_px = 600;
constexpr std::array<std::array<float, 2>, 4> kCorners_px{{{261, 415}, {797, 298}, {780, 47}, {261, 275}}};

std::array<float, 2> texture_at(std::array<float, 2> point_px) {
  return {point_px[0] / kWidth_px, point_px[1] / kHeight_px};
}

// A wall of the façade whose lower left, lower right, upper right and upper left corners are given.
std::array<Vertex, 4> wall(const std::array<std::array<float, 3>, 4>& corners) {
  std::array<Vertex, 4> vertices;
  for (std::size_t i = 0; i < 4; ++i) vertices[i] = {corners[i], texture_at(kCorners_px[i])};
  return vertices;
}

class Facade : public samples::Sample {
 public:
  const char* name() const override { return "facade"; }
  const char* description() const override {
    return "The facade of a photograph on a rectangle, and on a house";
  }
  void add_options(CLI::App& app) override {
    app.add_option("--figure", figure_,
                   "1: the photograph, 2: on a rectangle (default), 3: a house with two walls")
        ->check(CLI::Range(1, 3));
  }
  void prepare() override {
    texture_ = samples::make_texture(samples::sample_picture("building.jpg"), GL_CLAMP);
  }

  void draw(int width, int height, int frame) override {
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    if (figure_ == 1) {
      draw_photograph(width, height);
    } else if (figure_ == 2) {
      samples::view_in_pixels(width, height);
      samples::draw_quads(GL_QUADS, wall({{{-300, -180, 0}, {300, -180, 0}, {300, 180, 0}, {-300, 180, 0}}}));
    } else {
      draw_house(width, height, frame);
    }
  }

 private:
  void draw_photograph(int width, int height) {
    samples::view_in_pixels(width, height);
    const float scale = 600 / kWidth_px;
    glScalef(scale, -scale, 1);
    glTranslatef(-kWidth_px / 2, -kHeight_px / 2, 0);
    std::array<Vertex, 4> sheet;
    const std::array<std::array<float, 2>, 4> corners_px{
        {{0, kHeight_px}, {kWidth_px, kHeight_px}, {kWidth_px, 0}, {0, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
      sheet[i] = {{corners_px[i][0], corners_px[i][1], 0}, texture_at(corners_px[i])};
    }
    samples::draw_quads(GL_QUADS, sheet);
    glDisable(GL_TEXTURE_2D);
    glColor4f(1, 0.2f, 0, 0);  // in pictures of coordinates: no quad (common/quads.h)
    glLineWidth(2);
    glBegin(GL_LINE_LOOP);
    for (const auto& corner : kCorners_px) glVertex2fv(corner.data());
    glEnd();
    glColor3f(1, 1, 1);
  }

  void draw_house(int width, int height, int frame) {
    samples::view_in_perspective(width, height, 45, 0.5, 50);
    glEnable(GL_DEPTH_TEST);
    glTranslatef(0, 0, -8.5f);
    glRotatef(8, 1, 0, 0);
    glRotatef(-40 + 0.5f * float(frame), 0, 1, 0);
    const float w = 2.5f, h = 1.6f;
    glBindTexture(GL_TEXTURE_2D, texture_);
    samples::draw_quads(GL_QUADS, wall({{{-w, -h, w}, {w, -h, w}, {w, h, w}, {-w, h, w}}}));
    samples::draw_quads(GL_QUADS, wall({{{w, -h, w}, {w, -h, -w}, {w, h, -w}, {w, h, w}}}));
    glDisable(GL_DEPTH_TEST);
  }

  int figure_ = 2;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Facade sample;
  return samples::run(argc, argv, sample);
}
