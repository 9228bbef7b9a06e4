// How far from its exact place a mesh triangle draws a texel: derived, with proofs, in docs/design.md "Error
// of a triangle".
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "colour.h"
#include "rasteriser.h"
#include "screen.h"
#include "truequad/kernel.h"

namespace truequad::kernel {

// A bilinear function of the parameters: constant + along_u u + along_v v + twist uv.
struct Bilinear {
  double constant, along_u, along_v, twist;

  double at(double u, double v) const { return constant + along_u * u + along_v * v + twist * (u * v); }
};

// What two texture coordinates of one set add to the error.
struct TextureMap {
  // Jacobian determinant of the map (u, v) -> texture: constant + of_u u + of_v v.
  double constant, of_u, of_v;
  // Clip-space displacement per unit of the interpolation error and of 1 / determinant.
  double x, y, w;
  // The coordinates. False: t is an auxiliary function that nobody draws.
  Bilinear s, t;
  bool t_drawn = true;

  double jacobian(double u, double v) const { return constant + of_u * u + of_v * v; }
};

// Each set gives one map, three if all of s, t, r vary.
inline constexpr std::size_t kMaxMaps = 3 * kMaxTextureSets;

struct ErrorModel {
  ScreenQuad screen;
  Rasteriser rasteriser;
  std::array<TextureMap, kMaxMaps> map;
  std::size_t map_count = 0;
  ColourModel colours;
  // The determinant of some map changes sign or vanishes in the unit square: there it has no inverse.
  bool folded = false;

  std::span<const TextureMap> maps() const { return {map.data(), map_count}; }
  // What is bounded apart: each map, and the colours, for which there is none.
  std::size_t parts() const { return map_count + (colours.count > 0); }
  const TextureMap* part(std::size_t i) const { return i < map_count ? &map[i] : nullptr; }
};

// Adds the maps of the sets that are warped. Requires model.screen, and that classify() says kWarped of all
// sets together. Returns false if a set's q varies over the corners: then (s, t, r) alone do not tell what is
// drawn.
bool add_texture_maps(const Corners& position, std::span<const Corners> textures, ErrorModel& model);

// Largest distance in pixels of a texel that triangle a b c draws inside the clip volume from its exact
// place, what the rasteriser adds included but for the allowance of snapping itself; 0 if nothing of it is inside. Colours count
// by ColourModel::px_per_step. If the
// plain bound exceeds `limit_px`, up to `depth` halvings of the triangle look for a tighter one that does not; if there
// is none the result is beyond the limit, but is not itself a bound. With kTightest as limit it is the tightest bound that
// `depth` halvings give, infinite if none is known.
inline constexpr double kTightest = -1;
double triangle_bound(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c,
                      double limit_px, int depth);

// The larger of `bound_px` and the tightest bound that `depth` halvings give for a triangle.
double raised_bound(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c,
                    double bound_px, int depth);

// About how far a triangle's texels are displaced, in pixels: by the map, and in addition by the rasteriser.
struct Estimate {
  double map_px = 0, rasteriser_px = 0;
  double px() const { return map_px + rasteriser_px; }
};
Estimate triangle_estimate(const ErrorModel& model, const MeshPoint& a, const MeshPoint& b, const MeshPoint& c);

// The same for the two halves of the quad, along either diagonal, drawn with texture coordinates that `lambda`
// multiplies to an exact map: what the rasteriser alone adds.
double projected_px(const ErrorModel& model, const Corners& texture, const std::array<double, 4>& lambda,
                    double limit_px);

// The same as triangle_bound() for the centre fan over a cell; corners in the order (u0,v0) (u1,v0) (u1,v1) (u0,v1), or
// moved from there.
double cell_bound(const ErrorModel& model, const std::array<MeshPoint, 4>& corner, const MeshPoint& centre,
                  double limit_px);

}  // namespace truequad::kernel
