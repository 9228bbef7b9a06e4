// Shape is a property of the quad, not of its units, place or view.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "affine_fast.h"
#include "quads.h"

namespace truequad::test {
namespace {

Shape classify_one(const Corners& position, const Corners& texture) {
  return classify(position, {&texture, 1});
}

Corners flat(std::array<double, 8> xy) {
  return {Vec4{xy[0], xy[1], 0, 1}, Vec4{xy[2], xy[3], 0, 1}, Vec4{xy[4], xy[5], 0, 1},
          Vec4{xy[6], xy[7], 0, 1}};
}

// A random affine map of 3-space.
struct Map {
  double m[3][4];
  explicit Map(std::mt19937& engine, double reach) {
    std::uniform_real_distribution<double> unit(-1, 1);
    for (auto& row : m) {
      for (double& x : row) x = unit(engine);
      row[3] *= reach;
    }
  }
  Corners operator()(const Corners& c) const {
    Corners out;
    for (int i = 0; i < 4; ++i) {
      const auto row = [&](int r) {
        return float(m[r][0] * c[i].x + m[r][1] * c[i].y + m[r][2] * c[i].z + m[r][3]);
      };
      out[i] = {row(0), row(1), row(2), 1};
    }
    return out;
  }
};

const Corners kTrapezoid = flat({0, 0, 4, 0, 3, 2, 1, 2});

TEST(Classify, ParallelogramOnParallelogramIsAffine) {
  EXPECT_EQ(classify_one(flat({0, 0, 2, 1, 3, 4, 1, 3}), kUnitSquare), Shape::kAffine);
}

TEST(Classify, TrapezoidOnItsAffineCopyIsAffine) {
  EXPECT_EQ(classify_one(kTrapezoid, flat({0, 0, 1, 0, .75, 1, .25, 1})), Shape::kAffine);
}

TEST(Classify, TrapezoidOnSquareIsWarped) {
  EXPECT_EQ(classify_one(kTrapezoid, kUnitSquare), Shape::kWarped);
}

TEST(Classify, ParallelogramOnTrapezoidIsWarped) {
  EXPECT_EQ(classify_one(kUnitSquare, kTrapezoid), Shape::kWarped);
}

TEST(Classify, TheProgramsOwnCorrectQIsAffine) {
  // Reed's factors for a trapezoid with parallel sides 4 and 2: the diagonals cut each other 2 to 1, so q is
  // 3 and 3/2.
  Corners texture = kUnitSquare;
  const double q[4] = {3, 3, 1.5, 1.5};
  for (int i = 0; i < 4; ++i) texture[i] = {texture[i].x * q[i], texture[i].y * q[i], 0, q[i]};
  EXPECT_EQ(classify_one(kTrapezoid, texture), Shape::kAffine);
  texture[2].w *= 1.01;
  EXPECT_EQ(classify_one(kTrapezoid, texture), Shape::kWarped);
}

TEST(Classify, HomogeneousPositionsCountAsThePointsTheyAre) {
  Corners position = kUnitSquare;
  for (double w : {2.0, 0.25}) {
    position[1] = {w, 0, 0, w};
    // Points of a square, but corner weights that make w vary: P is no longer affine in (u, v).
    EXPECT_EQ(classify_one(position, kUnitSquare), Shape::kWarped);
  }
}

TEST(Classify, ConstantTextureIsConstantWhateverThePosition) {
  Corners texture = kUnitSquare;
  texture.fill(Vec4{0.3, 0.7, 0, 1});
  Corners nonplanar = kUnitSquare;
  nonplanar[2].z = 1;
  EXPECT_EQ(classify_one(nonplanar, texture), Shape::kConstant);
  EXPECT_EQ(classify(nonplanar, {}), Shape::kConstant);
}

TEST(Classify, NonPlanarIsWarped) {
  Corners nonplanar = kUnitSquare;
  nonplanar[2].z = 1e-3;
  EXPECT_EQ(classify_one(nonplanar, kUnitSquare), Shape::kWarped);
}

TEST(Classify, LinesAndPointsAreDegenerate) {
  EXPECT_EQ(classify_one(flat({0, 0, 1, 1, 2, 2, 5, 5}), kUnitSquare), Shape::kDegenerate);
  EXPECT_EQ(classify_one(flat({3, 4, 3, 4, 3, 4, 3, 4}), kUnitSquare), Shape::kDegenerate);
  Corners zero;
  zero.fill(Vec4{0, 0, 0, 0});
  EXPECT_EQ(classify_one(zero, kUnitSquare), Shape::kDegenerate);
}

TEST(Classify, TwoEqualCornersAreATriangle) {
  // Both collapsed at the same corner: the triangle's own linear map.
  EXPECT_EQ(classify_one(flat({0, 0, 1, 0, 0, 1, 0, 1}), flat({0, 0, 1, 0, 1, 1, 1, 1})), Shape::kAffine);
  EXPECT_EQ(classify_one(flat({0, 0, 1, 0, 0, 1, 0, 1}), kUnitSquare), Shape::kWarped);
}

// w and q, 1 at all corners, have no rounding that could count for that of far places.
TEST(Classify, FarFromTheOriginOnlyTheRoundingOfThePlaceCounts) {
  constexpr double kFar = 0x1p20, kStep = 0x1p-3;  // from one float to the next there
  for (int steps : {0, 2, 4, 16, 40, 1000}) {
    const double side = 100, in = steps * kStep / 2;
    const Corners position = flat({kFar, kFar, kFar + side, kFar, kFar + side - in, kFar + side, kFar + in, kFar + side});
    EXPECT_EQ(classify_one(position, kUnitSquare), steps < 8 ? Shape::kAffine : Shape::kWarped) << steps;
  }
}

TEST(Classify, EverySetCounts) {
  const std::array<Corners, 2> sets{flat({0, 0, 1, 0, .75, 1, .25, 1}), kUnitSquare};
  EXPECT_EQ(classify(kTrapezoid, std::span(sets).first(1)), Shape::kAffine);
  EXPECT_EQ(classify(kTrapezoid, sets), Shape::kWarped);
}

TEST(Classify, NotFiniteAnywhereIsNotFinite) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()}) {
    for (int corner = 0; corner < 4; ++corner) {
      for (double Vec4::*of : {&Vec4::x, &Vec4::y, &Vec4::z, &Vec4::w}) {
        Corners c = kUnitSquare;
        c[corner].*of = bad;
        EXPECT_EQ(classify_one(c, kUnitSquare), Shape::kNotFinite);
        EXPECT_EQ(classify_one(kUnitSquare, c), Shape::kNotFinite);
      }
    }
  }
}

TEST(Classify, AffineSurvivesSingleRoundingInAnyPlaceAndUnit) {
  for (unsigned trial = 0; trial < 20000; ++trial) {
    std::mt19937 engine(trial);
    std::uniform_real_distribution<double> unit(-1, 1);
    const Map to_position(engine, trial % 2 ? 1 : 1000), to_texture(engine, trial % 3 ? 1 : 500);
    Corners base;
    for (Vec4& p : base) p = {unit(engine), unit(engine), 0, 1};
    const double scale = std::exp(std::uniform_real_distribution<double>(-60, 60)(engine));
    Corners position = to_position(base), texture = to_texture(base);
    for (Vec4& p : position) p = {float(p.x * scale), float(p.y * scale), float(p.z * scale), 1};
    const Shape shape = classify_one(position, texture);
    ASSERT_TRUE(shape == Shape::kAffine || shape == Shape::kDegenerate) << "trial " << trial;
  }
}

TEST(Classify, AVisibleDisturbanceIsWarpedInAnyUnit) {
  for (unsigned trial = 0; trial < 20000; ++trial) {
    std::mt19937 engine(trial);
    const double scale = std::exp(std::uniform_real_distribution<double>(-60, 60)(engine));
    const double size = std::exp(std::uniform_real_distribution<double>(std::log(1e-5), 0)(engine));
    Corners position = flat({0, 0, 1, 0.2, 1.1, 1.3, 0.1, 1.1}), texture = kUnitSquare;
    (engine() % 2 ? position : texture)[engine() % 4].x += size;
    for (Vec4& p : position) p = {float(p.x * scale), float(p.y * scale), 0, 1};
    ASSERT_EQ(classify_one(position, texture), Shape::kWarped) << "trial " << trial;
  }
}

TEST(AffineFast, IsASubsetOfClassify) {
  int sure = 0;
  for (unsigned trial = 0; trial < 100000; ++trial) {
    std::mt19937 engine(trial);
    std::uniform_real_distribution<double> unit(-1, 1);
    // Parallelograms with one coordinate disturbed by about as much as the test may allow.
    Corners c[2];
    for (Corners& x : c) {
      const double place = engine() % 2 ? 1000 : 0;
      for (int i = 0; i < 3; ++i)
        x[i] = {unit(engine) + place, unit(engine) - place, engine() % 2 ? unit(engine) : 0, 1};
      x[3] = {x[0].x - x[1].x + x[2].x, x[0].y - x[1].y + x[2].y, x[0].z - x[1].z + x[2].z, 1};
      if (engine() % 2) x[engine() % 4].x += 0x1p-22 * unit(engine) * (1 + place);
    }
    alignas(16) float position[4][4], texture[4][4];
    for (int i = 0; i < 4; ++i) {
      const auto put = [&](float(&to)[4], Vec4& from) {
        to[0] = float(from.x), to[1] = float(from.y), to[2] = float(from.z), to[3] = float(from.w);
        from = {to[0], to[1], to[2], to[3]};
      };
      put(position[i], c[0][i]);
      put(texture[i], c[1][i]);
    }
    if (!surely_affine(position, texture)) continue;
    ++sure;
    const Shape shape = classify_one(c[0], c[1]);
    ASSERT_TRUE(shape == Shape::kAffine || shape == Shape::kDegenerate) << "trial " << trial;
  }
  EXPECT_GT(sure, 30000);
}

TEST(AffineFast, RefusesWhatIsNotFinite) {
  for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                    std::numeric_limits<float>::max()}) {
    for (int corner = 0; corner < 4; ++corner) {
      for (int i = 0; i < 4; ++i) {
        alignas(16) float position[4][4] = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}}, texture[4][4];
        std::copy(&position[0][0], &position[0][0] + 16, &texture[0][0]);
        EXPECT_TRUE(surely_affine(position, texture));
        position[corner][i] = bad;
        EXPECT_FALSE(surely_affine(position, texture));
        EXPECT_FALSE(surely_affine(texture, position));
      }
    }
  }
}

}  // namespace
}  // namespace truequad::test
