// Pictures of a real driver with truequad: right to the tolerance, whole, and untouched where nothing is to
// be corrected.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure_pictures.h"

namespace truequad::images {
namespace {

// Every check of one drawing: what was corrected is what the kernel plans for it, and every quad keeps its
// limit.
void expect_promises_kept(const Job& job, const Settings& settings) {
  SCOPED_TRACE(job.interface + " " + job.family + " " + settings.mode + " " +
               std::to_string(settings.tolerance_px));
  const Pictures pictures = draw(job, settings);
  if (pictures.bytes.empty()) return;
  const Measurement measured = measure(job, pictures, settings);
  EXPECT_EQ(pictures.statistics.quads, measured.quads * kPasses);
  EXPECT_EQ(pictures.statistics.corrected, measured.corrected * kPasses);
  EXPECT_EQ(pictures.statistics.capped, measured.capped * kPasses);
  EXPECT_EQ(measured.strays, 0)
      << "seed " << measured.worst_seed << ", largest " << measured.largest_px << " px";
  EXPECT_TRUE(measured.pixels > 0 || measured.unmeasured == measured.quads);
  std::printf(
      "%-8s %-15s %-10s %5.2f px: %5ld quads, %5ld corrected, %3ld capped, %4ld unmeasured, %8ld pixels, "
      "largest %.4f px\n",
      job.interface.c_str(), job.family.c_str(), settings.mode.c_str(), settings.tolerance_px, measured.quads,
      measured.corrected, measured.capped, measured.unmeasured, measured.pixels, measured.largest_px);
}

std::string name_of(const Family& family) { return std::string(family.name); }

// Pixels of one trial that are not touched as often.
long differing_layers(const Job& job, const Pictures& a, const Pictures& b, int trial) {
  long differing = 0;
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x) {
      differing += a.pixel(trial, kLayersPass, x, y)[0] != b.pixel(trial, kLayersPass, x, y)[0];
    }
  }
  return differing;
}

class EveryFamily : public testing::TestWithParam<Family> {};

TEST_P(EveryFamily, KeepsTheTolerance) {
  const std::string name = name_of(GetParam());
  expect_promises_kept({"osmesa", name, 0, 60, 120, 90}, {"bilinear", 0.25});
  expect_promises_kept({"osmesa", name, 1000, 20, 200, 160}, {"bilinear", 0.05});
  expect_promises_kept({"osmesa", name, 2000, 20, 200, 160}, {"bilinear", 1});
  expect_promises_kept({"osmesa", name, 3000, 2, 1000, 700}, {"bilinear", 0.25});
}

TEST_P(EveryFamily, CoversWhatTwoTrianglesCover) {
  if (!GetParam().planar_convex) return;
  const Job job{"osmesa", name_of(GetParam()), 5000, 100, 120, 90};
  const Pictures native = draw(job, std::nullopt), corrected = draw(job, Settings{"bilinear", 0.1});
  ASSERT_FALSE(HasFailure());
  long covered = 0;
  for (int trial = 0; trial < job.seeds; ++trial) {
    long differing = 0;
    for (int y = 0; y < job.height; ++y) {
      for (int x = 0; x < job.width; ++x) {
        const int before = native.pixel(trial, kLayersPass, x, y)[0];
        differing += before != corrected.pixel(trial, kLayersPass, x, y)[0];
        covered += before;
      }
    }
    EXPECT_EQ(differing, 0) << job.family << " seed " << job.first + unsigned(trial);
  }
  EXPECT_GT(covered, 10'000);
}

TEST_P(EveryFamily, IsUntouchedInModeOff) {
  const Job job{"osmesa", name_of(GetParam()), 6000, 30, 120, 90};
  const Pictures native = draw(job, std::nullopt), off = draw(job, Settings{"off", 0.25});
  ASSERT_FALSE(HasFailure());
  EXPECT_TRUE(native.bytes == off.bytes);
  EXPECT_EQ(off.statistics.corrected, 0);
  EXPECT_GT(off.statistics.quads, 0);
}

TEST_P(EveryFamily, ProjectiveIsExactOrFallsBack) {
  const std::string name = name_of(GetParam());
  expect_promises_kept({"osmesa", name, 7000, 60, 160, 120}, {"projective", 0.25});
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryFamily, testing::ValuesIn(families()),
                         [](const auto& info) { return name_of(info.param); });

class EveryInterface : public testing::TestWithParam<const char*> {};

TEST_P(EveryInterface, KeepsTheTolerance) {
  for (const char* name : {"trapezoid", "dragged", "strip", "polygon", "non_planar", "far_away"}) {
    expect_promises_kept({GetParam(), name, 8000, 10, 200, 160}, {"bilinear", 0.25});
  }
}

TEST_P(EveryInterface, LeavesAffineScenesBitIdentical) {
  const Job job{GetParam(), "affine", 9000, 60, 200, 160};
  const Pictures native = draw(job, std::nullopt);
  for (const char* mode : {"bilinear", "projective", "auto", "paper"}) {
    const Pictures passed = draw(job, Settings{mode, 0.05});
    ASSERT_FALSE(HasFailure());
    EXPECT_TRUE(native.bytes == passed.bytes) << mode;
    EXPECT_EQ(passed.statistics.corrected, 0) << mode;
    EXPECT_GT(passed.statistics.quads, 0) << mode;
  }
}

// However much of a pixel the rounding of vertices moves them, and however small the tolerance.
TEST_P(EveryInterface, CoversWhatTwoTrianglesCoverFarAway) {
  const Job job{GetParam(), "far_away", 1000, 200, 120, 90};
  const Pictures native = draw(job, std::nullopt), corrected = draw(job, Settings{"bilinear", 0.02});
  ASSERT_FALSE(HasFailure());
  for (int trial = 0; trial < job.seeds; ++trial) {
    EXPECT_EQ(differing_layers(job, native, corrected, trial), 0) << "seed " << job.first + unsigned(trial);
  }
}

// The vertices of a sheet are shared, its edges not split: no gap and no pixel twice, as without truequad.
TEST_P(EveryInterface, KeepsASheetWhole) {
  const Job job{GetParam(), "mesh", 9500, 10, 300, 300};
  const Pictures native = draw(job, std::nullopt), corrected = draw(job, Settings{"bilinear", 0.1});
  ASSERT_FALSE(HasFailure());
  EXPECT_GT(corrected.statistics.corrected, 0);
  for (int trial = 0; trial < job.seeds; ++trial) {
    EXPECT_EQ(differing_layers(job, native, corrected, trial), 0) << "seed " << job.first + unsigned(trial);
  }
}

INSTANTIATE_TEST_SUITE_P(Driver, EveryInterface, testing::Values("osmesa", "egl", "glx"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace truequad::images
