// truequad [OPTIONS] PROGRAM ARGS…: runs a program with truequad before its OpenGL and becomes it.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "config/options.h"
#include "doors/command/other_doors.h"

namespace {

namespace fs = std::filesystem;

// Statuses of our own; the last two as POSIX shells have them (XCU 2.8.2 "Exit Status for Commands").
constexpr int kBadArguments = 2, kCannotRun = 126, kNotFound = 127;

int complain(const std::string& text, int status) {
  std::fprintf(stderr, "truequad: %s\n", text.c_str());
  return status;
}

// The library beside this program (build tree), or where it was installed.
std::string find_library() {
  std::error_code error;
  const fs::path directory = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {".", TRUEQUAD_LIBRARY_DIRECTORY}) {
    const fs::path library = (directory / place / "libtruequad.so").lexically_normal();
    if (fs::exists(library, error)) return library;
  }
  return "";
}

// What the settings mean is said once, in config/options.cc; here a setting is only tried.
std::string check(const truequad::OptionRow& row, const std::string& text) {
  truequad::Options scratch;
  if (row.parse(text, scratch)) return "";
  return "must be " + std::string(row.accepts) + ", not '" + text + "'";
}

int become(std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  const int status = errno == ENOENT || errno == ENOTDIR ? kNotFound : kCannotRun;
  return complain(words[0] + ": " + std::strerror(errno), status);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs an OpenGL program so that its textured quadrilaterals are drawn correctly.", "truequad"};
  app.footer("The program and its own arguments follow: truequad [OPTIONS] PROGRAM [ARGUMENTS...]");
  app.set_version_flag("--version", "truequad " TRUEQUAD_VERSION);
  app.prefix_command();  // the first word that is no option of ours begins the program's own
  std::map<std::string, std::string> settings;
  bool no_dl = false, library_path = false, vendor = false;
  CLI::Option* by_library_path =
      app.add_flag("--library-path", library_path, "Instead of being preloaded, stand in the place of libGL and libOSMesa");
  app.add_flag("--no-dl", no_dl, "The same as --dl off");
  std::map<std::string, bool> switches;
  for (const truequad::OptionRow& row : truequad::option_rows()) {
    const std::string name = "--" + std::string(row.name);
    const std::string help = std::string(row.help) + ": " + std::string(row.accepts);
    if (row.accepts == truequad::kSwitchWords) {
      app.add_flag(name, switches[row.variable], std::string(row.help));
    } else if (row.accepts == truequad::kVendorWords) {
      app.add_flag(name, vendor, std::string(row.help))->excludes(by_library_path);
    } else {
      app.add_option_function<std::string>(
             name, [&settings, &row](const std::string& text) { settings[row.variable] = text; }, help)
          ->check([&row](const std::string& text) { return check(row, text); });
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return complain(std::string(error.what()) + " (see truequad --help)", kBadArguments);
  }
  std::vector<std::string> words = app.remaining();
  if (!words.empty() && words[0] == "--") {
    words.erase(words.begin());
  } else if (!words.empty() && words[0].starts_with("-")) {
    return complain("unknown option " + words[0] + " (see truequad --help)", kBadArguments);
  }
  if (words.empty()) return complain("which program? (see truequad --help)", kBadArguments);

  std::string preload = find_library();
  if (preload.empty()) return complain("libtruequad.so is not beside this command nor installed", kBadArguments);
  // ld.so(8): the names in LD_PRELOAD are separated by spaces or colons, and there is no way to quote them.
  if (preload.find_first_of(" :") != std::string::npos) {
    return complain("cannot be preloaded from " + preload + ": the path has a space or a colon", kBadArguments);
  }
  if (vendor || library_path) {
    const fs::path directory = fs::path(preload).parent_path();
    const std::string refusal = vendor ? truequad::become_vendor(directory) : truequad::stand_for_libraries(directory);
    if (!refusal.empty()) return complain(refusal, kBadArguments);
  } else {
    if (const char* others = std::getenv("LD_PRELOAD"); others && *others) preload += std::string(":") + others;
    ::setenv("LD_PRELOAD", preload.c_str(), 1);
  }
  if (truequad::is_privileged(words[0])) {
    std::fprintf(stderr, "truequad: %s runs with privileges of its own, so the dynamic linker leaves truequad out\n",
                 words[0].c_str());
  }
  for (const auto& [variable, on] : switches) {
    if (on) ::setenv(variable.c_str(), "1", 1);
  }
  if (no_dl) settings["TRUEQUAD_DL"] = "off";
  for (const auto& [variable, text] : settings) ::setenv(variable.c_str(), text.c_str(), 1);
  return become(words);
}
