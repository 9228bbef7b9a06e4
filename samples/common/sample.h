// What a sample program is: options of its own, textures, and a function that draws one frame with OpenGL 1.1.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace samples {

// What is drawn where the sample would draw its own texture.
enum class TextureKind {
  kOwn,
  // Texels that are their own coordinates: red is the first eight binary digits of s after the point, green those of
  // t, blue is 255. With kFineCoordinates the next eight digits: the texture matrix scales by 256.
  kCoordinates,
  kFineCoordinates,
};

// Common command-line options.
struct Options {
  std::string out;    // PNG to write
  std::string quads;  // JSON to write: every quad of the frame, and how it is seen
  std::string data;   // folder of the pictures
  int width = 640, height = 480;
  int frame = 0;
  int repeat = 1;
  bool time = false;
  bool window = false;
  TextureKind texture = TextureKind::kOwn;

  // Whether the texture alone has to be seen: no light, no fog, no outlines.
  bool bare() const { return texture != TextureKind::kOwn; }
};

class Sample {
 public:
  virtual ~Sample() = default;
  virtual std::string about() const = 0;
  // Options besides the common ones; a wrong value is to be refused with CLI::ValidationError.
  virtual void add_options(CLI::App&) {}
  // A context is current: make textures. Throws std::runtime_error when the data cannot be read.
  virtual void start(const Options&) = 0;
  // Draws frame number options.frame into a cleared window; the viewport is set.
  virtual void draw(const Options&) = 0;
};

// Runs the sample with these arguments and returns the exit status: 2 for bad arguments, 1 for what cannot be read
// or written. There are two of it, see CMakeLists.txt: off the screen (offscreen.cc), in a window (window.cc).
int run(Sample& sample, int argc, char** argv);

}  // namespace samples
