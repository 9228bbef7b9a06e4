// Sends a recorded value to the driver again: by the entry point that the program used, with the same argument bits.
#pragma once

#include "capture/state.h"

namespace truequad {

// slot says the texture unit, material property or generic attribute of calls that name one.
void replay(const Driver& driver, Slot slot, RowId row, const Float4& value, const Raw& raw);

// Of a value whose floats are its arguments.
inline constexpr Raw kNoRaw{};

inline void replay_at(const Capture& c, Slot slot, unsigned place) {
  replay(*c.driver, slot, c.row[slot][place], c.at[slot][place], c.raw[slot][place]);
}
inline void replay_now(const Capture& c, Slot slot) {
  replay(*c.driver, slot, c.now_row[slot], c.now[slot], c.now_raw[slot]);
}

// glMaterial's names of a material slot.
struct MaterialName {
  GLenum face, property;
};
inline MaterialName material_name(Slot slot) {
  constexpr GLenum kProperty[kMaterialProperties] = {GL_AMBIENT,  GL_DIFFUSE,   GL_SPECULAR,
                                                     GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES};
  const unsigned index = slot - kMaterial;
  return {GLenum(index < kMaterialProperties ? GL_FRONT : GL_BACK), kProperty[index % kMaterialProperties]};
}

}  // namespace truequad
