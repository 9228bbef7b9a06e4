// Runs a sample in a window of GLUT, until Escape, or for --repeat frames if the picture has to be written.
#include <GL/freeglut.h>

#include <cstdlib>
#include <exception>
#include <memory>

#include "common/frame.h"
#include "common/options.h"

namespace samples {
namespace {

constexpr int kFrame_ms = 33;

// GLUT's callbacks carry no argument of ours.
std::unique_ptr<Frames> frames;
bool endless = true;
int status = 0;
const char* program = "";

void display() {
  try {
    frames->draw(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    if (!endless && frames->done()) {
      frames->write();
      glutLeaveMainLoop();
    }
  } catch (const std::exception& error) {
    complain(program, error.what());
    status = 1;
    glutLeaveMainLoop();
  }
  glutSwapBuffers();
}

void tick(int) {
  glutPostRedisplay();
  glutTimerFunc(kFrame_ms, tick, 0);
}

void key(unsigned char character, int, int) {
  if (character == 27 || character == 'q') glutLeaveMainLoop();
}

}  // namespace

int run(Sample& sample, int argc, char** argv) {
  Options options;
  if (const auto early = parse(sample, argc, argv, options)) return *early;
  program = argv[0];
  endless = options.out.empty() && options.quads.empty() && !options.time;

  // GLUT would take words like -display out of the sample's own arguments.
  int none = 1;
  glutInit(&none, argv);
  glutInitDisplayMode(GLUT_RGBA | GLUT_DEPTH | GLUT_DOUBLE);
  glutInitWindowSize(options.width, options.height);
  glutCreateWindow(sample.about().c_str());
  glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
  frames = std::make_unique<Frames>(sample, options);
  try {
    frames->start();
  } catch (const std::exception& error) {
    complain(program, error.what());
    return 1;
  }
  glutDisplayFunc(display);
  glutKeyboardFunc(key);
  glutTimerFunc(kFrame_ms, tick, 0);
  glutMainLoop();
  return status;
}

}  // namespace samples
