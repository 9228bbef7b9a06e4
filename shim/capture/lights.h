// How the driver would light a quad's corners now, and drawing with these colours in place of its lighting.
#pragma once

#include <glm/vec4.hpp>

#include "capture/lighting.h"
#include "capture/slots.h"
#include "capture/values.h"

namespace truequad {

struct Capture;
struct Quad;

// Read from the driver, outside Begin/End, at most once for a Begin: the places when GL_LIGHTING is enabled and a quad is drawn
// as a mesh, all when the colours of such a quad may vary.
enum class LightsRead : std::uint8_t { kNothing, kPlaces, kAll };

struct Lights {
  static constexpr unsigned kMost = 32;

  // The places.
  unsigned count;        // of enabled lights, kMost at most
  GLenum name[kMost];
  Light light[kMost];    // their positions
  bool too_many;
  bool depend_on_place;  // a light is not at infinity, or the viewer is local
  bool color_material;

  // All.
  bool modelled;         // what was read determines the colours
  LightModel model;
  EyeSpace eye;
  bool two_sided;
  bool front_is_ccw;
  Material material[2];  // front, back
  SlotMask tracked;      // material slots that follow the current colour
  glm::vec4 normal;
  // What to restore.
  bool color_sum;
  bool color_kept, secondary_kept;
  Float4 color, secondary;
};

enum Side : unsigned { kFront, kBack };

// Lit colours of the corners A B C D, clamped if the driver would.
struct LitCorners {
  bool side[2];   // the quad, or a part of it, is seen from it
  bool separate;  // `secondary` is in use
  Float4 primary[2][4], secondary[2][4];
};

// True: draw the quad unlit, with these colours. False: leave lighting to the driver, because every vertex gets the same
// colour, or because the colours cannot be told. The driver may be inside our glBegin(GL_TRIANGLES), or is afterwards outside.
bool light_corners(Capture& c, const Quad& quad, LitCorners& out);

// Of a triangle in object space, as it is seen now (section 2.14.1, equation 2.6).
Side side_of(const Capture& c, const Float4& a, const Float4& b, const Float4& d);

// Lighting off, so that the colours of vertices are what is sent; and everything as it was. Outside Begin/End.
void begin_unlit(Capture& c);
void end_unlit(Capture& c);

}  // namespace truequad
