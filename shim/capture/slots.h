// Where a vertex keeps what: one slot for each piece of current state that may be set between glBegin and glEnd
// (GL 2.1 section 2.7, NV_half_float, ARB_vertex_program, EXT_fog_coord …).
#pragma once

#include <bit>
#include <cstdint>

#include "truequad/kernel.h"

namespace truequad {

using Slot = unsigned;
using SlotMask = std::uint64_t;

inline constexpr unsigned kTextureUnits = kMaxTextureSets;
inline constexpr unsigned kMaterialProperties = 6;   // ambient, diffuse, specular, emission, shininess, indexes
inline constexpr unsigned kGenericAttributes = 16;   // that every driver with generic attributes has; 0 is the vertex

inline constexpr Slot kPosition = 0;
inline constexpr Slot kTexture = 1;  // + unit
inline constexpr Slot kColor = kTexture + kTextureUnits;
inline constexpr Slot kSecondaryColor = kColor + 1;
inline constexpr Slot kNormal = kSecondaryColor + 1;
inline constexpr Slot kFogCoord = kNormal + 1;
inline constexpr Slot kIndex = kFogCoord + 1;
inline constexpr Slot kEdgeFlag = kIndex + 1;
inline constexpr Slot kMaterial = kEdgeFlag + 1;  // + face * kMaterialProperties + property; face 0 front, 1 back
inline constexpr Slot kGeneric = kMaterial + 2 * kMaterialProperties;  // + attribute - 1
inline constexpr Slot kSlots = kGeneric + kGenericAttributes - 1;
static_assert(kSlots <= 64, "SlotMask");

constexpr SlotMask bit(Slot slot) { return SlotMask(1) << slot; }
constexpr SlotMask bits(Slot first, unsigned count) { return ((SlotMask(1) << count) - 1) << first; }

inline constexpr SlotMask kTextureSlots = bits(kTexture, kTextureUnits);
inline constexpr SlotMask kMaterialSlots = bits(kMaterial, 2 * kMaterialProperties);
inline constexpr SlotMask kGenericSlots = bits(kGeneric, kGenericAttributes - 1);
// What a new vertex inside a quad needs. Edge flags matter only to polygon modes that are passed, generic attributes
// only to programs, which are passed too.
inline constexpr SlotMask kInterpolatedSlots =
    ~(bit(kPosition) | bit(kEdgeFlag) | kGenericSlots) & bits(0, kSlots);
// What flat shading takes from the provoking vertex alone: the colours and, if the driver lights them, the normal.
inline constexpr SlotMask kFlatSlots = bit(kColor) | bit(kSecondaryColor) | bit(kIndex) | kMaterialSlots;

// Calls f(slot) for each slot of a mask, lowest first.
template <typename F>
void for_each_slot(SlotMask mask, F f) {
  for (; mask; mask &= mask - 1) f(Slot(std::countr_zero(mask)));
}

}  // namespace truequad
