// OpenGL with the prototypes of every extension, for the drawing programs.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
