// small_program CHECK: uses the small driver, or none, through whatever the global scope offers, and returns 0 if what
// it saw is right. With the library preloaded every name of the registry is there.
//   none       no driver at all: every command is called with zeros
//   no-window  no driver at all: contexts are created and made current in vain, twice
//   nothing    no driver at all: dlsym() knows no command, and says why
//   own        the small driver: dlsym() knows its eight commands
//   all        the small driver: every command but Begin, End and the lists' is called with zeros, twice
//   quads      the small driver: quads that are not affine, between Begin and End
//   contexts N the small driver: N contexts are created, made current, drawn into, given a list, and destroyed
//              (some share lists with the one before, some are current then); memory must not grow
#include <dlfcn.h>
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "driver/driver.h"

namespace {

void* symbol(const char* name) { return dlsym(RTLD_DEFAULT, name); }

template <typename Result, typename... Parameters>
bool call_with_zeros(const char* name, Result (*)(Parameters...)) {
  const auto function = reinterpret_cast<Result (*)(Parameters...)>(symbol(name));
  if (!function) {
    std::printf("%s is not there\n", name);
    return false;
  }
  if constexpr (std::is_void_v<Result>) {
    function(Parameters()...);
  } else if (function(Parameters()...) != Result()) {
    std::printf("%s returned something\n", name);
    return false;
  }
  return true;
}

// These change what the next calls mean.
bool stateful(const char* name) {
  for (const char* other : {"glBegin", "glEnd", "glNewList", "glEndList"}) {
    if (!std::strcmp(name, other)) return true;
  }
  return false;
}

bool call_all() {
  bool good = true;
#define TQ_COMMAND(name, result, parameters, arguments) \
  good &= stateful("gl" #name) || call_with_zeros("gl" #name, static_cast<result(*) parameters>(nullptr));
#include "gl_commands.inc"
#undef TQ_COMMAND
  return good;
}

// The number of commands that dlsym() knows; dlerror() has something to say exactly if it does not.
bool has_commands(int expected) {
  int count = 0;
  bool good = true;
  for (const char* name : {
#define TQ_COMMAND(name, result, parameters, arguments) "gl" #name,
#include "gl_commands.inc"
#undef TQ_COMMAND
       }) {
    dlerror();
    const bool known = dlsym(RTLD_DEFAULT, name) != nullptr;
    if (known == (dlerror() != nullptr)) std::printf("%s: dlerror is wrong\n", name), good = false;
    void* const program = dlopen(nullptr, RTLD_LAZY);
    dlerror();
    if (known != (dlsym(program, name) != nullptr)) std::printf("%s: the program's handle differs\n", name), good = false;
    if (known == (dlerror() != nullptr)) std::printf("%s: dlerror is wrong by handle\n", name), good = false;
    count += known;
  }
  std::printf("%d commands\n", count);
  return good && count == expected;
}

// The commands as a program has them.
struct Gl {
#define TQ_FIND(name) decltype(truequad::Driver::name) name = reinterpret_cast<decltype(name)>(symbol("gl" #name))
  TQ_FIND(Begin);
  TQ_FIND(End);
  TQ_FIND(TexCoord2f);
  TQ_FIND(Vertex2f);
  TQ_FIND(NewList);
  TQ_FIND(EndList);
  TQ_FIND(CallList);
#undef TQ_FIND
};

void draw_quad(const Gl& gl, float tip) {
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(0, 0), gl.Vertex2f(-1, -1);
  gl.TexCoord2f(1, 0), gl.Vertex2f(1, -1);
  gl.TexCoord2f(1, 1), gl.Vertex2f(tip, 1);
  gl.TexCoord2f(0, 1), gl.Vertex2f(-tip, 1);
  gl.End();
}

struct Osmesa {
  void* (*create)(unsigned, void*) = reinterpret_cast<decltype(create)>(symbol("OSMesaCreateContext"));
  unsigned char (*make_current)(void*, void*, unsigned, int, int) =
      reinterpret_cast<decltype(make_current)>(symbol("OSMesaMakeCurrent"));
  void (*destroy)(void*) = reinterpret_cast<decltype(destroy)>(symbol("OSMesaDestroyContext"));
};

bool refuse_contexts() {
  const Osmesa osmesa;
  char picture[4];
  return !osmesa.create(0, nullptr) && !osmesa.make_current(nullptr, picture, GL_UNSIGNED_BYTE, 1, 1);
}

int number(const char* name) { return reinterpret_cast<int (*)()>(symbol(name))(); }

bool check_quads() {
  const Gl gl;
  const Osmesa osmesa;
  char picture[4];
  if (!osmesa.make_current(osmesa.create(0, nullptr), picture, GL_UNSIGNED_BYTE, 1, 1)) return false;
  for (int i = 0; i < 100; ++i) draw_quad(gl, i % 2 ? 1.0f : 0.5f);
  // Every Begin of the program reached the driver, each was ended, and no quad was lost.
  if (number("small_begins") < 100 || number("small_begins") != number("small_ends")) return false;
  return number("small_vertices") >= 400;
}

void use_contexts(const Gl& gl, const Osmesa& osmesa, int count) {
  char picture[4];
  void* before = nullptr;
  for (int i = 0; i < count; ++i) {
    void* context = osmesa.create(0, i % 3 ? nullptr : before);
    osmesa.make_current(context, picture, GL_UNSIGNED_BYTE, 1, 1);
    // Split, as nobody has asked yet what the driver can do.
    gl.NewList(GLuint(i % 5 + 1), GL_COMPILE);
    draw_quad(gl, 0.5f);
    // One in seven is left in the middle of its list.
    if (i % 7) {
      gl.EndList();
      gl.CallList(GLuint(i % 5 + 1));
    }
    draw_quad(gl, 0.5f);
    // Some are destroyed while they are current, some after that.
    if (i % 2) osmesa.make_current(nullptr, nullptr, 0, 0, 0);
    if (before) osmesa.destroy(before);
    before = context;
  }
  osmesa.destroy(before);
}

bool check_contexts(int count) {
  const Gl gl;
  const Osmesa osmesa;
  use_contexts(gl, osmesa, 1000);
  const std::size_t before = ::mallinfo2().uordblks;
  use_contexts(gl, osmesa, count);
  const std::size_t after = ::mallinfo2().uordblks;
  std::printf("%zu bytes before, %zu after %d contexts\n", before, after, count);
  return after <= before;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string check = argc > 1 ? argv[1] : "";
  if (check == "none") return call_all() ? 0 : 1;
  if (check == "no-window") return refuse_contexts() && refuse_contexts() ? 0 : 1;
  if (check == "nothing") return has_commands(0) ? 0 : 1;
  if (check == "own") return has_commands(8) ? 0 : 1;
  if (check == "all") return call_all() && call_all() ? 0 : 1;
  if (check == "quads") return check_quads() ? 0 : 1;
  if (check == "contexts" && argc == 3) return check_contexts(std::atoi(argv[2])) ? 0 : 1;
  return 2;
}
