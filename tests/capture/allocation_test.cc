// After a thread's first correction nothing of ours allocates: not for a corrected quad, not on the vertex path.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "../trials.h"
#include "program.h"

namespace {
std::atomic<long> allocations{0};
}

// The C library's allocator is counted below; the C++ operators call it.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
#if !defined(__SANITIZE_ADDRESS__)
void* malloc(std::size_t size) { return ++allocations, __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) { return ++allocations, __libc_calloc(count, size); }
void* realloc(void* old, std::size_t size) { return ++allocations, __libc_realloc(old, size); }
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return ++allocations, __libc_memalign(alignment, size);
}
#else
}
// The sanitizer owns malloc: what is left to count are the C++ operators.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  std::abort();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
extern "C" {
#endif
}

namespace truequad::fake {
namespace {

using test::trials;

void draw(const Driver& gl) {
  for (GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    gl.Begin(mode);
    for (int i = 0; i < 4; ++i) {
      gl.Color3ub(GLubyte(i), 0, 0);
      gl.Normal3f(0, float(i), 1);
      kTrapezoid.vertex(gl, mode == GL_QUAD_STRIP && i >= 2 ? 5 - i : i);
    }
    gl.End();
  }
}

TEST(Allocation, CorrectedQuadsNeedNone) {
  reset();
  make_current();
  gl().logging = false;
  draw(doors());
  const std::uint64_t quads = corrected();
  const long before = allocations;
  for (int i = 0; i < 100; ++i) draw(doors());
  EXPECT_EQ(allocations - before, 0);
  EXPECT_EQ(corrected() - quads, 300u);
}

// Of a primitive no more is held than the vertices of one quad, however many of its quads are corrected.
TEST(Allocation, TenMillionVerticesInOneBeginNeedNone) {
  reset();
  make_current();
  gl().logging = false;
  draw(doors());
  const unsigned quads = trials(2'500'000);
  for (GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    const long before = allocations;
    const std::uint64_t seen = passed() + corrected(), mended = corrected();
    doors().Begin(mode);
    for (unsigned i = 0; i < quads; ++i) {
      if (mode == GL_QUADS) {
        (i % 5000 ? kSquare : kTrapezoid).draw(doors());
      } else {
        for (int k : {0, 1, 3, 2}) kSquare.vertex(doors(), k);
      }
    }
    doors().End();
    EXPECT_EQ(allocations - before, 0) << mode;
    // A strip goes back and forth between two pairs of vertices; a polygon is one shape, and not ours.
    EXPECT_EQ(passed() + corrected() - seen, mode == GL_QUADS ? quads : mode == GL_QUAD_STRIP ? 2 * quads - 1 : 0u);
    EXPECT_EQ(corrected() - mended, mode == GL_QUADS ? (quads + 4999) / 5000 : 0u);
  }
}

TEST(Allocation, TheCounterCounts) {
  const long before = allocations;
  std::vector<int>* const x = new std::vector<int>(1000);
  EXPECT_GE(allocations - before, 2);
  delete x;
}

}  // namespace
}  // namespace truequad::fake
