// What is set for polygons as wholes: faces, modes, stipple, edges, samples.
#include <algorithm>
#include <iterator>
#include <vector>

#include "cases.h"
#include "scene_tools.h"

namespace truequad::semantics {
namespace {

void plain(const Shape& shape) {
  send_with(shape, [](const Vertex&, int) {});
}

void counting() {
  prepare_scene();
  glEnable(GL_BLEND);
  glColor3ub(kTouch, 2 * kTouch, 3 * kTouch);
}

void culling(unsigned first, unsigned seeds) {
  counting();
  glEnable(GL_CULL_FACE);
  for (const GLenum face : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) {
    for (const GLenum winding : {GL_CCW, GL_CW}) {
      glCullFace(face);
      glFrontFace(winding);
      for_each_planar(first, seeds, std::to_string(face) + " " + std::to_string(winding) + " ", plain);
    }
  }
}

void stipple(unsigned first, unsigned seeds) {
  counting();
  GLubyte pattern[128];
  for (int i = 0; i < 128; ++i) pattern[i] = GLubyte(i * 37 + (i / 4) * 91);
  glPolygonStipple(pattern);
  glEnable(GL_POLYGON_STIPPLE);
  for_each_planar(first, seeds, "", plain);
}

void smooth_edges(unsigned first, unsigned seeds) {
  counting();
  glEnable(GL_POLYGON_SMOOTH);
  for_each_planar(first, seeds, "", plain);
}

// Every second edge is one of the outline.
void edge_flags(const Shape& shape) {
  send_with(shape, [](const Vertex&, int number) { glEdgeFlag(GLboolean(number % 2)); });
}

template <GLenum front, GLenum back>
void modes(unsigned first, unsigned seeds) {
  counting();
  glPolygonMode(GL_FRONT, front);
  glPolygonMode(GL_BACK, back);
  for_each_planar(first, seeds, "", plain);
  for_each_planar(first, seeds, "flags ", edge_flags);
}

void filled_with_edge_flags(unsigned first, unsigned seeds) {
  counting();
  for_each_planar(first, seeds, "", edge_flags);
  // What the flags are afterwards shows in lines.
  for_each_planar(first, 1, "lines ", [](const Shape& shape) {
    edge_flags(shape);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  });
}

// Four samples for each pixel: the covered samples are those of two triangles.
void samples(unsigned first, unsigned seeds) {
  counting();
  GLuint buffers[2], resolved = 0;
  glGenRenderbuffers(1, &resolved);
  glBindRenderbuffer(GL_RENDERBUFFER, resolved);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, kWidth, kHeight);
  glGenFramebuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, buffers[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved);
  GLint number = 0;
  glGetIntegerv(GL_SAMPLES, &number);
  record("samples", &number, sizeof number);
  for (const char* kind : kPlanar) {
    for (unsigned seed = first; seed < first + seeds; ++seed) {
      const Shape shape = make_shape(kind, seed);
      glBindFramebuffer(GL_FRAMEBUFFER, buffers[0]);
      begin_frame(shape);
      glColor3ub(200, 100, 40);
      plain(shape);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, buffers[0]);
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
      glClear(GL_COLOR_BUFFER_BIT);
      glBlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT, GL_NEAREST);
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      record_picture(std::string(kind) + " " + std::to_string(seed));
    }
  }
}

// Cut by a plane: on the cut's border too the mesh covers what two triangles cover.
void clip_plane(unsigned first, unsigned seeds) {
  counting();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const GLdouble plane[] = {0.6, 0.8, 0.1, 0.2};
    glPushMatrix();
    glLoadIdentity();
    glClipPlane(GL_CLIP_PLANE0, plane);
    glPopMatrix();
    glEnable(GL_CLIP_PLANE0);
    plain(shape);
    glDisable(GL_CLIP_PLANE0);
  });
}

// Offset alone, seen by the depths: they are the native ones but for rounding, so none of two layers shows
// through.
void offset_layers(unsigned first, unsigned seeds) {
  counting();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    for (const int layer : {0, 2, -2, 1}) {
      glPolygonOffset(GLfloat(2 * layer), GLfloat(64 * layer));
      plain(shape);
    }
  });
}

// In pieces: scissors, colour masks and a viewport that lies partly outside of the window.
void windowed(unsigned first, unsigned seeds) {
  counting();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glViewport(-40, 31, 3 * kWidth / 2, kHeight);
    plain(shape);
    glEnable(GL_SCISSOR_TEST);
    glScissor(30, 20, 60, 50);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    plain(shape);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  });
}

// How many pixels each surface touches never, once, twice and so on, by coordinates that stretch and fold the
// texture more and more: many seeds, so the pictures themselves are not kept.
void touched_once(unsigned first, unsigned seeds) {
  prepare_passes();
  glDisable(GL_DEPTH_TEST);
  std::vector<unsigned char> pixels(std::size_t(kWidth) * kHeight);
  for (const char* kind : kPlanar) {
    for (const Coordinates coordinates : {Coordinates::kWarped, Coordinates::kOther, Coordinates::kTwisted}) {
      for (unsigned seed = first; seed < first + seeds; ++seed) {
        const Shape shape = make_shape(kind, seed);
        begin_frame(shape);
        draw(shape, {.coordinates = coordinates});
        glReadPixels(0, 0, kWidth, kHeight, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
        std::vector<GLuint> counts(5);
        for (const unsigned char pixel : pixels) ++counts[std::min<std::size_t>(pixel / kTouch, 4)];
        record(std::string(kind) + " " + std::to_string(int(coordinates)) + " " + std::to_string(seed),
               counts);
      }
    }
  }
}

// Textures that are a triangle, a line or a point's neighbourhood on the quad: no pixel outside of it is
// touched, and none inside twice.
void flat_textures(unsigned, unsigned) {
  counting();
  constexpr float kTextures[][4][2] = {
      {{0, 0}, {1, 0}, {1, 1}, {1, 1}}, {{0, 0}, {0, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 1}, {1, 1}, {1, 1}},
      {{0, 0}, {0, 0}, {0, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 0}, {1, 1}}, {{0, 0}, {1, 0}, {0, 0}, {0, 1}},
      {{0, 0}, {1, 1}, {2, 2}, {5, 5}}, {{0, 0}, {1, 0}, {3, 0}, {0, 1}}, {{0, 0}, {3, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {{0, 0}, {0, 0}, {1, 1}, {1, 1}}, {{0, 0}, {1, 0}, {1, 0}, {0, 0}}};
  // The same quad as in all seeds of this suite, and others: tall, wide, turned, with edges through pixel
  // centres.
  constexpr float kQuads[][4][2] = {{{-0.75f, -0.875f}, {0.875f, -0.75f}, {0.25f, 0.75f}, {-0.375f, 0.625f}},
                                    {{-0.9f, -0.1f}, {0.9f, -0.8f}, {0.9f, 0.8f}, {-0.9f, 0.2f}},
                                    {{-0.1f, -0.9f}, {0.2f, -0.9f}, {0.9f, 0.9f}, {-0.8f, 0.9f}},
                                    {{-0.95f, -0.9f}, {0.1f, -0.95f}, {0.95f, 0.9f}, {-0.3f, 0.4f}}};
  for (std::size_t q = 0; q < std::size(kQuads); ++q) {
    for (std::size_t t = 0; t < std::size(kTextures); ++t) {
      for (std::size_t start = 0; start < 4; ++start) {
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_QUADS);
        for (std::size_t i = 0; i < 4; ++i) {
          glTexCoord2fv(kTextures[t][(i + start) % 4]);
          glVertex2fv(kQuads[q][i]);
        }
        glEnd();
        record_picture("quad " + std::to_string(q) + " texture " + std::to_string(t) + " from corner " +
                       std::to_string(start));
      }
    }
  }
}

}  // namespace

const std::vector<Scene>& polygon_scenes() {
  static const std::vector<Scene> scenes = {
      {"culling", culling},
      {"stipple", stipple},
      {"smooth_edges", smooth_edges},
      {"mode_line", modes<GL_LINE, GL_LINE>},
      {"mode_point", modes<GL_POINT, GL_POINT>},
      {"mode_front_line", modes<GL_LINE, GL_FILL>},
      {"mode_back_line", modes<GL_FILL, GL_LINE>},
      {"filled_with_edge_flags", filled_with_edge_flags},
      {"samples", samples},
      {"clip_planes", clip_plane},
      {"offset_layers", offset_layers},
      {"windowed", windowed},
      {"touched_once", touched_once},
      {"flat_textures", flat_textures},
  };
  return scenes;
}

}  // namespace truequad::semantics
