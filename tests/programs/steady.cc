// A steady world for a program under test, to be preloaded: a clock that moves by a fixed step with every
// frame, a fixed process id (programs seed random numbers from both), an X connection without races, and
// pictures of chosen frames as they stand in the back buffer. It knows nothing of truequad and may stand
// before or after it in LD_PRELOAD.
//
//   STEADY_FRAMES=10,20   frames to keep, counted from 1 at the first swap; after the last one the process
//   ends STEADY_OUT=PREFIX     writes PREFIX-10.png, PREFIX-20.png, and PREFIX.log with a line per frame:
//                           frame 10 640x480 colours 4711 errors none
//
// Time as the program's first thread sees it stands still within a frame. A sleep does not wait but moves the
// clock; so does asking for the time without end, since some programs wait that way. Other threads (a
// driver's workers) see the real clock.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <dlfcn.h>
#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <initializer_list>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#define STEADY_EXPORT extern "C" __attribute__((visibility("default")))

namespace {

constexpr long long kSecond_ns = 1'000'000'000;
constexpr long long kFrame_ns = kSecond_ns / 30;
constexpr long long kStart_ns = 1'000'000'000 * kSecond_ns;
// So many readings of the clock within a frame mean that the program waits for it.
constexpr int kPatience = 1000;
constexpr long long kImpatientStep_ns = kSecond_ns / 1000;

long long now_ns = kStart_ns;
int readings = 0;
int frame = 0;

// Only the program itself lives in the steady world, not its children: they have no frames to move their
// clock.
bool steady_process = false;

__attribute__((constructor)) void claim() {
  constexpr const char* kOwner = "STEADY_OWNER";
  char own[16];
  snprintf(own, sizeof own, "%ld", syscall(SYS_getpid));
  if (!getenv(kOwner)) setenv(kOwner, own, 1);
  steady_process = strcmp(getenv(kOwner), own) == 0;
  pthread_atfork(nullptr, nullptr, [] { steady_process = false; });
}

bool steady() {
  static thread_local const bool first_thread = syscall(SYS_gettid) == syscall(SYS_getpid);
  return steady_process && first_thread;
}

void advance(long long step_ns) {
  now_ns += step_ns > 0 ? step_ns : 0;
  readings = 0;
  sched_yield();
}

long long read_clock() {
  if (++readings > kPatience) advance(kImpatientStep_ns);
  return now_ns;
}

timespec to_timespec(long long ns) { return {time_t(ns / kSecond_ns), long(ns % kSecond_ns)}; }
long long to_ns(const timespec& t) { return t.tv_sec * kSecond_ns + t.tv_nsec; }
long long to_ns(const timeval& t) { return t.tv_sec * kSecond_ns + t.tv_usec * 1000ll; }

// The next definition behind this library; for libraries that a plug-in brought along, the one in its own
// file.
template <typename Function>
Function next(const char* name, const char* file, Function) {
  void* found = dlsym(RTLD_NEXT, name);
  if (!found) {
    if (void* library = dlopen(file, RTLD_LAZY | RTLD_NOLOAD)) found = dlsym(library, name);
  }
  if (!found) {
    fprintf(stderr, "steady: no %s to be found\n", name);
    _exit(70);
  }
  return reinterpret_cast<Function>(found);
}

// The driver's own function, whatever other libraries are preloaded.
template <typename Function>
Function driver(const char* name, Function) {
  for (const char* file : {"libGL.so.1", "libOpenGL.so.0"}) {
    if (void* library = dlopen(file, RTLD_LAZY | RTLD_NOLOAD)) {
      if (void* found = dlsym(library, name)) return reinterpret_cast<Function>(found);
    }
  }
  fprintf(stderr, "steady: no driver to read pictures from\n");
  _exit(70);
}
#define DRIVER(name) driver(#name, &name)

struct Wanted {
  int last = 0;
  bool frames[10000] = {};
};

const Wanted& wanted() {
  static const Wanted kept = [] {
    Wanted result;
    const char* text = getenv("STEADY_FRAMES");
    while (text && *text) {
      char* end;
      const long number = strtol(text, &end, 10);
      if (end == text || number < 1 || number >= 10000) {
        fprintf(stderr, "steady: STEADY_FRAMES must be numbers from 1 to 9999, with commas between\n");
        _exit(70);
      }
      result.frames[number] = true;
      if (number > result.last) result.last = int(number);
      text = *end == ',' ? end + 1 : end;
    }
    return result;
  }();
  return kept;
}

const char* out_prefix() {
  const char* prefix = getenv("STEADY_OUT");
  return prefix ? prefix : "steady";
}

FILE* log_file() {
  static FILE* const file = [] {
    char path[4096];
    snprintf(path, sizeof path, "%s.log", out_prefix());
    FILE* opened = fopen(path, "we");
    return opened ? opened : stderr;
  }();
  return file;
}

// Number of different colours, counted up to the size of the table: tells a picture from an empty window.
int count_colours(const unsigned char* rgb, size_t pixels) {
  constexpr size_t kSlots = 8192;
  static unsigned table[kSlots];
  memset(table, 0, sizeof table);
  int count = 0;
  for (size_t i = 0; i < pixels; ++i) {
    const unsigned colour = 1u + (rgb[3 * i] << 16 | rgb[3 * i + 1] << 8 | rgb[3 * i + 2]);
    size_t slot = colour * 2654435761u % kSlots;
    while (table[slot] && table[slot] != colour) slot = (slot + 1) % kSlots;
    if (!table[slot]) {
      table[slot] = colour;
      if (++count == int(kSlots) / 2) break;
    }
  }
  return count;
}

int keep_picture(int width, int height) {
  const size_t stride = size_t(width) * 3;
  unsigned char* pixels = static_cast<unsigned char*>(malloc(stride * height));
  DRIVER(glPushClientAttrib)(GL_CLIENT_PIXEL_STORE_BIT);
  DRIVER(glPushAttrib)(GL_PIXEL_MODE_BIT);
  for (const GLenum name : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES}) {
    DRIVER(glPixelStorei)(name, 0);
  }
  DRIVER(glPixelStorei)(GL_PACK_ALIGNMENT, 1);
  DRIVER(glReadBuffer)(GL_BACK);
  DRIVER(glReadPixels)(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
  DRIVER(glPopAttrib)();
  DRIVER(glPopClientAttrib)();

  char path[4096];
  snprintf(path, sizeof path, "%s-%d.png", out_prefix(), frame);
  stbi_flip_vertically_on_write(1);
  if (!stbi_write_png(path, width, height, 3, pixels, int(stride))) {
    fprintf(stderr, "steady: cannot write %s\n", path);
    _exit(70);
  }
  const int colours = count_colours(pixels, size_t(width) * height);
  free(pixels);
  return colours;
}

// Another preloaded library may hold drawing back until a call that could notice; glFinish is one.
void finish_drawing() {
  if (auto finish = reinterpret_cast<decltype(&glFinish)>(dlsym(RTLD_DEFAULT, "glFinish"))) finish();
  DRIVER(glFinish)();
}

// One swap may come by more than one of the doors below.
bool swapping = false;

template <typename Size>
void frame_ends(Size size) {
  if (!steady_process || swapping || !wanted().last) return;
  ++frame;
  finish_drawing();
  char errors[16 * 8] = "";
  for (int i = 0; i < 16; ++i) {
    const GLenum error = DRIVER(glGetError)();
    if (error == GL_NO_ERROR) break;
    snprintf(errors + strlen(errors), sizeof errors - strlen(errors), " 0x%x", error);
  }
  if (frame <= wanted().last) {
    fprintf(log_file(), "frame %d", frame);
    if (wanted().frames[frame]) {
      int width = 0, height = 0;
      size(width, height);
      fprintf(log_file(), " %dx%d", width, height);
      fprintf(log_file(), " colours %d", keep_picture(width, height));
    }
    fprintf(log_file(), " errors%s\n", *errors ? errors : " none");
    fflush(log_file());
  }
  if (frame >= wanted().last) _exit(0);
  advance(kFrame_ns);
}

}  // namespace

// ---- frames

namespace {

void glx_frame_ends(Display* display, GLXDrawable drawable) {
  frame_ends([&](int& width, int& height) {
    unsigned value = 0;
    const auto query = driver("glXQueryDrawable", &glXQueryDrawable);
    query(display, drawable, GLX_WIDTH, &value);
    width = int(value);
    query(display, drawable, GLX_HEIGHT, &value);
    height = int(value);
  });
}

}  // namespace

STEADY_EXPORT void glXSwapBuffers(Display* display, GLXDrawable drawable) {
  glx_frame_ends(display, drawable);
  static const auto swap = next("glXSwapBuffers", "libGL.so.1", &glXSwapBuffers);
  swap(display, drawable);
}

// SDL 1.2 finds glXSwapBuffers by dlsym, on which preloading has no influence.
STEADY_EXPORT void SDL_GL_SwapBuffers() {
  glx_frame_ends(DRIVER(glXGetCurrentDisplay)(), DRIVER(glXGetCurrentDrawable)());
  static const auto swap = next("SDL_GL_SwapBuffers", "libSDL-1.2.so.0", &SDL_GL_SwapBuffers);
  swapping = true;
  swap();
  swapping = false;
}

STEADY_EXPORT EGLBoolean eglSwapBuffers(EGLDisplay display, EGLSurface surface) {
  frame_ends([&](int& width, int& height) {
    static const auto query = next("eglQuerySurface", "libEGL.so.1", &eglQuerySurface);
    query(display, surface, EGL_WIDTH, &width);
    query(display, surface, EGL_HEIGHT, &height);
  });
  static const auto swap = next("eglSwapBuffers", "libEGL.so.1", &eglSwapBuffers);
  return swap(display, surface);
}

// ---- X: every request waits for the server, so events are in the queue where the program's own requests put
// them.

STEADY_EXPORT Display* XOpenDisplay(const char* name) {
  static const auto open = next("XOpenDisplay", "libX11.so.6", &XOpenDisplay);
  static const auto synchronize = next("XSynchronize", "libX11.so.6", &XSynchronize);
  Display* display = open(name);
  if (display) synchronize(display, True);
  return display;
}

// ---- identity and time

STEADY_EXPORT pid_t getpid() noexcept { return steady_process ? 4242 : pid_t(syscall(SYS_getpid)); }

STEADY_EXPORT int clock_gettime(clockid_t clock, timespec* out) noexcept {
  const bool processor_time = clock == CLOCK_PROCESS_CPUTIME_ID || clock == CLOCK_THREAD_CPUTIME_ID;
  if (!steady() || processor_time) return int(syscall(SYS_clock_gettime, clock, out));
  *out = to_timespec(read_clock());
  return 0;
}

STEADY_EXPORT int gettimeofday(timeval* __restrict out, void* __restrict zone) noexcept {
  if (!steady()) return int(syscall(SYS_gettimeofday, out, zone));
  const timespec t = to_timespec(read_clock());
  *out = {t.tv_sec, t.tv_nsec / 1000};
  return 0;
}

STEADY_EXPORT time_t time(time_t* out) noexcept {
  timespec t;
  clock_gettime(CLOCK_REALTIME, &t);
  if (out) *out = t.tv_sec;
  return t.tv_sec;
}

STEADY_EXPORT int clock_nanosleep(clockid_t clock, int flags, const timespec* request, timespec* remain) {
  if (!steady()) {
    const long result = syscall(SYS_clock_nanosleep, clock, flags, request, remain);
    return result ? errno : 0;
  }
  advance(flags & TIMER_ABSTIME ? to_ns(*request) - now_ns : to_ns(*request));
  if (remain && !(flags & TIMER_ABSTIME)) *remain = {};
  return 0;
}

STEADY_EXPORT int nanosleep(const timespec* request, timespec* remain) {
  if (!steady()) return int(syscall(SYS_nanosleep, request, remain));
  return clock_nanosleep(CLOCK_MONOTONIC, 0, request, remain);
}

STEADY_EXPORT int usleep(useconds_t microseconds) {
  const timespec request = to_timespec(microseconds * 1000ll);
  return nanosleep(&request, nullptr);
}

STEADY_EXPORT unsigned sleep(unsigned seconds) {
  const timespec request = {time_t(seconds), 0};
  nanosleep(&request, nullptr);
  return 0;
}

// Waiting for descriptors with a time limit: what is ready is ready; otherwise the limit passes at once.

STEADY_EXPORT int select(int count, fd_set* __restrict in, fd_set* __restrict out, fd_set* __restrict except,
                         timeval* __restrict limit) {
  if (!steady() || !limit) return int(syscall(SYS_select, count, in, out, except, limit));
  timeval none = {};
  const int ready = int(syscall(SYS_select, count, in, out, except, &none));
  if (ready == 0) advance(to_ns(*limit));
  return ready;
}

STEADY_EXPORT int poll(pollfd* descriptors, nfds_t count, int limit_ms) {
  if (!steady() || limit_ms <= 0) return int(syscall(SYS_poll, descriptors, count, limit_ms));
  const int ready = int(syscall(SYS_poll, descriptors, count, 0));
  if (ready == 0) advance(limit_ms * 1'000'000ll);
  return ready;
}
