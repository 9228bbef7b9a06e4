// A wall taken from a photograph, after figures 1 to 3 of Oliveira, "Correcting Texture Mapping Errors Introduced by
// Graphics Hardware" (SIBGRAPI 2001): the texture patch is the wall as the camera saw it, a quadrilateral; the polygon
// is the wall as it was built, a rectangle.
#include <array>

#include "common/shapes.h"
#include "common/textures.h"

namespace {

using samples::Options;
using samples::Vertex;

// A place in building.jpg, pixels from the upper left, and the texture coordinates that belong to it.
struct Place {
  float x, y;
  float s() const { return x / 868; }
  float t() const { return 1 - y / 600; }
};

// Four corners in the photograph: lower left, lower right, upper right, upper left.
using Patch = std::array<Place, 4>;

// Three storeys between two ledges. The whole width of the façade, eight bays, and the same in two parts: five bays
// left of a joint and three right of it.
constexpr Place kLowerLeft{194, 421}, kLowerRight{648, 330}, kUpperRight{648, 3}, kUpperLeft{194, 243};
constexpr Place kLowerJoint{407, 377}, kUpperJoint{407, 131};
constexpr Patch kWall{kLowerLeft, kLowerRight, kUpperRight, kUpperLeft};
constexpr Patch kLeftWall{kLowerLeft, kLowerJoint, kUpperJoint, kUpperLeft};
constexpr Patch kRightWall{kLowerJoint, kLowerRight, kUpperRight, kUpperJoint};

class Facade : public samples::Sample {
 public:
  std::string about() const override { return "A wall from a photograph, mapped on a rectangle."; }

  void add_options(CLI::App& app) override {
    app.add_option("--figure", figure_, "1: two walls; 2: the photograph and the patch; 3: the wall, seen from the front")
        ->check(CLI::IsMember({1, 2, 3}));
  }

  void start(const Options& options) override {
    texture_ = samples::make_texture(samples::load_image(options.data + "/building.jpg"), options);
  }

  void draw(const Options& options) override {
    glBindTexture(GL_TEXTURE_2D, texture_);
    switch (figure_) {
      case 1: draw_walls(options); break;
      case 2: draw_photograph(options); break;
      default: draw_front(); break;
    }
  }

 private:
  static Vertex vertex(Place place, float x, float y, float z = 0) { return {place.s(), place.t(), x, y, z}; }

  static void draw_front() {
    samples::draw_quads({vertex(kWall[0], -0.96f, -0.94f), vertex(kWall[1], 0.96f, -0.94f),
                         vertex(kWall[2], 0.96f, 0.94f), vertex(kWall[3], -0.96f, 0.94f)});
  }

  static void draw_photograph(const Options& options) {
    samples::draw_quads({{0, 0, -1, -1}, {1, 0, 1, -1}, {1, 1, 1, 1}, {0, 1, -1, 1}});
    if (options.bare()) return;
    glDisable(GL_TEXTURE_2D);
    glLineWidth(3);
    glColor3f(1, 0.2f, 0.1f);
    glBegin(GL_LINE_LOOP);
    for (Place place : kWall) glVertex2f(place.s() * 2 - 1, place.t() * 2 - 1);
    glEnd();
  }

  // The walls meet at a right angle. Frames turn the house a little to and fro.
  static void draw_walls(const Options& options) {
    constexpr float kLeftWidth = 5, kRightWidth = 3, kHeight = 3.4f;
    const float aspect = float(options.width) / options.height;
    const int phase = options.frame % 120;
    const float angle_deg = 36 + 0.2f * (phase < 60 ? phase : 120 - phase);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.5 * aspect, 0.5 * aspect, -0.5, 0.5, 1, 100);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0.55f, -1.55f, -5.6f);
    glRotatef(8, 1, 0, 0);
    glRotatef(angle_deg, 0, 1, 0);
    glEnable(GL_DEPTH_TEST);
    samples::draw_quads({vertex(kLeftWall[0], -kLeftWidth, 0), vertex(kLeftWall[1], 0, 0),
                         vertex(kLeftWall[2], 0, kHeight), vertex(kLeftWall[3], -kLeftWidth, kHeight)});
    samples::draw_quads({vertex(kRightWall[0], 0, 0), vertex(kRightWall[1], 0, 0, -kRightWidth),
                         vertex(kRightWall[2], 0, kHeight, -kRightWidth), vertex(kRightWall[3], 0, kHeight)});
  }

  int figure_ = 3;
  GLuint texture_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Facade sample;
  return samples::run(sample, argc, argv);
}
