// How many trials a random test makes. Under sanitizers, which look for other faults than wrong figures and make a trial some
// ten times slower, the first seeds only: one in `divisor`.
#pragma once

namespace truequad::test {

constexpr unsigned trials(unsigned number, [[maybe_unused]] unsigned divisor = 8) {
#if defined(__SANITIZE_ADDRESS__)
  return number / divisor;
#else
  return number;
#endif
}

}  // namespace truequad::test
