#include "pictures.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace truequad::images {
namespace {

// Runs a command with more environment; its exit status.
int run(const std::vector<std::string>& command, const std::vector<std::string>& environment) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    for (const std::string& setting : environment) putenv(const_cast<char*>(setting.c_str()));
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = -1;
  if (child < 0 || waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// A file of this process alone, gone at the end of its life.
class ScratchFile {
 public:
  explicit ScratchFile(const char* name) : path_("images." + std::to_string(getpid()) + "." + name) {}
  ~ScratchFile() { std::remove(path_.c_str()); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// The number of steps of 1 / 256 in `byte`, nearest to `about`: `about` is known to a few steps, the byte to
// half of one, and modulo 256.
double refine(double about, int byte) { return byte + 256 * std::round((about - byte) / 256); }

double coordinate(const std::array<int, 3>& digits) {
  double steps = digits[0] + 0.5;
  for (const int scale : {1, 2}) steps = refine(steps * 16, digits[std::size_t(scale)]) + 0.5;
  return steps * kCoordinateStep;
}

}  // namespace

Pictures draw(const Job& job, const std::optional<Settings>& settings) {
  const ScratchFile file("raw"), statistics("json");
  std::vector<std::string> environment;
  if (settings) {
    environment = {"LD_PRELOAD=" TRUEQUAD_PRELOAD, "TRUEQUAD_MODE=" + settings->mode,
                   "TRUEQUAD_TOLERANCE=" + std::to_string(settings->tolerance_px),
                   "TRUEQUAD_STATS=" + statistics.path(), "TRUEQUAD_COLOR=" + std::string(settings->color ? "1" : "0")};
  }
  const std::vector<std::string> command = {(job.colours ? DRAW_COLOURS_PREFIX : DRAW_SCENES_PREFIX) + job.interface,
                                            job.family,
                                            std::to_string(job.first),
                                            std::to_string(job.seeds),
                                            std::to_string(job.width),
                                            std::to_string(job.height),
                                            file.path()};
  Pictures pictures;
  const int status = run(command, environment);
  EXPECT_EQ(status, 0) << command[0] << " " << job.family;
  if (status != 0) return pictures;

  std::ifstream in(file.path(), std::ios::binary);
  in.read(reinterpret_cast<char*>(&pictures.header), sizeof pictures.header);
  pictures.bytes.resize(picture_bytes(pictures.header) * kPasses * std::size_t(job.seeds));
  in.read(reinterpret_cast<char*>(pictures.bytes.data()), std::streamsize(pictures.bytes.size()));
  EXPECT_TRUE(in.good()) << "the pictures of " << job.family << " are cut short";
  if (settings) {
    const auto json = nlohmann::json::parse(std::ifstream(statistics.path()), nullptr, false);
    EXPECT_TRUE(json.is_object()) << "no statistics from " << job.family;
    if (json.is_object()) {
      pictures.statistics = {json.value("quads", -1L), json.value("corrected", -1L),
                             json.value("capped", -1L)};
    }
  }
  return pictures;
}

std::optional<Texel> texel_at(const Pictures& pictures, int trial, int x, int y) {
  std::array<int, 3> s, t;
  for (int pass = 0; pass < kLayersPass; ++pass) {
    const unsigned char* pixel = pictures.pixel(trial, pass, x, y);
    if (pixel[3] == 0) return std::nullopt;
    s[std::size_t(pass)] = pixel[0];
    t[std::size_t(pass)] = pixel[1];
  }
  return Texel{coordinate(s), coordinate(t), pictures.pixel(trial, 0, x, y)[2]};
}

}  // namespace truequad::images
