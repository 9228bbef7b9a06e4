// TRUEQUAD_COLOR=1: which quads are corrected for their colours, what is asked of the driver for it, and that a program finds
// everything as it left it. The pictures: tests/images/colours_test.cc.
#include <gtest/gtest.h>

#include <random>

#include "../trials.h"
#include "program.h"

namespace truequad::fake {
namespace {

// Runs with the option while it lives.
class WithColours : public testing::Test {
 protected:
  void SetUp() override {
    through_doors([](const Driver& gl) { gl.Begin(GL_QUADS), gl.End(); });  // for the thread's capture
    before_ = entry.own->options;
    colours_ = *before_;
    colours_.color = true;
    entry.own->options = &colours_;
  }
  void TearDown() override { entry.own->options = before_; }

 private:
  static inline Options colours_;
  const Options* before_ = nullptr;
};

enum class Given { kColours, kSecondary, kFog, kAffineColours, kNothing };

// A square without texture coordinates.
void square(const Driver& gl, Given given, GLenum mode = GL_QUADS) {
  const float saddle[4] = {0, 1, 0, 1}, even[4] = {0, 1, 1, 0};
  constexpr int kOrder[2][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}};
  gl.Begin(mode);
  for (int i : kOrder[mode == GL_QUAD_STRIP]) {
    if (given == Given::kColours) gl.Color3f(saddle[i], 0.5f, 1 - saddle[i]);
    if (given == Given::kSecondary) gl.SecondaryColor3f(saddle[i], saddle[i], 0);
    if (given == Given::kFog) gl.FogCoordf(saddle[i]);
    if (given == Given::kAffineColours) gl.Color3f(even[i], 0, 0);
    gl.Vertex2f(kSquare.corner[i].x, kSquare.corner[i].y);
  }
  gl.End();
}

struct Outcome {
  std::uint64_t corrected;
  Gl gl;
};
Outcome draw(const Program& program, const Gl& start = Gl()) {
  Outcome outcome{};
  outcome.corrected = growth(fake::corrected, [&] { outcome.gl = through_doors(program, start); });
  const Gl native = natively(program, start);
  EXPECT_EQ(outcome.gl.current, native.current);
  EXPECT_EQ(outcome.gl.enabled, native.enabled);
  EXPECT_TRUE(outcome.gl.all_errors.empty());
  EXPECT_EQ(outcome.gl.get_errors, 0u);
  return outcome;
}

Program of(Given given, GLenum mode = GL_QUADS) {
  return [=](const Driver& gl) { square(gl, given, mode); };
}
Gl flat() {
  Gl start;
  start.numbers[GL_SHADE_MODEL] = {GL_FLAT};
  return start;
}

TEST(Colours, AreNoReasonWithoutTheOption) {
  const std::uint64_t before = passed(Reason::kNoTextureVaries);
  EXPECT_EQ(draw(of(Given::kColours)).corrected, 0u);
  EXPECT_EQ(passed(Reason::kNoTextureVaries), before + 1);
  EXPECT_EQ(draw(of(Given::kColours)).gl.gets, 0u);
}

TEST_F(WithColours, ASaddleBecomesAMeshInEveryMode) {
  for (GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    const Outcome outcome = draw(of(Given::kColours, mode));
    EXPECT_EQ(outcome.corrected, 1u);
    const Primitive& mesh = outcome.gl.drawn.back();
    ASSERT_EQ(mesh.mode, GLenum(GL_TRIANGLES));
    EXPECT_GT(mesh.vertices.size(), 300u);
    for (const Values& v : mesh.vertices) {
      const float u = v[kPosition][0] + 0.5f, w = v[kPosition][1] + 0.5f;
      const float saddle = u * (1 - w) + (1 - u) * w;
      EXPECT_NEAR(v[kColor][0], saddle, 1e-5);
      EXPECT_NEAR(v[kColor][1], 0.5f, 1e-6);
      EXPECT_NEAR(v[kColor][2], 1 - saddle, 1e-5);
    }
  }
}

TEST_F(WithColours, AffineColoursArePassedAtOneQueryForEachBegin) {
  const Outcome first = draw(of(Given::kAffineColours));
  const Outcome both = draw([](const Driver& gl) {
    square(gl, Given::kAffineColours);
    square(gl, Given::kNothing);
  });
  EXPECT_EQ(first.corrected, 0u);
  EXPECT_EQ(both.corrected, 0u);
  EXPECT_EQ(both.gl.gets, first.gl.gets + 1);
  // The calls are the program's own.
  const Gl native = natively(of(Given::kAffineColours));
  ASSERT_GE(first.gl.log.size(), native.log.size());
  EXPECT_TRUE(std::equal(native.log.begin(), native.log.end(), first.gl.log.end() - long(native.log.size())));
}

TEST_F(WithColours, FlatShadingIsNeverCorrected) {
  const std::uint64_t before = passed(Reason::kNoTextureVaries);
  EXPECT_EQ(draw(of(Given::kColours), flat()).corrected, 0u);
  EXPECT_EQ(passed(Reason::kNoTextureVaries), before + 1);
}

TEST_F(WithColours, WhatIsNotShownIsNotCorrected) {
  EXPECT_EQ(draw(of(Given::kSecondary)).corrected, 0u);
  EXPECT_EQ(draw(of(Given::kFog)).corrected, 0u);
  Gl sum, fog;
  sum.enabled = {GL_COLOR_SUM};
  EXPECT_EQ(draw(of(Given::kSecondary), sum).corrected, 1u);
  fog.enabled = {GL_FOG};
  fog.numbers[GL_FOG_COORD_SRC] = {GL_FRAGMENT_DEPTH};
  EXPECT_EQ(draw(of(Given::kFog), fog).corrected, 0u);
  fog.numbers[GL_FOG_COORD_SRC] = {GL_FOG_COORD};
  fog.numbers[GL_FOG_MODE] = {GL_LINEAR};
  fog.numbers[GL_FOG_START] = {0};
  fog.numbers[GL_FOG_END] = {1};
  EXPECT_EQ(draw(of(Given::kFog), fog).corrected, 1u);
  // A fog that thickens by less than a step over the square.
  fog.numbers[GL_FOG_END] = {1000};
  EXPECT_EQ(draw(of(Given::kFog), fog).corrected, 0u);
  fog.numbers[GL_FOG_MODE] = {GL_EXP2};
  fog.numbers[GL_FOG_DENSITY] = {1};
  EXPECT_EQ(draw(of(Given::kFog), fog).corrected, 1u);
  fog.numbers[GL_FOG_DENSITY] = {0};
  EXPECT_EQ(draw(of(Given::kFog), fog).corrected, 0u);
}

TEST_F(WithColours, ALampNearASquareIsSeen) {
  Gl start;
  start.enabled = {GL_LIGHTING, GL_LIGHT0};
  start.lights[GL_LIGHT0][GL_POSITION] = {0.25f, 0.5f, 0.5f, 1};
  for (unsigned face = 0; face < 2; ++face) start.current[kMaterial + face * kMaterialProperties + 1] = {1, 1, 1, 1};
  EXPECT_EQ(draw(of(Given::kNothing), start).corrected, 1u);
  start.lights[GL_LIGHT0][GL_POSITION] = {0.25f, 0.5f, 0.5f, 0};
  EXPECT_EQ(draw(of(Given::kNothing), start).corrected, 0u) << "all corners have one colour";
}

TEST_F(WithColours, TheReasonsOfTheTextureAreNone) {
  const Program textured = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      gl.Color3f(float(i % 2), 0, 0);
      kTrapezoid.vertex(gl, i);
    }
    gl.End();
  };
  Gl off;
  off.unit_enabled[0] = {};
  EXPECT_EQ(draw(textured, off).corrected, 1u);
  Gl generated;
  generated.unit_enabled[0] = {GL_TEXTURE_2D, GL_TEXTURE_GEN_S};
  EXPECT_EQ(draw(textured, generated).corrected, 1u);

  const std::uint64_t before = passed(Reason::kOwnQ);
  EXPECT_EQ(draw([](const Driver& gl) {
              gl.Begin(GL_QUADS);
              for (int i = 0; i < 4; ++i) {
                gl.Color3f(float(i % 2), 0, 0);
                gl.TexCoord4f(float(i == 1 || i == 2), float(i >= 2), 0, float(1 + i));
                gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
              }
              gl.End();
            }).corrected,
            0u);
  EXPECT_EQ(passed(Reason::kOwnQ), before + 1);

  Gl program;
  program.numbers[GL_CURRENT_PROGRAM] = {3};
  const std::uint64_t programs = passed(Reason::kProgram);
  EXPECT_EQ(draw(of(Given::kColours), program).corrected, 0u);
  EXPECT_EQ(passed(Reason::kProgram), programs + 1);
}

// Attributes that begin in the midst of a quad, quads that are passed between others, other primitives.
TEST_F(WithColours, RandomProgramsLeaveEveryCurrentValueAndNoError) {
  std::uint64_t corrections = 0;
  for (unsigned seed = 0; seed < test::trials(600, 16); ++seed) {
    SCOPED_TRACE(seed);
    Gl start;
    if (seed % 3 == 1) start.enabled = {GL_LIGHTING, GL_LIGHT0};
    if (seed % 3 == 2) start.enabled = {GL_COLOR_SUM};
    corrections += draw(
                       [seed](const Driver& gl) {
                         std::mt19937 random(seed);
                         const auto number = [&] { return float(int(random() % 256)) / 256; };
                         for (unsigned n = 1 + random() % 4; n > 0; --n) {
                           gl.Begin(GL_QUADS + random() % 3);
                           for (unsigned i = 0, count = random() % 14; i < count; ++i) {
                             if (random() % 3 == 0) gl.Color4f(number(), number(), number(), number());
                             if (random() % 5 == 0) gl.SecondaryColor3f(number(), number(), number());
                             if (random() % 5 == 0) gl.Normal3f(number(), number(), 1);
                             if (random() % 6 == 0) gl.FogCoordf(number());
                             if (random() % 6 == 0) gl.TexCoord2f(number(), number());
                             const UnitPatch& patch = random() % 2 ? kSquare : kTrapezoid;
                             gl.Vertex2f(patch.corner[i % 4].x, patch.corner[i % 4].y);
                           }
                           gl.End();
                         }
                       },
                       start)
                       .corrected;
    if (HasFailure()) return;
  }
  EXPECT_GT(corrections, test::trials(300, 16));
}

}  // namespace
}  // namespace truequad::fake
