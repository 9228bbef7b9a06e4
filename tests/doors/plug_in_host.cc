// plug_in_host local|global|deepbind FILE WORD…: a program that is linked with no OpenGL at all and loads a plug-in that is.
#include <dlfcn.h>

#include <cstdio>
#include <cstring>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const int scope = std::strcmp(argv[1], "global") == 0     ? RTLD_GLOBAL
                    : std::strcmp(argv[1], "deepbind") == 0 ? RTLD_LOCAL | RTLD_DEEPBIND
                                                            : RTLD_LOCAL;
  void* plug_in = dlopen(argv[2], RTLD_NOW | scope);
  if (!plug_in) {
    std::fprintf(stderr, "plug_in_host: %s\n", dlerror());
    return 71;
  }
  const auto run = reinterpret_cast<int (*)(int, char**)>(dlsym(plug_in, "contexts_main"));
  return run ? run(argc - 3, argv + 3) : 72;
}
