/* Control of truequad by the program that it corrects: plain C (C89 and later, C++).
 *
 * A program that is linked with truequad calls these functions like any others. One that may run with or without it (LD_PRELOAD,
 * the command truequad) asks for them by name, and goes without if there are none:
 *
 *     int (*set_mode)(int) = (int (*)(int))dlsym(RTLD_DEFAULT, "truequad_set_mode");
 *
 * Settings belong to the thread that sets them. A thread begins with those of the environment (TRUEQUAD_MODE,
 * TRUEQUAD_TOLERANCE), with all primitives on, and keeps its own whatever context it makes current. A setting takes effect at the
 * thread's next glBegin, draw from arrays or glRect, so one that is made between glBegin and glEnd leaves that primitive as it is; a
 * display list that is called is drawn by the settings of the call. A list that was compiled while its quads were off is the driver's, for good.
 * Several passes over the same vertices land on the same depths only if all are drawn with the same settings: change them between
 * frames.
 *
 * Functions that set return 1 when it is done. They return 0 and change nothing if a value is none of those allowed (or if there is
 * no memory for the thread's first setting). None of them makes an OpenGL call, raises an OpenGL error or needs a current context.
 * Not for signal handlers. */
#ifndef TRUEQUAD_CONTROL_H
#define TRUEQUAD_CONTROL_H

#include <stddef.h>
#include <stdint.h>

/* Of this header. A library of the same or a higher version has all that stands here. */
#define TRUEQUAD_CONTROL_VERSION 1

#ifdef __cplusplus
extern "C" {
#endif

/* The TRUEQUAD_CONTROL_VERSION of the library that runs. */
int truequad_control_version(void);

/* How quads are corrected; TRUEQUAD_MODE in README.md says what each means. */
enum truequad_mode {
  TRUEQUAD_MODE_BILINEAR = 0,
  TRUEQUAD_MODE_PROJECTIVE = 1,
  TRUEQUAD_MODE_AUTO = 2,
  TRUEQUAD_MODE_PAPER = 3,
  TRUEQUAD_MODE_OFF = 4
};
int truequad_set_mode(int mode);
int truequad_get_mode(void);

/* The largest displacement of a texel, in pixels of the viewport: finite and above 0. */
int truequad_set_tolerance(double pixels);
double truequad_get_tolerance(void);

/* Quads of one kind of primitive: on (1) or off (0, drawn as the driver does). The values are those of OpenGL; GL_POLYGON means
 * polygons of four vertices. truequad_get_primitive returns -1 for anything else. */
enum truequad_primitive {
  TRUEQUAD_QUADS = 0x0007,      /* GL_QUADS */
  TRUEQUAD_QUAD_STRIP = 0x0008, /* GL_QUAD_STRIP */
  TRUEQUAD_POLYGON = 0x0009     /* GL_POLYGON */
};
int truequad_set_primitive(unsigned int primitive, int on);
int truequad_get_primitive(unsigned int primitive);

/* What was drawn since the process began (or was forked), by all threads. A quad that another thread draws meanwhile may be
 * counted in part. In a process whose environment says TRUEQUAD_MODE=off and asks for no statistics, a thread is not counted before
 * its first setting. */
typedef struct truequad_statistics {
  uint64_t quads;      /* all that were seen */
  uint64_t passed;     /* left to the driver */
  uint64_t corrected;  /* quads = passed + corrected */
  uint64_t capped;     /* of the corrected ones: the tolerance could not be promised */
  uint64_t triangles;  /* drawn for the corrected ones */
  uint64_t flushes;    /* primitives of the program that were cut for a correction */
  double bound_px_max; /* the largest promised error */
} truequad_statistics;

/* Fills in `size` bytes, which is sizeof(truequad_statistics) as the program was compiled: what its version of this header does not
 * know is left out, what the library's does not know is 0. Returns 0 if there is nowhere to write. */
int truequad_read_statistics(truequad_statistics* statistics, size_t size);

/* How many quads were passed for a reason, by its name in the table of docs/semantics.md ("affine", "texturing_off" ...). Returns 0
 * and leaves *count alone if there is no reason of that name. */
int truequad_read_pass_reason(const char* name, uint64_t* count);

#ifdef __cplusplus
}
#endif

#endif
