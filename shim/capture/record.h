// What becomes of each row of attribute_calls.inc inside a captured primitive: it is recorded, and forwarded if it is to be
// forwarded now.
//
// The usual case never calls a function but the driver's, in tail position, so that no register need be saved for it.
// Everything else (a slot that is set first, a completed quad, a call that GL will refuse) is marked as pending and
// done out of line.
//
// A number is kept twice at most: as float (for decisions and for new vertices) and, if the call took anything but
// floats, as its bytes, so that replays have the program's own argument bits (replay.cc).
#pragma once

#include <cstring>
#include <type_traits>

#include "capture/state.h"

namespace truequad {

// True if a call's floats are its arguments: nothing else has to be kept.
template <Row row, typename T>
inline constexpr bool kIsPlain = row.encoding == Encoding::kPlain && std::is_same_v<T, GLfloat>;

// Where a Raw keeps what is not a number.
inline constexpr unsigned kRawType = 8, kRawNormalized = 12;  // of packed calls; the value is in the first 4 bytes

namespace recording {

enum class Step : unsigned { kDrop, kForward, kPending, kOtherSlots };

inline Step forward_if(bool forward) { return forward ? Step::kForward : Step::kDrop; }

// One store of sixteen bytes: a vertex reads the value back at once, which from several smaller stores would stall.
inline void store_whole(Float4& to, const Float4& value) {
  using Vector [[gnu::vector_size(16), gnu::may_alias]] = float;
  reinterpret_cast<Vector&>(to) = Vector{value.at[0], value.at[1], value.at[2], value.at[3]};
}

// What the components that a call does not give are (GL 2.1 section 2.7).
inline Float4 default_value(Family family) {
  return family == Family::FogCoord || family == Family::Index || family == Family::EdgeFlag ? Float4{{0, 0, 0, 0}}
                                                                                             : Float4{{0, 0, 0, 1}};
}

// Values of Capture::pending beyond the slots.
inline constexpr Slot kGiveUp = kSlots, kUseExtension = kSlots + 1;  // + its number

// What becomes of a call that the driver lacks is the driver's affair: nothing, or an error.
template <Row row>
inline bool may_lack_extension(Capture& c) {
  if constexpr (row.extension >= 0) {
    if (!(c.extensions & (1u << row.extension))) [[unlikely]] {
      c.pending = kUseExtension + unsigned(row.extension);
      return true;
    }
  }
  return false;
}

// `raw_size` bytes at `raw` replace the floats in a replay; 0: the floats are the arguments.
template <Row row, unsigned raw_size>
inline Step attribute(Capture& c, Slot slot, const Float4& value, const void* raw) {
  if (may_lack_extension<row>(c)) return Step::kPending;
  const bool forwarded = c.forwarded & bit(slot);
  if (!forwarded && !(c.live & bit(slot))) [[unlikely]] {
    c.pending = slot;
    return Step::kPending;
  }
  store_whole(c.now[slot], value);
  c.now_row[slot] = row.id;
  if constexpr (raw_size > 0) {
    c.raw_kept |= bit(slot);
    std::memcpy(c.now_raw[slot].bytes, raw, raw_size);
  }
  return forward_if(forwarded);
}

inline void copy_slot(Capture& c, Slot slot, unsigned place) {
  c.at[slot][place] = c.now[slot];
  c.row[slot][place] = c.now_row[slot];
  if (c.raw_kept & bit(slot)) [[unlikely]] c.raw[slot][place] = c.now_raw[slot];
}

// The rest of a vertex that is not usual.
inline Step other_slots(Capture& c) {
  const unsigned place = c.next;
  c.present[place] = c.live;
  if (c.state != State::kPassive) for_each_slot(c.live, [&](Slot slot) { copy_slot(c, slot, place); });
  c.next = place + 1;
  if (place == c.due) {
    c.pending = kPosition;
    return Step::kPending;
  }
  return forward_if(c.forwarding);
}

template <Row row, unsigned raw_size>
inline Step vertex(Capture& c, const Float4& position, const void* raw) {
  if (may_lack_extension<row>(c)) return Step::kPending;
  const unsigned place = c.next;
  store_whole(c.at[kPosition][place], position);
  c.row[kPosition][place] = row.id;
  if constexpr (raw_size > 0) std::memcpy(c.raw[kPosition][place].bytes, raw, raw_size);
  if (!c.usual_vertex) [[unlikely]] return Step::kOtherSlots;
  c.present[place] = bit(kTexture);
  copy_slot(c, kTexture, place);
  c.next = place + 1;
  if (place == c.due) {
    if (usual_quad(c)) [[likely]] return Step::kForward;
    c.pending = kPosition;
    return Step::kPending;
  }
  return Step::kForward;
}

template <Row row, unsigned raw_size>
inline Step store(Capture& c, Slot slot, const Float4& value, const void* raw) {
  if constexpr (row.family == Family::Vertex) return vertex<row, raw_size>(c, value, raw);
  else return attribute<row, raw_size>(c, slot, value, raw);
}

// A program's pointer may have any alignment.
template <typename T>
inline T load(const T* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

// Numbers given by value or, in the vector forms, by pointer.
template <Row row, typename T>
inline Step numbers(Capture& c, Slot slot, const T* values) {
  Float4 value = default_value(row.family);
  for (unsigned i = 0; i < row.size; ++i) value.at[i] = to_float<row.encoding, row.normalized>(load(values + i));
  constexpr unsigned kRawSize = kIsPlain<row, T> ? 0 : row.size * sizeof(T);
  static_assert(kRawSize <= sizeof(Raw));
  return store<row, kRawSize>(c, slot, value, values);
}

// GL says what is wrong with such a call, now and in its order.
inline Step give_up(Capture& c) {
  c.pending = kGiveUp;
  return Step::kPending;
}

template <Row row>
inline Step packed(Capture& c, Slot slot, GLenum type, GLboolean normalized, GLuint bits_) {
  Float4 all, value = default_value(row.family);
  const bool small_floats = type == GL_UNSIGNED_INT_10F_11F_11F_REV;
  if (small_floats && !(row.family == Family::VertexAttribP && row.size == 3)) return give_up(c);
  if (!unpack(type, row.normalized || normalized, bits_, all)) return give_up(c);
  for (unsigned i = 0; i < row.size; ++i) value.at[i] = all.at[i];
  Raw raw{};
  std::memcpy(raw.bytes, &bits_, sizeof bits_);
  std::memcpy(raw.bytes + kRawType, &type, sizeof type);
  std::memcpy(raw.bytes + kRawNormalized, &normalized, sizeof normalized);
  return store<row, kRawNormalized + sizeof normalized>(c, slot, value, raw.bytes);
}

// The slot of a call whose first parameter names it; kSlots: none of ours. The vertex is generic attribute 0.
template <Row row>
inline Slot named_slot(GLuint name) {
  if constexpr (row.family == Family::MultiTexCoord) {
    const GLuint unit = name - GL_TEXTURE0;
    return unit < kTextureUnits ? kTexture + unit : kSlots;
  } else {
    return name < kGenericAttributes ? (name == 0 ? kPosition : kGeneric + name - 1) : kSlots;
  }
}

// A Row like `row` that gives the position (glVertexAttrib* of attribute 0; GL 2.1 section 2.7).
constexpr Row as_vertex(Row row) {
  row.family = Family::Vertex;
  return row;
}

template <Row row, typename... Arguments>
Step material(Capture& c, Arguments... arguments);

template <Row row, typename First, typename... Rest>
inline Step record(Capture& c, First first, Rest... rest) {
  constexpr Family family = row.family;
  constexpr bool kNamed = family == Family::MultiTexCoord || family == Family::VertexAttrib ||
                          family == Family::VertexAttribI || family == Family::VertexAttribL ||
                          family == Family::VertexAttribP;
  if constexpr (row.encoding == Encoding::kFixed) {
    // No call that a list could keep (kept_calls.cc).
    if (c.listing) return give_up(c);
  }
  if constexpr (family == Family::VertexAttribNV) {
    // These alias the conventional attributes (NV_vertex_program); a program that uses them has one bound.
    return give_up(c);
  } else if constexpr (family == Family::Material) {
    return material<row>(c, first, rest...);
  } else if constexpr (kNamed) {
    const Slot slot = named_slot<row>(first);
    if (slot == kSlots) [[unlikely]] return give_up(c);
    const auto with_row = [&]<Row kind>() {
      if constexpr (family == Family::VertexAttribP) {
        const auto value_of = []<typename V>(V v) -> GLuint {
          if constexpr (std::is_pointer_v<V>) return load(v);
          else return v;
        };
        return [&](GLenum type, GLboolean normalized, auto v) {
          return packed<kind>(c, slot, type, normalized, value_of(v));
        }(rest...);
      } else if constexpr (row.encoding == Encoding::kPacked) {
        return [&](GLenum type, auto v) {
          if constexpr (std::is_pointer_v<decltype(v)>) return packed<kind>(c, slot, type, GL_FALSE, load(v));
          else return packed<kind>(c, slot, type, GL_FALSE, v);
        }(rest...);
      } else if constexpr (row.vector) {
        return numbers<kind>(c, slot, rest...);
      } else if constexpr (sizeof...(Rest) != row.size) {
        return give_up(c);
      } else {
        using T = std::common_type_t<Rest...>;
        const T values[] = {rest...};
        return numbers<kind>(c, slot, values);
      }
    };
    if constexpr (family != Family::MultiTexCoord) {
      if (slot == kPosition) {
        // Integer and double attributes have no fixed-function meaning.
        if constexpr (family == Family::VertexAttribI || family == Family::VertexAttribL) return give_up(c);
        else return with_row.template operator()<as_vertex(row)>();
      }
    }
    return with_row.template operator()<row>();
  } else {
    constexpr Slot kSlotOf[] = {kPosition, kTexture, kTexture, kColor, kSecondaryColor, kNormal, kFogCoord, kIndex,
                                kEdgeFlag};
    constexpr Slot slot = kSlotOf[unsigned(family)];
    if constexpr (row.encoding == Encoding::kPacked) {
      return [&](auto v) {
        if constexpr (std::is_pointer_v<decltype(v)>) return packed<row>(c, slot, first, GL_FALSE, load(v));
        else return packed<row>(c, slot, first, GL_FALSE, v);
      }(rest...);
    } else if constexpr (row.vector) {
      return numbers<row>(c, slot, first);
    } else if constexpr (1 + sizeof...(Rest) != row.size) {
      // The registry has three calls with a parameter too few (glVertex2xOES …): nobody can say what they mean.
      return give_up(c);
    } else {
      const First values[] = {first, rest...};
      return numbers<row>(c, slot, values);
    }
  }
}

// glMaterial: one value for up to four slots. Anything that GL would call an error is GL's.
template <Row row, typename... Arguments>
inline Step material(Capture& c, Arguments... arguments) {
  return [&](GLenum face, GLenum property, auto parameter) {
    enum : unsigned { kAmbient, kDiffuse, kSpecular, kEmission, kShininess, kIndexes };
    using T = std::remove_cv_t<std::remove_pointer_t<decltype(parameter)>>;
    unsigned first, count = 1, size = 4;
    switch (property) {
      case GL_AMBIENT: first = kAmbient; break;
      case GL_DIFFUSE: first = kDiffuse; break;
      case GL_AMBIENT_AND_DIFFUSE: first = kAmbient, count = 2; break;
      case GL_SPECULAR: first = kSpecular; break;
      case GL_EMISSION: first = kEmission; break;
      case GL_SHININESS: first = kShininess, size = 1; break;
      case GL_COLOR_INDEXES: first = kIndexes, size = 3; break;
      default: return give_up(c);
    }
    if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK) return give_up(c);
    T values[4] = {};
    if constexpr (std::is_pointer_v<decltype(parameter)>) {
      std::memcpy(values, parameter, size * sizeof(T));
    } else {
      if (property != GL_SHININESS) return give_up(c);
      values[0] = parameter;
    }
    Float4 value{{0, 0, 0, 1}};
    for (unsigned i = 0; i < size; ++i) {
      value.at[i] = size == 4 ? to_float<row.encoding, true>(values[i]) : to_float<row.encoding, false>(values[i]);
    }
    if (property == GL_SHININESS && !(value.at[0] >= 0 && value.at[0] <= 128)) return give_up(c);

    Step step = Step::kForward;
    for (unsigned side = 0; side < 2; ++side) {
      if (face == (side == 0 ? GL_BACK : GL_FRONT)) continue;
      for (unsigned i = 0; i < count; ++i) {
        const Slot slot = kMaterial + side * kMaterialProperties + first + i;
        step = attribute<row, kIsPlain<row, T> ? 0 : sizeof values>(c, slot, value, values);
        // Once the slot is live, the whole call is recorded again.
        if (step == Step::kPending) return step;
      }
    }
    return step;
  }(arguments...);
}

// Does what is pending. True: forward the call.
template <Row row, typename... Arguments>
bool resolve(Capture& c, Arguments... arguments) {
  Step step;
  do {
    if (c.pending == kPosition) return quad_complete(c);
    if (c.pending == kGiveUp) {
      abandon(c, Reason::kUnmodelledCall);
      return true;
    }
    if (c.pending >= kUseExtension) use_extension(c, c.pending - kUseExtension);
    else set_first(c, c.pending);
    step = record<row>(c, arguments...);
    if (step == Step::kOtherSlots) step = other_slots(c);
  } while (step == Step::kPending);
  return step == Step::kForward;
}

// The whole door of a call inside a captured primitive (capturing.cc).
template <Row row, auto member, typename Function = std::remove_cvref_t<decltype(std::declval<Driver>().*member)>>
struct Recorder;
template <Row row, auto member, typename... Arguments>
struct Recorder<row, member, void(GLAPIENTRY*)(Arguments...)> {
  static void GLAPIENTRY call(Arguments... arguments) {
    Entry& e = entry;
    switch (record<row>(*e.active, arguments...)) {
      case Step::kDrop: return;
      case Step::kForward: return (e.driver->*member)(arguments...);
      case Step::kPending: return pending(arguments...);
      case Step::kOtherSlots: return other(arguments...);
    }
  }

 private:
  // A loop needs registers that the usual call need not save.
  [[gnu::noinline]] static void other(Arguments... arguments) {
    Entry& e = entry;
    switch (other_slots(*e.active)) {
      case Step::kForward: return (e.driver->*member)(arguments...);
      case Step::kPending: return pending(arguments...);
      default: return;
    }
  }

  [[gnu::noinline]] static void pending(Arguments... arguments) {
    Entry& e = entry;
    if (resolve<row>(*e.active, arguments...)) return (e.driver->*member)(arguments...);
  }
};

}  // namespace recording

}  // namespace truequad
