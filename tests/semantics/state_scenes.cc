// State around corrected quads: attribute stacks, display lists, debug output, and all that can be asked for.
#include <cstring>
#include <vector>

#include "cases.h"
#include "scene_tools.h"
#include "values.h"

namespace truequad::semantics {
namespace {

void warped_quad_with_values(GLenum mode) {
  glBegin(mode);
  glColor4ub(10, 20, 30, 40);
  glNormal3b(1, 2, 3);
  for (int i = 0; i < 4; ++i) {
    const Corner& c = kWarpedQuad[mode == GL_QUAD_STRIP ? i ^ (i >> 1) : i];
    glTexCoord2f(c.s, c.t);
    glMultiTexCoord3f(GL_TEXTURE2, c.t, 5, float(i));
    glFogCoordf(float(i));
    glSecondaryColor3us(GLushort(i), 7, 65535);
    glVertex2f(c.x, c.y);
  }
  glEdgeFlag(GL_FALSE);
  glTexCoord2s(11, 12);
  glEnd();
}

void record_all(const std::string& name) {
  record("values " + name, current_values());
  record("state " + name, other_state());
  record("errors " + name, all_errors());
}

// Everything that can be asked for, after one corrected primitive of each mode in an unusual state.
void state(unsigned, unsigned) {
  prepare_scene();
  glActiveTexture(GL_TEXTURE2);
  glEnable(GL_TEXTURE_2D);
  glMatrixMode(GL_TEXTURE);
  glPushMatrix();
  glRotatef(5, 0, 0, 1);
  glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  glClientActiveTexture(GL_TEXTURE1);
  glListBase(3);
  glEnable(GL_STENCIL_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthRange(0.25, 0.5);
  glPolygonOffset(1, 2);
  int number = 0;
  for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    warped_quad_with_values(mode);
    record_all(std::to_string(number++));
    glRasterPos2f(0.25f, 0.25f);
    record_all(std::to_string(number++));
  }
  glPopClientAttrib();
  glPopAttrib();
  record_all("popped");
}

// glPopAttrib brings back the values from before, and nothing of the mesh's.
void attribute_stack(unsigned, unsigned) {
  prepare_scene();
  int number = 0;
  for (const GLbitfield bits : {GLbitfield(GL_CURRENT_BIT), GLbitfield(GL_ALL_ATTRIB_BITS),
                                GLbitfield(GL_LIGHTING_BIT), GLbitfield(GL_TEXTURE_BIT | GL_ENABLE_BIT)}) {
    for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
      glColor4f(0.5f, 0.25f, 0.125f, 1);
      glTexCoord4f(9, 8, 7, 6);
      glPushAttrib(bits);
      glClear(GL_COLOR_BUFFER_BIT);
      warped_quad_with_values(mode);
      record_all("inside " + std::to_string(number));
      record_picture("picture " + std::to_string(number));
      glPopAttrib();
      record_all("outside " + std::to_string(number++));
    }
  }
}

// Lists that are compiled, compiled and executed, called, and called inside of Begin.
void lists(unsigned, unsigned) {
  prepare_scene();
  const GLuint list = glGenLists(3);
  glNewList(list, GL_COMPILE);
  warped_quad_with_values(GL_QUADS);
  record("compiling", other_state());
  glEndList();
  record_all("compiled");
  // Mesa leaves other current values after a list that it has compiled than the list's last ones: not compared.
  glCallList(list);
  record("state called", other_state());
  record("errors called", all_errors());
  record_picture("called");
  glClear(GL_COLOR_BUFFER_BIT);
  glNewList(list + 1, GL_COMPILE_AND_EXECUTE);
  warped_quad_with_values(GL_QUAD_STRIP);
  glEndList();
  record("state executed", other_state());
  record("errors executed", all_errors());
  record_picture("executed");
  glNewList(list + 2, GL_COMPILE);
  glColor3ub(1, 200, 3);
  glNormal3f(0, 1, 0);
  glEndList();
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_QUADS);
  send_warped_quad();
  glCallList(list + 2);
  send_warped_quad();
  glEnd();
  record_all("inside");
  record_picture("inside");
  // A primitive that begins in a list and ends outside.
  glNewList(list + 2, GL_COMPILE);
  glBegin(GL_QUADS);
  send_warped_quad();
  glEndList();
  glCallList(list + 2);
  glTexCoord2f(0.5f, 0.25f);
  glEnd();
  record_all("across");
}

struct Messages {
  std::vector<GLuint> numbers;
  std::string text;
};

void GLAPIENTRY hear(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei, const GLchar* message,
                     const void* user) {
  Messages& messages = *static_cast<Messages*>(const_cast<void*>(user));
  messages.numbers.insert(messages.numbers.end(), {source, type, id, severity});
  messages.text += message;
  messages.text += '\n';
}

// A debug callback hears of the program's errors alone.
void debug_output(unsigned, unsigned) {
  prepare_scene();
  Messages messages;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(hear, &messages);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  for (int round = 0; round < 3; ++round) {
    for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
      for (const GLenum shade : {GL_SMOOTH, GL_FLAT}) {
        glShadeModel(shade);
        warped_quad_with_values(mode);
      }
    }
    glBegin(GL_QUADS);
    send_warped_quad();
    glEnable(GL_LIGHTING);
    send_warped_quad();
    glEnd();
    glEnd();
    glEnable(0xdead);
  }
  glDebugMessageCallback(nullptr, nullptr);
  record("messages", messages.numbers);
  record("text", messages.text.data(), messages.text.size());
  record("errors", all_errors());
}

// Objects and names that a program counts on: none appears that it did not make.
void names(unsigned, unsigned) {
  prepare_scene();
  warped_quad_with_values(GL_QUADS);
  std::vector<GLuint> made(8);
  glGenTextures(2, made.data());
  made[2] = glGenLists(2);
  glGenBuffers(1, &made[3]);
  glGenQueries(1, &made[4]);
  glGenFramebuffers(1, &made[5]);
  glGenVertexArrays(1, &made[6]);
  made[7] = glCreateProgram();
  record("names", made);
  record_all("after");
}

}  // namespace

const std::vector<Scene>& state_scenes() {
  static const std::vector<Scene> scenes = {
      {"state", state}, {"attribute_stack", attribute_stack},
      {"lists", lists}, {"debug_output", debug_output},
      {"names", names},
  };
  return scenes;
}

}  // namespace truequad::semantics
