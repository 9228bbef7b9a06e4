// What all the programs here draw, through functions that each finds in its own way: one textured quad that two
// triangles get wrong. They are ordinary programs and know nothing of truequad.
#pragma once

#include <GL/gl.h>

#include <cstdio>
#include <vector>

namespace loaders {

inline constexpr int kSize = 64;

#define LOADERS_FUNCTIONS(F)                                                                                       \
  F(Begin) F(Clear) F(ClearColor) F(Enable) F(End) F(Finish) F(GetError) F(PixelStorei) F(ReadPixels) F(TexCoord2f) \
  F(TexImage2D) F(TexParameteri) F(Vertex2f) F(Viewport)

struct Functions {
#define LOADERS_MEMBER(name) decltype(&::gl##name) name;
  LOADERS_FUNCTIONS(LOADERS_MEMBER)
#undef LOADERS_MEMBER
};

// By what finds a function's address, given its name.
template <typename Find>
Functions find_functions(const Find& find) {
  return Functions{
#define LOADERS_FIND(name) reinterpret_cast<decltype(&::gl##name)>(find("gl" #name)),
      LOADERS_FUNCTIONS(LOADERS_FIND)
#undef LOADERS_FIND
  };
}

// Draws, prints a line that tells pictures apart, and returns the program's exit status.
inline int show(const Functions& gl) {
  const void* const* const all = reinterpret_cast<const void* const*>(&gl);
  for (std::size_t i = 0; i < sizeof gl / sizeof *all; ++i) {
    if (!all[i]) return std::fprintf(stderr, "function %zu is missing\n", i), 3;
  }
  unsigned char texels[8][8][3];
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool dark = (x + y) % 2;
      texels[y][x][0] = dark ? 30 : 255, texels[y][x][1] = 32 * x, texels[y][x][2] = 32 * y;
    }
  }
  gl.Viewport(0, 0, kSize, kSize);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(0, 0), gl.Vertex2f(-0.9f, -0.9f);
  gl.TexCoord2f(1, 0), gl.Vertex2f(0.9f, -0.9f);
  gl.TexCoord2f(1, 1), gl.Vertex2f(0.3f, 0.9f);
  gl.TexCoord2f(0, 1), gl.Vertex2f(-0.3f, 0.9f);
  gl.End();
  gl.Finish();
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  std::vector<unsigned char> pixels(kSize * kSize * 3);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  // FNV-1a.
  unsigned long long hash = 14695981039346656037ull;
  int drawn = 0;
  for (const unsigned char value : pixels) hash = (hash ^ value) * 1099511628211ull, drawn += value != 0;
  std::printf("picture %016llx, %s, error %x\n", hash, drawn > kSize * kSize / 4 ? "drawn" : "empty", gl.GetError());
  std::fflush(stdout);
  return 0;
}

}  // namespace loaders
