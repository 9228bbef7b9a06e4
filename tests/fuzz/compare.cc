#include "compare.h"

#include <chrono>
#include <sstream>

namespace truequad::fuzz {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool may_differ(const std::string& line, Kind kind, bool corrected) {
  const auto is = [&](const char* word) { return line.rfind(word, 0) == 0; };
  switch (kind) {
    case Kind::kBent: return is("colour") || is("depth") || is("stencil") || is("covered");
    case Kind::kCovered: return corrected && (is("colour") || is("depth"));
    default: return corrected && (is("colour") || is("depth") || is("stencil") || is("covered"));
  }
}

}  // namespace

std::string difference(const Seen& native, const Seen& ours, Kind kind) {
  if (native.status != 0) return "";
  if (ours.status != 0) return "crash";
  const auto a = lines_of(native.text), b = lines_of(ours.text);
  const bool corrected = ours.corrected > 0;
  for (std::size_t i = 0; i < a.size() || i < b.size(); ++i) {
    const std::string& x = i < a.size() ? a[i] : "missing";
    const std::string& y = i < b.size() ? b[i] : "missing";
    if (x == y || (may_differ(x, kind, corrected) && may_differ(y, kind, corrected))) continue;
    const std::string& named = x == "missing" ? y : x;
    return named.substr(0, named.find(' '));
  }
  return "";
}

namespace {

// Some sequences give the driver's own memory away only at times, or only to some processes: those that one has forked have
// all memory at the same addresses.
bool is_steady(const Programs& programs, const Sequence& sequence, Kind kind, const Seen& native, int processes) {
  for (int i = 0; i < processes; ++i) {
    if (i > 0) stop_native_programs();
    for (Way way : {Way::kPlain, Way::kDirty}) {
      for (const auto& [number, again] : run_sequences(programs, false, {4, sequence}, kind, false, way)) {
        if (native.text != again.text || native.status != again.status) return false;
      }
    }
  }
  return true;
}

std::string finding_in(const Programs& programs, const Sequence& sequence, Kind kind, int processes) {
  const Seen ours = run_sequences(programs, true, {sequence}, kind)[0], native = run_sequences(programs, false, {sequence}, kind)[0];
  const std::string found = difference(native, ours, kind);
  if (found.empty() || run_sequences(programs, false, {sequence}, kind, false, Way::kProbed)[0].status != 0) return "";
  const Seen ours_settled = run_sequences(programs, true, {sequence}, kind, false, Way::kSettled)[0],
             settled = run_sequences(programs, false, {sequence}, kind, false, Way::kSettled)[0];
  if (settled.status == 0 && difference(settled, ours_settled, kind).empty()) return "";
  return is_steady(programs, sequence, kind, native, processes) ? found : "";
}

}  // namespace

std::string finding(const Programs& programs, const Sequence& sequence, Kind kind) { return finding_in(programs, sequence, kind, 8); }

namespace {

// A sequence without the steps of [from, to).
Sequence without(const Sequence& sequence, std::size_t from, std::size_t to) {
  Sequence rest(sequence.begin(), sequence.begin() + long(from));
  rest.insert(rest.end(), sequence.begin() + long(std::min(to, sequence.size())), sequence.end());
  return rest;
}

// What the driver's own memory shows through is no smaller finding.
bool still_has(const Programs& programs, const Sequence& sequence, Kind kind, const std::string& found) {
  if (finding_in(programs, sequence, kind, 1) != found) return false;
  return run_sequences(programs, true, {sequence}, kind)[0].text == run_sequences(programs, true, {sequence}, kind, false, Way::kDirty)[0].text;
}

// Which of these seem to have the finding; the driver alone may still not be steady in it.
std::vector<bool> seem_to_fail(const Programs& programs, const std::vector<Sequence>& candidates, Kind kind, const std::string& found) {
  Trials native = run_sequences(programs, false, candidates, kind), ours = run_sequences(programs, true, candidates, kind);
  std::vector<bool> fail;
  for (std::size_t i = 0; i < candidates.size(); ++i) fail.push_back(difference(native[i], ours[i], kind) == found);
  return fail;
}

}  // namespace

Sequence shrink(const Programs& programs, Sequence sequence, Kind kind, const std::string& found, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  std::size_t first = 0;
  while (first < sequence.size() && stays(sequence[first].step)) ++first;
  for (std::size_t size = (sequence.size() + 1) / 2; size > 0 && Clock::now() < end;) {
    std::vector<Sequence> candidates;
    for (std::size_t at = first; at < sequence.size(); at += size) candidates.push_back(without(sequence, at, at + size));
    const std::vector<bool> fail = seem_to_fail(programs, candidates, kind, found);
    // All that can go at once, else the first that can.
    Sequence all(sequence.begin(), sequence.begin() + long(first));
    for (std::size_t i = first; i < sequence.size(); ++i) {
      if (!fail[(i - first) / size]) all.push_back(sequence[i]);
    }
    bool smaller = all.size() < sequence.size() && still_has(programs, all, kind, found);
    if (smaller) sequence = all;
    for (std::size_t i = 0; i < candidates.size() && !smaller && Clock::now() < end; ++i) {
      if (!fail[i] || !still_has(programs, candidates[i], kind, found)) continue;
      sequence = candidates[i];
      smaller = true;
    }
    if (!smaller) size = size == 1 ? 0 : (size + 1) / 2;
  }
  return sequence;
}

std::string describe(const Programs& programs, const Sequence& sequence, Kind kind) {
  const Seen native = run_sequences(programs, false, {sequence}, kind, true)[0],
             ours = run_sequences(programs, true, {sequence}, kind, true)[0];
  const auto a = lines_of(native.text), b = lines_of(ours.text);
  std::string text;
  for (const std::string& line : a) {
    if (line.find("everything is asked") != std::string::npos) break;
    text += line + "\n";
  }
  text += "what differs (status " + std::to_string(native.status) + ", with truequad " + std::to_string(ours.status) + ", corrected " +
          std::to_string(ours.corrected) + "):\n";
  int shown = 0;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()) && shown < 12; ++i) {
    const std::string x = i < a.size() ? a[i] : "nothing", y = i < b.size() ? b[i] : "nothing";
    if (x == y) continue;
    ++shown;
    text += "  native: " + x + "\n  ours:   " + y + "\n";
  }
  return text;
}

}  // namespace truequad::fuzz
