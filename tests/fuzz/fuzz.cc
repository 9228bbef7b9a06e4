// fuzz [--first N] [--trials N] [--seconds S] [--findings N] [--shrink S] [--corrected N] [--kinds 0123]: random sequences of
// OpenGL calls without and with truequad, until the time or the trials are over, or so many findings were made (1). Each is shrunk for S seconds (30) and
// printed; 0: only named. Exit 1 if any was, or if quads were corrected in fewer than so many sequences (0).
// fuzz --first N --write FILE: writes that sequence, for fuzz_program --file FILE --print.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "compare.h"

namespace truequad::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

struct Settings {
  std::uint64_t first = 1, trials = ~std::uint64_t(0);
  double seconds = 1e9;
  int findings = 1;
  std::uint64_t corrected = 0;
  double shrink_seconds = 30;
  std::string write;
  std::string kinds = "0123";
};

struct Tally {
  std::uint64_t trials = 0, native_crashes = 0, unsteady = 0, with_corrected = 0, corrected = 0;
  int findings = 0;
};

class Fuzz {
 public:
  Fuzz(const Programs& programs, const Settings& settings) : programs_(programs), settings_(settings) {}

  int run() {
    const auto begin = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    std::uint64_t trial = settings_.first;
    const std::uint64_t end = settings_.trials > ~trial ? ~std::uint64_t(0) : trial + settings_.trials;
    while (trial < end && elapsed() < settings_.seconds && tally_.findings < settings_.findings) {
      const std::uint64_t next = std::min(end, (trial / kBlock + 1) * kBlock);
      if (settings_.kinds.find(char('0' + int(kind_of(trial)))) != std::string::npos) block(trial, next);
      trial = next;
    }
    std::printf("%llu sequences from %llu on in %.0f s: %d findings; %llu quads corrected in %llu of them; the driver alone crashed in %llu, and was "
                "not steady in %llu\n",
                static_cast<unsigned long long>(tally_.trials), static_cast<unsigned long long>(settings_.first), elapsed(),
                tally_.findings, static_cast<unsigned long long>(tally_.corrected), static_cast<unsigned long long>(tally_.with_corrected),
                static_cast<unsigned long long>(tally_.native_crashes),
                static_cast<unsigned long long>(tally_.unsteady));
    const bool enough = tally_.with_corrected >= settings_.corrected;
    if (!enough) std::puts("in fewer than --corrected asks for");
    return tally_.findings == 0 && enough ? 0 : 1;
  }

 private:
  // Trials [first, end) of one kind.
  void block(std::uint64_t first, std::uint64_t end) {
    const Kind kind = kind_of(first);
    Trials native = run_trials(programs_, false, first, end - first, kind);
    Trials ours = run_trials(programs_, true, first, end - first, kind);
    for (std::uint64_t trial = first; trial < end && tally_.findings < settings_.findings; ++trial) {
      ++tally_.trials;
      tally_.corrected += std::uint64_t(ours[trial].corrected);
      if (ours[trial].corrected > 0) ++tally_.with_corrected;
      if (native[trial].status != 0) ++tally_.native_crashes;
      else if (!difference(native[trial], ours[trial], kind).empty()) look_at(trial, kind);
    }
  }

  void look_at(std::uint64_t trial, Kind kind) {
    const Sequence sequence = generate(trial, kind);
    const std::string found = finding(programs_, sequence, kind);
    if (found.empty()) return void(++tally_.unsteady);
    ++tally_.findings;
    std::printf("\ntrial %llu (kind %d): %s\n", static_cast<unsigned long long>(trial), int(kind), found.c_str());
    std::fflush(stdout);
    if (settings_.shrink_seconds <= 0) return;
    const Sequence small = shrink(programs_, sequence, kind, found, settings_.shrink_seconds);
    std::fputs(describe(programs_, small, kind).c_str(), stdout);
    std::fflush(stdout);
  }

  const Programs programs_;
  const Settings settings_;
  Tally tally_;
};

int main(int count, char** arguments) {
  Settings settings;
  for (int i = 1; i < count; i += 2) {
    const std::string name = arguments[i];
    if (i + 1 == count) return 2;
    const char* const value = arguments[i + 1];
    if (name == "--first") settings.first = std::strtoull(value, nullptr, 10);
    else if (name == "--trials") settings.trials = std::strtoull(value, nullptr, 10);
    else if (name == "--seconds") settings.seconds = std::strtod(value, nullptr);
    else if (name == "--findings") settings.findings = std::atoi(value);
    else if (name == "--corrected") settings.corrected = std::strtoull(value, nullptr, 10);
    else if (name == "--shrink") settings.shrink_seconds = std::strtod(value, nullptr);
    else if (name == "--kinds") settings.kinds = value;
    else if (name == "--write") settings.write = value;
    else return std::fprintf(stderr, "usage: %s [--first N] [--trials N] [--seconds S] [--findings N] [--shrink S] "
                                     "[--corrected N] [--kinds 0123] [--write FILE]\n", arguments[0]), 2;
  }
  std::string scratch = (std::filesystem::temp_directory_path() / "truequad_fuzz_XXXXXX").string();
  if (!settings.write.empty()) {
    write({generate(settings.first, kind_of(settings.first))}, settings.write);
    return 0;
  }
  if (!::mkdtemp(scratch.data())) return 70;
  const int status = Fuzz({FUZZ_PROGRAM, TRUEQUAD_PRELOAD, scratch}, settings).run();
  stop_programs();
  std::filesystem::remove_all(scratch);
  return status;
}

}  // namespace
}  // namespace truequad::fuzz

int main(int count, char** arguments) { return truequad::fuzz::main(count, arguments); }
