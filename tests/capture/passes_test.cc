// Later passes over the same vertices: the driver gets the same triangles again, or the program's own quad again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "capture/drawn.h"
#include "program.h"

namespace truequad::fake {
namespace {

// The depth state, which the fake driver does not keep by itself.
void depth(const Driver& gl, GLenum function, bool mask = true) {
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(function);
  fake::gl().enabled.insert(GL_DEPTH_TEST);
  fake::gl().numbers[GL_DEPTH_FUNC] = {double(function)};
  fake::gl().numbers[GL_DEPTH_WRITEMASK] = {double(mask)};
}

void textured(const Driver& gl, const UnitPatch& patch = kTrapezoid) {
  gl.Begin(GL_QUADS);
  patch.draw(gl);
  gl.End();
}
void untextured(const Driver& gl, const UnitPatch& patch = kTrapezoid) {
  gl.Begin(GL_QUADS);
  for (const Point& p : patch.corner) gl.Vertex2f(p.x, p.y);
  gl.End();
}
void affine(const Driver& gl) {
  gl.Begin(GL_QUADS);
  for (const Point& p : kTrapezoid.corner) gl.TexCoord2f(p.x, p.y), gl.Vertex2f(p.x, p.y);
  gl.End();
}
// Other coordinates, as warped.
void mirrored(const Driver& gl) {
  constexpr float kS[] = {1, 0, 0, 1}, kT[] = {0, 0, 1, 1};
  gl.Begin(GL_QUADS);
  for (int i = 0; i < 4; ++i) gl.TexCoord2f(kS[i], kT[i]), gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
  gl.End();
}

// Positions of what was drawn since, primitives without vertices left out.
struct Picture {
  GLenum mode;
  std::vector<Value> positions;
  bool operator==(const Picture&) const = default;
};
std::vector<Picture> pictures(std::size_t first = 0) {
  std::vector<Picture> result;
  for (std::size_t i = first; i < gl().drawn.size(); ++i) {
    const Primitive& primitive = gl().drawn[i];
    // What the driver drops of a quad that was begun.
    if (primitive.mode == GL_QUADS && primitive.vertices.size() < 4) continue;
    Picture picture{primitive.mode, {}};
    for (const Values& vertex : primitive.vertices) picture.positions.push_back(vertex[kPosition]);
    if (!picture.positions.empty()) result.push_back(picture);
  }
  return result;
}
template <typename F>
std::vector<Picture> pictures_of(F pass) {
  const std::size_t first = gl().drawn.size();
  pass(doors());
  return pictures(first);
}

class Passes : public testing::Test {
 protected:
  void SetUp() override {
    reset();
    make_current();
    doors().Clear(GL_DEPTH_BUFFER_BIT);
  }
};

TEST_F(Passes, WhateverTheTextureTheMeshIsTheSame) {
  for (GLenum function : {GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL}) {
    SetUp();
    depth(doors(), function);
    const auto first = pictures_of([](const Driver& gl) { textured(gl); });
    ASSERT_EQ(first.size(), 1u);
    ASSERT_EQ(first[0].mode, GLenum(GL_TRIANGLES));
    for (GLenum later : {GL_LESS, GL_EQUAL, GL_LEQUAL, GL_ALWAYS}) {
      depth(doors(), later);
      EXPECT_EQ(pictures_of([](const Driver& gl) { untextured(gl); }), first);
      EXPECT_EQ(pictures_of([](const Driver& gl) { affine(gl); }), first);
      EXPECT_EQ(pictures_of([](const Driver& gl) { textured(gl); }), first);
      EXPECT_EQ(pictures_of([](const Driver& gl) { mirrored(gl); }), first);
    }
    EXPECT_TRUE(gl().all_errors.empty());
    EXPECT_EQ(gl().get_errors, 0u);
  }
}

// More of a quad counts with GL_DEPTH_CLAMP, and another mesh were enough for it.
TEST_F(Passes, TheMeshIsTheSameIfDepthsAreClampedInOneOfThem) {
  for (const bool first_clamped : {false, true}) {
    reset();
    gl().extensions = {"GL_ARB_depth_clamp"};
    make_current();
    doors().Clear(GL_DEPTH_BUFFER_BIT);
    // Much of the quad is beyond the far plane, z = 3x, and nearer there: w = 1 + 0.7x.
    std::vector<double> leaning(16);
    leaning[0] = leaning[5] = leaning[15] = 1;
    leaning[2] = 3;
    leaning[3] = 0.7;
    gl().numbers[GL_PROJECTION_MATRIX] = leaning;
    depth(doors(), GL_LEQUAL);
    const auto clamp = [](bool on) { on ? doors().Enable(GL_DEPTH_CLAMP) : doors().Disable(GL_DEPTH_CLAMP); };
    clamp(first_clamped);
    const auto first = pictures_of([](const Driver& gl) { textured(gl); });
    ASSERT_EQ(first.at(0).mode, GLenum(GL_TRIANGLES));
    clamp(!first_clamped);
    EXPECT_EQ(pictures_of([](const Driver& gl) { textured(gl); }), first);
    EXPECT_EQ(pictures_of([](const Driver& gl) { untextured(gl); }), first);
  }
}

TEST_F(Passes, WhatLiesInTheBufferAsTwoTrianglesStaysSoAndIsAMeshFromTheNextFrameOn) {
  for (const auto& earlier : {+[](const Driver& gl) { untextured(gl); }, +[](const Driver& gl) { affine(gl); }}) {
    for (GLenum function : {GL_LEQUAL, GL_EQUAL}) {
      SetUp();
      depth(doors(), GL_LEQUAL);
      doors().Clear(GL_DEPTH_BUFFER_BIT);
      const auto first = pictures_of(earlier);
      ASSERT_EQ(first.at(0).mode, GLenum(GL_QUADS));
      depth(doors(), function);
      const std::uint64_t before = passed(Reason::kEarlierPass);
      EXPECT_EQ(pictures_of([](const Driver& gl) { textured(gl); }), first);
      EXPECT_EQ(passed(Reason::kEarlierPass), before + 1);

      for (int frame = 0; frame < 2; ++frame) {
        doors().Clear(GL_DEPTH_BUFFER_BIT);
        depth(doors(), GL_LESS);
        const auto mesh = pictures_of(earlier);
        EXPECT_EQ(mesh.at(0).mode, GLenum(GL_TRIANGLES));
        depth(doors(), function);
        EXPECT_EQ(pictures_of([](const Driver& gl) { textured(gl); }), mesh);
      }
      // Forget the wish, which outlives frames.
      delete_thread_memory();
    }
  }
}

TEST_F(Passes, OnlyTheSameVerticesInTheSameViewMeet) {
  depth(doors(), GL_LEQUAL);
  const auto first = pictures_of([](const Driver& gl) { textured(gl); });
  ASSERT_EQ(first.at(0).mode, GLenum(GL_TRIANGLES));
  UnitPatch other = kTrapezoid;
  other.corner[2].x = std::nextafter(other.corner[2].x, 1.f);
  EXPECT_EQ(pictures_of([&](const Driver& gl) { untextured(gl, other); }).at(0).mode, GLenum(GL_QUADS));
  gl().numbers[GL_VIEWPORT] = {0, 0, 400, 401};
  EXPECT_EQ(pictures_of([](const Driver& gl) { untextured(gl); }).at(0).mode, GLenum(GL_QUADS));
  gl().numbers[GL_VIEWPORT] = {0, 0, 400, 400};
  gl().numbers[GL_MODELVIEW_MATRIX][12] = 0.125;
  EXPECT_EQ(pictures_of([](const Driver& gl) { untextured(gl); }).at(0).mode, GLenum(GL_QUADS));
  gl().numbers[GL_MODELVIEW_MATRIX][12] = 0;
  EXPECT_EQ(pictures_of([](const Driver& gl) { untextured(gl); }), first);
}

TEST_F(Passes, AClearOfAllEndsThem) {
  struct Case {
    GLbitfield mask;
    bool scissor, depth_mask, stencil, forgets;
  };
  for (const Case& k : {Case{GL_DEPTH_BUFFER_BIT, false, true, false, true},
                        {GL_COLOR_BUFFER_BIT, false, true, false, false},
                        {GL_DEPTH_BUFFER_BIT, true, true, false, false},
                        {GL_DEPTH_BUFFER_BIT, false, false, false, false},
                        {GL_DEPTH_BUFFER_BIT, false, true, true, false},
                        {GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, false, true, true, true}}) {
    SetUp();
    depth(doors(), GL_LESS);
    textured(doors());
    if (k.scissor) gl().enabled.insert(GL_SCISSOR_TEST);
    if (k.stencil) gl().enabled.insert(GL_STENCIL_TEST);
    gl().numbers[GL_DEPTH_WRITEMASK] = {double(k.depth_mask)};
    doors().Clear(k.mask);
    gl().enabled.erase(GL_SCISSOR_TEST);
    gl().enabled.erase(GL_STENCIL_TEST);
    gl().numbers[GL_DEPTH_WRITEMASK] = {1};
    const GLenum mode = pictures_of([](const Driver& gl) { untextured(gl); }).at(0).mode;
    EXPECT_EQ(mode, GLenum(k.forgets ? GL_QUADS : GL_TRIANGLES)) << k.mask << k.scissor << k.depth_mask << k.stencil;
  }
}

TEST_F(Passes, AffineProgramsPayNoQuestion) {
  delete_thread_memory();
  depth(doors(), GL_LEQUAL);
  const std::size_t gets = gl().gets;
  for (int frame = 0; frame < 3; ++frame) {
    doors().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    textured(doors(), kSquare);
    untextured(doors());
  }
  EXPECT_EQ(gl().gets, gets);
  for (const Picture& picture : pictures()) EXPECT_EQ(picture.mode, GLenum(GL_QUADS));
}

// More meshes than there is room for: those that find none stay two triangles, in every pass.
TEST_F(Passes, AFullMemoryLosesNothing) {
  gl().logging = false;
  gl().numbers[GL_VIEWPORT] = {0, 0, 60, 60};  // where a mesh is small, and soon planned
  depth(doors(), GL_LEQUAL);
  doors().Clear(GL_DEPTH_BUFFER_BIT);
  const auto quad = [](int i) {
    UnitPatch patch = kTrapezoid;
    patch.corner[0].x = -0.9f + 1e-5f * float(i);
    return patch;
  };
  constexpr int kQuads = 40'000;
  std::vector<bool> corrected_first(kQuads);
  for (int i = 0; i < kQuads; ++i) {
    const std::uint64_t before = corrected();
    textured(doors(), quad(i));
    corrected_first[std::size_t(i)] = corrected() > before;
  }
  const auto meshes = std::count(corrected_first.begin(), corrected_first.end(), true);
  EXPECT_GT(meshes, 10'000);
  EXPECT_LT(meshes, kQuads);
  for (int i = 0; i < kQuads; ++i) {
    const std::uint64_t before = corrected();
    untextured(doors(), quad(i));
    ASSERT_EQ(corrected() > before, corrected_first[std::size_t(i)]) << i;
  }
}

// Wishes that share a place in memory must not take it from each other frame by frame: quads would be corrected in turn.
TEST_F(Passes, ThousandsOfWishesAreMetFrameByFrame) {
  delete_thread_memory();
  gl().logging = false;
  depth(doors(), GL_LEQUAL);
  constexpr int kQuads = 2'000;
  const auto quad = [](int i) {
    UnitPatch patch = kTrapezoid;
    patch.corner[0].x = -0.9f + 1e-5f * float(i);
    return patch;
  };
  std::vector<bool> as_mesh[3];
  for (std::vector<bool>& frame : as_mesh) {
    doors().Clear(GL_DEPTH_BUFFER_BIT);
    depth(doors(), GL_LEQUAL);
    for (int i = 0; i < kQuads; ++i) untextured(doors(), quad(i));
    depth(doors(), GL_EQUAL);
    for (int i = 0; i < kQuads; ++i) {
      const std::uint64_t before = corrected();
      textured(doors(), quad(i));
      frame.push_back(corrected() > before);
    }
  }
  EXPECT_EQ(std::count(as_mesh[0].begin(), as_mesh[0].end(), true), 0);
  // Few find no room.
  EXPECT_GT(std::count(as_mesh[1].begin(), as_mesh[1].end(), true), kQuads * 99 / 100);
  EXPECT_EQ(as_mesh[1], as_mesh[2]);
}

// Coordinates that move from frame to frame: the earlier pass, which has none, follows.
TEST_F(Passes, AWishFollowsTheLaterPass) {
  delete_thread_memory();
  const auto capped = [] { return counters().capped.get(); };
  const auto later = [](const Driver& gl, float size) {
    constexpr float kS[] = {0, 1, 1, 0}, kT[] = {0, 0, 1, 1};
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      gl.TexCoord2f(i == 2 ? size : kS[i], i == 2 ? size : kT[i]);
      gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
    }
    gl.End();
  };
  std::uint64_t before = 0;
  for (int frame = 0; frame < 40; ++frame) {
    if (frame == 30) before = capped();
    doors().Clear(GL_DEPTH_BUFFER_BIT);
    depth(doors(), GL_LEQUAL);
    untextured(doors());
    depth(doors(), GL_EQUAL);
    // Another patch from the tenth frame on.
    later(doors(), frame < 10 ? 1 : 2);
  }
  EXPECT_EQ(capped(), before);
}

TEST(KeySets, NeverForgetAndSeldomInvent) {
  const auto set = std::make_unique<KeySet<1 << 22>>();
  set->clear();
  for (unsigned seed = 0; seed < 3; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<PassKey> keys(50'000);
    for (PassKey& key : keys) set->add(key = random());
    for (PassKey key : keys) ASSERT_TRUE(set->has(key));
    long invented = 0;
    constexpr long kTrials = 1'000'000;
    for (long i = 0; i < kTrials; ++i) invented += set->has(random());
    EXPECT_LT(invented, kTrials / 500);
    set->clear();
    for (PassKey key : keys) ASSERT_FALSE(set->has(key));
  }
}

}  // namespace
}  // namespace truequad::fake
