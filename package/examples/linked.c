/* A program that is linked with truequad and sets how its quadrilaterals are drawn. C89. */
#include <stdio.h>

#include <truequad/control.h>

#include "picture.h"

int main(void) {
  truequad_statistics counts;
  unsigned long as_the_driver, corrected, switched_off;

  if (truequad_control_version() < TRUEQUAD_CONTROL_VERSION) {
    fprintf(stderr, "this libtruequad.so is too old\n");
    return 1;
  }
  if (!open_picture()) {
    fprintf(stderr, "no OpenGL\n");
    return 1;
  }

  truequad_set_mode(TRUEQUAD_MODE_OFF);
  as_the_driver = draw_picture();

  truequad_set_mode(TRUEQUAD_MODE_BILINEAR);
  if (!truequad_set_tolerance(0.1)) return 1;
  corrected = draw_picture();

  /* What is not allowed is refused, and nothing changes. */
  if (truequad_set_tolerance(-1) || truequad_get_tolerance() != 0.1) return 1;

  truequad_set_primitive(TRUEQUAD_QUADS, 0);
  switched_off = draw_picture();

  truequad_read_statistics(&counts, sizeof counts);
  printf("%lu quads, %lu corrected by %lu triangles, at most %.3f px out of place\n", (unsigned long)counts.quads,
         (unsigned long)counts.corrected, (unsigned long)counts.triangles, counts.bound_px_max);
  printf("driver %08lx, corrected %08lx, quads off %08lx\n", as_the_driver, corrected, switched_off);
  return counts.corrected == 1 && corrected != as_the_driver && switched_off == as_the_driver ? 0 : 1;
}
