// Prints what a program can ask of display lists, and every error, with a quad in most of them that needs correction.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <cstdio>
#include <vector>

namespace {

void quad() {
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
  glTexCoord2f(1, 0), glVertex2f(0.9f, -0.9f);
  glTexCoord2f(1, 1), glVertex2f(0.3f, 0.9f);
  glTexCoord2f(0, 1), glVertex2f(-0.3f, 0.9f);
  glEnd();
}

void say(const char* what) {
  GLint index = -1, mode = -1, base = -1, depth = -1;
  GLfloat float_index = -1, color[4], texture[4];
  GLdouble double_index = -1;
  GLboolean boolean_index = 99;
  glGetIntegerv(GL_LIST_INDEX, &index);
  glGetIntegerv(GL_LIST_MODE, &mode);
  glGetIntegerv(GL_LIST_BASE, &base);
  glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth);
  glGetFloatv(GL_LIST_INDEX, &float_index);
  glGetDoublev(GL_LIST_INDEX, &double_index);
  glGetBooleanv(GL_LIST_INDEX, &boolean_index);
  glGetFloatv(GL_CURRENT_COLOR, color);
  glGetFloatv(GL_CURRENT_TEXTURE_COORDS, texture);
  std::printf("%s: index %d %g %g %d mode %x base %d depth %d color %g %g %g %g texture %g %g %g %g error %x\n", what, index,
              float_index, double_index, boolean_index, mode, base, depth, color[0], color[1], color[2], color[3],
              texture[0], texture[1], texture[2], texture[3], glGetError());
}

void is(GLuint name) { std::printf("is %u: %d error %x\n", name, glIsList(name), glGetError()); }

// Calls of fixed-point numbers, which Mesa makes at once and does not compile, or refuses: before anything else of a list, after a
// quad that needs correction, in such a quad and in one after it.
void ask_fixed() {
  static const GLint numbers[2][4] = {{0x20000, 0x30000, 0, 0x10000}, {0x40000, 0x18000, 0, 0x10000}};
  const auto unit = reinterpret_cast<void (*)(GLenum, GLint, GLint, GLint, GLint)>(OSMesaGetProcAddress("glMultiTexCoord4x"));
  const auto color = reinterpret_cast<void (*)(const GLint*)>(OSMesaGetProcAddress("glColor3xvOES"));
  for (int place = 0; place < 4; ++place) {
    glTexCoord4f(0, 0, 0, 1);
    glNewList(58, GL_COMPILE);
    const auto calls = [&](const GLint* fixed) {
      if (unit) unit(GL_TEXTURE0, fixed[0], fixed[1], fixed[2], fixed[3]);
      if (color) color(fixed);
    };
    if (place == 0) {
      calls(numbers[0]);
      glVertex2f(0.5f, 0.5f);
      calls(numbers[1]);
    }
    if (place == 1) quad(), calls(numbers[0]);
    if (place == 3) quad();
    if (place > 1) {
      glBegin(GL_QUADS);
      for (int i = 0; i < 4; ++i) {
        glTexCoord2f(float(i % 3 > 0), float(i > 1));
        if (i == 2) calls(numbers[1]);
        glVertex2f(i == 2 ? 0.25f : float(i % 3 > 0), float(i > 1));
      }
      glEnd();
    }
    say("fixed: compiled");
    glEndList();
    say("fixed: ended");
    if (place == 0) glBegin(GL_POINTS);
    glCallList(58);
    if (place == 0) glEnd();
    say("fixed: called");
  }
}

void ask_all() {
  say("start");
  const GLuint three = glGenLists(3);
  std::printf("gen %u\n", three);
  is(three);
  is(three + 3);
  glNewList(three, GL_COMPILE);
  say("compiling");
  glColor3f(1, 0.5f, 0.25f);
  quad();
  say("after a quad");
  is(three);
  is(three + 1);
  std::printf("gen %u\n", glGenLists(2));
  glColor3f(0, 0.5f, 0.25f);
  quad();
  glTranslatef(0.1f, 0, 0);
  say("after a translation");
  glNewList(three + 1, GL_COMPILE);
  say("a list in a list");
  glEndList();
  say("ended");
  glEndList();
  say("ended twice");
  is(three);
  glCallList(three);
  say("called");
  // Numbers while a list is compiled that nobody has yet.
  glNewList(20, GL_COMPILE);
  is(20);
  quad();
  is(20);
  std::printf("gen %u\n", glGenLists(2));
  glTranslatef(0, 0, 0);
  std::printf("gen %u\n", glGenLists(1));
  glEndList();
  std::printf("gen %u\n", glGenLists(1));
  is(20);
  // A list of the name that is being compiled is the old one until glEndList.
  glNewList(20, GL_COMPILE);
  quad();
  is(20);
  glEndList();
  glNewList(0, GL_COMPILE);
  say("list 0");
  glNewList(three + 1, GL_TRIANGLES);
  say("bad mode");
  glBegin(GL_QUADS);
  glNewList(three + 1, GL_COMPILE);
  glEnd();
  say("a list inside Begin");
  glBegin(GL_QUADS);
  glCallList(three);
  glEnd();
  say("called inside Begin");
  glBegin(GL_QUADS);
  std::printf("gen %u\n", glGenLists(1));
  glDeleteLists(three, 1);
  std::printf("is %d\n", glIsList(three));
  glEnd();
  say("asked inside Begin");
  std::printf("gen %u %u %u\n", glGenLists(1), glGenLists(0), glGenLists(5));
  say("made more");
  std::printf("gen %u\n", glGenLists(-1));
  say("made less");
  glNewList(500, GL_COMPILE_AND_EXECUTE);
  say("executing");
  glColor4f(0.25f, 1, 0.5f, 0.75f);
  quad();
  say("executed a quad");
  glTexCoord2f(0.125f, 0.25f);
  glListBase(7);
  say("executed a base");
  quad();
  glEndList();
  say("executed all");
  std::printf("gen %u\n", glGenLists(2));
  glListBase(0);
  // Itself, to the depth limit.
  glNewList(600, GL_COMPILE);
  glTranslatef(1, 0, 0);
  quad();
  glCallList(600);
  glEndList();
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glCallList(600);
  GLfloat matrix[16];
  glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
  std::printf("moved by %g error %x\n", matrix[12], glGetError());
  glPopMatrix();
  glDeleteLists(three, -1);
  say("deleted less");
  glDeleteLists(three, 1000);
  say("deleted");
  for (GLuint name : {three, three + 1, 500u, 600u, 0x5a000000u, 0x5a000001u}) is(name);
  std::printf("gen %u\n", glGenLists(1));
  glCallList(three);
  const GLubyte names[] = {1, 2, 200};
  glCallLists(3, GL_UNSIGNED_BYTE, names);
  say("called what there is not");
  glCallLists(-1, GL_UNSIGNED_BYTE, names);
  say("negative");
  glCallLists(1, GL_TRIANGLES, names);
  say("bad type");
  // Attributes and vertices alone, for use inside Begin.
  glNewList(50, GL_COMPILE);
  glColor3f(0.5f, 0.5f, 0.5f);
  glTexCoord3f(0.5f, 0.25f, 0.125f);
  glVertex2f(0.5f, 0.5f);
  glEndList();
  glBegin(GL_QUADS);
  for (int i = 0; i < 4; ++i) glCallList(50);
  glEnd();
  say("vertices in a list");
  glNewList(51, GL_COMPILE);
  glColor3f(1, 0, 1);
  glEndList();
  glCallList(51);
  say("a colour in a list");
  // No list has the number 0: an error of glCallList, but not among others, nor in a list.
  const GLuint none_among[] = {51, 0, 51};
  glCallList(0);
  say("list 0 called");
  glCallLists(3, GL_UNSIGNED_INT, none_among);
  say("list 0 among others");
  glListBase(~0u);
  const GLubyte after_base[] = {1, 52};
  glCallLists(2, GL_UNSIGNED_BYTE, after_base);
  glListBase(0);
  say("list 0 by a base");
  for (GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    glNewList(60, mode);
    quad();
    glCallList(0);
    std::printf("list 0 in a list: error %x\n", glGetError());
    glCallLists(3, GL_UNSIGNED_INT, none_among);
    std::printf("among others: error %x\n", glGetError());
    glEndList();
    glCallList(60);
    say("list 0 in a list");
    // A packed number of no such type is an error where it is given.
    glNewList(61, mode);
    quad();
    glTexCoordP2ui(GL_FLOAT, 7);
    std::printf("packed as what is not: error %x\n", glGetError());
    quad();
    glMultiTexCoordP2ui(GL_TEXTURE0, GL_TRIANGLES, 7);
    std::printf("likewise of a unit: error %x\n", glGetError());
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
    glTexCoord2f(1, 0), glVertex2f(0.9f, -0.9f);
    glVertexAttribP4ui(3, GL_FLOAT, GL_FALSE, 7);
    std::printf("likewise in a primitive: error %x\n", glGetError());
    glTexCoord2f(1, 1), glVertex2f(0.3f, 0.9f);
    glTexCoord2f(0, 1), glVertex2f(-0.3f, 0.9f);
    glEnd();
    glTexCoordP2ui(GL_INT_2_10_10_10_REV, 7 | 3 << 10);
    glEndList();
    glCallList(61);
    say("packed in a list");
    // The list that is being compiled is not there yet: what is deleted is the one before it.
    for (int i = 0; i < 2; ++i) {
      glNewList(62, mode);
      glColor3f(0, 0.25f, 0.75f);
      quad();
      glDeleteLists(61, 4);
      is(62);
      glColor3f(0, 0.5f, 0.75f);
      quad();
      if (i == 1) glDeleteLists(62, 1);
      glEndList();
      is(62);
      glColor3f(0, 0, 0), glTexCoord2f(0, 0);
      glCallList(62);
      say("deleted while it was compiled");
    }
  }
  // A Begin that another list ends.
  glNewList(52, GL_COMPILE);
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
  glTexCoord2f(1, 0), glVertex2f(0.9f, -0.9f);
  glTexCoord2f(1, 1), glVertex2f(0.3f, 0.9f);
  glTexCoord2f(0, 1), glVertex2f(-0.3f, 0.9f);
  glEndList();
  say("half a list");
  glNewList(53, GL_COMPILE);
  glEnd();
  glEndList();
  glCallList(52);
  glCallList(53);
  say("both halves");
  // Between the glBegin and glEnd of a list nothing can be asked of the driver, whoever made the glBegin.
  const GLuint called[] = {50, 51};
  glNewList(54, GL_COMPILE);
  glBegin(GL_POINTS);
  glCallLists(2, GL_UNSIGNED_INT, called);
  glEnd();
  glEndList();
  glCallList(54);
  say("lists in a primitive of a list");
  glNewList(55, GL_COMPILE);
  glBegin(GL_POINTS);
  glEndList();
  glNewList(56, GL_COMPILE);
  glEnd();
  glEndList();
  glCallList(55);
  glCallLists(2, GL_UNSIGNED_INT, called);
  glCallList(56);
  say("lists between halves");
  glBegin(GL_POINTS);
  glCallList(56);
  say("ended by a list");
  glBegin(GL_QUADS);
  glCallList(56);
  say("quads ended by a list");
  glListBase(40);
  const GLubyte offsets[] = {10, 11};
  glCallLists(2, GL_UNSIGNED_BYTE, offsets);
  glListBase(0);
  say("lists by a base after that");
  quad();
  // A call that this driver has, but not between glBegin and glEnd.
  const auto normal = reinterpret_cast<void (*)(GLint, GLint, GLint)>(OSMesaGetProcAddress("glNormal3xOES"));
  for (int i = 0; i < 2; ++i) {
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
    glTexCoord2f(1, 0), glVertex2f(0.9f, -0.9f);
    glTexCoord2f(1, 1), glVertex2f(0.3f, 0.9f);
    glTexCoord2f(0, 1), glVertex2f(-0.3f, 0.9f);
    if (normal) normal(0x4000, 0, 0x10000);
    glEnd();
    GLfloat now[3];
    glGetFloatv(GL_CURRENT_NORMAL, now);
    std::printf("normal %g %g %g\n", now[0], now[1], now[2]);
    say("a call that is missing in a primitive");
  }
  // A list is what it was, or is not, until its end.
  glPushMatrix();
  glLoadIdentity();
  const GLubyte itself_and_more[] = {61, 50, 61};
  glNewList(61, GL_COMPILE_AND_EXECUTE);
  glTranslatef(1, 0, 0);
  quad();
  glCallList(61);
  glTranslatef(0, 1, 0);
  glCallLists(3, GL_UNSIGNED_BYTE, itself_and_more);
  glEndList();
  glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
  std::printf("moved by %g %g error %x\n", matrix[12], matrix[13], glGetError());
  glPopMatrix();
  // The number that is being compiled may be given out: there is no such list yet.
  const GLuint given = glGenLists(1);
  glDeleteLists(given, 1);
  glNewList(given + 1, GL_COMPILE);
  glSecondaryColor3f(0.25f, 0.5f, 0.75f);
  quad();
  std::printf("gen %d\n", glGenLists(3) == given);
  is(given + 1);
  glEndList();
  is(given + 1);
  glCallList(given + 1);
  GLfloat secondary[4];
  glGetFloatv(GL_CURRENT_SECONDARY_COLOR, secondary);
  std::printf("secondary %g %g %g\n", secondary[0], secondary[1], secondary[2]);
  glDeleteLists(given, 3);
  // An error where it is called, not when the list is.
  const auto material = reinterpret_cast<void (*)(GLenum, GLenum, GLint)>(OSMesaGetProcAddress("glMaterialxOES"));
  const auto materials = reinterpret_cast<void (*)(GLenum, GLenum, const GLint*)>(OSMesaGetProcAddress("glMaterialxvOES"));
  const GLint fixed[4] = {0x8000, 0x4000, 0x2000, 0x10000};
  glNewList(57, GL_COMPILE);
  quad();
  if (material) material(GL_FRONT_AND_BACK, GL_DIFFUSE, 0x8000);
  std::printf("material of one number: error %x\n", glGetError());
  quad();
  if (material) material(GL_FRONT, GL_SHININESS, 0x8000);
  std::printf("one side's shininess: error %x\n", glGetError());
  quad();
  if (materials) materials(GL_BACK, GL_DIFFUSE, fixed);
  std::printf("one side's material: error %x\n", glGetError());
  quad();
  if (materials) materials(GL_FRONT_AND_BACK, GL_DIFFUSE, fixed);
  std::printf("material: error %x\n", glGetError());
  glEndList();
  GLfloat diffuse[4];
  glGetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
  std::printf("diffuse before the call %g %g %g %g\n", diffuse[0], diffuse[1], diffuse[2], diffuse[3]);
  glCallList(57);
  glGetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
  std::printf("diffuse %g %g %g %g\n", diffuse[0], diffuse[1], diffuse[2], diffuse[3]);
  ask_fixed();
  say("end");
}

}  // namespace

int main() {
  static std::vector<unsigned char> pixels(160 * 120 * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  if (!context || !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, 160, 120)) return 70;
  const unsigned char texels[16] = {};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);
  ask_all();
}
