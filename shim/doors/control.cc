// The C control API (include/truequad/control.h): checks what it is given, and hands it to the capture of the calling thread.
#pragma GCC visibility push(default)
#include "truequad/control.h"
#pragma GCC visibility pop

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "capture/settings.h"
#include "capture/stats.h"
#include "doors/doors.h"

namespace truequad {
namespace {

static_assert(int(Mode::kBilinear) == TRUEQUAD_MODE_BILINEAR && int(Mode::kProjective) == TRUEQUAD_MODE_PROJECTIVE &&
              int(Mode::kAuto) == TRUEQUAD_MODE_AUTO && int(Mode::kPaper) == TRUEQUAD_MODE_PAPER &&
              int(Mode::kOff) == TRUEQUAD_MODE_OFF);
static_assert(TRUEQUAD_QUADS == GL_QUADS && TRUEQUAD_QUAD_STRIP == GL_QUAD_STRIP && TRUEQUAD_POLYGON == GL_POLYGON);

unsigned bit_of(unsigned primitive) { return primitive < 16 ? 1u << primitive & Settings::kAllPrimitives : 0; }

// Changes one of the thread's settings.
template <typename Change>
int choose(Change change) {
  Settings settings = chosen_settings(entry);
  change(settings);
  return choose_settings(entry, settings);
}

truequad_statistics statistics_of(const Counters& sum) {
  truequad_statistics all;
  all.quads = sum.quads();
  all.corrected = sum.corrected.get();
  all.passed = all.quads - all.corrected;
  all.capped = sum.capped.get();
  all.triangles = sum.triangles.get();
  all.flushes = sum.flushes.get();
  all.bound_px_max = sum.bound_px_max.load(std::memory_order_relaxed);
  return all;
}

}  // namespace
}  // namespace truequad

using namespace truequad;

int truequad_control_version() { return TRUEQUAD_CONTROL_VERSION; }

int truequad_set_mode(int mode) {
  if (mode < TRUEQUAD_MODE_BILINEAR || mode > TRUEQUAD_MODE_OFF) return 0;
  return choose([&](Settings& x) { x.mode = Mode(mode); });
}

int truequad_get_mode() { return int(chosen_settings(entry).mode); }

int truequad_set_tolerance(double pixels) {
  if (!std::isfinite(pixels) || !(pixels > 0)) return 0;
  return choose([&](Settings& x) { x.tolerance_px = pixels; });
}

double truequad_get_tolerance() { return chosen_settings(entry).tolerance_px; }

int truequad_set_primitive(unsigned int primitive, int on) {
  const unsigned bit = bit_of(primitive);
  if (!bit || (on != 0 && on != 1)) return 0;
  return choose([&](Settings& x) { x.primitives = std::uint16_t(on ? x.primitives | bit : x.primitives & ~bit); });
}

int truequad_get_primitive(unsigned int primitive) {
  const unsigned bit = bit_of(primitive);
  return bit ? (chosen_settings(entry).primitives & bit) != 0 : -1;
}

int truequad_read_statistics(truequad_statistics* statistics, size_t size) {
  if (!statistics || size == 0) return 0;
  Counters sum;
  stats_sum(sum);
  const truequad_statistics all = statistics_of(sum);
  std::memset(statistics, 0, size);
  std::memcpy(statistics, &all, std::min(size, sizeof all));
  return 1;
}

int truequad_read_pass_reason(const char* name, uint64_t* count) {
  if (!name || !count) return 0;
  const auto* const found = std::find(std::begin(kReasonNames), std::end(kReasonNames), std::string_view(name));
  if (found == std::end(kReasonNames)) return 0;
  Counters sum;
  stats_sum(sum);
  *count = sum.passed[found - kReasonNames].get();
  return 1;
}
