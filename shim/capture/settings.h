// The settings that a thread may change while it runs (include/truequad/control.h); Options are the process's. Each thread has its
// own copy, so that nothing is locked or shared when they are read.
#pragma once

#include <cstdint>

#include "capture/entry.h"
#include "config/options.h"
#include "gl_enums.h"

namespace truequad {

struct Settings {
  double tolerance_px = 0;
  Mode mode = Mode::kOff;
  std::uint16_t primitives = 0;  // bit m: quads of primitives of mode m are corrected

  static constexpr std::uint16_t kAllPrimitives = 1u << GL_QUADS | 1u << GL_QUAD_STRIP | 1u << GL_POLYGON;
};

inline Settings settings_of(const Options& options) {
  return {options.tolerance_px, options.mode, Settings::kAllPrimitives};
}

// What the thread's next primitive will be drawn with.
Settings chosen_settings(const Entry& entry);

// Chooses for the primitives that begin from now on. False without memory.
bool choose_settings(Entry& entry, const Settings& settings);

}  // namespace truequad
