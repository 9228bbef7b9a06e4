// The states of a primitive between glBegin and glEnd: "write through, then cut" (docs/semantics.md).
//
// Open: calls are forwarded at once, and the vertex that completes a quad is looked at first. If the quad may need
// correction, the driver's Begin is cut: "if a quad is begun but not completed, the extra vertices are ignored"
// (GL 2.1 section 2.6.1), so glEnd drops exactly the vertices that we still have. Held: nothing is forwarded until a
// quad turns out not to need correction.
#include <cstring>

#include "capture/capture.h"
#include "capture/colours.h"
#include "capture/correct.h"
#include "capture/drawn.h"
#include "capture/list_compile.h"
#include "capture/quads.h"
#include "capture/relist.h"
#include "capture/replay.h"
#include "capture/state.h"
#include "kernel/affine_fast.h"

namespace truequad {
namespace {

void set(Capture& c, State state, SlotMask live) {
  c.state = state;
  c.live = live;
  c.forwarding = state != State::kHeld;
  c.forwarded = c.forwarding ? live : 0;
  c.usual = state == State::kOpen && c.textures_alone && c.mode != GL_POLYGON;
  c.usual_vertex = c.usual && live == bit(kTexture);
}
void set_state(Capture& c, State state) { set(c, state, c.live); }

void pass(Capture& c, Reason reason) {
  c.counters.pass(reason);
}

// Vertices v0 v1 v2 v3 of a strip make the quad v0 v1 v3 v2 (GL 2.1 figure 2.4).
constexpr Quad kStripQuad = {{0, 1, 3, 2}}, kOtherStripQuad = {{2, 3, 1, 0}};

Quad completed_quad(const Capture& c) {
  if (c.mode != GL_QUAD_STRIP) return {{0, 1, 2, 3}};
  return c.due == 3 ? kStripQuad : kOtherStripQuad;
}

bool same_value(const Capture& c, Slot slot, unsigned a, unsigned b) {
  return c.row[slot][a] == c.row[slot][b] && !std::memcmp(&c.at[slot][a], &c.at[slot][b], sizeof(Float4)) &&
         (!(c.raw_kept & bit(slot)) || !std::memcmp(&c.raw[slot][a], &c.raw[slot][b], sizeof(Raw)));
}
bool now_is(const Capture& c, Slot slot, unsigned place) {
  return c.now_row[slot] == c.row[slot][place] && !std::memcmp(&c.now[slot], &c.at[slot][place], sizeof(Float4)) &&
         (!(c.raw_kept & bit(slot)) || !std::memcmp(&c.now_raw[slot], &c.raw[slot][place], sizeof(Raw)));
}

// Held to open: the program's glBegin, the vertices of the window, and what was set after the last of them.
void materialise(Capture& c) {
  close_mesh(c);
  begin_in_driver(c);
  c.began = true;
  set_state(c, State::kOpen);
  const WindowOrder window = window_order(c);
  SlotMask known = 0;
  unsigned previous = 0;
  for (unsigned i = 0; i < window.count; ++i) {
    const unsigned place = window[i];
    for_each_slot(c.present[place], [&](Slot slot) {
      if (!(known & bit(slot)) || !same_value(c, slot, place, previous)) replay_at(c, slot, place);
    });
    replay_at(c, kPosition, place);
    known = c.present[place];
    previous = place;
  }
  for_each_slot(c.live, [&](Slot slot) {
    if (!(known & bit(slot)) || !now_is(c, slot, previous)) replay_now(c, slot);
  });
}

}  // namespace

void cut(Capture& c) {
  end_in_driver(c);
  c.counters.flushes.add(1);
  set_state(c, State::kHeld);
}

namespace {

Corners corners_of(const Capture& c, Slot slot, const Quad& quad) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    const float(&x)[4] = c.at[slot][quad.corner[i]].at;
    corners[i] = {x[0], x[1], x[2], x[3]};
  }
  return corners;
}

bool surely_affine(const Capture& c, Slot texture, const Quad& quad) {
  alignas(16) float position[4][4], coordinates[4][4];
  for (int i = 0; i < 4; ++i) {
    std::memcpy(position[i], c.at[kPosition][quad.corner[i]].at, sizeof position[i]);
    std::memcpy(coordinates[i], c.at[texture][quad.corner[i]].at, sizeof coordinates[i]);
  }
  return truequad::surely_affine(position, coordinates);
}

}  // namespace

bool parallelogram(const Capture& c, const Quad& quad) { return surely_affine(c, kPosition, quad); }

Reason judge(Capture& c, const Quad& quad, SlotMask& warped) {
  const SlotMask textures = c.live & kTextureSlots;
  if (!textures) return Reason::kNoTextureVaries;
  SlotMask open_question = 0;
  for_each_slot(textures, [&](Slot slot) {
    if (!surely_affine(c, slot, quad)) open_question |= bit(slot);
  });
  if (!open_question) return Reason::kAffine;

  const Corners position = corners_of(c, kPosition, quad);
  Reason reason = Reason::kAffine;
  warped = 0;
  for (SlotMask rest = open_question; rest; rest &= rest - 1) {
    const Slot slot = Slot(std::countr_zero(rest));
    const Corners texture[] = {corners_of(c, slot, quad)};
    switch (classify(position, texture)) {
      case Shape::kNotFinite: return Reason::kNotFinite;
      case Shape::kDegenerate: reason = Reason::kDegenerate; break;
      case Shape::kConstant:
        if (open_question == textures) reason = Reason::kNoTextureVaries;
        break;
      case Shape::kAffine: break;
      case Shape::kWarped: warped |= bit(slot); break;
    }
  }
  return warped ? Reason::kNone : reason;
}

bool may_be_mesh(const Capture& c, const Quad& quad) {
  return c.watch == Watch::kMeshes && c.drawn->may_be_mesh(positions_key(c, quad));
}

namespace {

void count_listed(Capture& c) {
  if (c.listing || c.entry->playing) c.counters.listed.add(c.counters.quads() - c.counted_before);
}

// From here on this primitive is kept with the list: its quads may need correction in some view. False without memory.
bool keep_from_here(Capture& c) {
  Entry& e = *c.entry;
  if (c.state == State::kOpen) c.driver->End();
  const bool inside = e.inside;
  e.inside = false;
  const bool ended = end_driver_part(e);
  e.inside = inside;
  if (!ended) {
    // Without memory: the driver's, from its last whole quad on.
    if (c.state == State::kOpen) set_state(c, State::kHeld);
    return false;
  }
  c.driver = e.driver;
  materialise(c);
  count_listed(c);
  set_active(e, nullptr);
  return true;
}

// The same while a list is compiled: true if the quad's last vertex is to be forwarded.
bool settle_listed(Capture& c, const Quad& quad) {
  SlotMask warped = 0;
  Reason reason = Reason::kNone;
  SlotMask absent = 0;
  for (unsigned place : quad.corner) absent |= c.live & kTextureSlots & ~c.present[place];
  if (!absent) reason = judge(c, quad, warped);
  // Where passes meet, a quad without texture must be able to become a mesh later.
  const bool may_meet = passes_meet() && (reason == Reason::kAffine || reason == Reason::kNoTextureVaries) &&
                        !parallelogram(c, quad);
  // Whether it will be lit, and how, is not known yet.
  const bool wanted = reason == Reason::kNone || may_meet || c.options->color;
  if (wanted && keep_from_here(c)) return false;
  pass(c, reason == Reason::kNone ? Reason::kDisplayList : reason);
  if (c.state == State::kOpen) return true;
  materialise(c);
  return false;
}

// Decides on the completed quad, draws it if it needs correction, counts it. True: forward its last vertex; then the
// capture is open or passive. False: the driver has the quad; held if it was corrected, else open.
bool settle(Capture& c, const Quad& quad) {
  ++c.quads;
  if (c.state == State::kPassive) {
    pass(c, c.passive_reason);
    if (c.watch != Watch::kNothing) note_triangles(c, quad);
    return true;
  }
  if (c.listing) return settle_listed(c, quad);
  if (c.state == State::kHeld) fill_absent(c, quad, c.live & c.judged);
  SlotMask warped = 0;
  Reason reason = judge(c, quad, warped);
  const bool colours = colours_may_kink(c, quad);
  const bool needs_look = reason == Reason::kNone || colours || may_be_mesh(c, quad);
  if (needs_look && c.view_read && c.view.pass != Reason::kNone) {
    if (reason == Reason::kNone || colours) reason = c.view.pass;
  } else if (needs_look) {
    if (c.state == State::kOpen) cut(c);
    const Reason found = correct(c, quad, warped, colours);
    if (found == Reason::kNone) {
      c.corrected = true;
      return false;
    }
    if (reason == Reason::kNone || (colours && found != Reason::kAffine)) reason = found;
  }
  pass(c, reason);
  if (c.watch != Watch::kNothing) note_triangles(c, quad);
  if (c.state == State::kOpen) return true;
  materialise(c);
  return false;
}

// A vertex of a polygon at place 3 or later. Polygons start held: four vertices can still become more.
bool polygon_vertex(Capture& c) {
  if (c.next == 4) {
    c.due = 4;
    return c.forwarding;
  }
  // The fifth and further ones: no quad. The new vertex is in place 4, and goes out with the others.
  const bool held = c.state == State::kHeld;
  if (held) materialise(c);
  set(c, State::kPassive, ~SlotMask(0));
  c.extensions = ~0u;
  c.next = 4;  // further vertices overwrite it
  c.quads = 1;  // one shape, and not ours: nothing is left to count
  return !held;
}

[[gnu::noinline]] bool finish_quad(Capture& c) {
  if (c.mode == GL_POLYGON) return polygon_vertex(c);
  const bool forward = settle(c, completed_quad(c));
  next_quad(c);
  return forward;
}

// A window that ends here as an incomplete quad, dropped by GL.
bool leftover(const Capture& c) {
  const unsigned count = window_order(c).count;
  if (c.mode == GL_QUAD_STRIP) return c.quads > 0 ? count > 2 : count > 0;
  return c.mode == GL_QUADS && count > 0;
}

// Neither corrects nor counts.
bool is_idle(const Options& options) { return options.mode == Mode::kOff && options.stats_path[0] == '\0'; }

// Why quads cannot be captured now; kNone: they can.
Reason passive_reason(const Entry& e, const Settings& settings, GLenum mode) {
  if (settings.mode == Mode::kOff) return Reason::kModeOff;
  if (!(settings.primitives >> mode & 1)) return Reason::kPrimitiveOff;
  if (!e.context || (e.context->caps_read && !e.context->caps.supported)) return Reason::kUnknownContext;
  if (e.list && (!e.context->group || !e.list->driver_open)) return Reason::kDisplayList;
  return Reason::kNone;
}

// What to watch for in this Begin.
Watch watch(Capture& c, Reason reason) {
  // In a list nothing is drawn yet; in a context that is unknown nothing was corrected.
  if (reason != Reason::kNone) return Watch::kNothing;
  if (!c.drawn && passes_meet()) c.drawn = Drawn::allocate();
  if (!c.drawn) return Watch::kNothing;
  return c.drawn->any_mesh() ? Watch::kMeshes : passes_meet() ? Watch::kTriangles : Watch::kNothing;
}

}  // namespace

void start(Capture& c, const Entry& e, GLenum mode) {
  c.settings = c.chosen;
  const Reason reason = passive_reason(e, c.settings, mode);
  c.mode = mode;
  c.driver = e.driver;
  c.next = 0;
  c.due = 3;
  c.turn = mode == GL_QUAD_STRIP ? 2 : 0;
  c.order = mode == GL_QUAD_STRIP ? kStrip : kAround;
  c.raw_kept = 0;
  c.extensions = e.context && e.context->caps_read ? e.context->caps.extensions : 0;
  c.quads = 0;
  c.began = c.mesh_open = c.mesh_unlit = c.calls_grew = c.corrected = c.view_read = c.elements_found = false;
  c.listing = e.list != nullptr;
  c.watch = c.listing ? Watch::kNothing : watch(c, reason);
  if (c.watch == Watch::kNothing && !c.listing) c.unnoted = true;
  if (c.listing || e.playing) c.counted_before = c.counters.quads();
  c.relist = relist_name(e, mode);
  c.lights_read = LightsRead::kNothing;
  const bool color = c.options->color && reason == Reason::kNone;
  c.judged = color ? kInterpolatedSlots : kTextureSlots;
  c.lit = color && !c.listing && caps_of(*e.context, *c.driver).supported && c.driver->IsEnabled(GL_LIGHTING);
  c.textures_alone = !color && c.watch == Watch::kNothing;
  if (reason != Reason::kNone) {
    c.passive_reason = reason;
    c.extensions = ~0u;
    set(c, State::kPassive, ~SlotMask(0));
  } else {
    // In a list the first quad is held: Mesa draws a lone quad of three vertices that is compiled.
    set(c, mode == GL_POLYGON || c.start_held || c.listing || c.relist ? State::kHeld : State::kOpen, 0);
  }
}

Capture* capturing_thread(Entry& e) {
  if (e.own) return e.own;
  return is_idle(options()) ? nullptr : allocate_capture(e);
}

bool quad_complete(Capture& c) {
  if (c.usual && (c.live & kTextureSlots) == bit(kTexture) && usual_quad(c)) [[likely]] return true;
  return finish_quad(c);
}

namespace {

// A value that earlier vertices of the window still need was overwritten in the driver by a call that was forwarded.
bool value_lost(const Capture& c) {
  const WindowOrder window = window_order(c);
  for (unsigned i = 0; i < window.count; ++i) {
    if (c.live & ~c.present[window[i]]) return true;
  }
  return false;
}

}  // namespace

void set_first(Capture& c, Slot slot) {
  const WindowOrder window = window_order(c);
  const SlotMask live = c.live | bit(slot);
  // Without texture coordinates (or colours) no quad is corrected: what its earlier vertices had does not matter.
  if (c.state == State::kOpen && window.count > 0 && (live & c.judged)) {
    if (c.listing) {
      // What the earlier vertices have will be known when the list is called. Nothing is lost: this is the first such slot.
      if (keep_from_here(c)) return set(c, c.state, live);
      abandon(c, Reason::kDisplayList);
      return;
    }
    if (value_lost(c)) return abandon(c, Reason::kUnmodelledCall);
    // The driver still has the value of the earlier vertices, and keeps it while we hold what follows.
    cut(c);
  }
  set(c, c.state, live);
}

void use_extension(Capture& c, unsigned extension) {
  const std::uint32_t wanted = 1u << extension;
  ContextRecord& context = *c.entry->context;
  if (!context.caps_read && !c.listing && (c.state == State::kHeld || !value_lost(c))) {
    if (c.state == State::kOpen) cut(c);
    close_mesh(c);
    caps_of(context, *c.driver);
  }
  if (context.caps_read) c.extensions = context.caps.extensions;
  if (!(c.extensions & wanted)) abandon(c, Reason::kMissingExtension);
}

void abandon(Capture& c, Reason reason) {
  if (c.state == State::kPassive) return;
  if (c.state == State::kHeld) materialise(c);
  c.extensions = ~0u;
  c.passive_reason = reason;
  set(c, State::kPassive, ~SlotMask(0));
}

void begin_quads(Entry& e, GLenum mode) {
  if (e.active) {
    // An error, and the primitive goes on (GL 2.1 section 2.6.3).
    barrier(e);
    e.driver->Begin(mode);
    return;
  }
  if (e.list && keeps(*e.list) && !keeps_quads(e)) open_driver_part(e);
  if (!e.inside && keeps_quads(e)) {
    e.inside = true;
  } else if (!e.inside) {
    e.inside = true;
    if (Capture* const c = capturing_thread(e)) {
      start(*c, e, mode);
      set_active(e, c);
      if (c->state == State::kHeld) return;
      c->began = true;
      return begin_in_driver(*c);
    }
  }
  e.driver->Begin(mode);
}

void end_quads(Entry& e) {
  Capture& c = *e.active;
  const Driver* const c_driver = c.driver;
  set_active(e, nullptr);
  e.inside = false;
  if (c.mode == GL_POLYGON && c.next == 4 && c.quads == 0) {
    settle(c, completed_quad(c));
    // Kept with a list, which has its glEnd as well then.
    if (c.listing && e.driver != c_driver) return e.driver->End();
  }
  const bool incomplete = leftover(c);
  if (incomplete) pass(c, c.state == State::kPassive ? c.passive_reason : Reason::kIncomplete);
  if (!c.listing) c.start_held = c.corrected;
  count_listed(c);
  if (c.state == State::kHeld) {
    const bool unsent = window_order(c).count > 0 && c.mode == GL_POLYGON && !c.corrected;
    if (!incomplete && !unsent && (c.corrected || c.began)) {
      close_mesh(c);
      // GL's current values are the program's last ones, not those of our last vertex.
      for_each_slot(c.live, [&](Slot slot) { replay_now(c, slot); });
      return;
    }
    // What is left over is nothing in a list that has more than this primitive.
    if (c.corrected || c.began) c.relist = 0;
    materialise(c);
  }
  end_in_driver(c);
}

void barrier(Entry& e) {
  if (e.active) {
    Capture& c = *e.active;
    abandon(c, Reason::kUnmodelledCall);
    if (c.listing) {
      count_listed(c);
      set_active(e, nullptr);
    }
  }
  if (e.list) execute_kept(e);
}

}  // namespace truequad
