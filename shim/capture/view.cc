#include "capture/view.h"

#include <algorithm>

namespace truequad {
namespace {

GLint get(const Driver& driver, GLenum name) {
  GLint value = 0;
  driver.GetIntegerv(name, &value);
  return value;
}

}  // namespace

bool program_bound(const Driver& driver, const Caps& caps) {
  if (caps.glsl ? get(driver, GL_CURRENT_PROGRAM) != 0
                : caps.glsl_arb && driver.GetHandleARB(GL_PROGRAM_OBJECT_ARB) != 0) {
    return true;
  }
  if (caps.pipelines && get(driver, GL_PROGRAM_PIPELINE_BINDING) != 0) return true;
  if (caps.vertex_program && driver.IsEnabled(GL_VERTEX_PROGRAM_ARB)) return true;
  if (caps.fragment_program && driver.IsEnabled(GL_FRAGMENT_PROGRAM_ARB)) return true;
  if (caps.nv_fragment_program && driver.IsEnabled(GL_FRAGMENT_PROGRAM_NV)) return true;
  if (caps.ati_fragment_shader && driver.IsEnabled(GL_FRAGMENT_SHADER_ATI)) return true;
  if (caps.ext_vertex_shader && driver.IsEnabled(GL_VERTEX_SHADER_EXT)) return true;
  return caps.nv_texture_shader && driver.IsEnabled(GL_TEXTURE_SHADER_NV);
}

namespace {

// Counts of primitives that a mesh would change.
bool primitives_counted(const Driver& driver, const Caps& caps) {
  if (caps.feedback_objects && get(driver, GL_TRANSFORM_FEEDBACK_ACTIVE) != 0) return true;
  const auto active = [&](GLenum target) {
    GLint query = 0;
    driver.GetQueryiv(target, GL_CURRENT_QUERY, &query);
    return query != 0;
  };
  if (caps.primitive_queries &&
      (active(GL_PRIMITIVES_GENERATED) || active(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN))) {
    return true;
  }
  if (!caps.statistics_queries) return false;
  constexpr GLenum kCounted[] = {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED, GL_VERTEX_SHADER_INVOCATIONS,
                                 GL_CLIPPING_INPUT_PRIMITIVES, GL_CLIPPING_OUTPUT_PRIMITIVES,
                                 GL_FRAGMENT_SHADER_INVOCATIONS};
  return std::any_of(std::begin(kCounted), std::end(kCounted), active);
}

// Lights whose effect is computed for each fragment, from normals.
bool lit_by_fragments(const Driver& driver, const Caps& caps) {
  return caps.fragment_lighting && driver.IsEnabled(GL_FRAGMENT_LIGHTING_SGIX);
}

// Column-major product, in double: the drivers keep floats.
std::array<double, 16> product(const GLfloat (&a)[16], const GLfloat (&b)[16]) {
  std::array<double, 16> result;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += double(a[4 * k + row]) * double(b[4 * column + k]);
      result[4 * column + row] = sum;
    }
  }
  return result;
}

Reason find_reason(const Driver& driver, const Caps& caps) {
  if (!caps.supported) return Reason::kUnknownContext;
  if (get(driver, GL_RENDER_MODE) != GL_RENDER) return Reason::kSelectionOrFeedback;
  if (program_bound(driver, caps)) return Reason::kProgram;
  GLint polygon_mode[2] = {GL_FILL, GL_FILL};
  driver.GetIntegerv(GL_POLYGON_MODE, polygon_mode);
  if (polygon_mode[0] != GL_FILL || polygon_mode[1] != GL_FILL) return Reason::kPolygonMode;
  if (driver.IsEnabled(GL_POLYGON_SMOOTH)) return Reason::kPolygonSmooth;
  if (primitives_counted(driver, caps)) return Reason::kTransformFeedbackOrQuery;
  if (lit_by_fragments(driver, caps)) return Reason::kLighting;
  return Reason::kNone;
}

// A corrected quad is drawn without lighting (lights.h). Its specular colour then needs a secondary colour.
bool lighting_needs_color_sum(const Driver& driver, const Caps& caps) {
  return caps.separate_specular && !caps.secondary_color &&
         get(driver, GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR;
}

bool clamps_colours(const Driver& driver, const Caps& caps) {
  if (!caps.color_clamp) return true;
  const GLint clamp = get(driver, GL_CLAMP_VERTEX_COLOR);
  if (clamp != GL_FIXED_ONLY) return clamp != GL_FALSE;
  return !(caps.float_mode && get(driver, GL_RGBA_FLOAT_MODE_ARB) != 0);
}

void read_tests(const Driver& driver, FrameView& out) {
  if (driver.IsEnabled(GL_DEPTH_TEST)) {
    const GLint function = get(driver, GL_DEPTH_FUNC);
    out.meets_earlier = function != GL_ALWAYS && function != GL_NEVER;
    out.equals_earlier = function == GL_EQUAL || function == GL_NOTEQUAL;
    out.meets_later = function != GL_NEVER && get(driver, GL_DEPTH_WRITEMASK) != 0;
  }
  if (driver.IsEnabled(GL_STENCIL_TEST)) out.meets_earlier = out.meets_later = true;
}

}  // namespace

void read_view(const Driver& driver, const Caps& caps, FrameView& out) {
  out = FrameView{};
  out.pass = find_reason(driver, caps);
  if (out.pass != Reason::kNone) return;

  out.lighting = driver.IsEnabled(GL_LIGHTING);
  if (out.lighting && lighting_needs_color_sum(driver, caps)) {
    out.pass = Reason::kLighting;
    return;
  }
  GLfloat projection[16] = {}, viewport[4] = {};
  driver.GetFloatv(GL_MODELVIEW_MATRIX, out.modelview);
  driver.GetFloatv(GL_PROJECTION_MATRIX, projection);
  driver.GetFloatv(GL_VIEWPORT, viewport);
  out.view.clip_from_object = product(projection, out.modelview);
  out.view.viewport = {viewport[0], viewport[1], viewport[2], viewport[3]};
  out.view.snap_px = caps.snap_px;
  // No query tells it; software rasterisers set up in single precision, hardware in no less.
  out.view.setup_rounding = 0x1p-24;
  out.view.multisampled = caps.multisample && get(driver, GL_SAMPLE_BUFFERS) != 0 && driver.IsEnabled(GL_MULTISAMPLE);
  out.view.depth_clamped = caps.depth_clamp && driver.IsEnabled(GL_DEPTH_CLAMP);

  out.clamps_colours = clamps_colours(driver, caps);
  read_tests(driver, out);
  out.flat = get(driver, GL_SHADE_MODEL) == GL_FLAT;
  out.first_vertex_provokes = out.flat && caps.provoking_vertex && caps.quads_follow_provoking &&
                              get(driver, GL_PROVOKING_VERTEX) == GL_FIRST_VERTEX_CONVENTION;
}

void read_units(const Driver& driver, const Caps& caps, unsigned units, FrameView& out) {
  units &= ~out.units_read;
  out.units_read |= units;
  for (unsigned unit = 0; unit < caps.texture_units && units >> unit; ++unit) {
    if (!(units >> unit & 1)) continue;
    with_texture_unit(driver, caps, unit, [&] {
      const bool enabled = driver.IsEnabled(GL_TEXTURE_2D) || driver.IsEnabled(GL_TEXTURE_1D) ||
                           (caps.texture_3d && driver.IsEnabled(GL_TEXTURE_3D)) ||
                           (caps.cube_map && driver.IsEnabled(GL_TEXTURE_CUBE_MAP)) ||
                           (caps.rectangle && driver.IsEnabled(GL_TEXTURE_RECTANGLE));
      if (!enabled) return;
      out.units_enabled |= 1u << unit;
      for (GLenum coordinate : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q}) {
        if (driver.IsEnabled(coordinate)) out.units_generated |= 1u << unit;
      }
    });
  }
}

}  // namespace truequad
