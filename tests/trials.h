// How many trials a random test makes. Under sanitizers, which look for other faults than wrong figures and make a trial some
// ten times slower, fewer of the same seeds.
#pragma once

namespace truequad::test {

constexpr unsigned trials(unsigned number, [[maybe_unused]] unsigned fewer = 8) {
#if defined(__SANITIZE_ADDRESS__)
  return number / fewer;
#else
  return number;
#endif
}

}  // namespace truequad::test
