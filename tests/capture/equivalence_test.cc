// With and without truequad a program sees the same: errors when it asks for them, current values, Begin/End; for
// random sequences of calls, legal or not, and for a barrier at every position of a primitive.
#include <gtest/gtest.h>

#include <random>

#include "../trials.h"
#include "program.h"

namespace truequad::fake {
namespace {

void expect_same(const Gl& ours, const Gl& native) {
  EXPECT_EQ(ours.seen_errors, native.seen_errors);
  EXPECT_EQ(ours.flag, native.flag);
  EXPECT_EQ(ours.current, native.current);
  EXPECT_EQ(ours.inside, native.inside);
  EXPECT_EQ(ours.active_unit, native.active_unit);
  EXPECT_EQ(ours.get_errors, native.get_errors);
}

void random_calls(const Driver& gl, unsigned seed) {
  std::mt19937 random(seed);
  const auto any_mode = [&] {
    const unsigned n = random() % 16;
    return GLenum(n < 10 ? GL_QUADS + n % 3 : n < 14 ? random() % 10 : n == 14 ? GL_PATCHES : 0x4242);
  };
  for (unsigned i = 0, n = 20 + random() % 200; i < n; ++i) {
    switch (random() % 24) {
      case 0: case 1: gl.Begin(any_mode()); break;
      case 2: case 3: gl.End(); break;
      case 4:
        switch (random() % 8) {
          case 0: gl.GetError(); break;
          case 1: gl.Enable(GL_FOG); break;
          case 2: gl.ActiveTexture(GL_TEXTURE0 + random() % 9); break;
          case 3: gl.CallList(1); break;
          case 4: gl.ArrayElement(0); break;
          case 5: gl.EvalCoord1f(0); break;
          case 6: gl.PushAttrib(GL_CURRENT_BIT); break;
          default: gl.PopAttrib(); break;
        }
        break;
      case 5: case 6: case 7: case 8: case 9: case 10: case 11: case 12: case 13:
        (random() % 2 ? kTrapezoid : kSquare).vertex(gl, int(random() % 4));
        break;
      case 14: case 15: (random() % 2 ? kTrapezoid : kSquare).draw(gl); break;
      default: invoke(gl, RowId(random() % kRowCount), random(), random(), true); break;
    }
  }
  gl.End();
  gl.GetError();
}

TEST(Equivalence, RandomCallsLegalOrNot) {
  std::uint64_t corrections = 0;
  for (unsigned seed = 0; seed < test::trials(6000, 16); ++seed) {
    SCOPED_TRACE(seed);
    Gl start;
    // Half of the drivers are old ones without anything.
    if (seed % 2) start.version = "1.4 fake";
    const Program program = [seed](const Driver& gl) { random_calls(gl, seed); };
    const Gl native = natively(program, start);
    Gl ours;
    corrections += growth(corrected, [&] { ours = through_doors(program, start); });
    expect_same(ours, native);
    if (HasFailure()) return;
  }
  EXPECT_GT(corrections, test::trials(500, 16));
}

// Quads that are drawn after the barrier are the program's own, and complete ones before it are all there.
TEST(Equivalence, ABarrierAtEveryPosition) {
  for (GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    for (const bool warped : {false, true}) {
      for (const bool legal : {false, true}) {
        const UnitPatch& patch = warped ? kTrapezoid : kSquare;
        for (int position = 0; position <= 18; ++position) {
          SCOPED_TRACE(testing::Message() << mode << " " << warped << " " << legal << " " << position);
          const Program program = [&](const Driver& gl) {
            int call = 0;
            const auto step = [&] {
              if (call++ != position) return;
              if (legal) gl.CallList(1);
              else gl.Enable(GL_BLEND);
            };
            gl.Begin(mode);
            for (int i = 0; i < 8; ++i) {
              step();
              gl.TexCoord2f(float(i % 4 == 1 || i % 4 == 2), float(i % 4 >= 2));
              step();
              gl.Vertex2f(patch.corner[i % 4].x, patch.corner[i % 4].y);
            }
            step();
            gl.End();
            gl.GetError();
          };
          const Gl native = natively(program);
          const Gl ours = through_doors(program);
          expect_same(ours, native);
          EXPECT_EQ(ours.all_errors, native.all_errors);
          if (!warped) {
            EXPECT_EQ(ours.log, native.log);
          }
          // What came after the barrier: the end of the log is the native one.
          if (position < 16) {
            const std::size_t tail = 16 - std::size_t(position);
            ASSERT_GE(ours.log.size(), tail);
            EXPECT_TRUE(std::equal(native.log.end() - long(tail), native.log.end(), ours.log.end() - long(tail)));
          }
        }
      }
    }
  }
}

TEST(Equivalence, CallsOutOfPlace) {
  const Program programs[] = {
      [](const Driver& gl) { gl.End(); },
      [](const Driver& gl) { gl.Begin(GL_QUADS); gl.Begin(GL_QUADS); kTrapezoid.draw(gl); gl.End(); gl.End(); },
      [](const Driver& gl) { gl.Begin(GL_TRIANGLES); gl.Begin(GL_QUADS); kTrapezoid.draw(gl); gl.End(); },
      [](const Driver& gl) { gl.Begin(0x1234); kTrapezoid.draw(gl); gl.End(); },
      [](const Driver& gl) { gl.Begin(0x1234); gl.Begin(GL_QUADS); kSquare.draw(gl); gl.End(); },
      [](const Driver& gl) { kTrapezoid.draw(gl); },
      [](const Driver& gl) { gl.Begin(GL_POLYGON); gl.End(); },
      [](const Driver& gl) { gl.Begin(GL_QUADS); gl.GetError(); gl.End(); },
  };
  for (const Program& program : programs) {
    const Gl native = natively(program), ours = through_doors(program);
    expect_same(ours, native);
    EXPECT_EQ(ours.all_errors, native.all_errors);
  }
}

TEST(Equivalence, WithoutAContextEverythingIsForwarded) {
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    kTrapezoid.draw(gl);
    gl.End();
  };
  const Gl native = natively(program);
  reset();
  make_current();
  context_made_current(entry, nullptr, nullptr);
  program(doors());
  EXPECT_EQ(gl().log, native.log);
}

TEST(Equivalence, AContextSwitchInsideAPrimitiveFinishesIt) {
  static char a, b;
  reset();
  context_made_current(entry, &a, &driver());
  doors().Begin(GL_POLYGON);
  kTrapezoid.draw(doors());
  barrier(entry);
  context_made_current(entry, &b, &driver());
  EXPECT_EQ(entry.active, nullptr);
  EXPECT_EQ(gl().log.size(), 9u);  // Begin and four vertices with coordinates
  context_made_current(entry, &a, &driver());
  EXPECT_TRUE(entry.inside) << "the primitive is still open in its context";
  context_destroyed(&a);
  context_destroyed(&b);
  context_made_current(entry, nullptr, nullptr);
}

TEST(Equivalence, ARecreatedContextAtTheSameAddressIsANewOne) {
  static char handle;
  context_made_current(entry, &handle, &driver());
  doors().NewList(1, GL_COMPILE);
  const ContextRecord* const first = entry.context;
  context_destroyed(&handle);  // while it is current, as GLX allows
  EXPECT_EQ(entry.context, first);
  context_made_current(entry, &handle, &driver());
  EXPECT_EQ(entry.list, nullptr);
  context_made_current(entry, nullptr, nullptr);
  context_destroyed(&handle);
  reset();
}

}  // namespace
}  // namespace truequad::fake
