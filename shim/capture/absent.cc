// Attributes that were first set in the midst of a quad: its earlier corners have the driver's current values.
#include "capture/correct.h"
#include "capture/draw.h"
#include "capture/replay.h"

namespace truequad {
namespace {

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

}  // namespace

void fill_absent(Capture& c, const Quad& quad, SlotMask slots) {
  SlotMask absent = 0;
  for (unsigned place : quad.corner) absent |= slots & ~c.present[place];
  if (!absent) return;
  close_mesh(c);
  const Caps& caps = caps_of(c);
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

void keep_current(Capture& c, SlotMask slots) {
  const Caps& caps = caps_of(c);
  for_each_slot(slots, [&](Slot slot) {
    c.now[slot] = read_current(*c.driver, caps, slot);
    c.now_row[slot] = float_call(caps, slot, 4);
  });
}

}  // namespace truequad
