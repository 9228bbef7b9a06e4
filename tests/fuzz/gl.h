// OpenGL as the sequences call it: every command of the registry that the library has, found by name as programs find it.
// Each call can be printed as a line of C.
#pragma once

#include <cstdint>
#include <type_traits>

#include "driver/driver.h"

namespace truequad::fuzz {

// Null members: the library lacks the command; it is not called then.
extern Driver gl;
void load_gl();

// Whether calls are printed, and to what is told of them.
extern bool printing;
void print_begin(const char* name);
void print_number(std::int64_t value);
void print_enum(std::uint64_t value);
void print_real(double value);
void print_pointer(const void* value);
void print_end();
void print_note(const char* format, ...) __attribute__((format(printf, 1, 2)));

// Memory of the sequences whose place is known: pointers into it print, and answer queries, as offsets.
inline constexpr std::size_t kArena = std::size_t(4) << 20;
extern unsigned char arena[kArena];
// Offset in the arena; any other pointer: its own value if small, else -1.
std::int64_t place_of(const void* pointer);

template <typename T>
void print(T value) {
  if constexpr (std::is_pointer_v<T>) print_pointer(reinterpret_cast<const void*>(value));
  else if constexpr (std::is_floating_point_v<T>) print_real(double(value));
  else if constexpr (std::is_unsigned_v<T>) print_enum(value);
  else print_number(std::int64_t(value));
}

template <auto member, typename Function = std::remove_cvref_t<decltype(gl.*member)>>
struct Call;
template <auto member, typename Result, typename... Parameters>
struct Call<member, Result(GLAPIENTRY*)(Parameters...)> {
  static Result make(const char* name, Parameters... parameters) {
    if (!(gl.*member)) return Result();
    if (printing) {
      print_begin(name);
      (print(parameters), ...);
      print_end();
    }
    return (gl.*member)(parameters...);
  }
};

#define GL(Name, ...) ::truequad::fuzz::Call<&::truequad::Driver::Name>::make("gl" #Name __VA_OPT__(, ) __VA_ARGS__)

}  // namespace truequad::fuzz
