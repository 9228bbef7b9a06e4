// A surface that a clip plane of the program cuts. The cut runs through the mesh's triangles one by one, so
// its vertices snap to the rasteriser's grid elsewhere than those of two triangles: pixels whose centres lie
// on the cut, to that grid, may be on either side of it, and no others.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "run_semantics.h"
#include "shapes.h"

namespace truequad::semantics {
namespace {

using Vector = std::array<double, 4>;

Vector times(const Matrix& m, const Vector& p) {
  Vector result{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) result[row] += double(m[4 * column + row]) * p[column];
  }
  return result;
}

// The plane of a shape, seen: signed distance in pixels of a point of the window from the cut.
class Cut {
 public:
  Cut(const Shape& shape, const Vector& plane) {
    const auto& v = shape.primitives[0].vertices;
    const auto point = [&](const Vertex& vertex, double w) -> Vector {
      const auto &p = vertex.position, &a = v[0].position;
      if (w == 1) return {p[0], p[1], p[2], 1};
      return {double(p[0]) - a[0], double(p[1]) - a[1], double(p[2]) - a[2], 0};
    };
    const std::array<Vector, 3> basis = {point(v[1], 0), point(v[2], 0), point(v[0], 1)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector eye = times(shape.modelview, basis[i]), clip = times(shape.projection, eye);
      column_[i] = {clip[0], clip[1], clip[3]};
      value_[i] = plane[0] * eye[0] + plane[1] * eye[1] + plane[2] * eye[2] + plane[3] * eye[3];
    }
  }

  double distance_px(double x, double y) const {
    constexpr double kStep = 1e-3;
    const double here = at(x, y);
    return here / std::hypot((at(x + kStep, y) - here) / kStep, (at(x, y + kStep) - here) / kStep);
  }

 private:
  // The plane's value at the point of the surface that is seen there, by Cramer's rule. It is homogeneous:
  // divided by the value of "1" at that point.
  double at(double x, double y) const {
    const std::array<double, 3> ray = {2 * x / kWidth - 1, 2 * y / kHeight - 1, 1};
    const auto determinant = [](const std::array<double, 3>& a, const std::array<double, 3>& b,
                                const std::array<double, 3>& c) {
      return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    const double s = determinant(ray, column_[1], column_[2]), t = determinant(column_[0], ray, column_[2]),
                 one = determinant(column_[0], column_[1], ray);
    return (s * value_[0] + t * value_[1] + one * value_[2]) / one;
  }

  std::array<std::array<double, 3>, 3> column_;
  std::array<double, 3> value_;
};

TEST(ClipPlanes, CutWhereTheyCutNatively) {
  const Job job{"osmesa", "clip_planes", 0, 12};
  const Outcome native = run_natively(job), seen = run_with_truequad(job);
  ASSERT_FALSE(native.records.empty() || seen.records.empty());
  EXPECT_GT(seen.corrected, 0);
  int pixels = 0;
  for (const auto& [name, bytes] : native.records) {
    const std::size_t space = name.find(' ');
    const Shape shape = make_shape(name.substr(0, space), unsigned(std::stoi(name.substr(space + 1))));
    const Cut cut(shape, {0.6, 0.8, 0.1, 0.2});
    for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
      if (native.byte(name, pixel, 0) == seen.byte(name, pixel, 0)) continue;
      ++pixels;
      const double away_px = cut.distance_px(pixel % kWidth + 0.5, pixel / kWidth + 0.5);
      // Vertices snap to 1/256 px, by half of it along either axis; two of them bound the cut.
      EXPECT_LT(std::fabs(away_px), std::sqrt(0.5) / 256 + 1e-3) << name << " pixel " << pixel;
      EXPECT_LE(seen.byte(name, pixel, 0), 8) << name << " touched twice";
    }
  }
  std::printf("clip_planes: %d pixels of %zu pictures are on the other side\n", pixels,
              native.records.size());
}

}  // namespace
}  // namespace truequad::semantics
