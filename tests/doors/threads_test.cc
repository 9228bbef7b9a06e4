// Several contexts on a thread, several threads at once: every picture is the one that a single context on a single thread gives,
// and every correction is counted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "run.h"

namespace truequad::doors_test {
namespace {

constexpr int kThreads = 4, kRounds = 12;  // threads_program.cc

// What the program printed; `counts` gets the statistics.
std::vector<std::string> threads(const std::string& word, nlohmann::json* counts = nullptr, bool preloaded = true) {
  const Scratch scratch;
  const Ended ended = run({TRUEQUAD_THREADS, word}, {{"LD_PRELOAD", preloaded ? TRUEQUAD_PRELOAD : ""},
                                                     {"LIBGL_ALWAYS_SOFTWARE", "1"},
                                                     {"TRUEQUAD_STATS", scratch / "stats"}});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  if (counts) *counts = nlohmann::json::parse(read_file(scratch / "stats"), nullptr, false);
  std::istringstream in(ended.out);
  std::vector<std::string> sums;
  for (std::string line; std::getline(in, line);) sums.push_back(line);
  return sums;
}

class Threads : public testing::TestWithParam<std::pair<const char*, int>> {};

// Corrected pictures, each equal to that of one context on one thread.
TEST_P(Threads, DrawWhatOneThreadDraws) {
  const auto [word, pictures] = GetParam();
  const std::string alone = std::string(word).starts_with("egl") ? "egl-one" : "one";
  const std::vector<std::string> expected = threads(alone);
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_NE(expected, threads(alone, nullptr, false)) << "nothing was corrected";
  nlohmann::json counts;
  EXPECT_EQ(threads(word, &counts), expected);
  ASSERT_TRUE(counts.is_object());
  EXPECT_EQ(counts.value("corrected", -1), pictures);
}

INSTANTIATE_TEST_SUITE_P(Contexts, Threads,
                         testing::Values(std::pair{"own", kThreads * kRounds}, std::pair{"egl-own", kThreads* kRounds},
                                         std::pair{"turns", 3 * kThreads* kRounds}, std::pair{"handed", kThreads* kRounds},
                                         std::pair{"again", kThreads* kRounds}, std::pair{"shared", 2 * kThreads* kRounds}),
                         [](const auto& info) {
                           std::string name = info.param.first;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ThreadsWithSettings, KeepTheirOwn) { EXPECT_EQ(threads("settings"), threads("one")); }

}  // namespace
}  // namespace truequad::doors_test
