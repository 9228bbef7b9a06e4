// other_contexts CONTEXT FILE: contexts by EGL in which immediate mode is not there (core, es) or that differ in what
// becomes of errors (debug, robust, no_error). Knows nothing of truequad.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "gl.h"
#include "record.h"

namespace truequad::semantics {
namespace {

void open_context(const std::string& kind) {
  const bool es = kind == "es";
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           es ? EGL_OPENGL_ES2_BIT : EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_NONE};
  const EGLint size[] = {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight, EGL_NONE};
  const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION,
                         3,
                         EGL_CONTEXT_MINOR_VERSION,
                         3,
                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                         EGL_NONE};
  const EGLint es2[] = {EGL_CONTEXT_MAJOR_VERSION, 2, EGL_NONE};
  const EGLint debug[] = {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE};
  const EGLint robust[] = {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE, EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                           EGL_LOSE_CONTEXT_ON_RESET, EGL_NONE};
  const EGLint plain[] = {EGL_NONE};
  // Mesa's software drivers refuse EGL_CONTEXT_OPENGL_NO_ERROR_KHR, and make such contexts of all by this.
  if (kind == "no_error") ::setenv("MESA_NO_ERROR", "1", 1);
  const EGLint* const attributes = es                   ? es2
                                   : kind == "core"     ? core
                                   : kind == "debug"    ? debug
                                   : kind == "robust"   ? robust
                                                        : plain;
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglInitialize(display, nullptr, nullptr) && eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) &&
      eglChooseConfig(display, wanted, &config, 1, &count) && count == 1) {
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (eglMakeCurrent(display, surface, surface, context)) return;
  }
  std::fprintf(stderr, "no context: 0x%x\n", unsigned(eglGetError()));
  std::exit(70);
}

GLuint compile(GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

void triangle(bool es) {
  const std::string head = es ? "precision mediump float;" : "#version 150\n";
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile(GL_VERTEX_SHADER, (es ? "attribute vec4 at;" : head + "in vec4 at;") +
                                                        std::string("void main() { gl_Position = at; }")));
  glAttachShader(program,
                 compile(GL_FRAGMENT_SHADER,
                         es ? head + "void main() { gl_FragColor = vec4(0.2, 0.4, 0.6, 1.0); }"
                            : head + "out vec4 colour; void main() { colour = vec4(0.2, 0.4, 0.6, 1.0); }"));
  glBindAttribLocation(program, 0, "at");
  glLinkProgram(program);
  glUseProgram(program);
  const float corners[] = {-0.9f, -0.8f, 0.7f, -0.9f, 0.1f, 0.9f};
  GLuint names[2] = {};
  if (!es) {
    glGenVertexArrays(1, &names[0]);
    glBindVertexArray(names[0]);
  }
  glGenBuffers(1, &names[1]);
  glBindBuffer(GL_ARRAY_BUFFER, names[1]);
  glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void errors(const std::string& name) {
  std::vector<GLenum> found;
  for (int i = 0; i < 20; ++i) found.push_back(glGetError());
  record(name, found);
}

// In the compatibility profile: warped quads of one colour, and an error that the debug log has where errors are errors.
void warped_quads(bool may_err, const std::string& name) {
  glUseProgram(0);
  const GLubyte white[] = {255, 255, 255, 255};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
  glEnable(GL_TEXTURE_2D);
  glColor3f(0.2f, 0.4f, 0.6f);
  for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    glBegin(mode);
    const float corners[4][2] = {{-0.9f, -1}, {0.8f, -0.9f}, {0.25f, 1}, {-0.5f, 0.9f}};
    for (int i = 0; i < 4; ++i) {
      const auto& corner = corners[mode == GL_QUAD_STRIP ? i ^ (i >> 1) : i];
      glTexCoord2f(corner[0] > 0, corner[1] > 0);
      glVertex2f(corner[0], corner[1]);
      if (may_err && mode == GL_POLYGON && i == 2) glEnable(GL_LIGHTING);
    }
    glEnd();
  }
  GLint flags = 0, waiting = 0;
  glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
  glGetIntegerv(GL_DEBUG_LOGGED_MESSAGES, &waiting);
  const GLint numbers[] = {flags, waiting, GLint(glGetGraphicsResetStatus())};
  record("numbers " + name, numbers, sizeof numbers);
  errors("errors of the quads " + name);
  record_picture("picture " + name);
}

}  // namespace
}  // namespace truequad::semantics

int main(int count, char** arguments) {
  using namespace truequad::semantics;
  if (count != 3) return 2;
  const std::string kind = arguments[1];
  const bool es = kind == "es";
  open_context(kind);
  open_records(arguments[2]);
  glViewport(0, 0, kWidth, kHeight);
  for (int round = 0; round < 2; ++round) {
    const std::string name = std::to_string(round);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!es && kind != "core") {
      warped_quads(kind != "no_error", name);
      continue;
    }
    triangle(es);
    errors("errors of the triangle " + name);
    // Neither has glBegin: every call is an error or nothing.
    glBegin(GL_QUADS);
    const float corners[4][2] = {{-1, -1}, {1, -1}, {0.5f, 1}, {-0.5f, 1}};
    for (const auto& corner : corners) {
      glTexCoord2f(corner[0] > 0, corner[1] > 0);
      glVertex2f(corner[0], corner[1]);
    }
    glEnd();
    errors("errors of the quad " + name);
    record_picture("picture " + name);
    GLint program = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    record("program " + name, &program, sizeof program);
  }
  return close_records() ? 0 : 1;
}
