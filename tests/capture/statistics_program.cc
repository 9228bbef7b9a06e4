// A process that draws on the fake driver and ends in the way that its argument says; statistics_test.cc runs it.
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <thread>

#include "program.h"

using namespace truequad;
using namespace truequad::fake;

namespace {

// One corrected quad, two affine ones, one incomplete; and a list with one.
void draw() {
  make_current();
  gl().logging = false;
  doors().Begin(GL_QUADS);
  kTrapezoid.draw(doors());
  kSquare.draw(doors());
  kSquare.draw(doors());
  kSquare.vertex(doors(), 0);
  doors().End();
  doors().NewList(1, GL_COMPILE);
  doors().Begin(GL_QUADS);
  kTrapezoid.draw(doors());
  doors().End();
  doors().EndList();
  doors().CallList(1);
}

}  // namespace

int main(int, char** arguments) {
  const auto is = [&](const char* name) { return std::strcmp(arguments[1], name) == 0; };
  if (is("nothing")) {
    process_ends();
    return 0;
  }
  draw();
  if (is("threads")) {
    // The fake driver is one for all threads: they take turns.
    for (int i = 0; i < 3; ++i) std::thread(draw).join();
  } else if (is("fork-idle") || is("fork-draws")) {
    const pid_t child = ::fork();
    if (child == 0) {
      if (is("fork-draws")) draw();
      process_ends();
      ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
  } else if (is("vfork")) {
    const pid_t child = ::vfork();
    if (child == 0) {
      process_ends();  // what the door of _exit does
      ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
    draw();
  }
  process_ends();
  draw();
  process_ends();
  return 0;
}
