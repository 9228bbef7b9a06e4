// Contexts without immediate mode, where nothing is seen of truequad, and such as treat errors in other ways.
#include <gtest/gtest.h>

#include "run_semantics.h"

namespace truequad::semantics {
namespace {

class OtherContexts : public testing::TestWithParam<const char*> {};

TEST_P(OtherContexts, AreUntouched) {
  const Outcome native = run_program({OTHER_CONTEXTS, GetParam()}, false);
  const Outcome seen = run_program({OTHER_CONTEXTS, GetParam()}, true);
  ASSERT_FALSE(native.records.empty());
  EXPECT_TRUE(native.records == seen.records);
  const std::string kind = GetParam();
  if (kind == "core" || kind == "es") {
    EXPECT_EQ(seen.corrected, 0);
  } else {
    EXPECT_GT(seen.corrected, 0);
  }
  // The triangle is there, so the pictures say something.
  int coloured = 0;
  for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) coloured += native.byte("picture 0", pixel, 2) > 0;
  EXPECT_GT(coloured, 1000);
}

INSTANTIATE_TEST_SUITE_P(Feature, OtherContexts, testing::Values("core", "es", "debug", "robust", "no_error"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace truequad::semantics
