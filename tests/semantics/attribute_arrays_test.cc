// Attributes in vertex arrays - colours, secondary colours, normals, fog coordinates, edge flags, two sets of texture coordinates -
// are on corrected quads what the same attributes are in immediate mode.
#include <gtest/gtest.h>

#include "run_semantics.h"

namespace truequad::semantics {
namespace {

class AttributeArrays : public testing::TestWithParam<const char*> {};

TEST_P(AttributeArrays, AreDrawnAsInImmediateMode) {
  const std::string scene = GetParam();
  const Outcome immediate = run_with_truequad({"osmesa", scene, 0, 1}), seen = run_with_truequad({"osmesa", "arrays:" + scene, 0, 1});
  ASSERT_FALSE(immediate.records.empty() || seen.records.empty());
  EXPECT_GT(immediate.corrected, 0);
  EXPECT_EQ(seen.corrected, immediate.corrected);
  ASSERT_EQ(seen.records.size(), immediate.records.size());
  for (const auto& [name, bytes] : immediate.records) EXPECT_TRUE(bytes == seen.records.at(name)) << name;
}

INSTANTIATE_TEST_SUITE_P(Feature, AttributeArrays,
                         testing::Values("flat_last", "flat_first", "flat_secondary", "unclamped", "fog_of_depth",
                                         "bent_secondary", "bent_fog", "bent_normals", "two_sided", "colour_material",
                                         "flat_highlight", "filled_with_edge_flags", "second_unit_2d", "seam_normalized"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace truequad::semantics
