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

// What `map` does at one point of a triangle, or at the worst of several. e: the interpolation error of uv; jacobian: the
// determinant, in the sign of the triangle's own; reach: the square of |N_xy - p N_w|.
struct Local {
  double e, jacobian, w, reach;
};

double reach_at(const TextureMap& map, const ScreenPoint& p, double q) {
  const double ratio = map.w * q;
  const double x = map.x - p.x * ratio, y = map.y - p.y * ratio;
  return x * x + y * y;
}

// Distance in pixels that a texel is moved where nothing is worse than `at`.
double displacement(const TextureMap& map, const Local& at) {
  if (!(at.jacobian > 0)) return kInfinity;
  const double root = at.jacobian * at.jacobian - 4 * std::fabs(map.of_u * map.of_v) * at.e;
  if (!(root >= 0)) return kInfinity;
  const double sigma = 2 * at.e / (at.jacobian + std::sqrt(root));
  const double w = at.w - std::fabs(map.w) * sigma;
  if (!(w > 0)) return kInfinity;
  const double bound = sigma * std::sqrt(at.reach) / w * kRoundingSlack;
  return bound >= 0 ? bound : kInfinity;
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

// What holds for every part of one triangle as one map sees it, or the colours.
struct Whole {
  const ErrorModel& model;
  const TextureMap* map;  // null: the colours
  Param own;              // where the quad's determinants are the triangle's (docs/design.md: det M)
  bool clipped;
  double sign = 0;           // of the map's determinant there
  double lost_jacobian = 0;  // what the margin takes from determinants
  double step_px = 0;
  SnapMargin margin{};

  Whole(const ErrorModel& model, const TextureMap* map, Param own, bool clipped)
      : model(model), map(map), own(own), clipped(clipped) {
    if (map) sign = std::copysign(1.0, map->jacobian(own.u, own.v));
  }
  void add(const Rasteriser& rasteriser, const SnapMargin& of_triangle) {
    margin = of_triangle;
    step_px = rasteriser.step_px();
    if (map) lost_jacobian = std::fabs(map->of_u) * margin.u + std::fabs(map->of_v) * margin.v;
  }
};

// Corner of a part of a triangle: e is known there, and what set-up adds.
struct Corner {
  double u, v;
  Local at;
  ScreenPoint p;
  double setup_px;
};

Corner corner_at(const Whole& whole, const MeshPoint& at, double setup_px) {
  if (!whole.map) return {at.u, at.v, {0, 0, at.p.w, 0}, at.p, setup_px};
  return {at.u, at.v, {0, whole.sign * whole.map->jacobian(at.u, at.v), at.p.w, reach_at(*whole.map, at.p, at.q)},
          at.p, setup_px};
}

Corner middle_of(const Whole& whole, const Corner& p, const Corner& q) {
  Corner middle{(p.u + q.u) / 2, (p.v + q.v) / 2,
                {(p.at.e + q.at.e) / 2 - (p.u - q.u) * (p.v - q.v) / 4, (p.at.jacobian + q.at.jacobian) / 2,
                 (p.at.w + q.at.w) / 2, p.at.reach},
                {}, p.setup_px};
  if (!whole.map || whole.map->w != 0 || whole.clipped) middle.p = 0.5 * (p.p + q.p);
  if (whole.map && whole.map->w != 0) middle.at.reach = reach_at(*whole.map, middle.p, 1 / middle.at.w);
  // On the screen the middle of clip space divides the side as 1 / w at its ends does.
  if (!(p.at.w > 0) || !(q.at.w > 0)) {
    middle.setup_px = std::max(p.setup_px, q.setup_px);
  } else if (p.setup_px != q.setup_px) {
    middle.setup_px = (p.setup_px * p.at.w + q.setup_px * q.at.w) / (p.at.w + q.at.w);
  }
  return middle;
}

// What is drawn at one point, which no bound of a part that contains it can be less than.
double at_point(const Whole& whole, const Corner& c) {
  if (!whole.map) {
    const Param place[1] = {{c.u, c.v}};
    return colour_px(whole.model.colours, whole.model.screen,
                     {std::fabs(c.at.e) + whole.margin.error, place, whole.own, {&c.p, 1}, whole.margin, whole.step_px}) +
           c.setup_px;
  }
  return displacement(*whole.map, {std::fabs(c.at.e) + whole.margin.error, c.at.jacobian - whole.lost_jacobian,
                                  c.at.w / whole.margin.w, c.at.reach}) +
         c.setup_px;
}

double plain_bound(const Whole& whole, const std::array<Corner, 3>& c) {
  const auto product = [](const Corner& p, const Corner& q) { return std::fabs((p.u - q.u) * (p.v - q.v)); };
  const double e = std::max({std::fabs(c[0].at.e), std::fabs(c[1].at.e), std::fabs(c[2].at.e)}) +
                   std::max({product(c[0], c[1]), product(c[1], c[2]), product(c[2], c[0])}) / 4 + whole.margin.error;
  const double setup_px = std::max({c[0].setup_px, c[1].setup_px, c[2].setup_px});
  Local worst{e, 0, std::min({c[0].at.w, c[1].at.w, c[2].at.w}), std::max({c[0].at.reach, c[1].at.reach, c[2].at.reach})};
  if (whole.clipped || !whole.map) {
    Visible visible;
    if (!visible.of(whole.model.screen, c[0].p, c[1].p, c[2].p)) return 0;
    if (!whole.map) {
      const Param place[3] = {{c[0].u, c[0].v}, {c[1].u, c[1].v}, {c[2].u, c[2].v}};
      return colour_px(whole.model.colours, whole.model.screen,
                       {e, place, whole.own, visible.part.points(), whole.margin, whole.step_px}) + setup_px;
    }
    worst.w = kInfinity;
    worst.reach = 0;
    for (const ScreenPoint& p : visible.part.points()) {
      if (!(p.w > 0)) return kInfinity;
      worst.w = std::min(worst.w, p.w);
      worst.reach = std::max(worst.reach, reach_at(*whole.map, p, 1 / p.w));
    }
  }
  worst.jacobian = std::min({c[0].at.jacobian, c[1].at.jacobian, c[2].at.jacobian}) - whole.lost_jacobian;
  worst.w /= whole.margin.w;
  return displacement(*whole.map, worst) + setup_px;
}

double part_bound(const Whole& whole, const std::array<Corner, 3>& c, double limit_px, int depth) {
  const double bound = plain_bound(whole, c);
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
  const Corner middle = middle_of(whole, p, q);
  const bool search = limit_px == kTightest;
  if (!search && (!whole.clipped || whole.model.screen.outcode(middle.p) == 0) && at_point(whole, middle) > limit_px) {
    return bound;
  }
  const double first = part_bound(whole, {p, middle, far}, limit_px, depth - 1);
  if (first > limit_px && !search) return bound;
  const double second = part_bound(whole, {middle, q, far}, limit_px, depth - 1);
  if (search) return std::min(bound, std::max(first, second));
  return second > limit_px ? bound : std::max(first, second);
}

SetupVertex setup_vertex(const ScreenPoint& p, const glm::dvec3& t) {
  const double w = 1 / p.w;
  return {p.x * w, p.y * w, t.x * w, t.y * w, t.z * w};
}

// What the rounding of set-up adds to a triangle with this visible part: the largest, at all corners.
// texture: s, t and q at the corners.
std::array<double, 3> clipped_setup_px(const Rasteriser& rasteriser, const std::array<ScreenPoint, 3>& c,
                                       const std::array<glm::dvec3, 3>& texture, bool t_drawn, const VisiblePart& part) {
  const BarycentricWeights weights({c[0], c[1], c[2]});
  // The largest of the triangles that clipping can make of it.
  std::array<int, 3> largest;
  if (!largest_triangle(part.points(), largest)) return {};
  std::array<SetupVertex, 3> best;
  for (int i = 0; i < 3; ++i) {
    const ScreenPoint& p = part.point[largest[i]];
    const glm::dvec3 b = weights.at(p);
    best[i] = setup_vertex(p, b[0] * texture[0] + b[1] * texture[1] + b[2] * texture[2]);
  }
  const auto px = setup_px(rasteriser, best, {best[0], best[1], best[2]}, t_drawn);
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

SetupVertex setup_vertex(const TextureMap& map, const MeshPoint& at) {
  return {at.x, at.y, map.s.at(at.u, at.v) * at.q, map.t.at(at.u, at.v) * at.q, at.q};
}

namespace {

// A triangle of a mesh that draws something, ready to be bounded for any map.
class Sighted {
 public:
  Sighted(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c)
      : model_(model), point_{&a, &b, &c}, window_(a, b, c) {
    if (a.outside & b.outside & c.outside) return;
    const double u1 = b.u - a.u, v1 = b.v - a.v, u2 = c.u - a.u, v2 = c.v - a.v;
    const double area = u1 * v2 - u2 * v1;
    if (area == 0) return;
    // Gradient (L_u, L_v) of the linear interpolant of uv.
    const double f1 = b.u * b.v - a.u * a.v, f2 = c.u * c.v - a.u * a.v;
    gradient_u_ = (f1 * v2 - f2 * v1) / area;
    gradient_v_ = (u1 * f2 - u2 * f1) / area;
    visible_.clipped = (a.outside | b.outside | c.outside) != 0;
    draws_ = !visible_.clipped || visible_.of(model.screen, a.p, b.p, c.p);
    if (!draws_ || model.rasteriser.exact()) return;
    const double reach = std::max(model.screen.half_width, model.screen.half_height);
    const bool fat = !visible_.clipped && std::fabs(window_.area) > 1e-11 * reach * reach;
    draws_ = fat || !draws_nothing(model.screen, {a.p, b.p, c.p});
  }

  bool draws() const { return draws_; }
  bool misses() {
    if (model_.rasteriser.exact()) return false;
    if (!visible_.clipped) visible_.part = {{point_[0]->p, point_[1]->p, point_[2]->p}, 3};
    return misses_pixels(model_.rasteriser, visible_.part.points());
  }

  // What can be said of the triangle and its corners without a rasteriser.
  Whole whole(const TextureMap* map) const { return {model_, map, {gradient_v_, gradient_u_}, visible_.clipped}; }
  std::array<Corner, 3> corners(const Whole& whole) const {
    return {corner_at(whole, *point_[0], 0), corner_at(whole, *point_[1], 0), corner_at(whole, *point_[2], 0)};
  }

  void add_rasteriser(Whole& whole, std::array<Corner, 3>& corner) {
    if (model_.rasteriser.exact()) return;
    const MeshPoint &a = *point_[0], &b = *point_[1], &c = *point_[2];
    if (!margin_known_) {
      margin_known_ = true;
      margin_ = visible_.clipped ? clipped_snap_margin(model_.rasteriser, point_, gradient_u_, gradient_v_,
                                                       visible_.part.points())
                                 : snap_margin(model_.rasteriser, point_, window_, gradient_u_, gradient_v_);
    }
    whole.add(model_.rasteriser, margin_);
    std::array<double, 3> setup;
    if (!whole.map) {
      setup = colour_setup_px(model_.colours, model_.rasteriser, {a, b, c}, visible_.part, visible_.clipped);
    } else if (visible_.clipped) {
      const TextureMap& map = *whole.map;
      const auto texture = [&](const MeshPoint& at) { return glm::dvec3(map.s.at(at.u, at.v), map.t.at(at.u, at.v), 1); };
      setup = clipped_setup_px(model_.rasteriser, {a.p, b.p, c.p}, {texture(a), texture(b), texture(c)}, map.t_drawn,
                               visible_.part);
    } else {
      const TextureMap& map = *whole.map;
      setup = setup_px(model_.rasteriser, {setup_vertex(map, a), setup_vertex(map, b), setup_vertex(map, c)}, window_,
                       map.t_drawn);
    }
    for (int i = 0; i < 3; ++i) corner[i].setup_px = setup[i];
  }

 private:
  const ErrorModel& model_;
  TriangleCorners point_;
  WindowTriangle window_;
  double gradient_u_ = 0, gradient_v_ = 0;
  Visible visible_;
  bool draws_ = false, margin_known_ = false;
  SnapMargin margin_;
};

// The largest at the middles of the sides, which exact arithmetic has the largest e at.
double at_middles(const Whole& whole, const std::array<Corner, 3>& c) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const Corner middle = middle_of(whole, c[i], c[(i + 1) % 3]);
    if (whole.clipped && whole.model.screen.outcode(middle.p) != 0) continue;
    largest = std::max(largest, at_point(whole, middle));
  }
  return largest;
}

}  // namespace

double triangle_bound(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c,
                      double limit_px, int depth) {
  Sighted triangle(model, a, b, c);
  if (!triangle.draws()) return 0;
  const bool search = limit_px == kTightest;
  double bound = 0;
  for (std::size_t i = 0; i < model.parts(); ++i) {
    Whole whole = triangle.whole(model.part(i));
    std::array<Corner, 3> corner = triangle.corners(whole);
    double of_map = search ? 0 : at_middles(whole, corner);
    if (!(of_map > limit_px) || search) {
      triangle.add_rasteriser(whole, corner);
      of_map = part_bound(whole, corner, limit_px, depth);
    }
    bound = std::max(bound, of_map);
    if (bound > limit_px && !search) return triangle.misses() ? 0 : bound;
  }
  return bound;
}

double raised_bound(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c,
                    double bound_px, int depth) {
  if (triangle_bound(model, a, b, c, bound_px, depth) <= bound_px) return bound_px;
  return std::max(bound_px, triangle_bound(model, a, b, c, kTightest, depth));
}

Estimate triangle_estimate(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c) {
  constexpr int kDepth = 3;
  Sighted triangle(model, a, b, c);
  Estimate worst;
  if (!triangle.draws()) return worst;
  for (std::size_t i = 0; i < model.parts(); ++i) {
    Whole whole = triangle.whole(model.part(i));
    std::array<Corner, 3> corner = triangle.corners(whole);
    const auto look = [&] {
      return whole.clipped ? part_bound(whole, corner, kTightest, kDepth) : at_middles(whole, corner);
    };
    const double map_px = look();
    triangle.add_rasteriser(whole, corner);
    const double px = look();
    if (!(px <= worst.px())) worst = {map_px, map_px < px ? px - map_px : 0};
  }
  return worst;
}

namespace {

// The four triangles of a visible rectangle together: their own determinants are those of points of its sides, within
// the corners' range.
double whole_cell_bound(const ErrorModel& model, const std::array<MeshPoint, 4>& corner, const MeshPoint& centre,
                        double limit_px) {
  // The outer sides are axis-parallel. Next to a side of the quad without length the centre is not in the middle.
  double error = 0;
  for (const MeshPoint& c : corner) error = std::max(error, std::fabs((c.u - centre.u) * (c.v - centre.v)) / 4);
  double least_w = kInfinity;
  for (const MeshPoint& c : corner) least_w = std::min(least_w, c.p.w);
  if (!(least_w > 0)) return kInfinity;
  const bool exact = model.rasteriser.exact();
  SnapMargin margin;
  const std::array<WindowTriangle, 4> window{
      WindowTriangle(corner[0], corner[1], centre), WindowTriangle(corner[1], corner[2], centre),
      WindowTriangle(corner[2], corner[3], centre), WindowTriangle(corner[3], corner[0], centre)};
  bool margin_known = exact;
  const auto know_margin = [&] {
    for (int i = 0; i < 4 && !margin_known; ++i) {
      // Along a side of constant v, uv has the gradient (v, u of the centre).
      const MeshPoint &a = corner[i], &b = corner[(i + 1) % 4];
      const bool along_u = i % 2 == 0;
      margin.include(snap_margin(model.rasteriser, {&a, &b, &centre}, window[i], along_u ? a.v : centre.v,
                                 along_u ? centre.u : a.u));
    }
    margin_known = true;
  };
  double bound = 0;
  for (const TextureMap& map : model.maps()) {
    const double sign = std::copysign(1.0, map.jacobian(corner[0].u, corner[0].v));
    Local worst{error, kInfinity, least_w, 0};
    for (const MeshPoint& c : corner) {
      worst.jacobian = std::min(worst.jacobian, sign * map.jacobian(c.u, c.v));
      worst.reach = std::max(worst.reach, reach_at(map, c.p, c.q));
    }
    // What fails without a rasteriser fails with it.
    double map_px = displacement(map, worst);
    if (!(map_px <= limit_px)) return map_px;
    know_margin();
    if (!exact) {
      worst.e += margin.error;
      worst.jacobian -= std::fabs(map.of_u) * margin.u + std::fabs(map.of_v) * margin.v;
      worst.w /= margin.w;
      map_px = displacement(map, worst);
      if (!(map_px <= limit_px)) return map_px;
      const SetupVertex vertex[5] = {setup_vertex(map, corner[0]), setup_vertex(map, corner[1]),
                                     setup_vertex(map, corner[2]), setup_vertex(map, corner[3]),
                                     setup_vertex(map, centre)};
      double setup = 0;
      for (int i = 0; i < 4; ++i) {
        const auto px = setup_px(model.rasteriser, {vertex[i], vertex[(i + 1) % 4], vertex[4]}, window[i], map.t_drawn);
        setup = std::max({setup, px[0], px[1], px[2]});
      }
      map_px += setup;
    }
    bound = std::max(bound, map_px);
  }
  if (model.colours.count > 0 && bound <= limit_px) {
    know_margin();
    Param place[4];
    ScreenPoint points[4];
    for (int i = 0; i < 4; ++i) {
      place[i] = {corner[i].u, corner[i].v};
      points[i] = corner[i].p;
    }
    const double colour = colour_px(model.colours, model.screen, {error + margin.error, place, place[0], points, margin,
                                                                  exact ? 0 : model.rasteriser.step_px()});
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
      const std::array<glm::dvec3, 3> texel{coordinates(s, t, a), coordinates(s, t, b), coordinates(s, t, c)};
      const std::array<SetupVertex, 3> vertex{setup_vertex(p[0], texel[0]), setup_vertex(p[1], texel[1]),
                                              setup_vertex(p[2], texel[2])};
      const auto px = visible.clipped
                          ? clipped_setup_px(model.rasteriser, p, texel, true, visible.part)
                          : setup_px(model.rasteriser, vertex, {vertex[0], vertex[1], vertex[2]}, true);
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
    all &= c.outside;
    any |= c.outside;
  }
  if (all) return 0;
  const bool rectangle = corner[0].u == corner[3].u && corner[1].u == corner[2].u && corner[0].v == corner[1].v &&
                         corner[2].v == corner[3].v;
  if (!any && rectangle) {
    const double bound = whole_cell_bound(model, corner, centre, limit_px);
    if (bound <= limit_px) return bound;
  }
  double bound = 0;
  for (int i = 0; i < 4 && bound <= limit_px; ++i) {
    bound = std::max(bound, triangle_bound(model, corner[i], corner[(i + 1) % 4], centre, limit_px, 2));
  }
  return bound;
}

}  // namespace truequad::kernel
