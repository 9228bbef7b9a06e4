// ask_deleted CASE: draws from buffers that were deleted, and prints the errors, whether the names are buffers, and a sum of the
// picture, in which nothing needs correction: only what is new under an old name would. A program like any other, which
// knows nothing of truequad.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

std::vector<unsigned char> canvas(64 * 64 * 4);

// Positions and texture coordinates: a square, and a trapezoid.
using Quad = GLfloat[16];
constexpr Quad kSquare = {-0.7f, -0.7f, 0, 0, 0.7f, -0.7f, 1, 0, 0.7f, 0.7f, 1, 1, -0.7f, 0.7f, 0, 1};
constexpr Quad kTrapezoid = {-0.9f, -0.9f, 0, 0, 0.9f, -0.9f, 1, 0, 0.3f, 0.9f, 1, 1, -0.3f, 0.9f, 0, 1};
constexpr GLubyte kFirst[] = {0, 1, 2, 3}, kSecond[] = {4, 5, 6, 7};

void point_at(const void* base) {
  glVertexPointer(2, GL_FLOAT, 16, base);
  glTexCoordPointer(2, GL_FLOAT, 16, static_cast<const char*>(base) + 8);
}
GLuint buffer_of(GLenum target, const void* data, GLsizeiptr size) {
  GLuint name;
  glGenBuffers(1, &name);
  glBindBuffer(target, name);
  glBufferData(target, size, data, GL_STATIC_DRAW);
  return name;
}
GLuint vertices(const Quad& quad) { return buffer_of(GL_ARRAY_BUFFER, quad, sizeof quad); }
void again(GLenum target, GLuint name, const void* data, GLsizeiptr size) {
  glBindBuffer(target, name);
  glBufferData(target, size, data, GL_STATIC_DRAW);
}
GLuint object_with(const Quad& quad, GLuint& buffer) {
  GLuint object;
  glGenVertexArrays(1, &object);
  glBindVertexArray(object);
  buffer = vertices(quad);
  point_at(nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  return object;
}

void look(GLuint name) {
  glFinish();
  std::uint64_t sum = 14695981039346656037u;
  for (const unsigned char byte : canvas) sum = (sum ^ byte) * 1099511628211u;
  std::printf("error %x buffer %d picture %016llx\n", glGetError(), glIsBuffer(name), static_cast<unsigned long long>(sum));
  std::fflush(stdout);
  glClear(GL_COLOR_BUFFER_BIT);
}
void draw(GLuint name) { glDrawArrays(GL_QUADS, 0, 4), look(name); }
void draw_indexed(GLuint name) { glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, nullptr), look(name); }
void enable() {
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
}

OSMesaContext context;
bool make_current(OSMesaContext which) { return OSMesaMakeCurrent(which, canvas.data(), GL_UNSIGNED_BYTE, 64, 64); }
void in_another_context(const std::function<void()>& what) {
  glFinish();
  const OSMesaContext other = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, context);
  make_current(other), what(), glFinish();
  make_current(context), OSMesaDestroyContext(other);
}

const std::map<std::string, std::function<void()>> kCases = {
    {"bound",
     [] {
       const GLuint name = vertices(kSquare);
       point_at(nullptr), enable(), draw(name);
       glDeleteBuffers(1, &name);
       draw(name);
     }},
    {"bound_in_a_list",
     [] {
       const GLuint name = vertices(kSquare);
       point_at(nullptr), enable(), draw(name);
       glDeleteBuffers(1, &name);
       look(name);
       glNewList(1, GL_COMPILE);
       glDrawArrays(GL_QUADS, 0, 4);
       glEndList();
       glCallList(1), look(name);
     }},
    {"mapped",
     [] {
       const GLuint name = vertices(kTrapezoid);
       point_at(nullptr), enable();
       glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
       glDeleteBuffers(1, &name);
       glBindBuffer(GL_ARRAY_BUFFER, 0);
       point_at(kSquare), draw(name);
     }},
    {"created_again",
     [] {
       const GLuint name = vertices(kTrapezoid);
       point_at(nullptr), enable();
       glDeleteBuffers(1, &name);
       again(GL_ARRAY_BUFFER, name, kSquare, sizeof kSquare);
       point_at(nullptr), draw(name);
     }},
    {"kept_by_an_object",
     [] {
       GLuint name;
       const GLuint object = object_with(kSquare, name);
       glBindVertexArray(0), glBindBuffer(GL_ARRAY_BUFFER, 0);
       glDeleteBuffers(1, &name);
       glBindVertexArray(object), draw(name);
     }},
    {"kept_by_an_object_and_created_again",
     [] {
       GLuint name;
       const GLuint object = object_with(kSquare, name);
       glBindVertexArray(0), glBindBuffer(GL_ARRAY_BUFFER, 0);
       glDeleteBuffers(1, &name);
       again(GL_ARRAY_BUFFER, name, kTrapezoid, sizeof kTrapezoid);
       glBindVertexArray(object), draw(name);
       glNewList(1, GL_COMPILE);
       glDrawArrays(GL_QUADS, 0, 4);
       glEndList();
       glCallList(1), look(name);
     }},
    {"indices",
     [] {
       point_at(kSquare), enable();
       const GLuint name = buffer_of(GL_ELEMENT_ARRAY_BUFFER, kFirst, sizeof kFirst);
       draw_indexed(name);
       glDeleteBuffers(1, &name);
       draw_indexed(name);
     }},
    {"indices_kept_by_an_object_and_created_again",
     [] {
       GLuint vertex_name;
       const GLuint object = object_with(kSquare, vertex_name);
       glBufferData(GL_ARRAY_BUFFER, 2 * sizeof(Quad), nullptr, GL_STATIC_DRAW);
       glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof(Quad), kSquare);
       glBufferSubData(GL_ARRAY_BUFFER, sizeof(Quad), sizeof(Quad), kTrapezoid);
       const GLuint name = buffer_of(GL_ELEMENT_ARRAY_BUFFER, kFirst, sizeof kFirst);
       glBindVertexArray(0);
       glDeleteBuffers(1, &name);
       again(GL_ARRAY_BUFFER, name, kSecond, sizeof kSecond);
       glBindVertexArray(object), draw_indexed(name);
     }},
    {"kept_by_another_context_and_created_again",
     [] {
       const GLuint name = vertices(kSquare);
       point_at(nullptr), enable(), draw(name);
       glBindBuffer(GL_ARRAY_BUFFER, 0);
       in_another_context([&] {
         glDeleteBuffers(1, &name);
         again(GL_ARRAY_BUFFER, name, kTrapezoid, sizeof kTrapezoid);
       });
       draw(name);
     }},
    {"kept_by_pushed_arrays_and_created_again",
     [] {
       const GLuint name = vertices(kSquare);
       point_at(nullptr), enable(), draw(name);
       glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
       glDeleteBuffers(1, &name);
       again(GL_ARRAY_BUFFER, name, kTrapezoid, sizeof kTrapezoid);
       glBindBuffer(GL_ARRAY_BUFFER, 0);
       glPopClientAttrib(), draw(name);
     }},
    // An object that was made afterwards has the new buffer.
    {"in_a_new_object",
     [] {
       GLuint name, object;
       object_with(kSquare, name);
       glBindVertexArray(0), glBindBuffer(GL_ARRAY_BUFFER, 0);
       glDeleteBuffers(1, &name);
       glGenVertexArrays(1, &object);
       glBindVertexArray(object);
       again(GL_ARRAY_BUFFER, name, kTrapezoid, sizeof kTrapezoid);
       point_at(nullptr), enable();
       glDrawArrays(GL_QUADS, 0, 4);
     }},
};

}  // namespace

int main(int count, char** arguments) {
  const auto found = kCases.find(count == 2 ? arguments[1] : "");
  context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (found == kCases.end() || !context || !make_current(context)) return 70;
  std::vector<unsigned char> texels(64);
  for (unsigned i = 0; i < 64; ++i) texels[i] = (unsigned char)(i * 37);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glEnable(GL_TEXTURE_2D);
  found->second();
}
