// The sanitized library inside of real drivers, in programs that are not sanitized: every family of scenes in every mode,
// every interface, and the samples. A finding ends the program, so a status other than 0 is one. What the pictures show is
// measured without sanitizers (images_test.cc).
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "pictures.h"
#include "scenes.h"

namespace truequad::images {
namespace {

// Small pictures: what costs time is the driver, and what is tested depends on the number of quads.
constexpr int kWidth = 96, kHeight = 72, kSeeds = 12;

class Sanitized : public testing::TestWithParam<Family> {};

// A run costs half a second whatever it draws, so the overlay comes with the second tolerance.
TEST_P(Sanitized, DrawsInEveryMode) {
  const Family& family = GetParam();
  unsigned first = 0;
  for (const char* mode : {"bilinear", "projective", "auto", "paper", "off"}) {
    for (const bool overlay : {false, true}) {
      const bool off = std::string_view(mode) == "off";
      if (off && overlay) continue;
      ASSERT_EQ(setenv("TRUEQUAD_OVERLAY", overlay ? "1" : "0", 1), 0);
      const double tolerance_px = overlay ? 0.02 : 0.25;
      const Pictures pictures =
          draw({"osmesa", std::string(family.name), first, kSeeds, kWidth, kHeight}, Settings{mode, tolerance_px});
      EXPECT_GE(pictures.statistics.quads, kSeeds * kPasses) << mode;
      EXPECT_EQ(pictures.statistics.corrected > 0, !family.affine && !off) << mode << ' ' << tolerance_px;
      first += kSeeds;
    }
  }
  unsetenv("TRUEQUAD_OVERLAY");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Sanitized, testing::ValuesIn(families()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SanitizedInterface, DrawsEveryFamily) {
  for (const char* interface : {"egl", "glx"}) {
    for (const Family& family : families()) {
      const Pictures pictures =
          draw({interface, std::string(family.name), 20'000, 5, kWidth, kHeight}, Settings{"bilinear", 0.25});
      EXPECT_GE(pictures.statistics.quads, 5 * kPasses) << interface;
    }
  }
}

TEST(SanitizedSample, EndsWell) {
  ASSERT_EQ(setenv("TRUEQUAD_STATS", "/dev/null", 1), 0);
  for (const char* mode : {"bilinear", "projective", "auto", "paper", "off"}) {
    for (const char* words : {"facade --figure 1", "facade --figure 2", "facade --figure 3", "trapezoid",
                              "trapezoid --patch slanted --area 197", "patches --figure 12", "patches --figure 14",
                              "patches --figure 15", "patches --figure 16", "keystone", "tunnel --frame 20"}) {
      const std::string command = std::string("LD_PRELOAD=" TRUEQUAD_PRELOAD " TRUEQUAD_MODE=") + mode +
                                  " " SAMPLES_PREFIX + words + " --repeat 2 --size 320x240 --out /dev/null";
      EXPECT_EQ(std::system(command.c_str()), 0) << command;
    }
  }
  unsetenv("TRUEQUAD_STATS");
}

}  // namespace
}  // namespace truequad::images
