// Contexts that are made with flags: debug (nothing is heard of us, in any order), robust, without errors. Needs a display for GLX.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "run.h"

namespace truequad::doors_test {
namespace {

using Lines = std::vector<std::string>;

Lines flags(const Lines& words, const std::map<std::string, std::string>& settings) {
  Lines all = {TRUEQUAD_FLAGS};
  all.insert(all.end(), words.begin(), words.end());
  std::map<std::string, std::string> environment = settings;
  environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
  // Else the first run compiles shaders, which Mesa tells debug contexts of, and later ones find them.
  environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  const bool no_error = std::find(words.begin(), words.end(), "no-error") != words.end();
  environment["MESA_NO_ERROR"] = no_error ? "1" : "";
  const Ended ended = run(all, environment);
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  Lines lines;
  std::istringstream in(ended.out);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The line "picture …", taken out.
std::string take_picture(Lines& lines) {
  const auto found = std::find_if(lines.begin(), lines.end(), [](const auto& line) { return line.starts_with("picture "); });
  if (found == lines.end()) return "";
  const std::string picture = *found;
  lines.erase(found);
  return picture;
}

// GL_CONTEXT_FLAGS as the driver has them.
unsigned context_flags(const Lines& lines) {
  return lines.empty() ? ~0u : unsigned(std::stoul(lines[0].substr(lines[0].rfind(' ') + 1), nullptr, 16));
}

class Flags : public testing::TestWithParam<Lines> {};

TEST_P(Flags, AreKeptAndNothingElseIsNoticed) {
  const Scratch scratch;
  Lines native = flags(GetParam(), {{"LD_PRELOAD", ""}});
  for (const auto& [word, bit] : {std::pair{"debug", 2u}, {"robust", 4u}, {"no-error", 8u}}) {
    const bool wanted = std::find(GetParam().begin(), GetParam().end(), word) != GetParam().end();
    EXPECT_EQ((context_flags(native) & bit) != 0, wanted) << word;
  }
  EXPECT_EQ(flags(GetParam(), {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_MODE", "off"}}), native);
  Lines seen = flags(GetParam(), {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_STATS", scratch / "stats"}});
  const std::string before = take_picture(native), after = take_picture(seen);
  EXPECT_NE(before, "");
  EXPECT_NE(before, after);
  EXPECT_EQ(seen, native);
  const auto stats = nlohmann::json::parse(read_file(scratch / "stats"), nullptr, false);
  ASSERT_TRUE(stats.is_object());
  EXPECT_EQ(stats.value("corrected", -1), 9);
}

TEST(DebugFlag, LetsTheProgramHearItsOwnErrors) {
  const Lines heard = flags({"egl", "debug"}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}});
  const auto errors = std::count_if(heard.begin(), heard.end(), [](const auto& line) { return line.starts_with("  message 0x8246 0x824c"); });
  EXPECT_GE(errors, 8);
}

const Lines kFlags[] = {{"egl"},           {"egl", "debug"},           {"egl", "robust"}, {"egl", "no-error"},
                        {"egl", "debug", "robust"}, {"glx"},           {"glx", "debug"},  {"glx", "robust"},
                        {"glx", "no-error"}};
INSTANTIATE_TEST_SUITE_P(Contexts, Flags, testing::ValuesIn(kFlags), [](const auto& info) {
  std::string name;
  for (const std::string& word : info.param) name += name.empty() ? word : "_" + word;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace truequad::doors_test
