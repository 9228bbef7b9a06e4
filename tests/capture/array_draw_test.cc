// What the driver is called for draws from vertex arrays: the program's own call if every quad may pass, and nothing else; else
// draws of the same arrays for the quads that pass, and triangles for the others, in the program's order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "driver/driver.h"
#include "program.h"

namespace truequad::fake {
namespace {

struct Element {
  float texture[2], position[2];
};

// Quads of kSquare ('s'), which pass, and of kTrapezoid ('t').
std::vector<Element> elements(const std::string& quads) {
  constexpr float kS[] = {0, 1, 1, 0}, kT[] = {0, 0, 1, 1};
  std::vector<Element> result;
  for (const char kind : quads) {
    for (int i = 0; i < 4; ++i) {
      const Point& p = (kind == 's' ? kSquare : kTrapezoid).corner[i];
      result.push_back({{kS[i], kT[i]}, {p.x, p.y}});
    }
  }
  return result;
}

// Arrays of positions and texture coordinates in a driver's state.
Gl with_arrays(const std::vector<Element>& array) {
  Gl start;
  // The fake driver knows no client's unit: there is one.
  start.units = 1;
  start.numbers[GL_MAX_TEXTURE_UNITS] = start.numbers[GL_MAX_TEXTURE_COORDS] = {1};
  for (const GLenum name : {GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY}) start.enabled.insert(name);
  const auto describe = [&](GLenum size, GLenum type, GLenum stride, GLenum pointer, const void* at) {
    start.numbers[size] = {2};
    start.numbers[type] = {GL_FLOAT};
    start.numbers[stride] = {sizeof(Element)};
    start.pointers[pointer] = at;
  };
  describe(GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE, GL_VERTEX_ARRAY_POINTER, array[0].position);
  describe(GL_TEXTURE_COORD_ARRAY_SIZE, GL_TEXTURE_COORD_ARRAY_TYPE, GL_TEXTURE_COORD_ARRAY_STRIDE,
           GL_TEXTURE_COORD_ARRAY_POINTER, array[0].texture);
  start.numbers[GL_VERTEX_ARRAY_BUFFER_BINDING] = start.numbers[GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING] =
      start.numbers[GL_ELEMENT_ARRAY_BUFFER_BINDING] = {0};
  start.numbers[GL_CLIENT_ACTIVE_TEXTURE] = {GL_TEXTURE0};
  return start;
}

// The calls that draw: "DrawArrays 0 4" and "DrawElements 4 4" (count, and how many bytes into the indices), and of what goes
// by immediate mode the modes alone.
std::vector<std::string> drawing_calls(const Gl& gl, const void* indices = nullptr) {
  std::vector<std::string> result;
  const auto number = [](const Call& call, std::size_t offset) {
    GLint value;
    std::memcpy(&value, call.arguments.data() + offset, sizeof value);
    return value;
  };
  for (const Call& call : gl.log) {
    if (call.command == kCommandDrawArrays) {
      result.push_back("DrawArrays " + std::to_string(number(call, 4)) + " " + std::to_string(number(call, 8)));
    } else if (call.command == kCommandDrawElements) {
      const char* at;
      std::memcpy(&at, call.arguments.data() + 12, sizeof at);
      result.push_back("DrawElements " + std::to_string(number(call, 4)) + " " +
                       std::to_string(at - static_cast<const char*>(indices)));
    } else if (call.command == kCommandMultiDrawArrays) {
      result.push_back("MultiDrawArrays");
    } else if (call.command == kCommandBegin) {
      result.push_back("Begin " + std::to_string(number(call, 0)));
    }
  }
  return result;
}
using Calls = std::vector<std::string>;
const std::string kMesh = "Begin " + std::to_string(GL_TRIANGLES);

// All positions that were drawn by immediate mode.
std::size_t vertices_drawn(const Gl& gl) {
  return std::accumulate(gl.drawn.begin(), gl.drawn.end(), std::size_t(0),
                         [](std::size_t sum, const Primitive& p) { return sum + p.vertices.size(); });
}

bool is_query(const Call& call) {
  for (const unsigned command : {kCommandGetIntegerv, kCommandGetFloatv, kCommandGetBooleanv, kCommandIsEnabled, kCommandGetString,
                                 kCommandGetStringi, kCommandGetPointerv, kCommandGetQueryiv, kCommandClientActiveTexture,
                                 kCommandActiveTexture, kCommandGetVertexAttribiv}) {
    if (call.command == command) return true;
  }
  return false;
}
std::vector<Call> without_queries(const Gl& gl) {
  std::vector<Call> calls;
  std::copy_if(gl.log.begin(), gl.log.end(), std::back_inserter(calls), [](const Call& call) { return !is_query(call); });
  return calls;
}

TEST(ArrayDraws, OfQuadsThatPassAreTheProgramsOwnCalls) {
  const auto array = elements("ssss");
  const GLushort indices[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const GLint first[] = {0, 8};
  const GLsizei count[] = {8, 4};
  for (const Program& program :
       {Program([](const Driver& gl) { gl.DrawArrays(GL_QUADS, 0, 16); }), Program([](const Driver& gl) { gl.DrawArrays(GL_QUADS, 4, 7); }),
        Program([&](const Driver& gl) { gl.DrawElements(GL_QUADS, 8, GL_UNSIGNED_SHORT, indices); }),
        Program([&](const Driver& gl) { gl.DrawRangeElements(GL_QUADS, 0, 7, 8, GL_UNSIGNED_SHORT, indices); }),
        Program([&](const Driver& gl) { gl.MultiDrawArrays(GL_QUADS, first, count, 2); }),
        Program([&](const Driver& gl) { gl.DrawArraysInstanced(GL_QUADS, 0, 16, 3); })}) {
    const Gl start = with_arrays(array), native = natively(program, start), ours = through_doors(program, start);
    EXPECT_EQ(without_queries(ours), native.log);
    EXPECT_TRUE(ours.all_errors.empty());
    EXPECT_EQ(ours.get_errors, 0u);
    EXPECT_EQ(ours.current, native.current);
  }
}

TEST(ArrayDraws, TheStateIsAskedOnce) {
  const auto array = elements("ss");
  reset(with_arrays(array));
  make_current();
  doors().DrawArrays(GL_QUADS, 0, 8);
  const std::size_t gets = gl().gets;
  EXPECT_GT(gets, 0u);
  doors().DrawArrays(GL_QUADS, 0, 4);
  doors().DrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, "\0\1\2\3");
  const std::size_t with_indices = gl().gets;
  EXPECT_LE(with_indices - gets, 1u);
  doors().DrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, "\0\1\2\3");
  doors().DrawArrays(GL_QUADS, 0, 8);
  EXPECT_EQ(gl().gets, with_indices);
}

TEST(ArrayDraws, OfOtherPrimitivesAskNothing) {
  const auto array = elements("tt");
  reset(with_arrays(array));
  make_current();
  for (GLenum mode = 0; mode < 16; ++mode) {
    if (mode == GL_QUADS || mode == GL_QUAD_STRIP || mode == GL_POLYGON) continue;
    doors().DrawArrays(mode, 0, 8);
    doors().DrawElements(mode, 8, GL_UNSIGNED_BYTE, "\0\1\2\3\4\5\6\7");
  }
  EXPECT_EQ(gl().gets, 0u);
  EXPECT_EQ(gl().log.size(), 26u);
}

TEST(ArrayDraws, WarpedQuadsAreTrianglesBetweenDrawsOfTheOthers) {
  const std::pair<const char*, Calls> kCases[] = {
      {"t", {kMesh}},
      {"tt", {kMesh}},
      {"stss", {"DrawArrays 0 4", kMesh, "DrawArrays 8 8"}},
      {"sst", {"DrawArrays 0 8", kMesh}},
      {"tstst", {kMesh, "DrawArrays 4 4", kMesh, "DrawArrays 12 4", kMesh}},
  };
  for (const auto& [quads, calls] : kCases) {
    SCOPED_TRACE(quads);
    const auto array = elements(quads);
    const GLsizei count = GLsizei(array.size());
    const Gl start = with_arrays(array);
    const auto warped = std::uint64_t(std::count(quads, quads + std::strlen(quads), 't')), before = corrected();
    const Gl ours = through_doors([&](const Driver& gl) { gl.DrawArrays(GL_QUADS, 0, count); }, start);
    EXPECT_EQ(corrected() - before, warped);
    EXPECT_EQ(drawing_calls(ours), calls);
    EXPECT_TRUE(ours.all_errors.empty());
    EXPECT_EQ(ours.current, start.current) << "drivers leave the current values as they were";
    EXPECT_FALSE(ours.inside);

    // By indices the same, in their order.
    std::vector<GLushort> indices(array.size());
    std::iota(indices.begin(), indices.end(), GLushort(0));
    const Gl indexed = through_doors(
        [&](const Driver& gl) { gl.DrawElements(GL_QUADS, count, GL_UNSIGNED_SHORT, indices.data()); }, start);
    Calls expected;
    for (const std::string& call : calls) {
      int from = 0, length = 0;
      if (std::sscanf(call.c_str(), "DrawArrays %d %d", &from, &length) == 2) {
        expected.push_back("DrawElements " + std::to_string(length) + " " + std::to_string(2 * from));
      } else {
        expected.push_back(call);
      }
    }
    EXPECT_EQ(drawing_calls(indexed, indices.data()), expected);
    EXPECT_EQ(vertices_drawn(indexed), vertices_drawn(ours));
  }
}

// The mesh's corners are the array's numbers, and an incomplete quad is the driver's to drop.
TEST(ArrayDraws, KeepCornersAndIncompleteQuads) {
  const auto array = elements("ts");
  const Gl ours = through_doors([](const Driver& gl) { gl.DrawArrays(GL_QUADS, 0, 7); }, with_arrays(array));
  EXPECT_EQ(drawing_calls(ours), (Calls{kMesh, "DrawArrays 4 3"}));
  for (int i = 0; i < 4; ++i) {
    const Value corner = {kTrapezoid.corner[i].x, kTrapezoid.corner[i].y, 0, 1};
    EXPECT_TRUE(std::any_of(ours.drawn[0].vertices.begin(), ours.drawn[0].vertices.end(),
                            [&](const Values& v) { return v[kPosition] == corner; }))
        << "corner " << i;
  }
}

TEST(ArrayDraws, OfAStripAreShorterStripsBetweenMeshes) {
  // Columns of a band: between equal heights a rectangle, else a trapezoid.
  constexpr float kHeights[] = {0.5f, 0.5f, 0.2f, 0.2f, 0.2f};
  std::vector<Element> array;
  for (int i = 0; i < 5; ++i) {
    const float x = 0.4f * float(i) - 0.8f;
    array.push_back({{float(i), 0}, {x, -kHeights[i]}});
    array.push_back({{float(i), 1}, {x, kHeights[i]}});
  }
  const Gl ours = through_doors([](const Driver& gl) { gl.DrawArrays(GL_QUAD_STRIP, 0, 10); }, with_arrays(array));
  EXPECT_EQ(drawing_calls(ours), (Calls{"DrawArrays 0 4", kMesh, "DrawArrays 4 6"}));
}

TEST(ArrayDraws, OfSeveralPrimitivesKeepTheirOrder) {
  const auto array = elements("sstss");
  const GLint first[] = {0, 8, 12};
  const GLsizei count[] = {8, 4, 8};
  const Gl ours = through_doors([&](const Driver& gl) { gl.MultiDrawArrays(GL_QUADS, first, count, 3); }, with_arrays(array));
  EXPECT_EQ(drawing_calls(ours), (Calls{"DrawArrays 0 8", kMesh, "DrawArrays 12 8"}));
}

// Left alone for one reason for all: the program's call alone.
TEST(ArrayDraws, ThatAreLeftAloneAreTheProgramsOwn) {
  const auto array = elements("tt");
  struct Case {
    Reason reason;
    void (*change)(Gl&);
  };
  for (const Case& k : {Case{Reason::kTexturingOff, [](Gl& g) { g.unit_enabled.clear(); }},
                        {Reason::kNoTextureVaries, [](Gl& g) { g.enabled.erase(GL_TEXTURE_COORD_ARRAY); }},
                        {Reason::kProgram, [](Gl& g) { g.version = "2.1 fake", g.numbers[GL_CURRENT_PROGRAM] = {7}; }},
                        {Reason::kSelectionOrFeedback, [](Gl& g) { g.numbers[GL_RENDER_MODE] = {GL_FEEDBACK}; }},
                        {Reason::kDegenerate, [](Gl& g) { g.enabled.erase(GL_VERTEX_ARRAY); }}}) {
    SCOPED_TRACE(kReasonNames[std::size_t(k.reason)]);
    Gl start = with_arrays(array);
    k.change(start);
    const std::uint64_t before = passed(k.reason);
    const Program program = [](const Driver& gl) { gl.DrawArrays(GL_QUADS, 0, 8); };
    const Gl ours = through_doors(program, start);
    EXPECT_EQ(passed(k.reason) - before, 2u);
    EXPECT_EQ(without_queries(ours), natively(program, start).log);
    EXPECT_TRUE(ours.all_errors.empty());
  }
}

// Errors are the driver's to find, so it gets the call.
TEST(ArrayDraws, ThatAreErrorsAreForwarded) {
  const auto array = elements("tt");
  const GLint first[] = {0, 0};
  const GLsizei count[] = {4, -1};
  for (const Program& program :
       {Program([](const Driver& gl) { gl.DrawArrays(GL_QUADS, 0, -1); }), Program([](const Driver& gl) { gl.DrawArrays(GL_QUADS, -4, 4); }),
        Program([](const Driver& gl) { gl.DrawElements(GL_QUADS, 4, GL_FLOAT, "\0\1\2\3"); }),
        Program([&](const Driver& gl) { gl.MultiDrawArrays(GL_QUADS, first, count, 2); }),
        Program([](const Driver& gl) { gl.DrawArraysInstanced(GL_QUADS, 0, 4, -1); }),
        Program([](const Driver& gl) { gl.Begin(GL_QUADS), gl.DrawArrays(GL_QUADS, 0, 4), gl.End(); })}) {
    const Gl start = with_arrays(array), native = natively(program, start), ours = through_doors(program, start);
    EXPECT_EQ(without_queries(ours), native.log);
    EXPECT_EQ(ours.all_errors, native.all_errors);
  }
}

}  // namespace
}  // namespace truequad::fake
