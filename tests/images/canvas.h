// A place to draw into with OpenGL: one drawing program for each window-system interface has its own.
#pragma once

namespace truequad::images {

// Makes a context current that draws into `width` × `height` pixels with 24 bits of depth and 8 of
// stencil, or ends the process with a message.
void open_canvas(int width, int height);

}  // namespace truequad::images
