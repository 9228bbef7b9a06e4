#include "capture/stats.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "capture/capture.h"
#include "config/write.h"

namespace truequad {
namespace {

// Held for a few instructions, when threads start and end; never on the vertex path. A plain flag rather than a
// mutex: it can be set right in a forked child, and process_ends() may run in a signal handler.
constinit std::atomic_flag threads_busy = ATOMIC_FLAG_INIT;
constinit Counters* threads = nullptr;
constinit Counters ended;  // sum over threads that ended

constinit std::atomic<bool> engaged{false};
constinit std::atomic<bool> written{false};
constinit std::atomic<pid_t> owner{0};  // the process that the counts belong to
constinit std::atomic<bool> forked{false};

bool try_lock(int attempts) {
  while (threads_busy.test_and_set(std::memory_order_acquire)) {
    if (--attempts == 0) return false;
    ::usleep(100);
  }
  return true;
}
void unlock() { threads_busy.clear(std::memory_order_release); }
constexpr int kPatient = -1, kAboutASecond = 10000;

constexpr Counter Counters::*kPaths[] = {&Counters::listed, &Counters::from_arrays, &Counters::from_buffers,
                                         &Counters::rectangles};

// An infinite bound promises nothing; `capped` counts it.
void raise(std::atomic<double>& largest, double bound) {
  if (std::isfinite(bound) && bound > largest.load(std::memory_order_relaxed)) {
    largest.store(bound, std::memory_order_relaxed);
  }
}

void add_to(Counters& sum, const Counters& x) {
  for (std::size_t i = 0; i < kReasonCount; ++i) sum.passed[i].add(x.passed[i].get());
  for (Counter Counters::*path : kPaths) (sum.*path).add((x.*path).get());
  sum.corrected.add(x.corrected.get());
  sum.capped.add(x.capped.get());
  sum.triangles.add(x.triangles.get());
  sum.flushes.add(x.flushes.get());
  raise(sum.bound_px_max, x.bound_px_max.load(std::memory_order_relaxed));
  raise(sum.bound_steps_max, x.bound_steps_max.load(std::memory_order_relaxed));
}

void sum_all(Counters& sum) {
  add_to(sum, ended);
  for (const Counters* x = threads; x; x = x->next) add_to(sum, *x);
}

void clear(Counters& x) {
  for (Counter& counter : x.passed) counter.set(0);
  for (Counter Counters::*path : kPaths) (x.*path).set(0);
  for (Counter* counter : {&x.corrected, &x.capped, &x.triangles, &x.flushes}) counter->set(0);
  x.bound_px_max.store(0, std::memory_order_relaxed);
  x.bound_steps_max.store(0, std::memory_order_relaxed);
}

// In the child of fork(): the parent reports what came before. Not called for vfork(), whose child shares our memory.
void start_child() {
  unlock();
  for (Counters* x = threads; x; x = x->next) clear(*x);
  clear(ended);
  written.store(false, std::memory_order_relaxed);
  forked.store(true, std::memory_order_relaxed);
  owner.store(::getpid(), std::memory_order_relaxed);
}

// A JSON object in a buffer of fixed size: no allocation, as this may run inside _exit.
class Writer {
 public:
  void text(std::string_view s) {
    if (s.size() > sizeof buffer_ - size_) return;
    std::memcpy(buffer_ + size_, s.data(), s.size());
    size_ += s.size();
  }
  template <typename T>
  void number(T value) {
    const auto [end, error] = std::to_chars(buffer_ + size_, buffer_ + sizeof buffer_, value);
    if (error == std::errc()) size_ = end - buffer_;
  }
  template <typename T>
  void field(std::string_view name, T value) {
    this->name(name);
    number(value);
  }
  void name(std::string_view name) {
    if (size_ > 0 && buffer_[size_ - 1] != '{') text(", ");
    text("\"");
    text(name);
    text("\": ");
  }
  std::string_view all() const { return {buffer_, size_}; }

 private:
  char buffer_[4096];
  std::size_t size_ = 0;
};

void write_json(const Counters& sum, const Options& settings, Writer& out) {
  const std::uint64_t quads = sum.quads(), passed = quads - sum.corrected.get();
  out.text("{");
  out.field("quads", quads);
  out.field("passed", passed);
  out.field("corrected", sum.corrected.get());
  out.field("capped", sum.capped.get());
  out.field("triangles", sum.triangles.get());
  out.field("bound_px_max", sum.bound_px_max.load(std::memory_order_relaxed));
  if (settings.color) out.field("bound_steps_max", sum.bound_steps_max.load(std::memory_order_relaxed));
  out.name("by_path");
  out.text("{");
  std::uint64_t others = 0;
  for (Counter Counters::*path : kPaths) others += (sum.*path).get();
  out.field("immediate", quads - others);
  out.field("list", sum.listed.get());
  out.field("arrays", sum.from_arrays.get());
  out.field("buffer", sum.from_buffers.get());
  out.field("rect", sum.rectangles.get());
  out.text("}");
  out.name("pass_reasons");
  out.text("{");
  for (std::size_t i = 0; i < kReasonCount; ++i) {
    if (sum.passed[i].get() > 0) out.field(kReasonNames[i], sum.passed[i].get());
  }
  out.text("}");
  out.field("flushes", sum.flushes.get());
  out.name("mode");
  out.text("\"");
  out.text(mode_name(settings.mode));
  out.text("\"");
  out.field("tolerance_px", settings.tolerance_px);
  out.text("}\n");
}

bool write_to(const char* path, std::string_view text, int flags) {
  const int file = ::open(path, O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
  if (file < 0) return false;
  const bool complete = write_whole(file, text);
  const int error = errno;
  const bool closed = ::close(file) == 0;
  if (!complete) errno = error;
  return complete && closed;
}

// A reader never sees half a file: a regular file is replaced at once. Devices and pipes are written into; a pipe that nobody
// reads must not keep the program from ending.
bool write_file(const char* path, std::string_view text) {
  struct stat there;
  if (::stat(path, &there) == 0 && !S_ISREG(there.st_mode)) return write_to(path, text, O_NONBLOCK);
  char temporary[Options::kPathSize + 32];
  std::snprintf(temporary, sizeof temporary, "%s.tmp%d", path, int(::getpid()));
  if (!write_to(temporary, text, O_TRUNC)) return false;
  if (::rename(temporary, path) == 0) return true;
  const int error = errno;
  ::unlink(temporary);
  errno = error;
  return false;
}

}  // namespace

void Counters::correct(int triangle_count, double bound_px, double bound_steps, bool is_capped) {
  corrected.add(1);
  triangles.add(triangle_count);
  if (is_capped) capped.add(1);
  raise(bound_px_max, bound_px);
  raise(bound_steps_max, bound_steps);
}

void stats_engage() {
  if (engaged.load(std::memory_order_relaxed)) return;
  engaged.store(true, std::memory_order_relaxed);
  pid_t nobody = 0;
  if (owner.compare_exchange_strong(nobody, ::getpid())) {
    ::pthread_atfork([] { try_lock(kAboutASecond); }, [] { unlock(); }, start_child);
  }
}

void stats_attach(Counters& counters) {
  try_lock(kPatient);
  counters.next = threads;
  threads = &counters;
  unlock();
}

void stats_detach(Counters& counters) {
  try_lock(kPatient);
  for (Counters** x = &threads; *x; x = &(*x)->next) {
    if (*x == &counters) {
      *x = counters.next;
      break;
    }
  }
  add_to(ended, counters);
  unlock();
}

void stats_sum(Counters& sum) {
  try_lock(kPatient);
  sum_all(sum);
  unlock();
}

void process_ends() {
  if (!engaged.load(std::memory_order_relaxed)) return;
  // The child of a vfork() or a raw clone() leaves: the counts are its parent's.
  if (::getpid() != owner.load(std::memory_order_relaxed)) return;
  const Options& settings = options();
  if (settings.stats_path[0] == '\0') return;
  if (written.exchange(true)) return;

  const int host_errno = errno;
  Counters sum;
  const bool locked = try_lock(kAboutASecond);
  sum_all(sum);
  if (locked) unlock();
  // A child that only runs another program, or fails to, has nothing to tell.
  const bool child = forked.load(std::memory_order_relaxed);
  if (child && sum.quads() == 0) return;

  Writer json;
  write_json(sum, settings, json);
  if (std::string_view(settings.stats_path) == "-") {
    write_whole(STDERR_FILENO, json.all());
  } else {
    char path[Options::kPathSize + 16];
    std::snprintf(path, sizeof path, child ? "%s.%d" : "%s", settings.stats_path, int(::getpid()));
    if (!write_file(path, json.all())) {
      log_warning("cannot write the statistics to %s: %s", path, std::strerror(errno));
    }
  }
  errno = host_errno;
}

}  // namespace truequad
