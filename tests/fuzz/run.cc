// The processes that run sequences: one for each way, started when it is first needed. Contexts cost more than sequences.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "compare.h"

namespace truequad::fuzz {
namespace {

struct Setting {
  bool with_truequad, tolerant;
  Way way;
  friend auto operator<=>(const Setting&, const Setting&) = default;
  // Statistics of the processes that it forks lie beside this file.
  std::string statistics(const Programs& programs) const { return programs.scratch + (tolerant ? "/tolerant" : "/strict"); }
};

struct Server {
  std::FILE *to, *from;
  pid_t process;
  void stop() const {
    std::fclose(to), std::fclose(from);
    ::waitpid(process, nullptr, 0);
  }
};

std::map<Setting, Server> servers;

Server start(const Programs& programs, const Setting& setting) {
  int in[2], out[2];
  if (::pipe(in) != 0 || ::pipe(out) != 0) std::abort();
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(in[0], STDIN_FILENO);
    ::dup2(out[1], STDOUT_FILENO);
    for (int end : {in[0], in[1], out[0], out[1]}) ::close(end);
    // A driver without compiled shaders: contexts and first calls cost less, and it has one thread.
    ::setenv("GALLIUM_DRIVER", "softpipe", 1);
    ::setenv("DRAW_USE_LLVM", "0", 1);
    ::setenv("ASAN_OPTIONS", "detect_leaks=0:verify_asan_link_order=0", 0);
    if (setting.way == Way::kDirty) ::setenv("MALLOC_PERTURB_", "165", 1);
    if (setting.way == Way::kProbed) ::setenv("FUZZ_PROBE", "1", 1);
    if (setting.way == Way::kSettled) ::setenv("FUZZ_SETTLE", "1", 1);
    // Lists that call themselves draw tens of thousands of quads in a second; to correct them takes longer.
    ::setenv("FUZZ_SECONDS", setting.with_truequad ? "6" : "2", 1);
    if (setting.with_truequad) {
      ::setenv("LD_PRELOAD", programs.preload.c_str(), 1);
      ::setenv("TRUEQUAD_STATS", setting.statistics(programs).c_str(), 1);
      if (setting.tolerant) ::setenv("TRUEQUAD_TOLERANCE", "1000000", 1);
    }
    ::execl(programs.program.c_str(), programs.program.c_str(), "--serve", nullptr);
    ::_exit(99);
  }
  ::close(in[0]), ::close(out[1]);
  // Those that are started later must not hold this one's ends.
  ::fcntl(in[1], F_SETFD, FD_CLOEXEC), ::fcntl(out[0], F_SETFD, FD_CLOEXEC);
  return {::fdopen(in[1], "w"), ::fdopen(out[0], "r"), child};
}

// Reads what was written for each trial.
Trials read_trials(std::FILE* from, const std::string& statistics, bool& ended) {
  Trials trials;
  Seen* seen = nullptr;
  ended = false;
  char* line = nullptr;
  std::size_t room = 0;
  while (!ended && ::getline(&line, &room, from) > 0) {
    int process = 0;
    const std::string_view text = line;
    if (text == "end\n") {
      ended = true;
    } else if (text.starts_with("trial ")) {
      seen = &trials[std::strtoull(line + 6, nullptr, 10)];
      seen->status = 128;  // of a program that did not come to say it
    } else if (seen && std::sscanf(line, "process %d %d", &process, &seen->status) == 2) {
      const std::string path = statistics + "." + std::to_string(process);
      std::ifstream file(path);
      const auto json = nlohmann::json::parse(file, nullptr, false);
      if (json.is_object()) seen->corrected = json.value("corrected", 0L);
      ::unlink(path.c_str());
    } else if (seen) {
      seen->text += text;
    }
  }
  std::free(line);
  return trials;
}

Trials run(const Programs& programs, const Setting& setting, const std::string& words) {
  std::signal(SIGPIPE, SIG_IGN);
  auto found = servers.find(setting);
  if (found == servers.end()) found = servers.emplace(setting, start(programs, setting)).first;
  const Server server = found->second;
  std::fprintf(server.to, "%s\n", words.c_str());
  std::fflush(server.to);
  bool ended;
  Trials trials = read_trials(server.from, setting.statistics(programs), ended);
  if (!ended) {
    server.stop();
    servers.erase(found);
  }
  return trials;
}

}  // namespace

void stop_programs() {
  for (const auto& [setting, server] : servers) server.stop();
  servers.clear();
}

void stop_native_programs() {
  std::erase_if(servers, [](const auto& started) {
    const auto& [setting, server] = started;
    if (!setting.with_truequad) server.stop();
    return !setting.with_truequad;
  });
}

Trials run_trials(const Programs& programs, bool with_truequad, std::uint64_t first, std::uint64_t count, Kind kind) {
  return run(programs, {with_truequad, with_truequad && kind == Kind::kWarped, Way::kPlain},
             "--trials " + std::to_string(first) + " " + std::to_string(count));
}

Trials run_sequences(const Programs& programs, bool with_truequad, const std::vector<Sequence>& sequences, Kind kind, bool print,
                     Way way) {
  const std::string path = programs.scratch + "/sequences";
  write(sequences, path);
  return run(programs, {with_truequad, with_truequad && kind == Kind::kWarped, way}, "--file " + path + (print ? " --print" : ""));
}

}  // namespace truequad::fuzz
