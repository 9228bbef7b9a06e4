// Pictures in files and as textures.
#pragma once

#include <GL/gl.h>

#include <string>
#include <vector>

namespace samples {

// RGBA, eight bits each, first row on top.
struct Picture {
  int width, height;
  std::vector<unsigned char> pixels;
};

// Throws std::runtime_error, naming the file.
Picture read_picture(const std::string& file);
void write_png(const Picture& picture, const std::string& file, bool keep_alpha);

// squares x squares alternating squares of size_px pixels each; a darker one marks the corner (0, 0) of the
// texture.
Picture checkerboard(int squares, int size_px);

// A texture with mipmaps, (s, t) = (0, 0) at the picture's upper left corner. OpenGL 1.1 wants sizes that are
// powers of two: the picture is scaled to the next ones, which leaves relative coordinates as they are.
// `wrap` as GL_TEXTURE_WRAP_S.
GLuint make_texture(const Picture& picture, GLint wrap);

// The picture `name` of samples/data.
Picture sample_picture(const std::string& name);

}  // namespace samples
