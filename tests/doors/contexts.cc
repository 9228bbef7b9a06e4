// contexts WORD…: a program that uses OSMesa, GLX and EGL in one process. It knows nothing of truequad; every word prints
// lines that can be compared between runs.
//   osmesa glx egl          makes that API's context (64 × 64, off the screen) current on this thread
//   core gles               likewise, EGL's contexts of a core profile and of OpenGL ES 2
//   no-osmesa no-glx no-egl releases that API's context
//   affine warped           draws quads with the functions that the API's getProcAddress gives; prints the picture's sum
//   linked-affine …         likewise, with the functions that the program was linked with
//   illegal                 illegal calls inside Begin/End; prints the errors
//   triangle                a triangle by shader; prints the picture's sum and the errors
//   threads                 two threads for each API draw at once; prints the sums, each once
//   again N                 creates and destroys N contexts of each API, each drawn into; prints the last sums
//   names                   prints which names getProcAddress knows, of those on the standard input; behind each which
//                           library has it, if TRUEQUAD_TEST_WHERE is set
#include "contexts.h"

#include <EGL/egl.h>
#include <GL/glx.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr int kSize = 64;

// The functions that the scenes use, from wherever the program has them.
struct Gl {
#define FUNCTIONS(X)                                                                                              \
  X(Begin) X(End) X(TexCoord2f) X(Vertex2f) X(Clear) X(ClearColor) X(Enable) X(TexImage2D) X(TexParameteri)       \
  X(ReadPixels) X(GetError) X(Viewport) X(Finish) X(Color3f) X(PixelStorei) X(LoadIdentity) X(NewList) X(EndList)
#define DECLARE(name) decltype(&gl##name) name;
  FUNCTIONS(DECLARE)
#undef DECLARE
  void (*MultiTexCoord2fARB)(GLenum, GLfloat, GLfloat);
};

using GetProcAddress = void* (*)(const char*);

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "contexts: %s failed\n", what);
  std::exit(70);
}

Gl functions_of(GetProcAddress get) {
  Gl gl;
#define FIND(name)                                             \
  gl.name = reinterpret_cast<decltype(gl.name)>(get("gl" #name)); \
  if (!gl.name) fail("getProcAddress of gl" #name);
  FUNCTIONS(FIND)
  FIND(MultiTexCoord2fARB)
#undef FIND
  return gl;
}

Gl linked_functions() {
  Gl gl;
#define FIND(name) gl.name = &gl##name;
  FUNCTIONS(FIND)
  FIND(MultiTexCoord2fARB)
#undef FIND
  return gl;
}

// ---- The three APIs -------------------------------------------------------------------------------------------------

class Context {
 public:
  virtual ~Context() = default;
  virtual void make_current() = 0;
  virtual void release() = 0;
  virtual void* get(const char* name) = 0;
};

class OsmesaContext : public Context {
 public:
  OsmesaContext() : context_(OSMesaCreateContextExt(OSMESA_RGBA, 16, 0, 0, nullptr)) {
    if (!context_) fail("OSMesaCreateContextExt");
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }
  void make_current() override {
    if (!OSMesaMakeCurrent(context_, picture_, GL_UNSIGNED_BYTE, kSize, kSize)) fail("OSMesaMakeCurrent");
  }
  void release() override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }
  void* get(const char* name) override { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

 private:
  OSMesaContext context_;
  unsigned char picture_[kSize * kSize * 4] = {};
};

Display* x_display() {
  static Display* const display = [] {
    XInitThreads();
    return XOpenDisplay(nullptr);
  }();
  if (!display) fail("XOpenDisplay");
  return display;
}

class GlxContext : public Context {
 public:
  GlxContext() {
    const int wanted[] = {GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT, GLX_RED_SIZE,   8,  GLX_GREEN_SIZE, 8,
                          GLX_BLUE_SIZE,     8,               GLX_DEPTH_SIZE, 16, None};
    int count = 0;
    GLXFBConfig* configs = glXChooseFBConfig(x_display(), DefaultScreen(x_display()), wanted, &count);
    if (!configs || count == 0) fail("glXChooseFBConfig");
    const int size[] = {GLX_PBUFFER_WIDTH, kSize, GLX_PBUFFER_HEIGHT, kSize, None};
    pbuffer_ = glXCreatePbuffer(x_display(), configs[0], size);
    context_ = glXCreateNewContext(x_display(), configs[0], GLX_RGBA_TYPE, nullptr, True);
    XFree(configs);
    if (!context_) fail("glXCreateNewContext");
  }
  ~GlxContext() override {
    glXDestroyContext(x_display(), context_);
    glXDestroyPbuffer(x_display(), pbuffer_);
  }
  void make_current() override {
    if (!glXMakeContextCurrent(x_display(), pbuffer_, pbuffer_, context_)) fail("glXMakeContextCurrent");
  }
  void release() override { glXMakeCurrent(x_display(), None, nullptr); }
  void* get(const char* name) override {
    return reinterpret_cast<void*>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name)));
  }

 private:
  GLXPbuffer pbuffer_;
  GLXContext context_;
};

EGLDisplay egl_display() {
  static const EGLDisplay display = [] {
    const EGLDisplay opened = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    return eglInitialize(opened, nullptr, nullptr) ? opened : EGL_NO_DISPLAY;
  }();
  if (display == EGL_NO_DISPLAY) fail("eglInitialize");
  return display;
}

class EglContext : public Context {
 public:
  EglContext() : EglContext(EGL_OPENGL_API, EGL_OPENGL_BIT, {EGL_NONE}) {}
  EglContext(EGLenum api, EGLint bit, std::vector<EGLint> attributes) : api_(api) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, bit,
                             EGL_RED_SIZE,     8,               EGL_DEPTH_SIZE,      16, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    if (!eglChooseConfig(egl_display(), wanted, &config, 1, &count) || count == 0) fail("eglChooseConfig");
    const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
    surface_ = eglCreatePbufferSurface(egl_display(), config, size);
    eglBindAPI(api_);
    context_ = eglCreateContext(egl_display(), config, EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext");
  }
  ~EglContext() override {
    eglDestroyContext(egl_display(), context_);
    eglDestroySurface(egl_display(), surface_);
  }
  void make_current() override {
    eglBindAPI(api_);
    if (!eglMakeCurrent(egl_display(), surface_, surface_, context_)) fail("eglMakeCurrent");
  }
  void release() override {
    eglBindAPI(api_);
    eglMakeCurrent(egl_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  void* get(const char* name) override { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

 private:
  EGLenum api_;
  EGLSurface surface_;
  EGLContext context_;
};

std::unique_ptr<Context> open(const std::string& kind) {
  if (kind == "osmesa") return std::make_unique<OsmesaContext>();
  if (kind == "glx") return std::make_unique<GlxContext>();
  if (kind == "egl") return std::make_unique<EglContext>();
  if (kind == "core") {
    return std::make_unique<EglContext>(
        EGL_OPENGL_API, EGL_OPENGL_BIT,
        std::vector<EGLint>{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE});
  }
  if (kind == "gles") {
    return std::make_unique<EglContext>(EGL_OPENGL_ES_API, EGL_OPENGL_ES2_BIT,
                                        std::vector<EGLint>{EGL_CONTEXT_MAJOR_VERSION, 2, EGL_NONE});
  }
  return nullptr;
}

const char* const kKinds[] = {"osmesa", "glx", "egl"};

template <Context* (*current)()>
void* get_of_current(const char* name) {
  return current()->get(name);
}

// ---- Scenes ---------------------------------------------------------------------------------------------------------

std::uint64_t sum_of_picture(const Gl& gl) {
  unsigned char pixels[kSize * kSize * 4] = {};
  gl.Finish();
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  std::uint64_t sum = 14695981039346656037u;  // FNV-1a
  for (unsigned char byte : pixels) sum = (sum ^ byte) * 1099511628211u;
  return sum;
}

void prepare(const Gl& gl) {
  unsigned char texels[16 * 16 * 3];
  for (int i = 0; i < 16 * 16; ++i) {
    texels[3 * i] = (unsigned char)(i % 16 * 16);
    texels[3 * i + 1] = (unsigned char)(i / 16 * 16);
    texels[3 * i + 2] = (unsigned char)((i % 2 ^ i / 16 % 2) * 255);
  }
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.Viewport(0, 0, kSize, kSize);
  gl.ClearColor(0.25f, 0.5f, 0.75f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

// `tip` 1: a square, whose map is affine.
void quad(const Gl& gl, float tip) {
  gl.TexCoord2f(0, 0), gl.Vertex2f(-0.9f, -0.9f);
  gl.TexCoord2f(1, 0), gl.Vertex2f(0.9f, -0.9f);
  gl.MultiTexCoord2fARB(GL_TEXTURE0_ARB, 1, 1), gl.Vertex2f(0.9f * tip, 0.9f);
  gl.TexCoord2f(0, 1), gl.Vertex2f(-0.9f * tip, 0.9f);
}

std::uint64_t draw(const Gl& gl, bool warped) {
  prepare(gl);
  gl.Begin(GL_QUADS);
  quad(gl, 1);
  if (warped) quad(gl, 0.3f);
  gl.End();
  if (const GLenum error = gl.GetError()) std::printf("error %#x\n", error);
  return sum_of_picture(gl);
}

// GL 2.1 section 2.6.3: what else is called between Begin and End is an error.
void illegal(const Gl& gl) {
  prepare(gl);
  const auto say = [&](const char* what) { std::printf("%s: %#x\n", what, gl.GetError()); };
  say("before");
  gl.Begin(GL_QUADS);
  quad(gl, 0.5f);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Begin(GL_TRIANGLES);
  gl.End();
  say("Clear in Begin");
  gl.End();
  say("End without Begin");
  gl.Begin(0x7777);
  say("Begin of nothing");
  gl.NewList(0, GL_COMPILE);
  say("NewList 0");
  gl.EndList();
  say("EndList without NewList");
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(0, 0);
  const GLenum inside = gl.GetError();
  gl.End();
  std::printf("GetError in Begin: %#x\n", inside);
  say("after it");
  std::printf("picture %016llx\n", (unsigned long long)sum_of_picture(gl));
}

void triangle(Context& context) {
#define SHADER_FUNCTION(result, name, parameters) \
  const auto name = reinterpret_cast<result(*) parameters>(context.get("gl" #name))
  SHADER_FUNCTION(GLuint, CreateShader, (GLenum));
  SHADER_FUNCTION(void, ShaderSource, (GLuint, GLsizei, const char* const*, const GLint*));
  SHADER_FUNCTION(void, CompileShader, (GLuint));
  SHADER_FUNCTION(GLuint, CreateProgram, ());
  SHADER_FUNCTION(void, AttachShader, (GLuint, GLuint));
  SHADER_FUNCTION(void, LinkProgram, (GLuint));
  SHADER_FUNCTION(void, UseProgram, (GLuint));
  SHADER_FUNCTION(void, GenBuffers, (GLsizei, GLuint*));
  SHADER_FUNCTION(void, BindBuffer, (GLenum, GLuint));
  SHADER_FUNCTION(void, BufferData, (GLenum, GLsizeiptr, const void*, GLenum));
  SHADER_FUNCTION(void, GenVertexArrays, (GLsizei, GLuint*));
  SHADER_FUNCTION(void, BindVertexArray, (GLuint));
  SHADER_FUNCTION(void, VertexAttribPointer, (GLuint, GLint, GLenum, GLboolean, GLsizei, const void*));
  SHADER_FUNCTION(void, EnableVertexAttribArray, (GLuint));
  SHADER_FUNCTION(void, DrawArrays, (GLenum, GLint, GLsizei));
  SHADER_FUNCTION(const unsigned char*, GetString, (GLenum));
  SHADER_FUNCTION(GLenum, GetError, ());
  SHADER_FUNCTION(void, Begin, (GLenum));
  SHADER_FUNCTION(void, End, ());
  SHADER_FUNCTION(void, Vertex2f, (float, float));
  SHADER_FUNCTION(void, Clear, (GLbitfield));
  SHADER_FUNCTION(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*));
#undef SHADER_FUNCTION
  const std::string version = reinterpret_cast<const char*>(GetString(GL_VERSION));
  const bool es = version.find("ES") != std::string::npos;
  const std::string head = es ? "#version 100\nprecision mediump float;\n" : "#version 140\n";
  const std::string vertex = head + (es ? "attribute" : "in") + " vec2 p;\nvoid main() { gl_Position = vec4(p, 0, 1); }\n";
  const std::string fragment =
      head + (es ? "void main() { gl_FragColor" : "out vec4 c;\nvoid main() { c") + " = vec4(1, 0.5, 0.25, 1); }\n";
  const GLuint program = CreateProgram();
  for (const auto& [type, source] : {std::pair{0x8B31, vertex}, {0x8B30, fragment}}) {
    const GLuint shader = CreateShader(type);
    const char* text = source.c_str();
    ShaderSource(shader, 1, &text, nullptr);
    CompileShader(shader);
    AttachShader(program, shader);
  }
  LinkProgram(program);
  UseProgram(program);
  GLuint name;
  if (!es) {
    GenVertexArrays(1, &name);
    BindVertexArray(name);
  }
  const float corners[] = {-1, -1, 1, -1, 0, 1};
  GenBuffers(1, &name);
  BindBuffer(GL_ARRAY_BUFFER, name);
  BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
  VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  EnableVertexAttribArray(0);
  Clear(GL_COLOR_BUFFER_BIT);
  DrawArrays(GL_TRIANGLES, 0, 3);
  std::printf("error %#x\n", GetError());
  // This profile has no Begin; the driver says so, if it has the entry point at all.
  if (Begin && End && Vertex2f) {
    Begin(GL_QUADS);
    std::printf("Begin: %#x\n", GetError());
    for (const float tip : {1.0f, 0.5f}) Vertex2f(-tip, 0), Vertex2f(tip, 0), Vertex2f(0.5f, tip), Vertex2f(-1, 1);
    std::printf("Vertex: %#x\n", GetError());
    End();
    std::printf("End: %#x\n", GetError());
  }
  unsigned char pixels[kSize * kSize * 4] = {};
  ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  unsigned long long lit = 0;
  for (int i = 0; i < kSize * kSize; ++i) lit += pixels[4 * i] == 255 && pixels[4 * i + 1] == 128;
  std::printf("triangle of %llu pixels, error %#x\n", lit, GetError());
}

// ---- Words ----------------------------------------------------------------------------------------------------------

thread_local Context* current = nullptr;
Context* current_context() { return current; }

void say_sum(const std::string& what, std::uint64_t sum) {
  std::printf("%s %016llx\n", what.c_str(), (unsigned long long)sum);
}

void draw_on_threads() {
  std::set<std::uint64_t> sums[3];
  std::set<std::uint64_t> found[6];
  std::vector<std::thread> threads;
  for (int i = 0; i < 6; ++i) {
    threads.emplace_back([i, &found] {
      const std::unique_ptr<Context> context = open(kKinds[i % 3]);
      context->make_current();
      current = context.get();
      const Gl gl = functions_of(get_of_current<current_context>);
      for (int frame = 0; frame < 50; ++frame) found[i].insert(draw(gl, true));
      context->release();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 6; ++i) sums[i % 3].insert(found[i].begin(), found[i].end());
  for (int i = 0; i < 3; ++i) {
    for (const std::uint64_t sum : sums[i]) say_sum(std::string("threads ") + kKinds[i], sum);
  }
}

void create_again_and_again(int count) {
  for (const char* kind : kKinds) {
    std::uint64_t sum = 0;
    for (int i = 0; i < count; ++i) {
      const std::unique_ptr<Context> context = open(kind);
      context->make_current();
      current = context.get();
      sum = draw(functions_of(get_of_current<current_context>), true);
      if (i % 3 > 0) context->release();  // else it is destroyed while it is current
    }
    say_sum(std::string("again ") + kind, sum);
  }
}

void say_names() {
  const bool where = std::getenv("TRUEQUAD_TEST_WHERE");
  for (std::string name; std::cin >> name;) {
    void* function = current->get(name.c_str());
    std::printf("%s %s", name.c_str(), function ? "known" : "null");
    Dl_info info;
    if (where && function) {
      const char* file = dladdr(function, &info) ? std::strrchr(info.dli_fname, '/') : nullptr;
      std::printf(" %s", file ? file + 1 : "?");
    }
    std::printf("\n");
  }
}

}  // namespace

extern "C" [[gnu::visibility("default")]] int contexts_main(int count, char** words) {
  std::vector<std::pair<std::string, std::unique_ptr<Context>>> opened;
  std::string kind = "nothing";
  for (int i = 0; i < count; ++i) {
    const std::string word = words[i];
    const bool linked = word.starts_with("linked-");
    const std::string what = linked ? word.substr(7) : word;
    if (what == "affine" || what == "warped" || what == "illegal") {
      const Gl gl = linked ? linked_functions() : functions_of(get_of_current<current_context>);
      if (what == "illegal") illegal(gl);
      else say_sum(kind + " " + what, draw(gl, what == "warped"));
    } else if (word == "triangle") {
      triangle(*current);
    } else if (word == "threads") {
      draw_on_threads();
    } else if (word == "again" && i + 1 < count) {
      create_again_and_again(std::atoi(words[++i]));
    } else if (word == "names") {
      say_names();
    } else {
      const bool release = word.starts_with("no-");
      const std::string name = release ? word.substr(3) : word;
      Context* context = nullptr;
      for (const auto& [known, its] : opened) {
        if (known == name) context = its.get();
      }
      if (!context) {
        opened.emplace_back(name, open(name));
        context = opened.back().second.get();
      }
      if (!context) return 2;
      if (release) {
        context->release();
      } else {
        context->make_current();
        current = context;
        kind = name;
      }
    }
  }
  std::fflush(stdout);
  return 0;
}
