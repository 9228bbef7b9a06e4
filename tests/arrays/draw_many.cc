// draw_many client|buffer: one call with ten million indices, every thousandth quad of them warped. Prints by how many MiB the
// process grew at most. A program like any other, which knows nothing of truequad.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <sys/resource.h>

#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr std::size_t kIndices = 10'000'000;

long peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<unsigned char> canvas(64 * 64 * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (count != 2 || !context || !OSMesaMakeCurrent(context, canvas.data(), GL_UNSIGNED_BYTE, 64, 64)) return 70;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, std::vector<unsigned char>(64 * 64 * 4).data());
  glEnable(GL_TEXTURE_2D);
  // A square, and a trapezoid.
  const GLfloat position[] = {-1, -1, 1, -1, 1, 1, -1, 1, -1, -1, 1, -1, 0.25f, 1, -0.25f, 1};
  const GLfloat texture[] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1};
  std::vector<GLubyte> indices(kIndices);
  for (std::size_t i = 0; i < kIndices; ++i) indices[i] = GLubyte(i % 4 + (i / 4 % 1000 == 0 ? 4 : 0));
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, position);
  glTexCoordPointer(2, GL_FLOAT, 0, texture);
  const void* start = indices.data();
  if (std::strcmp(arguments[1], "buffer") == 0) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, kIndices, indices.data(), GL_STATIC_DRAW);
    start = nullptr;
  }
  // What a first draw needs is none of the ten million's.
  glDrawElements(GL_QUADS, 8, GL_UNSIGNED_BYTE, start);
  glFinish();
  const long before_kib = peak_kib();
  glDrawElements(GL_QUADS, kIndices, GL_UNSIGNED_BYTE, start);
  glFinish();
  std::printf("%ld\n", (peak_kib() - before_kib) / 1024);
  return glGetError() == GL_NO_ERROR ? 0 : 1;
}
