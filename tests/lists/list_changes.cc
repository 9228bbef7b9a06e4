// Lists that are compiled in one state and called in another.
#include "list_ways.h"

namespace truequad::images {
namespace {

// A program that computes what the fixed pipeline does.
GLuint program(GLenum type, const char* source) {
  const GLuint shader = glCreateShader(type), made = glCreateProgram();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(made, shader);
  glLinkProgram(made);
  return made;
}

void use_vertex_shader() {
  static const GLuint made = program(GL_VERTEX_SHADER,
                                     "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color;"
                                     " gl_TexCoord[0] = gl_MultiTexCoord0; }");
  glUseProgram(made);
}
void use_fragment_shader() {
  static const GLuint made = program(GL_FRAGMENT_SHADER,
                                     "uniform sampler2D image;"
                                     "void main() { gl_FragColor = gl_Color * texture2DProj(image, gl_TexCoord[0]); }");
  glUseProgram(made);
}
void use_no_shader() { glUseProgram(0); }

void use_vertex_program() {
  static const GLuint made = [] {
    static const char source[] =
        "!!ARBvp1.0\nPARAM m[4] = { state.matrix.mvp };\n"
        "DP4 result.position.x, m[0], vertex.position;\nDP4 result.position.y, m[1], vertex.position;\n"
        "DP4 result.position.z, m[2], vertex.position;\nDP4 result.position.w, m[3], vertex.position;\n"
        "MOV result.color, vertex.color;\nMOV result.texcoord[0], vertex.texcoord[0];\nEND";
    GLuint name;
    glGenProgramsARB(1, &name);
    glBindProgramARB(GL_VERTEX_PROGRAM_ARB, name);
    glProgramStringARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, sizeof source - 1, source);
    return name;
  }();
  glBindProgramARB(GL_VERTEX_PROGRAM_ARB, made);
  glEnable(GL_VERTEX_PROGRAM_ARB);
}
void use_no_vertex_program() { glDisable(GL_VERTEX_PROGRAM_ARB); }

void generate(GLenum mode) {
  for (const GLenum coordinate : {GL_S, GL_T}) {
    glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GLint(mode));
    glEnable(coordinate == GL_S ? GL_TEXTURE_GEN_S : GL_TEXTURE_GEN_T);
  }
}
void generate_nothing() {
  glDisable(GL_TEXTURE_GEN_S);
  glDisable(GL_TEXTURE_GEN_T);
}

void turn(GLenum matrix, float degrees) {
  glMatrixMode(matrix);
  glPushMatrix();
  glRotatef(degrees, 0.25f, 0.5f, 1);
  glMatrixMode(GL_MODELVIEW);
}
void turn_back(GLenum matrix) {
  glMatrixMode(matrix);
  glPopMatrix();
  glMatrixMode(GL_MODELVIEW);
}

struct Change {
  const char* state;
  void (*enter)();
  void (*leave)();
};

constexpr Change kChanges[] = {
    {"no_texture", [] { glDisable(GL_TEXTURE_2D); }, [] { glEnable(GL_TEXTURE_2D); }},
    {"object_linear", [] { generate(GL_OBJECT_LINEAR); }, generate_nothing},
    {"sphere_map", [] { generate(GL_SPHERE_MAP); }, generate_nothing},
    {"vertex_shader", use_vertex_shader, use_no_shader},
    {"fragment_shader", use_fragment_shader, use_no_shader},
    {"vertex_program", use_vertex_program, use_no_vertex_program},
    {"texture_matrix", [] { turn(GL_TEXTURE, 25); }, [] { turn_back(GL_TEXTURE); }},
    {"modelview", [] { turn(GL_MODELVIEW, 20); }, [] { turn_back(GL_MODELVIEW); }},
    {"projection", [] { turn(GL_PROJECTION, 20); }, [] { turn_back(GL_PROJECTION); }},
    {"viewport", [] { glPushAttrib(GL_VIEWPORT_BIT), glViewport(5, 7, 50, 40); }, glPopAttrib},
    {"lines", [] { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); }, [] { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
    {"flat", [] { glPushAttrib(GL_LIGHTING_BIT), glShadeModel(GL_FLAT); }, glPopAttrib},
    {"lighting", [] { glPushAttrib(GL_LIGHTING_BIT), glEnable(GL_LIGHTING), glEnable(GL_LIGHT0); }, glPopAttrib},
    {"equal_depth",
     [] { glPushAttrib(GL_DEPTH_BUFFER_BIT), glClear(GL_DEPTH_BUFFER_BIT), glEnable(GL_DEPTH_TEST), glDepthFunc(GL_LEQUAL); },
     glPopAttrib},
};

}  // namespace

void add_changes(std::map<std::string, Way>& ways) {
  for (const Change& change : kChanges) {
    const std::string state = change.state;
    ways["immediate_" + state] = [&change](const Scene& s) {
      change.enter();
      primitives(s);
      change.leave();
    };
    ways["before_" + state] = [&change](const Scene& s) {
      glNewList(3, GL_COMPILE);
      primitives(s);
      glEndList();
      change.enter();
      glCallList(3);
      change.leave();
    };
    ways["within_" + state] = [&change](const Scene& s) {
      change.enter();
      glNewList(3, GL_COMPILE);
      primitives(s);
      glEndList();
      change.leave();
      glCallList(3);
    };
  }
}

}  // namespace truequad::images
