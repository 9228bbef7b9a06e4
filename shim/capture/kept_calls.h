// Calls that a display list holds with us instead of with the driver: vertices, attributes, glBegin and glEnd, made again
// whenever the list is called, as the program would make them. Arguments are kept as bytes, so nothing is rounded.
#pragma once

#include <cstddef>

#include "capture/entry.h"

namespace truequad {

class KeptCalls {
 public:
  KeptCalls() = default;
  ~KeptCalls();
  KeptCalls(const KeptCalls&) = delete;
  KeptCalls& operator=(const KeptCalls&) = delete;

  bool empty() const { return size_ == 0; }

  // Room for `size` more bytes; null if there is no memory.
  unsigned char* add(std::size_t size);

  // Makes the calls through the doors' own way, in order.
  void play(Entry& entry) const;

 private:
  unsigned char* bytes_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

// Where calls go while a list keeps them: attributes, glBegin and glEnd are added to entry.list's kept calls; everything
// else is the driver's, and opens its next part of the list first (list_compile.h).
extern const Driver keeping;

}  // namespace truequad
