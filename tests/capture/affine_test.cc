// A program whose quads are all affine: the driver sees exactly the program's own calls, and no query.
#include <gtest/gtest.h>

#include <random>

#include "program.h"

namespace truequad::fake {
namespace {

constexpr unsigned kTrials = 2000;

// A random parallelogram on a random parallelogram, vertices in the order of the mode.
struct Parallelogram {
  float p[3], q[3], r[3], s[2], t[2], u[2];  // origin and two sides of position and texture, small integers: no rounding
  explicit Parallelogram(std::mt19937& random) {
    for (float* x : {p, q, r}) for (int i = 0; i < 3; ++i) x[i] = float(int(random() % 201) - 100);
    for (float* x : {s, t, u}) for (int i = 0; i < 2; ++i) x[i] = float(int(random() % 201) - 100);
  }
  void vertex(const Driver& gl, float a, float b) const {
    gl.TexCoord2f(s[0] + a * t[0] + b * u[0], s[1] + a * t[1] + b * u[1]);
    gl.Vertex3f(p[0] + a * q[0] + b * r[0], p[1] + a * q[1] + b * r[1], p[2] + a * q[2] + b * r[2]);
  }
};

void random_affine_program(const Driver& gl, unsigned seed) {
  std::mt19937 random(seed);
  const auto maybe_attributes = [&] {
    if (random() % 3 == 0) gl.Color4ub(GLubyte(random()), 1, 2, 255);
    if (random() % 3 == 0) gl.Normal3f(0, 0, float(random() % 100));
    if (random() % 5 == 0) gl.SecondaryColor3f(0.5f, 0, float(random() % 2));
  };
  for (unsigned primitive = 0; primitive < 4; ++primitive) {
    maybe_attributes();
    const bool strip = random() % 2;
    gl.Begin(strip ? GL_QUAD_STRIP : GL_QUADS);
    gl.Color3f(0.5f, 0.25f, 1);
    gl.Normal3f(0, 1, 0);
    gl.SecondaryColor3f(0, 0, 0);
    gl.MultiTexCoord2f(GL_TEXTURE1, 0, 0);
    gl.TexCoord2f(9, 9);
    const unsigned quads = random() % 6;
    const Parallelogram shape(random);
    for (unsigned i = 0; i < quads + (strip ? 1 : 0); ++i) {
      maybe_attributes();
      if (strip) {
        shape.vertex(gl, float(i), 0);
        shape.vertex(gl, float(i), 1);
      } else {
        const Parallelogram own(random);
        own.vertex(gl, 0, 0);
        own.vertex(gl, 1, 0);
        own.vertex(gl, 1, 1);
        maybe_attributes();
        own.vertex(gl, 0, 1);
      }
    }
    // An incomplete rest.
    for (unsigned i = random() % 4; i > 0 && !strip; --i) shape.vertex(gl, 0, 0);
    gl.End();
    maybe_attributes();
  }
}

TEST(Affine, RandomProgramsReachTheDriverCallForCall) {
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    const Program program = [seed](const Driver& gl) { random_affine_program(gl, seed); };
    const Gl native = natively(program);
    const Gl ours = through_doors(program);
    ASSERT_EQ(ours.log, native.log) << "seed " << seed;
    ASSERT_EQ(ours.gets, 0u);
    ASSERT_GT(native.log.size(), 20u);
  }
}

TEST(Affine, ATrapezoidOnATrapezoidIsLeftAlone) {
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (const Point p : kTrapezoid.corner) {
      gl.TexCoord2f(2 * p.x + p.y, p.y - 1);
      gl.Vertex2f(p.x, p.y);
    }
    gl.End();
  };
  EXPECT_EQ(through_doors(program).log, natively(program).log);
}

TEST(Affine, UntexturedGradientsAreNeverCut) {
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      if (i == 2) gl.Color3f(1, 0, 0);
      gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
    }
    gl.End();
  };
  const Gl ours = through_doors(program);
  EXPECT_EQ(ours.log, natively(program).log);
  EXPECT_EQ(ours.gets, 0u);
}

TEST(Affine, OtherPrimitivesAreNotOurs) {
  for (GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP,
                      GL_TRIANGLE_FAN}) {
    const Program program = [mode](const Driver& gl) {
      gl.Begin(mode);
      for (int i = 0; i < 3; ++i) kTrapezoid.draw(gl);
      gl.End();
    };
    const Gl ours = through_doors(program);
    EXPECT_EQ(ours.log, natively(program).log) << mode;
  }
}

TEST(Affine, PolygonsGoOutAsTheyAre) {
  for (int sides = 0; sides < 12; ++sides) {
    const Program program = [sides](const Driver& gl) {
      gl.Begin(GL_POLYGON);
      for (int i = 0; i < sides; ++i) {
        gl.TexCoord2f(float(i % 3), float(i));
        gl.Vertex2f(float(i % 3), float(i));
      }
      gl.End();
    };
    const Gl ours = through_doors(program);
    EXPECT_EQ(ours.log, natively(program).log) << sides;
    EXPECT_EQ(ours.gets, 0u);
  }
}

}  // namespace
}  // namespace truequad::fake
