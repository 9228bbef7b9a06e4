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

Seen run(const Programs& programs, bool with_truequad, const std::vector<std::string>& words, Kind kind) {
  const std::string statistics = programs.scratch + "/statistics";
  ::unlink(statistics.c_str());
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
    if (with_truequad) {
      ::setenv("LD_PRELOAD", programs.preload.c_str(), 1);
      ::setenv("TRUEQUAD_STATS", statistics.c_str(), 1);
      if (kind == Kind::kWarped) ::setenv("TRUEQUAD_TOLERANCE", "1000000", 1);
    }
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::alarm(60);
    ::execv(arguments[0], arguments.data());
    ::_exit(99);
  }
  ::close(ends[1]);
  Seen seen;
  char buffer[1 << 16];
  for (ssize_t got; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;) seen.text.append(buffer, std::size_t(got));
  ::close(ends[0]);
  int state = 0;
  ::waitpid(child, &state, 0);
  seen.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  if (with_truequad) {
    const auto json = nlohmann::json::parse(read_file(statistics), nullptr, false);
    if (json.is_object()) seen.corrected = json.value("corrected", 0L);
  }
  return seen;
}

bool may_differ(const std::string& line, Kind kind, bool corrected) {
  const auto is = [&](const char* word) { return line.rfind(word, 0) == 0; };
  switch (kind) {
    case Kind::kBent: return is("colour") || is("depth") || is("stencil") || is("covered");
    case Kind::kCovered: return corrected && (is("colour") || is("depth"));
    default: return corrected && (is("colour") || is("depth") || is("stencil") || is("covered"));
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

Seen run_trials(const Programs& programs, bool with_truequad, std::uint64_t first, std::uint64_t count, Kind kind) {
  return run(programs, with_truequad, {programs.program, "--trials", std::to_string(first), std::to_string(count)}, kind);
}

Seen run_sequences(const Programs& programs, bool with_truequad, const std::vector<Sequence>& sequences, Kind kind, bool print) {
  const std::string path = programs.scratch + "/sequences";
  write(sequences, path);
  std::vector<std::string> words = {programs.program, "--file", path};
  if (print) words.push_back("--print");
  return run(programs, with_truequad, words, kind);
}

std::map<std::uint64_t, std::string> divide(const std::string& text) {
  std::map<std::uint64_t, std::string> trials;
  std::string* trial = nullptr;
  for (const std::string& line : lines_of(text)) {
    if (line.rfind("trial ", 0) == 0) trial = &trials[std::strtoull(line.c_str() + 6, nullptr, 10)];
    else if (trial) *trial += line + "\n";
  }
  return trials;
}

std::string difference(const std::string& native, const std::string& ours, Kind kind, bool corrected) {
  const auto a = lines_of(native), b = lines_of(ours);
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
  const Seen ours = run_sequences(programs, true, {sequence}, kind), native = run_sequences(programs, false, {sequence}, kind);
  if (native.status != 0) return "";
  if (ours.status != 0) return "crash";
  const std::string found = difference(native.text, ours.text, kind, ours.corrected > 0);
  if (found.empty() || run_sequences(programs, false, {sequence}, kind).text != native.text) return "";
  return found;
}

namespace {

// A sequence without the steps of [from, to).
Sequence without(const Sequence& sequence, std::size_t from, std::size_t to) {
  Sequence rest(sequence.begin(), sequence.begin() + long(from));
  rest.insert(rest.end(), sequence.begin() + long(std::min(to, sequence.size())), sequence.end());
  return rest;
}

// Which of these seem to have the finding, as far as one process for all can tell.
std::vector<bool> seem_to_fail(const Programs& programs, const std::vector<Sequence>& candidates, Kind kind, const std::string& found) {
  std::vector<bool> fail(candidates.size(), found == "crash");
  if (found == "crash") return fail;
  const auto native = divide(run_sequences(programs, false, candidates, kind).text),
             ours = divide(run_sequences(programs, true, candidates, kind).text);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto a = native.find(i), b = ours.find(i);
    // What came after a crash has to be looked at alone.
    fail[i] = a == native.end() || b == ours.end() || difference(a->second, b->second, kind, false) == found;
  }
  return fail;
}

}  // namespace

Sequence shrink(const Programs& programs, Sequence sequence, Kind kind, const std::string& found, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (std::size_t size = (sequence.size() + 1) / 2; size > 0 && Clock::now() < end;) {
    std::vector<Sequence> candidates;
    for (std::size_t at = 0; at < sequence.size(); at += size) candidates.push_back(without(sequence, at, at + size));
    const std::vector<bool> fail = seem_to_fail(programs, candidates, kind, found);
    // All that can go at once, else the first that can.
    Sequence all;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      if (!fail[i / size]) all.push_back(sequence[i]);
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
  const Seen native = run_sequences(programs, false, {sequence}, kind, true), ours = run_sequences(programs, true, {sequence}, kind, true);
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
