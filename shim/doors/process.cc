// The ways a process can end. exit() runs handlers; those that run none (POSIX _exit, C99 _Exit, C11 quick_exit has
// its own) have doors.
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>

#include "capture/capture.h"
#include "doors/doors.h"

namespace truequad {
namespace {

using Exit = void (*)(int);

enum Way : unsigned { kUnderscoreExit, kCapitalExit, kQuickExit, kWayCount };
constexpr const char* kNames[kWayCount] = {"_exit", "_Exit", "quick_exit"};

// Looked up in advance: _exit is what signal handlers and forked children call, where dlsym is not allowed.
constinit std::array<std::atomic<Exit>, kWayCount> real_exits = {};

Exit real_exit(Way way) {
  Exit real = real_exits[way].load(std::memory_order_relaxed);
  if (!real) {
    real = reinterpret_cast<Exit>(next_symbol(Api::kNext, kNames[way]));
    real_exits[way].store(real, std::memory_order_relaxed);
  }
  return real;
}

[[noreturn]] void end_process(Way way, int status) {
  process_ends();
  if (const Exit real = real_exit(way)) real(status);
  // A C library without this function cannot have brought the program here; still, nobody may return.
  for (;;) ::raise(SIGKILL);
}

}  // namespace

void watch_exit() {
  static constinit std::atomic<bool> watching = false;
  if (watching.load(std::memory_order_relaxed) || watching.exchange(true)) return;
  std::atexit(process_ends);
  for (unsigned way = 0; way < kWayCount; ++way) real_exit(Way(way));
}

}  // namespace truequad

extern "C" {

[[noreturn]] TRUEQUAD_DOOR void _exit(int status) { truequad::end_process(truequad::kUnderscoreExit, status); }
[[noreturn]] TRUEQUAD_DOOR void _Exit(int status) noexcept { truequad::end_process(truequad::kCapitalExit, status); }
[[noreturn]] TRUEQUAD_DOOR void quick_exit(int status) noexcept {
  truequad::end_process(truequad::kQuickExit, status);
}

}  // extern "C"
