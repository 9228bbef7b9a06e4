// Every small program here through every door, against the table of docs/doors.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../run.h"

namespace truequad::doors_test {
namespace {

using Words = std::vector<std::string>;

const std::string kDirectory = LOADERS_DIRECTORY, kPlugIn = LOADERS_PLUG_IN;

Words loader(const std::string& name, const Words& arguments = {}) {
  Words words = {kDirectory + "/loader_" + name};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

// The rows of the table, in its order.
const std::vector<std::pair<std::string, Words>> kPrograms = {
    {"linked with libGL", loader("linked")},
    {"GLUT", loader("glut")},
    {"GLEW, shared", loader("glew")},
    {"GLEW, static", loader("glew_static")},
    {"GLFW", loader("glfw")},
    {"SDL2", loader("sdl")},
    {"SDL2's loader", loader("sdl", {"loader"})},
    {"libepoxy", loader("epoxy")},
    {"`dlsym` on a local libGL", loader("raw", {"local"})},
    {"`dlsym` on a deeply bound libGL", loader("raw", {"deepbind"})},
    {"`glXGetProcAddress` of a deeply bound libGL", loader("raw", {"deepbind", "get-proc-address"})},
    {"local plug-in linked with libGL", {LOADERS_PLUG_IN_HOST, "local", kPlugIn}},
    {"deeply bound plug-in linked with libGL", {LOADERS_PLUG_IN_HOST, "deepbind", kPlugIn}},
    {"program with functions of these names", loader("own_functions")},
    {"program with variables of these names", loader("own_variables")},
    {"plug-in with variables of these names", {LOADERS_PLUG_IN_HOST, "local", LOADERS_OWN_PLUG_IN}},
    {"linked with libOSMesa", loader("osmesa_linked")},
    {"`dlsym` on a deeply bound libOSMesa", loader("osmesa", {"deepbind"})},
    {"`eglGetProcAddress` of a deeply bound libEGL", loader("egl", {"deepbind"})},
};

// The columns: the words of the command.
const std::vector<std::pair<std::string, Words>> kDoors = {
    {"`--no-dl`", {"--no-dl"}},
    {"(default)", {}},
    {"`--dl dlopen`", {"--dl", "dlopen"}},
    {"`--vendor`", {"--vendor"}},
    {"`--library-path`", {"--library-path"}},
};

Ended run_steadily(const Words& words, std::map<std::string, std::string> environment = {}) {
  environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
  if (words.size() > 1 && words[words.size() - 2].ends_with("egl")) environment["EGL_PLATFORM"] = "surfaceless";
  return run(words, environment);
}

int corrected_in(const std::string& file) {
  const auto stats = nlohmann::json::parse(read_file(file), nullptr, false);
  return stats.is_object() ? stats.value("corrected", -1) : 0;
}

std::string markdown_row(const Words& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

TEST(Doors, ReachWhatTheTableSays) {
  const std::string natively = run_steadily(loader("linked"), {{"LD_PRELOAD", ""}}).out;
  ASSERT_THAT(natively, ::testing::HasSubstr("drawn, error 0"));
  Words header = {"program"};
  for (const auto& [name, words] : kDoors) header.push_back(name);
  std::string table, corrected_picture;
  table = markdown_row(header) + "|";
  for (std::size_t i = 0; i < header.size(); ++i) table += "---|";
  table += "\n";
  for (const auto& [name, program] : kPrograms) {
    Words cells = {name};
    for (const auto& [door, options] : kDoors) {
      SCOPED_TRACE(name + " by " + door);
      const Scratch scratch;
      Words words = {TRUEQUAD_COMMAND, "--stats", scratch / "stats"};
      words.insert(words.end(), options.begin(), options.end());
      words.insert(words.end(), program.begin(), program.end());
      const Ended ended = run_steadily(words);
      if (ended.status == 128 + SIGSEGV) {
        cells.push_back("breaks");
        continue;
      }
      EXPECT_EQ(ended.status, 0) << ended.err;
      EXPECT_THAT(ended.err, ::testing::Not(::testing::HasSubstr("truequad:")));
      const int corrected = corrected_in(scratch / "stats");
      cells.push_back(corrected == 1 ? "yes" : "no");
      if (corrected == 0) {
        EXPECT_EQ(ended.out, natively);
        continue;
      }
      EXPECT_EQ(corrected, 1);
      EXPECT_NE(ended.out, natively);
      if (corrected_picture.empty()) corrected_picture = ended.out;
      EXPECT_EQ(ended.out, corrected_picture);
    }
    table += markdown_row(cells);
  }
  EXPECT_THAT(read_file(LOADERS_DOCUMENT), ::testing::HasSubstr(table)) << "measured:\n" << table;
}

// ---- Others in LD_PRELOAD ------------------------------------------------------------------------------------------------

const std::string kLibrary = LOADERS_LIBRARY, kClock = LOADERS_STEADY;

// Before us apitrace records the program's calls, behind us what we draw: so these traces are longer.
TEST(Neighbours, ApitraceRecordsInEitherOrder) {
  const std::string corrected = run_steadily(loader("linked"), {{"LD_PRELOAD", kLibrary}}).out;
  ASSERT_NE(corrected, run_steadily(loader("linked"), {{"LD_PRELOAD", ""}}).out);
  for (const auto& [program, tracer] : {std::pair(loader("linked"), std::string(LOADERS_GLXTRACE)),
                                        {loader("raw", {"local"}), LOADERS_GLXTRACE},
                                        {loader("egl", {"local"}), LOADERS_EGLTRACE}}) {
    const Scratch scratch;
    const auto traced = [&](const std::string& preload, const std::string& name) {
      const Ended ended = run_steadily(program, {{"LD_PRELOAD", preload}, {"TRACE_FILE", scratch / name}});
      EXPECT_EQ(ended.status, 0) << ended.err;
      EXPECT_THAT(ended.err, ::testing::Not(::testing::HasSubstr("truequad:")));
      EXPECT_EQ(ended.out, corrected) << program[0] << " " << name;
      return read_file(scratch / name).size();
    };
    const std::size_t before = traced(tracer + ":" + kLibrary, "before"), behind = traced(kLibrary + ":" + tracer, "behind");
    EXPECT_GT(before, 1000u) << program[0];
    EXPECT_GT(behind, before + 1000) << program[0];
  }
}

// Two copies of truequad in one process: the first works, the other passes everything on. One door within another: one is enough.
TEST(Copies, OneWorks) {
  const std::string corrected = run_steadily(loader("linked"), {{"LD_PRELOAD", kLibrary}}).out;
  const Scratch scratch;
  const std::string copy = scratch / "libtruequad-copy.so";
  std::ofstream(copy, std::ios::binary) << read_file(kLibrary);
  const auto within = [](const Words& outer, const Words& inner, const Words& program) {
    Words words = {TRUEQUAD_COMMAND};
    words.insert(words.end(), outer.begin(), outer.end());
    if (!inner.empty()) words.insert(words.end(), inner.begin(), inner.end());
    words.insert(words.end(), program.begin(), program.end());
    return words;
  };
  const Words preloading = {TRUEQUAD_COMMAND};
  const Words library_path = {TRUEQUAD_COMMAND, "--library-path"}, vendor = {TRUEQUAD_COMMAND, "--vendor"};
  const struct {
    const char* name;
    std::string preload;
    Words words;
  } kCases[] = {
      {"preloaded twice", kLibrary + ":" + copy, loader("linked")},
      {"preloaded before libraries", kLibrary, within({"--library-path"}, {}, loader("linked"))},
      {"preloaded before a vendor", kLibrary, within({"--vendor"}, {}, loader("linked"))},
      {"a copy before a vendor", copy, within({"--vendor"}, {}, loader("linked"))},
      {"preloaded within libraries", "", within({"--library-path"}, preloading, loader("linked"))},
      {"preloaded within a vendor", "", within({"--vendor"}, preloading, loader("linked"))},
      {"libraries within a vendor", "", within({"--vendor"}, library_path, loader("linked"))},
      {"a vendor within libraries", "", within({"--library-path"}, vendor, loader("linked"))},
      {"preloaded before libraries, raw", kLibrary, within({"--library-path"}, {}, loader("raw", {"local"}))},
      {"preloaded before libraries, OSMesa", kLibrary, within({"--library-path"}, {}, loader("osmesa_linked"))},
  };
  for (const auto& [name, preload, words] : kCases) {
    SCOPED_TRACE(name);
    const Ended ended = run_steadily(words, {{"LD_PRELOAD", preload}, {"TRUEQUAD_STATS", "-"}});
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.out, corrected);
    // Written once, by the copy that counted.
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    const auto stats = nlohmann::json::parse(ended.err, nullptr, false);
    EXPECT_TRUE(stats.is_object() && stats.value("corrected", -1) == 1) << ended.err;
  }
}

// The preloaded clock of tests/programs, which also ends the process, by _exit, at the frame's end.
TEST(Neighbours, AClockMayStandOnEitherSide) {
  const std::string before = kClock + ":" + kLibrary, behind = kLibrary + ":" + kClock;
  std::map<std::string, std::string> pictures;
  for (const std::string& preload : {kClock, before, behind}) {
    const Scratch scratch;
    const Ended ended = run_steadily(loader("glut"), {{"LD_PRELOAD", preload},
                                                      {"STEADY_FRAMES", "1"},
                                                      {"STEADY_OUT", scratch / "frame"},
                                                      {"TRUEQUAD_STATS", scratch / "stats"}});
    EXPECT_EQ(ended.status, 0) << preload << ended.err;
    EXPECT_EQ(ended.err, "") << preload;
    EXPECT_THAT(read_file(scratch / "frame.log"), ::testing::EndsWith("errors none\n")) << preload;
    pictures[preload] = read_file(scratch / "frame-1.png");
    EXPECT_EQ(corrected_in(scratch / "stats"), preload == kClock ? 0 : 1) << preload;
  }
  EXPECT_NE(pictures[before], "");
  EXPECT_EQ(pictures[before], pictures[behind]);
  EXPECT_NE(pictures[before], pictures[kClock]);
}

}  // namespace
}  // namespace truequad::doors_test
