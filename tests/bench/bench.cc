// What calls cost: quads and triangles sent in immediate mode and from arrays to Mesa's driver that draws nothing (OSMesa
// with GALLIUM_NOOP=1), so that what is left is the cost of the calls. The program knows nothing of truequad;
// compare.py runs it without and with it.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <sys/resource.h>

#include <array>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

struct Vertex {
  float s, t, x, y, z;
};

constexpr int kQuads = 1000;
constexpr int kColumns = 40;

void send(const Vertex& v) {
  glTexCoord2f(v.s, v.t);
  glVertex3f(v.x, v.y, v.z);
}

// Corners of a cell of a sheet; warped cells are trapezoids of about 16 pixels.
std::array<Vertex, 4> cell(int index, bool warped) {
  const int i = index % kColumns, j = index / kColumns;
  const float size = 2.0f / kColumns, x = -1 + size * float(i), y = -1 + size * float(j);
  const float narrow = warped ? size * 0.3f : 0;
  return {{{0, 0, x, y, 0},
           {1, 0, x + size, y, 0},
           {1, 1, x + size - narrow, y + size, 0},
           {0, 1, x + narrow, y + size, 0}}};
}

std::vector<Vertex> make_quads(bool warped) {
  std::vector<Vertex> vertices;
  for (int index = 0; index < kQuads; ++index) {
    for (const Vertex& v : cell(index, warped)) vertices.push_back(v);
  }
  return vertices;
}

std::vector<Vertex> make_strip(bool warped) {
  std::vector<Vertex> vertices;
  for (int i = 0; i <= kQuads; ++i) {
    const float at = float(i) / kQuads;
    const float half = warped && i % 2 ? 0.4f : 0.8f;
    vertices.push_back({at, 0, 2 * at - 1, -half, 0});
    vertices.push_back({at, 1, 2 * at - 1, half, 0});
  }
  return vertices;
}

std::vector<Vertex> make_triangles() {
  std::vector<Vertex> vertices;
  for (int index = 0; index < kQuads; ++index) {
    const auto corners = cell(index, true);
    for (const int i : {0, 1, 2}) vertices.push_back(corners[std::size_t(i)]);
  }
  return vertices;
}

// Made once: what a case counts (compare.py --instructions) are its calls, not the making of its vertices.
const std::vector<Vertex>& quads(bool warped) {
  static const std::vector<Vertex> made[] = {make_quads(false), make_quads(true)};
  return made[warped];
}
const std::vector<Vertex>& strip(bool warped) {
  static const std::vector<Vertex> made[] = {make_strip(false), make_strip(true)};
  return made[warped];
}
const std::vector<Vertex>& triangles() {
  static const std::vector<Vertex> made = make_triangles();
  return made;
}

// Mesa's driver that draws nothing never frees a buffer of vertices that it was given (22.3), so calls write to ever fresh
// memory. A page fault for each 4 KiB of it costs several times the calls on a virtual machine. With the pages touched before,
// calls alone are measured.
void touch_memory(std::size_t bytes) {
  constexpr std::size_t kBlock = 16 << 20;
  mallopt(M_MMAP_THRESHOLD, 2 * kBlock);  // the largest that glibc takes
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  std::vector<void*> blocks(bytes / kBlock);
  for (void*& block : blocks) {
    block = std::malloc(kBlock);
    if (block) std::memset(block, 1, kBlock);
  }
  for (void* block : blocks) std::free(block);
}

// Counts the page faults of an iteration, so that a reader of the times knows what they are of.
class CountedFaults {
 public:
  explicit CountedFaults(benchmark::State& state) : state_(state), before_(now()) {}
  ~CountedFaults() {
    state_.counters["faults"] = benchmark::Counter(double(now() - before_), benchmark::Counter::kAvgIterations);
  }

 private:
  static long now() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
  }
  benchmark::State& state_;
  long before_;
};

// All of `vertices` in primitives of `each` vertices (0: in one). An iteration is kQuads quads or triangles.
void run(benchmark::State& state, GLenum mode, const std::vector<Vertex>& vertices, std::size_t each) {
  const std::size_t step = each ? each : vertices.size();
  const CountedFaults faults(state);
  for (auto _ : state) {
    for (std::size_t first = 0; first < vertices.size(); first += step) {
      glBegin(mode);
      for (std::size_t i = first; i < first + step; ++i) send(vertices[i]);
      glEnd();
    }
  }
}

void affine_in_one(benchmark::State& state) { run(state, GL_QUADS, quads(false), 0); }
void affine_one_by_one(benchmark::State& state) { run(state, GL_QUADS, quads(false), 4); }
void affine_strip(benchmark::State& state) { run(state, GL_QUAD_STRIP, strip(false), 0); }
void corrected_in_one(benchmark::State& state) { run(state, GL_QUADS, quads(true), 0); }
void corrected_one_by_one(benchmark::State& state) { run(state, GL_QUADS, quads(true), 4); }
void corrected_strip(benchmark::State& state) { run(state, GL_QUAD_STRIP, strip(true), 0); }
void triangles_in_one(benchmark::State& state) { run(state, GL_TRIANGLES, triangles(), 0); }
void triangles_one_by_one(benchmark::State& state) { run(state, GL_TRIANGLES, triangles(), 3); }

// By calls of `each` vertices (0: one call): a program that keeps its vertices in arrays.
void run_from_arrays(benchmark::State& state, GLenum mode, const std::vector<Vertex>& vertices, GLsizei each) {
  const GLsizei count = GLsizei(vertices.size()), step = each ? each : count;
  glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &vertices[0].s);
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), &vertices[0].x);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glEnableClientState(GL_VERTEX_ARRAY);
  const CountedFaults faults(state);
  for (auto _ : state) {
    for (GLsizei first = 0; first < count; first += step) glDrawArrays(mode, first, step);
  }
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
}

void triangles_from_arrays(benchmark::State& state) { run_from_arrays(state, GL_TRIANGLES, triangles(), 0); }
void arrays_affine(benchmark::State& state) { run_from_arrays(state, GL_QUADS, quads(false), 0); }
void arrays_affine_strip(benchmark::State& state) { run_from_arrays(state, GL_QUAD_STRIP, strip(false), 0); }
void arrays_affine_one_by_one(benchmark::State& state) { run_from_arrays(state, GL_QUADS, quads(false), 4); }
void arrays_corrected(benchmark::State& state) { run_from_arrays(state, GL_QUADS, quads(true), 0); }

// From a buffer whose contents are uploaded anew before each call, as programs do that move their vertices themselves.
enum class Upload { kSubData, kData, kMap };
template <Upload upload>
void run_stream(benchmark::State& state, GLenum mode, const std::vector<Vertex>& vertices) {
  const GLsizeiptr size = GLsizeiptr(vertices.size() * sizeof(Vertex));
  GLuint buffer;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, size, vertices.data(), GL_STREAM_DRAW);
  glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), nullptr);
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), reinterpret_cast<const void*>(offsetof(Vertex, x)));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glEnableClientState(GL_VERTEX_ARRAY);
  const CountedFaults faults(state);
  for (auto _ : state) {
    if (upload == Upload::kSubData) glBufferSubData(GL_ARRAY_BUFFER, 0, size, vertices.data());
    if (upload == Upload::kData) glBufferData(GL_ARRAY_BUFFER, size, vertices.data(), GL_STREAM_DRAW);
    if (upload == Upload::kMap) {
      void* const to = glMapBufferRange(GL_ARRAY_BUFFER, 0, size, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
      std::memcpy(to, vertices.data(), std::size_t(size));
      glUnmapBuffer(GL_ARRAY_BUFFER);
    }
    glDrawArrays(mode, 0, GLsizei(vertices.size()));
  }
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
}

void stream_sub_data(benchmark::State& state) { run_stream<Upload::kSubData>(state, GL_QUADS, quads(false)); }
void stream_data(benchmark::State& state) { run_stream<Upload::kData>(state, GL_QUADS, quads(false)); }
void stream_map(benchmark::State& state) { run_stream<Upload::kMap>(state, GL_QUADS, quads(false)); }
void stream_triangles(benchmark::State& state) { run_stream<Upload::kSubData>(state, GL_TRIANGLES, triangles()); }

BENCHMARK(affine_in_one);
BENCHMARK(affine_one_by_one);
BENCHMARK(affine_strip);
BENCHMARK(corrected_in_one);
BENCHMARK(corrected_one_by_one);
BENCHMARK(corrected_strip);
BENCHMARK(triangles_in_one);
BENCHMARK(triangles_one_by_one);
BENCHMARK(triangles_from_arrays);
BENCHMARK(arrays_affine);
BENCHMARK(arrays_affine_strip);
BENCHMARK(arrays_affine_one_by_one);
BENCHMARK(arrays_corrected);
BENCHMARK(stream_sub_data);
BENCHMARK(stream_data);
BENCHMARK(stream_map);
BENCHMARK(stream_triangles);

bool open_canvas() {
  constexpr int kSize = 640;
  static std::vector<unsigned char> pixels(kSize * kSize * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (!context || !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize)) return false;
  GLuint texture;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const unsigned char texels[16] = {};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  // By compare.py --touched: 80 bytes for a quad, enough for the samples that it takes of a case.
  if (std::getenv("BENCH_TOUCHED")) touch_memory(std::size_t(1) << 30);
  if (!open_canvas()) {
    std::fprintf(stderr, "no OSMesa context\n");
    return 70;
  }
  benchmark::RunSpecifiedBenchmarks();
}
