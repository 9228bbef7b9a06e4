// TRUEQUAD_STATS: one JSON object, written once, by the process that drew.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace truequad {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

class Statistics : public testing::Test {
 protected:
  void SetUp() override {
    char pattern[] = "/tmp/truequad-statistics-XXXXXX";
    ASSERT_TRUE(::mkdtemp(pattern));
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  // Runs the program; returns what it said on stderr.
  std::string run(const std::string& how, const std::string& stats, const std::string& settings = "") {
    const std::string errors = folder_ + "/stderr";
    const std::string command = "cd " + folder_ + " && TRUEQUAD_STATS='" + stats + "' " + settings +
                                " " TRUEQUAD_STATISTICS_PROGRAM " " + how + " 2>" + errors;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return text_of(errors);
  }
  static std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& x : std::filesystem::directory_iterator(folder_)) {
      if (x.path().filename() != "stderr") names.push_back(x.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  std::string folder_;
};

void expect_draws(const json& j, int times) {
  EXPECT_EQ(j["quads"], 5 * times);
  EXPECT_EQ(j["passed"], 3 * times);
  EXPECT_EQ(j["corrected"], 2 * times);
  EXPECT_EQ(j["capped"], 0);
  EXPECT_GT(j["triangles"], 4 * times);
  EXPECT_GT(j["bound_px_max"], 0);
  EXPECT_LE(j["bound_px_max"], 0.25);
  EXPECT_EQ(j["by_path"], json({{"immediate", 4 * times}, {"list", times}, {"arrays", 0}, {"buffer", 0}, {"rect", 0}}));
  EXPECT_EQ(j["pass_reasons"], json({{"affine", 2 * times}, {"incomplete", times}}));
  EXPECT_EQ(j["flushes"], times);
  EXPECT_EQ(j["mode"], "bilinear");
  EXPECT_EQ(j["tolerance_px"], 0.25);
}

TEST_F(Statistics, AreWrittenOnceToTheFile) {
  EXPECT_THAT(run("plain", "s.json"), IsEmpty());
  EXPECT_EQ(files(), std::vector<std::string>{"s.json"});
  expect_draws(json::parse(text_of(folder_ + "/s.json")), 1);
}

TEST_F(Statistics, GoToStderrForADash) {
  expect_draws(json::parse(run("plain", "-")), 1);
  EXPECT_TRUE(files().empty());
}

TEST_F(Statistics, SumOverThreadsThatEnded) {
  expect_draws(json::parse(run("threads", "-")), 4);
}

TEST_F(Statistics, AProcessWithoutGlWritesNothing) {
  EXPECT_THAT(run("nothing", "s.json"), IsEmpty());
  EXPECT_TRUE(files().empty());
}

TEST_F(Statistics, AnIdleChildWritesNothing) {
  run("fork-idle", "s.json");
  EXPECT_EQ(files(), std::vector<std::string>{"s.json"});
  expect_draws(json::parse(text_of(folder_ + "/s.json")), 1);
}

TEST_F(Statistics, AChildThatDrawsWritesItsOwnFile) {
  run("fork-draws", "s.json");
  const auto names = files();
  ASSERT_EQ(names.size(), 2u);
  for (const auto& name : names) {
    EXPECT_EQ(name.rfind("s.json", 0), 0u);
    expect_draws(json::parse(text_of(folder_ + "/" + name)), 1);
  }
}

TEST_F(Statistics, AVforkedChildDoesNotEndItsParentsCounts) {
  run("vfork", "s.json");
  expect_draws(json::parse(text_of(folder_ + "/s.json")), 2);
}

TEST_F(Statistics, AnUnwritableFileCostsOneLine) {
  const std::string said = run("plain", "/nonexistent/folder/s.json");
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
  EXPECT_THAT(said, HasSubstr("truequad: cannot write the statistics to /nonexistent/folder/s.json"));
}

TEST_F(Statistics, ADeviceIsWrittenIntoAndNotReplaced) {
  EXPECT_THAT(run("plain", "/dev/null"), IsEmpty());
  struct stat null;
  ASSERT_EQ(::stat("/dev/null", &null), 0);
  EXPECT_TRUE(S_ISCHR(null.st_mode));
}

TEST_F(Statistics, ModeOffCountsWithoutTouching) {
  const json j = json::parse(run("plain", "-", "TRUEQUAD_MODE=off TRUEQUAD_TOLERANCE=2"));
  EXPECT_EQ(j["quads"], 5);
  EXPECT_EQ(j["corrected"], 0);
  EXPECT_EQ(j["pass_reasons"], json({{"mode_off", 5}}));
  EXPECT_EQ(j["mode"], "off");
  EXPECT_EQ(j["tolerance_px"], 2);
}

}  // namespace
}  // namespace truequad
