// The program NAME-window: the scene in a GLUT window, frame after frame.
#include <GL/freeglut.h>

#include "common/sample.h"

namespace samples {
namespace {

constexpr unsigned kFrame_ms = 33;
constexpr unsigned char kEscape = 27;

// GLUT's callbacks take no argument of ours.
struct Shown {
  Sample* sample;
  const Options* options;
  int frame;
} shown;

void display() {
  draw_frame(*shown.sample, *shown.options, glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT),
             shown.frame);
  glutSwapBuffers();
}

void next_frame(int) {
  ++shown.frame;
  glutPostRedisplay();
  glutTimerFunc(kFrame_ms, next_frame, 0);
}

void key(unsigned char character, int, int) {
  if (character == 'q' || character == kEscape) glutLeaveMainLoop();
}

}  // namespace

int show(Sample& sample, const Options& options, char** argv) {
  int count = 1;  // the command line is read already
  glutInit(&count, argv);
  glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);
  glutInitWindowSize(options.width, options.height);
  glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
  glutCreateWindow(sample.name());
  shown = {&sample, &options, options.frame};
  sample.prepare();
  glutDisplayFunc(display);
  glutKeyboardFunc(key);
  glutTimerFunc(kFrame_ms, next_frame, 0);
  glutMainLoop();
  return 0;
}

}  // namespace samples
