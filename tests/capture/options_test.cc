// Settings: what is accepted, and that anything else costs one clear line and leaves the default.
#include "config/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <string>

namespace truequad {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::map<std::string, std::string> environment;
const char* look_up(const char* variable) {
  const auto found = environment.find(variable);
  return found == environment.end() ? nullptr : found->second.c_str();
}

struct Result {
  Options options;
  std::string complaints;
};
Result read(std::map<std::string, std::string> settings) {
  environment = std::move(settings);
  testing::internal::CaptureStderr();
  Result result{read_options(look_up), ""};
  result.complaints = testing::internal::GetCapturedStderr();
  log_level = LogLevel::kWarning;
  return result;
}

TEST(Options, DefaultsNeedNoEnvironment) {
  const Result r = read({});
  EXPECT_EQ(r.options.mode, Mode::kBilinear);
  EXPECT_EQ(r.options.tolerance_px, 0.25);
  EXPECT_STREQ(r.options.stats_path, "");
  EXPECT_FALSE(r.options.overlay);
  EXPECT_FALSE(r.options.color);
  EXPECT_THAT(r.complaints, IsEmpty());
}

TEST(Options, GoodSettingsAreTaken) {
  const Result r = read({{"TRUEQUAD_MODE", "projective"},
                         {"TRUEQUAD_TOLERANCE", "1.5e-1"},
                         {"TRUEQUAD_STATS", "/tmp/x.json"},
                         {"TRUEQUAD_OVERLAY", "1"},
                         {"TRUEQUAD_COLOR", "1"},
                         {"TRUEQUAD_LOG", "info"}});
  EXPECT_EQ(r.options.mode, Mode::kProjective);
  EXPECT_EQ(r.options.tolerance_px, 0.15);
  EXPECT_STREQ(r.options.stats_path, "/tmp/x.json");
  EXPECT_TRUE(r.options.overlay);
  EXPECT_TRUE(r.options.color);
  EXPECT_EQ(r.options.log_level, LogLevel::kInfo);
  EXPECT_THAT(r.complaints, IsEmpty());
}

TEST(Options, ARelativePathStaysWhereTheProgramStarted) {
  char here[4096];
  ASSERT_TRUE(::getcwd(here, sizeof here));
  EXPECT_EQ(read({{"TRUEQUAD_STATS", "x.json"}}).options.stats_path, std::string(here) + "/x.json");
  EXPECT_STREQ(read({{"TRUEQUAD_STATS", "-"}}).options.stats_path, "-");
}

TEST(Options, EachBadSettingCostsOneLineAndLeavesTheDefault) {
  const std::pair<const char*, const char*> bad[] = {
      {"TRUEQUAD_TOLERANCE", "-1"},  {"TRUEQUAD_TOLERANCE", "abc"}, {"TRUEQUAD_TOLERANCE", ""},
      {"TRUEQUAD_TOLERANCE", "nan"}, {"TRUEQUAD_TOLERANCE", "inf"}, {"TRUEQUAD_TOLERANCE", "0"},
      {"TRUEQUAD_TOLERANCE", "1px"}, {"TRUEQUAD_TOLERANCE", " 1"},  {"TRUEQUAD_TOLERANCE", "1e999"},
      {"TRUEQUAD_MODE", ""},         {"TRUEQUAD_MODE", "Bilinear"}, {"TRUEQUAD_OVERLAY", "yes"}, {"TRUEQUAD_COLOR", "2"},
      {"TRUEQUAD_LOG", "loud"},      {"TRUEQUAD_STATS", ""}};
  for (const auto& [variable, text] : bad) {
    const Result r = read({{variable, text}});
    EXPECT_EQ(r.options.tolerance_px, 0.25) << variable << "=" << text;
    EXPECT_EQ(r.options.mode, Mode::kBilinear);
    EXPECT_STREQ(r.options.stats_path, "");
    EXPECT_FALSE(r.options.overlay);
    EXPECT_EQ(std::count(r.complaints.begin(), r.complaints.end(), '\n'), 1) << r.complaints;
    EXPECT_THAT(r.complaints, HasSubstr("truequad: " + std::string(variable) + "='" + text + "' is not"));
  }
  EXPECT_EQ(read({{"TRUEQUAD_STATS", std::string(5000, 'x').c_str()}}).options.stats_path, std::string());
}

TEST(Options, QuietIsQuietAboutBadSettingsToo) {
  EXPECT_THAT(read({{"TRUEQUAD_LOG", "quiet"}, {"TRUEQUAD_TOLERANCE", "abc"}}).complaints, IsEmpty());
}

TEST(Options, AnEndlessSettingIsCutToOneLine) {
  const Result r = read({{"TRUEQUAD_MODE", std::string(100000, 'x').c_str()}});
  EXPECT_EQ(std::count(r.complaints.begin(), r.complaints.end(), '\n'), 1);
  EXPECT_LT(r.complaints.size(), 1100u);
}

TEST(Options, TheTableNamesEachVariableOnce) {
  std::map<std::string, int> seen;
  for (const OptionRow& row : option_rows()) {
    EXPECT_EQ(std::string(row.variable).rfind("TRUEQUAD_", 0), 0u);
    EXPECT_EQ(++seen[row.variable], 1);
    EXPECT_FALSE(row.help.empty());
    Options options;
    if (!row.default_text.empty()) {
      EXPECT_TRUE(row.parse(row.default_text, options)) << row.variable;
    }
  }
}

}  // namespace
}  // namespace truequad
