#include "capture/overlay.h"

#include "capture/replay.h"

namespace truequad {
namespace {

GLint get(const Driver& driver, GLenum name) {
  GLint value = 0;
  driver.GetIntegerv(name, &value);
  return value;
}

void set_line_state(const Driver& driver, const Caps& caps) {
  for (unsigned unit = 0; unit < caps.texture_units; ++unit) {
    with_texture_unit(driver, caps, unit, [&] {
      driver.Disable(GL_TEXTURE_1D);
      driver.Disable(GL_TEXTURE_2D);
      if (caps.texture_3d) driver.Disable(GL_TEXTURE_3D);
      if (caps.cube_map) driver.Disable(GL_TEXTURE_CUBE_MAP);
      if (caps.rectangle) driver.Disable(GL_TEXTURE_RECTANGLE);
    });
  }
  for (GLenum off : {GL_LIGHTING, GL_FOG, GL_BLEND, GL_ALPHA_TEST, GL_COLOR_LOGIC_OP, GL_LINE_STIPPLE}) {
    driver.Disable(off);
  }
  if (caps.secondary_color) driver.Disable(GL_COLOR_SUM);
  driver.DepthMask(GL_FALSE);
  driver.StencilMask(0);
  driver.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  driver.Enable(GL_POLYGON_OFFSET_LINE);
  driver.PolygonOffset(-1, -1);
  driver.Color3f(1, 0.25f, 0);
}

}  // namespace

void draw_overlay(const Capture& c, const Quad& quad, const Plan& plan, std::span<const Param> params,
                  std::span<const Triangle> triangles) {
  const Driver& driver = *c.driver;
  if (get(driver, GL_ATTRIB_STACK_DEPTH) >= get(driver, GL_MAX_ATTRIB_STACK_DEPTH)) return;
  driver.PushAttrib(GL_ALL_ATTRIB_BITS);
  set_line_state(driver, c.entry->context->caps);
  if (plan.action == Action::kMesh) {
    const auto corner = [&](int i) { return c.at[kPosition][quad.corner[i]].at; };
    driver.Begin(GL_TRIANGLES);
    for (const Triangle& triangle : triangles.first(mesh_size(plan).triangles)) {
      for (const unsigned vertex : {triangle.a, triangle.b, triangle.c}) {
        const Param p = params[vertex];
        GLfloat position[4];
        for (int k = 0; k < 4; ++k) {
          position[k] = float(
              interpolate<double>(corner(0)[k], corner(1)[k], corner(2)[k], corner(3)[k], p.u, p.v));
        }
        driver.Vertex4fv(position);
      }
    }
  } else {
    driver.Begin(GL_QUADS);
    for (unsigned place : quad.corner) replay_at(c, kPosition, place);
  }
  driver.End();
  driver.PopAttrib();
}

}  // namespace truequad
