// A flight through a tunnel of quad strips whose lit, fogged walls move: the shape that many demos and screen
// savers of the nineties draw. Rings are pushed sideways and swell, so that hardly any quad is a
// parallelogram or planar.
#include <GL/gl.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/picture.h"
#include "common/quads.h"
#include "common/sample.h"
#include "common/view.h"

namespace {

using samples::Vertex;

constexpr int kRings = 24, kSegments = 12;
constexpr float kRingDistance = 0.8f;
constexpr float kTilesAround = 6;

class Tunnel : public samples::Sample {
 public:
  const char* name() const override { return "tunnel"; }
  const char* description() const override {
    return "A flight through a lit, fogged tunnel whose walls move";
  }
  void prepare() override { texture_ = samples::make_texture(samples::checkerboard(4, 32), GL_REPEAT); }

  void draw(int width, int height, int frame) override {
    samples::view_in_perspective(width, height, 75, 0.1, 40);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    light();
    const float flight = 0.05f * float(frame);
    std::vector<Vertex> strip;
    for (int ring = 0; ring < kRings; ++ring) {
      strip.clear();
      for (int segment = 0; segment <= kSegments; ++segment) {
        strip.push_back(wall(ring, segment, flight));
        strip.push_back(wall(ring + 1, segment, flight));
      }
      samples::draw_quads(GL_QUAD_STRIP, strip);
    }
    for (const GLenum effect : {GL_LIGHTING, GL_FOG, GL_DEPTH_TEST}) glDisable(effect);
  }

 private:
  static void light() {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    const float position[] = {0, 0.3f, -1, 1}, diffuse[] = {1, 0.95f, 0.85f, 1},
                ambient[] = {0.35f, 0.35f, 0.4f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
    glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
    const float white[] = {1, 1, 1, 1}, haze[] = {0.75f, 0.75f, 0.75f, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 4);
    glFogf(GL_FOG_END, kRings * kRingDistance);
    glFogfv(GL_FOG_COLOR, haze);
  }

  // A point of the wall. The walls stand still in the distance flown, so ring 0 is always just behind the
  // eye.
  static Vertex wall(int ring, int segment, float flight) {
    const float passed = std::floor(flight / kRingDistance);
    const float along = (float(ring) + passed) * kRingDistance;  // place in the tunnel
    const float around = 2 * std::numbers::pi_v<float> * float(segment % kSegments) / kSegments;
    const float radius = 1 + 0.2f * std::sin(1.1f * along + 3 * around) + 0.1f * std::sin(1.6f * along);
    const float x = 0.35f * std::sin(0.55f * along), y = 0.25f * std::cos(0.4f * along);
    const float eye_x = 0.35f * std::sin(0.55f * flight), eye_y = 0.25f * std::cos(0.4f * flight);
    return {{radius * std::cos(around) + x - eye_x, radius * std::sin(around) + y - eye_y, flight - along},
            {kTilesAround * float(segment) / kSegments, float(ring) + passed},
            {-std::cos(around), -std::sin(around), 0}};
  }

  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Tunnel sample;
  return samples::run(argc, argv, sample);
}
