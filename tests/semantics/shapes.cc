#include "shapes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace truequad::semantics {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float in(double low, double high) {
    return float(std::uniform_real_distribution<double>(low, high)(engine_));
  }

 private:
  std::mt19937 engine_;
};

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// glFrustum with a quarter turn from top to bottom at the aspect of the pictures.
Matrix frustum() {
  constexpr double kNear = 0.25, kFar = 20;
  Matrix m{};
  m[0] = 0.75f;
  m[5] = 1;
  m[10] = float(-(kFar + kNear) / (kFar - kNear));
  m[11] = -1;
  m[14] = float(-2 * kFar * kNear / (kFar - kNear));
  return m;
}

// Turned about x, then y, then moved away from the eye.
Matrix turned(double about_x, double about_y, double distance) {
  const double cx = std::cos(about_x), sx = std::sin(about_x), cy = std::cos(about_y), sy = std::sin(about_y);
  return {float(cy),
          0,
          float(-sy),
          0,
          float(sy * sx),
          float(cx),
          float(cy * sx),
          0,
          float(sy * cx),
          float(-sx),
          float(cy * cx),
          0,
          0,
          0,
          float(-distance),
          1};
}

std::array<double, 4> multiply(const Matrix& m, const std::array<double, 4>& p) {
  std::array<double, 4> result{};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) result[row] += double(m[4 * column + row]) * p[column];
  }
  return result;
}

// In front of the eye, with corners that all turn the same way by a good part of a pixel.
bool picture_is_convex(const Shape& shape) {
  std::array<std::array<double, 2>, 4> at;
  for (int i = 0; i < 4; ++i) {
    const auto& p = shape.primitives[0].vertices[std::size_t(i)].position;
    const auto clip = multiply(shape.projection, multiply(shape.modelview, {p[0], p[1], p[2], 1}));
    if (clip[3] < 0.3) return false;
    at[std::size_t(i)] = {80 * clip[0] / clip[3], 60 * clip[1] / clip[3]};
  }
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &a = at[i], &b = at[(i + 1) % 4], &c = at[(i + 2) % 4];
    const double area = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
    left += area > 20;
    right += area < -20;
  }
  return left == 4 || right == 4;
}

// A trapezoid of heights 2 a and 2 b at x = -1 and x = 1.
Primitive trapezoid(GLenum mode, float a, float b, float slant) {
  return {mode,
          {{{-1, -a, 0}, 0, 0}, {{1, slant - b, 0}, 1, 0}, {{1, slant + b, 0}, 1, 1}, {{-1, a, 0}, 0, 1}}};
}

Shape flat(Random& random, GLenum mode) {
  const float wide = random.in(0.7, 1), narrow = random.in(0.15, 0.5);
  const bool swap = random.in(0, 1) < 0.5;
  Shape shape{{trapezoid(mode, swap ? narrow : wide, swap ? wide : narrow, random.in(-0.2, 0.2))},
              frustum(),
              turned(random.in(-0.8, 0.8), random.in(-0.8, 0.8), random.in(1.6, 2.4))};
  return shape;
}

Shape tilted(Random& random) {
  Shape shape = flat(random, GL_QUADS);
  for (Vertex& v : shape.primitives[0].vertices) {
    const auto eye = multiply(shape.modelview, {v.position[0], v.position[1], v.position[2], 1});
    v.position = {float(eye[0]), float(eye[1]), float(eye[2])};
  }
  shape.modelview = kIdentity;
  return shape;
}

Shape floor_shape(Random& random) {
  Shape shape = flat(random, GL_QUADS);
  const float behind = random.in(0.1, 2), far = random.in(-8, -5), left = random.in(-4, -1),
              right = random.in(1, 4);
  shape.primitives[0].vertices = {
      {{-2, behind, 0}, 0, 0}, {{2, behind, 0}, 1, 0}, {{right, far, 0}, 1, 1}, {{left, far, 0}, 0, 1}};
  // Its y is the eye's z.
  shape.modelview = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, random.in(-0.8, -0.3), 0, 1};
  return shape;
}

Shape bent(Random& random, bool convex) {
  while (true) {
    Shape shape = flat(random, GL_QUADS);
    const double depth = convex ? 0.5 : 1.2;
    for (Vertex& v : shape.primitives[0].vertices) v.position[2] = random.in(-depth, depth);
    if (picture_is_convex(shape) == convex) return shape;
  }
}

// Columns of a band; between equal heights lies a parallelogram.
Shape band(Random& random, GLenum mode) {
  constexpr int kColumns = 7;
  Shape shape{
      {{mode, {}}}, frustum(), turned(random.in(-0.7, 0.7), random.in(-0.7, 0.7), random.in(1.6, 2.2))};
  std::array<float, kColumns> half{};
  for (int i = 0; i < kColumns; ++i) {
    half[std::size_t(i)] = i % 3 == 2 ? half[std::size_t(i - 1)] : random.in(0.15, 0.9);
  }
  const auto at = [&](int i, int side) -> Vertex {
    const float x = float(2 * i - kColumns + 1) / (kColumns - 1), y = half[std::size_t(i)];
    return {{x, side ? y : -y, 0}, float(i), float(side)};
  };
  auto& vertices = shape.primitives[0].vertices;
  for (int i = 0; i < kColumns; ++i) {
    if (mode == GL_QUAD_STRIP) {
      vertices.insert(vertices.end(), {at(i, 0), at(i, 1)});
    } else if (i + 1 < kColumns) {
      vertices.insert(vertices.end(), {at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)});
    }
  }
  return shape;
}

}  // namespace

const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> names = {"trapezoid", "tilted", "floor", "non_planar",
                                                 "folded",    "mixed",  "strip", "polygon"};
  return names;
}

Shape make_shape(const std::string& name, unsigned seed) {
  Random random(seed);
  if (name == "trapezoid") return flat(random, GL_QUADS);
  if (name == "tilted") return tilted(random);
  if (name == "floor") return floor_shape(random);
  if (name == "non_planar") return bent(random, true);
  if (name == "folded") return bent(random, false);
  if (name == "mixed") return band(random, GL_QUADS);
  if (name == "strip") return band(random, GL_QUAD_STRIP);
  if (name == "polygon") return flat(random, GL_POLYGON);
  std::fprintf(stderr, "there is no shape named %s\n", name.c_str());
  std::exit(2);
}

}  // namespace truequad::semantics
