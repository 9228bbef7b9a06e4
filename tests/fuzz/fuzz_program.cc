// fuzz_program --trials FIRST COUNT [--print]: runs the sequences of trials on OSMesa, each in a process of its own.
// fuzz_program --file FILE [--print]: runs those that a file has. --print: says their calls and every answer.
// fuzz_program --serve: does what the lines of standard input say in these words, and writes "end" after each.
// A program like any other, which knows nothing of truequad. What it sees is written to standard output.
#include "execute.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>

extern "C" {
struct osmesa_context;
osmesa_context* OSMesaCreateContextExt(unsigned format, int depth, int stencil, int accumulation, osmesa_context* share);
unsigned char OSMesaMakeCurrent(osmesa_context* context, void* pixels, unsigned type, int width, int height);
void OSMesaDestroyContext(osmesa_context* context);
}

namespace truequad::fuzz {
namespace {

osmesa_context* contexts[2];
unsigned char pixels[2][kCanvas * kCanvas * 4];

std::uint64_t hash(const void* bytes, std::size_t size) {
  std::uint64_t value = 0xcbf29ce484222325u;
  for (std::size_t i = 0; i < size; ++i) value = (value ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3u;
  return value;
}

void make_textures() {
  static unsigned char texels[8 * 8 * 4];
  for (int i = 0; i < 64; ++i) {
    const unsigned char texel[] = {(unsigned char)(i % 8 * 30 + 20), (unsigned char)(i / 8 * 30 + 20), (unsigned char)(i * 4), 255};
    std::memcpy(texels + 4 * i, texel, 4);
  }
  for (GLuint name = 0; name < 4; ++name) {
    for (GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D}) {
      if (target == GL_TEXTURE_1D && name > 0) continue;
      gl.BindTexture(target, name);
      gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      if (target == GL_TEXTURE_1D) gl.TexImage1D(target, 0, GL_RGBA, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
      else gl.TexImage2D(target, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }
  }
}

void prepare_context() {
  make_textures();
  for (int unit = kUnits - 1; unit >= 0; --unit) {
    gl.ActiveTexture(GL_TEXTURE0 + GLuint(unit));
    gl.BindTexture(GL_TEXTURE_2D, GLuint(unit));
    gl.MatrixMode(GL_TEXTURE);
    gl.LoadIdentity();
    gl.Scalef(0.125f, 0.125f, 1);
    gl.Translatef(0.03f, 0.03f, 0);
  }
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Ortho(0, kCanvas, 0, kCanvas, -40, 40);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Viewport(0, 0, kCanvas, kCanvas);
  gl.Scissor(0, 0, kCanvas, kCanvas);
  gl.Enable(GL_TEXTURE_2D);
}

void create_contexts() {
  contexts[0] = OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, nullptr);
  contexts[1] = OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, contexts[0]);
  if (!contexts[0] || !contexts[1]) std::exit(70);
  for (int i : {1, 0}) {
    make_current(i);
    prepare_context();
  }
}

void begin_trial(int context) {
  make_current(context);
  gl.ClearColor(0.1f, 0.2f, 0.3f, 0.4f);
  gl.ClearDepth(1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  point_arrays();
}

// After glEnd, outside of lists, a driver that still answers as between glBegin and glEnd has lost its way; what follows says
// nothing. Without truequad such a sequence is left out, with it it would be a finding.
constexpr int kStuck = 72;
void expect_outside() {
  GLint mode = 0;
  gl.GetIntegerv(GL_MATRIX_MODE, &mode);
  if (mode != 0) return;
  std::fflush(stdout);
  ::_exit(kStuck);
}

// As a list leaves it that is called, a driver may be between glBegin and glEnd to some calls and not to others (README.md). To
// ask is an error between them, so it is done in runs of their own, which are compared with nothing.
bool probing = false;
void expect_one_mind() {
  GLint mode = 0;
  gl.GetIntegerv(GL_MATRIX_MODE, &mode);
  if (mode == 0 || gl.IsTexture(1)) return;
  std::fflush(stdout);
  ::_exit(kStuck);
}

// Leaves whatever the sequence was in.
void close_trial() {
  GL(End);
  GL(EndList);
  GL(End);
  expect_outside();
  record_errors();
  if (gl.UnmapBuffer) {
    GL(UnmapBuffer, GL_ARRAY_BUFFER);
    GL(UnmapBuffer, GL_ELEMENT_ARRAY_BUFFER);
  }
  record("RenderMode: %d", GL(RenderMode, GL_RENDER));
  for (GLenum target : {GL_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED}) GL(EndQuery, target);
  record_errors();
}

void record_pixels(int context) {
  gl.Finish();
  record("colour %016llx", static_cast<unsigned long long>(hash(pixels[context], sizeof pixels[context])));
  static unsigned char depth[kCanvas * kCanvas * 4], stencil[kCanvas * kCanvas];
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, kCanvas, kCanvas, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
  gl.ReadPixels(0, 0, kCanvas, kCanvas, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
  record("depth %016llx", static_cast<unsigned long long>(hash(depth, sizeof depth)));
  record("stencil %016llx", static_cast<unsigned long long>(hash(stencil, sizeof stencil)));
  char covered[kCanvas * 9 + 1];
  for (int y = 0; y < kCanvas; ++y) {
    unsigned row = 0;
    for (int x = 0; x < kCanvas; ++x) row |= unsigned(pixels[context][(y * kCanvas + x) * 4 + 3] != 102) << x;
    std::snprintf(covered + 9 * y, 10, "%08x ", row);
  }
  record("covered %s", covered);
}

void run(const Sequence& sequence) {
  Player player;
  std::memset(feedback_buffer, 0, sizeof feedback_buffer);
  std::memset(selection_buffer, 0, sizeof selection_buffer);
  for (int i : {1, 0}) begin_trial(i);
  for (const Op& op : sequence) {
    execute(op, player);
    if (probing && !player.listing) expect_one_mind();
  }
  for (int i : {player.context, player.context ^ 1}) {
    make_current(i);
    close_trial();
    record_state();
    record_pixels(i);
  }
}

// A process of its own for each: what a sequence leaves, or breaks, is no other's. It has some seconds of a processor, even
// in a loop without end.
void run_apart(std::uint64_t trial, const Sequence& sequence) {
  std::printf("trial %llu\n", static_cast<unsigned long long>(trial));
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    const char* const given = std::getenv("FUZZ_SECONDS");
    const rlim_t most = given ? rlim_t(std::atoi(given)) : 2;
    const rlimit seconds = {most, most}, no_core = {0, 0};
    ::setrlimit(RLIMIT_CPU, &seconds);
    ::setrlimit(RLIMIT_CORE, &no_core);
    run(sequence);
    std::fflush(stdout);
    ::_exit(0);
  }
  int state = 0;
  if (child < 0 || ::waitpid(child, &state, 0) != child) std::exit(71);
  std::printf("process %d %d\n", int(child), WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state));
}

// False: the words are not understood.
bool run_words(const std::vector<std::string>& words) {
  printing = verbose = words.size() > 2 && words.back() == "--print";
  std::setvbuf(stdout, nullptr, printing ? _IONBF : _IOFBF, printing ? 0 : 1 << 16);
  const std::size_t count = words.size() - printing;
  if (count == 2 && words[0] == "--file") {
    std::vector<Sequence> sequences;
    if (!read(words[1], sequences)) return false;
    for (std::size_t i = 0; i < sequences.size(); ++i) run_apart(i, sequences[i]);
    return true;
  }
  if (count == 3 && words[0] == "--trials") {
    const std::uint64_t first = std::stoull(words[1]), trials = std::stoull(words[2]);
    for (std::uint64_t trial = first; trial < first + trials; ++trial) run_apart(trial, generate(trial, kind_of(trial)));
    return true;
  }
  return false;
}

int serve() {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream stream(line);
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    if (!run_words(words)) return 2;
    std::puts("end");
    std::fflush(stdout);
  }
  return 0;
}

int main(int count, char** arguments) {
  probing = std::getenv("FUZZ_PROBE");
  settling = std::getenv("FUZZ_SETTLE");
  load_gl();
  fill_arena();
  create_contexts();
  find_names();
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words == std::vector<std::string>{"--serve"}) return serve();
  if (run_words(words)) return 0;
  std::fprintf(stderr, "usage: %s --trials FIRST COUNT [--print] | --file FILE [--print] | --serve\n", arguments[0]);
  return 2;
}

}  // namespace

void make_current(int context) {
  print_note("context %d", context);
  OSMesaMakeCurrent(contexts[context], pixels[context], GL_UNSIGNED_BYTE, kCanvas, kCanvas);
}

void record(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  std::vprintf(format, arguments);
  va_end(arguments);
  std::putchar('\n');
}

void record_errors() {
  for (int i = 0; i < 4; ++i) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) break;
    record("error %x", error);
  }
}

void execute(const Op& op, Player& player) {
  switch (op.step) {
    case Step::kBegin:
      settle_values(player);
      note_begin(player, GLenum(op.index));
      return GL(Begin, GLenum(op.index));
    case Step::kEnd:
      note_end(player);
      GL(End);
      settle_pieces(player);
      if (!player.listing) expect_outside();
      return;
    case Step::kTexCoord: note_values(player, kTextures); return execute_vertex(op, player);
    case Step::kVertex: return execute_vertex(op, player);
    case Step::kAttribute:
      note_values(player, op.warp & kOneSlot ? kColours : kAllValues);
      return execute_attribute(op, player);
    case Step::kMaterial: return execute_material(op);
    case Step::kNewList: case Step::kEndList: case Step::kCallList: case Step::kCallLists: case Step::kDeleteLists:
    case Step::kGenLists: case Step::kListBase: case Step::kNest: return execute_list(op, player);
    case Step::kMatrix: case Step::kEnable: case Step::kTexGen: case Step::kTexture: case Step::kLighting: case Step::kRaster:
    case Step::kPushAttrib: case Step::kPopAttrib: case Step::kCover: return execute_state(op, player);
    case Step::kPointer: case Step::kClientState: case Step::kDrawArrays: case Step::kDrawElements: case Step::kArrayElement:
    case Step::kInterleaved: case Step::kBuffer: case Step::kMapBuffer: case Step::kVertexArray: case Step::kRestart:
    case Step::kLockArrays: return execute_arrays(op, player);
    case Step::kDrawIndirect: case Step::kFarIndices: case Step::kNowhere: return execute_edges(op);
    default: return execute_other(op, player);
  }
}

}  // namespace truequad::fuzz

int main(int count, char** arguments) { return truequad::fuzz::main(count, arguments); }
