// Runs a program and says how it ended: what the tests of whole processes share.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace truequad::doors_test {

struct Ended {
  int status = -1;  // of exit; 128 + number if a signal ended the program, as shells have it
  std::string out, err;
};

// Runs `words` with `environment` added to this process's own ("" removes a variable), and waits for it.
Ended run(const std::vector<std::string>& words, const std::map<std::string, std::string>& environment = {});

// A new directory, removed with all that is in it.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);

}  // namespace truequad::doors_test
