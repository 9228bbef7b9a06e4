// A flight through a brick tunnel whose walls breathe: lit, fogged, a quad strip for each ring. Neighbouring rings
// differ in radius and turn, so hardly any quad is a parallelogram or even planar.
#include <cmath>
#include <numbers>
#include <vector>

#include "common/shapes.h"
#include "common/textures.h"

namespace {

using samples::Options;
using samples::Vertex;

class Tunnel : public samples::Sample {
 public:
  std::string about() const override { return "A flight through a tunnel with moving walls."; }

  void add_options(CLI::App& app) override {
    app.add_option("--sides", sides_, "of a ring (8)")->check(CLI::Range(3, 512));
    app.add_option("--rings", rings_, "that are drawn (14)")->check(CLI::Range(1, 4096));
  }

  void start(const Options& options) override { texture_ = samples::make_texture(samples::bricks(), options); }

  void draw(const Options& options) override {
    const double aspect = double(options.width) / options.height;
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.5 * aspect, 0.5 * aspect, -0.5, 0.5, 0.5, 100);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_DEPTH_TEST);
    if (!options.bare()) light_and_fog();
    glBindTexture(GL_TEXTURE_2D, texture_);

    // The eye flies forward; rings stand still, so which are in front of it changes with time.
    const float time_s = options.frame / 30.0f, travelled = 1.5f * time_s;
    const int nearest = int(std::floor(travelled / kStep));
    glTranslatef(0, 0, travelled);
    std::vector<Vertex> strip;
    for (int ring = nearest; ring < nearest + rings_; ++ring) {
      strip.clear();
      for (int side = 0; side <= sides_; ++side) {
        strip.push_back(wall(ring, side, time_s));
        strip.push_back(wall(ring + 1, side, time_s));
      }
      samples::draw_quad_strip(strip);
    }
  }

 private:
  static constexpr float kStep = 1.6f;

  static void light_and_fog() {
    // At the eye: set while the modelview matrix is still the identity.
    const GLfloat at_eye[] = {0, 0, 0, 1}, ambient[] = {0.25f, 0.25f, 0.3f, 1}, fog[] = {0.02f, 0.02f, 0.05f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, at_eye);
    glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glFogi(GL_FOG_MODE, GL_EXP2);
    glFogf(GL_FOG_DENSITY, 0.07f);
    glFogfv(GL_FOG_COLOR, fog);
    glEnable(GL_FOG);
  }

  Vertex wall(int ring, int side, float time_s) const {
    const float around = 2 * std::numbers::pi_v<float> * (side % sides_) / sides_;
    const float turn = 0.35f * std::sin(0.9f * ring + 0.7f * time_s);
    const float radius = 1.5f + 0.45f * std::sin(1.7f * ring + 2.1f * (side % sides_) + 1.3f * time_s);
    const float x = std::cos(around + turn), y = std::sin(around + turn);
    return {2.0f * side / sides_, float(ring) / 2, radius * x, radius * y, -kStep * ring, {-x, -y, 0}};
  }

  int sides_ = 8, rings_ = 14;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Tunnel sample;
  return samples::run(sample, argc, argv);
}
