// Lines for the user on stderr, each written by one write(2): no lock, no allocation, no stdio state of the host.
#pragma once

#include <atomic>

namespace truequad {

enum class LogLevel : unsigned char { kQuiet, kWarning, kInfo };

// The level that lines are compared with: kWarning until options() has read the environment.
extern constinit std::atomic<LogLevel> log_level;

// Prints "truequad: " and the formatted text (printf's rules, cut after about 1000 characters) as one line.
[[gnu::format(printf, 1, 2)]] void log_warning(const char* format, ...);
[[gnu::format(printf, 1, 2)]] void log_info(const char* format, ...);

}  // namespace truequad
