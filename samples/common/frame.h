// One frame, the same off the screen and in a window.
#pragma once

#include <chrono>
#include <vector>

#include "common/sample.h"

namespace samples {

class Frames {
 public:
  Frames(Sample& sample, const Options& options) : sample_(sample), options_(options) {}

  // With the context current, before the first frame.
  void start();
  // Clears, draws the next frame and waits until it is drawn.
  void draw(int width, int height);
  // Writes what the options ask for: the picture in the buffer, the list of quads, the time.
  void write() const;
  bool done() const { return int(times_ms_.size()) >= options_.repeat; }

 private:
  Sample& sample_;
  Options options_;
  std::vector<double> times_ms_;
};

}  // namespace samples
