// What every sample program is: a scene in plain OpenGL 1.1, and the options that all of them share. The
// program draws into memory and writes a PNG, or opens a window.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace samples {

// Which texture the scene shows: its own, or one that tells its own coordinates, so that a picture can be
// measured. Each pass shows eight binary digits of s in red and of t in green: coarse those above 2^-8, fine
// those above 2^-16.
enum class Coordinates { kNone, kCoarse, kFine };

struct Options {
  std::string out;    // PNG to write; empty: none
  std::string quads;  // JSON of the quads that the last frame drew; empty: none
  int width = 640, height = 480;
  int frame = 0;        // which moment of the scene
  int repeat = 1;       // draw it so many times
  bool time = false;    // report milliseconds per frame
  bool window = false;  // a GLUT window instead of a picture
  Coordinates coordinates = Coordinates::kNone;
};

class Sample {
 public:
  virtual ~Sample() = default;
  virtual const char* name() const = 0;
  virtual const char* description() const = 0;
  // Adds the options of this scene alone.
  virtual void add_options(CLI::App&) {}
  // Makes textures. Called once, with the context current.
  virtual void prepare() = 0;
  // Draws the scene on a cleared canvas of width x height pixels, as it is at `frame`.
  virtual void draw(int width, int height, int frame) = 0;
};

// A whole program: reads the options, shows the sample, returns the exit status (2 for bad arguments).
int run(int argc, char** argv, Sample& sample);

// Shows one frame as `options` say; there are two definitions, of which each program links one.
int show(Sample& sample, const Options& options, char** argv);

// Clears the canvas and draws one frame.
void draw_frame(Sample& sample, const Options& options, int width, int height, int frame);

}  // namespace samples
