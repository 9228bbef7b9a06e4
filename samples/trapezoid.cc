// A checkerboard on a trapezoid, after figures 4 to 6 and 13 of Oliveira, "Correcting Texture Mapping Errors
// Introduced by Graphics Hardware" (SIBGRAPI 2001): which way the picture kinks depends on the vertex that is given
// first, and on the screen it matters less the smaller the trapezoid is.
#include <cmath>

#include "common/shapes.h"
#include "common/textures.h"

namespace {

using samples::Options;
using samples::Vertex;

// Areas of figure 13, square pixels.
constexpr double kAreas_px[] = {33600, 11879, 3051, 795, 197};

class Trapezoid : public samples::Sample {
 public:
  std::string about() const override { return "A checkerboard on a trapezoid."; }

  void add_options(CLI::App& app) override {
    app.add_option("--order", order_, "the vertices' order: abcd (from the lower left) or bcda (from the lower right)")
        ->check(CLI::IsMember({"abcd", "bcda"}));
    app.add_option("--area", area_px_, "area in square pixels (33600)")->check(CLI::Range(1.0, 1e8));
    app.add_option("--figure", figure_, "4: one trapezoid; 13: five, of the areas of the paper's figure")
        ->check(CLI::IsMember({4, 13}));
  }

  void start(const Options& options) override {
    texture_ = samples::make_texture(samples::checkerboard(8), options);
  }

  void draw(const Options& options) override {
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, options.width, 0, options.height, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glBindTexture(GL_TEXTURE_2D, texture_);
    if (figure_ == 4) {
      draw_one(area_px_, options.width / 2.0, options.height / 2.0);
      return;
    }
    double x = 20;
    for (double area_px : kAreas_px) {
      const double half = base(area_px) / 2;
      draw_one(area_px, x + half, options.height / 2.0);
      x += 2 * half + 16;
    }
  }

 private:
  // Base b, top b/2, height 3b/4: area 9/16 b^2.
  static double base(double area_px) { return std::sqrt(area_px * 16 / 9); }

  void draw_one(double area_px, double centre_x, double centre_y) const {
    const float b = float(base(area_px)), left = float(centre_x) - b / 2, bottom = float(centre_y) - b * 3 / 8;
    const Vertex corners[] = {{0, 0, left, bottom},
                              {1, 0, left + b, bottom},
                              {1, 1, left + b * 3 / 4, bottom + b * 3 / 4},
                              {0, 1, left + b / 4, bottom + b * 3 / 4}};
    const int first = order_ == "bcda";
    samples::draw_quads({corners[first], corners[first + 1], corners[(first + 2) % 4], corners[(first + 3) % 4]});
  }

  std::string order_ = "abcd";
  double area_px_ = kAreas_px[0];
  int figure_ = 4;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Trapezoid sample;
  return samples::run(sample, argc, argv);
}
