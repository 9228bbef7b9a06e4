#include "compare.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace truequad::fuzz {
namespace {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// What was written for each trial. Statistics of a process that was forked lie beside its parent's.
Trials divide(const std::string& text, const std::string& statistics) {
  Trials trials;
  Seen* seen = nullptr;
  for (const std::string& line : lines_of(text)) {
    int process = 0;
    if (line.rfind("trial ", 0) == 0) {
      seen = &trials[std::strtoull(line.c_str() + 6, nullptr, 10)];
      seen->status = 128;  // of a program that did not come to say it
    } else if (seen && std::sscanf(line.c_str(), "process %d %d", &process, &seen->status) == 2) {
      const std::string path = statistics + "." + std::to_string(process);
      const auto json = nlohmann::json::parse(read_file(path), nullptr, false);
      if (json.is_object()) seen->corrected = json.value("corrected", 0L);
      ::unlink(path.c_str());
    } else if (seen) {
      seen->text += line + "\n";
    }
  }
  return trials;
}

Trials run(const Programs& programs, bool with_truequad, const std::vector<std::string>& words, Kind kind, bool dirty = false) {
  const std::string statistics = programs.scratch + "/statistics";
  int ends[2];
  if (::pipe(ends) != 0) std::abort();
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]), ::close(ends[1]);
    // A driver without compiled shaders: contexts and first calls cost less, and it has one thread.
    ::setenv("GALLIUM_DRIVER", "softpipe", 1);
    ::setenv("DRAW_USE_LLVM", "0", 1);
    ::setenv("ASAN_OPTIONS", "detect_leaks=0:verify_asan_link_order=0", 0);
    if (dirty) ::setenv("MALLOC_PERTURB_", "165", 1);
    if (with_truequad) {
      ::setenv("LD_PRELOAD", programs.preload.c_str(), 1);
      ::setenv("TRUEQUAD_STATS", statistics.c_str(), 1);
      if (kind == Kind::kWarped) ::setenv("TRUEQUAD_TOLERANCE", "1000000", 1);
    }
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execv(arguments[0], arguments.data());
    ::_exit(99);
  }
  ::close(ends[1]);
  std::string text;
  char buffer[1 << 16];
  for (ssize_t got; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;) text.append(buffer, std::size_t(got));
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return divide(text, statistics);
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

Trials run_trials(const Programs& programs, bool with_truequad, std::uint64_t first, std::uint64_t count, Kind kind) {
  return run(programs, with_truequad, {programs.program, "--trials", std::to_string(first), std::to_string(count)}, kind);
}

Trials run_sequences(const Programs& programs, bool with_truequad, const std::vector<Sequence>& sequences, Kind kind, bool print,
                     bool dirty) {
  const std::string path = programs.scratch + "/sequences";
  write(sequences, path);
  std::vector<std::string> words = {programs.program, "--file", path};
  if (print) words.push_back("--print");
  return run(programs, with_truequad, words, kind, dirty);
}

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

std::string finding(const Programs& programs, const Sequence& sequence, Kind kind) {
  const Seen ours = run_sequences(programs, true, {sequence}, kind)[0];
  const Seen native = run_sequences(programs, false, {sequence}, kind)[0];
  // Some sequences give the driver's own memory away only at times.
  for (int i = 0; i < 6; ++i) {
    const Seen again = run_sequences(programs, false, {sequence}, kind, false, i % 2 == 0)[0];
    if (native.text != again.text || native.status != again.status) return "";
  }
  return difference(native, ours, kind);
}

namespace {

// A sequence without the steps of [from, to).
Sequence without(const Sequence& sequence, std::size_t from, std::size_t to) {
  Sequence rest(sequence.begin(), sequence.begin() + long(from));
  rest.insert(rest.end(), sequence.begin() + long(std::min(to, sequence.size())), sequence.end());
  return rest;
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
    bool smaller = all.size() < sequence.size() && finding(programs, all, kind) == found;
    if (smaller) sequence = all;
    for (std::size_t i = 0; i < candidates.size() && !smaller && Clock::now() < end; ++i) {
      if (!fail[i] || finding(programs, candidates[i], kind) != found) continue;
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
