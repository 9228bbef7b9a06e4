// Textures as OpenGL 1.1 programs had them: sides that are powers of two, mipmaps made by the program.
#pragma once

#include <GL/gl.h>

#include "common/image.h"
#include "common/sample.h"

namespace samples {

// Squares in two colours, `squares` along each side, the corner s = t = 0 marked in red.
Image checkerboard(int squares);

// A wall of stretcher-bond bricks, seamless in both directions.
Image bricks();

// A texture object of the image (or of what options.texture says in its place), repeated, with mipmaps.
GLuint make_texture(const Image& image, const Options& options);

}  // namespace samples
