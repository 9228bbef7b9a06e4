// What the dynamic linker answers depends on who asks. This program and its library ask in all the ways that do, and
// print the answers; whoever stands between them and the linker must not change a word.
#include <dlfcn.h>

#include <cstdio>
#include <initializer_list>

extern "C" {
void ask_from_library();
[[gnu::visibility("default")]] int layer() { return 1; }
}

namespace {
void try_to_find(void* library, const char* name) {
  const bool found = dlsym(library, name) != nullptr;
  std::printf("program: '%s' %s, dlerror %s\n", name, found ? "found" : "not found", dlerror() ? "says so" : "silent");
}

int call(void* function) { return function ? reinterpret_cast<int (*)()>(function)() : -1; }
}  // namespace

int main() {
  std::printf("program: next %d\n", call(dlsym(RTLD_NEXT, "layer")));
  std::printf("program: default %d\n", call(dlsym(RTLD_DEFAULT, "layer")));
  std::printf("program: itself %d\n", call(dlsym(dlopen(nullptr, RTLD_LAZY), "layer")));
  // The run path that leads to it is the library's, not the program's.
  std::printf("program: plug-in %s\n", dlopen("libtq_linker_plug_in.so", RTLD_LAZY) ? "found" : "not found");
  ask_from_library();
  try_to_find(RTLD_NEXT, "glBegin");
  try_to_find(RTLD_DEFAULT, "glXMakeCurrent");
  void* const library = dlopen("libc.so.6", RTLD_LAZY);
  std::printf("program: puts %d\n", dlsym(library, "puts") == dlsym(RTLD_DEFAULT, "puts"));
  for (const char* name : {"glBegin", "eglMakeCurrent", "glob", "gl", ""}) try_to_find(library, name);
}
