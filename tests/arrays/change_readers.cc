// Draws from arrays before and after every way in which a program can switch off, and on again, what reads texture coordinates:
// while nothing reads them, their array has no memory. Prints errors. A program like any other, which knows nothing of truequad.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr GLfloat kTrapezoid[] = {-0.8f, -0.8f, 0.8f, -0.8f, 0.3f, 0.8f, -0.3f, 0.8f};
constexpr GLfloat kTexture[] = {0, 0, 1, 0, 1, 1, 0, 1};

GLuint program, list_base, indices;

void make_programs() {
  const char* const source = "void main() { gl_Position = gl_Vertex; }";
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  const char* const assembly = "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n";
  glBindProgramARB(GL_VERTEX_PROGRAM_ARB, 1);
  glProgramStringARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(assembly)), assembly);
}

// Lists: 0 texture off, 1 on, 2 with the program, 3 without, 4 restart on, 5 off.
void make_lists() {
  list_base = glGenLists(6);
  const auto compile = [](GLuint list, auto calls) {
    glNewList(list_base + list, GL_COMPILE);
    calls();
    glEndList();
  };
  compile(0, [] { glDisable(GL_TEXTURE_2D); });
  compile(1, [] { glEnable(GL_TEXTURE_2D); });
  compile(2, [] { glUseProgram(program); });
  compile(3, [] { glUseProgram(0); });
  compile(4, [] { glEnable(GL_PRIMITIVE_RESTART); });
  compile(5, [] { glDisable(GL_PRIMITIVE_RESTART); });
}

void call_lists(GLuint list) {
  const GLuint name = list_base + list;
  glCallLists(1, GL_UNSIGNED_INT, &name);
}

struct Change {
  const char* name;
  void (*off)();
  void (*on)();
};
const Change kChanges[] = {
    {"nothing but the pointer", [] { glDisableClientState(GL_TEXTURE_COORD_ARRAY); },
     [] { glEnableClientState(GL_TEXTURE_COORD_ARRAY); }},
    {"enables", [] { glDisable(GL_TEXTURE_2D); }, [] { glEnable(GL_TEXTURE_2D); }},
    {"enables by unit", [] { glDisableIndexedEXT(GL_TEXTURE_2D, 0); }, [] { glEnableIndexedEXT(GL_TEXTURE_2D, 0); }},
    {"attributes that are popped",
     [] { glPushAttrib(GL_ENABLE_BIT), glDisable(GL_TEXTURE_2D); },
     [] { glPopAttrib(); }},
    {"attributes popped first",
     [] { glDisable(GL_TEXTURE_2D), glPushAttrib(GL_TEXTURE_BIT), glEnable(GL_TEXTURE_2D), glPopAttrib(); },
     [] { glEnable(GL_TEXTURE_2D); }},
    {"another unit",
     [] { glDisable(GL_TEXTURE_2D), glActiveTexture(GL_TEXTURE1), glEnable(GL_TEXTURE_2D), glActiveTexture(GL_TEXTURE0); },
     [] { glActiveTexture(GL_TEXTURE1), glDisable(GL_TEXTURE_2D), glActiveTexture(GL_TEXTURE0), glEnable(GL_TEXTURE_2D); }},
    {"a program", [] { glUseProgram(program); }, [] { glUseProgram(0); }},
    {"a program of the extension", [] { glUseProgramObjectARB(program); }, [] { glUseProgramObjectARB(0); }},
    {"a program in assembly", [] { glEnable(GL_VERTEX_PROGRAM_ARB); }, [] { glDisable(GL_VERTEX_PROGRAM_ARB); }},
    {"a list", [] { glCallList(list_base); }, [] { glCallList(list_base + 1); }},
    {"lists", [] { call_lists(0); }, [] { call_lists(1); }},
    {"a program in a list", [] { glCallList(list_base + 2); }, [] { glCallList(list_base + 3); }},
    {"a list as it is compiled",
     [] { glNewList(99, GL_COMPILE_AND_EXECUTE), glDisable(GL_TEXTURE_2D), glEndList(); },
     [] { glNewList(99, GL_COMPILE_AND_EXECUTE), glCallList(list_base + 1), glEndList(); }},
};

void* nowhere(std::size_t bytes) { return mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); }

// Restarts that a list enables: the number has no element.
void restart_from_a_list() {
  const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
  auto* const memory = static_cast<unsigned char*>(nowhere(64 * page));
  mprotect(memory, page, PROT_READ | PROT_WRITE);
  unsigned char* const position = memory + page - sizeof kTrapezoid;
  std::memcpy(position, kTrapezoid, sizeof kTrapezoid);
  constexpr GLushort kIndices[] = {0, 1, 3, 2, 5000, 0, 1, 3, 2};
  glVertexPointer(2, GL_FLOAT, 0, position);
  glTexCoordPointer(2, GL_FLOAT, 0, position);
  glPrimitiveRestartIndex(5000);
  glDrawElements(GL_QUAD_STRIP, 4, GL_UNSIGNED_SHORT, kIndices);
  glCallList(list_base + 4);
  glDrawElements(GL_QUAD_STRIP, 9, GL_UNSIGNED_SHORT, kIndices);
  glCallList(list_base + 5);
}

// Indices in a buffer, and in memory.
void change_index_buffer() {
  constexpr GLubyte kIndices[] = {0, 1, 2, 3};
  glGenBuffers(1, &indices);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kIndices, kIndices, GL_STATIC_DRAW);
  for (int i = 0; i < 2; ++i) {
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, kIndices);
    i ? glBindBufferARB(GL_ELEMENT_ARRAY_BUFFER, indices) : glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

}  // namespace

int main() {
  std::vector<unsigned char> canvas(64 * 64 * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (!context || !OSMesaMakeCurrent(context, canvas.data(), GL_UNSIGNED_BYTE, 64, 64)) return 70;
  make_programs();
  make_lists();
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
    glActiveTexture(unit);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, std::vector<unsigned char>(64, 200).data());
  }
  glEnable(GL_TEXTURE_2D);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kTrapezoid);
  const void* const unread = nowhere(4096);
  for (const Change& change : kChanges) {
    glTexCoordPointer(2, GL_FLOAT, 0, kTexture);
    glDrawArrays(GL_QUADS, 0, 4);
    change.off();
    glTexCoordPointer(2, GL_FLOAT, 0, unread);
    glDrawArrays(GL_QUADS, 0, 4);
    glTexCoordPointer(2, GL_FLOAT, 0, kTexture);
    glDrawArrays(GL_QUADS, 0, 4);
    change.on();
    glDrawArrays(GL_QUADS, 0, 4);
    glFinish();
    std::printf("%s: %x\n", change.name, glGetError());
    std::fflush(stdout);
  }
  change_index_buffer();
  restart_from_a_list();
  glFinish();
  std::printf("end: %x\n", glGetError());
}
