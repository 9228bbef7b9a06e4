#include <GL/osmesa.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "canvas.h"

namespace truequad::images {

void open_canvas(int width, int height) {
  static std::vector<unsigned char> pixels;
  pixels.resize(std::size_t(width) * std::size_t(height) * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
  if (!context || !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height)) {
    std::fprintf(stderr, "no OSMesa context\n");
    std::exit(70);
  }
}

}  // namespace truequad::images
