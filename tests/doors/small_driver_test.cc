// A driver without functions, no driver at all, a hundred thousand contexts, and the library loaded twice: nothing crashes,
// nothing grows, and what is missing is said once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "run.h"

namespace truequad::doors_test {
namespace {

namespace fs = std::filesystem;
const std::string kLibrary = TRUEQUAD_PRELOAD, kDriver = TRUEQUAD_SMALL_DRIVER;

// Without the door of dlsym(), which shows only what the driver has: here all of our doors are called.
Ended small_program(const std::string& preload, const std::vector<std::string>& arguments, const std::string& log = "") {
  std::vector<std::string> words = {TRUEQUAD_SMALL_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run(words, {{"LD_PRELOAD", preload}, {"TRUEQUAD_LOG", log}, {"TRUEQUAD_DL", "off"}});
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

TEST(SmallDriver, WithoutADriverEveryCommandDoesNothing) {
  const Ended ended = small_program(kLibrary, {"none"});
  EXPECT_EQ(ended.status, 0) << ended.out;
}

TEST(SmallDriver, WithoutADriverContextsAreRefusedAndThatIsSaidOnce) {
  const Ended ended = small_program(kLibrary, {"no-window"});
  EXPECT_EQ(ended.status, 0) << ended.out;
  EXPECT_THAT(lines(ended.err),
              ::testing::ElementsAre("truequad: no library of this process has OSMesaCreateContext; calls to it do nothing",
                                     "truequad: no library of this process has OSMesaMakeCurrent; calls to it do nothing"));
}

TEST(SmallDriver, WhatItLacksDoesNothingAndIsSaidOnce) {
  const Ended ended = small_program(kLibrary + ":" + kDriver, {"all"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err.substr(0, 2000);
  std::vector<std::string> said = lines(ended.err);
  EXPECT_GT(said.size(), 3000u);  // as many as the registry has, less the driver's own
  for (const std::string& line : said) EXPECT_THAT(line, ::testing::StartsWith("truequad: "));
  std::sort(said.begin(), said.end());
  const auto twice = std::adjacent_find(said.begin(), said.end());
  EXPECT_EQ(twice, said.end()) << *twice;
}

// Asked by dlsym() in the global scope, a name that no library has is not there, and so dlerror() says.
TEST(SmallDriver, WhatItLacksIsNotThereForDlsym) {
  for (const auto& [preload, check] : {std::pair(kLibrary, "nothing"), {kLibrary + ":" + kDriver, "own"}}) {
    const Ended natively = run({TRUEQUAD_SMALL_PROGRAM, check}, {{"LD_PRELOAD", check == std::string("own") ? kDriver : ""}});
    EXPECT_EQ(natively.status, 0) << natively.out;
    const Ended ended = run({TRUEQUAD_SMALL_PROGRAM, check}, {{"LD_PRELOAD", preload}});
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_EQ(ended.out, natively.out);
    EXPECT_EQ(ended.err, "");
  }
}

TEST(SmallDriver, NothingIsSaidIfThatIsWanted) {
  const Ended ended = small_program(kLibrary + ":" + kDriver, {"all"}, "quiet");
  EXPECT_EQ(ended.status, 0) << ended.out;
  EXPECT_EQ(ended.err, "");
}

TEST(SmallDriver, GetsTheQuadsOfAProgram) {
  for (const char* mode : {"bilinear", "projective", "auto", "paper", "off"}) {
    const Ended ended = run({TRUEQUAD_SMALL_PROGRAM, "quads"},
                            {{"LD_PRELOAD", kLibrary + ":" + kDriver}, {"TRUEQUAD_MODE", mode}});
    EXPECT_EQ(ended.status, 0) << mode << ": " << ended.err;
  }
}

TEST(SmallDriver, AHundredThousandContextsLeaveNothingBehind) {
  const Ended ended = small_program(kLibrary + ":" + kDriver, {"contexts", "100000"}, "quiet");
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
}

// Another copy, as a program may find one in its own directory and one in LD_PRELOAD.
TEST(LoadedTwice, StillReachesTheDriver) {
  const Scratch scratch;
  fs::copy_file(TRUEQUAD_LIBRARY, scratch / "libtruequad.so");
  const std::string preload = kLibrary + ":" + (scratch / "libtruequad.so").string() + ":" + kDriver;
  for (const std::vector<std::string>& check :
       {std::vector<std::string>{"quads"}, {"all"}, {"contexts", "1000"}}) {
    const Ended ended = small_program(preload, check, "quiet");
    EXPECT_EQ(ended.status, 0) << check[0] << ": " << ended.out << ended.err.substr(0, 2000);
  }
  // The same file named twice is loaded once.
  EXPECT_EQ(small_program(kLibrary + ":" + kLibrary + ":" + kDriver, {"quads"}, "quiet").status, 0);
}

}  // namespace
}  // namespace truequad::doors_test
