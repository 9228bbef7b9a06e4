// Random numbers that are the same on every machine (splitmix64, Steele, Lea and Flood 2014).
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>

namespace truequad::fuzz {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // 0 … n-1.
  int below(int n) { return int((next() >> 33) % std::uint64_t(n)); }
  bool chance(int percent) { return below(100) < percent; }
  double real(double from, double to) { return from + (to - from) * double(next() >> 11) * 0x1p-53; }
  template <typename T>
  T of(std::initializer_list<T> choices) {
    return choices.begin()[below(int(choices.size()))];
  }

 private:
  std::uint64_t state_;
};

}  // namespace truequad::fuzz
