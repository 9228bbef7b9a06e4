// other_contexts CONTEXT FILE: immediate mode where there is none: a core profile and OpenGL ES, by EGL.
// Knows nothing of truequad.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "gl.h"
#include "record.h"

namespace truequad::semantics {
namespace {

void open_context(bool es) {
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
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
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglInitialize(display, nullptr, nullptr) && eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) &&
      eglChooseConfig(display, wanted, &config, 1, &count) && count == 1) {
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, es ? es2 : core);
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

}  // namespace
}  // namespace truequad::semantics

int main(int count, char** arguments) {
  using namespace truequad::semantics;
  if (count != 3) return 2;
  const bool es = std::string(arguments[1]) == "es";
  open_context(es);
  open_records(arguments[2]);
  glViewport(0, 0, kWidth, kHeight);
  for (int round = 0; round < 2; ++round) {
    const std::string name = std::to_string(round);
    glClear(GL_COLOR_BUFFER_BIT);
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
