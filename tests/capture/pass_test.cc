// Every reason for which a quad is left alone: counted, the picture the driver's own, and no error raised in asking.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"

namespace truequad::fake {
namespace {

void draw_warped(const Driver& gl) {
  gl.Begin(GL_QUADS);
  kTrapezoid.draw(gl);
  gl.End();
}

// The quad is drawn as it is, for this reason and no other.
void expect_passed(Reason reason, const Gl& start, const Program& program = draw_warped) {
  SCOPED_TRACE(kReasonNames[std::size_t(reason)]);
  const Gl native = natively(program, start);
  const std::uint64_t for_reason = passed(reason), all = passed(), drawn = corrected();
  const Gl ours = through_doors(program, start);
  EXPECT_EQ(passed(reason) - for_reason, 1u);
  EXPECT_EQ(passed() - all, 1u);
  EXPECT_EQ(corrected(), drawn);
  EXPECT_EQ(ours.current, native.current);
  EXPECT_TRUE(ours.all_errors.empty());
  EXPECT_EQ(ours.get_errors, 0u);
  // A cut primitive is begun anew: the last one holds the quad.
  ASSERT_FALSE(ours.drawn.empty());
  EXPECT_EQ(ours.drawn.back().mode, native.drawn.back().mode);
  EXPECT_EQ(ours.drawn.back().vertices, native.drawn.back().vertices);
}

Program with_corners(std::function<void(const Driver&, int)> vertex) {
  return [vertex](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) vertex(gl, i);
    gl.End();
  };
}

TEST(Pass, TheQuadItselfGivesTheReason) {
  const Gl start;
  expect_passed(Reason::kAffine, start, [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    kSquare.draw(gl);
    gl.End();
  });
  expect_passed(Reason::kNoTextureVaries, start, with_corners([](const Driver& gl, int i) {
    gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
  }));
  expect_passed(Reason::kNoTextureVaries, start, with_corners([](const Driver& gl, int i) {
    gl.TexCoord2f(0.5f, 0.25f);
    gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
  }));
  for (float bad : {NAN, INFINITY, -INFINITY}) {
    expect_passed(Reason::kNotFinite, start, with_corners([bad](const Driver& gl, int i) {
      gl.TexCoord2f(float(i == 1 || i == 2), float(i >= 2));
      gl.Vertex2f(i == 2 ? INFINITY : kTrapezoid.corner[i].x, bad > 0 ? kTrapezoid.corner[i].y : -1.f / 0.f);
    }));
  }
  expect_passed(Reason::kDegenerate, start, with_corners([](const Driver& gl, int i) {
    gl.TexCoord2f(float(i == 1 || i == 2), float(i >= 2));
    gl.Vertex2f(float(i * i), float(2 * i * i));
  }));
  expect_passed(Reason::kInvisible, start, with_corners([](const Driver& gl, int i) {
    gl.TexCoord2f(float(i == 1 || i == 2), float(i >= 2));
    gl.Vertex2f(kTrapezoid.corner[i].x + 5, kTrapezoid.corner[i].y);
  }));
  expect_passed(Reason::kWithinTolerance, start, with_corners([](const Driver& gl, int i) {
    gl.TexCoord2f(float(i == 1 || i == 2), float(i >= 2));
    gl.Vertex2f(0.002f * kTrapezoid.corner[i].x, 0.002f * kTrapezoid.corner[i].y);
  }));
  expect_passed(Reason::kOwnQ, start, with_corners([](const Driver& gl, int i) {
    const float q = i == 2 ? 2 : 1;
    gl.TexCoord4f(q * float(i == 1 || i == 2), q * float(i >= 2), 0, q);
    gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
  }));
  expect_passed(Reason::kGenericAttribute, start, with_corners([](const Driver& gl, int i) {
    gl.VertexAttrib4f(5, float(i), 0, 0, 1);
    kTrapezoid.vertex(gl, i);
  }));
  expect_passed(Reason::kIncomplete, start, [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 3; ++i) kTrapezoid.vertex(gl, i);
    gl.End();
  });
}

TEST(Pass, TheStateGivesTheReason) {
  const auto with = [](auto change) {
    Gl start;
    change(start);
    return start;
  };
  expect_passed(Reason::kTexturingOff, with([](Gl& g) { g.unit_enabled.clear(); }));
  expect_passed(Reason::kTexturingOff, with([](Gl& g) { g.unit_enabled = {{1, {GL_TEXTURE_2D}}}; }));
  for (GLenum coordinate : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T}) {
    expect_passed(Reason::kTextureGeneration, with([&](Gl& g) { g.unit_enabled[0].insert(coordinate); }));
  }
  expect_passed(Reason::kProgram, with([](Gl& g) { g.numbers[GL_CURRENT_PROGRAM] = {7}; }));
  expect_passed(Reason::kProgram, with([](Gl& g) {
    g.extensions = {"GL_ARB_separate_shader_objects"};
    g.numbers[GL_PROGRAM_PIPELINE_BINDING] = {3};
  }));
  expect_passed(Reason::kProgram, with([](Gl& g) {
    g.version = "1.4 fake";
    g.extensions = {"GL_ARB_shader_objects"};
    g.numbers[GL_PROGRAM_OBJECT_ARB] = {3};
  }));
  const std::pair<const char*, GLenum> programs[] = {
      {"GL_ARB_vertex_program", GL_VERTEX_PROGRAM_ARB},   {"GL_ARB_fragment_program", GL_FRAGMENT_PROGRAM_ARB},
      {"GL_NV_fragment_program", GL_FRAGMENT_PROGRAM_NV}, {"GL_ATI_fragment_shader", GL_FRAGMENT_SHADER_ATI},
      {"GL_EXT_vertex_shader", GL_VERTEX_SHADER_EXT},     {"GL_NV_texture_shader", GL_TEXTURE_SHADER_NV}};
  for (const auto& [extension, name] : programs) {
    expect_passed(Reason::kProgram, with([&](Gl& g) {
      g.extensions = {extension};
      g.enabled = {name};
    }));
  }
  for (GLenum mode : {GL_SELECT, GL_FEEDBACK}) {
    expect_passed(Reason::kSelectionOrFeedback, with([&](Gl& g) { g.numbers[GL_RENDER_MODE] = {double(mode)}; }));
  }
  expect_passed(Reason::kPolygonMode, with([](Gl& g) { g.numbers[GL_POLYGON_MODE] = {GL_FILL, GL_LINE}; }));
  expect_passed(Reason::kPolygonMode, with([](Gl& g) { g.numbers[GL_POLYGON_MODE] = {GL_POINT, GL_FILL}; }));
  expect_passed(Reason::kPolygonSmooth, with([](Gl& g) { g.enabled = {GL_POLYGON_SMOOTH}; }));
  expect_passed(Reason::kTransformFeedbackOrQuery, with([](Gl& g) {
    g.extensions = {"GL_ARB_transform_feedback2"};
    g.numbers[GL_TRANSFORM_FEEDBACK_ACTIVE] = {1};
  }));
  for (GLenum target : {GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN}) {
    expect_passed(Reason::kTransformFeedbackOrQuery, with([&](Gl& g) {
      g.extensions = {"GL_EXT_transform_feedback"};
      g.queries[target] = 9;
    }));
  }
  for (GLenum target : {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED, GL_CLIPPING_INPUT_PRIMITIVES}) {
    expect_passed(Reason::kTransformFeedbackOrQuery, with([&](Gl& g) {
      g.extensions = {"GL_EXT_transform_feedback", "GL_ARB_pipeline_statistics_query"};
      g.queries[target] = 9;
    }));
  }
  expect_passed(Reason::kInvisible, with([](Gl& g) { g.numbers[GL_VIEWPORT] = {0, 0, 0, 0}; }));
  expect_passed(Reason::kNotFinite, with([](Gl& g) { g.numbers[GL_MODELVIEW_MATRIX][5] = NAN; }));
  expect_passed(Reason::kUnknownContext, with([](Gl& g) { g.version = "OpenGL ES 1.1"; }));
  expect_passed(Reason::kUnknownContext, with([](Gl& g) { g.version = ""; }));
  expect_passed(Reason::kUnknownContext, with([](Gl& g) { g.version = "3.1 fake"; }));
  expect_passed(Reason::kUnknownContext, with([](Gl& g) {
    g.version = "3.3 fake";
    g.numbers[GL_CONTEXT_PROFILE_MASK] = {GL_CONTEXT_CORE_PROFILE_BIT};
    for (GLenum gone : {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_RENDER_MODE, GL_SHADE_MODEL,
                        GL_MAX_TEXTURE_UNITS, GL_MAX_TEXTURE_COORDS}) {
      g.numbers.erase(gone);
    }
  }));
}

TEST(Pass, ACompatibilityProfileIsNotAReason) {
  Gl start;
  start.version = "4.6 (Compatibility Profile) fake";
  start.extensions = {"GL_ARB_compatibility"};
  start.numbers[GL_CONTEXT_PROFILE_MASK] = {GL_CONTEXT_COMPATIBILITY_PROFILE_BIT};
  start.numbers[GL_PROGRAM_PIPELINE_BINDING] = {0};
  start.numbers[GL_TRANSFORM_FEEDBACK_ACTIVE] = {0};
  start.numbers[GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION] = {1};
  Gl ours;
  EXPECT_EQ(growth(corrected, [&] { ours = through_doors(draw_warped, start); }), 1u);
  EXPECT_TRUE(ours.all_errors.empty());
}

TEST(Pass, AnOldDriverIsAskedOnlyWhatItKnows) {
  for (const char* version : {"1.1 fake", "1.2 fake", "1.3 fake", "1.5 fake", "2.0 fake"}) {
    Gl start;
    start.version = version;
    if (start.version_number() < 20) {
      start.numbers.erase(GL_CURRENT_PROGRAM);
      start.numbers.erase(GL_MAX_TEXTURE_COORDS);
    }
    if (start.version_number() < 13) {
      start.numbers.erase(GL_MAX_TEXTURE_UNITS);
      start.units = 1;
    }
    Gl ours;
    EXPECT_EQ(growth(corrected, [&] { ours = through_doors(draw_warped, start); }), 1u) << version;
    EXPECT_TRUE(ours.all_errors.empty()) << version;
  }
}

TEST(Pass, ACallThatTheDriverLacksDidNothing) {
  const Program program = with_corners([](const Driver& gl, int i) {
    gl.TexCoord2hNV(i == 1 || i == 2 ? 0x3c00 : 0, i >= 2 ? 0x3c00 : 0);
    gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
  });
  expect_passed(Reason::kMissingExtension, Gl(), program);
  Gl start;
  start.extensions = {"GL_NV_half_float"};
  EXPECT_EQ(growth(corrected, [&] { through_doors(program, start); }), 1u);
}

TEST(Pass, UnmodelledCallsAndLists) {
  expect_passed(Reason::kUnmodelledCall, Gl(), [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    kTrapezoid.vertex(gl, 0);
    barrier(entry);  // as before a call that is legal here
    for (int i = 1; i < 4; ++i) kTrapezoid.vertex(gl, i);
    gl.End();
  });
  // After the list quads are corrected again.
  EXPECT_EQ(growth(corrected, [] {
              through_doors([](const Driver& gl) {
                gl.NewList(1, GL_COMPILE);
                gl.EndList();
                draw_warped(gl);
              });
            }),
            1u);
}

TEST(Pass, ModeOffIsCountedAndNothingElse) {
  const Settings before = chosen_settings(entry);
  Settings off = before;
  off.mode = Mode::kOff;
  ASSERT_TRUE(choose_settings(entry, off));
  expect_passed(Reason::kModeOff, Gl());
  EXPECT_EQ(through_doors(draw_warped).log, natively(draw_warped).log);
  choose_settings(entry, before);
}

// Not passed, but nothing is promised.
TEST(Pass, MultisamplingIsCapped) {
  for (const bool buffers : {false, true}) {
    for (const bool enabled : {false, true}) {
      Gl start;
      start.numbers[GL_SAMPLE_BUFFERS] = {double(buffers)};
      if (enabled) start.enabled.insert(GL_MULTISAMPLE);
      const std::uint64_t capped = counters().capped.get(), before = corrected();
      through_doors(draw_warped, start);
      EXPECT_EQ(corrected(), before + 1);
      EXPECT_EQ(counters().capped.get() - capped, buffers && enabled ? 1u : 0u);
    }
  }
}

TEST(Pass, APrimitiveAsksOnce) {
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 50; ++i) kTrapezoid.draw(gl);
    gl.End();
  };
  Gl start;
  start.numbers[GL_CURRENT_PROGRAM] = {7};
  const std::size_t once = through_doors(draw_warped, start).gets;
  const Gl many = through_doors(program, start);
  EXPECT_EQ(many.gets, once);
  EXPECT_EQ(many.drawn.size(), 2u);  // cut once
  EXPECT_EQ(through_doors(program).gets, through_doors(draw_warped).gets);
}

}  // namespace
}  // namespace truequad::fake
