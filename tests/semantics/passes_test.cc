// A later pass over the same vertices lands on the same depths, whatever its texture coordinates: no pixel is
// lost and none is touched twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "pass.h"
#include "run_semantics.h"

namespace truequad::semantics {
namespace {

// What a case's picture must be within itself: channel `first` against the passes that came later.
struct Expected {
  const char* scene;
  int first;
  std::vector<int> same;     // touch the pixels that `first` touches
  std::vector<int> nothing;  // touch none
  bool split = false;        // the channels of `same` share the pixels of `first` among them
  bool own = false;          // the first pass may cover other pixels than natively (clip_test.cc says which)
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.scene; }

// Each fails if a mesh's depths are not those of the quad's own two triangles.
const std::vector<Expected> kLater = {
    {"equal_untextured", 0, {1}, {2}},
    {"equal_affine", 0, {1}, {2}},
    {"equal_other", 0, {1}, {2}},
    {"equal_twisted", 0, {1}, {2}},
    {"equal_unused", 0, {1}, {2}},
    {"equal_two_units", 0, {1}, {2}},
    {"equal_second_unit", 0, {1}, {2}},
    {"equal_begin_each", 0, {1}, {2}},
    {"equal_begin_each_other", 0, {1}, {2}},
    {"equal_doubles", 0, {1}, {2}},
    {"equal_arrays", 0, {1}, {2}},
    {"equal_arrays_warped", 0, {1}, {2}},
    {"equal_list", 0, {1}, {2}},
    {"lequal_untextured", 0, {1}, {2}},
    {"lequal_other", 0, {1}, {2}},
    {"gequal_untextured", 0, {1}, {2}},
    {"gequal_reversed", 0, {1}, {2}},
    {"less_untextured", 0, {}, {1, 2}},
    {"less_twisted", 0, {}, {1, 2}},
    {"greater_untextured", 0, {}, {1, 2}},
    {"notequal_other", 0, {}, {1, 2}},
    {"prepass_equal", 1, {}, {0, 2}},
    {"prepass_lequal", 1, {}, {0, 2}},
    {"prepass_affine_equal", 1, {}, {0, 2}},
    {"prepass_list_equal", 1, {}, {0, 2}},
    {"untextured_then_warped", 0, {1}, {2}},
    {"prepass_colour_light", 1, {2}, {0}},
    {"colour_light_fog", 0, {1, 2}, {}},
    {"always_over_nearer", 0, {1}, {2}},
    {"greater_over_nearer", 0, {1}, {2}},
    {"alpha_grating", 2, {0, 1}, {}, true},
    {"depth_clamp", 0, {1}, {2}},
    {"clip_plane", 0, {1}, {2}, false, true},
    {"same_frames", 0, {1, 2}, {}},
    {"moving_camera", 0, {1, 2}, {}},
    {"instances", 0, {1, 2}, {}},
    {"instances_in_turn", 0, {1}, {2}},
    {"viewports", 0, {1, 2}, {}},
    {"depth_range", 0, {1, 2}, {}},
    {"projection_and_back", 0, {1, 2}, {}},
    {"scissor", 0, {1, 2}, {}},
    {"offset_decal_less", 0, {1}, {2}},
    {"offset_decal_lequal", 0, {1}, {2}},
    {"offset_behind", 0, {}, {1, 2}},
    {"offset_first", 0, {1}, {2}},
    {"offset_both", 0, {1, 2}, {}},
    {"mirror", 0, {1, 2}, {}},
    {"counted_failures", 0, {1}, {2}},
    {"counted_failures_warped", 0, {1}, {2}},
    {"counted_up_and_down", 0, {1}, {2}},
    {"shadow", 0, {1, 2}, {}, true},
};

// Of these the last bits of depths do not matter: the mesh covers what the two triangles cover, once.
const std::vector<Expected> kAlone = {
    {"equal_same", 0, {1}, {2}},
    {"mask_plain_surface_warped", 0, {1}, {2}},
    {"mask_warped_surface_plain", 0, {1}, {2}},
    {"mask_warped_surface_twisted", 0, {1}, {2}},
    {"depth_mask_off", 0, {1}, {2}},
    {"depth_test_off", 0, {1}, {2}},
    {"alpha_discarded", 1, {}, {0, 2}},
    {"counted_passes", 0, {1}, {2}},
    {"decal_plain_on_warped", 0, {1}, {}},
    {"decal_affine_on_warped", 0, {1}, {}},
    {"decal_warped_on_plain", 0, {1}, {}},
    {"decal_warped_on_warped", 0, {1}, {}},
};

struct Count {
  long touches = 0, lost = 0, doubled = 0;
  void add(int expected, int seen) {
    touches += expected;
    (seen < expected ? lost : doubled) += std::abs(seen - expected);
  }
  void operator+=(const Count& other) {
    touches += other.touches;
    lost += other.lost;
    doubled += other.doubled;
  }
};

int touches(const Outcome& run, const std::string& picture, int pixel, int channel) {
  return (run.byte(picture, pixel, channel) + kTouch / 2) / kTouch;
}

// Whether the pixel and its neighbours have the same touches.
bool even(const Outcome& run, const std::string& picture, int pixel, int channel) {
  const int x = pixel % kWidth, y = pixel / kWidth;
  if (x == 0 || y == 0 || x == kWidth - 1 || y == kHeight - 1) return false;
  for (const int step : {1, kWidth - 1, kWidth, kWidth + 1}) {
    for (const int other : {pixel - step, pixel + step}) {
      if (touches(run, picture, other, channel) != touches(run, picture, pixel, channel)) return false;
    }
  }
  return true;
}

// Against the driver's own picture, every channel. Where two channels share a surface, their border may move
// to the next pixel with the rounding of depths or, if `free_border`, anywhere.
Count against_native(const Expected& expected, const Outcome& native, const Outcome& seen,
                     const std::string& picture, bool free_border) {
  Count count;
  for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
    for (int c = 0; c < 3; ++c) {
      const int wanted = touches(native, picture, pixel, c), got = touches(seen, picture, pixel, c);
      const bool shared = expected.split && c != expected.first;
      if (!shared)
        count.add(wanted, got);
      else if (!free_border && even(native, picture, pixel, c))
        count.add(wanted, got);
    }
  }
  return count;
}

// Within one picture: whether the later passes keep to the first one's pixels.
Count against_first(const Expected& expected, const Outcome& run, const std::string& picture) {
  Count count;
  for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
    const int first = touches(run, picture, pixel, expected.first);
    int together = 0;
    for (const int c : expected.same) {
      const int later = touches(run, picture, pixel, c);
      together += later > 0;
      if (!expected.split) count.add(first > 0, later > 0);
    }
    if (expected.split) count.add(first > 0, together);
    for (const int c : expected.nothing) count.add(0, touches(run, picture, pixel, c));
    if (expected.same.empty()) count.touches += first;
  }
  return count;
}

std::string shape_of(const std::string& picture) { return picture.substr(0, picture.find(' ')); }

// `folded`: judges that shape alone, else all others.
void expect_passes_kept(const Expected& expected, const std::string& interface, unsigned seeds,
                        const std::string& mode = "bilinear", bool folded = false, bool color = false) {
  const Job job{interface, expected.scene, 0, seeds};
  const Outcome native = run_natively(job), seen = run_with_truequad(job, mode, color);
  ASSERT_FALSE(native.records.empty() || seen.records.empty());
  ASSERT_EQ(native.records.size(), seen.records.size());
  EXPECT_GT(seen.corrected, 0);

  std::map<std::string, Count> table;
  for (const auto& [picture, bytes] : native.records) {
    const std::string shape = shape_of(picture);
    if ((shape == "folded") != folded) continue;
    const Count known = against_first(expected, native, picture);
    EXPECT_EQ(known.lost, 0) << "natively: " << picture;
    EXPECT_EQ(known.doubled, 0) << "natively: " << picture;
    // A folded surface covers other pixels than two triangles do: all that is known is what its passes have
    // in common.
    if (folded || expected.split || expected.own) table[shape] += against_first(expected, seen, picture);
    if (folded || expected.own) continue;
    // The borders of a texture's bars move by correction, those of a shadow on a bent surface with its
    // depths.
    const bool free_border = shape == "non_planar" || expected.first == 2;
    table[shape] += against_native(expected, native, seen, picture, free_border);
  }
  ASSERT_FALSE(table.empty());
  std::string line = interface + " " + mode + " " + expected.scene + " lost/doubled:";
  for (const auto& [shape, count] : table) {
    line += "  " + shape + " " + std::to_string(count.lost) + "/" + std::to_string(count.doubled) + " of " +
            std::to_string(count.touches);
    EXPECT_EQ(count.lost, 0) << shape;
    EXPECT_EQ(count.doubled, 0) << shape;
    EXPECT_GT(count.touches, 500) << shape << " is hardly seen";
  }
  std::puts(line.c_str());
}

class Passes : public testing::TestWithParam<Expected> {};

TEST_P(Passes, LoseAndDoubleNoPixel) { expect_passes_kept(GetParam(), "osmesa", 4); }

std::string scene_of(const testing::TestParamInfo<Expected>& info) { return info.param.scene; }
INSTANTIATE_TEST_SUITE_P(Later, Passes, testing::ValuesIn(kLater), scene_of);
INSTANTIATE_TEST_SUITE_P(Alone, Passes, testing::ValuesIn(kAlone), scene_of);

std::vector<Expected> some(const std::vector<std::string>& scenes) {
  std::vector<Expected> result;
  for (const auto* list : {&kLater, &kAlone}) {
    for (const Expected& expected : *list) {
      if (std::find(scenes.begin(), scenes.end(), expected.scene) != scenes.end()) result.push_back(expected);
    }
  }
  return result;
}

// Passes that need a mesh for their colours, with TRUEQUAD_COLOR=1.
const std::vector<Expected> kColoured = {
    {"colours_then_plain", 0, {1}, {2}},   {"plain_then_colours", 0, {1}, {2}}, {"colours_then_texture", 0, {1}, {2}},
    {"texture_then_colours", 0, {1}, {2}}, {"colours_then_both", 0, {1}, {2}},  {"prepass_colours", 1, {}, {0, 2}},
    {"colours_arrays", 0, {1}, {2}},
};
class Coloured : public testing::TestWithParam<Expected> {};
TEST_P(Coloured, LoseAndDoubleNoPixel) { expect_passes_kept(GetParam(), "osmesa", 3, "bilinear", false, true); }
INSTANTIATE_TEST_SUITE_P(Later, Coloured, testing::ValuesIn(kColoured), scene_of);

// Surfaces whose picture is not convex, where the bilinear surface covers other pixels than two triangles.
class Folded : public testing::TestWithParam<Expected> {};
TEST_P(Folded, KeepsToTheFirstPass) { expect_passes_kept(GetParam(), "osmesa", 4, "bilinear", true); }
INSTANTIATE_TEST_SUITE_P(Bent, Folded,
                         testing::ValuesIn(some({"equal_untextured", "equal_other", "less_untextured",
                                                 "offset_decal_lequal", "mask_plain_surface_warped",
                                                 "mask_warped_surface_plain",
                                                 "mask_warped_surface_twisted"})),
                         scene_of);

// The same through the other interfaces.
class Interfaces : public testing::TestWithParam<const char*> {};
TEST_P(Interfaces, LoseAndDoubleNoPixel) {
  for (const Expected& expected : some({"equal_other", "prepass_equal", "offset_decal_less", "shadow"})) {
    expect_passes_kept(expected, GetParam(), 2);
  }
}
INSTANTIATE_TEST_SUITE_P(Later, Interfaces, testing::Values("egl", "glx"),
                         [](const auto& info) { return std::string(info.param); });

// A quad that is drawn as two triangles with other texture coordinates keeps the diagonal of its primitive's
// mode.
class Modes : public testing::TestWithParam<const char*> {};

TEST_P(Modes, LoseAndDoubleNoPixel) {
  for (const Expected& expected : some({"equal_untextured", "prepass_equal"})) {
    expect_passes_kept(expected, "osmesa", 4, GetParam());
  }
}
INSTANTIATE_TEST_SUITE_P(Later, Modes, testing::Values("projective", "auto"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace truequad::semantics
