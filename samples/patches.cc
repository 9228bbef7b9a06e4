// Quads of every kind on texture patches of every kind, after figures 12 and 14 to 16 of Oliveira, "Correcting Texture
// Mapping Errors Introduced by Graphics Hardware" (SIBGRAPI 2001).
#include <array>
#include <cmath>

#include "common/shapes.h"
#include "common/textures.h"

namespace {

using samples::Options;
using samples::Vertex;

class Patches : public samples::Sample {
 public:
  std::string about() const override { return "Quadrilaterals with quadrilateral patches of a texture."; }

  void add_options(CLI::App& app) override {
    app.add_option("--figure", figure_,
                   "12: any quad on any patch; 14: a square in perspective, one vertex dragged; 15: not planar; "
                   "16: quad and patch are affine copies")
        ->check(CLI::IsMember({12, 14, 15, 16}));
  }

  void start(const Options& options) override {
    texture_ = samples::make_texture(samples::checkerboard(10), options);
  }

  void draw(const Options& options) override {
    glBindTexture(GL_TEXTURE_2D, texture_);
    const float swing = std::sin(float(options.frame) / 15);
    const double aspect = double(options.width) / options.height;
    glMatrixMode(GL_PROJECTION);
    if (figure_ == 12 || figure_ == 16) {
      glOrtho(-aspect, aspect, -1, 1, -1, 1);
    } else {
      glFrustum(-0.4 * aspect, 0.4 * aspect, -0.4, 0.4, 1, 20);
    }
    glMatrixMode(GL_MODELVIEW);
    switch (figure_) {
      case 12: draw_arbitrary(swing); break;
      case 14: draw_dragged(swing); break;
      case 15: draw_bent(swing); break;
      default: draw_affine(swing); break;
    }
  }

 private:
  static void draw_arbitrary(float swing) {
    samples::draw_quads({{0.08f, 0.22f, -1.05f, -0.72f + 0.1f * swing},
                         {0.94f, 0.06f, 0.92f, -0.88f},
                         {0.70f, 0.88f, 1.08f, 0.46f},
                         {0.28f, 0.97f, -0.48f, 0.90f - 0.1f * swing}});
  }

  // In its own plane: what is seen is a planar quad that is no parallelogram.
  static void draw_dragged(float swing) {
    glTranslatef(0, 0.1f, -3.4f);
    glRotatef(-50, 1, 0, 0);
    glRotatef(12, 0, 0, 1);
    samples::draw_quads({{0, 0, -1, -1}, {1, 0, 1, -1}, {1, 1, 1.7f + 0.2f * swing, 1.9f}, {0, 1, -1, 1}});
  }

  static void draw_bent(float swing) {
    glTranslatef(0, 0, -3.6f);
    glRotatef(-38, 1, 0, 0);
    glRotatef(25, 0, 0, 1);
    const float bend = 0.55f + 0.2f * swing;
    samples::draw_quads({{0, 0, -1.1f, -1.1f, bend},
                         {1, 0, 1.1f, -1.1f, -bend},
                         {1, 1, 1.1f, 1.1f, bend},
                         {0, 1, -1.1f, 1.1f, -bend}});
  }

  // A trapezoid of texture on the same trapezoid, turned, sheared and scaled.
  static void draw_affine(float swing) {
    constexpr std::array<std::array<float, 2>, 4> patch{{{0.125f, 0.125f}, {0.875f, 0.125f}, {0.75f, 0.875f},
                                                          {0.375f, 0.875f}}};
    const float shear = 0.25f + 0.125f * swing;
    std::array<Vertex, 4> vertices;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [s, t] = patch[i];
      vertices[i] = {s, t, 2 * (s - 0.5f) + shear * (t - 0.5f), 2 * (t - 0.5f) - 0.25f * (s - 0.5f)};
    }
    samples::draw_quads(vertices);
  }

  int figure_ = 12;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Patches sample;
  return samples::run(sample, argc, argv);
}
