// Quadrilaterals of texture on quadrilaterals of every kind: figures 12 and 14 to 16 of Oliveira, "Correcting
// Texture Mapping Errors Introduced by Graphics Hardware" (SIBGRAPI 2001). 12: an arbitrary quad on an
// arbitrary patch; 14: a square in perspective one of whose vertices is dragged away in its plane; 15: a quad
// that is not planar; 16: a quad whose patch is its own affine copy, on which nothing is wrong.
#include <GL/gl.h>

#include <CLI/CLI.hpp>
#include <array>

#include "common/picture.h"
#include "common/quads.h"
#include "common/sample.h"
#include "common/view.h"

namespace {

using Quad = std::array<samples::Vertex, 4>;

constexpr Quad kArbitrary{{{{-230, -170, 0}, {0.1f, 0.25f}},
                           {{250, -120, 0}, {0.875f, 0}},
                           {{120, 180, 0}, {1, 0.75f}},
                           {{-170, 90, 0}, {0.25f, 1}}}};

constexpr Quad kDragged{
    {{{-1, -1, 0}, {0, 0}}, {{1, -1, 0}, {1, 0}}, {{0.35f, 0.45f, 0}, {1, 1}}, {{-1, 1, 0}, {0, 1}}}};

constexpr Quad kBent{
    {{{-1, -1, 0.5f}, {0, 0}}, {{1, -1, -0.5f}, {1, 0}}, {{1, 1, 0.6f}, {1, 1}}, {{-1, 1, -0.5f}, {0, 1}}}};

// Texture = position through one affine map, exact in binary: s = x / 512 + 0.5, t = y / 512 + 0.5.
constexpr Quad affine_copy() {
  Quad quad{{{{-224, -160, 0}, {}}, {{240, -128, 0}, {}}, {{96, 192, 0}, {}}, {{-160, 96, 0}, {}}}};
  for (samples::Vertex& v : quad) v.texture = {v.position[0] / 512 + 0.5f, v.position[1] / 512 + 0.5f};
  return quad;
}

class Patches : public samples::Sample {
 public:
  const char* name() const override { return "patches"; }
  const char* description() const override {
    return "Quadrilaterals of texture on quadrilaterals of every kind";
  }
  void add_options(CLI::App& app) override {
    app.add_option(
           "--figure", figure_,
           "12: arbitrary on arbitrary (default), 14: dragged vertex, 15: not planar, 16: affine copy")
        ->check(CLI::IsMember({12, 14, 15, 16}));
  }
  void prepare() override { texture_ = samples::make_texture(samples::checkerboard(8, 32), GL_REPEAT); }

  void draw(int width, int height, int frame) override {
    const bool flat = figure_ == 12 || figure_ == 16;
    if (flat) {
      samples::view_in_pixels(width, height);
      glRotatef(0.5f * float(frame), 0, 0, 1);
    } else {
      samples::view_in_perspective(width, height, 40, 0.1, 20);
      glTranslatef(figure_ == 14 ? -0.15f : 0, 0, -3.8f);
      glRotatef(figure_ == 14 ? -50 : -20, 1, 0, 0);
      glRotatef((figure_ == 14 ? 20 : 35) + 0.5f * float(frame), 0, figure_ == 14 ? 0 : 1,
                figure_ == 14 ? 1 : 0);
    }
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    samples::draw_quads(GL_QUADS, figure_ == 12   ? kArbitrary
                                  : figure_ == 14 ? kDragged
                                  : figure_ == 15 ? kBent
                                                  : affine_copy());
  }

 private:
  int figure_ = 12;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Patches sample;
  return samples::run(argc, argv, sample);
}
