// Linked with libGL; also built as a plug-in, which plug_in_host loads.
#include "glx_window.h"

extern "C" [[gnu::visibility("default")]] int contexts_main(int, char**) {
  using namespace loaders;
  if (!open_window({glXChooseVisual, glXCreateContext, glXMakeCurrent})) return 4;
#define LOADERS_LINKED(name) gl##name,
  return show({LOADERS_FUNCTIONS(LOADERS_LINKED)});
#undef LOADERS_LINKED
}

int main(int argc, char** argv) { return contexts_main(argc, argv); }
