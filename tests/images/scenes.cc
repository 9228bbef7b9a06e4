#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "quads.h"

namespace truequad::images {
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

constexpr std::array<float, 16> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// Seeds move the viewport about, so that nothing is right only at the origin.
Scene empty_scene(unsigned seed, int width, int height) {
  Scene scene{width, height, {int(seed % 7), int(seed % 5), width - 8, height - 8}, kIdentity, kIdentity, {}, false};
  return scene;
}

// glFrustum of a right angle at aspect 1, near 0.1, far 100.
std::array<float, 16> frustum() {
  constexpr double kNear = 0.1, kFar = 100;
  return {1,
          0,
          0,
          0,
          0,
          1,
          0,
          0,
          0,
          0,
          float(-(kFar + kNear) / (kFar - kNear)),
          -1,
          0,
          0,
          float(-2 * kFar * kNear / (kFar - kNear)),
          0};
}

// Turned about x, then y, then moved away from the eye.
std::array<float, 16> turned(double about_x, double about_y, double distance) {
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

void add_quad(Scene& scene, Mode mode, const std::array<std::array<float, 2>, 4>& position,
              const std::array<std::array<float, 2>, 4>& texture) {
  const float mark = float(scene.primitives.size() + 1);
  Primitive primitive{mode, {}};
  for (int i = 0; i < 4; ++i) {
    primitive.vertices.push_back(
        {{position[i][0], position[i][1], 0, 1}, {texture[i][0], texture[i][1], 0, 1}, mark});
  }
  scene.primitives.push_back(primitive);
}

constexpr std::array<std::array<float, 2>, 4> kPatch{
    {{0.1f, 0.1f}, {0.9f, 0.1f}, {0.9f, 0.9f}, {0.1f, 0.9f}}};

Scene trapezoid(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = empty_scene(seed, width, height);
  const float top = random.in(0.05, 0.85), shift = random.in(-0.1, 0.1);
  add_quad(scene, Mode::kQuads, {{{-0.95f, -0.9f}, {0.95f, -0.9f}, {top + shift, 0.9f}, {shift - top, 0.9f}}},
           kPatch);
  return scene;
}

// A square in perspective, its texture patch drawn to a trapezoid: planar, and affine in no way.
Scene perspective(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = empty_scene(seed, width, height);
  scene.projection = frustum();
  scene.modelview = turned(random.in(-1.1, 1.1), random.in(-1.1, 1.1), random.in(1.8, 4));
  const float in = random.in(0.1, 0.35);
  add_quad(scene, Mode::kQuads, {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}},
           {{{0.1f, 0.1f}, {0.9f, 0.1f}, {0.9f - in, 0.9f}, {0.1f + in, 0.9f}}});
  return scene;
}

// The same with a near and a far plane that leave little of it or nothing, and cut nothing away: "if depth clamping is enabled,
// the -w_c <= z_c <= w_c plane equation is ignored by view volume clipping" (GL 4.6 compatibility section 13.7).
Scene depth_clamped(unsigned seed, int width, int height) {
  Scene scene = perspective(seed, width, height);
  const double near = 0.5 + seed % 7, far = 1.1 * near;
  scene.projection[10] = float(-(far + near) / (far - near));
  scene.projection[14] = float(-2 * far * near / (far - near));
  scene.depth_clamped = true;
  return scene;
}

// The paper's figure 14: one vertex of a rectangle dragged, its texture coordinates staying.
Scene dragged(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = empty_scene(seed, width, height);
  scene.projection = frustum();
  scene.modelview = turned(random.in(-0.9, 0.9), random.in(-0.9, 0.9), random.in(1.8, 3));
  add_quad(scene, Mode::kQuads, {{{-1, -1}, {1, -1}, {random.in(0, 1.6), random.in(0.1, 1.6)}, {-1, 1}}},
           kPatch);
  return scene;
}

Scene polygon(unsigned seed, int width, int height) {
  Scene scene = dragged(seed, width, height);
  scene.primitives[0].mode = Mode::kPolygon;
  return scene;
}

// Two edges apart by less than a pixel, or by nothing.
Scene collapsed(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = empty_scene(seed, width, height);
  const float gap = seed % 3 ? random.in(0, 2.0 / width) : 0;
  const float x = random.in(-0.8, 0.8);
  std::array<std::array<float, 2>, 4> position{{{-0.9f, -0.9f}, {0.9f, -0.8f}, {x + gap, 0.9f}, {x, 0.9f}}};
  std::rotate(position.begin(), position.begin() + seed % 4, position.end());
  add_quad(scene, Mode::kQuads, position, kPatch);
  return scene;
}

// The floor under the eye and far ahead.
Scene near_plane(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = empty_scene(seed, width, height);
  scene.projection = frustum();
  const float floor = random.in(-0.9, -0.2), behind = random.in(0.05, 3);
  add_quad(scene, Mode::kQuads,
           {{{-2, behind}, {2, behind}, {random.in(0.5, 4), -8}, {random.in(-4, -0.5), -8}}}, kPatch);
  for (Vertex& v : scene.primitives[0].vertices) v.position = {v.position[0], floor, v.position[1], 1};
  return scene;
}

// A band over the width, its zigzag borders where `edge` says; texture runs evenly along it.
template <typename Edge>
Scene band(unsigned seed, int width, int height, int cells, Edge edge) {
  Scene scene = empty_scene(seed, width, height);
  Primitive strip{Mode::kQuadStrip, {}};
  for (int i = 0; i <= cells; ++i) {
    for (const int side : {0, 1}) {
      const std::array<float, 2> at = edge(i, side);
      const float s = 0.05f + 0.9f * float(i) / float(cells);
      strip.vertices.push_back({{at[0], at[1], 0, 1}, {s, side ? 0.9f : 0.1f, 0, 1}, float(std::max(i, 1))});
    }
  }
  scene.primitives.push_back(strip);
  return scene;
}

Scene strip(unsigned seed, int width, int height) {
  Random random(seed);
  const int cells = 3 + int(seed % 8);
  return band(seed, width, height, cells, [&](int i, int side) {
    const float x = 1.8f * float(i) / float(cells) - 0.9f;
    return std::array{x + random.in(-0.4, 0.4) / float(cells), (side ? 1 : -1) * random.in(0.2, 0.9)};
  });
}

// Some cells are parallelograms and some are not: a strip that is cut and taken up again.
Scene mixed_strip(unsigned seed, int width, int height) {
  Random random(seed);
  const int cells = 8;
  float half = 0.5f;
  return band(seed, width, height, cells, [&](int i, int side) {
    if (side == 0 && random.in(0, 1) < 0.4) half = random.in(0.2, 0.9);
    return std::array{1.75f * float(i) / float(cells) - 0.875f, (side ? 1 : -1) * half};
  });
}

// A sheet of warped quads that share their edges: no gap and no pixel twice.
Scene mesh(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = empty_scene(seed, width, height);
  constexpr int kCells = 5;
  std::array<std::array<float, 2>, (kCells + 1) * (kCells + 1)> at;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const bool border = i == 0 || j == 0 || i == kCells || j == kCells;
      const double move = border ? 0 : 0.35 * 1.8 / kCells;
      at[j * (kCells + 1) + i] = {-0.9f + 1.8f * i / kCells + random.in(-move, move),
                                  -0.9f + 1.8f * j / kCells + random.in(-move, move)};
    }
  }
  const auto texel = [](int i, int j) {
    return std::array{0.1f + 0.8f * i / kCells, 0.1f + 0.8f * j / kCells};
  };
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const int a = j * (kCells + 1) + i;
      add_quad(scene, Mode::kQuads, {at[a], at[a + 1], at[a + kCells + 2], at[a + kCells + 1]},
               {texel(i, j), texel(i + 1, j), texel(i + 1, j + 1), texel(i, j + 1)});
    }
  }
  return scene;
}

// Quads in the coordinates of a map, far from their origin, which the matrix moves back. Single precision leaves steps there
// that are much of a pixel. A step has a size in the picture, so that seeds do not depend on the unit.
Scene far_away(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = seed % 2 ? perspective(seed, width, height) : trapezoid(seed, width, height);
  const float unit = std::exp(random.in(-5, 9)), steps_px = std::exp(random.in(-5, -2));
  const float far = steps_px / (float(width) / 4) * 0x1p24f;  // in units
  std::array<float, 3> place{};
  for (int k = 0; k < (seed % 2 ? 3 : 2); ++k) place[k] = random.in(-far, far) * unit;
  for (Vertex& v : scene.primitives[0].vertices) {
    for (int k = 0; k < 3; ++k) v.position[k] = v.position[k] * unit + place[k];
  }
  // The modelview matrix, then the unit, then the place.
  std::array<float, 16>& m = scene.modelview;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) m[4 * k + i] /= unit;
    double moved = m[12 + i];
    for (int k = 0; k < 3; ++k) moved -= double(m[4 * k + i]) * place[k];
    m[12 + i] = float(moved);
  }
  return scene;
}

// Everything whose map is affine: parallelograms, a trapezoid with a trapezoid of texture, both in
// perspective, a strip of them, a polygon, and a trapezoid with the right q's of its own.
Scene affine(unsigned seed, int width, int height) {
  Random random(seed);
  Scene scene = empty_scene(seed, width, height);
  if (seed % 6 == 4) {
    return band(seed, width, height, 6, [](int i, int side) {
      return std::array{0.25f * float(i) - 0.75f, side ? 0.5f : -0.5f};
    });
  }
  // D = A - B + C in steps that floats hold exactly.
  const auto even = [&](double low, double high) { return std::round(random.in(low, high) * 64) / 64; };
  std::array<std::array<float, 2>, 4> p, t;
  for (int k : {0, 1}) {
    p[0][k] = even(-0.8, -0.2);
    p[1][k] = k ? even(-0.9, -0.3) : even(0.2, 0.8);
    p[2][k] = even(0.2, 0.9);
    p[3][k] = p[0][k] - p[1][k] + p[2][k];
    t[0][k] = even(0.3, 0.4);
    t[1][k] = k ? even(0.2, 0.4) : even(0.6, 0.7);
    t[2][k] = even(0.6, 0.7);
    t[3][k] = t[0][k] - t[1][k] + t[2][k];
  }
  if (seed % 6 == 1) {  // the same trapezoid in both
    p = {{{-0.75f, -0.75f}, {0.75f, -0.75f}, {0.375f, 0.75f}, {-0.375f, 0.75f}}};
    for (int i = 0; i < 4; ++i) t[i] = {0.5f + 0.5f * p[i][0], 0.5f + 0.5f * p[i][1]};
  }
  add_quad(scene, seed % 6 == 5 ? Mode::kPolygon : Mode::kQuads, p, t);
  if (seed % 6 == 2) {
    scene.projection = frustum();
    scene.modelview = turned(random.in(-1, 1), random.in(-1, 1), random.in(1.8, 4));
  }
  if (seed % 6 == 3) {
    // A trapezoid half as wide at the top, seen as the square that it would be in perspective.
    p = {{{-0.75f, -0.75f}, {0.75f, -0.75f}, {0.375f, 0.75f}, {-0.375f, 0.75f}}};
    for (int i = 0; i < 4; ++i) {
      const float q = i < 2 ? 1.0f : 0.5f;
      scene.primitives[0].vertices[i].position = {p[i][0], p[i][1], 0, 1};
      scene.primitives[0].vertices[i].texture = {kPatch[i][0] * q, kPatch[i][1] * q, 0, q};
    }
  }
  return scene;
}

// The shapes of the kernel's own tests on a driver. Texture coordinates are brought into the square, which
// changes no displacement.
template <test::Kind kind>
Scene shape(unsigned seed, int width, int height) {
  Scene scene = empty_scene(seed, width, height);
  const test::Quad quad = test::random_quad(kind, seed);
  for (int i = 0; i < 16; ++i) scene.projection[i] = float(quad.view.clip_from_object[i]);
  double low[2] = {INFINITY, INFINITY}, size = 0;
  for (const Vec4& t : quad.texture) low[0] = std::min(low[0], t.x), low[1] = std::min(low[1], t.y);
  for (const Vec4& t : quad.texture) size = std::max({size, t.x - low[0], t.y - low[1]});
  Primitive primitive;
  for (int i = 0; i < 4; ++i) {
    const Vec4 &p = quad.position[i], &t = quad.texture[i];
    primitive.vertices.push_back(
        {{float(p.x), float(p.y), float(p.z), float(p.w)},
         {float(0.05 + 0.9 * (t.x - low[0]) / size), float(0.05 + 0.9 * (t.y - low[1]) / size), 0, 1},
         1});
  }
  scene.primitives.push_back(primitive);
  return scene;
}

}  // namespace

const std::vector<Family>& families() {
  using test::Kind;
  static const std::vector<Family> kept = {
      {"trapezoid", trapezoid, false, true},
      {"perspective", perspective, false, true},
      {"depth_clamped", depth_clamped, false, true},
      {"dragged", dragged, false, false},
      {"polygon", polygon, false, false},
      {"collapsed", collapsed, false, false},
      {"near_plane", near_plane, false, true},
      {"strip", strip, false, false},
      {"mixed_strip", mixed_strip, false, true},
      {"mesh", mesh, false, false},
      {"affine", affine, true, true},
      {"convex", shape<Kind::kConvex>, false, true},
      {"unit_texture", shape<Kind::kUnitTexture>, false, true},
      {"concave", shape<Kind::kConcave>, false, false},
      {"bow_tie", shape<Kind::kBowTie>, false, false},
      {"non_planar", shape<Kind::kNonPlanar>, false, false},
      {"equal_corners", shape<Kind::kEqualCorners>, false, false},
      {"collinear", shape<Kind::kCollinear>, false, false},
      {"behind_eye", shape<Kind::kBehindEye>, false, true},
      {"steep", shape<Kind::kSteep>, false, true},
      {"scaled", shape<Kind::kScaled>, false, true},
      {"folded_texture", shape<Kind::kFoldedTexture>, false, true},
      {"homogeneous", shape<Kind::kHomogeneous>, false, false},
  };
  return kept;
}

const Family& family(std::string_view name) {
  static const Family other = {"far_away", far_away, false, false};
  if (name == other.name) return other;
  for (const Family& family : families()) {
    if (family.name == name) return family;
  }
  std::fprintf(stderr, "there are no scenes named %.*s\n", int(name.size()), name.data());
  std::exit(2);
}

std::vector<DrawnQuad> quads_of(const Scene& scene, double snap_px) {
  View view;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) {
        view.clip_from_object[4 * j + i] += double(scene.projection[4 * k + i]) * scene.modelview[4 * j + k];
      }
    }
  }
  const auto& [x, y, width, height] = scene.viewport;
  view.viewport = {double(x), double(y), double(width), double(height)};
  view.snap_px = snap_px;
  view.setup_rounding = 0x1p-24;
  view.depth_clamped = scene.depth_clamped;

  std::vector<DrawnQuad> quads;
  for (const Primitive& primitive : scene.primitives) {
    const bool strip = primitive.mode == Mode::kQuadStrip;
    const auto order = strip ? std::array{0, 1, 3, 2} : std::array{0, 1, 2, 3};
    for (std::size_t first = 0; first + 4 <= primitive.vertices.size(); first += strip ? 2 : 4) {
      DrawnQuad quad;
      quad.view = view;
      for (std::size_t i = 0; i < 4; ++i) {
        const Vertex& v = primitive.vertices[first + std::size_t(order[i])];
        quad.position[i] = {v.position[0], v.position[1], v.position[2], v.position[3]};
        quad.texture[i] = {v.texture[0], v.texture[1], v.texture[2], v.texture[3]};
      }
      quad.mark = int(primitive.vertices[first + 3].mark);
      quads.push_back(quad);
    }
  }
  return quads;
}

}  // namespace truequad::images
