// Working space of one thread: allocated at its first correction, none after that.
#pragma once

#include "capture/lights.h"
#include "capture/slots.h"
#include "capture/values.h"
#include "truequad/kernel.h"

namespace truequad {

struct Scratch {
  static constexpr int kTriangleCap = 4096;  // for one quad
  // The published subdivision shares no vertices between its leaves of two triangles.
  static constexpr int kMaxVertices = 2 * kTriangleCap + 4;
  static constexpr unsigned kMaxChannels = 32;
  static_assert(kMaxChannels >= std::popcount(kInterpolatedSlots) + 1);

  Plan plan;
  Lights lights;
  Param params[kMaxVertices];
  Triangle triangles[kTriangleCap];
  Float4 values[std::size_t(kMaxVertices) * kMaxChannels];  // vertex after vertex, a value for each channel
};

}  // namespace truequad
