// One pass over a shape's vertices. Every fragment that survives adds kTouch to one channel, so that the
// picture tells how often each pixel was touched.
#pragma once

#include "shapes.h"

namespace truequad::semantics {

inline constexpr int kTouch = 8;

// All textures are white: coordinates decide what truequad does, never what is seen.
enum class Coordinates {
  kNone,     // no call, and texturing off
  kUnused,   // those of kWarped, and texturing off
  kAffine,   // linear in the position
  kWarped,   // a unit square for each quad
  kOther,    // warped otherwise, on parallelograms too
  kTwisted,  // the like, by far more
};

// How the vertices reach OpenGL.
enum class Way { kOneBegin, kBeginForEach, kDoubles, kArrays, kList };

struct Pass {
  Coordinates coordinates = Coordinates::kNone;
  Coordinates second = Coordinates::kNone;  // of the second texture unit
  GLenum depth = GL_LESS;
  int channel = 0;  // 0 red, 1 green, 2 blue; kUnseen: the colour mask is off
  Way way = Way::kOneBegin;
  bool kinked = false;  // an alpha for each vertex, which no map of the position makes
};
inline constexpr int kUnseen = -1;

// Textures, blending, depth test: once for a context.
void prepare_passes();
// Clears everything and sets the shape's matrices.
void begin_frame(const Shape& shape);
void draw(const Shape& shape, const Pass& pass);
// The shape's primitives alone, in the current state.
void send(const Shape& shape, const Pass& pass);

}  // namespace truequad::semantics
