// A picture pinned to the window by its four corners, as slide shows and projector software do it against keystone
// distortion. Frames pull the corners to and fro.
#include <cmath>
#include <vector>

#include "common/shapes.h"
#include "common/textures.h"

namespace {

using samples::Options;
using samples::Vertex;

class Keystone : public samples::Sample {
 public:
  std::string about() const override { return "A picture pinned to the window by its four corners."; }

  void add_options(CLI::App& app) override {
    app.add_option("--corners", corners_,
                   "x y of the lower left, lower right, upper right, upper left corner, the window being 0 to 1")
        ->expected(8)
        ->check(CLI::Range(-10.0, 10.0));
    app.add_option("--picture", picture_, "an image file (building.jpg of the data)")->check(CLI::ExistingFile);
  }

  void start(const Options& options) override {
    texture_ = samples::make_texture(samples::load_image(picture_.empty() ? options.data + "/building.jpg" : picture_),
                                     options);
  }

  void draw(const Options& options) override {
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 1, 0, 1, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glBindTexture(GL_TEXTURE_2D, texture_);
    const float pull = 0.03f * std::sin(float(options.frame) / 20);
    samples::draw_quads({{0, 0, corners_[0] + pull, corners_[1]},
                         {1, 0, corners_[2], corners_[3] + pull},
                         {1, 1, corners_[4] - pull, corners_[5]},
                         {0, 1, corners_[6], corners_[7] - pull}});
  }

 private:
  std::vector<float> corners_{0.02f, 0.02f, 0.98f, 0.09f, 0.74f, 0.97f, 0.16f, 0.78f};
  std::string picture_;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Keystone sample;
  return samples::run(sample, argc, argv);
}
