#include "config/options.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <utility>

namespace truequad {
namespace {

static_assert(std::is_trivially_destructible_v<Options>, "nothing of ours runs when the host exits");

template <typename T, std::size_t count>
bool choose(std::string_view text, const std::pair<std::string_view, T> (&choices)[count], T& out) {
  for (const auto& [name, value] : choices) {
    if (name == text) {
      out = value;
      return true;
    }
  }
  return false;
}

constexpr std::pair<std::string_view, Mode> kModes[] = {{"bilinear", Mode::kBilinear},
                                                        {"projective", Mode::kProjective},
                                                        {"auto", Mode::kAuto},
                                                        {"paper", Mode::kPaper},
                                                        {"off", Mode::kOff}};

bool parse_log(std::string_view text, Options& options) {
  constexpr std::pair<std::string_view, LogLevel> kLevels[] = {
      {"quiet", LogLevel::kQuiet}, {"warning", LogLevel::kWarning}, {"info", LogLevel::kInfo}};
  return choose(text, kLevels, options.log_level);
}

bool parse_mode(std::string_view text, Options& options) { return choose(text, kModes, options.mode); }

bool parse_tolerance(std::string_view text, Options& options) {
  double value;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  if (!std::isfinite(value) || !(value > 0)) return false;
  options.tolerance_px = value;
  return true;
}

template <bool Options::*option>
bool parse_switch(std::string_view text, Options& options) {
  constexpr std::pair<std::string_view, bool> kSwitch[] = {{"0", false}, {"1", true}};
  return choose(text, kSwitch, options.*option);
}

bool parse_dl(std::string_view text, Options& options) {
  constexpr std::pair<std::string_view, DynamicLinker> kLevels[] = {
      {"off", DynamicLinker::kOff}, {"dlsym", DynamicLinker::kDlsym}, {"dlopen", DynamicLinker::kDlopen}};
  return choose(text, kLevels, options.dl);
}

bool parse_vendor(std::string_view text, Options& options) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos || text.size() >= sizeof options.vendor_glx) return false;
  const std::string_view glx = text.substr(0, colon), egl = text.substr(colon + 1);
  *std::copy(glx.begin(), glx.end(), options.vendor_glx) = '\0';
  *std::copy(egl.begin(), egl.end(), options.vendor_egl) = '\0';
  return true;
}

// A relative path means the folder in which the program was started, wherever it goes later.
bool parse_stats(std::string_view text, Options& options) {
  if (text.empty()) return false;
  char path[Options::kPathSize] = "";
  if (text != "-" && text[0] != '/') {
    if (!::getcwd(path, sizeof path - 1)) return false;
    std::strcat(path, "/");
  }
  const std::size_t prefix = std::strlen(path);
  // Room for ".<pid>" and ".tmp" behind it.
  if (prefix + text.size() + 32 > sizeof path) return false;
  std::copy(text.begin(), text.end(), path + prefix);
  path[prefix + text.size()] = '\0';
  std::memcpy(options.stats_path, path, sizeof path);
  return true;
}

// The log level comes first: it governs the complaints about the others.
constexpr std::array kRows = {
    OptionRow{"log", "TRUEQUAD_LOG", "warning", "quiet, warning or info", "what truequad says on stderr", parse_log},
    OptionRow{"mode", "TRUEQUAD_MODE", "bilinear", "bilinear, projective, auto, paper or off",
              "how quadrilaterals are corrected", parse_mode},
    OptionRow{"tolerance", "TRUEQUAD_TOLERANCE", "0.25", "a number of pixels above 0",
              "largest displacement of a texel in pixels", parse_tolerance},
    OptionRow{"stats", "TRUEQUAD_STATS", "", "a file name, or - for stderr",
              "where statistics are written (JSON) when the program ends", parse_stats},
    OptionRow{"color", "TRUEQUAD_COLOR", "0", kSwitchWords, "correct colours that kink along a diagonal too",
              parse_switch<&Options::color>},
    OptionRow{"overlay", "TRUEQUAD_OVERLAY", "0", kSwitchWords, "draw the mesh over corrected quadrilaterals",
              parse_switch<&Options::overlay>},
    OptionRow{"dl", "TRUEQUAD_DL", "dlsym", "off, dlsym or dlopen",
              "which of the dynamic linker's functions lead to truequad", parse_dl},
    OptionRow{"vendor", "TRUEQUAD_VENDOR", "", kVendorWords,
              "stand between libglvnd and the driver instead of being preloaded", parse_vendor},
};

}  // namespace

std::span<const OptionRow> option_rows() { return kRows; }

Options read_options(const char* (*lookup)(const char*)) {
  Options result;
  for (const OptionRow& row : kRows) {
    const char* text = lookup(row.variable);
    if (text && !row.parse(text, result)) {
      log_warning("%s='%s' is not %.*s; using %s%.*s", row.variable, text, int(row.accepts.size()), row.accepts.data(),
                  row.default_text.empty() ? "none" : "", int(row.default_text.size()), row.default_text.data());
    }
    log_level.store(result.log_level, std::memory_order_relaxed);
  }
  return result;
}

namespace {

Options& kept_options() {
  static Options kept = read_options([](const char* variable) -> const char* { return std::getenv(variable); });
  return kept;
}

}  // namespace

const Options& options() { return kept_options(); }

void stand_back() {
  Options& kept = kept_options();
  kept.mode = Mode::kOff;
  kept.color = kept.overlay = false;
  kept.stats_path[0] = '\0';
}

std::string_view mode_name(Mode mode) {
  for (const auto& [name, value] : kModes) {
    if (value == mode) return name;
  }
  return "unknown";
}

}  // namespace truequad
