// A corrected quad beside one that is passed: their brightness agrees along the edge that they share.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "run_semantics.h"

namespace truequad::semantics {
namespace {

class Seam : public testing::TestWithParam<const char*> {};

TEST_P(Seam, IsNotSeen) {
  const Job job{"osmesa", GetParam(), 0, 1};
  const Outcome native = run_natively(job), seen = run_with_truequad(job);
  ASSERT_FALSE(native.records.empty() || seen.records.empty());
  ASSERT_EQ(seen.quads, 2);
  ASSERT_EQ(seen.corrected, 1);
  int largest = 0, largest_natively = 0;
  for (int y = 8; y < kHeight - 8; ++y) {
    // The columns left and right of x = 0.
    const int left = y * kWidth + kWidth / 2 - 1, right = left + 1;
    for (int c = 0; c < 3; ++c) {
      const int step = std::abs(seen.byte("seam", left, c) - seen.byte("seam", right, c));
      const int step_natively = std::abs(native.byte("seam", left, c) - native.byte("seam", right, c));
      EXPECT_EQ(native.byte("seam", right, c), seen.byte("seam", right, c)) << "row " << y;
      largest = std::max(largest, step - step_natively);
      largest_natively = std::max(largest_natively, step_natively);
    }
  }
  std::printf("%s: steps of up to %d of 255 natively, up to %d more with truequad\n", GetParam(),
              largest_natively, largest);
  EXPECT_LE(largest, 2);
}

std::string name_of(const testing::TestParamInfo<const char*>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Feature, Seam,
                         testing::Values("seam_colours", "seam_normals", "seam_normalized", "seam_lamp",
                                         "seam_highlight", "seam_saturated", "seam_two_sided"),
                         name_of);

}  // namespace
}  // namespace truequad::semantics
