// The bound of docs/design.md "Error of a triangle"; names as there.
#include "error_model.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace truequad::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// For the rounding of this computation itself.
constexpr double kRoundingSlack = 1 + 1e-9;

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

// Part of a triangle: e, the interpolation error of uv, is known at its corners, and what set-up adds there.
struct Corner {
  double u, v, e;
  ScreenPoint p;
  double setup_px;
};

// Distance in pixels that `map` moves a texel which is drawn in the hull of `points`, when |e| <= error there
// and the determinant is at least `jacobian` in size, and w may be less by the factor `w_margin`.
double displacement(const TextureMap& map, double error, double jacobian, std::span<const ScreenPoint> points,
                    double w_margin = 1) {
  if (!(jacobian > 0)) return kInfinity;
  const double root = jacobian * jacobian - 4 * std::fabs(map.of_u * map.of_v) * error;
  if (!(root >= 0)) return kInfinity;
  const double sigma = 2 * error / (jacobian + std::sqrt(root));
  double least_w = kInfinity, largest = 0;
  for (const ScreenPoint& p : points) {
    if (!(p.w > 0)) return kInfinity;
    least_w = std::min(least_w, p.w);
    const double ratio = map.w / p.w;
    const double x = map.x - p.x * ratio, y = map.y - p.y * ratio;
    largest = std::max(largest, x * x + y * y);
  }
  const double w = least_w / w_margin - std::fabs(map.w) * sigma;
  if (!(w > 0)) return kInfinity;
  const double bound = sigma * std::sqrt(largest) / w * kRoundingSlack;
  return bound >= 0 ? bound : kInfinity;
}

// Least size of the determinant at the corners, 0 if its sign differs among them or from `sign`.
template <typename AnyCorner, std::size_t n>
double least_jacobian(const TextureMap& map, const std::array<AnyCorner, n>& corner, double sign) {
  double least = kInfinity;
  for (const AnyCorner& c : corner)
    least = std::min(least, std::copysign(1.0, sign) * map.jacobian(c.u, c.v));
  return std::max(least, 0.0);
}

struct Visible {
  VisiblePart part;
  bool clipped = false;
  // False: nothing is visible.
  bool of(const ScreenQuad& quad, const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    const unsigned at[3] = {quad.outcode(a), quad.outcode(b), quad.outcode(c)};
    if (at[0] & at[1] & at[2]) return false;
    clipped = (at[0] | at[1] | at[2]) != 0;
    clip_triangle(quad, a, b, c, at[0] | at[1] | at[2], part);
    return part.count > 0;
  }
};

double largest_product(const std::array<Corner, 3>& c) {
  const auto product = [](const Corner& p, const Corner& q) { return std::fabs((p.u - q.u) * (p.v - q.v)); };
  return std::max({product(c[0], c[1]), product(c[1], c[2]), product(c[2], c[0])});
}

// What holds for every part of one triangle.
struct Whole {
  std::array<double, kMaxMaps> own;  // its determinants (docs/design.md: det M)
  Param own_place;                   // where the quad's own are those
  SnapMargin margin;
};

// On the screen the middle of clip space divides the side as 1 / w at its ends does.
double middle_setup(const Corner& p, const Corner& q) {
  if (!(p.p.w > 0) || !(q.p.w > 0) || p.setup_px == q.setup_px) return std::max(p.setup_px, q.setup_px);
  return (p.setup_px * p.p.w + q.setup_px * q.p.w) / (p.p.w + q.p.w);
}

double margin_step_px(const ErrorModel& model) { return model.rasteriser.exact() ? 0 : model.rasteriser.step_px(); }

double part_bound(const ErrorModel& model, const Whole& whole, const std::array<Corner, 3>& c, double limit_px,
                  int depth) {
  Visible visible;
  if (!visible.of(model.screen, c[0].p, c[1].p, c[2].p)) return 0;
  const SnapMargin& margin = whole.margin;
  const double error = std::max({std::fabs(c[0].e), std::fabs(c[1].e), std::fabs(c[2].e)}) +
                       largest_product(c) / 4 + margin.error;
  double bound = 0;
  for (std::size_t i = 0; i < model.map_count; ++i) {
    const TextureMap& map = model.map[i];
    const double jacobian = least_jacobian(map, c, whole.own[i]) - std::fabs(map.of_u) * margin.u -
                            std::fabs(map.of_v) * margin.v;
    bound = std::max(bound, displacement(map, error, jacobian, visible.part.points(), margin.w));
  }
  if (model.colours.count > 0) {
    const std::array<Param, 3> corner{Param{c[0].u, c[0].v}, Param{c[1].u, c[1].v}, Param{c[2].u, c[2].v}};
    bound = std::max(bound, colour_px(model.colours, model.screen, {error, corner, whole.own_place, visible.part.points(),
                                                                    margin, margin_step_px(model)}));
  }
  bound += std::max({c[0].setup_px, c[1].setup_px, c[2].setup_px});
  if (bound <= limit_px || depth == 0) return bound;

  // Halve the longest side in the parameter square.
  int longest = 0;
  double length = -1;
  for (int i = 0; i < 3; ++i) {
    const Corner &p = c[i], &q = c[(i + 1) % 3];
    const double l = std::max(std::fabs(p.u - q.u), std::fabs(p.v - q.v));
    if (l > length) length = l, longest = i;
  }
  const Corner &p = c[longest], &q = c[(longest + 1) % 3], &far = c[(longest + 2) % 3];
  const Corner middle{(p.u + q.u) / 2, (p.v + q.v) / 2, (p.e + q.e) / 2 - (p.u - q.u) * (p.v - q.v) / 4,
                      0.5 * (p.p + q.p), middle_setup(p, q)};
  const double first = part_bound(model, whole, {p, middle, far}, limit_px, depth - 1);
  const bool search = limit_px == kTightest;
  if (first > limit_px && !search) return bound;
  const double second = part_bound(model, whole, {middle, q, far}, limit_px, depth - 1);
  if (search) return std::min(bound, std::max(first, second));
  return second > limit_px ? bound : std::max(first, second);
}

// What the rounding of set-up adds at the corners of a triangle; where it is clipped, the largest at all of them.
// texture: s, t and q at the corners.
std::array<double, 3> setup_at(const Rasteriser& rasteriser, const std::array<ScreenPoint, 3>& c,
                               const std::array<glm::dvec3, 3>& texture, bool t_drawn, const VisiblePart& part,
                               bool clipped) {
  const auto vertex_at = [](const ScreenPoint& p, const glm::dvec3& t) {
    const double w = 1 / p.w;
    return SetupVertex{p.x * w, p.y * w, t.x * w, t.y * w, t.z * w};
  };
  if (!clipped) {
    return setup_px(rasteriser, {vertex_at(c[0], texture[0]), vertex_at(c[1], texture[1]), vertex_at(c[2], texture[2])},
                    t_drawn);
  }
  const BarycentricWeights weights({c[0], c[1], c[2]});
  std::array<int, 3> largest;
  if (!largest_triangle(part.points(), largest)) return {};
  std::array<SetupVertex, 3> best;
  for (int i = 0; i < 3; ++i) {
    const ScreenPoint& p = part.point[largest[i]];
    const glm::dvec3 b = weights.at(p);
    best[i] = vertex_at(p, b[0] * texture[0] + b[1] * texture[1] + b[2] * texture[2]);
  }
  const auto px = setup_px(rasteriser, best, t_drawn);
  const double most = std::max({px[0], px[1], px[2]});
  return {most, most, most};
}

// Two of the corners are one point of the screen, to the rounding of this computation: nothing is drawn.
bool draws_nothing(const ScreenQuad& quad, const std::array<ScreenPoint, 3>& c) {
  const double reach = std::max(quad.half_width, quad.half_height);
  for (int i = 0; i < 3; ++i) {
    const ScreenPoint &p = c[i], &q = c[(i + 1) % 3];
    const double size = 1e-12 * reach * std::fabs(p.w * q.w);
    if (std::fabs(p.x * q.w - q.x * p.w) <= size && std::fabs(p.y * q.w - q.y * p.w) <= size) return true;
  }
  return false;
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

MeshPoint mesh_point(const ErrorModel& model, double u, double v) { return {u, v, model.screen.at(u, v)}; }

double triangle_bound(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c,
                      double limit_px, int depth) {
  const double u1 = b.u - a.u, v1 = b.v - a.v, u2 = c.u - a.u, v2 = c.v - a.v;
  const double area = u1 * v2 - u2 * v1;
  if (area == 0) return 0;  // draws nothing
  // Gradient (L_u, L_v) of the linear interpolant of uv.
  const double f1 = b.u * b.v - a.u * a.v, f2 = c.u * c.v - a.u * a.v;
  const double gradient_u = (f1 * v2 - f2 * v1) / area, gradient_v = (u1 * f2 - u2 * f1) / area;
  Whole whole;
  whole.own_place = {gradient_v, gradient_u};
  for (std::size_t i = 0; i < model.map_count; ++i)
    whole.own[i] = model.map[i].jacobian(gradient_v, gradient_u);
  std::array<double, 3> setup{};
  Visible visible;
  const bool exact = model.rasteriser.exact();
  if (!exact) {
    const std::array<ScreenPoint, 3> p{a.p, b.p, c.p};
    if (!visible.of(model.screen, a.p, b.p, c.p) || draws_nothing(model.screen, p)) return 0;
    whole.margin = visible.clipped ? clipped_snap_margin(model.rasteriser, {a, b, c}, gradient_u, gradient_v,
                                                         visible.part.points())
                                   : snap_margin(model.rasteriser, {a, b, c}, gradient_u, gradient_v);
    for (const TextureMap& map : model.maps()) {
      const auto texture = [&](const MeshPoint& at) { return glm::dvec3(map.s.at(at.u, at.v), map.t.at(at.u, at.v), 1); };
      const auto px = setup_at(model.rasteriser, p, {texture(a), texture(b), texture(c)}, map.t_drawn, visible.part,
                               visible.clipped);
      for (int i = 0; i < 3; ++i) setup[i] = std::max(setup[i], px[i]);
    }
    if (model.colours.count > 0) {
      const auto px = colour_setup_px(model.colours, model.rasteriser, {a, b, c}, visible.part, visible.clipped);
      for (int i = 0; i < 3; ++i) setup[i] = std::max(setup[i], px[i]);
    }
  }
  const std::array<Corner, 3> corner{Corner{a.u, a.v, 0, a.p, setup[0]}, Corner{b.u, b.v, 0, b.p, setup[1]},
                                     Corner{c.u, c.v, 0, c.p, setup[2]}};
  const double bound = part_bound(model, whole, corner, limit_px, depth);
  if (bound > limit_px && limit_px != kTightest && !exact && misses_pixels(model.rasteriser, visible.part.points())) return 0;
  return bound;
}

namespace {

// The four triangles of a visible rectangle together: their own determinants are those of points of its sides, within
// the corners' range.
double whole_cell_bound(const ErrorModel& model, const std::array<MeshPoint, 4>& corner, const MeshPoint& centre) {
  const ScreenPoint points[4] = {corner[0].p, corner[1].p, corner[2].p, corner[3].p};
  // The outer sides are axis-parallel. Next to a side of the quad without length the centre is not in the middle.
  double error = 0;
  for (const MeshPoint& c : corner) error = std::max(error, std::fabs((c.u - centre.u) * (c.v - centre.v)) / 4);
  SnapMargin margin;
  if (!model.rasteriser.exact()) {
    for (int i = 0; i < 4; ++i) {
      // Along a side of constant v, uv has the gradient (v, u of the centre).
      const MeshPoint &a = corner[i], &b = corner[(i + 1) % 4];
      margin.include(snap_margin(model.rasteriser, {a, b, centre}, i % 2 == 0 ? a.v : centre.v,
                                 i % 2 == 0 ? centre.u : a.u));
    }
  }
  double bound = 0;
  for (const TextureMap& map : model.maps()) {
    const double jacobian = least_jacobian(map, corner, map.jacobian(corner[0].u, corner[0].v)) -
                            std::fabs(map.of_u) * margin.u - std::fabs(map.of_v) * margin.v;
    double map_px = displacement(map, error + margin.error, jacobian, points, margin.w);
    if (!model.rasteriser.exact()) {
      const auto vertex_at = [&](const MeshPoint& at) {
        const double w = 1 / at.p.w;
        return SetupVertex{at.p.x * w, at.p.y * w, map.s.at(at.u, at.v) * w, map.t.at(at.u, at.v) * w, w};
      };
      const SetupVertex vertex[5] = {vertex_at(corner[0]), vertex_at(corner[1]), vertex_at(corner[2]),
                                     vertex_at(corner[3]), vertex_at(centre)};
      double setup = 0;
      for (int i = 0; i < 4; ++i) {
        const auto px = setup_px(model.rasteriser, {vertex[i], vertex[(i + 1) % 4], vertex[4]}, map.t_drawn);
        setup = std::max({setup, px[0], px[1], px[2]});
      }
      map_px += setup;
    }
    bound = std::max(bound, map_px);
  }
  if (model.colours.count > 0) {
    std::array<Param, 4> place;
    for (int i = 0; i < 4; ++i) place[i] = {corner[i].u, corner[i].v};
    double colour = colour_px(model.colours, model.screen,
                              {error + margin.error, place, place[0], points, margin, margin_step_px(model)});
    double setup = 0;
    for (int i = 0; i < 4; ++i) {
      const auto px = colour_setup_px(model.colours, model.rasteriser, {corner[i], corner[(i + 1) % 4], centre}, {}, false);
      setup = std::max({setup, px[0], px[1], px[2]});
    }
    bound = std::max(bound, colour + setup);
  }
  return bound;
}

}  // namespace

double projected_px(const ErrorModel& model, const Corners& texture, const std::array<double, 4>& lambda, double limit_px) {
  if (model.rasteriser.exact()) return 0;
  const auto coordinates = [&](double Vec4::*s, double Vec4::*t, int i) {
    return lambda[i] * glm::dvec3(texture[i].*s, texture[i].*t, texture[i].w);
  };
  const auto varies = [&](double Vec4::*of) {
    return std::any_of(texture.begin(), texture.end(), [&](const Vec4& t) { return t.*of != texture[0].*of; });
  };
  constexpr std::array<std::array<double Vec4::*, 2>, 3> kPairs{
      {{&Vec4::x, &Vec4::y}, {&Vec4::y, &Vec4::z}, {&Vec4::x, &Vec4::z}}};
  double bound = 0;
  for (int i = 0; i < 4; ++i) {
    const int a = i / 2, b = a + 1 + i % 2, c = (a + 2 + i % 2) % 4;
    const std::array<ScreenPoint, 3> p{model.screen.corner[a], model.screen.corner[b], model.screen.corner[c]};
    Visible visible;
    if (!visible.of(model.screen, p[0], p[1], p[2]) || draws_nothing(model.screen, p)) continue;
    double worst = 0;
    for (const auto& [s, t] : kPairs) {
      if (!varies(s) || !varies(t)) continue;
      const auto px = setup_at(model.rasteriser, p, {coordinates(s, t, a), coordinates(s, t, b), coordinates(s, t, c)},
                               true, visible.part, visible.clipped);
      worst = std::max({worst, px[0], px[1], px[2]});
    }
    if (worst > limit_px && misses_pixels(model.rasteriser, visible.part.points())) continue;
    bound = std::max(bound, worst);
  }
  return bound;
}

double cell_bound(const ErrorModel& model, const std::array<MeshPoint, 4>& corner, const MeshPoint& centre,
                  double limit_px) {
  unsigned all = ~0u, any = 0;
  for (const MeshPoint& c : corner) {
    const unsigned at = model.screen.outcode(c.p);
    all &= at;
    any |= at;
  }
  if (all) return 0;
  const bool rectangle = corner[0].u == corner[3].u && corner[1].u == corner[2].u && corner[0].v == corner[1].v &&
                         corner[2].v == corner[3].v;
  if (!any && rectangle) {
    const double bound = whole_cell_bound(model, corner, centre);
    if (bound <= limit_px) return bound;
  }
  double bound = 0;
  for (int i = 0; i < 4; ++i) {
    bound = std::max(bound, triangle_bound(model, corner[i], corner[(i + 1) % 4], centre, limit_px, 2));
  }
  return bound;
}

}  // namespace truequad::kernel
