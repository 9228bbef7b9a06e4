// What the scenes of single features share. Textures are white where coordinates are warped, so that truequad
// corrects the quads and the picture must be the native one all the same.
#pragma once

#include <string>
#include <vector>

#include "pass.h"
#include "record.h"
#include "shapes.h"

namespace truequad::semantics {

// Shapes whose quads are planar and convex: attributes that are linear in the position are so over both
// triangles.
inline const char* const kPlanar[] = {"trapezoid", "tilted", "floor", "mixed", "strip", "polygon"};

// White in units 0 and 1, texturing in unit 0, no blending, no depth test, black.
void prepare_scene();

// A value from 0.1 to 0.9 that is linear in the position: the shape's extent decides how steep.
class Ramp {
 public:
  Ramp(const Shape& shape, float x, float y, float z = 0);
  float operator()(const Vertex& v) const;

 private:
  float along(const Vertex& v) const;
  float direction_[3], low_ = 0, size_ = 1;
};

// How a scene's primitives reach OpenGL: as they are, or as a display list for each shape.
enum class Lists { kNone, kCompile, kCompileAndExecute };
inline Lists listing = Lists::kNone;

// While it lives, calls go into a list; then that has been executed once, and is gone.
class Listed {
 public:
  Listed() {
    if (listing == Lists::kNone) return;
    list_ = glGenLists(1);
    glNewList(list_, listing == Lists::kCompile ? GL_COMPILE : GL_COMPILE_AND_EXECUTE);
  }
  ~Listed() {
    if (listing == Lists::kNone) return;
    glEndList();
    if (listing == Lists::kCompile) glCallList(list_);
    glDeleteLists(list_, 1);
  }
  Listed(const Listed&) = delete;
  Listed& operator=(const Listed&) = delete;

 private:
  GLuint list_ = 0;
};

// Whether the same primitives are drawn from vertex arrays, all attributes in arrays of their own.
inline bool from_arrays = false;

// Vertices with the current values that they are noted under.
class NotedVertices {
 public:
  void note(const Vertex& vertex);
  // By glDrawArrays; no array is enabled before or after.
  void draw(GLenum mode) const;

 private:
  struct Noted {
    GLfloat colour[4], secondary[4], normal[3], fog, texture[2], second[4], position[3];
    GLboolean edge;
  };
  std::vector<Noted> vertices_;
};

// The shape with warped coordinates; `attributes(vertex, number)` comes before each vertex.
template <typename F>
void send_with(const Shape& shape, F attributes) {
  const Listed listed;
  for (const Primitive& primitive : shape.primitives) {
    int number = 0;
    if (from_arrays) {
      NotedVertices vertices;
      for (const Vertex& v : primitive.vertices) {
        attributes(v, number++);
        vertices.note(v);
      }
      vertices.draw(primitive.mode);
      continue;
    }
    glBegin(primitive.mode);
    for (const Vertex& v : primitive.vertices) {
      attributes(v, number++);
      glTexCoord2f(v.u, v.v);
      glVertex3f(v.position[0], v.position[1], v.position[2]);
    }
    glEnd();
  }
}

// Calls draw(shape) for every planar shape and seed, each on a clear canvas with its matrices, and records
// the picture.
template <typename F>
void for_each_planar(unsigned first, unsigned seeds, const std::string& name, F draw) {
  for (const char* kind : kPlanar) {
    for (unsigned seed = first; seed < first + seeds; ++seed) {
      const Shape shape = make_shape(kind, seed);
      begin_frame(shape);
      draw(shape);
      record_picture(name + kind + " " + std::to_string(seed));
    }
  }
}

// A number of each kind of primitive for the programs that draw no shape: a warped quad, its corners in
// order.
struct Corner {
  float x, y, s, t;
};
inline constexpr Corner kWarpedQuad[] = {
    {-0.75f, -0.875f, 0, 0}, {0.875f, -0.75f, 1, 0}, {0.25f, 0.75f, 1, 1}, {-0.375f, 0.625f, 0, 1}};
void send_warped_quad();

}  // namespace truequad::semantics
