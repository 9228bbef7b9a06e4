#include "capture/colours.h"

#include <cmath>

#include "capture/draw.h"
#include "capture/lights.h"
#include "kernel/affine_fast.h"

namespace truequad {
namespace {

constexpr SlotMask kColourSlots = bit(kColor) | bit(kSecondaryColor) | bit(kFogCoord);
constexpr float kSteps = 255;

void corners_of(const Capture& c, Slot slot, const Quad& quad, float (&out)[4][4]) {
  for (int i = 0; i < 4; ++i) std::memcpy(out[i], c.at[slot][quad.corner[i]].at, sizeof out[i]);
}

// `size` components of a colour, those that vary.
void add(PlannedFor& out, const Float4 (&corner)[4], unsigned size, float steps = kSteps) {
  for (unsigned k = 0; k < size; ++k) {
    if (out.colours == kMaxColourChannels) return;
    float(&channel)[4] = out.colour[out.colours];
    bool varies = false, finite = true;
    for (int i = 0; i < 4; ++i) {
      channel[i] = steps * corner[i].at[k];
      varies |= channel[i] != channel[0];
      finite &= std::isfinite(channel[i]);
    }
    if (varies && finite) ++out.colours;
  }
}

}  // namespace

bool colours_may_kink(const Capture& c, const Quad& quad) {
  if (!c.options->color || (c.view_read && c.view.flat)) return false;
  if (c.lit) return true;
  bool may = false;
  for_each_slot(c.live & kColourSlots, [&](Slot slot) {
    if (may || same_everywhere(c, slot, quad)) return;
    alignas(16) float position[4][4], colour[4][4];
    corners_of(c, kPosition, quad, position);
    corners_of(c, slot, quad, colour);
    if (surely_affine(position, colour)) return;
    // Channel by channel, as the kernel does it.
    const auto& x = position;
    const Corners at{Vec4{x[0][0], x[0][1], x[0][2], x[0][3]}, Vec4{x[1][0], x[1][1], x[1][2], x[1][3]},
                     Vec4{x[2][0], x[2][1], x[2][2], x[2][3]}, Vec4{x[3][0], x[3][1], x[3][2], x[3][3]}};
    for (int k = 0; k < 4 && !may; ++k) {
      const Corners channel[] = {
          {Vec4{colour[0][k]}, Vec4{colour[1][k]}, Vec4{colour[2][k]}, Vec4{colour[3][k]}}};
      may = classify(at, channel) == Shape::kWarped;
    }
  });
  return may;
}

void read_colour_state(const Driver& driver, const Caps& caps, FrameView& out) {
  if (out.colours_read) return;
  out.colours_read = true;
  out.color_sum = caps.secondary_color && driver.IsEnabled(GL_COLOR_SUM);
  if (!caps.fog_coord || !driver.IsEnabled(GL_FOG)) return;
  GLint source = 0, mode = 0;
  driver.GetIntegerv(GL_FOG_COORD_SRC, &source);
  if (source != GL_FOG_COORD) return;
  driver.GetIntegerv(GL_FOG_MODE, &mode);
  if (mode == GL_LINEAR) {
    GLfloat start = 0, end = 0;
    driver.GetFloatv(GL_FOG_START, &start);
    driver.GetFloatv(GL_FOG_END, &end);
    if (end != start) out.steps_per_fog = kSteps / std::fabs(end - start);
  } else {
    // The steepest that exp(-dc) and exp(-(dc)^2) become.
    GLfloat density = 0;
    driver.GetFloatv(GL_FOG_DENSITY, &density);
    out.steps_per_fog = kSteps * density * (mode == GL_EXP2 ? 0.8578f : 1.0f);
  }
}

void find_colours(Capture& c, const Quad& quad, PlannedFor& out) {
  out.colours = 0;
  if (!c.options->color || c.view.flat) return;
  const Driver& driver = *c.driver;
  const SlotMask varying = c.live & kColourSlots;
  if ((varying & (bit(kSecondaryColor) | bit(kFogCoord))) && !c.view.colours_read) {
    close_mesh(c);
    read_colour_state(driver, c.entry->context->caps, c.view);
  }
  const auto corners = [&](Slot slot, Float4(&corner)[4], bool clamped) {
    for (int i = 0; i < 4; ++i) {
      corner[i] = c.at[slot][quad.corner[i]];
      if (clamped) clamp_colour(corner[i]);
    }
  };
  Float4 corner[4];
  if (c.view.lighting) {
    LitCorners lit;
    if (light_corners(c, quad, lit)) {
      for (const Side side : {kFront, kBack}) {
        if (!lit.side[side]) continue;
        add(out, lit.primary[side], 4);
        if (lit.separate) add(out, lit.secondary[side], 3);
      }
    }
  } else {
    if (varying & bit(kColor)) {
      corners(kColor, corner, c.view.clamps_colours);
      add(out, corner, 4);
    }
    if ((varying & bit(kSecondaryColor)) && c.view.color_sum) {
      corners(kSecondaryColor, corner, c.view.clamps_colours);
      add(out, corner, 3);
    }
  }
  if ((varying & bit(kFogCoord)) && c.view.steps_per_fog > 0) {
    corners(kFogCoord, corner, false);
    add(out, corner, 1, c.view.steps_per_fog);
  }
}

}  // namespace truequad
