// What is known of each GL context: found by its handle when it is made current, never on the vertex path.
#pragma once

#include <atomic>
#include <cstdint>

#include "capture/deletions.h"
#include "driver/driver.h"

namespace truequad {

// What a context can be asked without raising an error. Read once, outside Begin/End, when first needed.
struct Caps {
  bool supported = false;  // a compatibility context that we can query
  int version = 0;         // 10 * major + minor
  bool multitexture_core = false, secondary_color_core = false, fog_coord_core = false;  // else ARB or EXT names
  bool multitexture = false, secondary_color = false, fog_coord = false;
  bool texture_3d = false, cube_map = false, rectangle = false;
  bool glsl = false, glsl_arb = false, pipelines = false;
  bool vertex_program = false, fragment_program = false, nv_fragment_program = false;
  bool ati_fragment_shader = false, ext_vertex_shader = false, nv_texture_shader = false;
  bool feedback_objects = false, primitive_queries = false, statistics_queries = false;
  bool separate_specular = false, rescale_normal = false, fragment_lighting = false;
  bool color_clamp = false, float_mode = false, depth_clamp = false, multisample = false;
  bool provoking_vertex = false;
  bool buffers = false, vertex_array_objects = false, unified_memory = false;
  bool generic_attributes_core = false, vertex_program_arb = false;
  bool restart_core = false, restart_nv = false, restart_fixed = false;
  bool quads_follow_provoking = false;
  unsigned texture_units = 1;   // that have texture enables and generation
  unsigned texture_coords = 1;  // that have current coordinates
  unsigned lights = 8;          // GL_MAX_LIGHTS
  double snap_px = 0;           // of the rasteriser's grid
  std::uint32_t extensions = 0;  // bit i: kExtensions[i] is advertised
};

class ShareGroup;
struct ArrayMemory;
struct ListCompile;

// Never raises an error: the version decides what is asked. Must be called outside Begin/End.
Caps read_caps(const Driver& driver);

struct ContextRecord {
  const void* handle = nullptr;
  ContextRecord* next = nullptr;
  int users = 0;  // threads in which it is current
  std::atomic<bool> destroyed{false};
  bool caps_read = false;
  bool inside = false;          // while it is not current
  ListCompile* list = nullptr;  // likewise
  ShareGroup* group = nullptr;  // null without memory
  GLuint list_base = 0;         // as it was when it was set, or could be asked for
  bool list_base_set = false;   // by the program: else glPopAttrib brings back no other
  GLuint relist_name = 0;       // of the list that relist.h compiles; 0: not chosen yet
  ArrayMemory* arrays = nullptr;  // allocated with the first draw of quads from arrays
  BindingAges ages;
  Caps caps;
};

// Read at the first need, outside Begin/End.
const Caps& caps_of(ContextRecord& context, const Driver& driver);

}  // namespace truequad
