// measure --quads LIST --coarse PNG --fine PNG [--map bilinear|projective]
//
// How far the texels of a sample's picture are from where the exact map has them, in pixels. The sample draws
// three times: with --quads, with --coordinates coarse and with --coordinates fine; the two pictures together
// tell s and t of every pixel to 16 binary digits (modulo 1) and the number of its quad. Prints one line:
//
//     pixels 33467 max_px 0.2312 mean_px 0.0611 unplaced 0 worst 311,97 of quad 1
//
// unplaced: pixels, not in the other figures, with a texel that the exact map has nowhere before the eye.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/picture.h"
#include "truequad_reference/reference.h"

namespace {

namespace reference = truequad::reference;
using reference::Real;

struct Quad {
  truequad::Corners position, texture;
  truequad::View view;
};

std::vector<Quad> read_quads(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  const auto corners = [](const nlohmann::json& json) {
    truequad::Corners result;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto c = json.at(i).get<std::array<double, 4>>();
      result[i] = {c[0], c[1], c[2], c[3]};
    }
    return result;
  };
  const nlohmann::json list = nlohmann::json::parse(in);
  std::vector<Quad> quads;
  for (const nlohmann::json& json : list.at("quads")) {
    Quad quad{corners(json.at("position")), corners(json.at("texture")), {}};
    quad.view.clip_from_object = json.at("clip_from_object");
    const auto viewport = json.at("viewport").get<std::array<double, 4>>();
    quad.view.viewport = {viewport[0], viewport[1], viewport[2], viewport[3]};
    quads.push_back(quad);
  }
  return quads;
}

constexpr int kDigits = 256;
constexpr Real kStep = Real(1) / (kDigits * kDigits);

// The values modulo 1 that two digits may mean. Just at a texel's border rounding may bring the coarse digit
// into the neighbour while the fine one is at the other end of its range.
std::vector<Real> decode(int coarse, int fine) {
  std::vector<Real> values{(coarse * kDigits + fine + Real(0.5)) * kStep};
  if (fine == 0) values.push_back(values[0] + kDigits * kStep);
  if (fine == kDigits - 1) values.push_back(values[0] - kDigits * kStep);
  return values;
}

// A pixel's centre on the very edge of a quad may be drawn a few roundings beyond it.
constexpr Real kBeyond = 8 * kStep;
// The same for the parameters of the bilinear map.
constexpr Real kSlack = 1e-3L;

// value + n for every integer n that brings it into the range of the corners.
std::vector<Real> unwrapped(const std::vector<Real>& values, Real low, Real high) {
  std::vector<Real> result;
  for (const Real value : values) {
    for (Real x = value + std::floor(low - value); x <= high + kBeyond; x += 1) {
      if (x >= low - kBeyond && x <= high + kBeyond) result.push_back(x);
    }
  }
  return result;
}

std::pair<Real, Real> range(const truequad::Corners& corners, double truequad::Vec4::*part) {
  const auto [low, high] = std::minmax_element(
      corners.begin(), corners.end(), [part](const auto& a, const auto& b) { return a.*part < b.*part; });
  return {(*low).*part, (*high).*part};
}

struct Summary {
  long pixels = 0, unplaced = 0;
  Real max_px = 0, sum_px = 0;
  int worst_x = 0, worst_y = 0;
  std::size_t worst_quad = 0;
};

Summary measure(const std::vector<Quad>& quads, const samples::Picture& coarse, const samples::Picture& fine,
                bool projective) {
  if (coarse.width != fine.width || coarse.height != fine.height)
    throw std::runtime_error("the pictures differ in size");
  Summary summary;
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      const std::size_t at = (std::size_t(y) * std::size_t(coarse.width) + std::size_t(x)) * 4;
      const unsigned char *c = &coarse.pixels[at], *f = &fine.pixels[at];
      const std::size_t number = std::size_t(c[2]) + std::size_t(c[3]) * kDigits;
      if (c[2] != f[2] || c[3] != f[3]) throw std::runtime_error("the pictures show different scenes");
      if (number == 0) continue;
      if (number > quads.size()) throw std::runtime_error("a pixel has the number of no quad");
      const Quad& quad = quads[number - 1];
      const reference::Point drawn{x + Real(0.5), coarse.height - y - Real(0.5)};
      const auto [s_low, s_high] = range(quad.texture, &truequad::Vec4::x);
      const auto [t_low, t_high] = range(quad.texture, &truequad::Vec4::y);
      std::optional<reference::ProjectiveMap> map;
      if (projective) map.emplace(quad.position, quad.texture, quad.view);
      Real nearest = std::numeric_limits<Real>::infinity();
      for (const Real s : unwrapped(decode(c[0], f[0]), s_low, s_high)) {
        for (const Real t : unwrapped(decode(c[1], f[1]), t_low, t_high)) {
          nearest = std::min(nearest, map ? map->displacement(drawn, s, t)
                                          : reference::bilinear_displacement(quad.position, quad.texture,
                                                                             quad.view, drawn, s, t, kSlack));
        }
      }
      if (std::isinf(nearest)) {
        ++summary.unplaced;
        continue;
      }
      ++summary.pixels;
      if (nearest >= summary.max_px) {
        summary.max_px = nearest;
        summary.worst_x = x;
        summary.worst_y = y;
        summary.worst_quad = number;
      }
      summary.sum_px += nearest;
    }
  }
  return summary;
}

}  // namespace

int main(int argc, char** argv) {
  std::string quads, coarse, fine;
  bool projective = false;
  CLI::App app("Displacement of texels in pictures of coordinates", "measure");
  app.add_option("--quads", quads, "JSON that the sample wrote")->required();
  app.add_option("--coarse", coarse, "Picture with --coordinates coarse")->required();
  app.add_option("--fine", fine, "Picture with --coordinates fine")->required();
  app.add_option("--map", projective, "The exact map: bilinear (default) or projective")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, bool>{{"bilinear", false}, {"projective", true}}));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "measure: %s\n", error.what());
    return 2;
  }
  try {
    const Summary summary =
        measure(read_quads(quads), samples::read_picture(coarse), samples::read_picture(fine), projective);
    if (summary.pixels == 0) throw std::runtime_error("no quad is to be seen");
    std::printf("pixels %ld max_px %.4Lf mean_px %.4Lf unplaced %ld worst %d,%d of quad %zu\n",
                summary.pixels, summary.max_px, summary.sum_px / Real(summary.pixels), summary.unplaced,
                summary.worst_x, summary.worst_y, summary.worst_quad);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "measure: %s\n", error.what());
    return 1;
  }
}
