// flags INTERFACE FLAG…: a compatibility context of EGL or GLX that is made with flags, and what a program can learn in it. Knows nothing of
// truequad; but for the lines that begin with "picture", runs can be compared.
//   egl glx
//   debug      messages are heard, at once
//   robust     out-of-range accesses have no effect, resets are noticed
//   no-error   errors are undefined, so none are made. Software drivers refuse the attribute (EGL_CONTEXT_OPENGL_NO_ERROR_KHR,
//              GLX_CONTEXT_OPENGL_NO_ERROR_ARB); MESA_NO_ERROR=1 makes such contexts
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace {

constexpr int kSize = 64;

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "flags: %s failed\n", what);
  std::exit(70);
}

using Flags = std::set<std::string>;
using GetProcAddress = void* (*)(const char*);

GetProcAddress open_egl(const Flags& flags) {
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) fail("eglInitialize");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8,
                           EGL_DEPTH_SIZE,   16,              EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) fail("eglChooseConfig");
  const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  std::vector<EGLint> attributes;
  if (flags.contains("debug")) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
  if (flags.contains("robust")) {
    attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE,
                                         EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
  }
  attributes.push_back(EGL_NONE);
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) fail("eglCreateContext");
  if (!eglMakeCurrent(display, surface, surface, context)) fail("eglMakeCurrent");
  return [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); };
}

GetProcAddress open_glx(const Flags& flags) {
  Display* const display = XOpenDisplay(nullptr);
  if (!display) fail("XOpenDisplay");
  const int wanted[] = {GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 16, None};
  int count = 0;
  GLXFBConfig* const configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  if (!configs || count == 0) fail("glXChooseFBConfig");
  const int size[] = {GLX_PBUFFER_WIDTH, kSize, GLX_PBUFFER_HEIGHT, kSize, None};
  const GLXPbuffer pbuffer = glXCreatePbuffer(display, configs[0], size);
  int bits = 0;
  if (flags.contains("debug")) bits |= GLX_CONTEXT_DEBUG_BIT_ARB;
  if (flags.contains("robust")) bits |= GLX_CONTEXT_ROBUST_ACCESS_BIT_ARB;
  std::vector<int> attributes;
  if (bits) attributes.insert(attributes.end(), {GLX_CONTEXT_FLAGS_ARB, bits});
  if (flags.contains("robust")) {
    attributes.insert(attributes.end(),
                      {GLX_CONTEXT_RESET_NOTIFICATION_STRATEGY_ARB, GLX_LOSE_CONTEXT_ON_RESET_ARB});
  }
  attributes.push_back(None);
  const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
      glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
  const GLXContext context = create(display, configs[0], nullptr, True, attributes.data());
  if (!context) fail("glXCreateContextAttribsARB");
  if (!glXMakeContextCurrent(display, pbuffer, pbuffer, context)) fail("glXMakeContextCurrent");
  return [](const char* name) {
    return reinterpret_cast<void*>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name)));
  };
}

// In the place where the program is then: a message that comes at once comes between the program's own lines.
void GLAPIENTRY hear(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei, const GLchar* text, const void*) {
  std::printf("  message %#x %#x %u %#x %s\n", source, type, id, severity, text);
}

void quads(float tip) {
  glBegin(GL_QUADS);
  for (int i = 0; i < 3; ++i) {
    glTexCoord2f(0, 0), glVertex3f(-0.9f, -0.9f, 0.1f * float(i));
    glTexCoord2f(1, 0), glVertex3f(0.9f, -0.9f, 0.1f * float(i));
    glTexCoord2f(1, 1), glVertex3f(tip, 0.9f, 0.1f * float(i));
    glTexCoord2f(0, 1), glVertex3f(-tip, 0.9f, 0.1f * float(i));
  }
  glEnd();
}

void say_picture(const char* what) {
  std::vector<unsigned char> pixels(kSize * kSize * 4);
  glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  std::uint64_t sum = 14695981039346656037u;  // FNV-1a
  for (unsigned char byte : pixels) sum = (sum ^ byte) * 1099511628211u;
  std::printf("%s %016llx\n", what, (unsigned long long)sum);
}

void draw(const char* what, float tip, bool errors) {
  std::printf("%s\n", what);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  quads(tip);
  glEnable(GL_LIGHTING), glEnable(GL_LIGHT0);
  const GLfloat near[] = {0, 0, -0.5f, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, near);
  quads(tip);
  glDisable(GL_LIGHTING);
  glNewList(1, GL_COMPILE);
  quads(tip);
  glEndList();
  glCallList(1);
  if (!errors) return;
  // GL 2.1 section 2.6.3: errors between Begin and End.
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnd();
  std::printf("Clear in Begin: %#x\n", glGetError());
  glBegin(0x1234);
  std::printf("Begin of nothing: %#x\n", glGetError());
  glEnd();
  std::printf("End of nothing: %#x\n", glGetError());
  glEndList();
  std::printf("EndList of nothing: %#x\n", glGetError());
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) return 2;
  const Flags flags(words + 2, words + count);
  const GetProcAddress get = words[1] == std::string("glx") ? open_glx(flags) : open_egl(flags);
  std::setvbuf(stdout, nullptr, _IOLBF, 1 << 16);

  GLint value = 0;
  glGetIntegerv(GL_CONTEXT_FLAGS, &value);
  std::printf("context flags %#x\n", value);
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &value);
  std::printf("profile %#x\n", value);
  if (flags.contains("robust")) {
    glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &value);
    std::printf("reset strategy %#x\n", value);
  }
  if (flags.contains("debug")) {
    reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(get("glDebugMessageCallback"))(hear, nullptr);
    reinterpret_cast<PFNGLDEBUGMESSAGECONTROLPROC>(get("glDebugMessageControl"))(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0,
                                                                                nullptr, GL_TRUE);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  }

  unsigned char texels[16 * 16];
  for (int i = 0; i < 16 * 16; ++i) texels[i] = (unsigned char)(i * 37 % 256);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 16, 16, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_DEPTH_TEST);
  glViewport(0, 0, kSize, kSize);

  const bool errors = !flags.contains("no-error");
  draw("affine", 0.9f, errors);
  say_picture("affine picture");
  draw("warped", 0.3f, errors);
  say_picture("picture");
  if (flags.contains("robust")) {
    const auto status = reinterpret_cast<PFNGLGETGRAPHICSRESETSTATUSPROC>(get("glGetGraphicsResetStatus"));
    std::printf("reset status %#x\n", status ? status() : 1);
  }
  std::printf("left over: %#x\n", glGetError());
  return 0;
}
