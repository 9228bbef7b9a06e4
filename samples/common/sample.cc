// The command line that all samples share.
#include "common/sample.h"

#include <GL/gl.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "common/quads.h"

namespace samples {
namespace {

// The largest canvas that common drivers accept.
constexpr int kMaxSize = 16384;

// "WxH" in pixels; returns what is wrong with it, or nothing.
std::string parse_size(const std::string& text, Options& options) {
  int used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &options.width, &options.height, &used) != 2 ||
      std::size_t(used) != text.size() || options.width < 1 || options.height < 1 ||
      options.width > kMaxSize || options.height > kMaxSize) {
    return "must be WIDTHxHEIGHT, each from 1 to " + std::to_string(kMaxSize) + ", not '" + text + "'";
  }
  return {};
}

}  // namespace

void draw_frame(Sample& sample, const Options& options, int width, int height, int frame) {
  begin_frame(options.coordinates, !options.quads.empty());
  glViewport(0, 0, width, height);
  // The coordinate texture leaves 0 for "no quad here".
  const float grey = options.coordinates == Coordinates::kNone ? 0.75f : 0;
  glClearColor(grey, grey, grey, options.coordinates == Coordinates::kNone ? 1 : 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  sample.draw(width, height, frame);
  glFinish();
}

int run(int argc, char** argv, Sample& sample) {
  Options options;
  CLI::App app(sample.description(), sample.name());
  app.add_option("--out", options.out, "PNG file to write");
  app.add_option_function<std::string>(
         "--size",
         [&options](const std::string& text) {
           if (const std::string wrong = parse_size(text, options); !wrong.empty()) {
             throw CLI::ValidationError("--size", wrong);
           }
         },
         "Size of the picture in pixels (640x480)")
      ->type_name("WxH");
  app.add_option("--frame", options.frame, "Moment of the scene, from 0")->check(CLI::Range(0, 1000000));
  app.add_option("--repeat", options.repeat, "Draw the frame so many times")->check(CLI::Range(1, 1000000));
  app.add_flag("--time", options.time, "Print milliseconds per frame on standard error");
  app.add_flag("--window", options.window, "Open a window instead; q or Escape closes it");
  app.add_option("--coordinates", options.coordinates, "Show a texture that tells its own coordinates")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Coordinates>{{"coarse", Coordinates::kCoarse},
                                                                             {"fine", Coordinates::kFine}}));
  app.add_option("--quads", options.quads, "JSON file to write: the quads that were drawn");
  sample.add_options(app);
  try {
    app.parse(argc, argv);
    if (!options.window && options.out.empty() && options.quads.empty() && !options.time) {
      throw CLI::ValidationError("nothing to do: say --out FILE or --window");
    }
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "%s: %s\n", sample.name(), error.what());
    return 2;
  }
  try {
    return show(sample, options, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", sample.name(), error.what());
    return 1;
  }
}

}  // namespace samples
