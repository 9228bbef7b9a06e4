#include "capture/draw.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "capture/lights.h"
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

namespace {

// What only lighting looks at, or replaces.
constexpr SlotMask kLitSlots = bit(kColor) | bit(kSecondaryColor) | kMaterialSlots;

// What every vertex of the quad has in common goes out once; the rest is returned.
SlotMask send_common(Capture& c, const Quad& quad, SlotMask channels, SlotMask flat) {
  SlotMask varying = 0;
  const unsigned provoking = quad.corner[provoking_corner(c)];
  for_each_slot(channels, [&](Slot slot) {
    if (flat & bit(slot)) replay_at(c, slot, provoking);
    else if (same_everywhere(c, slot, quad)) replay_at(c, slot, quad.corner[0]);
    else varying |= bit(slot);
  });
  return varying;
}

double length(const float (&x)[4]) { return std::sqrt(double(x[0]) * x[0] + double(x[1]) * x[1] + double(x[2]) * x[2]); }

// One attribute over the quad, at any (u, v).
class Channel {
 public:
  // What the program gave.
  Channel(const Capture& c, const Caps& caps, Slot slot, const Quad& quad) : slot_(slot) {
    for (int i = 0; i < 4; ++i) corner_[i] = c.at[slot][quad.corner[i]];
    row_ = float_call(caps, slot, size());
    for (unsigned place : quad.corner) longer_ |= kRows[c.row[slot][place]].size < kRows[row_].size;
    if ((slot == kColor || slot == kSecondaryColor) && !c.view.lighting && c.view.clamps_colours) {
      // Unlit colours are clamped before they are interpolated (GL 2.1 section 2.14.6).
      for (Float4& x : corner_) clamp_colour(x);
    }
    if (slot == kNormal) {
      for (int i = 0; i < 4; ++i) length_[i] = length(corner_[i].at);
    }
  }
  // What lighting made of it.
  Channel(const Caps& caps, Slot slot, const Float4 (&corner)[4]) : slot_(slot), row_(float_call(caps, slot, 4)) {
    for (int i = 0; i < 4; ++i) corner_[i] = corner[i];
  }
  Slot slot() const { return slot_; }
  // Our calls give more components than the program's.
  bool longer() const { return longer_; }

  bool varies() const {
    return std::any_of(corner_ + 1, corner_ + 4,
                       [&](const Float4& x) { return std::memcmp(&x, &corner_[0], sizeof x) != 0; });
  }

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
  bool longer_ = false;
  Float4 corner_[4];
  double length_[4] = {};
};

// The corner that a vertex of the parameter square is, or 4.
unsigned corner_at(Param p) {
  if ((p.u != 0 && p.u != 1) || (p.v != 0 && p.v != 1)) return 4;
  return p.v == 0 ? (p.u == 0 ? 0 : 1) : (p.u == 0 ? 3 : 2);
}

// All that differs between the vertices of a mesh, the position apart. What the program gave comes first, then the lit
// colours: of one side, or of the front and then of the back.
struct Channels {
  alignas(Channel) unsigned char memory[Scratch::kMaxChannels * sizeof(Channel)];
  unsigned given = 0;
  unsigned lit_first[2] = {}, lit_count = 0;  // by side; for each
  unsigned count = 0;

  template <typename... Arguments>
  void add(const Arguments&... arguments) {
    new (memory + count++ * sizeof(Channel)) Channel(arguments...);
  }
  const Channel& operator[](unsigned i) const {
    return *std::launder(reinterpret_cast<const Channel*>(memory + i * sizeof(Channel)));
  }
};

void add_lit(const Driver& driver, const Caps& caps, const LitCorners& lit, Channels& out) {
  const bool both = lit.side[kFront] && lit.side[kBack];
  for (const Side side : {kFront, kBack}) {
    if (!lit.side[side]) continue;
    out.lit_first[side] = out.count;
    const auto add = [&](Slot slot, const Float4(&corners)[4]) {
      const Channel channel(caps, slot, corners);
      if (both || channel.varies()) out.add(channel);
      else channel.send(driver, corners[0]);
    };
    add(kColor, lit.primary[side]);
    if (lit.separate) add(kSecondaryColor, lit.secondary[side]);
    out.lit_count = out.count - out.lit_first[side];
  }
  if (!lit.side[kFront]) out.lit_first[kFront] = out.lit_first[kBack];
  if (!lit.side[kBack]) out.lit_first[kBack] = out.lit_first[kFront];
}

}  // namespace

void draw_mesh(Capture& c, const Quad& quad) {
  const Driver& driver = *c.driver;
  const Caps& caps = c.entry->context->caps;
  Scratch& s = *c.scratch;
  const MeshSize size = mesh_size(s.plan);
  tessellate(s.plan, {s.params, size.vertices}, {s.triangles, size.triangles});

  LitCorners lit;
  const bool own_light = c.view.lighting && light_corners(c, quad, lit);
  if (c.mesh_unlit != own_light) close_mesh(c);
  if (own_light && !c.mesh_unlit) begin_unlit(c);
  const SlotMask sent = c.live & kInterpolatedSlots & ~(own_light ? kLitSlots : 0);
  // Without lighting, normals serve to generate texture coordinates, which are not flat.
  const SlotMask flat = !c.view.flat ? 0 : c.view.lighting && !own_light ? kFlatSlots | bit(kNormal) : kFlatSlots;
  const SlotMask varying = send_common(c, quad, sent, flat);
  const Channel position(c, caps, kPosition, quad);
  Channels channels;
  for_each_slot(varying, [&](Slot slot) {
    channels.add(c, caps, slot, quad);
    c.calls_grew |= channels[channels.count - 1].longer();
  });
  channels.given = channels.count;
  if (own_light) add_lit(driver, caps, lit, channels);
  const unsigned stride = channels.count + 1;

  // Each vertex is computed once, though a triangle list sends it several times.
  for (std::size_t i = 0; i < size.vertices; ++i) {
    Float4* const out = s.values + i * stride;
    out[0] = position.at(s.params[i]);
    for (unsigned k = 0; k < channels.count; ++k) out[1 + k] = channels[k].at(s.params[i]);
  }
  if (!c.mesh_open) {
    driver.Begin(GL_TRIANGLES);
    c.mesh_open = true;
  }
  for (std::size_t t = 0; t < size.triangles; ++t) {
    const Triangle& triangle = s.triangles[t];
    unsigned lit_first = channels.lit_first[kFront];
    if (channels.lit_first[kBack] != lit_first) {
      lit_first = channels.lit_first[side_of(c, s.values[triangle.a * stride], s.values[triangle.b * stride],
                                             s.values[triangle.c * stride])];
    }
    for (const unsigned vertex : {triangle.a, triangle.b, triangle.c}) {
      const unsigned corner = corner_at(s.params[vertex]);
      const Float4* const values = s.values + vertex * stride;
      for (unsigned k = 0; k < channels.given; ++k) {
        if (corner < 4 && !channels[k].longer()) replay_at(c, channels[k].slot(), quad.corner[corner]);
        else channels[k].send(driver, values[1 + k]);
      }
      for (unsigned k = lit_first; k < lit_first + channels.lit_count; ++k) channels[k].send(driver, values[1 + k]);
      if (corner < 4) replay_at(c, kPosition, quad.corner[corner]);
      else position.send(driver, values[0]);
    }
  }
}

void draw_projected(Capture& c, const Quad& quad, unsigned units) {
  const Caps& caps = c.entry->context->caps;
  const Plan& plan = c.scratch->plan;
  if (c.mesh_open) close_mesh(c);
  const SlotMask projected = SlotMask(units) << kTexture;
  const SlotMask varying = send_common(c, quad, c.live & kInterpolatedSlots & ~projected, 0);
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
  c.calls_grew |= projected != 0;
}

// Mesa (vbo_exec_fixup_vertex) sets the components that a call does not give to their defaults when a call is shorter than
// the last one. But if calls became shorter before, and then longer again, it does not see that they become shorter once
// more, and the program's current values keep components of ours. Any change of state lets it begin anew.
void end_batch(Capture& c) {
  const Driver& driver = *c.driver;
  const Caps& caps = c.entry->context->caps;
  c.calls_grew = false;
  if (!caps.multitexture || caps.texture_units < 2) return;
  GLint before = GL_TEXTURE0;
  driver.GetIntegerv(GL_ACTIVE_TEXTURE, &before);
  const GLenum other = before == GL_TEXTURE0 ? GL_TEXTURE1 : GL_TEXTURE0;
  for (const GLenum texture : {other, GLenum(before)}) {
    if (caps.multitexture_core) driver.ActiveTexture(texture);
    else driver.ActiveTextureARB(texture);
  }
}

}  // namespace truequad
