// The truequad command: its arguments, its exit statuses and what it hands to the program (XCU 2.8.2 for 126 and 127).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "run.h"

namespace truequad::doors_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kCommand = TRUEQUAD_COMMAND, kLibrary = TRUEQUAD_LIBRARY;

Ended truequad(std::vector<std::string> words, const std::map<std::string, std::string>& environment = {}) {
  words.insert(words.begin(), kCommand);
  return run(words, environment);
}

// One clear line, and nothing for the program's own output.
void expect_complaint(const Ended& ended, int status, const std::string& about) {
  EXPECT_EQ(ended.status, status) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_THAT(ended.err, StartsWith("truequad: "));
  EXPECT_THAT(ended.err, HasSubstr(about));
}

TEST(Command, ReturnsTheStatusOfTheProgram) {
  for (int status : {0, 1, 2, 42, 126, 127, 255}) {
    const Ended ended = truequad({"sh", "-c", "echo out; echo err >&2; exit " + std::to_string(status)});
    EXPECT_EQ(ended.status, status);
    EXPECT_EQ(ended.out, "out\n");
    EXPECT_EQ(ended.err, "err\n");
  }
  EXPECT_EQ(truequad({"sh", "-c", "kill -TERM $$"}).status, 128 + 15);
}

TEST(Command, HandsItsSettingsOver) {
  const std::string show = "echo \"$TRUEQUAD_MODE|$TRUEQUAD_TOLERANCE|$TRUEQUAD_STATS|$TRUEQUAD_OVERLAY|$TRUEQUAD_LOG|$TRUEQUAD_DL|$TRUEQUAD_COLOR\"";
  const std::map<std::string, std::string> none = {{"TRUEQUAD_MODE", ""},    {"TRUEQUAD_TOLERANCE", ""},
                                                   {"TRUEQUAD_STATS", ""},   {"TRUEQUAD_OVERLAY", ""},
                                                   {"TRUEQUAD_LOG", ""},     {"TRUEQUAD_DL", ""},
                                                   {"TRUEQUAD_COLOR", ""}};
  EXPECT_EQ(truequad({"sh", "-c", show}, none).out, "||||||\n");
  EXPECT_EQ(truequad({"--no-dl", "sh", "-c", show}, none).out, "|||||off|\n");
  EXPECT_EQ(truequad({"--dl", "dlopen", "sh", "-c", show}, none).out, "|||||dlopen|\n");
  EXPECT_EQ(truequad({"--mode", "auto", "--tolerance", "0.5", "--stats", "a b", "--overlay", "sh", "-c", show}, none).out,
            "auto|0.5|a b|1|||\n");
  EXPECT_EQ(truequad({"--mode=paper", "--tolerance=2", "--stats=-", "sh", "-c", show}, none).out, "paper|2|-||||\n");
  EXPECT_EQ(truequad({"--log", "quiet", "sh", "-c", show}, none).out, "||||quiet||\n");
  EXPECT_EQ(truequad({"--color", "sh", "-c", show}, none).out, "||||||1\n");
  // What the environment says holds unless the command line says otherwise.
  EXPECT_EQ(truequad({"--mode", "off", "sh", "-c", show}, {{"TRUEQUAD_MODE", "paper"}, {"TRUEQUAD_TOLERANCE", "3"}}).out
                .substr(0, 6),
            "off|3|");
}

TEST(Command, PreloadsTheLibraryBeforeOthers) {
  const std::string show = "echo $LD_PRELOAD";
  EXPECT_EQ(truequad({"sh", "-c", show}, {{"LD_PRELOAD", ""}}).out, kLibrary + "\n");
  EXPECT_EQ(truequad({"sh", "-c", show}, {{"LD_PRELOAD", "libm.so.6"}}).out, kLibrary + ":libm.so.6\n");
}

TEST(Command, LeavesTheProgramItsArguments) {
  const std::vector<std::string> own = {"sh", "-c", "printf '<%s>' \"$@\"", "sh"};
  const auto shown = [&](std::vector<std::string> before, const std::vector<std::string>& after) {
    before.insert(before.end(), own.begin(), own.end());
    before.insert(before.end(), after.begin(), after.end());
    return truequad(before).out;
  };
  EXPECT_EQ(shown({}, {"--mode", "off", "--help", "--version", "-h"}), "<--mode><off><--help><--version><-h>");
  EXPECT_EQ(shown({"--mode", "off"}, {"--mode", "nonsense", "--unknown"}), "<--mode><nonsense><--unknown>");
  EXPECT_EQ(shown({"--overlay"}, {"", "a b", "--", "-x", "--overlay"}), "<><a b><--><-x><--overlay>");
  EXPECT_EQ(shown({"--"}, {"--", "x"}), "<--><x>");
  EXPECT_EQ(shown({"--mode", "off", "--"}, {"--stats=x"}), "<--stats=x>");
}

TEST(Command, KnowsHelpAndVersion) {
  const Ended help = truequad({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const char* word : {"--mode", "--tolerance", "--stats", "--overlay", "--color", "bilinear", "PROGRAM", "pixels"}) {
    EXPECT_THAT(help.out, HasSubstr(word));
  }
  const Ended version = truequad({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out, "truequad " TRUEQUAD_VERSION "\n");
  EXPECT_EQ(version.err, "");
}

TEST(Command, RefusesBadArguments) {
  expect_complaint(truequad({}), 2, "program");
  expect_complaint(truequad({"--mode", "off"}), 2, "program");
  expect_complaint(truequad({"--"}), 2, "program");
  expect_complaint(truequad({"--nonsense", "true"}), 2, "--nonsense");
  expect_complaint(truequad({"-x", "true"}), 2, "-x");
  expect_complaint(truequad({"--mode", "nonsense", "true"}), 2, "nonsense");
  expect_complaint(truequad({"--mode", "OFF", "true"}), 2, "OFF");
  expect_complaint(truequad({"--mode"}), 2, "--mode");
  expect_complaint(truequad({"--mode=", "true"}), 2, "--mode");
  for (const char* tolerance : {"-1", "0", "abc", "", "nan", "inf", "1px", "1e999", " 1"}) {
    expect_complaint(truequad({"--tolerance", tolerance, "true"}), 2, "--tolerance");
  }
  expect_complaint(truequad({"--stats", "", "true"}), 2, "--stats");
  expect_complaint(truequad({"--overlay=maybe", "true"}), 2, "--overlay");
  expect_complaint(truequad({"--dl", "on", "true"}), 2, "--dl");
  for (const char* level : {"loud", "", "Quiet"}) expect_complaint(truequad({"--log", level, "true"}), 2, "--log");
  expect_complaint(truequad({"--stats", std::string(5000, 'x'), "true"}), 2, "--stats");
  // Twice is no decision.
  expect_complaint(truequad({"--mode", "off", "--mode", "auto", "true"}), 2, "--mode");
}

TEST(Command, SaysAsAShellWhenTheProgramCannotRun) {
  const Scratch scratch;
  expect_complaint(truequad({"no-such-program-here"}), 127, "no-such-program-here");
  expect_complaint(truequad({(scratch / "missing").string()}), 127, "missing");
  std::ofstream(scratch / "plain") << "not a program\n";
  fs::permissions(scratch / "plain", fs::perms::owner_read);
  expect_complaint(truequad({(scratch / "plain").string()}), 126, "plain");
  expect_complaint(truequad({scratch.path().string()}), 126, scratch.path().string());
  expect_complaint(truequad({(scratch / "plain").string() + "/below"}), 127, "below");
}

// The vendors are files here, so that the test knows which there are.
TEST(Command, StandsBetweenLibglvndAndTheDriver) {
  const Scratch scratch;
  const std::string one = scratch / "one.json", two = scratch / "two.json";
  std::ofstream(one) << "{ \"ICD\" : { \"library_path\" : \"libEGL_mesa.so.0\" } }";
  std::ofstream(two) << "{ \"ICD\" : { \"library_path\" : \"libEGL_two.so.0\" } }";
  const std::string show = "echo \"$TRUEQUAD_VENDOR|$__GLX_VENDOR_LIBRARY_NAME|$LD_PRELOAD\"";
  const std::map<std::string, std::string> known = {{"__GLX_VENDOR_LIBRARY_NAME", "mesa"},
                                                    {"__EGL_VENDOR_LIBRARY_FILENAMES", one},
                                                    {"TRUEQUAD_VENDOR", ""},
                                                    {"LD_PRELOAD", ""}};
  EXPECT_EQ(truequad({"--vendor", "sh", "-c", show}, known).out, "libGLX_mesa.so.0:libEGL_mesa.so.0|truequad|\n");
  // A program that was started like this starts another one.
  EXPECT_EQ(truequad({"--vendor", kCommand, "--vendor", "sh", "-c", show}, known).out,
            "libGLX_mesa.so.0:libEGL_mesa.so.0|truequad|\n");
  auto unknown = known;
  unknown["__EGL_VENDOR_LIBRARY_FILENAMES"] = one + ":" + two;
  expect_complaint(truequad({"--vendor", "true"}, unknown), 2, "libEGL_mesa.so.0, libEGL_two.so.0");
  // There is one, and it cannot be loaded.
  unknown["__EGL_VENDOR_LIBRARY_FILENAMES"] = two;
  expect_complaint(truequad({"--vendor", "true"}, unknown), 2, "libEGL_two.so.0");
  unknown = known;
  unknown["__GLX_VENDOR_LIBRARY_NAME"] = "two";
  expect_complaint(truequad({"--vendor", "true"}, unknown), 2, "libGLX_two.so.0");
  // Two libraries of GLX.
  unknown = known;
  unknown["__GLX_VENDOR_LIBRARY_NAME"] = "";
  unknown["LD_LIBRARY_PATH"] = scratch.path();
  for (const char* name : {"libGLX_one.so.0", "libGLX_two.so.0"}) std::ofstream(scratch / name) << "";
  expect_complaint(truequad({"--vendor", "true"}, unknown), 2, "__GLX_VENDOR_LIBRARY_NAME");
}

TEST(Command, StandsForTheLibrariesThatItWasBuiltFor) {
  const std::string show = "echo \"$LD_LIBRARY_PATH|$LD_PRELOAD\"";
  const std::map<std::string, std::string> none = {{"LD_PRELOAD", ""}, {"LD_LIBRARY_PATH", ""}};
  const std::string place = fs::path(kLibrary).parent_path() / "truequad-libraries";
  EXPECT_EQ(truequad({"--library-path", "sh", "-c", show}, none).out, place + "|\n");
  EXPECT_EQ(truequad({"--library-path", kCommand, "--library-path", "sh", "-c", show}, none).out, place + "|\n");
  // Another libGL comes first here.
  const Scratch scratch;
  fs::copy_file(kLibrary, scratch / "libGL.so.1");
  expect_complaint(truequad({"--library-path", "true"}, {{"LD_PRELOAD", ""}, {"LD_LIBRARY_PATH", scratch.path()}}), 2,
                   "libGL.so.1 is");
  expect_complaint(truequad({"--library-path", "--vendor", "true"}), 2, "--library-path");
}

// Root makes a program that is somebody else's; anybody else finds one that is root's.
std::string privileged_program(const Scratch& scratch) {
  if (::getuid() != 0) return "/usr/bin/su";
  const std::string program = scratch / "privileged";
  fs::copy_file("/bin/true", program);
  EXPECT_EQ(::chown(program.c_str(), 65534, 65534), 0);
  EXPECT_EQ(::chmod(program.c_str(), 04755), 0);
  fs::permissions(scratch.path(), fs::perms::owner_all | fs::perms::others_exec | fs::perms::group_exec);
  return program;
}

// With privileges of its own a program gets neither; it runs all the same.
TEST(Command, SaysThatAProgramHasPrivileges) {
  const Scratch scratch;
  const std::string program = privileged_program(scratch);
  const Ended ended = truequad({program, "--version"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("privileges"));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
}

// Where no process may gain privileges it has none, and is reached.
TEST(Command, SaysNothingOfPrivilegesThatAreNotGiven) {
  const Scratch scratch;
  const Ended ended = run({"setpriv", "--no-new-privs", kCommand, privileged_program(scratch), "--version"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
}

TEST(Command, FindsTheLibraryWhereItWasInstalled) {
  const Scratch scratch;
  fs::create_directories(scratch / "bin");
  fs::create_directories(scratch / "bin" / TRUEQUAD_LIBRARY_FROM_COMMAND);
  fs::copy_file(kCommand, scratch / "bin" / "truequad");
  fs::copy_file(kLibrary, scratch.path() / "bin" / TRUEQUAD_LIBRARY_FROM_COMMAND / "libtruequad.so");
  const std::vector<std::string> show = {(scratch / "bin" / "truequad").string(), "sh", "-c", "echo $LD_PRELOAD"};
  const std::string expected =
      (scratch.path() / "bin" / TRUEQUAD_LIBRARY_FROM_COMMAND / "libtruequad.so").lexically_normal().string() + "\n";
  EXPECT_EQ(run(show, {{"LD_PRELOAD", ""}}).out, expected);
  // Through a link, as people put commands into their path.
  fs::create_symlink(scratch / "bin" / "truequad", scratch / "linked");
  EXPECT_EQ(run({(scratch / "linked").string(), "sh", "-c", "echo $LD_PRELOAD"}, {{"LD_PRELOAD", ""}}).out, expected);
}

TEST(Command, SaysThatTheLibraryIsMissing) {
  const Scratch scratch;
  fs::copy_file(kCommand, scratch / "truequad");
  expect_complaint(run({(scratch / "truequad").string(), "true"}), 2, "libtruequad.so");
}

TEST(Command, SaysThatTheLinkerCannotTakeThePath) {
  for (const char* name : {"with space", "with:colon"}) {
    const Scratch scratch;
    fs::create_directory(scratch / name);
    fs::copy_file(kCommand, scratch / name / "truequad");
    fs::copy_file(kLibrary, scratch / name / "libtruequad.so");
    expect_complaint(run({(scratch / name / "truequad").string(), "true"}), 2, name);
  }
}

}  // namespace
}  // namespace truequad::doors_test
