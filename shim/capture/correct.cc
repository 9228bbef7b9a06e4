#include "capture/correct.h"

#include <cstdlib>
#include <cstring>
#include <new>

#include "capture/colours.h"
#include "capture/draw.h"
#include "capture/drawn.h"
#include "capture/overlay.h"
#include "capture/scratch.h"

namespace truequad {
namespace {

Scratch* scratch_of(Capture& c) {
  // Pages that no mesh is large enough to touch are never backed by memory.
  if (!c.scratch) {
    void* memory = std::aligned_alloc(64, (sizeof(Scratch) + 63) / 64 * 64);
    if (memory) c.scratch = new (memory) Scratch;
  }
  return c.scratch;
}


// Why no quad of this Begin can be drawn otherwise; the view is read first. kNone: it can.
Reason find_reason(Capture& c) {
  const Caps& caps = caps_of(c);
  if (!c.view_read) {
    close_mesh(c);
    read_view(*c.driver, caps, c.view);
    c.view_read = true;
  }
  if (c.view.pass != Reason::kNone) return c.view.pass;
  if (c.live & kGenericSlots) return Reason::kGenericAttribute;
  return Reason::kNone;
}

// Units whose coordinates the program gives and the driver uses.
unsigned textured_units(Capture& c) {
  const unsigned live_units = unsigned((c.live & kTextureSlots) >> kTexture);
  if (live_units & ~c.view.units_read) {
    close_mesh(c);
    read_units(*c.driver, caps_of(c), live_units, c.view);
  }
  return live_units & c.view.units_enabled & ~c.view.units_generated;
}

// The texture coordinates of a plan, as the kernel takes them.
struct Sets {
  Corners of[kTextureUnits];
  std::size_t count = 0;

  explicit Sets(const PlannedFor& from) {
    for_each_slot(SlotMask(from.units), [&](unsigned unit) {
      Corners& corners = of[count++];
      for (int i = 0; i < 4; ++i) {
        const float(&x)[4] = from.texture[unit][i].at;
        corners[i] = {x[0], x[1], x[2], x[3]};
      }
    });
  }
  std::span<const Corners> all() const { return {of, count}; }
};

// And its colours.
struct Channels {
  ColourChannel of[kMaxColourChannels];
  std::size_t count = 0;

  explicit Channels(const PlannedFor& from) {
    for (; count < from.colours; ++count) {
      const float(&x)[4] = from.colour[count];
      of[count] = {x[0], x[1], x[2], x[3]};
    }
  }
  std::span<const ColourChannel> all() const { return {of, count}; }
};

Corners positions_of(const Capture& c, const Quad& quad) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    const float(&x)[4] = c.at[kPosition][quad.corner[i]].at;
    corners[i] = {x[0], x[1], x[2], x[3]};
  }
  return corners;
}

PlannedFor own_sets(Capture& c, const Quad& quad) {
  PlannedFor sets;
  sets.depth_clamped = c.view.view.depth_clamped;
  sets.units = textured_units(c);
  for_each_slot(SlotMask(sets.units), [&](unsigned unit) {
    for (int i = 0; i < 4; ++i) sets.texture[unit][i] = c.at[kTexture + unit][quad.corner[i]];
  });
  find_colours(c, quad, sets);
  return sets;
}

bool same_sets(const PlannedFor& a, const PlannedFor& b) {
  bool same = a.depth_clamped == b.depth_clamped && a.units == b.units && a.colours == b.colours &&
              !std::memcmp(a.colour, b.colour, a.colours * sizeof a.colour[0]);
  for_each_slot(SlotMask(a.units), [&](unsigned unit) {
    same = same && !std::memcmp(a.texture[unit], b.texture[unit], sizeof a.texture[unit]);
  });
  return same;
}

// Colours, normals and so on: of numbers that are not finite drivers make what they like, and not the same inside a quad.
bool attributes_finite(const Capture& c, const Quad& quad) {
  float zero = 0;
  for_each_slot(c.live & kInterpolatedSlots, [&](Slot slot) {
    for (unsigned corner : quad.corner) {
      for (float x : c.at[slot][corner].at) zero += 0 * x;
    }
  });
  return zero == 0;
}

bool gives_own_q(const PlannedFor& sets) {
  bool own = false;
  for_each_slot(SlotMask(sets.units), [&](unsigned unit) {
    for (const Float4& x : sets.texture[unit]) own |= x.at[3] != 1;
  });
  return own;
}

Limits limits_of(const Capture& c) {
  Limits limits;
  limits.tolerance_px = c.settings.tolerance_px;
  limits.max_triangles = Scratch::kTriangleCap;
  return limits;
}

void plan_for(Capture& c, const Quad& quad, const PlannedFor& sets) {
  View view = c.view.view;
  view.depth_clamped = sets.depth_clamped;
  plan(positions_of(c, quad), Sets(sets).all(), view, limits_of(c), c.settings.mode, c.scratch->plan, Channels(sets).all());
}

// The plan's mesh, drawn with these.
void bound_for(Capture& c, const Quad& quad, const PlannedFor& sets) {
  bound_mesh(positions_of(c, quad), Sets(sets).all(), c.view.view, limits_of(c), c.scratch->plan, Channels(sets).all());
}

// What nothing but the quad itself and its texture units decides.
Reason find_reason(Capture& c, const PlannedFor& sets, SlotMask warped) {
  const unsigned warped_units = unsigned(warped >> kTexture) & c.view.units_enabled;
  if (!warped_units) return Reason::kTexturingOff;
  if (!(warped_units & ~c.view.units_generated)) return Reason::kTextureGeneration;
  if (gives_own_q(sets)) return Reason::kOwnQ;
  return Reason::kNone;
}

Drawn* memory_of(Capture& c) {
  if (!c.drawn) c.drawn = Drawn::allocate();
  return c.drawn;
}

// Two triangles of these vertices are in the buffers, and a mesh would miss them; or they may be.
bool must_meet_triangles(const Capture& c, PassKey positions, PassKey seen) {
  if (c.view.equals_earlier) return true;
  if (!c.view.meets_earlier || !c.drawn) return false;
  // Without room for one more, the passes that follow would have to draw triangles again.
  if (passes_meet() && (c.unnoted || (c.view.meets_later && !c.drawn->can_keep(seen)))) return true;
  return c.drawn->has_triangles(positions) || c.drawn->has_triangles(seen);
}

void draw(Capture& c, const Quad& quad, unsigned units) {
  Plan& plan = c.scratch->plan;
  if (c.before_draw) c.before_draw(c);
  if (plan.action == Action::kMesh) draw_mesh(c, quad);
  else draw_projected(c, quad, units);
  c.counters.correct(plan.triangles, plan.bound_px, plan.bound_steps, plan.capped);
  if (c.options->overlay) {
    close_mesh(c);
    draw_overlay(c, quad, plan, {c.scratch->params, std::size(c.scratch->params)},
                 {c.scratch->triangles, std::size(c.scratch->triangles)});
  }
}

}  // namespace

const Caps& caps_of(Capture& c) {
  ContextRecord& record = *c.entry->context;
  if (!record.caps_read) close_mesh(c);
  return caps_of(record, *c.driver);
}

Reason correct(Capture& c, const Quad& quad, SlotMask warped, bool colours) {
  if (const Reason reason = find_reason(c); reason != Reason::kNone) return reason;
  if (!scratch_of(c)) return Reason::kNoMemory;
  Plan& plan = c.scratch->plan;

  const PassKey positions = positions_key(c, quad), seen = with_view(positions, c.view.view);
  const PlannedFor* const before = c.drawn ? c.drawn->mesh(seen) : nullptr;
  if (!before && !warped && !colours && !(c.drawn && c.drawn->wanted(positions))) return Reason::kAffine;

  fill_absent(c, quad, c.live & kInterpolatedSlots);
  PlannedFor sets = own_sets(c, quad);
  if (before) {
    plan_for(c, quad, *before);
    if (same_sets(sets, *before)) {
      c.drawn->meet_wish(positions);
    } else {
      bound_for(c, quad, sets);
      if (plan.capped && c.drawn->wish_is_stale(positions)) {
        sets.key = positions;
        c.drawn->want_mesh(sets);
      }
    }
    draw(c, quad, sets.units);
    return Reason::kNone;
  }
  if (!attributes_finite(c, quad)) return Reason::kNotFinite;
  const Reason reason = warped ? find_reason(c, sets, warped) : Reason::kAffine;
  // The program's own q would be interpolated otherwise; what is not textured by it is right in any mesh.
  if (reason == Reason::kNone || (sets.colours > 0 && reason != Reason::kOwnQ)) {
    plan_for(c, quad, sets);
    if (plan.action == Action::kPass) {
      const bool nothing = plan.reason == PassReason::kAffine || plan.reason == PassReason::kConstant;
      return nothing && reason != Reason::kNone ? reason : reason_of(plan.reason);
    }
    if (plan.action == Action::kMesh && must_meet_triangles(c, positions, seen)) {
      sets.key = positions;
      if (memory_of(c)) c.drawn->want_mesh(sets);
      return Reason::kEarlierPass;
    }
  } else {
    // A later pass will want a mesh, as it did in an earlier frame.
    const PlannedFor* const wanted = c.drawn && c.view.meets_later ? c.drawn->wanted(positions) : nullptr;
    if (!wanted || must_meet_triangles(c, positions, seen)) return reason;
    sets = *wanted;
    plan_for(c, quad, sets);
    if (plan.action != Action::kMesh) return reason;
    c.drawn->use_wish(positions);
    bound_for(c, quad, own_sets(c, quad));
  }
  if (plan.action == Action::kMesh && c.view.meets_later && memory_of(c)) {
    sets.key = seen;
    c.drawn->keep_mesh(positions, sets);
    c.watch = Watch::kMeshes;
    c.textures_alone = false;
  } else if (plan.action == Action::kProject && c.watch != Watch::kNothing) {
    c.drawn->note_triangles(seen);
  }
  draw(c, quad, sets.units);
  return Reason::kNone;
}

void note_triangles(Capture& c, const Quad& quad) {
  const PassKey positions = positions_key(c, quad);
  const bool view_known = c.view_read && c.view.pass == Reason::kNone;
  c.drawn->note_triangles(view_known ? with_view(positions, c.view.view) : positions);
}

void free_working_memory(Capture& c) {
  std::free(c.scratch);
  Drawn::free(c.drawn);
}

}  // namespace truequad
