// Runs a drawing program, without truequad and with it, and reads what it recorded.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record.h"

namespace truequad::semantics {

struct Outcome {
  std::map<std::string, std::string> records;
  long quads = 0, corrected = 0;  // of the statistics; 0 without truequad

  // A byte of a picture: channel 0 to 3 of the pixel number `pixel`, counted from the bottom left.
  int byte(const std::string& picture, int pixel, int channel) const {
    return static_cast<unsigned char>(records.at(picture)[std::size_t(pixel) * 4 + std::size_t(channel)]);
  }
  template <typename T>
  std::vector<T> values(const std::string& name) const {
    const std::string& bytes = records.at(name);
    std::vector<T> result(bytes.size() / sizeof(T));
    bytes.copy(reinterpret_cast<char*>(result.data()), result.size() * sizeof(T));
    return result;
  }
};

struct Job {
  std::string interface;  // osmesa, egl or glx
  std::string scene;
  unsigned first = 0, seeds = 1;
};

// The same for any program: `words` and the file of records.
Outcome run_program(std::vector<std::string> words, bool with_truequad, const std::string& mode = "bilinear",
                    bool color = false);

// A program that fails is a failed test, and leaves no records. `mode`, `color`: of truequad.
Outcome run_natively(const Job& job);
Outcome run_with_truequad(const Job& job, const std::string& mode = "bilinear", bool color = false);

}  // namespace truequad::semantics
