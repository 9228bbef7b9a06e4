// font_lists: lists that the window system makes (glXUseXFont), before, behind and in the place of lists with a quad that needs
// correction. Prints what can be asked of them and a sum of the picture's text, which lies beside the quads.
#include <GL/gl.h>
#include <GL/glx.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr int kWidth = 160, kHeight = 120;

void quad() {
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-0.9f, 0);
  glTexCoord2f(1, 0), glVertex2f(0.9f, 0);
  glTexCoord2f(1, 1), glVertex2f(0.3f, 0.9f);
  glTexCoord2f(0, 1), glVertex2f(-0.3f, 0.9f);
  glEnd();
}

void write(GLuint base, const char* text, float y) {
  glDisable(GL_TEXTURE_2D);
  glRasterPos2f(-0.9f, y);
  glListBase(base);
  glCallLists(GLsizei(std::strlen(text)), GL_UNSIGNED_BYTE, text);
  glListBase(0);
  glEnable(GL_TEXTURE_2D);
}

void say(const char* what) {
  // The lower half has the text alone.
  std::vector<unsigned char> pixels(kWidth * kHeight / 2 * 4);
  glReadPixels(0, 0, kWidth, kHeight / 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  std::uint64_t sum = 0;
  for (unsigned char byte : pixels) sum = sum * 1099511628211u + byte;
  std::printf("%s: text %016llx lists", what, (unsigned long long)sum);
  for (GLuint name : {1u, 40u, 65u, 127u, 128u, 300u, 365u}) std::printf(" %d", glIsList(name));
  std::printf(" free %u error %x\n", glGenLists(3), glGetError());
}

void compile(GLuint name) {
  glNewList(name, GL_COMPILE);
  quad();
  glEndList();
}

}  // namespace

int main() {
  Display* const display = XOpenDisplay(nullptr);
  if (!display) return 70;
  const XFontStruct* const font = XLoadQueryFont(display, "fixed");
  int wanted[] = {GLX_RGBA, GLX_RED_SIZE, 8, None};
  XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), wanted);
  if (!font || !visual) return 70;
  XSetWindowAttributes attributes{};
  const Window root = RootWindow(display, visual->screen);
  attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
  const Window window = XCreateWindow(display, root, 0, 0, kWidth, kHeight, 0, visual->depth, InputOutput, visual->visual,
                                      CWColormap, &attributes);
  XMapWindow(display, window);
  const GLXContext context = glXCreateContext(display, visual, nullptr, True);
  if (!context || !glXMakeCurrent(display, window, context)) return 70;
  const unsigned char texels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);

  compile(65);
  glCallList(65);
  say("a quad");
  glXUseXFont(font->fid, 32, 96, 32);
  write(0, "A quad no more", -0.3f);
  say("in its place");
  compile(300);
  glXUseXFont(font->fid, 32, 96, 300 + 32);
  write(300, "behind it", -0.6f);
  glCallList(300);
  say("behind");
  compile(365);
  glCallList(365);
  write(300, "A nd C", -0.9f);
  say("a letter is a quad");
  glDeleteLists(32, 96);
  write(0, "gone", -0.1f);
  say("deleted");
  // While a list is compiled it makes none.
  glNewList(1, GL_COMPILE);
  glXUseXFont(font->fid, 32, 96, 32);
  quad();
  glEndList();
  say("compiling");
  glCallList(1);
  write(0, "not there", -0.2f);
  say("called");
  glBegin(GL_QUADS);
  glXUseXFont(font->fid, 32, 96, 32);
  glEnd();
  say("inside Begin");
  XSync(display, False);
}
