// The settings, one table of them: name, environment variable, default, parser and help (options.cc).
#pragma once

#include <span>
#include <string_view>

#include "config/log.h"
#include "truequad/kernel.h"

namespace truequad {

// Which functions of the dynamic linker find our doors: none, dlsym(3), or dlopen(3) too.
enum class DynamicLinker : unsigned char { kOff, kDlsym, kDlopen };

struct Options {
  static constexpr int kPathSize = 4096;

  LogLevel log_level = LogLevel::kWarning;
  Mode mode = Mode::kBilinear;
  double tolerance_px = 0.25;
  bool overlay = false;
  bool color = false;
  DynamicLinker dl = DynamicLinker::kDlsym;
  // The driver's vendor libraries, for truequad as a vendor of libglvnd; empty if there is none.
  char vendor_glx[kPathSize] = "", vendor_egl[kPathSize] = "";
  // Where the statistics go: absolute path, "-" for stderr, empty for nowhere.
  char stats_path[kPathSize] = "";
};

// A row of the table.
struct OptionRow {
  std::string_view name;         // of the command line option, without dashes
  const char* variable;          // of the environment
  std::string_view default_text;
  std::string_view accepts;      // what may be given, for help and complaints
  std::string_view help;
  bool (*parse)(std::string_view text, Options& options);  // false: not acceptable, options unchanged
};
std::span<const OptionRow> option_rows();
// What OptionRow::accepts says of a switch, which is a flag of the command.
inline constexpr std::string_view kSwitchWords = "0 or 1";
// And of a row that is a flag of the command too, which finds out what the library is to read.
inline constexpr std::string_view kVendorWords = "the driver's vendor libraries, GLX:EGL";

// The settings of this process. The environment is read once, at the first call; a bad setting costs one line on
// stderr and leaves the default. May be called from any thread.
const Options& options();

// Another copy of this library does the work: from now on nothing is corrected, counted or written.
void stand_back();

// What options() does, without keeping the result: for tests.
Options read_options(const char* (*lookup)(const char* variable));

std::string_view mode_name(Mode mode);

}  // namespace truequad
