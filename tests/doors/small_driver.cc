// A driver that has almost nothing: the interface of OSMesa, handles from a row of numbers, and the few commands below.
// What it lacks a program cannot have been linked with; but programs look functions up, and call them unasked.
#include <dlfcn.h>

#include <atomic>
#include <cstdint>

#define EXPORT extern "C" [[gnu::visibility("default")]]

namespace {
std::atomic<std::uintptr_t> last_handle = 0;
std::atomic<int> begins = 0, ends = 0, vertices = 0;
}  // namespace

EXPORT int small_begins() { return begins; }
EXPORT int small_ends() { return ends; }
EXPORT int small_vertices() { return vertices; }

// Few handles, used again and again, as an allocator would give them.
EXPORT void* OSMesaCreateContext(unsigned, void*) { return reinterpret_cast<void*>(16 * (1 + last_handle++ % 64)); }
EXPORT unsigned char OSMesaMakeCurrent(void*, void*, unsigned, int, int) { return 1; }
EXPORT void OSMesaDestroyContext(void*) {}

// As some drivers do, it looks for itself in the global scope. What it finds there is ours.
EXPORT void* OSMesaGetProcAddress(const char* name) { return dlsym(RTLD_DEFAULT, name); }

EXPORT void glBegin(unsigned) { ++begins; }
EXPORT void glEnd() { ++ends; }
EXPORT void glVertex2f(float, float) { ++vertices; }
EXPORT void glTexCoord2f(float, float) {}
EXPORT void glNewList(unsigned, unsigned) {}
EXPORT void glEndList() {}
EXPORT void glCallList(unsigned) {}
EXPORT unsigned glGetError() { return 0; }
