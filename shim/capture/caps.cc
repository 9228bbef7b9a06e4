// What a context can be asked, from its version and extension strings (GL 2.1 section 6.1.11, GL 3.0 section 6.1.11).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "capture/context.h"
#include "capture/rows.h"
#include "capture/slots.h"

namespace truequad {
namespace {

constexpr struct {
  std::string_view name;
  bool Caps::*flag;
} kFlags[] = {
    {"ARB_multitexture", &Caps::multitexture},
    {"EXT_secondary_color", &Caps::secondary_color},
    {"EXT_fog_coord", &Caps::fog_coord},
    {"EXT_texture3D", &Caps::texture_3d},
    {"ARB_texture_cube_map", &Caps::cube_map},
    {"EXT_texture_cube_map", &Caps::cube_map},
    {"ARB_texture_rectangle", &Caps::rectangle},
    {"EXT_texture_rectangle", &Caps::rectangle},
    {"NV_texture_rectangle", &Caps::rectangle},
    {"ARB_shader_objects", &Caps::glsl_arb},
    {"ARB_separate_shader_objects", &Caps::pipelines},
    {"ARB_vertex_program", &Caps::vertex_program},
    {"NV_vertex_program", &Caps::vertex_program},
    {"ARB_fragment_program", &Caps::fragment_program},
    {"NV_fragment_program", &Caps::nv_fragment_program},
    {"ATI_fragment_shader", &Caps::ati_fragment_shader},
    {"EXT_vertex_shader", &Caps::ext_vertex_shader},
    {"NV_texture_shader", &Caps::nv_texture_shader},
    {"ARB_transform_feedback2", &Caps::feedback_objects},
    {"EXT_transform_feedback", &Caps::primitive_queries},
    {"ARB_pipeline_statistics_query", &Caps::statistics_queries},
    {"EXT_separate_specular_color", &Caps::separate_specular},
    {"EXT_rescale_normal", &Caps::rescale_normal},
    {"EXT_fragment_lighting", &Caps::fragment_lighting},
    {"SGIX_fragment_lighting", &Caps::fragment_lighting},
    {"ARB_color_buffer_float", &Caps::float_mode},
    {"NV_depth_clamp", &Caps::depth_clamp},
    {"ARB_depth_clamp", &Caps::depth_clamp},
    {"ARB_multisample", &Caps::multisample},
    {"EXT_provoking_vertex", &Caps::provoking_vertex},
    {"ARB_provoking_vertex", &Caps::provoking_vertex},
    {"ARB_vertex_buffer_object", &Caps::buffers},
    {"ARB_vertex_array_object", &Caps::vertex_array_objects},
    {"APPLE_vertex_array_object", &Caps::vertex_array_objects},
    {"NV_vertex_buffer_unified_memory", &Caps::unified_memory},
    {"ARB_vertex_program", &Caps::vertex_program_arb},
    {"NV_primitive_restart", &Caps::restart_nv},
    {"ARB_ES3_compatibility", &Caps::restart_fixed},
};

struct Reader {
  Caps caps;
  bool compatibility = false;

  void extension(std::string_view name) {
    constexpr std::string_view kPrefix = "GL_";
    if (!name.starts_with(kPrefix)) return;
    name.remove_prefix(kPrefix.size());
    for (const auto& [known, flag] : kFlags) {
      if (known == name) caps.*flag = true;
    }
    for (std::size_t i = 0; i < kExtensions.count; ++i) {
      if (kExtensions.name[i] == name) caps.extensions |= 1u << i;
    }
    compatibility |= name == "ARB_compatibility";
  }
};

// "2.1 Mesa 22.3" gives 21; 0 for OpenGL ES and for what cannot be read.
int parse_version(const char* text) {
  if (!text || text[0] < '1' || text[0] > '9' || text[1] != '.' || text[2] < '0' || text[2] > '9') return 0;
  return 10 * (text[0] - '0') + (text[2] - '0');
}

GLint get(const Driver& driver, GLenum name, GLint otherwise) {
  driver.GetIntegerv(name, &otherwise);
  return otherwise;
}

}  // namespace

Caps read_caps(const Driver& driver) {
  Reader reader;
  Caps& caps = reader.caps;
  caps.version = parse_version(reinterpret_cast<const char*>(driver.GetString(GL_VERSION)));
  if (caps.version == 0) return caps;
  if (caps.version >= 30) {
    const GLint count = get(driver, GL_NUM_EXTENSIONS, 0);
    for (GLint i = 0; i < count; ++i) {
      const GLubyte* name = driver.GetStringi(GL_EXTENSIONS, GLuint(i));
      if (name) reader.extension(reinterpret_cast<const char*>(name));
    }
  } else if (const GLubyte* all = driver.GetString(GL_EXTENSIONS)) {
    std::string_view rest = reinterpret_cast<const char*>(all);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      reader.extension(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  // Without the compatibility profile there is no glBegin, and asking for matrices would be an error.
  if (caps.version == 31 && !reader.compatibility) return caps;
  if (caps.version >= 32) {
    const GLint profile = get(driver, GL_CONTEXT_PROFILE_MASK, 0);
    if (profile & GL_CONTEXT_CORE_PROFILE_BIT) return caps;
  }
  caps.supported = true;

  const int version = caps.version;
  caps.multitexture_core = version >= 13;
  caps.secondary_color_core = caps.fog_coord_core = version >= 14;
  caps.multitexture |= version >= 13;
  caps.secondary_color |= version >= 14;
  caps.fog_coord |= version >= 14;
  caps.separate_specular |= version >= 12;
  caps.rescale_normal |= version >= 12;
  caps.color_clamp = caps.float_mode || version >= 30;
  caps.texture_3d |= version >= 12;
  caps.cube_map |= version >= 13;
  caps.rectangle |= version >= 31;
  caps.glsl = version >= 20;
  caps.pipelines |= version >= 41;
  caps.feedback_objects |= version >= 40;
  caps.primitive_queries |= version >= 30;
  caps.statistics_queries |= version >= 46;
  caps.provoking_vertex |= version >= 32;
  caps.depth_clamp |= version >= 32;
  caps.multisample |= version >= 13;
  caps.buffers |= version >= 15;
  caps.vertex_array_objects |= version >= 30;
  caps.generic_attributes_core = version >= 20;
  caps.restart_core = version >= 31;
  caps.restart_fixed |= version >= 43;

  caps.snap_px = std::ldexp(1.0, -std::clamp(get(driver, GL_SUBPIXEL_BITS, 4), 0, 30));
  caps.lights = unsigned(std::max(0, get(driver, GL_MAX_LIGHTS, 8)));
  if (caps.multitexture) caps.texture_units = unsigned(std::max(1, get(driver, GL_MAX_TEXTURE_UNITS, 1)));
  caps.texture_coords = caps.texture_units;
  if (version >= 20 || caps.fragment_program) {
    caps.texture_coords = unsigned(std::max(1, get(driver, GL_MAX_TEXTURE_COORDS, 1)));
  }
  if (caps.provoking_vertex) {
    GLboolean follow = GL_FALSE;
    driver.GetBooleanv(GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION, &follow);
    caps.quads_follow_provoking = follow != GL_FALSE;
  }
  return caps;
}

const Caps& caps_of(ContextRecord& context, const Driver& driver) {
  if (!context.caps_read) {
    context.caps = read_caps(driver);
    context.caps_read = true;
  }
  return context.caps;
}

}  // namespace truequad
