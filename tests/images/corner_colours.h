// The colours of the pictures that draw_colours makes, known to it and to the test.
#pragma once

#include <array>
#include <random>

namespace truequad::images {

// What carries them, one picture each.
enum ColourKind { kPrimary, kSecondary, kFog, kEmission, kColourKinds };

// Whose vertices carry them: a second pass is planned for by its positions, so that each kind has its own.
inline unsigned scene_seed(unsigned seed, ColourKind kind, bool second_pass) {
  return second_pass ? seed + 1000 * unsigned(kind) : seed;
}

// Components of one vertex; alpha, where it is drawn, tells covered pixels. Fog has the first alone.
inline std::array<float, 4> vertex_colour(unsigned seed, unsigned primitive, unsigned vertex) {
  std::mt19937 engine(seed * 7919 + primitive * 131 + vertex);
  const auto unit = [&] { return float(engine() % 1024) / 1023; };
  return {unit(), unit(), unit(), 0.5f + unit() / 2};
}

}  // namespace truequad::images
