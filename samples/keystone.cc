// A picture corner-pinned over the whole window, as projector programs do to undo a slanted projection: four
// points, dragged by the user, carry the picture's corners, and one quadrilateral is drawn.
#include <GL/gl.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <vector>

#include "common/picture.h"
#include "common/quads.h"
#include "common/sample.h"

namespace {

class Keystone : public samples::Sample {
 public:
  const char* name() const override { return "keystone"; }
  const char* description() const override { return "A picture corner-pinned over the whole window"; }
  void add_options(CLI::App& app) override {
    app.add_option("--picture", file_, "Picture to show")->check(CLI::ExistingFile);
    app.add_option("--pins", pins_,
                   "Where the lower left, lower right, upper right and upper left corner go, in fractions of "
                   "the window")
        ->type_name("X Y X Y X Y X Y")
        ->expected(8);
  }
  void prepare() override {
    texture_ = samples::make_texture(
        file_.empty() ? samples::sample_picture("building.jpg") : samples::read_picture(file_), GL_CLAMP);
  }

  void draw(int, int, int frame) override {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 1, 0, 1, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    // The hand of the user, who is still at it: the upper right pin moves around its place.
    const float angle = 0.1f * float(frame), reach = frame == 0 ? 0 : 0.04f;
    const std::array<samples::Vertex, 4> picture{
        {{{pins_[0], pins_[1], 0}, {0, 1}},
         {{pins_[2], pins_[3], 0}, {1, 1}},
         {{pins_[4] + reach * std::cos(angle), pins_[5] + reach * std::sin(angle), 0}, {1, 0}},
         {{pins_[6], pins_[7], 0}, {0, 0}}}};
    samples::draw_quads(GL_QUADS, picture);
  }

 private:
  std::string file_;
  std::vector<float> pins_{0.02f, 0.03f, 0.98f, 0.12f, 0.76f, 0.94f, 0.2f, 0.8f};
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Keystone sample;
  return samples::run(argc, argv, sample);
}
