// What programs share that draw scenes (scenes.h) with OSMesa in one of many ways: display lists, arrays. They know nothing of
// truequad.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <functional>
#include <map>
#include <string>

#include "scenes.h"

namespace truequad::images {

using Way = std::function<void(const Scene&)>;

// Of the picture, in pixels.
extern int canvas_width, canvas_height;

// Two contexts that share their objects; the first one is current when a way is called, and is to be when it ends.
extern OSMesaContext first_context, second_context;
void make_current(OSMesaContext context);

GLenum mode_of(const Primitive& primitive);

// The scene's viewport and matrices, with texturing.
void look(const Scene& scene);

// PROGRAM FAMILY,FAMILY… COUNT WIDTH HEIGHT WAY FILE: writes the raw pictures of COUNT seeds of each family. Returns the exit
// status, which is 1 if OpenGL reported an error.
int draw_in_a_way(const std::map<std::string, Way>& ways, int count, char** arguments);

}  // namespace truequad::images
