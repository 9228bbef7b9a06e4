// Runs sequences without and with truequad, and compares what the program saw.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ops.h"

namespace truequad::fuzz {

// What the process of a trial wrote, and how it ended: 0, an exit status, or 128 + the number of a signal.
struct Seen {
  std::string text;
  int status = 0;
  long corrected = 0;  // quads, if truequad was there
};

using Trials = std::map<std::uint64_t, Seen>;

struct Programs {
  std::string program, preload;
  std::string scratch;  // a directory
};

Trials run_trials(const Programs& programs, bool with_truequad, std::uint64_t first, std::uint64_t count, Kind kind);
enum class Way : std::uint8_t {
  kPlain,
  kDirty,   // new memory is not zero, so that what a driver reads without having written it shows
  kProbed,  // after each step it is asked whether the driver knows if it is between glBegin and glEnd
  kSettled, // values that a list leaves open are set anew also where another list calls it
};
// Numbered from 0.
Trials run_sequences(const Programs& programs, bool with_truequad, const std::vector<Sequence>& sequences, Kind kind,
                     bool print = false, Way way = Way::kPlain);

// Ends the processes that these have started; those of the driver alone.
void stop_programs();
void stop_native_programs();

// The first word of the first line that differs and may not, or "crash"; empty: nothing, or the driver alone crashed.
// Where some quad was corrected pixels may differ in any case.
std::string difference(const Seen& native, const Seen& ours, Kind kind);

// What goes wrong with a sequence that runs alone; empty: nothing. Native runs that differ, some of them with dirty
// memory, or that end, are nobody's fault; nor is a driver that loses its way between glBegin and glEnd, or what differs no more if kSettled.
std::string finding(const Programs& programs, const Sequence& sequence, Kind kind);

// The shortest sequence found with the same finding, in so many seconds.
Sequence shrink(const Programs& programs, Sequence sequence, Kind kind, const std::string& found, double seconds);

// Its calls, and the lines that differ.
std::string describe(const Programs& programs, const Sequence& sequence, Kind kind);

}  // namespace truequad::fuzz
