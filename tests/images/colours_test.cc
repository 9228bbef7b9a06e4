// Pictures of smooth colours by a real driver with TRUEQUAD_COLOR=1, pixel by pixel against the bilinear colour of the quads
// at the pixel's centre: within the promise, and half a step more for the bytes of the picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "corner_colours.h"
#include "pictures.h"
#include "scenes.h"
#include "truequad_reference/reference.h"

namespace truequad::images {
namespace {

using reference::Real;

struct ColouredQuad {
  DrawnQuad quad;
  std::array<std::array<float, 4>, 4> colour;  // of the corners
};

std::vector<ColouredQuad> coloured_quads(const Scene& scene, unsigned seed, double snap_px) {
  std::vector<ColouredQuad> result;
  for (const DrawnQuad& quad : quads_of(scene, snap_px)) result.push_back({quad, {}});
  std::size_t next = 0;
  for (unsigned p = 0; p < scene.primitives.size(); ++p) {
    const bool strip = scene.primitives[p].mode == Mode::kQuadStrip;
    const auto order = strip ? std::array{0u, 1u, 3u, 2u} : std::array{0u, 1u, 2u, 3u};
    for (unsigned first = 0; first + 4 <= scene.primitives[p].vertices.size(); first += strip ? 2 : 4, ++next) {
      for (unsigned i = 0; i < 4; ++i) result[next].colour[i] = vertex_colour(seed, p, first + order[i]);
    }
  }
  return result;
}

unsigned components(ColourKind kind) { return kind == kPrimary ? 4 : kind == kFog ? 1 : 3; }

std::vector<ColourChannel> channels(const ColouredQuad& quad, ColourKind kind) {
  std::vector<ColourChannel> result;
  for (unsigned k = 0; k < components(kind); ++k) {
    ColourChannel channel;
    for (std::size_t i = 0; i < 4; ++i) channel[i] = 255 * quad.colour[i][k];
    result.push_back(channel);
  }
  return result;
}

struct Measured {
  long pixels = 0, beyond = 0, capped = 0, quads = 0, corrected = 0;
  double largest = 0;       // steps
  double largest_kept = 0;  // of scenes without a capped quad
};

// The pixel's largest difference in steps from the nearest of the colours that the quads have there.
double difference(const std::vector<ColouredQuad>& quads, ColourKind kind, const unsigned char* pixel, double x, double y) {
  double nearest = INFINITY;
  for (const ColouredQuad& q : quads) {
    const View& view = q.quad.view;
    const auto clip = reference::clip_corners(q.quad.position, view);
    const Real px = (x - view.viewport.x) / (view.viewport.width / 2) - 1,
               py = (y - view.viewport.y) / (view.viewport.height / 2) - 1;
    std::array<Real, 4> f, g;
    for (std::size_t i = 0; i < 4; ++i) f[i] = clip[i][0] - px * clip[i][3], g[i] = clip[i][1] - py * clip[i][3];
    for (const auto& [u, v] : reference::solve_bilinear(f, g)) {
      // Snapped edges let pixels lie outside of the quad by less than the rasteriser's grid.
      constexpr Real kBeyond = 0.2L;
      if (u < -kBeyond || u > 1 + kBeyond || v < -kBeyond || v > 1 + kBeyond) continue;
      double worst = 0;
      for (unsigned k = 0; k < components(kind); ++k) {
        const auto at = [&](int i) { return Real(255 * q.colour[std::size_t(i)][k]); };
        const Real exact = (1 - u) * (1 - v) * at(0) + u * (1 - v) * at(1) + u * v * at(2) + (1 - u) * v * at(3);
        worst = std::max(worst, double(std::fabs(std::clamp(exact, Real(0), Real(255)) - pixel[k])));
      }
      nearest = std::min(nearest, worst);
    }
  }
  return nearest;
}

// Colours that are the second pass of two, with the same promise (draw_colours.cc).
constexpr std::string_view kSecondPasses = "passes:";
bool is_second_pass(const Job& job) { return job.family.starts_with(kSecondPasses); }
std::string_view scenes_of(const Job& job) {
  return std::string_view(job.family).substr(is_second_pass(job) ? kSecondPasses.size() : 0);
}

Measured measure_colours(const Job& job, const Pictures& pictures) {
  static Plan plan;
  Measured measured;
  const double snap_px = std::ldexp(1.0, -pictures.header.subpixel_bits);
  for (int trial = 0; trial < job.seeds; ++trial) {
    const unsigned seed = job.first + unsigned(trial);
    for (int k = 0; k < kColourKinds; ++k) {
      const ColourKind kind = ColourKind(k);
      const unsigned of = scene_seed(seed, kind, is_second_pass(job));
      const std::vector<ColouredQuad> quads =
          coloured_quads(family(scenes_of(job)).make(of, job.width, job.height), seed, snap_px);
      double promised = 0;
      bool capped = false;
      for (const ColouredQuad& q : quads) {
        const std::span<const Corners> textures(&q.quad.texture, kind >= kFog);
        truequad::plan(q.quad.position, textures, q.quad.view, Limits(), truequad::Mode::kBilinear, plan, channels(q, kind));
        ++measured.quads;
        measured.corrected += plan.action == Action::kMesh;
        measured.capped += plan.capped;
        capped |= plan.capped;
        promised = std::max(promised, plan.bound_steps);
      }
      for (int y = 0; y < job.height; ++y) {
        for (int x = 0; x < job.width; ++x) {
          const unsigned char* pixel = pictures.pixel(trial, kind, x, y);
          if (pixel[3] == 0) continue;
          ++measured.pixels;
          const double steps = difference(quads, kind, pixel, x + 0.5, y + 0.5);
          measured.largest = std::max(measured.largest, steps);
          if (!capped) measured.largest_kept = std::max(measured.largest_kept, steps);
          // Half a step of the picture's bytes, and what a driver's conversion to them adds.
          measured.beyond += !(steps <= promised + 0.5 + 0.01);
        }
      }
    }
  }
  return measured;
}

void expect_promises_kept(const Job& job, bool capping) {
  SCOPED_TRACE(job.interface + " " + job.family);
  Settings settings;
  settings.color = true;
  const Pictures pictures = draw(job, settings);
  if (pictures.bytes.empty()) return;
  const Measured measured = measure_colours(job, pictures);
  // Of two passes in two frames the first time finds that the second pass wants meshes, the second time draws both so.
  const bool passes = is_second_pass(job);
  EXPECT_EQ(pictures.statistics.quads, measured.quads * (passes ? 4 : 1));
  EXPECT_EQ(pictures.statistics.corrected, measured.corrected * (passes ? 2 : 1));
  EXPECT_EQ(pictures.statistics.capped, measured.capped);
  EXPECT_EQ(measured.beyond, 0);
  EXPECT_GT(measured.pixels, 1000);
  if (!capping) {
    EXPECT_LE(measured.capped, measured.quads / 3);
  }
  const double native = measure_colours(job, draw(job, std::nullopt)).largest;
  EXPECT_GT(native, 10) << "nothing to correct";
  std::printf("%-8s %-12s %4ld quads, %4ld corrected, %3ld capped, %7ld pixels: largest difference %.3f steps (%.3f where "
              "capped), two triangles %.1f\n",
              job.interface.c_str(), job.family.c_str(), measured.quads, measured.corrected, measured.capped,
              measured.pixels, measured.largest_kept, measured.largest, native);
}

class Colours : public testing::TestWithParam<const char*> {};

TEST_P(Colours, AreBilinear) {
  for (const char* name : {"trapezoid", "perspective", "near_plane", "strip", "polygon", "convex", "affine", "homogeneous"}) {
    expect_promises_kept({GetParam(), name, 100, 6, 96, 80, true}, false);
  }
  // Slivers, and pictures that fold.
  for (const char* name : {"collapsed", "non_planar"}) expect_promises_kept({GetParam(), name, 100, 6, 96, 80, true}, true);
}

TEST_P(Colours, OfASecondPassAreBilinear) {
  for (const char* name : {"passes:trapezoid", "passes:near_plane", "passes:strip", "passes:convex"}) {
    expect_promises_kept({GetParam(), name, 300, 4, 96, 80, true}, false);
  }
}

TEST_P(Colours, AreTheDriversOwnWithoutTheOption) {
  const Job job{GetParam(), "affine", 200, 20, 96, 80, true};
  const Pictures native = draw(job, std::nullopt), passed = draw(job, Settings());
  ASSERT_FALSE(HasFailure());
  EXPECT_TRUE(native.bytes == passed.bytes);
  EXPECT_EQ(passed.statistics.corrected, 0);
}

INSTANTIATE_TEST_SUITE_P(Driver, Colours, testing::Values("osmesa", "egl", "glx"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace truequad::images
