#include "measure_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "truequad_reference/reference.h"

namespace truequad::images {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

truequad::Mode mode_of(const std::string& name) {
  if (name == "projective") return truequad::Mode::kProjective;
  if (name == "auto") return truequad::Mode::kAuto;
  if (name == "paper") return truequad::Mode::kPaper;
  if (name == "off") return truequad::Mode::kOff;
  return truequad::Mode::kBilinear;
}

}  // namespace

Promise promise_of(const DrawnQuad& quad, const Settings& settings) {
  static Plan plan;
  Limits limits;
  limits.tolerance_px = settings.tolerance_px;
  truequad::plan(quad.position, {&quad.texture, 1}, quad.view, limits, mode_of(settings.mode), plan);
  Promise promise;
  promise.corrected = plan.action != Action::kPass;
  promise.capped = plan.capped;
  // A program's own right q's make a homography, which the bilinear map of (s/q, t/q) is not.
  const auto& t = quad.texture;
  const bool own_q = std::any_of(t.begin(), t.end(), [&](const Vec4& corner) { return corner.w != t[0].w; });
  promise.projective = plan.action == Action::kProject || (own_q && plan.reason == PassReason::kAffine);
  const bool exact = plan.reason == PassReason::kAffine || plan.reason == PassReason::kWithinTolerance;
  promise.measurable = (promise.corrected || exact) && std::isfinite(plan.bound_px);
  promise.bound_px = promise.measurable ? plan.bound_px : kInfinity;
  return promise;
}

double displacement_px(const DrawnQuad& quad, bool projective, double x, double y, const Texel& texel,
                       double enough_px) {
  const reference::Point centre{x, y};
  std::optional<reference::ProjectiveMap> map;
  if (projective) map.emplace(quad.position, quad.texture, quad.view);
  constexpr double kHalf = kCoordinateStep / 2;
  const auto distance = [&](double s, double t) {
    // Snapped edges let pixels lie outside of the quad by less than the rasteriser's grid, which may be much of
    // the quad where it is narrow: what they show has its place on the map continued.
    constexpr double kBeyond = 1;
    return double(map ? map->displacement(centre, s, t)
                      : reference::bilinear_displacement(quad.position, quad.texture, quad.view, centre, s, t,
                                                         kBeyond));
  };
  // Of the texels that the pixel may show: the one that it does show, then the one nearest to what it ought
  // to show, then those around.
  double nearest = distance(texel.s, texel.t);
  if (nearest > enough_px) {
    std::optional<reference::Point> exact;
    if (map) {
      exact = map->texel_at(centre);
    } else if (const auto seen = reference::bilinear_at(quad.position, quad.texture, quad.view, centre)) {
      exact = {seen->s, seen->t};
    }
    if (exact) {
      nearest = std::min(nearest, distance(std::clamp(double(exact->x), texel.s - kHalf, texel.s + kHalf),
                                           std::clamp(double(exact->y), texel.t - kHalf, texel.t + kHalf)));
    }
  }
  for (int place = 0; place < 9 && nearest > enough_px; ++place) {
    const double s = texel.s + (place / 3 - 1) * kHalf, t = texel.t + (place % 3 - 1) * kHalf;
    nearest = std::min(nearest, distance(s, t));
  }
  return nearest;
}

Measurement measure(const Job& job, const Pictures& pictures, const Settings& settings) {
  Measurement result;
  const double snap_px = std::ldexp(1.0, -pictures.header.subpixel_bits);
  for (int trial = 0; trial < job.seeds; ++trial) {
    const unsigned seed = job.first + unsigned(trial);
    const Scene scene = family(job.family).make(seed, job.width, job.height);
    const auto quads = quads_of(scene, snap_px);
    std::vector<Promise> promises;
    for (const DrawnQuad& quad : quads) {
      promises.push_back(promise_of(quad, settings));
      ++result.quads;
      result.corrected += promises.back().corrected;
      result.capped += promises.back().capped;
      result.unmeasured += !promises.back().measurable;
    }
    for (int y = 0; y < job.height; ++y) {
      for (int x = 0; x < job.width; ++x) {
        const auto texel = texel_at(pictures, trial, x, y);
        if (!texel) continue;
        const auto seen = std::find_if(quads.begin(), quads.end(),
                                       [&](const DrawnQuad& q) { return q.mark == texel->mark; });
        if (seen == quads.end()) {
          ADD_FAILURE() << job.family << " seed " << seed << ": pixel " << x << "," << y << " has mark "
                        << texel->mark;
          return result;
        }
        const Promise& promise = promises[std::size_t(seen - quads.begin())];
        if (!promise.measurable) continue;
        ++result.pixels;
        const double limit_px = promise.capped ? promise.bound_px : settings.tolerance_px;
        // What is neither a stray nor the largest need not be known better.
        const double enough_px = std::min({limit_px, result.largest_px, result.worst_ratio * limit_px});
        const double found_px = displacement_px(*seen, promise.projective, x + 0.5, y + 0.5, *texel, enough_px);
        const double ratio = found_px / limit_px;
        result.largest_px = std::max(result.largest_px, found_px);
        result.strays += ratio > 1;
        if (ratio > result.worst_ratio) {
          result.worst_ratio = ratio;
          result.worst_seed = seed;
        }
      }
    }
  }
  return result;
}

}  // namespace truequad::images
