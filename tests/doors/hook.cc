// Another preloaded library that counts calls: it must see the same ones whether it stands before or behind truequad.
#include <dlfcn.h>

#include <atomic>
#include <cstdio>

namespace {

std::atomic<int> finishes = 0, vertices = 0, currents = 0;

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

struct Report {
  ~Report() { std::fprintf(stderr, "hook: %d Finish, %d Vertex2f, %d current\n", +finishes, +vertices, +currents); }
} report;

}  // namespace

extern "C" {
[[gnu::visibility("default")]] void glFinish() {
  ++finishes;
  static const auto real = next<void (*)()>("glFinish");
  real();
}
[[gnu::visibility("default")]] void glVertex2f(float x, float y) {
  ++vertices;
  static const auto real = next<void (*)(float, float)>("glVertex2f");
  real(x, y);
}
[[gnu::visibility("default")]] int glXMakeContextCurrent(void* display, unsigned long draw, unsigned long read,
                                                         void* context) {
  ++currents;
  static const auto real = next<int (*)(void*, unsigned long, unsigned long, void*)>("glXMakeContextCurrent");
  return real(display, draw, read, context);
}
}
