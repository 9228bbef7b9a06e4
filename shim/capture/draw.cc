#include "capture/draw.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "capture/replay.h"
#include "capture/scratch.h"

namespace truequad {

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

namespace {

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

}  // namespace

void draw_mesh(Capture& c, const Quad& quad) {
  const Driver& driver = *c.driver;
  const Caps& caps = c.entry->context->caps;
  Scratch& s = *c.scratch;
  const MeshSize size = mesh_size(s.plan);
  tessellate(s.plan, {s.params, size.vertices}, {s.triangles, size.triangles});

  const SlotMask varying = send_common(c, quad, c.live & kInterpolatedSlots);
  const Channel position(c, caps, kPosition, quad);
  alignas(Channel) unsigned char memory[Scratch::kMaxChannels * sizeof(Channel)];
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

void draw_projected(Capture& c, const Quad& quad, unsigned units) {
  const Caps& caps = c.entry->context->caps;
  const Plan& plan = c.scratch->plan;
  close_mesh(c);
  const SlotMask projected = SlotMask(units) << kTexture;
  const SlotMask varying = send_common(c, quad, c.live & kInterpolatedSlots & ~projected);
  // In the program's own mode: drivers choose the diagonal by it, and with the diagonal the depths.
  constexpr unsigned kInOrder[] = {0, 1, 2, 3}, kInStrip[] = {0, 1, 3, 2};
  c.driver->Begin(c.mode);
  for (const unsigned i : c.mode == GL_QUAD_STRIP ? kInStrip : kInOrder) {
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

}  // namespace truequad
