// A checkerboard on a trapezoid: figures 4 to 6 of Oliveira, "Correcting Texture Mapping Errors Introduced by
// Graphics Hardware" (SIBGRAPI 2001), one for each order of the vertices, since that decides along which
// diagonal a driver cuts; and figure 13, the same at smaller and smaller projected areas (33,600 11,879 3,051
// 795 and 197 square pixels).
#include <GL/gl.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "common/picture.h"
#include "common/quads.h"
#include "common/sample.h"
#include "common/view.h"

namespace {

using samples::Vertex;

// Lower and upper side and height of the trapezoid, in units of its own.
constexpr float kLower = 2, kUpper = 0.8f, kHeight = 2;
constexpr float kArea = (kLower + kUpper) / 2 * kHeight;

class Trapezoid : public samples::Sample {
 public:
  const char* name() const override { return "trapezoid"; }
  const char* description() const override { return "A checkerboard on a trapezoid"; }
  void add_options(CLI::App& app) override {
    app.add_option("--order", first_,
                   "Vertex order: the quad begins at its lower left (abcd) or right (bcda) corner")
        ->transform(CLI::CheckedTransformer(std::map<std::string, int>{{"abcd", 0}, {"bcda", 1}}));
    app.add_option("--area", area_px_, "Projected area in square pixels at 640x480 (33600)")
        ->check(CLI::Range(1.0, 150000.0));
    app.add_option("--patch", slanted_, "Part of the texture: the whole square or a slanted quadrilateral")
        ->transform(
            CLI::CheckedTransformer(std::map<std::string, bool>{{"square", false}, {"slanted", true}}));
  }
  void prepare() override { texture_ = samples::make_texture(samples::checkerboard(8, 32), GL_REPEAT); }

  void draw(int width, int height, int frame) override {
    samples::view_in_pixels(width, height);
    glRotatef(0.5f * float(frame), 0, 0, 1);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const float scale = float(std::sqrt(area_px_ / kArea));
    glScalef(scale, scale, 1);
    std::array<Vertex, 4> vertices{{{{-kLower / 2, -kHeight / 2, 0}, {0, 0}},
                                    {{kLower / 2, -kHeight / 2, 0}, {1, 0}},
                                    {{kUpper / 2, kHeight / 2, 0}, {1, 1}},
                                    {{-kUpper / 2, kHeight / 2, 0}, {0, 1}}}};
    if (slanted_) {
      const std::array<std::array<float, 2>, 4> patch{{{0.125f, 0}, {1, 0.25f}, {0.75f, 1}, {0, 0.75f}}};
      for (std::size_t i = 0; i < 4; ++i) vertices[i].texture = patch[i];
    }
    std::rotate(vertices.begin(), vertices.begin() + first_, vertices.end());
    samples::draw_quads(GL_QUADS, vertices);
  }

 private:
  int first_ = 0;
  bool slanted_ = false;
  double area_px_ = 33600;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Trapezoid sample;
  return samples::run(argc, argv, sample);
}
