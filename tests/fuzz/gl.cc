#include "gl.h"

#include <cstdarg>
#include <cstdio>

typedef void (*OSMESAproc)();
extern "C" OSMESAproc OSMesaGetProcAddress(const char* name);

namespace truequad::fuzz {

Driver gl;
bool printing = false;
alignas(64) unsigned char arena[kArena];

void load_gl() {
#define TQ_COMMAND(name, result, parameters, arguments) \
  gl.name = reinterpret_cast<decltype(gl.name)>(OSMesaGetProcAddress("gl" #name));
#include "gl_commands.inc"
#undef TQ_COMMAND
}

namespace {
bool first_argument;
void separate() {
  if (!first_argument) std::fputs(", ", stdout);
  first_argument = false;
}
}  // namespace

void print_begin(const char* name) {
  std::printf("  %s(", name);
  first_argument = true;
}
void print_number(std::int64_t value) { separate(), std::printf("%lld", static_cast<long long>(value)); }
void print_enum(std::uint64_t value) {
  separate();
  std::printf(value < 256 ? "%llu" : "0x%llx", static_cast<unsigned long long>(value));
}
void print_real(double value) { separate(), std::printf("%.9g", value); }
void print_pointer(const void* value) {
  separate();
  const std::int64_t place = place_of(value);
  if (place < 0) std::fputs("data", stdout);
  else std::printf("%s%lld", value >= arena && value < arena + kArena ? "arena + " : "(void*)", static_cast<long long>(place));
}
void print_end() { std::puts(");"); }
void print_note(const char* format, ...) {
  if (!printing) return;
  std::fputs("  // ", stdout);
  va_list arguments;
  va_start(arguments, format);
  std::vprintf(format, arguments);
  va_end(arguments);
  std::puts("");
}

std::int64_t place_of(const void* pointer) {
  const auto address = reinterpret_cast<std::uintptr_t>(pointer), begin = reinterpret_cast<std::uintptr_t>(arena);
  if (address >= begin && address < begin + kArena) return std::int64_t(address - begin);
  return address < (1u << 20) ? std::int64_t(address) : -1;
}

}  // namespace truequad::fuzz
