// Runs sequences without and with truequad, and compares what the program saw.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ops.h"

namespace truequad::fuzz {

// What a process wrote, and how it ended: 0, an exit status, or 128 + the number of a signal.
struct Seen {
  std::string text;
  int status = 0;
  long corrected = 0;  // quads, if truequad was there
};

struct Programs {
  std::string program, preload;
  std::string scratch;  // a directory
};

Seen run_trials(const Programs& programs, bool with_truequad, std::uint64_t first, std::uint64_t count, Kind kind);
Seen run_sequences(const Programs& programs, bool with_truequad, const std::vector<Sequence>& sequences, Kind kind,
                   bool print = false);

// What each trial wrote. The last one may be cut short by a crash.
std::map<std::uint64_t, std::string> divide(const std::string& text);

// The first word of the first line that differs and may not; empty: nothing. `corrected`: whether some quad was, so that
// pixels may differ in any case.
std::string difference(const std::string& native, const std::string& ours, Kind kind, bool corrected);

// What goes wrong with a sequence that runs alone; empty: nothing. Two native runs that differ, or end, are nobody's fault.
std::string finding(const Programs& programs, const Sequence& sequence, Kind kind);

// The shortest sequence found with the same finding, in so many seconds.
Sequence shrink(const Programs& programs, Sequence sequence, Kind kind, const std::string& found, double seconds);

// Its calls, and the lines that differ.
std::string describe(const Programs& programs, const Sequence& sequence, Kind kind);

}  // namespace truequad::fuzz
