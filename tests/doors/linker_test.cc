// The doors of dlsym() and dlopen() jump: run paths, RTLD_NEXT and RTLD_DEFAULT mean what they mean without them.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "run.h"

namespace truequad::doors_test {
namespace {

// dlopen(3), dlsym(3): a local plug-in is in its own scope but not in its loader's; RTLD_NEXT is behind the caller.
constexpr const char* kAnswers =
    "program: next 2\n"
    "program: default 1\n"
    "program: itself 1\n"
    "program: plug-in not found\n"
    "library: next 3\n"
    "library: plug-in found\n"
    "library: plug-in's layer 4, glBegin 5\n"
    "library: default -1\n"
    "plug-in: default 6\n"
    "program: 'glBegin' not found, dlerror says so\n"
    "program: 'glXMakeCurrent' not found, dlerror says so\n"
    "program: puts 1\n"
    "program: 'glBegin' not found, dlerror says so\n"
    "program: 'eglMakeCurrent' not found, dlerror says so\n"
    "program: 'glob' found, dlerror silent\n"
    "program: 'gl' not found, dlerror says so\n"
    "program: '' not found, dlerror says so\n";

TEST(Linker, AnswersAsWithoutUs) {
  // A sanitizer's runtime has a dlopen() of its own, which loses the run path of its caller.
  constexpr std::string_view kWithoutUs = TRUEQUAD_WITHOUT_US;
  const Ended natively = run({TRUEQUAD_LINKER_PROGRAM}, {{"LD_PRELOAD", std::string(kWithoutUs)}});
  EXPECT_EQ(natively.status, 0) << natively.err;
  if (kWithoutUs.empty()) {
    EXPECT_EQ(natively.out, kAnswers);
  }
  for (const char* dl : {"dlsym", "dlopen"}) {
    SCOPED_TRACE(dl);
    const Ended ended = run({TRUEQUAD_LINKER_PROGRAM}, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_DL", dl}});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(ended.out, natively.out);
    EXPECT_EQ(ended.err, "");
  }
}

}  // namespace
}  // namespace truequad::doors_test
