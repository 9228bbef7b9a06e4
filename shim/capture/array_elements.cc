#include "capture/array_elements.h"

#include "capture/draw.h"
#include "capture/correct.h"
#include "capture/drawn.h"
#include "capture/kept_current.h"
#include "capture/list_compile.h"
#include "capture/quads.h"
#include "capture/replay.h"

namespace truequad {
namespace {

// No row: the driver has to make the call.
constexpr RowId kNoRow = kRowCount;

// A call that takes an array's numbers as they are, for the types that such arrays may have (table 2.4); `index` counts
// the sizes from the smallest that the family has.

template <auto first, auto... others>
RowId nth(unsigned index) {
  constexpr RowId kAll[] = {first, others...};
  return index < 1 + sizeof...(others) ? kAll[index] : kNoRow;
}

RowId vertex_row(GLenum type, unsigned index) {
  switch (type) {
    case GL_SHORT: return nth<kRowVertex2sv, kRowVertex3sv, kRowVertex4sv>(index);
    case GL_INT: return nth<kRowVertex2iv, kRowVertex3iv, kRowVertex4iv>(index);
    case GL_FLOAT: return nth<kRowVertex2fv, kRowVertex3fv, kRowVertex4fv>(index);
    case GL_DOUBLE: return nth<kRowVertex2dv, kRowVertex3dv, kRowVertex4dv>(index);
    default: return kNoRow;
  }
}

RowId texture_row(GLenum type, unsigned index) {
  switch (type) {
    case GL_SHORT: return nth<kRowTexCoord1sv, kRowTexCoord2sv, kRowTexCoord3sv, kRowTexCoord4sv>(index);
    case GL_INT: return nth<kRowTexCoord1iv, kRowTexCoord2iv, kRowTexCoord3iv, kRowTexCoord4iv>(index);
    case GL_FLOAT: return nth<kRowTexCoord1fv, kRowTexCoord2fv, kRowTexCoord3fv, kRowTexCoord4fv>(index);
    case GL_DOUBLE: return nth<kRowTexCoord1dv, kRowTexCoord2dv, kRowTexCoord3dv, kRowTexCoord4dv>(index);
    default: return kNoRow;
  }
}

RowId unit_row(GLenum type, unsigned index) {
  switch (type) {
    case GL_SHORT:
      return nth<kRowMultiTexCoord1sv, kRowMultiTexCoord2sv, kRowMultiTexCoord3sv, kRowMultiTexCoord4sv>(index);
    case GL_INT:
      return nth<kRowMultiTexCoord1iv, kRowMultiTexCoord2iv, kRowMultiTexCoord3iv, kRowMultiTexCoord4iv>(index);
    case GL_FLOAT:
      return nth<kRowMultiTexCoord1fv, kRowMultiTexCoord2fv, kRowMultiTexCoord3fv, kRowMultiTexCoord4fv>(index);
    case GL_DOUBLE:
      return nth<kRowMultiTexCoord1dv, kRowMultiTexCoord2dv, kRowMultiTexCoord3dv, kRowMultiTexCoord4dv>(index);
    default: return kNoRow;
  }
}

RowId color_row(GLenum type, unsigned index) {
  switch (type) {
    case GL_BYTE: return nth<kRowColor3bv, kRowColor4bv>(index);
    case GL_UNSIGNED_BYTE: return nth<kRowColor3ubv, kRowColor4ubv>(index);
    case GL_SHORT: return nth<kRowColor3sv, kRowColor4sv>(index);
    case GL_UNSIGNED_SHORT: return nth<kRowColor3usv, kRowColor4usv>(index);
    case GL_INT: return nth<kRowColor3iv, kRowColor4iv>(index);
    case GL_UNSIGNED_INT: return nth<kRowColor3uiv, kRowColor4uiv>(index);
    case GL_FLOAT: return nth<kRowColor3fv, kRowColor4fv>(index);
    case GL_DOUBLE: return nth<kRowColor3dv, kRowColor4dv>(index);
    default: return kNoRow;
  }
}

RowId secondary_row(GLenum type) {
  switch (type) {
    case GL_BYTE: return kRowSecondaryColor3bv;
    case GL_UNSIGNED_BYTE: return kRowSecondaryColor3ubv;
    case GL_SHORT: return kRowSecondaryColor3sv;
    case GL_UNSIGNED_SHORT: return kRowSecondaryColor3usv;
    case GL_INT: return kRowSecondaryColor3iv;
    case GL_UNSIGNED_INT: return kRowSecondaryColor3uiv;
    case GL_FLOAT: return kRowSecondaryColor3fv;
    case GL_DOUBLE: return kRowSecondaryColor3dv;
    default: return kNoRow;
  }
}

RowId normal_row(GLenum type) {
  switch (type) {
    case GL_BYTE: return kRowNormal3bv;
    case GL_SHORT: return kRowNormal3sv;
    case GL_INT: return kRowNormal3iv;
    case GL_FLOAT: return kRowNormal3fv;
    case GL_DOUBLE: return kRowNormal3dv;
    default: return kNoRow;
  }
}

RowId index_row(GLenum type) {
  switch (type) {
    case GL_UNSIGNED_BYTE: return kRowIndexubv;
    case GL_SHORT: return kRowIndexsv;
    case GL_INT: return kRowIndexiv;
    case GL_FLOAT: return kRowIndexfv;
    case GL_DOUBLE: return kRowIndexdv;
    default: return kNoRow;
  }
}

RowId fog_row(GLenum type) {
  switch (type) {
    case GL_FLOAT: return kRowFogCoordfv;
    case GL_DOUBLE: return kRowFogCoorddv;
    default: return kNoRow;
  }
}

RowId row_of(Slot slot, const ArraySource& source, const Caps& caps) {
  if (source.bgra) return kNoRow;
  // Half floats are floats exactly.
  if (source.type == GL_HALF_FLOAT && slot != kEdgeFlag) return float_call(caps, slot, source.size);
  if (slot == kTexture) return texture_row(source.type, source.size - 1u);
  if (bit(slot) & kTextureSlots) return caps.multitexture_core ? unit_row(source.type, source.size - 1u) : kNoRow;
  switch (slot) {
    case kPosition: return vertex_row(source.type, source.size - 2u);
    case kColor: return color_row(source.type, source.size - 3u);
    case kSecondaryColor: return caps.secondary_color_core ? secondary_row(source.type) : kNoRow;
    case kNormal: return normal_row(source.type);
    case kFogCoord: return caps.fog_coord_core ? fog_row(source.type) : kNoRow;
    case kIndex: return index_row(source.type);
    default: return kRowEdgeFlagv;
  }
}

// All enabled arrays can be sent by calls.
bool can_be_sent(ArraySources& sources) {
  const SlotMask enabled = sources.state().enabled;
  if (sources.any_generic() || sources.find(enabled) != Reason::kNone) return false;
  bool all = true;
  for_each_slot(enabled, [&](Slot slot) { all = all && row_of(slot, sources[slot], sources.caps()) != kNoRow; });
  return all;
}

// The driver is, or can be brought, where it can be asked: outside of Begin/End, whatever the program's calls say.
bool leave_primitive(Entry& e) {
  if (e.active) {
    if (e.active->state == State::kOpen) {
      if (e.active->listing) return false;
      cut(*e.active);
    }
    close_mesh(*e.active);
    return true;
  }
  return !(e.list->mode == GL_COMPILE_AND_EXECUTE && e.list->executed_inside);
}

bool find_elements(Entry& e) {
  ArrayMemory* const memory = e.context ? array_memory(e) : nullptr;
  if (!memory) return false;
  const ArrayState& state = memory->state;
  const bool known = e.arrays_known && e.context->caps_read && state.any_generic >= 0 && !state.any_buffer();
  if (!known && !leave_primitive(e)) return false;
  return memory->sources.open(e, *real_driver(e)) == Reason::kNone && can_be_sent(memory->sources);
}

}  // namespace

void send_element(Entry& e, const ArraySources& sources, std::uint64_t element) {
  const auto send = [&](Slot slot) {
    const ArraySource& source = sources[slot];
    const unsigned char* const from = source.bytes + source.stride * element;
    Raw raw;
    std::memcpy(raw.bytes, from, sources.state().array[slot].bytes);
    replay(*e.dispatch, slot, row_of(slot, source, sources.caps()), fetch(source, element), raw);
  };
  const SlotMask enabled = sources.state().enabled;
  for_each_slot(enabled & ~bit(kPosition), send);
  if (enabled & bit(kPosition)) send(kPosition);
}

bool element_in_primitive(Entry& e, GLint element) {
  Capture* const c = e.active;
  if (c ? c->state == State::kPassive : !e.list || !keeps(*e.list) || !e.inside) return false;
  if (!c || !c->elements_found) {
    if (!find_elements(e)) return false;
    if (c) c->elements_found = true;
  }
  const ArraySources& sources = e.context->arrays->sources;
  const Restart restart = restart_of(sources.state(), 0);
  if (element < 0 || std::uint64_t(element) >= sources.elements() || (restart.on && GLuint(element) == restart.index)) {
    return false;
  }
  send_element(e, sources, std::uint64_t(element));
  return true;
}

namespace {

class Compiling {
 public:
  Compiling(Entry& e, Capture& c, const ArrayDraw& draw, ArraySources& sources)
      : e_(e), c_(c), draw_(draw), sources_(sources), quad_(quad_of(draw.mode)),
        restart_(restart_of(sources.state(), draw.type)) {
    c.mode = draw.mode;
    c.raw_kept = 0;
    c.live = sources.state().enabled & kTextureSlots;
  }

  // True if a quad may need correction in some view.
  bool may_need_correction() {
    bool may = false;
    for (GLsizei i = 0; i < draw_.primitives && !may; ++i) {
      Elements elements;
      if (sources_.find(draw_, i, elements) != Reason::kNone) return false;
      for_each_segment(elements, restart_, draw_.count[i], [&](GLsizei begin, GLsizei end) {
        const GLsizei quads = quads_in(draw_.mode, end - begin);
        for (GLsizei k = 0; k < quads && !may; ++k) may = quad_may(elements, begin + k * quad_step(draw_.mode));
      });
    }
    return may && all_inside();
  }

  // The driver compiles it: its quads are counted once.
  void count_passed() {
    for (std::size_t i = 0; i < kReasonCount; ++i) {
      c_.counters.passed[i].add(passed_[i]);
      c_.counters.listed.add(passed_[i]);
    }
  }

  void send() {
    for (GLsizei i = 0; i < draw_.primitives; ++i) {
      Elements elements;
      sources_.find(draw_, i, elements);
      for_each_segment(elements, restart_, draw_.count[i], [&](GLsizei begin, GLsizei end) {
        begin_primitive();
        for (GLsizei k = begin; k < end; ++k) send_element(e_, sources_, element(elements, k));
        truequad::end(e_);
      });
    }
  }

 private:
  void begin_primitive() { begin(e_, draw_.mode); }

  static std::uint64_t element(const Elements& elements, GLsizei i) {
    return std::uint64_t(elements.base + std::int64_t(elements.index(i)));
  }

  bool quad_may(const Elements& elements, GLsizei first) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint64_t at = element(elements, first + GLsizei(i));
      if (at >= sources_.elements()) return false;
      for_each_slot(c_.live | bit(kPosition), [&](Slot slot) { c_.at[slot][i] = fetch(sources_[slot], at); });
    }
    SlotMask warped = 0;
    const Reason reason = judge(c_, quad_, warped);
    // Whether it will be lit, and how, is not known yet.
    if (reason == Reason::kNone || c_.options->color) return true;
    ++passed_[std::size_t(reason)];
    return passes_meet() && (reason == Reason::kAffine || reason == Reason::kNoTextureVaries) && !parallelogram(c_, quad_);
  }

  // Every vertex lies in its arrays: what the driver makes of others is its own.
  bool all_inside() {
    for (GLsizei i = 0; i < draw_.primitives; ++i) {
      Elements elements;
      sources_.find(draw_, i, elements);
      for (GLsizei k = 0; k < draw_.count[i]; ++k) {
        const GLuint index = elements.index(k);
        if (restart_.on && index == restart_.index) continue;
        if (element(elements, k) >= sources_.elements()) return false;
        if (draw_.type != 0 && (index < draw_.least || index > draw_.most)) return false;
      }
    }
    return true;
  }

  Entry& e_;
  Capture& c_;
  const ArrayDraw& draw_;
  ArraySources& sources_;
  const Quad quad_;
  const Restart restart_;
  std::uint64_t passed_[kReasonCount] = {};
};

}  // namespace

bool compile_quads(Entry& e, Capture& c, const ArrayDraw& draw) {
  // "The error INVALID_OPERATION is generated if DrawArraysInstancedARB or DrawElementsInstancedARB is called during display
  // list compilation" (ARB_draw_instanced).
  if (draw.instances.named) return false;
  const Settings& settings = c.chosen;
  if (settings.mode == Mode::kOff || !(settings.primitives >> draw.mode & 1) || !e.context) return false;
  if (e.list->mode == GL_COMPILE_AND_EXECUTE && e.list->executed_inside) return false;
  ArrayMemory* const memory = array_memory(e);
  if (!memory || memory->sources.open(e, *real_driver(e)) != Reason::kNone) return false;
  ArraySources& sources = memory->sources;
  if (!(sources.state().enabled & bit(kPosition)) || !can_be_sent(sources)) return false;
  if (draw.type == 0 && sources.state().restarts) return false;
  // Nothing tells the current edge flag's type apart from the array's, and it matters to no quad that is corrected.
  if (sources.state().enabled & bit(kEdgeFlag)) return false;
  Compiling compiling(e, c, draw, sources);
  if (!compiling.may_need_correction()) {
    compiling.count_passed();
    return false;
  }
  if (e.list->leading) open_driver_part(e);
  if (!end_driver_part(e) || !keep_noting_current(e, sources.state().enabled & kInterpolatedSlots)) return false;
  compiling.send();
  keep_restoring_current(e);
  return true;
}

void note_current(Entry& e, SlotMask slots) {
  Capture* const c = capturing_thread(e);
  ArrayMemory* const memory = c && e.context && !e.inside ? array_memory(e) : nullptr;
  if (!memory) return;
  barrier(e);
  c->driver = e.driver;
  if (!caps_of(*c).supported) return;
  keep_current(*c, slots);
  for_each_slot(slots, [&](Slot slot) { memory->current[slot] = c->now[slot]; });
  memory->current_noted = slots;
}

void restore_current(Entry& e) {
  ArrayMemory* const memory = e.context ? e.context->arrays : nullptr;
  if (!memory || e.inside || memory->current_noted == 0) return;
  const Caps& caps = e.context->caps;
  for_each_slot(memory->current_noted, [&](Slot slot) {
    replay(*e.driver, slot, float_call(caps, slot, 4), memory->current[slot], kNoRaw);
  });
  memory->current_noted = 0;
  end_batch(*e.own);
}

}  // namespace truequad
