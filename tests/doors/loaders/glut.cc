// GLUT, linked.
#include <GL/freeglut.h>

#include "scene.h"

int main(int argc, char** argv) {
  using namespace loaders;
  glutInit(&argc, argv);
  glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE);
  glutInitWindowSize(kSize, kSize);
  glutCreateWindow("glut");
  glutDisplayFunc([] {
#define LOADERS_LINKED(name) gl##name,
    const int status = show({LOADERS_FUNCTIONS(LOADERS_LINKED)});
#undef LOADERS_LINKED
    glutSwapBuffers();
    std::exit(status);
  });
  glutMainLoop();
}
