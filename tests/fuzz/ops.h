// A sequence: steps that can be dropped one by one, each of which makes its calls from its own numbers alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace truequad::fuzz {

// Name, and how often a step of that kind stands by itself in a sequence (per mille or so).
#define TQ_STEPS(X)                                                                                            \
  X(Begin, 2) X(End, 4) X(Vertex, 4) X(TexCoord, 4) X(Attribute, 30) X(Material, 12)                           \
  X(NewList, 4) X(EndList, 4) X(CallList, 60) X(CallLists, 40) X(DeleteLists, 8) X(GenLists, 6) X(ListBase, 8) \
  X(Errors, 40) X(Get, 20) X(Digest, 4) X(Matrix, 40) X(Enable, 40) X(TexGen, 12) X(Texture, 20)               \
  X(Lighting, 16) X(Raster, 50) X(PushAttrib, 16) X(PopAttrib, 20) X(RenderMode, 8) X(Names, 4)                \
  X(Evaluator, 10) X(Rect, 16) X(Clear, 8) X(Pixels, 6) X(Context, 3) X(Query, 6) X(Program, 3)                \
  X(Pointer, 30) X(ClientState, 20) X(DrawArrays, 30) X(DrawElements, 30) X(ArrayElement, 8)                   \
  X(Interleaved, 6) X(Buffer, 24) X(MapBuffer, 8) X(VertexArray, 5) X(Restart, 4) X(LockArrays, 3)                      \
  X(DrawIndirect, 10) X(FarIndices, 6) X(Nowhere, 6) X(Nest, 4)                      \
  X(Cover, 0)

enum class Step : std::uint8_t {
#define X(name, weight) k##name,
  TQ_STEPS(X)
#undef X
  kCount
};

// Steps that make a comparison sound are the first ones of a sequence, and stay when it is shrunk.
inline constexpr bool stays(Step step) { return step == Step::kCover; }

// What of a shape is not affine.
enum Warp : std::uint8_t { kFlat = 0, kWarpPosition = 1, kWarpTexture = 2, kWarpDepth = 4 };

// Other bits of Op::warp.
inline constexpr unsigned kStrip = 8, kVarious = 16;  // the shape is a strip; any entry point may be used
inline constexpr unsigned kOneSlot = 32;  // but always for the same piece of state: texture unit 0, the colour
// How many numbers calls of a sequence give: two, three or four.
inline constexpr unsigned kSize = 64;
// Positions are just the shape's: no call that gives others of the same numbers, and none that is not finite.
inline constexpr unsigned kExact = 256;

struct Op {
  Step step;
  std::uint16_t warp;      // Warp and other bits
  std::int32_t index;      // corner of the shape, mode, name …
  std::uint32_t shape;
  std::uint64_t seed;
};
using Sequence = std::vector<Op>;

// The kinds of sequences, which take turns.
enum class Kind : std::uint8_t {
  kAffine,   // every shape is affine: nothing may change
  kWarped,   // meant for a tolerance that passes every quad: cuts and splits happen, and still nothing may change
  kBent,     // quads are corrected: errors and state may not change
  kCovered,  // quads are corrected, and nothing is used that hides or lights them: the same pixels are covered
  kCount
};
// Trials of a block have one kind; they share a process.
inline constexpr unsigned kBlock = 64;
inline Kind kind_of(std::uint64_t trial) { return Kind(trial / kBlock % unsigned(Kind::kCount)); }

Sequence generate(std::uint64_t trial, Kind kind);

// Files of sequences.
void write(const std::vector<Sequence>& sequences, const std::string& path);
bool read(const std::string& path, std::vector<Sequence>& sequences);

}  // namespace truequad::fuzz
