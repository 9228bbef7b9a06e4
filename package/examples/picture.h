/* What the examples draw: a textured quadrilateral that shows its diagonal if it is drawn as two triangles. Off the screen. */
#ifndef PICTURE_H
#define PICTURE_H

#include <GL/gl.h>
#include <GL/osmesa.h>

#define PICTURE_SIZE 128

static unsigned char picture[PICTURE_SIZE * PICTURE_SIZE * 4];

/* Returns 0 if there is no OpenGL. */
static int open_picture(void) {
  unsigned char texels[16 * 16];
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 16, 0, 0, NULL);
  int i;
  if (!context || !OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, PICTURE_SIZE, PICTURE_SIZE)) return 0;
  for (i = 0; i < 16 * 16; ++i) texels[i] = (unsigned char)((i % 16 + i / 16) % 2 * 255);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 16, 16, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  return 1;
}

/* Returns the sum of the picture's bytes, by which two pictures are told apart. */
static unsigned long draw_picture(void) {
  unsigned long sum = 0;
  int i;
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
  glTexCoord2f(1, 0), glVertex2f(0.9f, -0.9f);
  glTexCoord2f(1, 1), glVertex2f(0.3f, 0.9f);
  glTexCoord2f(0, 1), glVertex2f(-0.3f, 0.9f);
  glEnd();
  glFinish();
  for (i = 0; i < PICTURE_SIZE * PICTURE_SIZE * 4; ++i) sum = (sum * 31 + picture[i]) & 0xffffffffUL;
  return sum;
}

#endif
