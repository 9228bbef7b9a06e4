// Clip-space geometry. Clipping after Sutherland and Hodgman, "Reentrant Polygon Clipping" (CACM 1974), in
// homogeneous coordinates, so that points behind the eye need no special case.
#include "screen.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

namespace truequad::kernel {
namespace {

// Ends of an edge nearer than this are one point to a rasteriser and to the eye.
constexpr double kCollapsedPx = 1.0 / 16;

// Signed distance from one plane of the clip volume, positive inside; planes are numbered as outcode's bits.
double inside(const ScreenQuad& quad, int plane, const ScreenPoint& p) {
  switch (plane) {
    case 0:
      return quad.half_width * p.w + p.x;
    case 1:
      return quad.half_width * p.w - p.x;
    case 2:
      return quad.half_height * p.w + p.y;
    case 3:
      return quad.half_height * p.w - p.y;
    case 4:
      return p.w + p.z;
    default:
      return p.w - p.z;
  }
}

bool finite(const ScreenPoint& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

}  // namespace

bool ScreenQuad::invisible() const {
  return (outcode(corner[0]) & outcode(corner[1]) & outcode(corner[2]) & outcode(corner[3])) != 0;
}

bool ScreenQuad::collapsed_edge(int i) const {
  const ScreenPoint& p = corner[i];
  const ScreenPoint& q = corner[(i + 1) % 4];
  if (p == q) return true;
  if (!(p.w > 0) || !(q.w > 0)) return false;
  const double dx = p.x / p.w - q.x / q.w, dy = p.y / p.w - q.y / q.w;
  return dx * dx + dy * dy <= kCollapsedPx * kCollapsedPx;
}

double ScreenQuad::parameter_at(int i, double px, double most) const {
  const ScreenPoint &a = corner[i], &b = corner[(i + 1) % 4];
  // Its dot product with a point's x, y, w is w times the distance from the edge.
  const glm::dvec3 line = glm::cross(glm::dvec3(a.x, a.y, a.w), glm::dvec3(b.x, b.y, b.w));
  const double length = glm::length(glm::dvec2(line.x, line.y));
  double result = 0;
  for (const auto& [near, far] : {std::pair(&a, &corner[(i + 3) % 4]), std::pair(&b, &corner[(i + 2) % 4])}) {
    const double away = std::fabs(glm::dot(line, glm::dvec3(far->x, far->y, far->w))) / length;
    // t away = px ((1 - t) w_near + t w_far)
    const double t = px * near->w / (away - px * (far->w - near->w));
    if (t > result && t <= most) result = t;
  }
  return result;
}

BarycentricWeights::BarycentricWeights(const std::array<ScreenPoint, 3>& corner) {
  const auto point = [&](int i) { return glm::dvec3(corner[i].x, corner[i].y, corner[i].w); };
  const glm::dvec3 a = point(0), b = point(1), c = point(2);
  row_[0] = glm::cross(b, c);
  row_[1] = glm::cross(c, a);
  row_[2] = glm::cross(a, b);
  const double det = glm::dot(a, row_[0]);
  for (glm::dvec3& row : row_) row *= 1 / det;
}

glm::dvec3 BarycentricWeights::at(const ScreenPoint& p) const {
  const glm::dvec3 point(p.x, p.y, p.w);
  return {glm::dot(row_[0], point), glm::dot(row_[1], point), glm::dot(row_[2], point)};
}

bool make_screen_quad(const Corners& position, const View& view, ScreenQuad& quad) {
  quad.half_width = view.viewport.width / 2;
  quad.half_height = view.viewport.height / 2;
  const std::array<double, 16>& m = view.clip_from_object;
  for (int i = 0; i < 4; ++i) {
    const Vec4& p = position[i];
    const auto row = [&](int r) { return m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r] * p.w; };
    // Depth 0 is between the near and the far plane wherever w >= 0, which the other planes together ask for.
    quad.corner[i] = {row(0) * quad.half_width, row(1) * quad.half_height, view.depth_clamped ? 0 : row(2), row(3)};
    if (!finite(quad.corner[i])) return false;
  }
  quad.along_u = quad.corner[1] - quad.corner[0];
  quad.along_v = quad.corner[3] - quad.corner[0];
  quad.twist = (quad.corner[0] - quad.corner[1]) + (quad.corner[2] - quad.corner[3]);
  return finite(quad.along_u) && finite(quad.along_v) && finite(quad.twist);
}

void clip_triangle(const ScreenQuad& quad, const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
                   unsigned planes, VisiblePart& part) {
  part.point[0] = a;
  part.point[1] = b;
  part.point[2] = c;
  part.count = 3;
  for (int plane = 0; plane < 6 && part.count > 0; ++plane) {
    if (!(planes >> plane & 1)) continue;
    const VisiblePart before = part;
    part.count = 0;
    ScreenPoint from = before.point[before.count - 1];
    double from_inside = inside(quad, plane, from);
    for (int i = 0; i < before.count; ++i) {
      const ScreenPoint& to = before.point[i];
      const double to_inside = inside(quad, plane, to);
      // Rounding can make a polygon cross a plane more often than twice: never write past the end.
      if ((from_inside < 0) != (to_inside < 0) && part.count < 9) {
        part.point[part.count++] = from + (from_inside / (from_inside - to_inside)) * (to - from);
      }
      if (!(to_inside < 0) && part.count < 9) part.point[part.count++] = to;
      from = to;
      from_inside = to_inside;
    }
  }
}

bool largest_triangle(std::span<const ScreenPoint> points, std::array<int, 3>& out) {
  const auto at = [&](int i) { return glm::dvec2(points[i].x / points[i].w, points[i].y / points[i].w); };
  const int count = int(points.size());
  double largest = -1;
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      for (int k = j + 1; k < count; ++k) {
        const glm::dvec2 p = at(j) - at(i), q = at(k) - at(i);
        const double area = std::fabs(p.x * q.y - p.y * q.x);
        if (area > largest) largest = area, out = {i, j, k};
      }
    }
  }
  return largest >= 0;
}

}  // namespace truequad::kernel
