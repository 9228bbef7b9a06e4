// The ways a process can end without running exit handlers: each writes the statistics first (POSIX _exit, C99 _Exit,
// C11 quick_exit). exit() itself runs process_ends through atexit.
#include <unistd.h>

#include <csignal>

#include "capture/capture.h"
#include "doors/doors.h"

namespace {

[[noreturn]] void end_process(const char* name, int status) {
  truequad::process_ends();
  using Exit = void (*)(int);
  if (auto real = reinterpret_cast<Exit>(truequad::next_symbol(name))) real(status);
  // A C library without this function cannot have brought the program here; still, nobody may return.
  for (;;) ::raise(SIGKILL);
}

}  // namespace

extern "C" {

[[noreturn]] TRUEQUAD_DOOR void _exit(int status) { end_process("_exit", status); }
[[noreturn]] TRUEQUAD_DOOR void _Exit(int status) noexcept { end_process("_Exit", status); }
[[noreturn]] TRUEQUAD_DOOR void quick_exit(int status) noexcept { end_process("quick_exit", status); }

}  // extern "C"
