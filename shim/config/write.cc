#include "config/write.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>

namespace truequad {
namespace {

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(file, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    text.remove_prefix(n);
  }
  return true;
}

}  // namespace

// The signal is sent to the thread that writes (signal(7)): blocked there and taken away, nobody else can notice it.
bool write_whole(int file, std::string_view text) {
  sigset_t pipe, before, pending;
  ::sigemptyset(&pipe);
  ::sigaddset(&pipe, SIGPIPE);
  ::sigpending(&pending);
  const bool programs_own = ::sigismember(&pending, SIGPIPE) == 1;
  ::pthread_sigmask(SIG_BLOCK, &pipe, &before);
  const bool complete = write_all(file, text);
  const int error = errno;
  if (!complete && error == EPIPE && !programs_own) {
    const timespec at_once = {};
    while (::sigtimedwait(&pipe, nullptr, &at_once) < 0 && errno == EINTR) {
    }
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return complete;
}

}  // namespace truequad
