#include "quads.h"

#include <algorithm>
#include <cmath>

namespace truequad::test {
namespace {

using Matrix = std::array<double, 16>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) c[4 * j + i] += a[4 * k + i] * b[4 * j + k];
    }
  }
  return c;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double log_in(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
  bool one_in(int n) { return below(n) == 0; }

 private:
  std::mt19937 engine_;
};

struct Flat {
  double x[4], y[4];
};

// Points on an ellipse in order are convex; turning backwards gives the other winding.
Flat convex(Random& random) {
  Flat f;
  double angle[4];
  do {
    for (double& a : angle) a = random.in(0, 6.28318);
    std::sort(angle, angle + 4);
  } while (angle[1] - angle[0] < 0.2 || angle[2] - angle[1] < 0.2 || angle[3] - angle[2] < 0.2 ||
           angle[0] + 6.28318 - angle[3] < 0.2);
  if (random.one_in(3)) std::reverse(angle, angle + 4);
  const double wide = random.in(0.3, 1), high = random.in(0.3, 1);
  for (int i = 0; i < 4; ++i) {
    f.x[i] = wide * std::cos(angle[i]);
    f.y[i] = high * std::sin(angle[i]);
  }
  return f;
}

// One corner moved into the triangle of the others.
Flat concave(Random& random) {
  Flat f = convex(random);
  const int i = random.below(4), a = (i + 1) % 4, b = (i + 2) % 4, c = (i + 3) % 4;
  double r = random.in(0.05, 0.4), s = random.in(0.2, 0.5);
  f.x[i] = s * f.x[a] + r * f.x[b] + (1 - r - s) * f.x[c];
  f.y[i] = s * f.y[a] + r * f.y[b] + (1 - r - s) * f.y[c];
  return f;
}

Flat bow_tie(Random& random) {
  Flat f = convex(random);
  const int i = random.below(4), j = (i + 1) % 4;
  std::swap(f.x[i], f.x[j]);
  std::swap(f.y[i], f.y[j]);
  return f;
}

Flat equal_corners(Random& random) {
  Flat f = convex(random);
  const int i = random.below(4), j = (i + 1 + random.below(3)) % 4;
  f.x[i] = f.x[j];
  f.y[i] = f.y[j];
  return f;
}

Flat collinear(Random& random) {
  Flat f = convex(random);
  const int i = random.below(4), a = (i + 1) % 4, b = (i + 3) % 4;
  const double t = random.in(0.1, 0.9);
  f.x[i] = f.x[a] + t * (f.x[b] - f.x[a]);
  f.y[i] = f.y[a] + t * (f.y[b] - f.y[a]);
  return f;
}

Flat parallelogram(Random& random) {
  Flat f = convex(random);
  f.x[3] = f.x[0] - f.x[1] + f.x[2];
  f.y[3] = f.y[0] - f.y[1] + f.y[2];
  return f;
}

Corners corners(const Flat& f) {
  Corners c;
  for (int i = 0; i < 4; ++i) c[i] = {f.x[i], f.y[i], 0, 1};
  return c;
}

Matrix rotation(Random& random) {
  // From a random unit quaternion.
  double q[4], length = 0;
  for (double& c : q) c = random.in(-1, 1), length += c * c;
  length = std::sqrt(length) + 1e-9;
  for (double& c : q) c /= length;
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {1 - 2 * (y * y + z * z),
          2 * (x * y + z * w),
          2 * (x * z - y * w),
          0,
          2 * (x * y - z * w),
          1 - 2 * (x * x + z * z),
          2 * (y * z + x * w),
          0,
          2 * (x * z + y * w),
          2 * (y * z - x * w),
          1 - 2 * (x * x + y * y),
          0,
          0,
          0,
          0,
          1};
}

Matrix translation(double x, double y, double z) { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}; }

// glFrustum's matrix, symmetric.
Matrix perspective(double slope, double aspect, double near, double far) {
  return {1 / (slope * aspect),
          0,
          0,
          0,
          0,
          1 / slope,
          0,
          0,
          0,
          0,
          -(far + near) / (far - near),
          -1,
          0,
          0,
          -2 * far * near / (far - near),
          0};
}

float single(double x) { return float(x); }

void to_single(Corners& c) {
  for (Vec4& p : c) p = {single(p.x), single(p.y), single(p.z), single(p.w)};
}

Matrix identity() { return translation(0, 0, 0); }

}  // namespace

std::string name(Kind kind) {
  static const char* const names[] = {
      "Convex",        "UnitTexture",      "Concave",        "BowTie",     "NonPlanar", "NearlyAffine",
      "EqualCorners",  "Collinear",        "BehindEye",      "Steep",      "Scaled",    "TextureFar",
      "FoldedTexture", "TextureCollinear", "OneDimensional", "Homogeneous"};
  return names[int(kind)];
}

View pixel_view(double width, double height) {
  View view;
  view.clip_from_object = {2 / width, 0, 0, 0, 0, 2 / height, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  view.viewport = {0, 0, width, height};
  return view;
}

Quad random_quad(Kind kind, unsigned trial) {
  Random random(trial * unsigned(Kind::kCount) + unsigned(kind));
  Quad quad;
  quad.texture = corners(convex(random));
  quad.position = corners(convex(random));
  switch (kind) {
    case Kind::kUnitTexture:
      quad.texture = kUnitSquare;
      break;
    case Kind::kConcave:
      quad.position = corners(concave(random));
      break;
    case Kind::kBowTie:
      quad.position = corners(bow_tie(random));
      break;
    case Kind::kNonPlanar:
      for (Vec4& p : quad.position) p.z = random.in(-0.5, 0.5);
      break;
    case Kind::kNearlyAffine: {
      quad.position = corners(parallelogram(random));
      quad.texture = corners(parallelogram(random));
      const double size = random.log_in(1e-7, 1e-2);
      quad.position[random.below(4)].x += size;
      quad.texture[random.below(4)].y -= size;
      break;
    }
    case Kind::kEqualCorners:
      quad.position = corners(equal_corners(random));
      break;
    case Kind::kCollinear:
      quad.position = corners(collinear(random));
      break;
    case Kind::kFoldedTexture:
      quad.texture = corners(random.one_in(2) ? concave(random) : bow_tie(random));
      break;
    case Kind::kTextureCollinear:
      quad.texture = corners(random.one_in(2) ? collinear(random) : equal_corners(random));
      break;
    case Kind::kOneDimensional:
      for (Vec4& p : quad.texture) p.y = 0;
      break;
    default:
      break;
  }
  if (kind == Kind::kTextureFar) {
    const double s = random.in(-9000, 9000), t = random.in(-9000, 9000), repeat = random.log_in(1, 2000);
    for (Vec4& p : quad.texture) p.x = p.x * repeat + s, p.y = p.y * repeat + t;
  }

  const double width = std::floor(random.log_in(16, 16384)), height = std::floor(width * random.in(0.4, 1.6));
  quad.view.viewport = {std::floor(random.in(0, 50)), std::floor(random.in(0, 50)), width,
                        std::max(height, 1.0)};
  quad.view.snap_px = random.one_in(2) ? 0 : 1.0 / 256;
  quad.tolerance_px = random.log_in(0.1, 2);

  Matrix model = rotation(random);
  double distance = random.log_in(0.8, 12);
  const double slope = random.log_in(0.3, 2);
  if (kind == Kind::kBehindEye) distance = random.in(-0.5, 0.9);
  if (kind == Kind::kSteep) {
    // Seen along its plane, from close to it, and long.
    const double tilt = random.log_in(1e-3, 0.3);
    model = product(rotation(random), identity());
    model = {1, 0, 0, 0, 0, std::sin(tilt), -std::cos(tilt), 0, 0, std::cos(tilt), std::sin(tilt),
             0, 0, 0, 0, 1};
    distance = random.in(0.9, 1.3);
  }
  const bool flat = kind != Kind::kBehindEye && kind != Kind::kSteep && random.one_in(3);
  if (flat) {
    // A window's own coordinates, as a picture program has them.
    quad.view.clip_from_object =
        product(translation(random.in(-0.3, 0.3), random.in(-0.3, 0.3), 0), identity());
  } else {
    const double near = kind == Kind::kSteep ? 0.002 : 0.05;
    quad.view.clip_from_object =
        product(perspective(slope, 1, near, 100),
                product(translation(random.in(-0.3, 0.3), random.in(-0.3, 0.3), -distance), model));
  }
  if (kind == Kind::kHomogeneous) {
    for (Vec4& p : quad.position) {
      const double w = random.log_in(0.2, 5);
      p = {p.x * w, p.y * w, p.z * w, w};
    }
  }
  if (kind == Kind::kScaled) {
    const double unit = random.log_in(1e-30, 1e30), texel = random.log_in(1e-30, 1e30);
    for (Vec4& p : quad.position) p.x *= unit, p.y *= unit, p.z *= unit;
    for (Vec4& p : quad.texture) p.x *= texel, p.y *= texel;
    for (int i = 0; i < 12; ++i) quad.view.clip_from_object[i] /= unit;
  }
  to_single(quad.position);
  to_single(quad.texture);
  return quad;
}

}  // namespace truequad::test
