// Texture coordinates as the error sees them: N and the determinant of docs/design.md "Error of a triangle", lemma 2.
#include <algorithm>
#include <cmath>

#include "error_model.h"

namespace truequad::kernel {
namespace {

Bilinear component(const Corners& x, double Vec4::*of) {
  return {x[0].*of, x[1].*of - x[0].*of, x[3].*of - x[0].*of, (x[0].*of - x[1].*of) + (x[2].*of - x[3].*of)};
}

bool varies(const Bilinear& f) { return f.along_u != 0 || f.along_v != 0 || f.twist != 0; }

// N = (J_T at the origin) K - (K_T x T_v) P_u - (T_u x K_T) P_v, and the determinant's coefficients.
TextureMap make_map(const ScreenQuad& quad, const Bilinear& s, const Bilinear& t) {
  TextureMap map;
  map.constant = s.along_u * t.along_v - t.along_u * s.along_v;
  map.of_v = s.twist * t.along_v - t.twist * s.along_v;
  map.of_u = s.along_u * t.twist - t.along_u * s.twist;
  const ScreenPoint n = map.constant * quad.twist - map.of_v * quad.along_u - map.of_u * quad.along_v;
  map.x = n.x;
  map.y = n.y;
  map.w = n.w;
  map.s = s;
  map.t = t;
  return map;
}

// Are the corners of (s, t) on one line, to the rounding of the doubles?
bool collinear(const Bilinear& s, const Bilinear& t) {
  const auto small = [](double a, double b) {
    return std::fabs(a - b) <= 0x1p-40 * (std::fabs(a) + std::fabs(b));
  };
  return small(s.along_u * t.along_v, t.along_u * s.along_v) &&
         small(s.along_u * t.twist, t.along_u * s.twist) && small(s.along_v * t.twist, t.along_v * s.twist);
}

// The determinant is 0 or changes sign in the unit square.
bool folds(const TextureMap& map) {
  const double at[4] = {map.constant, map.jacobian(1, 0), map.jacobian(1, 1), map.jacobian(0, 1)};
  return !(*std::min_element(at, at + 4) > 0) && !(*std::max_element(at, at + 4) < 0);
}

// Only `s` is told apart: a texel is a curve of constant s, and any second function may choose which point of
// the curve counts as its place. This one has a gradient orthogonal to that of s in the middle of the quad,
// and the twist that makes the displacement least there, or as much of it as does not fold the map.
TextureMap make_curve_map(const ScreenQuad& quad, const Bilinear& s) {
  const double gradient_u = s.along_u + s.twist / 2, gradient_v = s.along_v + s.twist / 2;
  const auto with_twist = [&](double twist) {
    TextureMap map = make_map(quad, s, {0, -gradient_v - twist / 2, gradient_u - twist / 2, twist});
    map.t_drawn = false;
    return map;
  };
  const TextureMap plain = with_twist(0);
  const ScreenPoint middle = quad.at(0.5, 0.5);
  if (!(middle.w > 0)) return plain;
  // The displacement is linear in the twist.
  const auto shift = [&](const TextureMap& map) {
    return std::array<double, 2>{map.x - middle.x / middle.w * map.w, map.y - middle.y / middle.w * map.w};
  };
  const double unit = std::max(std::fabs(gradient_u), std::fabs(gradient_v));
  const auto at_zero = shift(plain), at_unit = shift(with_twist(unit));
  const double dx = at_unit[0] - at_zero[0], dy = at_unit[1] - at_zero[1], square = dx * dx + dy * dy;
  if (!(square > 0)) return plain;
  const double best = -unit * ((at_zero[0] * dx + at_zero[1] * dy) / square);
  for (double part : {1.0, 0.75, 0.5, 0.25}) {
    const TextureMap map = with_twist(part * best);
    if (!folds(map)) return map;
  }
  return plain;
}

void add_map(ErrorModel& model, const Bilinear& s, const Bilinear& t) {
  if (!varies(s) && !varies(t)) return;
  const auto size = [](const Bilinear& f) {
    return std::fabs(f.along_u) + std::fabs(f.along_v) + std::fabs(f.twist);
  };
  const TextureMap map = collinear(s, t) ? make_curve_map(model.screen, size(s) >= size(t) ? s : t)
                                         : make_map(model.screen, s, t);
  model.folded |= folds(map);
  model.map[model.map_count++] = map;
}

}  // namespace

bool add_texture_maps(const Corners& position, std::span<const Corners> textures, ErrorModel& model) {
  model.map_count = 0;
  model.folded = false;
  for (const Corners& texture : textures.first(std::min(textures.size(), kMaxTextureSets))) {
    for (int i = 1; i < 4; ++i) {
      if (texture[i].w != texture[0].w) return false;
    }
    // A single set has been found warped by the caller.
    if (textures.size() > 1 && classify(position, {&texture, 1}) != Shape::kWarped) continue;
    const Bilinear s = component(texture, &Vec4::x), t = component(texture, &Vec4::y),
                   r = component(texture, &Vec4::z);
    if (!varies(r)) {
      add_map(model, s, t);
    } else {
      if (varies(s) && varies(t)) add_map(model, s, t);
      if (varies(t)) add_map(model, t, r);
      if (varies(s) || !varies(t)) add_map(model, s, r);
    }
  }
  return true;
}

}  // namespace truequad::kernel
