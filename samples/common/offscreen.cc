// Runs a sample without a screen: OSMesa, a buffer in memory.
#include <GL/osmesa.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <memory>
#include <vector>

#include "common/frame.h"
#include "common/options.h"

namespace samples {
namespace {

// The same sample linked with a window system, beside this program.
int become_window(char** argv) {
  std::error_code error;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", error).string() + "-window";
  ::execv(program.c_str(), argv);
  complain(argv[0], program + ": " + std::strerror(errno));
  return 1;
}

}  // namespace

int run(Sample& sample, int argc, char** argv) {
  Options options;
  if (const auto status = parse(sample, argc, argv, options)) return *status;
  if (options.window) return become_window(argv);

  const auto destroy = [](OSMesaContext context) { OSMesaDestroyContext(context); };
  const std::unique_ptr<std::remove_pointer_t<OSMesaContext>, decltype(destroy)> context(
      OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr), destroy);
  std::vector<GLubyte> buffer(std::size_t(options.width) * options.height * 4);
  if (!context ||
      !OSMesaMakeCurrent(context.get(), buffer.data(), GL_UNSIGNED_BYTE, options.width, options.height)) {
    complain(argv[0], "OSMesa gives no context of that size");
    return 1;
  }
  try {
    Frames frames(sample, options);
    frames.start();
    while (!frames.done()) frames.draw(options.width, options.height);
    frames.write();
  } catch (const std::exception& error) {
    complain(argv[0], error.what());
    return 1;
  }
  return 0;
}

}  // namespace samples
