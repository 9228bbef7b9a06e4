// Prints what a program can ask after draws from arrays, legal and not, and a sum of the picture where nothing in it needs
// correction. A program like any other, which knows nothing of truequad.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr int kWidth = 160, kHeight = 120;
std::vector<unsigned char> canvas(kWidth* kHeight * 4);

struct Element {
  GLfloat texture[2], color[4], normal[3], position[3];
};
constexpr GLsizei kStride = sizeof(Element);

// Four corners; a trapezoid needs correction, its affine copy does not.
std::vector<Element> quad(bool affine) {
  const float x = affine ? 0.8f : 0.3f;
  return {{{0, 0}, {1, 0.5f, 0.5f, 1}, {0, 0, 1}, {-0.8f, -0.8f, 0}},
          {{1, 0}, {0.5f, 1, 0.5f, 1}, {0, 0, 1}, {0.8f, -0.8f, 0}},
          {{1, 1}, {0.5f, 0.5f, 1, 1}, {0, 0, 1}, {x, 0.8f, 0}},
          {{0, 1}, {1, 1, 1, 1}, {0, 0, 1}, {-x, 0.8f, 0}}};
}
std::vector<Element> quads(int affine, int warped) {
  std::vector<Element> all;
  for (int i = 0; i < affine + warped; ++i) {
    const auto one = quad(i < affine);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

void say(const char* what) {
  GLint array = -1, elements = -1, object = -1, client = -1, active = -1, copy = -1;
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &array);
  glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &elements);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &object);
  glGetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &client);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glGetIntegerv(GL_COPY_READ_BUFFER_BINDING, &copy);
  std::printf("%s: error %x bindings %d %d %d %d units %x %x enabled", what, glGetError(), array, elements, object, copy,
              client, active);
  for (GLenum name : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_EDGE_FLAG_ARRAY,
                      GL_LIGHTING, GL_COLOR_MATERIAL, GL_COLOR_SUM}) {
    std::printf(" %d", glIsEnabled(name));
  }
  for (GLenum name : {GL_CURRENT_COLOR, GL_CURRENT_TEXTURE_COORDS, GL_CURRENT_NORMAL, GL_CURRENT_SECONDARY_COLOR}) {
    GLfloat value[4] = {};
    glGetFloatv(name, value);
    std::printf(" (%g %g %g %g)", value[0], value[1], value[2], value[3]);
  }
  GLfloat fog = -1, diffuse[4];
  glGetFloatv(GL_CURRENT_FOG_COORD, &fog);
  glGetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
  std::printf(" %g (%g %g %g %g)\n", fog, diffuse[0], diffuse[1], diffuse[2], diffuse[3]);
}

// For draws of which nothing is corrected.
void look(const char* what) {
  glFinish();
  std::uint64_t sum = 14695981039346656037u;
  for (unsigned char byte : canvas) sum = (sum ^ byte) * 1099511628211u;
  glClear(GL_COLOR_BUFFER_BIT);
  say(what);
  std::printf("  picture %016llx\n", static_cast<unsigned long long>(sum));
}

void point_at(const void* base) {
  const auto* bytes = static_cast<const unsigned char*>(base);
  glTexCoordPointer(2, GL_FLOAT, kStride, bytes + offsetof(Element, texture));
  glColorPointer(4, GL_FLOAT, kStride, bytes + offsetof(Element, color));
  glNormalPointer(GL_FLOAT, kStride, bytes + offsetof(Element, normal));
  glVertexPointer(3, GL_FLOAT, kStride, bytes + offsetof(Element, position));
}
void enable(bool on) {
  for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY}) {
    on ? glEnableClientState(array) : glDisableClientState(array);
  }
}

// `size` bytes that end where memory ends.
unsigned char* at_the_end(const void* data, std::size_t size) {
  const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE)), pages = (size + page - 1) / page;
  void* memory = mmap(nullptr, (pages + 1) * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  auto* bytes = static_cast<unsigned char*>(memory);
  mprotect(bytes + pages * page, page, PROT_NONE);
  std::memcpy(bytes + pages * page - size, data, size);
  return bytes + pages * page - size;
}
const void* nowhere() {
  static void* const page = mmap(nullptr, 65536, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return page;
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void current_values() {
  glColor4f(0.125f, 0.25f, 0.375f, 0.5f);
  glSecondaryColor3f(0.5f, 0.75f, 0.25f);
  glTexCoord4f(0.5f, 0.25f, 0.125f, 2);
  glNormal3f(0, 0.6f, 0.8f);
  glFogCoordf(0.25f);
}

void legal() {
  const auto both = quads(2, 2);
  point_at(both.data());
  enable(true);
  glDrawArrays(GL_QUADS, 0, 16);
  say("two of four");
  glClientActiveTexture(GL_TEXTURE3);
  glActiveTexture(GL_TEXTURE2);
  glDrawArrays(GL_QUADS, 0, 15);
  say("other units");
  glClientActiveTexture(GL_TEXTURE0);
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glDrawArrays(GL_QUADS, 0, 16);
  say("lit");
  glColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
  glEnable(GL_COLOR_MATERIAL);
  glDrawArrays(GL_QUADS, 0, 16);
  say("with material colours");
  // Materials that are not the current colour, as glPopAttrib leaves them.
  glPushAttrib(GL_LIGHTING_BIT);
  glColor4f(0.75f, 0.5f, 0.25f, 1);
  glPopAttrib();
  glDrawArrays(GL_QUADS, 0, 16);
  say("with other material colours");
  glDisable(GL_COLOR_MATERIAL);
  glDisable(GL_LIGHTING);
  for (GLint i = 0; i < 4; ++i) glArrayElement(8 + i);
  say("elements outside of Begin");
  current_values();
  glBegin(GL_QUADS);
  for (GLint i = 0; i < 16; ++i) glArrayElement(i);
  glEnd();
  say("elements");
  glBegin(GL_QUADS);
  for (GLint i = 8; i < 11; ++i) glArrayElement(i);
  glEnd();
  say("three elements");
  current_values();
  glNewList(9, GL_COMPILE);
  glDrawArrays(GL_QUADS, 0, 4);
  say("an affine quad compiled");
  glDrawArrays(GL_QUADS, 0, 16);
  say("compiled");
  glEndList();
  say("ended");
  enable(false);
  glCallList(9);
  say("called");
  current_values();
  glClear(GL_COLOR_BUFFER_BIT);
}

void errors() {
  const auto warped = quads(0, 2);
  point_at(warped.data());
  enable(true);
  const GLushort indices[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const GLint first[] = {0, 4};
  GLsizei count[] = {4, -4};
  const void* starts[] = {indices, indices + 4};
  glDrawArrays(GL_QUADS, 0, -4), look("negative count");
  glDrawArrays(GL_QUADS, 0, 0), look("no vertices");
  glDrawArrays(0x1234, 0, 4), look("bad mode");
  glDrawArrays(GL_QUADS, 0, 3), look("three vertices");
  glDrawElements(GL_QUADS, 4, GL_FLOAT, indices), look("bad type");
  glDrawElements(GL_QUADS, -1, GL_UNSIGNED_SHORT, indices), look("negative count of indices");
  glDrawRangeElements(GL_QUADS, 3, 0, 4, GL_UNSIGNED_SHORT, indices), look("a range that ends before it begins");
  glMultiDrawArrays(GL_QUADS, first, count, 2), look("a negative count among others");
  glMultiDrawArrays(GL_QUADS, first, count, -1), look("a negative number of draws");
  glMultiDrawElements(GL_QUADS, count, GL_UNSIGNED_SHORT, starts, 2), look("likewise of indices");
  glDrawArraysInstanced(GL_QUADS, 0, 4, -1), look("negative instances");
  glDrawArraysInstanced(GL_QUADS, 0, 4, 0), look("no instance");
  glNewList(12, GL_COMPILE);
  glDrawArraysInstanced(GL_QUADS, 0, 8, 1);
  std::printf("instances in a list: error %x\n", glGetError());
  glDrawElementsInstanced(GL_QUADS, 4, GL_UNSIGNED_SHORT, indices, 2);
  std::printf("instances of indices in a list: error %x\n", glGetError());
  glEndList();
  glCallList(12), look("instances that were in a list");
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-0.5f, -0.5f);
  glDrawArrays(GL_QUADS, 0, 4);
  glTexCoord2f(1, 0), glVertex2f(0.5f, -0.5f);
  glVertexPointer(3, GL_FLOAT, kStride, warped[0].position);
  glRectf(-1, -1, 1, 1);
  glTexCoord2f(1, 1), glVertex2f(0.5f, 0.5f);
  glEnableClientState(GL_NORMAL_ARRAY);
  glTexCoord2f(0, 1), glVertex2f(-0.5f, 0.5f);
  glEnd();
  look("draws inside Begin");
  glBegin(GL_POINTS);
  glDrawArrays(GL_QUADS, 0, 4);
  glEnd();
  look("quads inside points");
  glVertexPointer(5, GL_FLOAT, 0, warped.data()), say("bad size");
  glVertexPointer(3, GL_FLOAT, -1, warped.data()), say("bad stride");
  glTexCoordPointer(2, GL_UNSIGNED_BYTE, 0, warped.data()), say("bad type of an array");
  glInterleavedArrays(GL_QUADS, 0, warped.data()), say("bad format");
  glLockArraysEXT(0, -1), say("a bad lock");
  enable(false);
  glDrawArrays(GL_QUADS, 0, 8), look("without arrays");
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glDrawArrays(GL_QUADS, 0, 8), look("without positions");
  enable(false);
}

void memory() {
  const auto affine = quads(2, 0), warped = quads(0, 2);
  enable(true);
  // The last byte of the last vertex is the last that there is.
  unsigned char* end = at_the_end(affine.data(), affine.size() * sizeof(Element));
  point_at(end);
  glDrawArrays(GL_QUADS, 0, 8), look("affine quads where memory ends");
  end = at_the_end(warped.data(), warped.size() * sizeof(Element));
  point_at(end);
  glDrawArrays(GL_QUADS, 0, 8);
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, at_the_end("\4\5\6\7", 4));
  say("warped quads where memory ends");
  glClear(GL_COLOR_BUFFER_BIT);
  // Arrays that the driver does not read.
  point_at(affine.data());
  glClientActiveTexture(GL_TEXTURE1);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, kStride, nowhere());
  glClientActiveTexture(GL_TEXTURE0);
  glNormalPointer(GL_FLOAT, kStride, nowhere());
  glDrawArrays(GL_QUADS, 0, 8), look("unused arrays without memory");
  point_at(warped.data());
  glNormalPointer(GL_FLOAT, kStride, nowhere());
  glDrawArrays(GL_QUADS, 0, 8);
  say("the same with warped quads");
  glClear(GL_COLOR_BUFFER_BIT);
  glClientActiveTexture(GL_TEXTURE1);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
  glDisable(GL_TEXTURE_2D);
  point_at(affine.data());
  glTexCoordPointer(2, GL_FLOAT, kStride, nowhere());
  glDrawArrays(GL_QUADS, 0, 8), look("texture coordinates without memory");
  glEnable(GL_TEXTURE_2D);
  enable(false);
}

void buffers() {
  const auto warped = quads(0, 2), affine = quads(1, 0);
  const GLsizeiptr size = GLsizeiptr(warped.size() * sizeof(Element));
  GLuint names[3];
  glGenBuffers(3, names);
  glBindBuffer(GL_ARRAY_BUFFER, names[0]);
  glBufferData(GL_ARRAY_BUFFER, size, warped.data(), GL_STATIC_DRAW);
  point_at(nullptr);
  enable(true);
  glBindBuffer(GL_ARRAY_BUFFER, names[1]);
  glDrawArrays(GL_QUADS, 0, 8), say("of a buffer, while another is bound");
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_QUADS, 8, 4), look("behind the buffer");
  const GLuint far[] = {100000, 100001, 100002, 100003};
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_INT, far), look("indices behind the buffer");
  glDrawElementsBaseVertex(GL_QUADS, 4, GL_UNSIGNED_INT, far, 1 << 30), look("a base vertex behind it");
  const GLushort range[] = {0, 1, 2, 3, 4, 5, 6, 7};
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[2]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, 6, range, GL_STATIC_DRAW);
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, nullptr), look("indices that are not all in their buffer");
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, offset(1000)), look("indices behind their buffer");
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ARRAY_BUFFER, names[0]);
  glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
  glDrawArrays(GL_QUADS, 0, 8), look("mapped");
  glUnmapBuffer(GL_ARRAY_BUFFER);
  glDrawArrays(GL_QUADS, 0, 8), say("mapped no more");
  glClear(GL_COLOR_BUFFER_BIT);
  // A buffer whose name is gone lives on in a vertex array object that is not bound.
  GLuint object;
  glGenVertexArrays(1, &object);
  glBindVertexArray(object);
  glBindBuffer(GL_ARRAY_BUFFER, names[1]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(affine.size() * sizeof(Element)), affine.data(), GL_STATIC_DRAW);
  point_at(nullptr);
  enable(true);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDeleteBuffers(1, &names[1]);
  glBindVertexArray(object);
  glDrawArrays(GL_QUADS, 0, 4), look("of a deleted buffer");
  std::printf("is a buffer: %d\n", glIsBuffer(names[1]));
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &object);
  say("after the object");
  // Empty, then full.
  glBindBuffer(GL_ARRAY_BUFFER, names[0]);
  glBufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_STATIC_DRAW);
  glDrawArrays(GL_QUADS, 0, 8), look("empty");
  glBufferData(GL_ARRAY_BUFFER, -1, nullptr, GL_STATIC_DRAW), say("a negative size");
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(affine.size() * sizeof(Element)), affine.data(), GL_STATIC_DRAW);
  glDrawArrays(GL_QUADS, 0, 4), look("full");
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDeleteBuffers(1, &names[0]);
  glDeleteBuffers(1, &names[2]);
  enable(false);
  say("buffers deleted");
}

void rectangles() {
  const GLfloat low[] = {-0.5f, -0.5f}, high[] = {0.5f, 0.25f};
  const GLint whole_low[] = {-1, -1}, whole_high[] = {0, 1};
  glRectf(-0.25f, -0.75f, 0.5f, 0.5f), look("rectangle");
  glRectd(-0.25, -0.75, 0.5, 0.5), look("rectangle of doubles");
  glRecti(-1, -1, 0, 0), look("rectangle of integers");
  glRects(0, 0, 1, 1), look("rectangle of shorts");
  glRectfv(low, high), look("rectangle by pointers");
  glRectiv(whole_low, whole_high), look("rectangle by pointers to integers");
  glNewList(11, GL_COMPILE);
  glRectf(-0.25f, -0.75f, 0.5f, 0.5f);
  glEndList();
  glCallList(11), look("rectangle in a list");
}

// Mesa says that it is an error, keeps it, and reads elsewhere: there must be something to read.
void negative_stride() {
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glEnableClientState(GL_VERTEX_ARRAY);
  static GLfloat around[1 << 18];
  glVertexPointer(3, GL_FLOAT, -1, around + (1 << 17)), look("negative stride");
  glDrawArrays(GL_QUADS, 0, 4), look("drawn with a negative stride");
  glNewList(12, GL_COMPILE);
  glDrawArrays(GL_QUADS, 0, 4);
  glEndList();
  look("compiled with a negative stride");
}

}  // namespace

int main() {
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (!context || !OSMesaMakeCurrent(context, canvas.data(), GL_UNSIGNED_BYTE, kWidth, kHeight)) return 70;
  unsigned char texels[4 * 4 * 4];
  for (unsigned i = 0; i < sizeof texels; ++i) texels[i] = (unsigned char)(i * 37);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);
  current_values();
  say("start");
  legal();
  errors();
  memory();
  buffers();
  rectangles();
  negative_stride();
  say("end");
}
