#include "capture/lights.h"

#include <cmath>
#include <glm/vec2.hpp>
#include <span>

#include "capture/draw.h"
#include "capture/scratch.h"
#include "capture/state.h"

namespace truequad {
namespace {

GLint get(const Driver& driver, GLenum name) {
  GLint value = 0;
  driver.GetIntegerv(name, &value);
  return value;
}

void read_places(const Driver& driver, const Caps& caps, Lights& out) {
  out.count = 0;
  out.too_many = false;
  out.depend_on_place = get(driver, GL_LIGHT_MODEL_LOCAL_VIEWER) != 0;
  out.color_material = driver.IsEnabled(GL_COLOR_MATERIAL);
  for (GLenum i = 0; i < caps.lights; ++i) {
    if (!driver.IsEnabled(GL_LIGHT0 + i)) continue;
    if (out.count == Lights::kMost) {
      out.too_many = true;
      return;
    }
    out.name[out.count] = GL_LIGHT0 + i;
    Light& light = out.light[out.count++];
    driver.GetLightfv(GL_LIGHT0 + i, GL_POSITION, &light.position.x);
    if (light.position.w != 0) out.depend_on_place = true;
  }
}

void read_light(const Driver& driver, GLenum name, Light& out) {
  driver.GetLightfv(name, GL_AMBIENT, &out.ambient.x);
  driver.GetLightfv(name, GL_DIFFUSE, &out.diffuse.x);
  driver.GetLightfv(name, GL_SPECULAR, &out.specular.x);
  driver.GetLightfv(name, GL_SPOT_DIRECTION, &out.spot_direction.x);
  driver.GetLightfv(name, GL_SPOT_EXPONENT, &out.spot_exponent);
  driver.GetLightfv(name, GL_SPOT_CUTOFF, &out.spot_cutoff);
  driver.GetLightfv(name, GL_CONSTANT_ATTENUATION, &out.constant_attenuation);
  driver.GetLightfv(name, GL_LINEAR_ATTENUATION, &out.linear_attenuation);
  driver.GetLightfv(name, GL_QUADRATIC_ATTENUATION, &out.quadratic_attenuation);
}

void read_material(const Driver& driver, GLenum face, Material& out) {
  driver.GetMaterialfv(face, GL_AMBIENT, &out.ambient.x);
  driver.GetMaterialfv(face, GL_DIFFUSE, &out.diffuse.x);
  driver.GetMaterialfv(face, GL_SPECULAR, &out.specular.x);
  driver.GetMaterialfv(face, GL_EMISSION, &out.emission.x);
  driver.GetMaterialfv(face, GL_SHININESS, &out.shininess);
}

// The places of a face's material slots, in their order.
constexpr unsigned kAmbient = 0, kDiffuse = 1, kSpecular = 2, kEmission = 3, kShininess = 4;

SlotMask tracked_slots(const Driver& driver) {
  SlotMask properties = 0;
  switch (get(driver, GL_COLOR_MATERIAL_PARAMETER)) {
    case GL_AMBIENT: properties = bit(kAmbient); break;
    case GL_DIFFUSE: properties = bit(kDiffuse); break;
    case GL_SPECULAR: properties = bit(kSpecular); break;
    case GL_EMISSION: properties = bit(kEmission); break;
    default: properties = bit(kAmbient) | bit(kDiffuse); break;
  }
  const GLenum face = GLenum(get(driver, GL_COLOR_MATERIAL_FACE));
  return (face != GL_BACK ? properties << kMaterial : 0) |
         (face != GL_FRONT ? properties << (kMaterial + kMaterialProperties) : 0);
}

glm::vec4& colour_of(Material& material, unsigned property) {
  switch (property) {
    case kAmbient: return material.ambient;
    case kDiffuse: return material.diffuse;
    case kSpecular: return material.specular;
    default: return material.emission;
  }
}

glm::vec4 vector(const Float4& x) { return {x.at[0], x.at[1], x.at[2], x.at[3]}; }

// Drawing with our colours ends with the current colour as it was, and with materials that take it on. A driver in which
// they were not the same (after glPopAttrib, say) would not have its materials again.
bool materials_follow(Lights& lights) {
  bool same = true;
  for_each_slot(lights.tracked >> kMaterial, [&](unsigned property) {
    Material& material = lights.material[property / kMaterialProperties];
    same = same && colour_of(material, property % kMaterialProperties) == vector(lights.color);
  });
  return same;
}

// Drivers make colours of their own of what is not finite.
bool all_finite(const Lights& lights) {
  float zero = 0;
  const auto add = [&](const auto& x) {
    for (int i = 0; i < x.length(); ++i) zero += 0 * x[i];
  };
  for (const Light& light : std::span(lights.light, lights.count)) {
    for (const glm::vec4* x : {&light.ambient, &light.diffuse, &light.specular, &light.position}) add(*x);
    add(light.spot_direction);
    add(glm::vec3(light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation));
    add(glm::vec2(light.spot_exponent, light.spot_cutoff));
  }
  for (const Material& material : std::span(lights.material, lights.two_sided ? 2 : 1)) {
    for (const glm::vec4* x : {&material.ambient, &material.diffuse, &material.specular, &material.emission}) add(*x);
    zero += 0 * material.shininess;
  }
  add(lights.model.ambient);
  add(lights.normal);
  return zero == 0;
}

void read_all(const Capture& c, const Caps& caps, Lights& out) {
  const Driver& driver = *c.driver;
  out.modelled = !out.too_many && get(driver, GL_RGBA_MODE) != 0 &&
                 out.eye.set(c.view.modelview, caps.rescale_normal && driver.IsEnabled(GL_RESCALE_NORMAL),
                             driver.IsEnabled(GL_NORMALIZE));
  if (!out.modelled) return;
  for (unsigned i = 0; i < out.count; ++i) read_light(driver, out.name[i], out.light[i]);
  driver.GetFloatv(GL_LIGHT_MODEL_AMBIENT, &out.model.ambient.x);
  out.model.local_viewer = get(driver, GL_LIGHT_MODEL_LOCAL_VIEWER) != 0;
  out.model.separate_specular =
      caps.separate_specular && get(driver, GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR;
  out.two_sided = get(driver, GL_LIGHT_MODEL_TWO_SIDE) != 0;
  out.front_is_ccw = !out.two_sided || get(driver, GL_FRONT_FACE) == GL_CCW;
  read_material(driver, GL_FRONT, out.material[kFront]);
  if (out.two_sided) read_material(driver, GL_BACK, out.material[kBack]);
  out.color_sum = caps.secondary_color && driver.IsEnabled(GL_COLOR_SUM);

  // What is set in this Begin is known from its corners, and is sent again at its end.
  out.normal = {0, 0, 1, 0};
  if (!(c.live & bit(kNormal))) driver.GetFloatv(GL_CURRENT_NORMAL, &out.normal.x);
  out.color_kept = !(c.live & bit(kColor));
  if (out.color_kept) driver.GetFloatv(GL_CURRENT_COLOR, out.color.at);
  out.secondary_kept = out.model.separate_specular && !(c.live & bit(kSecondaryColor));
  if (out.secondary_kept) driver.GetFloatv(GL_CURRENT_SECONDARY_COLOR, out.secondary.at);
  out.tracked = out.color_material ? tracked_slots(driver) : 0;
  if (!out.two_sided) out.tracked &= bits(kMaterial, kMaterialProperties);
  if (out.color_kept && !materials_follow(out)) out.modelled = false;
  if (!all_finite(out)) out.modelled = false;
}

bool same_at_corners(const Capture& c, const Quad& quad, SlotMask slots) {
  bool same = true;
  for_each_slot(slots & c.live, [&](Slot slot) { same = same && same_everywhere(c, slot, quad); });
  return same;
}

// Every vertex of the mesh gets the same colour from the driver, which is that of the provoking or of every corner.
bool one_colour(const Capture& c, const Lights& lights, const Quad& quad) {
  if (lights.depend_on_place || !same_at_corners(c, quad, bit(kNormal))) return false;
  return c.view.flat ||
         same_at_corners(c, quad, kMaterialSlots | (lights.color_material ? bit(kColor) : SlotMask(0)));
}

// The material of one corner.
Material material_at(const Capture& c, const Lights& lights, Side side, unsigned place) {
  Material material = lights.material[side];
  const Slot first = kMaterial + side * kMaterialProperties;
  for (unsigned property : {kAmbient, kDiffuse, kSpecular, kEmission}) {
    // While a property tracks the current colour, glMaterial does not change it (section 2.14.3).
    const Slot slot = lights.tracked & bit(first + property) ? kColor : first + property;
    if (c.live & bit(slot)) colour_of(material, property) = vector(c.at[slot][place]);
  }
  if (c.live & bit(first + kShininess)) material.shininess = c.at[first + kShininess][place].at[0];
  return material;
}

Float4 colour(const Capture& c, const glm::dvec4& x) {
  Float4 result{{float(x.r), float(x.g), float(x.b), float(x.a)}};
  if (c.view.clamps_colours) clamp_colour(result);
  return result;
}

// False: the corner is at infinity, from where no direction leads to a lamp, or its colour is not finite.
bool light_corner(const Capture& c, const Lights& lights, unsigned place, unsigned corner, LitCorners& out) {
  const glm::dvec4 eye = lights.eye.position(vector(c.at[kPosition][place]));
  if (eye.w == 0) return false;
  const glm::dvec3 position = glm::dvec3(eye) / eye.w;
  const glm::dvec3 normal =
      lights.eye.normal(glm::dvec3(c.live & bit(kNormal) ? vector(c.at[kNormal][place]) : lights.normal));
  for (const Side side : {kFront, kBack}) {
    if (!out.side[side]) continue;
    const LitColours lit =
        light_vertex(lights.model, {lights.light, lights.count}, material_at(c, lights, side, place), position,
                     side == kFront ? normal : -normal);
    if (!std::isfinite(lit.primary.r + lit.primary.g + lit.primary.b + lit.primary.a + lit.secondary.r + lit.secondary.g +
                       lit.secondary.b)) {
      return false;
    }
    out.primary[side][corner] = colour(c, lit.primary);
    out.secondary[side][corner] = colour(c, lit.secondary);
  }
  return true;
}

// Twice the area of a triangle on the screen, but for a factor that is positive where the triangle is before the eye.
// So triangles of which only a part is there need no clipping.
double area(const Capture& c, const Float4& p, const Float4& q, const Float4& r) {
  const auto& m = c.view.view.clip_from_object;
  double clip[3][3];
  const Float4* const corners[3] = {&p, &q, &r};
  for (int i = 0; i < 3; ++i) {
    const float(&x)[4] = corners[i]->at;
    for (int k = 0; k < 3; ++k) {
      const int row = k == 2 ? 3 : k;
      clip[i][k] = m[row] * x[0] + m[4 + row] * x[1] + m[8 + row] * x[2] + m[12 + row] * x[3];
    }
  }
  const auto& [a, b, d] = clip;
  return a[0] * (b[1] * d[2] - b[2] * d[1]) - a[1] * (b[0] * d[2] - b[2] * d[0]) +
         a[2] * (b[0] * d[1] - b[1] * d[0]);
}

// A quad is seen from one side if its four corners turn the same way; else its triangles are told apart one by one.
void find_sides(const Capture& c, const Lights& lights, const Quad& quad, bool (&out)[2]) {
  out[kFront] = out[kBack] = false;
  if (!lights.two_sided) {
    out[kFront] = true;
    return;
  }
  const auto corner = [&](unsigned i) -> const Float4& { return c.at[kPosition][quad.corner[i % 4]]; };
  for (unsigned i = 0; i < 4; ++i) {
    const double turn = area(c, corner(i), corner(i + 1), corner(i + 2));
    if (turn != 0) out[(turn > 0) == lights.front_is_ccw ? kFront : kBack] = true;
  }
  if (!out[kBack]) out[kFront] = true;
}

}  // namespace

Side side_of(const Capture& c, const Float4& a, const Float4& b, const Float4& d) {
  const Lights& lights = c.scratch->lights;
  if (!lights.two_sided) return kFront;
  return (area(c, a, b, d) > 0) == lights.front_is_ccw ? kFront : kBack;
}

bool light_corners(Capture& c, const Quad& quad, LitCorners& out) {
  Lights& lights = c.scratch->lights;
  const Caps& caps = c.entry->context->caps;
  if (c.lights_read == LightsRead::kNothing) {
    close_mesh(c);
    read_places(*c.driver, caps, lights);
    c.lights_read = LightsRead::kPlaces;
  }
  // While lighting is off, the next quad costs least if it stays so.
  if (!c.mesh_unlit && one_colour(c, lights, quad)) return false;
  if (c.lights_read == LightsRead::kPlaces) {
    close_mesh(c);
    read_all(c, caps, lights);
    c.lights_read = LightsRead::kAll;
  }
  if (!lights.modelled) return false;

  find_sides(c, lights, quad, out.side);
  out.separate = lights.model.separate_specular;
  if (c.view.flat) {
    const unsigned provoking = provoking_corner(c);
    if (!light_corner(c, lights, quad.corner[provoking], 0, out)) return false;
    for (unsigned i = 1; i < 4; ++i) {
      for (const Side side : {kFront, kBack}) {
        out.primary[side][i] = out.primary[side][0];
        out.secondary[side][i] = out.secondary[side][0];
      }
    }
    return true;
  }
  for (unsigned i = 0; i < 4; ++i) {
    if (!light_corner(c, lights, quad.corner[i], i, out)) return false;
  }
  return true;
}

void begin_unlit(Capture& c) {
  const Driver& driver = *c.driver;
  const Lights& lights = c.scratch->lights;
  // Our colours are not to become materials.
  if (lights.color_material) driver.Disable(GL_COLOR_MATERIAL);
  driver.Disable(GL_LIGHTING);
  // "If lighting is enabled … color sum is always applied, regardless of the value of COLOR_SUM" (section 3.9), with what
  // lighting made of the secondary colour.
  if (lights.model.separate_specular && !lights.color_sum) driver.Enable(GL_COLOR_SUM);
  if (!lights.model.separate_specular && lights.color_sum) driver.Disable(GL_COLOR_SUM);
  c.mesh_unlit = true;
}

void end_unlit(Capture& c) {
  const Driver& driver = *c.driver;
  const Caps& caps = c.entry->context->caps;
  const Lights& lights = c.scratch->lights;
  c.mesh_unlit = false;
  if (lights.color_kept) driver.Color4fv(lights.color.at);
  if (lights.secondary_kept) {
    caps.secondary_color_core ? driver.SecondaryColor3fv(lights.secondary.at)
                              : driver.SecondaryColor3fvEXT(lights.secondary.at);
  }
  if (lights.model.separate_specular && !lights.color_sum) driver.Disable(GL_COLOR_SUM);
  if (!lights.model.separate_specular && lights.color_sum) driver.Enable(GL_COLOR_SUM);
  driver.Enable(GL_LIGHTING);
  if (lights.color_material) driver.Enable(GL_COLOR_MATERIAL);
}

}  // namespace truequad
