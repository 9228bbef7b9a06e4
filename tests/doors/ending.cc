// ending PIECE…: a program that draws a number of quads into OSMesa or ends in one of the ways that a process can end.
//   N            draws N textured quads that are not affine
//   return exit _exit _Exit quick_exit
//   abort        SIGABRT
//   fork         goes on in a child; the parent waits for it and then goes on behind the next "joined"
//   joined       where the parent of a fork goes on
//   vfork        a child of vfork() that calls _exit at once; goes on
//   exec PIECE…  becomes this program again
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

constexpr int kSize = 32;
unsigned char picture[kSize * kSize * 4];

void open_context() {
  static OSMesaContext context = nullptr;
  if (context) return;
  context = OSMesaCreateContextExt(OSMESA_RGBA, 16, 0, 0, nullptr);
  if (!context || !OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, kSize, kSize)) std::_Exit(70);
  const unsigned char texels[4 * 4] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 0, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
}

void draw(int quads) {
  open_context();
  glBegin(GL_QUADS);
  for (int i = 0; i < quads; ++i) {
    glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
    glTexCoord2f(1, 0), glVertex2f(0.9f, -0.9f);
    glTexCoord2f(1, 1), glVertex2f(0.2f, 0.9f);
    glTexCoord2f(0, 1), glVertex2f(-0.2f, 0.9f);
  }
  glEnd();
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const char* piece = argv[i];
    const auto is = [&](const char* name) { return std::strcmp(piece, name) == 0; };
    if (is("return")) return 3;
    if (is("exit")) std::exit(3);
    if (is("_exit")) ::_exit(3);
    if (is("_Exit")) std::_Exit(3);
    if (is("quick_exit")) std::quick_exit(3);
    if (is("abort")) std::abort();
    if (is("joined")) continue;
    if (is("fork")) {
      if (const pid_t child = ::fork()) {
        int state = 0;
        ::waitpid(child, &state, 0);
        while (i < argc && std::strcmp(argv[i], "joined") != 0) ++i;
      }
    } else if (is("vfork")) {
      if (const pid_t child = ::vfork(); child == 0) {
        ::_exit(0);
      } else {
        int state = 0;
        ::waitpid(child, &state, 0);
      }
    } else if (is("exec")) {
      std::vector<char*> words(argv + i, argv + argc);
      words[0] = argv[0];
      words.push_back(nullptr);
      ::execv("/proc/self/exe", words.data());
      return 71;
    } else {
      draw(std::atoi(piece));
    }
  }
}
