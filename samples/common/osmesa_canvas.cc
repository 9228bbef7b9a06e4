// The plain program: draws into memory with OSMesa and writes a PNG.
//
// OSMesa and libGL define the same gl* names, and whichever is linked first takes them all, so one program
// cannot serve an OSMesa context and a GLX window both. Each sample is therefore linked twice from the same
// objects: NAME with OSMesa and NAME-window with GLUT and libGL. NAME --window becomes NAME-window, which
// stands beside it.
#include <GL/osmesa.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "common/picture.h"
#include "common/quads.h"
#include "common/sample.h"

namespace samples {
namespace {

class Canvas {
 public:
  Canvas(int width, int height)
      : picture_{width, height, std::vector<unsigned char>(std::size_t(width) * std::size_t(height) * 4)},
        context_(OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr)) {
    if (context_ == nullptr ||
        OSMesaMakeCurrent(context_, picture_.pixels.data(), GL_UNSIGNED_BYTE, width, height) != GL_TRUE) {
      throw std::runtime_error("OSMesa gives no context of this size");
    }
    OSMesaPixelStore(OSMESA_Y_UP, 0);  // first row on top, as PNG has it
  }
  ~Canvas() {
    if (context_ != nullptr) OSMesaDestroyContext(context_);
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  const Picture& picture() const { return picture_; }

 private:
  Picture picture_;
  OSMesaContext context_;
};

int become_window(char** argv) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string() + "-window";
  execv(program.c_str(), argv);
  throw std::runtime_error("cannot run " + program + ": " + std::strerror(errno));
}

}  // namespace

int show(Sample& sample, const Options& options, char** argv) {
  if (options.window) return become_window(argv);
  using Clock = std::chrono::steady_clock;
  Canvas canvas(options.width, options.height);
  sample.prepare();
  std::vector<double> times_ms;
  for (int i = 0; i < options.repeat; ++i) {
    const Clock::time_point start = Clock::now();
    draw_frame(sample, options, options.width, options.height, options.frame);
    times_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  if (options.time) {
    const auto middle = times_ms.begin() + std::ptrdiff_t(times_ms.size() / 2);
    std::nth_element(times_ms.begin(), middle, times_ms.end());
    std::fprintf(stderr, "%.3f ms per frame\n", *middle);
  }
  // A picture of coordinates keeps the quad's number in alpha; others are opaque, whatever a scene left
  // there.
  if (!options.out.empty())
    write_png(canvas.picture(), options.out, options.coordinates != Coordinates::kNone);
  if (!options.quads.empty()) write_quads(options.quads);
  return 0;
}

}  // namespace samples
