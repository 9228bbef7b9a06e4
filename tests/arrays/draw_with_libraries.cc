// draw_with_libraries LIBRARY: draws quads by a library that calls OpenGL itself. A program that knows nothing of truequad.
#include <FTGL/ftgl.h>
#include <GL/glu.h>
#include <GL/osmesa.h>

#include <cstdio>
#include <cstring>
#include <vector>

namespace {

void glu() {
  GLUquadric* const quadric = gluNewQuadric();
  gluQuadricTexture(quadric, GL_TRUE);
  gluSphere(quadric, 0.5, 12, 8);
  gluCylinder(quadric, 0.5, 0.2, 0.7, 7, 2);
  gluDisk(quadric, 0.1, 0.9, 9, 2);
  gluDeleteQuadric(quadric);
}

void ftgl() {
  FTTextureFont font("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
  font.FaceSize(24);
  font.Render("quads");
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<unsigned char> pixels(160 * 120 * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (count != 2 || !context || !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, 160, 120)) return 70;
  const unsigned char texels[16] = {};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);
  std::strcmp(arguments[1], "glu") == 0 ? glu() : ftgl();
  glFinish();
  return glGetError() == GL_NO_ERROR ? 0 : 1;
}
