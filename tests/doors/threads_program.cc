// threads WHAT…: contexts on several threads at once, and the same work on one thread to compare with. OSMesa, and EGL without any
// surface. Every word prints the different pictures that were drawn, one sum a line, and nothing else if all is well.
//   one egl-one          one context, drawn into once
//   own egl-own          four threads, each with contexts of its own, one after the other; every second one is destroyed while current
//   turns                four threads, each with three contexts, drawn into in turn
//   handed               one context, made current on thread after thread
//   again                a context is destroyed while it is current, and one with the same handle may follow on another thread
//   shared               four threads whose contexts share display lists: a common one is called, own ones are made and deleted
//   settings             four threads that set modes and tolerances (truequad/control.h) while a fifth reads the statistics
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "truequad/control.h"

namespace {

// ThreadSanitizer needs no repetition to see a race.
#ifdef __SANITIZE_THREAD__
constexpr int kRounds = 3;
#else
constexpr int kRounds = 12;
#endif
constexpr int kSize = 64, kThreads = 4;

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "threads: %s failed\n", what);
  std::exit(70);
}

using Sums = std::set<std::uint64_t>;

void on_threads(const std::function<void(int)>& work) {
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) threads.emplace_back(work, i);
  for (std::thread& thread : threads) thread.join();
}

// What all threads drew.
class AllSums {
 public:
  void add(std::uint64_t sum) {
    const std::lock_guard lock(mutex_);
    sums_.insert(sum);
  }
  Sums all() const { return sums_; }

 private:
  std::mutex mutex_;
  Sums sums_;
};

// ---- Scenes ---------------------------------------------------------------------------------------------------------

void prepare() {
  unsigned char texels[16 * 16];
  for (int i = 0; i < 16 * 16; ++i) texels[i] = (unsigned char)(i * 37 % 256);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 16, 16, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  glViewport(0, 0, kSize, kSize);
}

void quads() {
  glBegin(GL_QUADS);
  for (const float tip : {0.9f, 0.3f}) {
    glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
    glTexCoord2f(1, 0), glVertex2f(0.9f, -0.9f);
    glTexCoord2f(1, 1), glVertex2f(tip, 0.9f);
    glTexCoord2f(0, 1), glVertex2f(-tip, 0.9f);
  }
  glEnd();
}

std::uint64_t sum_of_picture() {
  std::vector<unsigned char> pixels(kSize * kSize * 4);
  glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  std::uint64_t sum = 14695981039346656037u;  // FNV-1a
  for (unsigned char byte : pixels) sum = (sum ^ byte) * 1099511628211u;
  return glGetError() == GL_NO_ERROR ? sum : 0;
}

std::uint64_t draw(const std::function<void()>& scene = quads) {
  glClear(GL_COLOR_BUFFER_BIT);
  scene();
  return sum_of_picture();
}

// ---- Contexts -------------------------------------------------------------------------------------------------------

class OsmesaContext {
 public:
  explicit OsmesaContext(const OsmesaContext* share = nullptr)
      : context_(OSMesaCreateContextExt(OSMESA_RGBA, 16, 0, 0, share ? share->context_ : nullptr)), picture_(kSize * kSize * 4) {
    if (!context_) fail("OSMesaCreateContextExt");
  }
  ~OsmesaContext() { OSMesaDestroyContext(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;
  void make_current() {
    if (!OSMesaMakeCurrent(context_, picture_.data(), GL_UNSIGNED_BYTE, kSize, kSize)) fail("OSMesaMakeCurrent");
  }
  static void release() { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }

 private:
  OSMesaContext context_;
  std::vector<unsigned char> picture_;
};

// Without a surface: a framebuffer object of its own is what is drawn into.
class EglContext {
 public:
  EglContext() {
    eglBindAPI(EGL_OPENGL_API);
    context_ = eglCreateContext(display(), EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext");
  }
  ~EglContext() { eglDestroyContext(display(), context_); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  void make_current() {
    eglBindAPI(EGL_OPENGL_API);
    if (!eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) fail("eglMakeCurrent");
    const auto generate = reinterpret_cast<PFNGLGENFRAMEBUFFERSPROC>(eglGetProcAddress("glGenFramebuffers"));
    const auto bind = reinterpret_cast<PFNGLBINDFRAMEBUFFERPROC>(eglGetProcAddress("glBindFramebuffer"));
    const auto attach = reinterpret_cast<PFNGLFRAMEBUFFERTEXTURE2DPROC>(eglGetProcAddress("glFramebufferTexture2D"));
    GLuint texture, framebuffer;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    generate(1, &framebuffer);
    bind(GL_FRAMEBUFFER, framebuffer);
    attach(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  static void release() { eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

 private:
  static EGLDisplay display() {
    static const EGLDisplay opened = [] {
      const EGLDisplay found = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
      return eglInitialize(found, nullptr, nullptr) ? found : EGL_NO_DISPLAY;
    }();
    if (opened == EGL_NO_DISPLAY) fail("eglInitialize");
    return opened;
  }
  EGLContext context_;
};

// ---- Words ----------------------------------------------------------------------------------------------------------

template <typename Context>
std::uint64_t draw_in_new(bool destroy_current) {
  Context context;
  context.make_current();
  prepare();
  const std::uint64_t sum = draw();
  if (!destroy_current) Context::release();
  return sum;
}

template <typename Context>
Sums one() {
  return {draw_in_new<Context>(false)};
}

template <typename Context>
Sums own() {
  AllSums sums;
  on_threads([&](int) {
    for (int round = 0; round < kRounds; ++round) sums.add(draw_in_new<Context>(round % 2));
  });
  return sums.all();
}

Sums turns() {
  AllSums sums;
  on_threads([&](int) {
    OsmesaContext contexts[3];
    for (OsmesaContext& context : contexts) {
      context.make_current();
      prepare();
    }
    for (int round = 0; round < kRounds; ++round) {
      for (OsmesaContext& context : contexts) {
        context.make_current();
        sums.add(draw());
      }
    }
    OsmesaContext::release();
  });
  return sums.all();
}

Sums handed() {
  AllSums sums;
  OsmesaContext context;
  context.make_current();
  prepare();
  // Left between glNewList and glEndList, and finished by another thread.
  glNewList(1, GL_COMPILE);
  OsmesaContext::release();
  std::mutex turn;
  std::thread([&] {
    context.make_current();
    quads();
    glEndList();
    OsmesaContext::release();
  }).join();
  on_threads([&](int) {
    for (int round = 0; round < kRounds; ++round) {
      const std::lock_guard lock(turn);
      context.make_current();
      sums.add(draw([] { glCallList(1); }));
      OsmesaContext::release();
    }
  });
  return sums.all();
}

Sums again() {
  AllSums sums;
  on_threads([&](int) {
    for (int round = 0; round < kRounds; ++round) {
      sums.add(draw_in_new<OsmesaContext>(true));
      // Nothing of ours is current now, whoever else has that handle.
      glBegin(GL_QUADS);
      glEnd();
    }
  });
  return sums.all();
}

Sums shared() {
  AllSums sums;
  OsmesaContext first;
  first.make_current();
  prepare();
  glNewList(1, GL_COMPILE);
  quads();
  glEndList();
  OsmesaContext::release();
  on_threads([&](int i) {
    OsmesaContext context(&first);
    context.make_current();
    prepare();
    for (int round = 0; round < kRounds; ++round) {
      sums.add(draw([] { glCallList(1); }));
      const GLuint mine = GLuint(10 + i);
      glNewList(mine, GL_COMPILE);
      quads();
      glEndList();
      sums.add(draw([&] { glCallList(mine); }));
      glDeleteLists(mine, 1);
      if (glIsList(mine) || !glIsList(1)) sums.add(0);
    }
    OsmesaContext::release();
  });
  return sums.all();
}

Sums settings() {
  const auto set_mode = reinterpret_cast<decltype(&truequad_set_mode)>(dlsym(RTLD_DEFAULT, "truequad_set_mode"));
  const auto set_tolerance =
      reinterpret_cast<decltype(&truequad_set_tolerance)>(dlsym(RTLD_DEFAULT, "truequad_set_tolerance"));
  const auto read =
      reinterpret_cast<decltype(&truequad_read_statistics)>(dlsym(RTLD_DEFAULT, "truequad_read_statistics"));
  if (!set_mode || !set_tolerance || !read) fail("dlsym");
  AllSums sums;
  std::atomic<bool> done = false;
  std::thread reader([&] {
    std::uint64_t last = 0;
    while (!done) {
      truequad_statistics counts;
      // Counts only grow.
      if (!read(&counts, sizeof counts) || counts.quads < last) sums.add(0);
      last = counts.quads;
      std::this_thread::yield();
    }
  });
  on_threads([&](int i) {
    OsmesaContext context;
    context.make_current();
    prepare();
    for (int round = 0; round < kRounds; ++round) {
      set_mode((i + round) % 5);
      set_tolerance(0.05 * (1 + round));
      draw();
      // Whatever the others do, these are this thread's own.
      set_mode(TRUEQUAD_MODE_BILINEAR);
      set_tolerance(0.25);
      sums.add(draw());
    }
    OsmesaContext::release();
  });
  done = true;
  reader.join();
  return sums.all();
}

}  // namespace

int main(int count, char** words) {
  const std::pair<const char*, Sums (*)()> known[] = {
      {"one", one<OsmesaContext>}, {"egl-one", one<EglContext>}, {"own", own<OsmesaContext>}, {"egl-own", own<EglContext>},
      {"turns", turns},            {"handed", handed},           {"again", again},            {"shared", shared},
      {"settings", settings}};
  for (int i = 1; i < count; ++i) {
    bool found = false;
    for (const auto& [name, work] : known) {
      if (words[i] != std::string(name)) continue;
      found = true;
      for (const std::uint64_t sum : work()) std::printf("%016llx\n", (unsigned long long)sum);
    }
    if (!found) return 2;
  }
  return 0;
}
