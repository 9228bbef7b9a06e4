// draw_many WAY: ten million vertices, every thousandth quad of them warped: by one call with indices, or by ten calls from
// arrays or of lists. Prints by how many MiB the process grew at most, after a first draw. A program like any other, which knows
// nothing of truequad.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <sys/resource.h>

#include <cstddef>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

constexpr std::size_t kVertices = 10'000'000, kCalls = 10, kEach = kVertices / kCalls;

struct Vertex {
  GLfloat texture[2], position[2];
};
// A square, and a trapezoid.
constexpr Vertex kVertex[8] = {{{0, 0}, {-1, -1}}, {{1, 0}, {1, -1}}, {{1, 1}, {1, 1}},     {{0, 1}, {-1, 1}},
                               {{0, 0}, {-1, -1}}, {{1, 0}, {1, -1}}, {{1, 1}, {0.25f, 1}}, {{0, 1}, {-0.25f, 1}}};
std::size_t place(std::size_t i) { return i % 4 + (i / 4 % 1000 == 0 ? 4 : 0); }

long peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

void point_at(const void* base) {
  const auto* bytes = static_cast<const unsigned char*>(base);
  glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), bytes);
  glVertexPointer(2, GL_FLOAT, sizeof(Vertex), bytes + offsetof(Vertex, position));
}

void store(GLenum target, std::size_t size, const void* data) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, GLsizeiptr(size), data, GL_STATIC_DRAW);
}

long growth_mib(const std::function<void()>& first, const std::function<void()>& all) {
  first();
  glFinish();
  const long before_kib = peak_kib();
  all();
  glFinish();
  return (peak_kib() - before_kib) / 1024;
}

// What a first draw needs is none of the ten million's.
long by_indices(bool in_buffer) {
  std::vector<GLubyte> indices(kVertices);
  for (std::size_t i = 0; i < kVertices; ++i) indices[i] = GLubyte(place(i));
  point_at(kVertex);
  if (in_buffer) store(GL_ELEMENT_ARRAY_BUFFER, kVertices, indices.data());
  const void* const start = in_buffer ? nullptr : indices.data();
  return growth_mib([&] { glDrawElements(GL_QUADS, 8, GL_UNSIGNED_BYTE, start); },
                    [&] { glDrawElements(GL_QUADS, kVertices, GL_UNSIGNED_BYTE, start); });
}

long by_calls(const std::function<void()>& call) {
  return growth_mib(call, [&] {
    for (std::size_t i = 0; i < kCalls; ++i) call();
  });
}

void draw_arrays() { glDrawArrays(GL_QUADS, 0, kEach); }

std::vector<Vertex> vertices() {
  std::vector<Vertex> all(kEach);
  for (std::size_t i = 0; i < kEach; ++i) all[i] = kVertex[place(i)];
  return all;
}

long from_arrays(bool in_buffer) {
  const std::vector<Vertex> all = vertices();
  if (in_buffer) store(GL_ARRAY_BUFFER, all.size() * sizeof(Vertex), all.data());
  point_at(in_buffer ? nullptr : all.data());
  return by_calls(draw_arrays);
}

long by_list(bool from_arrays) {
  const std::vector<Vertex> all = vertices();
  point_at(all.data());
  glNewList(1, GL_COMPILE);
  if (from_arrays) {
    draw_arrays();
  } else {
    glBegin(GL_QUADS);
    for (const Vertex& v : all) glTexCoord2fv(v.texture), glVertex2fv(v.position);
    glEnd();
  }
  glEndList();
  return by_calls([] { glCallList(1); });
}

}  // namespace

int main(int count, char** arguments) {
  const std::map<std::string, std::function<long()>> ways = {
      {"indices", [] { return by_indices(false); }}, {"buffer_of_indices", [] { return by_indices(true); }},
      {"arrays", [] { return from_arrays(false); }}, {"buffer", [] { return from_arrays(true); }},
      {"list", [] { return by_list(false); }},       {"list_of_arrays", [] { return by_list(true); }},
  };
  std::vector<unsigned char> canvas(64 * 64 * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  const auto way = ways.find(count == 2 ? arguments[1] : "");
  if (way == ways.end() || !context || !OSMesaMakeCurrent(context, canvas.data(), GL_UNSIGNED_BYTE, 64, 64)) return 70;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, std::vector<unsigned char>(64 * 64 * 4).data());
  glEnable(GL_TEXTURE_2D);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  std::printf("%ld\n", way->second());
  return glGetError() == GL_NO_ERROR ? 0 : 1;
}
