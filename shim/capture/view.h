// How the driver would draw a quad now: read from the driver, outside Begin/End, when a quad may need correction.
#pragma once

#include "capture/context.h"
#include "capture/reasons.h"
#include "truequad/kernel.h"

namespace truequad {

struct FrameView {
  Reason pass = Reason::kNone;  // every quad of this Begin is left alone
  View view;
  float modelview[16] = {};
  bool flat = false;
  bool lighting = false;
  bool clamps_colours = true;          // of vertices, lit or not (GL 2.1 section 2.14.6, ARB_color_buffer_float)
  bool first_vertex_provokes = false;  // of a GL_QUADS or GL_QUAD_STRIP quad, under flat shading
  // Passes over the same vertices (drawn.h): the picture depends on what earlier ones drew; only on where they drew it
  // just so (GL_EQUAL); and later ones may depend on this one.
  bool meets_earlier = false, equals_earlier = false, meets_later = false;
  // Bit masks over texture units; valid for the units of units_read.
  unsigned units_read = 0, units_enabled = 0, units_generated = 0;
  // Valid if colours_read (colours.h): secondary colours are shown; steps of 1/255 for each unit of the fog coordinate.
  bool colours_read = false, color_sum = false;
  float steps_per_fog = 0;
};

// Reads all but the texture units. Asks only what `caps` knows to exist: never raises an error.
void read_view(const Driver& driver, const Caps& caps, FrameView& out);

// A vertex, fragment or GLSL program, a pipeline, or a vendor's shader is in use.
bool program_bound(const Driver& driver, const Caps& caps);

// Reads texture enables and coordinate generation of the units in `units` (bit mask) that were not read before.
void read_units(const Driver& driver, const Caps& caps, unsigned units, FrameView& out);

// Runs f() while `unit` is the active texture unit.
template <typename F>
void with_texture_unit(const Driver& driver, const Caps& caps, unsigned unit, F f) {
  if (!caps.multitexture) return f();
  GLint before = GL_TEXTURE0;
  driver.GetIntegerv(GL_ACTIVE_TEXTURE, &before);
  const auto select = [&](GLenum texture) {
    if (caps.multitexture_core) driver.ActiveTexture(texture);
    else driver.ActiveTextureARB(texture);
  };
  const GLenum wanted = GL_TEXTURE0 + unit;
  if (GLenum(before) != wanted) select(wanted);
  f();
  if (GLenum(before) != wanted) select(GLenum(before));
}

}  // namespace truequad
