#include "capture/draw.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "capture/overlay.h"
#include "capture/replay.h"

namespace truequad {

namespace {

constexpr int kTriangleCap = 4096;  // for one quad
// The published subdivision shares no vertices between its leaves of two triangles.
constexpr int kMaxVertices = 2 * kTriangleCap + 4;
constexpr unsigned kMaxChannels = 32;
static_assert(kMaxChannels >= std::popcount(kInterpolatedSlots) + 1);

}  // namespace

// Working space of one thread: allocated at its first correction, none after that.
struct Scratch {
  Plan plan;
  Param params[kMaxVertices];
  Triangle triangles[kTriangleCap];
  Float4 values[std::size_t(kMaxVertices) * kMaxChannels];  // vertex after vertex, a value for each channel
};

void free_scratch(Scratch* scratch) { std::free(scratch); }

namespace {

Scratch* scratch_of(Capture& c) {
  // Pages that no mesh is large enough to touch are never backed by memory.
  if (!c.scratch) {
    void* memory = std::aligned_alloc(64, (sizeof(Scratch) + 63) / 64 * 64);
    if (memory) c.scratch = new (memory) Scratch;
  }
  return c.scratch;
}

const Caps& caps_of(Capture& c) {
  ContextRecord& record = *c.entry->context;
  if (!record.caps_read) {
    close_mesh(c);
    record.caps = read_caps(*c.driver);
    record.caps_read = true;
  }
  return record.caps;
}

// The call that gives `size` floats of an interpolated slot.
RowId float_call(const Caps& caps, Slot slot, unsigned size) {
  constexpr RowId kTexCoord[] = {kRowTexCoord1fv, kRowTexCoord2fv, kRowTexCoord3fv, kRowTexCoord4fv};
  constexpr RowId kMultiTexCoord[] = {kRowMultiTexCoord1fv, kRowMultiTexCoord2fv, kRowMultiTexCoord3fv,
                                      kRowMultiTexCoord4fv};
  constexpr RowId kMultiTexCoordARB[] = {kRowMultiTexCoord1fvARB, kRowMultiTexCoord2fvARB, kRowMultiTexCoord3fvARB,
                                         kRowMultiTexCoord4fvARB};
  constexpr RowId kVertex[] = {kRowVertex2fv, kRowVertex2fv, kRowVertex3fv, kRowVertex4fv};
  const unsigned last = size - 1;
  if (slot == kPosition) return kVertex[last];
  if (slot == kTexture) return kTexCoord[last];
  if (bit(slot) & kTextureSlots) return caps.multitexture_core ? kMultiTexCoord[last] : kMultiTexCoordARB[last];
  if (bit(slot) & kMaterialSlots) return kRowMaterialfv;
  switch (slot) {
    case kColor: return size < 4 ? kRowColor3fv : kRowColor4fv;
    case kSecondaryColor: return caps.secondary_color_core ? kRowSecondaryColor3fv : kRowSecondaryColor3fvEXT;
    case kNormal: return kRowNormal3fv;
    case kFogCoord: return caps.fog_coord_core ? kRowFogCoordfv : kRowFogCoordfvEXT;
    default: return kRowIndexfv;
  }
}

GLenum current_name(Slot slot) {
  switch (slot) {
    case kColor: return GL_CURRENT_COLOR;
    case kSecondaryColor: return GL_CURRENT_SECONDARY_COLOR;
    case kNormal: return GL_CURRENT_NORMAL;
    case kFogCoord: return GL_CURRENT_FOG_COORD;
    default: return GL_CURRENT_INDEX;
  }
}

Float4 read_current(const Driver& driver, const Caps& caps, Slot slot) {
  Float4 value{{0, 0, 0, 1}};
  if (bit(slot) & kMaterialSlots) {
    const MaterialName name = material_name(slot);
    driver.GetMaterialfv(name.face, name.property, value.at);
  } else if (bit(slot) & kTextureSlots) {
    with_texture_unit(driver, caps, slot - kTexture,
                      [&] { driver.GetFloatv(GL_CURRENT_TEXTURE_COORDS, value.at); });
  } else {
    driver.GetFloatv(current_name(slot), value.at);
  }
  return value;
}

bool can_be_read(const Caps& caps, Slot slot) {
  if (!caps.supported) return false;
  if (bit(slot) & kTextureSlots) return slot - kTexture < caps.texture_coords;
  if (slot == kSecondaryColor) return caps.secondary_color;
  if (slot == kFogCoord) return caps.fog_coord;
  return true;
}

bool same_everywhere(const Capture& c, Slot slot, const Quad& quad) {
  const unsigned first = quad.corner[0];
  for (unsigned place : quad.corner) {
    if (std::memcmp(&c.at[slot][place], &c.at[slot][first], sizeof(Float4))) return false;
  }
  return true;
}

// Flat shading takes the colours of one vertex: of a polygon the first, of other quads the last or, with
// GL_FIRST_VERTEX_CONVENTION, the first (GL 3.2 compatibility section 2.19, ARB_provoking_vertex). A strip's last
// vertex is corner C.
unsigned provoking_corner(const Capture& c) {
  if (c.mode == GL_POLYGON || c.view.first_vertex_provokes) return 0;
  return c.mode == GL_QUAD_STRIP ? 2 : 3;
}

// What every vertex of the quad has in common goes out once; the rest is returned.
SlotMask send_common(Capture& c, const Quad& quad, SlotMask channels) {
  SlotMask varying = 0;
  const unsigned provoking = quad.corner[provoking_corner(c)];
  for_each_slot(channels, [&](Slot slot) {
    if (c.view.flat && (bit(slot) & kFlatSlots)) replay_at(c, slot, provoking);
    else if (same_everywhere(c, slot, quad)) replay_at(c, slot, quad.corner[0]);
    else varying |= bit(slot);
  });
  return varying;
}

double length(const float (&x)[4]) { return std::sqrt(double(x[0]) * x[0] + double(x[1]) * x[1] + double(x[2]) * x[2]); }

// One attribute over the quad, at any (u, v).
class Channel {
 public:
  Channel(const Capture& c, const Caps& caps, Slot slot, const Quad& quad) : slot_(slot) {
    for (int i = 0; i < 4; ++i) corner_[i] = c.at[slot][quad.corner[i]];
    row_ = float_call(caps, slot, size());
    if ((slot == kColor || slot == kSecondaryColor) && !c.view.lighting) {
      // Unlit colours are clamped before they are interpolated (GL 2.1 section 2.14.6).
      for (Float4& x : corner_) {
        for (float& component : x.at) component = component > 0 ? (component < 1 ? component : 1) : 0;
      }
    }
    if (slot == kNormal) {
      for (int i = 0; i < 4; ++i) length_[i] = length(corner_[i].at);
    }
  }
  Slot slot() const { return slot_; }

  void send(const Driver& driver, const Float4& value) const { replay(driver, slot_, row_, value, kNoRaw); }

  Float4 at(Param p) const {
    Float4 value;
    for (int i = 0; i < 4; ++i) {
      value.at[i] = float(interpolate<double>(corner_[0].at[i], corner_[1].at[i], corner_[2].at[i], corner_[3].at[i],
                                              p.u, p.v));
    }
    if (slot_ == kNormal) {
      // Interpolation shortens normals; lighting without GL_NORMALIZE would darken the quad's middle.
      const double wanted = interpolate(length_[0], length_[1], length_[2], length_[3], p.u, p.v);
      const double has = length(value.at);
      if (has > 0) {
        for (int i = 0; i < 3; ++i) value.at[i] = float(value.at[i] * (wanted / has));
      }
    }
    return value;
  }

 private:
  // Components without those at the end that a shorter call would set to the same (GL 2.1 section 2.7). Drivers keep
  // vertices as large as the largest call made them.
  unsigned size() const {
    const auto all = [&](int component, float value) {
      return std::all_of(std::begin(corner_), std::end(corner_),
                         [&](const Float4& x) { return x.at[component] == value; });
    };
    if (!all(3, 1)) return 4;
    return !all(2, 0) ? 3 : !all(1, 0) ? 2 : 1;
  }

  Slot slot_;
  RowId row_;
  Float4 corner_[4];
  double length_[4] = {};
};

// The corner that a vertex of the parameter square is, or 4.
unsigned corner_at(Param p) {
  if ((p.u != 0 && p.u != 1) || (p.v != 0 && p.v != 1)) return 4;
  return p.v == 0 ? (p.u == 0 ? 0 : 1) : (p.u == 0 ? 3 : 2);
}

void draw_mesh(Capture& c, const Quad& quad) {
  const Driver& driver = *c.driver;
  const Caps& caps = c.entry->context->caps;
  Scratch& s = *c.scratch;
  const MeshSize size = mesh_size(s.plan);
  tessellate(s.plan, {s.params, size.vertices}, {s.triangles, size.triangles});

  const SlotMask varying = send_common(c, quad, c.live & kInterpolatedSlots);
  const Channel position(c, caps, kPosition, quad);
  alignas(Channel) unsigned char memory[kMaxChannels * sizeof(Channel)];
  Channel* const channels = reinterpret_cast<Channel*>(memory);
  unsigned count = 0;
  for_each_slot(varying, [&](Slot slot) { new (&channels[count++]) Channel(c, caps, slot, quad); });
  const unsigned stride = count + 1;

  // Each vertex is computed once, though a triangle list sends it several times.
  for (std::size_t i = 0; i < size.vertices; ++i) {
    Float4* const out = s.values + i * stride;
    out[0] = position.at(s.params[i]);
    for (unsigned k = 0; k < count; ++k) out[1 + k] = channels[k].at(s.params[i]);
  }
  if (!c.mesh_open) {
    driver.Begin(GL_TRIANGLES);
    c.mesh_open = true;
  }
  for (std::size_t t = 0; t < size.triangles; ++t) {
    for (const unsigned vertex : {s.triangles[t].a, s.triangles[t].b, s.triangles[t].c}) {
      const unsigned corner = corner_at(s.params[vertex]);
      if (corner < 4) {
        for (unsigned k = 0; k < count; ++k) replay_at(c, channels[k].slot(), quad.corner[corner]);
        replay_at(c, kPosition, quad.corner[corner]);
        continue;
      }
      const Float4* const values = s.values + vertex * stride;
      for (unsigned k = 0; k < count; ++k) channels[k].send(driver, values[1 + k]);
      position.send(driver, values[0]);
    }
  }
}

// The corners with their texture coordinates multiplied by lambda; `units`: those of the plan's sets, in order.
void draw_projected(Capture& c, const Quad& quad, unsigned units) {
  const Caps& caps = c.entry->context->caps;
  const Plan& plan = c.scratch->plan;
  close_mesh(c);
  const SlotMask projected = SlotMask(units) << kTexture;
  const SlotMask varying = send_common(c, quad, c.live & kInterpolatedSlots & ~projected);
  c.driver->Begin(GL_QUADS);
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned place = quad.corner[i];
    for_each_slot(varying, [&](Slot slot) { replay_at(c, slot, place); });
    unsigned set = 0;
    for_each_slot(projected, [&](Slot slot) {
      Float4 scaled;
      for (int k = 0; k < 4; ++k) scaled.at[k] = float(plan.lambda[set][i] * c.at[slot][place].at[k]);
      replay(*c.driver, slot, float_call(caps, slot, 4), scaled, kNoRaw);
      ++set;
    });
    replay_at(c, kPosition, place);
  }
  c.driver->End();
}

Corners corners_of(const Capture& c, Slot slot, const Quad& quad) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    const float(&x)[4] = c.at[slot][quad.corner[i]].at;
    corners[i] = {x[0], x[1], x[2], x[3]};
  }
  return corners;
}

// The texture sets for the plan: of the units that are enabled and take the program's coordinates.
struct Sets {
  Corners of[kTextureUnits];
  std::size_t count = 0;
  unsigned units = 0;
};

}  // namespace

void fill_absent(Capture& c, const Quad& quad, SlotMask slots) {
  SlotMask absent = 0;
  for (unsigned place : quad.corner) absent |= slots & ~c.present[place];
  if (!absent) return;
  const Caps& caps = caps_of(c);
  close_mesh(c);
  for_each_slot(absent, [&](Slot slot) {
    if (!can_be_read(caps, slot)) return;
    const Float4 value = read_current(*c.driver, caps, slot);
    for (unsigned place : quad.corner) {
      if (c.present[place] & bit(slot)) continue;
      c.at[slot][place] = value;
      c.row[slot][place] = float_call(caps, slot, 4);
      c.present[place] |= bit(slot);
    }
  });
}

Reason correct(Capture& c, const Quad& quad, SlotMask warped) {
  const Caps& caps = caps_of(c);
  if (!c.view_read) {
    close_mesh(c);
    read_view(*c.driver, caps, c.view);
    c.view_read = true;
  }
  if (c.view.pass != Reason::kNone) return c.view.pass;
  if (c.extensions_used & ~caps.extensions) return Reason::kMissingExtension;
  if (c.live & kGenericSlots) return Reason::kGenericAttribute;

  const unsigned live_units = unsigned((c.live & kTextureSlots) >> kTexture);
  if (live_units & ~c.view.units_read) {
    close_mesh(c);
    read_units(*c.driver, caps, live_units, c.view);
  }
  const unsigned warped_units = unsigned(warped >> kTexture) & c.view.units_enabled;
  if (!warped_units) return Reason::kTexturingOff;
  if (!(warped_units & ~c.view.units_generated)) return Reason::kTextureGeneration;

  fill_absent(c, quad, c.live & kInterpolatedSlots);
  Sets sets;
  sets.units = live_units & c.view.units_enabled & ~c.view.units_generated;
  for_each_slot(SlotMask(sets.units) << kTexture, [&](Slot slot) {
    sets.of[sets.count++] = corners_of(c, slot, quad);
  });
  for (std::size_t i = 0; i < sets.count; ++i) {
    for (const Vec4& x : sets.of[i]) {
      if (x.w != 1) return Reason::kOwnQ;
    }
  }

  Scratch* const scratch = scratch_of(c);
  if (!scratch) return Reason::kNoMemory;
  Plan& result = scratch->plan;
  Limits limits;
  limits.tolerance_px = c.options->tolerance_px;
  limits.max_triangles = kTriangleCap;
  plan(corners_of(c, kPosition, quad), {sets.of, sets.count}, c.view.view, limits, c.options->mode, result);
  switch (result.action) {
    case Action::kPass: return reason_of(result.reason);
    case Action::kProject: draw_projected(c, quad, sets.units); break;
    case Action::kMesh: draw_mesh(c, quad); break;
  }
  c.counters.correct(result.triangles, result.bound_px, result.capped);
  if (c.options->overlay) {
    close_mesh(c);
    draw_overlay(c, quad, result, {scratch->params, std::size(scratch->params)},
                 {scratch->triangles, std::size(scratch->triangles)});
  }
  return Reason::kNone;
}

}  // namespace truequad
