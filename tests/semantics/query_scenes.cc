// What OpenGL reports of primitives and samples: selection, feedback, queries, transform feedback.
#include <vector>

#include "cases.h"
#include "scene_tools.h"

namespace truequad::semantics {
namespace {

void plain(const Shape& shape) {
  send_with(shape, [](const Vertex&, int) {});
}

// Draws before, in and after the other render mode: truequad's view of the state must not be an old one.
template <typename F>
void in_other_mode(unsigned first, unsigned seeds, GLenum mode, F draw) {
  prepare_scene();
  std::vector<GLfloat> fed(20000);
  std::vector<GLuint> hits(2000);
  glFeedbackBuffer(GLsizei(fed.size()), GL_3D_COLOR_TEXTURE, fed.data());
  glSelectBuffer(GLsizei(hits.size()), hits.data());
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    std::fill(fed.begin(), fed.end(), 0.0f);
    std::fill(hits.begin(), hits.end(), 0u);
    plain(shape);
    glRenderMode(mode);
    glInitNames();
    glPushName(7);
    draw(shape);
    GLint values[2] = {glRenderMode(GL_RENDER), 0};
    static int number = 0;
    const std::string name = std::to_string(number++);
    record("values " + name, values, sizeof values);
    if (mode == GL_FEEDBACK)
      record("fed " + name, fed);
    else
      record("hits " + name, hits);
    glColor3ub(9, 99, 199);
    plain(shape);
    glColor3ub(255, 255, 255);
  });
}

void feedback(unsigned first, unsigned seeds) {
  in_other_mode(first, seeds, GL_FEEDBACK, [](const Shape& shape) {
    glPassThrough(17);
    plain(shape);
    glPassThrough(18);
    send_with(shape, [](const Vertex&, int number) {
      glEdgeFlag(GLboolean(number % 2));
      glColor3ub(GLubyte(number * 40), 1, 2);
    });
    glEdgeFlag(GL_TRUE);
  });
}

void selection(unsigned first, unsigned seeds) {
  in_other_mode(first, seeds, GL_SELECT, [](const Shape& shape) {
    for (const GLuint name : {3u, 4u}) {
      glLoadName(name);
      plain(shape);
    }
  });
}

GLuint query_of(GLenum target, void (*draw)(const Shape&), const Shape& shape) {
  GLuint query = 0, count = 0;
  glGenQueries(1, &query);
  glBeginQuery(target, query);
  draw(shape);
  glEndQuery(target);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return count;
}

// Samples of the surface, of a second pass that depths reject where they are not nearer, and of half a
// window.
void samples_passed(unsigned first, unsigned seeds) {
  prepare_scene();
  std::vector<GLuint> counts;
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    counts.push_back(query_of(GL_SAMPLES_PASSED, plain, shape));
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, kWidth / 2, kHeight);
    counts.push_back(query_of(GL_SAMPLES_PASSED, plain, shape));
    glDisable(GL_SCISSOR_TEST);
    counts.push_back(query_of(GL_ANY_SAMPLES_PASSED, plain, shape));
  });
  record("counts", counts);
}

template <GLenum target>
void primitives(unsigned first, unsigned seeds) {
  prepare_scene();
  std::vector<GLuint> counts;
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    plain(shape);
    counts.push_back(query_of(target, plain, shape));
    plain(shape);
  });
  record("counts", counts);
}

// What is drawn depends on a query's result; the correction must be drawn under the same condition.
void conditional(unsigned first, unsigned seeds) {
  prepare_scene();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    for (const bool seen : {true, false}) {
      GLuint query = 0;
      glGenQueries(1, &query);
      glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
      glBeginQuery(GL_SAMPLES_PASSED, query);
      if (seen) plain(shape);
      glEndQuery(GL_SAMPLES_PASSED);
      glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      glBeginConditionalRender(query, GL_QUERY_WAIT);
      seen ? glColor3ub(200, 10, 20) : glColor3ub(20, 200, 10);
      plain(shape);
      glEndConditionalRender();
      glDeleteQueries(1, &query);
    }
  });
}

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  return shader;
}

// Vertices are recorded as a program's varyings: as many, and the same, as natively.
void transform_feedback(unsigned first, unsigned seeds) {
  prepare_scene();
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile(GL_VERTEX_SHADER,
                                  "varying vec4 out_texture; void main() { out_texture = gl_MultiTexCoord0; "
                                  "gl_Position = ftransform(); gl_FrontColor = gl_Color; }"));
  const char* varyings[] = {"out_texture"};
  glTransformFeedbackVaryings(program, 1, varyings, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  int number = 0;
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    std::vector<float> written(4 * 200);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, GLsizeiptr(written.size() * sizeof(float)), written.data(),
                 GL_STATIC_READ);
    plain(shape);
    glUseProgram(program);
    glBeginTransformFeedback(GL_TRIANGLES);
    const GLuint count = query_of(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, plain, shape);
    glEndTransformFeedback();
    glUseProgram(0);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLsizeiptr(written.size() * sizeof(float)),
                       written.data());
    record("written " + std::to_string(number), written);
    record("count " + std::to_string(number++), &count, sizeof count);
    plain(shape);
  });
}

// A program of the fragment side alone, which sees the coordinates, is the program's business.
void fragment_program(unsigned first, unsigned seeds) {
  prepare_scene();
  const GLuint program = glCreateProgram();
  glAttachShader(program,
                 compile(GL_FRAGMENT_SHADER,
                         "void main() { gl_FragColor = vec4(fract(gl_TexCoord[0].st * 8.0), 0.5, 1.0); }"));
  glLinkProgram(program);
  for_each_planar(first, seeds, "", [&](const Shape& shape) {
    glUseProgram(program);
    plain(shape);
    glUseProgram(0);
  });
}

}  // namespace

const std::vector<Scene>& query_scenes() {
  static const std::vector<Scene> scenes = {
      {"feedback", feedback},
      {"selection", selection},
      {"samples_passed", samples_passed},
      {"primitives_generated", primitives<GL_PRIMITIVES_GENERATED>},
      {"vertices_submitted", primitives<GL_VERTICES_SUBMITTED>},
      {"primitives_submitted", primitives<GL_PRIMITIVES_SUBMITTED>},
      {"vertex_invocations", primitives<GL_VERTEX_SHADER_INVOCATIONS>},
      {"clipping_input", primitives<GL_CLIPPING_INPUT_PRIMITIVES>},
      {"clipping_output", primitives<GL_CLIPPING_OUTPUT_PRIMITIVES>},
      {"fragment_invocations", primitives<GL_FRAGMENT_SHADER_INVOCATIONS>},
      {"conditional", conditional},
      {"transform_feedback", transform_feedback},
      {"fragment_program", fragment_program},
  };
  return scenes;
}

}  // namespace truequad::semantics
