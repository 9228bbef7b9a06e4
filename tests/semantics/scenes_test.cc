// Single features of OpenGL on corrected quads: what is seen and what is answered is the driver's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "run_semantics.h"

namespace truequad::semantics {
namespace {

enum class Corrected { kSome, kNone };

struct Expected {
  const char* scene;
  int tolerance;  // of a byte of the pictures; other records are the same to the last bit
  Corrected corrected = Corrected::kSome;
  unsigned seeds = 3;
};
void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.scene; }

// Interpolated over other triangles, a value that is linear in the position is rounded to a neighbouring byte
// at most.
const std::vector<Expected> kScenes = {
    {"flat_last", 0},
    {"flat_first", 0},
    {"flat_late", 0},
    {"flat_secondary", 0},
    {"smooth", 1},
    {"secondary", 1},
    {"unclamped", 1},
    {"fog_coordinate", 1},
    {"fog_of_depth", 1},
    {"translucent", 0},
    {"alpha_test", 0},
    {"logic_operation", 0},
    {"directional", 1},
    {"normals_of_any_length", 1},
    {"normals_by_length", 1},
    {"two_sided", 1},
    {"material_for_each_vertex", 1},
    {"colour_material", 1},
    {"flat_lamp_last", 1},
    {"flat_lamp_first", 1},
    {"flat_highlight", 1},
    {"flat_random_lights", 1, Corrected::kSome, 16},
    {"culling", 0},
    {"stipple", 0},
    {"smooth_edges", 0, Corrected::kNone},
    {"mode_line", 0, Corrected::kNone},
    {"mode_point", 0, Corrected::kNone},
    {"mode_front_line", 0, Corrected::kNone},
    {"mode_back_line", 0, Corrected::kNone},
    {"filled_with_edge_flags", 0},
    {"samples", 0},
    {"offset_layers", 0},
    {"windowed", 0},
    {"second_unit_1d", 1},
    {"second_unit_2d", 1},
    {"second_unit_3d", 1},
    {"second_unit_rectangle", 1},
    {"second_unit_cube", 1},
    {"matrices", 1},
    {"projective_matrix", 1},
    {"generated", 1},
    {"constant_second", 1},
    {"other_unit_active", 1},
    {"warped_1d", 1},
    {"warped_3d", 1},
    {"warped_rectangle", 1},
    {"own_q", 0, Corrected::kNone},
    {"sphere_map", 0, Corrected::kNone},
    {"feedback", 0},
    {"selection", 0},
    {"samples_passed", 0},
    {"primitives_generated", 0},
    {"vertices_submitted", 0},
    {"primitives_submitted", 0},
    {"vertex_invocations", 0},
    {"clipping_input", 0},
    {"clipping_output", 0},
    {"fragment_invocations", 0},
    {"conditional", 0},
    {"transform_feedback", 0},
    {"fragment_program", 0, Corrected::kNone},
    {"state", 0},
    {"attribute_stack", 1},
    {"lists", 1},
    {"debug_output", 0},
    {"names", 0},
    {"errors_at_last", 0, Corrected::kSome, 150},
    {"pictures_of_calls", 0, Corrected::kSome, 60},
    {"illegal_calls", 0, Corrected::kSome, 150},
    {"legal_calls", 0, Corrected::kSome, 150},
    {"calls_of_mixed_sizes", 0, Corrected::kSome, 150},
    {"bad_vertices", 0, Corrected::kSome, 1},
    {"extreme_vertices", 1, Corrected::kSome, 1},
    {"lit_by_bad_numbers", 0, Corrected::kSome, 1},
    {"bad_matrices", 0, Corrected::kSome, 1},
    {"bad_viewports", 0, Corrected::kSome, 1},
    {"flat_textures", 0, Corrected::kSome, 1},
    {"touched_once", 0, Corrected::kSome, 120},
    {"mirrored_sides", 1, Corrected::kSome, 1},
    {"accumulated", 1},
    {"copied", 0},
    {"reversed_depth", 0},
    {"nested_names", 0},
    {"fed_in_every_form", 0, Corrected::kSome, 1},
    {"everything_in_a_list", 0},
    {"nested_lists", 0, Corrected::kSome, 1},
};

constexpr std::size_t kPictureBytes = std::size_t(kWidth) * kHeight * 4;

// How many bytes of two records differ by more than `tolerance`, by how much, and where first.
struct Difference {
  long bytes = 0;
  int largest = 0;
  std::size_t first = 0;
};
Difference difference(const std::string& a, const std::string& b, int tolerance) {
  Difference sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int by = std::abs(int((unsigned char)(a[i])) - int((unsigned char)(b[i])));
    if (by <= tolerance) continue;
    if (sum.bytes++ == 0) sum.first = i;
    sum.largest = std::max(sum.largest, by);
  }
  return sum;
}

class Scenes : public testing::TestWithParam<Expected> {};

// `way`: a prefix of the scene's name (draw_semantics.cc).
void expect_native(const Expected& expected, const std::string& interface, const std::string& way = "", bool color = false) {
  const Job job{interface, way + expected.scene, 0, expected.seeds};
  const Outcome native = run_natively(job), seen = run_with_truequad(job, "bilinear", color);
  ASSERT_FALSE(native.records.empty() || seen.records.empty());
  ASSERT_EQ(native.records.size(), seen.records.size());
  EXPECT_GT(seen.quads, 0);
  if (expected.corrected == Corrected::kSome)
    EXPECT_GT(seen.corrected, 0);
  else
    EXPECT_EQ(seen.corrected, 0);
  int largest = 0;
  for (const auto& [name, bytes] : native.records) {
    const std::string& other = seen.records.at(name);
    const bool picture = bytes.size() == kPictureBytes;
    ASSERT_EQ(bytes.size(), other.size()) << name;
    const Difference found = difference(bytes, other, picture ? expected.tolerance : 0);
    largest = std::max(largest, found.largest);
    EXPECT_EQ(found.bytes, 0) << interface << " " << job.scene << " " << name << ": from byte " << found.first << " on, by up to "
                              << found.largest;
  }
  std::printf("%s %s: %zu records, %ld quads, %ld corrected\n", interface.c_str(), job.scene.c_str(),
              native.records.size(), seen.quads, seen.corrected);
}

TEST_P(Scenes, AreTheDriversOwn) { expect_native(GetParam(), "osmesa"); }

std::string scene_of(const testing::TestParamInfo<Expected>& info) { return info.param.scene; }
INSTANTIATE_TEST_SUITE_P(Feature, Scenes, testing::ValuesIn(kScenes), scene_of);

class OtherInterfaces : public testing::TestWithParam<const char*> {};

TEST_P(OtherInterfaces, AreTheDriversOwn) {
  for (Expected expected : kScenes) {
    const std::string scene = expected.scene;
    for (const char* one :
         {"flat_first", "smooth", "translucent", "culling", "samples", "second_unit_2d", "feedback",
          "samples_passed", "transform_feedback", "state", "attribute_stack", "lists", "debug_output", "bad_vertices", "extreme_vertices",
          "lit_by_bad_numbers", "bad_matrices", "bad_viewports"}) {
      if (scene != one) continue;
      expected.seeds = 1;
      expect_native(expected, GetParam());
    }
  }
}

// Not those that record what is asked for in words of their own, or make lists themselves; nor those that go on with the
// current values of a list, where Mesa's own lists leave others (docs/semantics.md).
bool draws_shapes(const std::string& scene) {
  for (const char* other : {"feedback", "selection", "state", "attribute_stack", "lists", "debug_output", "names", "errors_at_last", "flat_random_lights",
                            "pictures_of_calls", "illegal_calls", "legal_calls", "calls_of_mixed_sizes", "bad_vertices", "extreme_vertices",
                            "lit_by_bad_numbers", "bad_matrices", "bad_viewports", "nested_names", "fed_in_every_form",
                            "everything_in_a_list", "nested_lists"}) {
    if (scene == other) return false;
  }
  return true;
}

// Each shape is a list, which is compiled and then called, or executed while it is compiled.
class InLists : public testing::TestWithParam<const char*> {};

TEST_P(InLists, AreTheDriversOwn) {
  for (Expected expected : kScenes) {
    if (!draws_shapes(expected.scene)) continue;
    expected.seeds = 1;
    expect_native(expected, "osmesa", GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(Feature, InLists, testing::Values("compile:", "execute:"),
                         [](const auto& info) { return std::string(info.param).substr(0, 7); });

// What is one colour or linear in the position is as natively with TRUEQUAD_COLOR=1 too.
TEST(WithColours, AreTheDriversOwn) {
  for (Expected expected : kScenes) {
    expected.seeds = std::min(expected.seeds, 2u);
    expect_native(expected, "osmesa", "", true);
  }
}

// Other colours are drawn the same whichever way the quads come, and not as natively.
TEST(WithColours, AreTheSameEveryWay) {
  const Job immediate{"osmesa", "kinked", 0, 1};
  const Outcome wanted = run_with_truequad(immediate, "bilinear", true), native = run_natively(immediate);
  ASSERT_FALSE(wanted.records.empty());
  EXPECT_GE(wanted.corrected, wanted.quads * 9 / 10);
  EXPECT_FALSE(wanted.records == native.records);
  for (const char* way : {"compile:kinked", "execute:kinked", "kinked_arrays", "compile:kinked_arrays"}) {
    const Outcome seen = run_with_truequad({"osmesa", way, 0, 1}, "bilinear", true);
    EXPECT_EQ(seen.corrected, wanted.corrected) << way;
    for (const auto& [name, bytes] : wanted.records) EXPECT_TRUE(bytes == seen.records.at(name)) << way << " " << name;
  }
}

// Textures of other kinds are corrected as those of two dimensions are, to the last bit.
class SeenTextures : public testing::TestWithParam<const char*> {};

TEST_P(SeenTextures, AreThoseOfTwoDimensions) {
  const Job job{"osmesa", GetParam(), 0, 2};
  const Outcome native = run_natively(job), seen = run_with_truequad(job);
  ASSERT_FALSE(native.records.empty() || seen.records.empty());
  EXPECT_GT(seen.corrected, 0);
  bool changed = false;
  for (const auto& [name, bytes] : seen.records) {
    changed |= bytes != native.records.at(name);
    if (!name.starts_with("seen ")) continue;
    EXPECT_TRUE(bytes == seen.records.at("plane " + name.substr(5))) << name;
  }
  EXPECT_TRUE(changed);
}

INSTANTIATE_TEST_SUITE_P(Feature, SeenTextures, testing::Values("seen_1d", "seen_3d", "seen_rectangle"),
                         [](const auto& info) { return std::string(info.param); });

INSTANTIATE_TEST_SUITE_P(Feature, OtherInterfaces, testing::Values("egl", "glx"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace truequad::semantics
