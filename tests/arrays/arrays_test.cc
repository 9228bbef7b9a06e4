// A quad from vertex arrays is drawn exactly as the same quad in immediate mode, whichever way its arrays and buffers come
// about; a draw without a quad to correct is as without truequad, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "run.h"

namespace truequad::arrays_test {
namespace {

using doors_test::read_file;
using doors_test::run;
using doors_test::Scratch;

struct Drawn {
  std::string pictures;
  nlohmann::json statistics;
  long corrected() const { return statistics.value("corrected", -1L); }
  long by(const char* path) const { return statistics["by_path"].value(path, -1L); }
};

constexpr std::size_t kSeeds = 3, kWidth = 120, kHeight = 90;

Drawn draw(const std::string& families, const std::string& way, bool with_truequad) {
  const Scratch scratch;
  const std::string file = scratch / "raw", statistics = scratch / "json";
  std::map<std::string, std::string> environment;
  if (with_truequad) environment = {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", statistics}};
  const auto ended = run({DRAW_ARRAYS, families, std::to_string(kSeeds), std::to_string(kWidth), std::to_string(kHeight), way, file},
                         environment);
  EXPECT_EQ(ended.status, 0) << families << " " << way << ": " << ended.err;
  EXPECT_EQ(ended.err, "");
  Drawn drawn{read_file(file), {}};
  const std::size_t count = 1 + std::size_t(std::count(families.begin(), families.end(), ','));
  EXPECT_EQ(drawn.pictures.size(), count * kSeeds * kWidth * kHeight * 4);
  if (with_truequad) {
    drawn.statistics = nlohmann::json::parse(read_file(statistics), nullptr, false);
    EXPECT_TRUE(drawn.statistics.is_object());
  }
  return drawn;
}

struct Way {
  const char* name;
  const char* path;  // where the statistics count it
  long draws = 1;
};
constexpr Way kWays[] = {
    {"arrays", "arrays"},
    {"arrays_ext", "arrays"},
    {"twice", "arrays", 2},
    {"bytes", "arrays"},
    {"shorts", "arrays"},
    {"ints", "arrays"},
    {"range", "arrays"},
    {"interleaved", "arrays"},
    {"pushed", "arrays", 2},
    {"doubles", "arrays"},
    {"unaligned", "arrays"},
    {"multi_arrays", "arrays"},
    {"multi_elements", "arrays"},
    {"base_vertex", "arrays"},
    {"multi_base_vertex", "arrays"},
    {"instanced", "arrays", 2},
    {"indirect", "buffer", 2},
    {"indirect_elements", "buffer"},
    {"restart", "arrays"},
    {"restart_fixed", "arrays"},
    {"locked", "arrays"},
    {"index_buffer", "arrays"},
    {"array_element", "immediate"},
    {"mixed_element", "immediate"},
    {"element_of_buffer", "immediate"},
    {"list", "list"},
    {"list_of_elements", "list"},
    {"list_executed", "list"},
    {"list_of_array_element", "list"},
    {"buffer", "buffer"},
    {"vertex_array_objects", "buffer"},
    {"data", "buffer", 2},
    {"sub_data", "buffer", 2},
    {"named", "buffer", 2},
    {"map", "buffer", 2},
    {"map_range", "buffer", 2},
    {"copied", "buffer", 2},
    {"cleared", "buffer", 2},
    {"deleted", "buffer", 2},
    {"other_context", "buffer", 2},
    {"pixels_packed", "buffer", 2},
};

// In all of these every quad is corrected, or drawn by the same two triangles whichever way it comes. Quads that pass are drawn
// by the program's own calls, and drivers divide quads with indices along the other diagonal.
constexpr const char* kFamilies = "trapezoid,near_plane,strip,non_planar,bow_tie,polygon";
// Some quads are within the tolerance, among others that are not.
constexpr const char* kMixedFamilies = "dragged,mesh";

class Ways : public testing::TestWithParam<Way> {};

TEST_P(Ways, DrawWhatImmediateModeDraws) {
  const Way way = GetParam();
  static const Drawn immediate = draw(kFamilies, "immediate", true);
  ASSERT_GT(immediate.corrected(), 0);
  const Drawn ours = draw(kFamilies, way.name, true);
  EXPECT_TRUE(ours.pictures == immediate.pictures);
  EXPECT_EQ(ours.corrected(), way.draws * immediate.corrected());
  EXPECT_EQ(ours.by(way.path), way.draws * immediate.by("immediate"));
  EXPECT_EQ(ours.by(way.path), ours.statistics.value("quads", -1L));
}

TEST(Arrays, DrawRunsOfQuadsThatPassByTheirOwnCalls) {
  const Drawn immediate = draw(kMixedFamilies, "immediate", true);
  ASSERT_GT(immediate.statistics["pass_reasons"].value("within_tolerance", 0), 0);
  for (const char* way : {"arrays", "multi_arrays", "buffer"}) {
    SCOPED_TRACE(way);
    const Drawn ours = draw(kMixedFamilies, way, true);
    EXPECT_TRUE(ours.pictures == immediate.pictures);
    EXPECT_EQ(ours.corrected(), immediate.corrected());
  }
  // A list's quads that pass are the driver's list, and Mesa cuts those along the other diagonal.
  const Drawn native = draw(kMixedFamilies, "list", false), ours = draw(kMixedFamilies, "list", true);
  EXPECT_EQ(ours.corrected(), immediate.corrected());
  ASSERT_EQ(ours.pictures.size(), immediate.pictures.size());
  ASSERT_EQ(ours.pictures.size(), native.pictures.size());
  long neither = 0;
  for (std::size_t i = 0; i < ours.pictures.size(); ++i) {
    neither += ours.pictures[i] != immediate.pictures[i] && ours.pictures[i] != native.pictures[i];
  }
  EXPECT_EQ(neither, 0);
}

TEST_P(Ways, LeaveAffineQuadsToTheDriver) {
  const Way way = GetParam();
  const Drawn native = draw("affine", way.name, false), ours = draw("affine", way.name, true);
  EXPECT_EQ(ours.corrected(), 0);
  EXPECT_GT(ours.by(way.path), 0);
  EXPECT_TRUE(ours.pictures == native.pictures);
}

INSTANTIATE_TEST_SUITE_P(Arrays, Ways, testing::ValuesIn(kWays),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Arrays, MeetEarlierAndLaterPasses) {
  const Drawn immediate = draw(kFamilies, "passes_immediate", true);
  ASSERT_GT(immediate.corrected(), 0);
  for (const char* way : {"passes_arrays", "passes_arrays_first"}) {
    SCOPED_TRACE(way);
    const Drawn ours = draw(kFamilies, way, true);
    EXPECT_TRUE(ours.pictures == immediate.pictures);
    EXPECT_EQ(ours.corrected(), immediate.corrected());
  }
}

TEST(Arrays, ARectangleMeetsTheMeshBelowIt) {
  const Drawn immediate = draw("trapezoid", "rectangle_immediate", true), ours = draw("trapezoid", "rectangle", true);
  EXPECT_TRUE(ours.pictures == immediate.pictures);
  EXPECT_EQ(ours.corrected(), immediate.corrected());
  EXPECT_EQ(ours.corrected(), 2 * long(kSeeds));
  EXPECT_EQ(ours.by("rect"), long(kSeeds));
}

TEST(Arrays, OfEveryTypeAreDrawnAlike) {
  constexpr const char* kWhole = "trapezoid,strip,non_planar";
  const Drawn immediate = draw(kWhole, "typed_immediate", true);
  ASSERT_GT(immediate.corrected(), 0);
  for (const char* way : {"typed_floats", "typed_shorts", "typed_ints", "typed_doubles", "typed_halves"}) {
    SCOPED_TRACE(way);
    const Drawn ours = draw(kWhole, way, true);
    EXPECT_TRUE(ours.pictures == immediate.pictures);
    EXPECT_EQ(ours.corrected(), immediate.corrected());
  }
}

// The colours of a corrected quad come from the same numbers, whatever their type.
TEST(Arrays, OfColoursAndNormalsOfEveryTypeAreDrawnAlike) {
  for (const std::string what : {"colored_", "lit_"}) {
    std::string floats;
    for (const char* type : {"floats", "doubles", "bytes", "shorts", "ints", "packed", "unsigned_packed"}) {
      // Packed normals Mesa refuses, though the extension has them.
      if (what == "lit_" && std::string(type).ends_with("packed")) continue;
      SCOPED_TRACE(what + type);
      const Drawn immediate = draw("strip", what + type + "_immediate", true), ours = draw("strip", what + type, true);
      ASSERT_GT(immediate.corrected(), 0);
      EXPECT_EQ(ours.corrected(), immediate.corrected());
      EXPECT_TRUE(ours.pictures == immediate.pictures);
      // What a few bits cannot say is seen.
      if (std::string(type) == "floats") floats = ours.pictures;
      if (std::string(type) == "bytes" || std::string(type) == "packed") {
        EXPECT_TRUE(ours.pictures != floats);
      }
    }
  }
}

// Bindings, current values, errors and their order, where arrays are wrong or memory ends; and pictures, where nothing is
// corrected.
TEST(Arrays, AnswersAreTheDriversOwn) {
  const auto native = run({ASK_ARRAYS});
  const auto ours = run({ASK_ARRAYS}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", "-"}});
  EXPECT_EQ(native.status, 0);
  EXPECT_EQ(ours.status, 0);
  EXPECT_NE(native.out, "");
  EXPECT_EQ(ours.out, native.out);
  const auto json = nlohmann::json::parse(ours.err, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ours.err;
  EXPECT_GT(json.value("corrected", 0), 0);
  EXPECT_GT(json["by_path"].value("rect", 0), 0);
}

// What is remembered of what reads arrays is asked anew after every call that may change it: an array that nothing reads
// has no memory, and each quad that can be is corrected.
TEST(Arrays, AreReadOnlyWhileTheDriverReadsThem) {
  const auto native = run({CHANGE_READERS});
  const auto ours = run({CHANGE_READERS}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", "-"}});
  EXPECT_EQ(native.status, 0) << native.out;
  EXPECT_EQ(ours.status, 0) << ours.out;
  EXPECT_EQ(ours.out, native.out);
  const auto json = nlohmann::json::parse(ours.err, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ours.err;
  // Thirteen changes, before and after; four draws from indices.
  EXPECT_EQ(json.value("corrected", 0), 2 * 13 + 4);
}

// What a driver does with buffers that are deleted differs: where it ends by a signal, it does so with us, and no sooner.
TEST(Arrays, OfDeletedBuffersAreTheDriversOwn) {
  for (const char* what : {"bound", "bound_in_a_list", "mapped", "created_again", "kept_by_an_object",
                           "kept_by_an_object_and_created_again", "indices", "indices_kept_by_an_object_and_created_again",
                           "kept_by_another_context_and_created_again", "kept_by_pushed_arrays_and_created_again"}) {
    SCOPED_TRACE(what);
    const auto native = run({ASK_DELETED, what}), ours = run({ASK_DELETED, what}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}});
    EXPECT_NE(native.out, "");
    EXPECT_EQ(ours.out, native.out);
    EXPECT_EQ(ours.status, native.status);
  }
}

// A name that was deleted is no reason to leave alone what was bound afterwards.
TEST(Arrays, OfANewBufferUnderAnOldNameAreCorrected) {
  const auto ours = run({ASK_DELETED, "in_a_new_object"}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", "-"}});
  EXPECT_EQ(ours.status, 0);
  const auto json = nlohmann::json::parse(ours.err, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ours.err;
  EXPECT_EQ(json.value("corrected", 0), 1);
}

// The driver draws nothing, so that what grows is memory of ours, or what the driver keeps of any draw.
TEST(Arrays, MemoryIsBoundedForTenMillionVertices) {
  for (const std::string way : {"indices", "buffer_of_indices", "arrays", "buffer", "list", "list_of_arrays"}) {
    SCOPED_TRACE(way);
    const auto native = run({DRAW_MANY, way}, {{"GALLIUM_NOOP", "1"}});
    const auto ours = run({DRAW_MANY, way}, {{"GALLIUM_NOOP", "1"}, {"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", "-"}});
    EXPECT_EQ(native.status, 0);
    EXPECT_EQ(ours.status, 0);
    const auto json = nlohmann::json::parse(ours.err, nullptr, false);
    ASSERT_TRUE(json.is_object()) << ours.err;
    // All, and those before them.
    const bool indexed = way.find("indices") != std::string::npos;
    EXPECT_EQ(json.value("quads", 0), indexed ? 2'500'002 : 2'750'000);
    EXPECT_EQ(json.value("corrected", 0), indexed ? 2'501 : 2'750);
    std::printf("%s: %d MiB natively, %d with truequad\n", way.c_str(), std::stoi(native.out), std::stoi(ours.out));
    EXPECT_LE(std::stoi(ours.out), std::stoi(native.out) + 24);
  }
}

TEST(Arrays, LibrariesThatDrawQuadsAreReached) {
  for (const char* library : {"glu", "ftgl"}) {
    SCOPED_TRACE(library);
    const auto ended = run({DRAW_WITH_LIBRARIES, library}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", "-"}});
    EXPECT_EQ(ended.status, 0);
    const auto json = nlohmann::json::parse(ended.err, nullptr, false);
    ASSERT_TRUE(json.is_object()) << ended.err;
    EXPECT_GT(json.value("quads", 0), 0);
    const bool warped = std::string(library) == "glu";
    EXPECT_EQ(json.value("corrected", 0) > 0, warped);
  }
}

// What is mapped may change at any time.
TEST(Arrays, OfABufferThatStaysMappedAreLeftAlone) {
  const Drawn native = draw(kFamilies, "persistent", false), ours = draw(kFamilies, "persistent", true);
  EXPECT_GT(ours.statistics["pass_reasons"].value("buffer", 0), 0);
  EXPECT_TRUE(ours.pictures == native.pictures);
}

}  // namespace
}  // namespace truequad::arrays_test
