// The geometry kernel of truequad: what to draw in place of one textured quadrilateral so that its picture is
// right to a stated fraction of a pixel. Plain structs and standard types; no GL, no heap, no globals; every
// function is pure and may be called from any thread.
//
// A quad has corners A B C D (indices 0 to 3) in drawing order; u runs from A to B, v from A to D. Position and
// every attribute are bilinear in (u, v):
//     X(u,v) = (1-u)(1-v) A + u(1-v) B + uv C + (1-u)v D
// which is the limit of the midpoint subdivision of Oliveira, "Correcting Texture Mapping Errors Introduced by
// Graphics Hardware" (SIBGRAPI 2001), and linear along the four edges. Derivations: docs/design.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace truequad {

// Homogeneous vector: a position (x, y, z, w) or texture coordinates (s, t, r, q).
struct Vec4 {
  double x = 0, y = 0, z = 0, w = 1;
};

// One Vec4 for each corner A B C D.
using Corners = std::array<Vec4, 4>;

// Texture coordinate sets (texture units) that one quad may have.
inline constexpr std::size_t kMaxTextureSets = 8;
// One colour component (or a fog coordinate) at the corners A B C D, in steps: 255 from black to full intensity.
using ColourChannel = std::array<double, 4>;
// Channels that one quad may have: primary and secondary colours of both sides, a fog coordinate.
inline constexpr std::size_t kMaxColourChannels = 16;

// Grid lines that a plan can hold along one direction, both ends included.
inline constexpr std::size_t kMaxLines = 1024;
// The largest value that Limits::max_triangles may have.
inline constexpr int kMaxTriangles = 16384;

// What the shape of a quad alone (no matrix) says about the two triangles that a driver makes of it.
enum class Shape : std::uint8_t {
  kAffine,      // position -> texture is one linear map over the four corners: any triangulation is exact
  kConstant,    // no texture coordinate varies: nothing can be seen of the map
  kDegenerate,  // the four corners lie on one line or point, in every view without area
  kNotFinite,   // a coordinate is NaN or infinite
  kWarped,      // everything else: the two triangles show another picture than the bilinear map
};

// Classifies a quad in homogeneous object space (docs/design.md "Nothing to do").
// position: four corners (x, y, z, w). textures: zero or more sets of four (s, t, r, q).
// Residuals are compared with the rounding of single-precision input (a few units of 2^-24 of the magnitudes that
// enter), never with an absolute number. Cost: about 0.1 us for one set.
Shape classify(const Corners& position, std::span<const Corners> textures);

enum class Mode : std::uint8_t { kBilinear, kProjective, kAuto, kPaper, kOff };

// Viewport rectangle in pixels, as glViewport takes it.
struct Viewport {
  double x = 0, y = 0, width = 0, height = 0;
};

// How a quad is seen: clip = clip_from_object * position, column-major as OpenGL keeps it.
struct View {
  std::array<double, 16> clip_from_object{};
  Viewport viewport;
  // Width in pixels of the grid to which the rasteriser snaps vertices (2^-GL_SUBPIXEL_BITS); 0 = exact.
  double snap_px = 0;
  // Of a rasteriser that takes vertices and sets up interpolation in floating point, from the vertices as they were before
  // snapping: the largest relative rounding of one operation (2^-24 for single precision). 0 = exact, from snapped vertices.
  // Where this is not 0, fragments are taken to be at the centres of pixels, unless `multisampled`.
  double setup_rounding = 0;
  // The near and the far plane cut nothing away: all that is before the eye and inside the viewport counts (GL_DEPTH_CLAMP).
  bool depth_clamped = false;
  // Fragments may have the values of a place outside of their triangle. Plans are the same, and all that correct something `capped`.
  bool multisampled = false;
};

// Thresholds of the published algorithm (Oliveira 2001): dot-product tests in object and texture space, and the
// projected area of a whole quad, in square pixels, below which subdivision stops.
struct PaperThresholds {
  double object = 1e-3;
  double texture = 1e-4;
  double area_px = 200;
};

struct Limits {
  double tolerance_px = 0.25;  // largest displacement of a texel, pixels of the viewport, 1e-3 .. 1e6
  double colour_steps = 0.5;   // largest error of a colour channel, steps of 1/255, 1e-3 .. 255
  int max_triangles = 4096;    // cap for one quad, 4 .. kMaxTriangles
  PaperThresholds paper;
};

enum class Action : std::uint8_t {
  kPass,     // draw the quad as the program gave it
  kProject,  // draw the quad with texture coordinates multiplied by Plan::lambda
  kMesh,     // draw tessellate(plan)
};

enum class PassReason : std::uint8_t {
  kNone,             // not passed
  kAffine,           // Shape::kAffine
  kConstant,         // Shape::kConstant
  kDegenerate,       // Shape::kDegenerate
  kNotFinite,        // a coordinate, a matrix element or the viewport is NaN or infinite
  kWithinTolerance,  // two triangles already keep the tolerance
  kInvisible,        // no part of the quad can be inside the clip volume, or the viewport is empty
  kModeOff,
  kOwnQ,            // a set's q varies over the corners and the mode corrects none of it
};

// Grid lines along one parameter, increasing, from lines[0] to lines[count - 1].
struct GridLines {
  std::array<double, kMaxLines> at;
  std::size_t count = 0;
};

// A rectangle [u0,u1] x [v0,v1] of the parameter square: one leaf of the published subdivision.
struct Leaf {
  float u0, v0, u1, v1;
};

struct Plan {
  Action action = Action::kPass;
  PassReason reason = PassReason::kNone;
  // What is promised: no texel lies farther than this from its exact place, in pixels, over the visible part, when
  // a rasteriser draws it as View describes.
  // Infinite where nothing can be promised (then `capped` is set).
  double bound_px = 0;
  // The same for colours: no channel that was given differs by more steps from its exact value at the same place of the
  // screen, before it is rounded to what the buffer holds. 0 where none has a kink that the action could mend.
  double bound_steps = 0;
  // bound_px or bound_steps > tolerance: the cap was hit, the texture map cannot be inverted, or triangles that are too thin for the
  // rasteriser's arithmetic cannot be avoided. Or the view is multisampled, which the bounds do not contain.
  bool capped = false;
  int triangles = 2;    // that the action draws
  // kProject: factors of A B C D for every texture set; texture coordinates become (l s, l t, l r, l q).
  std::array<std::array<double, 4>, kMaxTextureSets> lambda{};
  // kMesh: a block of centre fans with these outer and inner lines (see tessellate).
  GridLines u, v;
  // kMesh: edges AB, BC, CD, DA that have no length on the screen and therefore may carry vertices.
  std::array<bool, 4> collapsed_edge{};
  // kMesh of Mode::kPaper: leaves, two triangles each; T-junctions as published.
  std::array<Leaf, kMaxTriangles / 2> leaves;
  std::size_t leaf_count = 0;
};

// Decides what to draw. textures: the sets that matter (enabled and varying), at most kMaxTextureSets; further ones
// are ignored. colours: what is interpolated besides, in at most kMaxColourChannels channels; none: only textures are
// corrected. Mode::kPaper knows no colours, and projective texture coordinates do not mend them.
// `out` is large (about 150 KiB): keep one per thread.
// Never fails: any input, NaN and singular matrices included, has a defined plan.
void plan(const Corners& position, std::span<const Corners> textures, const View& view, const Limits& limits,
          Mode mode, Plan& out, std::span<const ColourChannel> colours = {});

// What the mesh of a plan with Action::kMesh, made for this position and view but other texture coordinates, promises for
// these: sets bound_px, bound_steps and capped. For later passes over the same vertices, whose depths agree only if the triangles do.
void bound_mesh(const Corners& position, std::span<const Corners> textures, const View& view, const Limits& limits,
                Plan& mesh, std::span<const ColourChannel> colours = {});

// A vertex of a mesh: its place in the parameter square.
struct Param {
  double u, v;
};

// Indices of a triangle's vertices, in the winding of A B C D.
struct Triangle {
  std::uint16_t a, b, c;
};

struct MeshSize {
  std::size_t vertices, triangles;
};

// Sizes of the mesh of a plan with Action::kMesh.
MeshSize mesh_size(const Plan& plan);

// Writes the mesh of a plan with Action::kMesh. `vertices` and `triangles` must have at least mesh_size(plan)
// elements; vertices 0 to 3 are A B C D themselves. Centre fans inside, outer edges never split (unless
// Plan::collapsed_edge allows it): no neighbour need be known, and the covered pixels stay the two triangles'.
void tessellate(const Plan& plan, std::span<Param> vertices, std::span<Triangle> triangles);

// The value at (u, v) of an attribute given at the corners. Bit-exact at the corners; exactly constant along an
// edge whose ends are equal.
template <typename T>
constexpr T interpolate(T a, T b, T c, T d, T u, T v) {
  constexpr auto lerp = [](T p, T q, T t) { return t == T(1) ? q : p + (q - p) * t; };
  return lerp(lerp(a, b, u), lerp(d, c, u), v);
}

}  // namespace truequad
