#include "config/log.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>

#include "config/write.h"

namespace truequad {

constinit std::atomic<LogLevel> log_level{LogLevel::kWarning};

namespace {

void write_line(const char* format, std::va_list arguments) {
  const int host_errno = errno;
  char line[1024] = "truequad: ";
  constexpr int kPrefix = 10;
  const int room = int(sizeof line) - kPrefix - 1;
  const int length = std::vsnprintf(line + kPrefix, room, format, arguments);
  if (length >= 0) {
    const int end = kPrefix + std::min(length, room - 1);
    line[end] = '\n';
    write_whole(STDERR_FILENO, {line, std::size_t(end + 1)});
  }
  errno = host_errno;
}

}  // namespace

void log_warning(const char* format, ...) {
  if (log_level.load(std::memory_order_relaxed) < LogLevel::kWarning) return;
  std::va_list arguments;
  va_start(arguments, format);
  write_line(format, arguments);
  va_end(arguments);
}

void log_info(const char* format, ...) {
  if (log_level.load(std::memory_order_relaxed) < LogLevel::kInfo) return;
  std::va_list arguments;
  va_start(arguments, format);
  write_line(format, arguments);
  va_end(arguments);
}

}  // namespace truequad
