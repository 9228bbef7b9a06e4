// Quads from vertex arrays. A draw whose quads are all affine is the program's own call, untouched. Else it is drawn in
// order: quads that need no correction by draws of the same arrays, so that the driver takes them as it would take the
// whole, and the others, which are copied from the arrays, as in immediate mode.
#include <algorithm>
#include <cstring>

#include "capture/array_elements.h"
#include "capture/array_sources.h"
#include "capture/arrays.h"
#include "capture/colours.h"
#include "capture/correct.h"
#include "capture/draw.h"
#include "capture/drawn.h"
#include "capture/replay.h"
#include "kernel/affine_fast.h"
#include "capture/quads.h"

namespace truequad {
namespace {

// Sending colours makes materials of them that track the current colour, and afterwards of what it was. Where they are not
// the same before (after glPopAttrib, say) they could not be had again.
bool materials_have_current_colour(const Driver& driver) {
  GLint parameter = GL_AMBIENT_AND_DIFFUSE, side = GL_FRONT_AND_BACK;
  driver.GetIntegerv(GL_COLOR_MATERIAL_PARAMETER, &parameter);
  driver.GetIntegerv(GL_COLOR_MATERIAL_FACE, &side);
  GLfloat current[4] = {};
  driver.GetFloatv(GL_CURRENT_COLOR, current);
  const auto has = [&](GLenum face, GLenum property) {
    GLfloat value[4] = {};
    driver.GetMaterialfv(face, property, value);
    return std::equal(value, value + 4, current);
  };
  const auto all = [&](GLenum face) {
    if (side != GL_FRONT_AND_BACK && GLenum(side) != face) return true;
    if (parameter != GL_AMBIENT_AND_DIFFUSE) return has(face, GLenum(parameter));
    return has(face, GL_AMBIENT) && has(face, GL_DIFFUSE);
  };
  return all(GL_FRONT) && all(GL_BACK);
}

// A draw that GL calls an error, or that draws nothing.
bool is_void(const ArrayDraw& draw) {
  if (draw.primitives <= 0 || draw.instances.count <= 0 || !draw.count) return true;
  if (draw.type != 0 && (index_bytes(draw.type) == 0 || !draw.indices || draw.least > draw.most)) return true;
  bool any = false;
  for (GLsizei i = 0; i < draw.primitives; ++i) {
    if (draw.count[i] < 0 || (draw.type == 0 && draw.first[i] < 0)) return true;
    // Of many vertices restarts can make polygons of four.
    any |= quads_in(draw.mode, draw.count[i]) > 0 || (draw.type != 0 && draw.count[i] >= 4);
  }
  return !any;
}

std::uint64_t count_quads(const ArrayDraw& draw) {
  std::uint64_t quads = 0;
  for (GLsizei i = 0; i < draw.primitives; ++i) quads += std::uint64_t(quads_in(draw.mode, draw.count[i]));
  return quads * std::uint64_t(draw.instances.count);
}

class Drawing {
 public:
  Drawing(Capture& c, const Driver& driver, const ArrayDraw& draw, ArraySources& sources, SlotMask textures)
      : c_(c), driver_(driver), draw_(draw), sources_(sources), quad_(quad_of(draw.mode)) {
    c.live = textures;
    c.drawing = this;
    c.before_draw = before_draw;
    quick_ = c.textures_alone && textures != 0;
    for_each_slot(bit(kPosition) | textures, [&](Slot slot) { quick_ = quick_ && sources[slot].floats(); });
  }

  // True if something was corrected; then all of it has been drawn.
  bool run() {
    for (GLsizei i = 0; i < draw_.instances.count && (i == 0 || corrected_); ++i) run_instance();
    c_.drawing = nullptr;
    c_.before_draw = nullptr;
    count(Reason::kAffine, affine_);
    for (std::size_t i = 0; any_passed_ && i < kReasonCount; ++i) count(Reason(i), passed_[i]);
    if (!corrected_) return false;
    close_mesh(c_);
    // Draws from arrays leave the current values as they were, where drivers do as the specification allows.
    for_each_slot(c_.live, [&](Slot slot) { replay_now(c_, slot); });
    c_.calls_grew = true;
    end_batch(c_);
    return true;
  }

  // Quads that were seen, of all instances.
  std::uint64_t seen() const { return seen_; }

 private:
  void count(Reason reason, std::uint64_t quads) {
    // What needs nothing in the first instance needs nothing in the others, which were not looked at.
    if (!corrected_) quads *= std::uint64_t(draw_.instances.count);
    c_.counters.passed[std::size_t(reason)].add(quads);
    seen_ += quads;
  }

  // What the driver has not drawn yet, up to the end of the last quad that passed.
  struct Place {
    GLsizei primitive = 0, vertex = 0;
  };

  void run_instance() {
    from_ = to_ = {};
    for (GLsizei primitive = 0; primitive < draw_.primitives; ++primitive) {
      const Reason reason = sources_.find(draw_, primitive, elements_);
      if (reason == Reason::kNone) run_primitive(primitive);
      else pass_all(primitive, reason);
      to_ = {primitive, draw_.count[primitive]};
    }
    if (corrected_) flush();
  }

  void pass_all(GLsizei primitive, Reason reason) {
    any_passed_ = true;
    passed_[std::size_t(reason)] += std::uint64_t(quads_in(draw_.mode, draw_.count[primitive]));
  }

  void run_primitive(GLsizei primitive) {
    const GLsizei count = draw_.count[primitive];
    const Restart restart = restart_of(sources_.state(), draw_.type);
    // Whether numbers that no index gives restart differs between versions and drivers.
    if (restart.on && draw_.type == 0 && restart.index - GLuint(elements_.base) < GLuint(count)) {
      return pass_all(primitive, Reason::kArrayRange);
    }
    for_each_segment(elements_, restart, count, [&](GLsizei begin, GLsizei end) { run_segment(primitive, begin, end); });
  }

  // Vertices that are one primitive.
  void run_segment(GLsizei primitive, GLsizei begin, GLsizei end) {
    const GLsizei step = quad_step(draw_.mode), quads = quads_in(draw_.mode, end - begin);
    for (GLsizei i = 0; i < quads; ++i) {
      const GLsizei first = begin + i * step;
      if (!locate(first)) {
        settle_passed(primitive, first, Reason::kArrayRange);
        continue;
      }
      if (surely_affine_elements()) [[likely]] {
        settle_affine(primitive, first);
        continue;
      }
      if (!rows_noted_) {
        rows_noted_ = true;
        note_rows(bit(kPosition) | (c_.live & kTextureSlots));
      }
      fetch_slot(kPosition);
      for_each_slot(c_.live & kTextureSlots, [&](Slot slot) { fetch_slot(slot); });
      settle(primitive, first);
    }
  }

  // Finds the quad's four elements; false: not all lie in the arrays, and what the driver makes of them is its own.
  bool locate(GLsizei first) {
    bool inside = true;
    for (GLsizei i = 0; i < 4; ++i) {
      const GLuint index = elements_.index(first + i);
      element_[i] = std::uint64_t(elements_.base + std::int64_t(index));
      inside = inside && element_[i] < sources_.elements() &&
               (draw_.type == 0 || (index >= draw_.least && index <= draw_.most));
    }
    return inside;
  }

  // What surely_affine() (kernel/affine_fast.h) says of the quad, without copying it: floats only, and the components that
  // the arrays do not have cannot fail.
  bool surely_affine_elements() const {
    if (!quick_) return false;
    bool affine = parallelogram(sources_[kPosition]);
    for_each_slot(c_.live & kTextureSlots, [&](Slot slot) { affine = affine && parallelogram(sources_[slot]); });
    return affine;
  }

  bool parallelogram(const ArraySource& source) const {
    switch (source.size) {
      case 2: return parallelogram<2>(source);
      case 3: return parallelogram<3>(source);
      case 4: return parallelogram<4>(source);
      default: return parallelogram<1>(source);
    }
  }
  template <int size>
  bool parallelogram(const ArraySource& source) const {
    alignas(16) float x[4][4] = {};
    for (int i = 0; i < 4; ++i) {
      std::memcpy(x[i], source.bytes + source.stride * element_[quad_.corner[i]], size * sizeof(float));
    }
    alignas(16) static constexpr float kSame[4][4] = {};
    return surely_affine(x, kSame);
  }

  void fetch_slot(Slot slot) {
    const ArraySource& source = sources_[slot];
    for (unsigned i = 0; i < 4; ++i) c_.at[slot][i] = fetch(source, element_[i]);
  }

  void note_rows(SlotMask slots) {
    for_each_slot(slots, [&](Slot slot) {
      const RowId row = float_call(sources_.caps(), slot, sources_[slot].size);
      for (unsigned i = 0; i < 4; ++i) c_.row[slot][i] = row;
    });
  }

  // As settle() of primitive.cc does for a quad of immediate mode.
  void settle(GLsizei primitive, GLsizei first) {
    SlotMask warped = 0;
    Reason reason = judge(c_, quad_, warped);
    if (reason == Reason::kAffine && c_.textures_alone) [[likely]] {
      return settle_affine(primitive, first);
    }
    const bool colours = c_.options->color && fetch_others() == Reason::kNone && colours_may_kink(c_, quad_);
    const bool needs_look = reason == Reason::kNone || colours || may_be_mesh(c_, quad_);
    if (needs_look && c_.view_read && c_.view.pass != Reason::kNone) {
      if (reason == Reason::kNone || colours) reason = c_.view.pass;
    } else if (needs_look) {
      const Reason found = look(warped, colours);
      if (found == Reason::kNone) {
        ++seen_;
        from_ = to_ = {primitive, first + quad_step(draw_.mode)};
        return;
      }
      if (reason == Reason::kNone || (colours && found != Reason::kAffine)) reason = found;
    }
    settle_passed(primitive, first, reason);
    if (c_.watch != Watch::kNothing) note_triangles(c_, quad_);
  }

  void settle_affine(GLsizei primitive, GLsizei first) {
    ++affine_;
    to_ = {primitive, first + 4};
  }

  void settle_passed(GLsizei primitive, GLsizei first, Reason reason) {
    any_passed_ = true;
    ++passed_[std::size_t(reason)];
    to_ = {primitive, first + 4};
  }

  Reason look(SlotMask warped, bool colours) {
    const Reason reason = fetch_others();
    return reason == Reason::kNone ? correct(c_, quad_, warped, colours) : reason;
  }

  // All that an inserted vertex needs besides positions and textures.
  Reason fetch_others() {
    if (!looked_) {
      looked_ = true;
      why_not_ = find_others();
    }
    if (why_not_ != Reason::kNone) return why_not_;
    for (const std::uint64_t element : element_) {
      if (element >= sources_.elements()) return Reason::kArrayRange;
    }
    for_each_slot(c_.live & ~kTextureSlots, [&](Slot slot) { fetch_slot(slot); });
    for (unsigned i = 0; i < 4; ++i) c_.present[i] = c_.live;
    return Reason::kNone;
  }

  // The arrays that matter besides positions and textures: only these are read.
  Reason find_others() {
    const Caps& caps = sources_.caps();
    const SlotMask enabled = sources_.state().enabled;
    const auto is_enabled = [&](GLenum name) { return driver_.IsEnabled(name) != GL_FALSE; };
    const auto get = [&](GLenum name) {
      GLint value = 0;
      driver_.GetIntegerv(name, &value);
      return GLenum(value);
    };
    SlotMask others = 0;
    const bool lighting = is_enabled(GL_LIGHTING);
    if ((enabled & bit(kColor)) && (!lighting || is_enabled(GL_COLOR_MATERIAL))) others |= bit(kColor);
    if (enabled & bit(kNormal)) others |= bit(kNormal);
    if ((enabled & bit(kSecondaryColor)) && !lighting && is_enabled(GL_COLOR_SUM)) others |= bit(kSecondaryColor);
    if ((enabled & bit(kFogCoord)) && is_enabled(GL_FOG) && get(GL_FOG_COORD_SRC) == GL_FOG_COORD) {
      others |= bit(kFogCoord);
    }
    if ((enabled & bit(kIndex)) && get(GL_RGBA_MODE) == GL_FALSE) others |= bit(kIndex);
    if (others & bit(kNormal) && !lighting && !generates_by_normals(caps)) others &= ~bit(kNormal);
    const Reason reason = sources_.find(others);
    if (reason != Reason::kNone) return reason;
    if (!sources_.all_readable()) return Reason::kBuffer;
    if ((others & bit(kColor)) && is_enabled(GL_COLOR_MATERIAL) && !materials_have_current_colour(driver_)) {
      return Reason::kLighting;
    }
    note_rows(others);
    c_.live |= others;
    return Reason::kNone;
  }

  bool generates_by_normals(const Caps& caps) const {
    FrameView view;
    read_units(driver_, caps, (1u << std::min(caps.texture_units, kTextureUnits)) - 1, view);
    return view.units_generated != 0;
  }

  // The driver gets what comes before a quad that is corrected.
  static void before_draw(Capture& c) {
    Drawing& drawing = *static_cast<Drawing*>(c.drawing);
    if (!drawing.corrected_) {
      drawing.corrected_ = true;
      keep_current(c, c.live);
    }
    drawing.flush();
  }

  void flush() {
    for (GLsizei primitive = from_.primitive; primitive <= to_.primitive; ++primitive) {
      const GLsizei from = primitive == from_.primitive ? from_.vertex : 0;
      const GLsizei to = primitive == to_.primitive ? to_.vertex : draw_.count[primitive];
      if (to - from >= kLeast) draw_part(primitive, from, to - from);
    }
    from_ = to_;
  }

  // Fewer vertices are no polygon.
  static constexpr GLsizei kLeast = 3;

  void draw_part(GLsizei primitive, GLsizei from, GLsizei count) {
    close_mesh(c_);
    if (draw_.type == 0) return driver_.DrawArrays(draw_.mode, draw_.first[primitive] + from, count);
    const void* const indices =
        static_cast<const unsigned char*>(draw_.indices[primitive]) + std::size_t(from) * index_bytes(draw_.type);
    if (!draw_.base) return driver_.DrawElements(draw_.mode, count, draw_.type, indices);
    driver_.DrawElementsBaseVertex(draw_.mode, count, draw_.type, indices, draw_.base[primitive]);
  }

  Capture& c_;
  const Driver& driver_;
  const ArrayDraw& draw_;
  ArraySources& sources_;
  const Quad quad_;
  Elements elements_;
  std::uint64_t element_[4];
  std::uint64_t affine_ = 0, passed_[kReasonCount] = {}, seen_ = 0;
  Place from_, to_;
  bool corrected_ = false, looked_ = false, quick_ = false, any_passed_ = false, rows_noted_ = false;
  Reason why_not_ = Reason::kNone;
};

// What can be said of all quads before a vertex is looked at. kNone: they are to be looked at.
Reason find_reason(const Capture& c, const Driver& driver, ArrayMemory& memory, SlotMask& textures) {
  ArraySources& sources = memory.sources;
  const Reason reason = sources.open(*c.entry, driver);
  if (reason != Reason::kNone) return reason;
  // Before anything of the arrays is read: a program may read others.
  read_readers(*c.entry, driver, sources.caps(), memory.state, memory.readers);
  if (memory.readers.program) return Reason::kProgram;
  const SlotMask enabled = sources.state().enabled;
  if (!(enabled & bit(kPosition))) return Reason::kDegenerate;
  // Of units that are enabled: the driver reads no others.
  textures = enabled & kTextureSlots & (SlotMask(memory.readers.units_enabled) << kTexture);
  if (!textures && c.textures_alone) {
    return enabled & kTextureSlots ? Reason::kTexturingOff : Reason::kNoTextureVaries;
  }
  return sources.find(bit(kPosition) | textures);
}

}  // namespace

bool draw_quads(Entry& e, const ArrayDraw& draw) {
  if (is_void(draw)) return false;
  Capture* const c = capturing_thread(e);
  if (!c) return false;
  if (e.list) return compile_quads(e, *c, draw);
  start(*c, e, draw.mode);
  ArrayMemory* const memory = e.context ? array_memory(e) : nullptr;
  SlotMask textures = 0;
  Reason reason = Reason::kNone;
  if (c->state == State::kPassive) reason = c->passive_reason;
  else if (!memory) reason = Reason::kNoMemory;
  else reason = find_reason(*c, *e.driver, *memory, textures);
  bool drawn = false;
  std::uint64_t quads;
  if (reason == Reason::kNone) {
    Drawing drawing(*c, *e.driver, draw, memory->sources, textures);
    drawn = drawing.run();
    quads = drawing.seen();
  } else {
    quads = count_quads(draw);
    c->counters.passed[std::size_t(reason)].add(quads);
  }
  const bool from_buffer = reason == Reason::kNone && memory->state.array[kPosition].buffer != 0;
  (from_buffer ? c->counters.from_buffers : c->counters.from_arrays).add(quads);
  return drawn;
}

}  // namespace truequad
