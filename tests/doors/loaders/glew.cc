// GLEW, shared or static: texture coordinates by a function that GLEW found.
#include <GL/glew.h>

#include "glx_window.h"

int main() {
  using namespace loaders;
  if (!open_window({glXChooseVisual, glXCreateContext, glXMakeCurrent})) return 4;
  if (glewInit() != GLEW_OK) return 5;
#define LOADERS_LINKED(name) ::gl##name,
  Functions functions{LOADERS_FUNCTIONS(LOADERS_LINKED)};
#undef LOADERS_LINKED
  functions.TexCoord2f = [](GLfloat s, GLfloat t) { glMultiTexCoord2fARB(GL_TEXTURE0_ARB, s, t); };
  return show(functions);
}
