// A quad in a display list is corrected exactly as the same quad in immediate mode, whichever way the list is called; what
// needs no correction is as without truequad, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run.h"

namespace truequad::lists_test {
namespace {

using doors_test::read_file;
using doors_test::run;
using doors_test::Scratch;

struct Drawn {
  std::string pictures;
  long corrected = 0, listed = 0, immediate = 0;
};

constexpr unsigned kWidth = 160, kHeight = 120, kScenes = 8;

Drawn draw(const std::string& families, const std::string& way, bool with_truequad, const std::string& tolerance_px = "0.25") {
  const Scratch scratch;
  const std::string file = scratch / "raw", statistics = scratch / "json";
  std::map<std::string, std::string> environment;
  if (with_truequad) environment = {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", statistics},
                                      {"TRUEQUAD_TOLERANCE", tolerance_px}};
  const auto ended = run({DRAW_LISTS, families, std::to_string(kScenes), std::to_string(kWidth), std::to_string(kHeight), way, file},
                         environment);
  EXPECT_EQ(ended.status, 0) << families << " " << way << ": " << ended.err;
  EXPECT_EQ(ended.err, "");
  Drawn drawn{read_file(file)};
  const std::size_t count = 1 + std::size_t(std::count(families.begin(), families.end(), ','));
  EXPECT_EQ(drawn.pictures.size(), count * kScenes * kWidth * kHeight * 4);
  if (with_truequad) {
    const auto json = nlohmann::json::parse(read_file(statistics), nullptr, false);
    EXPECT_TRUE(json.is_object());
    if (json.is_object()) {
      drawn.corrected = json.value("corrected", -1L);
      drawn.listed = json["by_path"].value("list", -1L);
      drawn.immediate = json["by_path"].value("immediate", -1L);
    }
  }
  return drawn;
}

bool each_pixel_from(const std::string& picture, const std::string& one, const std::string& other) {
  bool each = picture.size() == one.size() && picture.size() == other.size();
  for (std::size_t i = 0; each && i < picture.size(); i += 4) {
    each = !picture.compare(i, 4, one, i, 4) || !picture.compare(i, 4, other, i, 4);
  }
  return each;
}

struct Way {
  const char* name;
  int calls = 1;         // of the list, into the same picture or not
  bool by_list = true;
};
constexpr Way kWays[] = {{"list"},       {"without_gen"}, {"execute"},   {"execute_then_call", 2}, {"called_twice", 2},
                         {"nested"},     {"each_its_own"}, {"call_lists_in_list"}, {"redefined"}, {"redefined_as_triangles", 1, false},
                         {"inside_begin"}, {"inside_begin_by_base"},
                         {"inside_begin_by_popped_base"}, {"inside_begin_by_listed_base"}, {"inside_begin_by_base_popped_in_list"}, {"among_others"}, {"shared"}, {"matrices_in_list"}};

class Ways : public testing::TestWithParam<Way> {};

TEST_P(Ways, DrawWhatImmediateModeDraws) {
  const Way way = GetParam();
  for (const char* family : {"trapezoid", "dragged", "polygon", "near_plane", "strip", "mesh", "non_planar", "bow_tie"}) {
    SCOPED_TRACE(family);
    const Drawn immediate = draw(family, "immediate", true), listed = draw(family, way.name, true);
    ASSERT_GT(immediate.corrected, 0);
    // Where a quad is left alone it is the driver's, as it draws lists.
    if (listed.pictures != immediate.pictures) {
      const Drawn native = draw(family, way.name, false);
      EXPECT_TRUE(each_pixel_from(listed.pictures, immediate.pictures, native.pictures));
    }
    EXPECT_GE(listed.corrected, immediate.corrected);
    if (way.by_list && !std::string(way.name).starts_with("inside_begin")) {
      EXPECT_GE(listed.listed, immediate.immediate);
      EXPECT_EQ(listed.immediate, 0);
    }
  }
}

TEST_P(Ways, LeaveAffineQuadsToTheDriver) {
  const Way way = GetParam();
  const Drawn native = draw("affine", way.name, false), ours = draw("affine", way.name, true);
  EXPECT_EQ(ours.corrected, 0);
  EXPECT_TRUE(ours.pictures == native.pictures);
}

// Drivers may cut the quads of lists along the other diagonal than those of immediate mode.
TEST_P(Ways, LeaveQuadsWithinTheToleranceAsTheDriverDrawsThem) {
  const Way way = GetParam();
  for (const char* family : {"trapezoid", "strip", "mesh"}) {
    SCOPED_TRACE(family);
    const Drawn native = draw(family, way.name, false), ours = draw(family, way.name, true, "1e6");
    ASSERT_EQ(ours.corrected, 0);
    EXPECT_TRUE(ours.pictures == native.pictures);
  }
}

INSTANTIATE_TEST_SUITE_P(Lists, Ways, testing::ValuesIn(kWays),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Lists, NamesOfEveryTypeAreUnderstood) {
  const Drawn immediate = draw("trapezoid", "immediate", true);
  for (const char* type : {"byte", "unsigned_byte", "short", "unsigned_short", "int", "unsigned_int", "float", "2_bytes",
                           "3_bytes", "4_bytes"}) {
    SCOPED_TRACE(type);
    const Drawn ours = draw("trapezoid", std::string("type_") + type, true);
    EXPECT_TRUE(ours.pictures == immediate.pictures);
    EXPECT_EQ(ours.corrected, 2 * immediate.corrected);
    EXPECT_EQ(ours.listed, 2 * immediate.immediate);
  }
}

struct Change {
  const char* state;
  bool corrects = true;
};
class Changes : public testing::TestWithParam<Change> {};

// OpenGL 2.1, 5.4: commands in a list are as if they were given when it is called.
TEST_P(Changes, BetweenCompilationAndCallCount) {
  const auto [state, corrects] = GetParam();
  constexpr const char* kFamilies = "trapezoid,strip,non_planar";
  const auto is_drawn_as = [](const std::string& way, const Drawn& immediate) {
    const Drawn ours = draw(kFamilies, way, true), native = draw(kFamilies, way, false);
    EXPECT_EQ(ours.corrected, immediate.corrected) << way;
    EXPECT_EQ(ours.listed, immediate.immediate) << way;
    if (ours.corrected == 0) {
      EXPECT_TRUE(ours.pictures == native.pictures) << way;
    } else if (ours.pictures != immediate.pictures) {
      // Where a quad is left alone it is the driver's, as it draws lists.
      EXPECT_TRUE(each_pixel_from(ours.pictures, immediate.pictures, native.pictures)) << way;
    }
  };
  static const Drawn without = draw(kFamilies, "immediate", true);
  const Drawn within = draw(kFamilies, std::string("immediate_") + state, true);
  EXPECT_EQ(within.corrected > 0, corrects);
  is_drawn_as(std::string("before_") + state, within);
  is_drawn_as(std::string("within_") + state, without);
}

INSTANTIATE_TEST_SUITE_P(
    Lists, Changes,
    testing::Values(Change{"no_texture", false}, Change{"object_linear", false}, Change{"sphere_map", false}, Change{"vertex_shader", false},
                    Change{"fragment_shader", false}, Change{"vertex_program", false}, Change{"texture_matrix"}, Change{"modelview"},
                    Change{"projection"}, Change{"viewport"}, Change{"lines", false}, Change{"flat"}, Change{"lighting"},
                    Change{"equal_depth"}),
    [](const auto& info) { return std::string(info.param.state); });

// The driver compiles such a primitive, so it is drawn as without truequad; no vertex is lost.
TEST(Lists, InAPrimitiveThatIsExecutedDrawWhatTheDriverDraws) {
  for (const char* way : {"inside_executed_begin", "inside_executed_begin_many"}) {
    for (const char* family : {"affine", "trapezoid", "strip"}) {
      SCOPED_TRACE(std::string(way) + " " + family);
      const Drawn native = draw(family, way, false), ours = draw(family, way, true);
      EXPECT_TRUE(ours.pictures == native.pictures);
    }
  }
}

// The base that the list's own commands have set, brought back, or called. Mesa 22.3 alone crashes in such lists.
TEST(Lists, InAPrimitiveOfAListAreThoseOfTheBaseThatItHasSet) {
  const Drawn native = draw("affine", "immediate", false);
  for (const char* way : {"inside_listed_begin_by_base", "inside_listed_begin_by_popped_base", "inside_listed_begin_by_called_base",
                          "inside_executed_begin_by_popped_base"}) {
    SCOPED_TRACE(way);
    EXPECT_TRUE(draw("affine", way, true).pictures == native.pictures);
  }
}

TEST(Lists, QuadsBesideACorrectedOneAreAsTheDriverDrawsThem) {
  const Drawn native = draw("affine", "three_quads", false), ours = draw("affine", "three_quads", true);
  EXPECT_EQ(ours.corrected, long(kScenes));
  const auto differ = [&](unsigned from, unsigned to) {
    for (unsigned row = 0; row < kHeight; ++row) {
      const std::size_t begin = 4 * (std::size_t(row) * kWidth + from), size = 4 * (to - from);
      if (native.pictures.compare(begin, size, ours.pictures, begin, size) != 0) return true;
    }
    return false;
  };
  EXPECT_FALSE(differ(0, 52));
  EXPECT_TRUE(differ(52, 104));
  EXPECT_FALSE(differ(104, kWidth));
}

TEST(Lists, ADeletedListDrawsNothing) {
  for (const char* family : {"trapezoid", "affine"}) {
    const Drawn native = draw(family, "deleted_inner", false), ours = draw(family, "deleted_inner", true);
    EXPECT_TRUE(ours.pictures == native.pictures);
  }
}

// What a program can ask about lists, and the errors that it gets.
TEST(Lists, AnswersAreTheDriversOwn) {
  const auto native = run({ASK_LISTS});
  const auto ours = run({ASK_LISTS}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", "-"}});
  EXPECT_EQ(native.status, 0);
  EXPECT_EQ(ours.status, 0);
  EXPECT_NE(native.out, "");
  EXPECT_EQ(ours.out, native.out);
  const auto json = nlohmann::json::parse(ours.err, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ours.err;
  EXPECT_GT(json.value("corrected", 0), 0);
}

TEST(Lists, OfAFontOfTheWindowSystemAreTheDriversOwn) {
  const auto native = run({WITH_DISPLAY, FONT_LISTS});
  const auto ours = run({WITH_DISPLAY, "env", "LD_PRELOAD=" TRUEQUAD_PRELOAD, "TRUEQUAD_STATS=-", FONT_LISTS});
  EXPECT_EQ(native.status, 0) << native.err;
  EXPECT_EQ(ours.status, 0) << ours.err;
  EXPECT_NE(native.out, "");
  EXPECT_EQ(ours.out, native.out);
  const auto json = nlohmann::json::parse(ours.err, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ours.err;
  EXPECT_EQ(json.value("corrected", 0), 4);
}

}  // namespace
}  // namespace truequad::lists_test
