#include "common/options.h"

#include <cstdio>
#include <filesystem>
#include <map>

namespace samples {
namespace {

constexpr int kBadArguments = 2;
constexpr int kMaxSize_px = 16384;

void parse_size(const std::string& text, Options& options) {
  int width = 0, height = 0, end = 0;
  if (std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &end) != 2 || end != int(text.size()) ||
      width < 1 || height < 1 || width > kMaxSize_px || height > kMaxSize_px) {
    throw CLI::ValidationError("--size", "must be WxH, 1x1 to 16384x16384, not '" + text + "'");
  }
  options.width = width;
  options.height = height;
}

}  // namespace

void complain(const char* program, const std::string& text) {
  std::fprintf(stderr, "%s: %s\n", std::filesystem::path(program).filename().c_str(), text.c_str());
}

std::optional<int> parse(Sample& sample, int argc, char** argv, Options& options) {
  CLI::App app{sample.about(), std::filesystem::path(argv[0]).filename()};
  const std::map<std::string, TextureKind> kinds{{"own", TextureKind::kOwn},
                                                 {"coordinates", TextureKind::kCoordinates},
                                                 {"fine-coordinates", TextureKind::kFineCoordinates}};
  options.data = SAMPLES_DATA;
  app.add_option("--out", options.out, "write the picture to this PNG file");
  app.add_option_function<std::string>(
      "--size", [&](const std::string& text) { parse_size(text, options); },
      "width and height in pixels, WxH (640x480)");
  app.add_option("--frame", options.frame, "which frame of the animation (0)")->check(CLI::Range(0, 1 << 24));
  app.add_option("--repeat", options.repeat, "draw so many frames, beginning with --frame")
      ->check(CLI::Range(1, 1 << 24));
  app.add_flag("--time", options.time, "print the milliseconds of a frame (median) on stderr");
  app.add_flag("--window", options.window, "draw in a window; Escape ends it");
  app.add_option("--data", options.data, "folder of the pictures")->check(CLI::ExistingDirectory);
  app.add_option_function<std::string>(
         "--texture", [&](const std::string& text) { options.texture = kinds.at(text); },
         "own, or texels that are their own coordinates: coordinates (first 8 bits), fine-coordinates (next "
         "8)")
      ->check(CLI::IsMember(kinds));
  app.add_option("--quads", options.quads,
                 "write every quad of the last frame, and how it is seen, to this JSON file");
  sample.add_options(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    complain(argv[0], std::string(error.what()) + " (see --help)");
    return kBadArguments;
  }
  return std::nullopt;
}

}  // namespace samples
