/* A program that uses truequad if it runs with it (truequad PROGRAM, LD_PRELOAD), and does without if not. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>

#include <truequad/control.h>

#include "picture.h"

int main(void) {
  int (*version)(void);
  int (*set_tolerance)(double);
  int (*read_statistics)(truequad_statistics*, size_t);

  if (!open_picture()) {
    fprintf(stderr, "no OpenGL\n");
    return 1;
  }
  /* ISO C has no conversion from an object's to a function's address, POSIX does (dlsym). */
  *(void**)&version = dlsym(RTLD_DEFAULT, "truequad_control_version");
  *(void**)&set_tolerance = dlsym(RTLD_DEFAULT, "truequad_set_tolerance");
  *(void**)&read_statistics = dlsym(RTLD_DEFAULT, "truequad_read_statistics");
  if (version && version() >= 1) set_tolerance(0.1);
  draw_picture();
  if (version && version() >= 1) {
    truequad_statistics counts;
    read_statistics(&counts, sizeof counts);
    printf("%lu corrected\n", (unsigned long)counts.corrected);
  } else {
    printf("without truequad\n");
  }
  return 0;
}
