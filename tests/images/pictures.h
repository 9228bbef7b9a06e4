// Running the drawing programs, and reading what pixels say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture_file.h"

namespace truequad::images {

struct Statistics {
  long quads = 0, corrected = 0, capped = 0;
};

struct Pictures {
  PictureHeader header{};
  std::vector<unsigned char> bytes;
  Statistics statistics;  // zero without truequad

  const unsigned char* pixel(int trial, int pass, int x, int y) const {
    const std::size_t picture = std::size_t(trial) * kPasses + std::size_t(pass);
    return bytes.data() + picture * picture_bytes(header) +
           (std::size_t(y) * std::size_t(header.width) + std::size_t(x)) * 4;
  }
};

struct Settings {
  std::string mode = "bilinear";
  double tolerance_px = 0.25;
  bool color = false;
};

struct Job {
  std::string interface;  // osmesa, egl or glx
  std::string family;
  unsigned first = 0;
  int seeds = 1;
  int width = 256, height = 256;
  bool colours = false;  // by draw_colours: a picture for each ColourKind
};

// Draws with the driver alone, or with truequad under `settings`. A program that fails is a failed test.
Pictures draw(const Job& job, const std::optional<Settings>& settings);

// Texture coordinates that a covered pixel shows, to within half of kCoordinateStep.
struct Texel {
  double s, t;
  int mark;
};
inline constexpr double kCoordinateStep = 1.0 / 65536;
std::optional<Texel> texel_at(const Pictures& pictures, int trial, int x, int y);

}  // namespace truequad::images
