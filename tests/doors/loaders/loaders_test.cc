// Every small program here through every door, against the table of docs/doors.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
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
  if (words.back() == "deepbind" && words[words.size() - 2].ends_with("egl")) environment["EGL_PLATFORM"] = "surfaceless";
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

}  // namespace
}  // namespace truequad::doors_test
