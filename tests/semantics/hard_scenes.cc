// Numbers that no program should give: NaN, infinity, the largest and the smallest, matrices without inverse, viewports without
// size. Beside each bad quad a good one is drawn, and everything is recorded that can be asked.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>

#include "cases.h"
#include "scene_tools.h"
#include "values.h"

namespace truequad::semantics {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

struct Element {
  GLfloat texture[4], colour[4], normal[3], position[4];
};
// Two trapezoids, the first above the second.
std::vector<Element> quads() {
  constexpr float kX[] = {-0.8f, 0.8f, 0.3f, -0.3f}, kS[] = {0, 1, 1, 0}, kT[] = {0, 0, 1, 1};
  std::vector<Element> elements;
  for (int quad = 0; quad < 2; ++quad) {
    for (int i = 0; i < 4; ++i) {
      const float y = float(1 - quad) - 0.9f + 0.8f * kT[i];
      elements.push_back({{kS[i], kT[i], 0, 1}, {1, 0.75f, 0.5f, 1}, {0, 0, 1}, {kX[i], y, 0, 1}});
    }
  }
  return elements;
}

void send_immediately(const std::vector<Element>& elements) {
  glBegin(GL_QUADS);
  for (const Element& e : elements) {
    glTexCoord4fv(e.texture);
    glColor4fv(e.colour);
    glNormal3fv(e.normal);
    glVertex4fv(e.position);
  }
  glEnd();
}

void enable_arrays(bool on) {
  for (const GLenum array : {GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_VERTEX_ARRAY}) {
    on ? glEnableClientState(array) : glDisableClientState(array);
  }
}

void point_at(const unsigned char* base) {
  constexpr GLsizei kStride = sizeof(Element);
  glTexCoordPointer(4, GL_FLOAT, kStride, base + offsetof(Element, texture));
  glColorPointer(4, GL_FLOAT, kStride, base + offsetof(Element, colour));
  glNormalPointer(GL_FLOAT, kStride, base + offsetof(Element, normal));
  glVertexPointer(4, GL_FLOAT, kStride, base + offsetof(Element, position));
}

void send_arrays(const std::vector<Element>& elements) {
  point_at(reinterpret_cast<const unsigned char*>(elements.data()));
  enable_arrays(true);
  glDrawArrays(GL_QUADS, 0, GLsizei(elements.size()));
  enable_arrays(false);
}

void send_from_buffer(const std::vector<Element>& elements) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(elements.size() * sizeof(Element)), elements.data(), GL_STATIC_DRAW);
  point_at(nullptr);
  enable_arrays(true);
  const GLushort indices[] = {0, 1, 2, 3, 4, 5, 6, 7};
  glDrawElements(GL_QUADS, 8, GL_UNSIGNED_SHORT, indices);
  enable_arrays(false);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
}

void send_listed(const std::vector<Element>& elements) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  send_immediately(elements);
  glEndList();
  glCallList(list);
  glDeleteLists(list, 1);
}

// The picture, the error, and what can be asked.
void record_all(const std::string& name) {
  const GLenum error = glGetError();
  record("error " + name, &error, sizeof error);
  record_picture(name);
  record("values " + name, current_values());
  record("state " + name, other_state());
}

using Quads = std::vector<Element>;

// `spoil` makes the first quad bad.
void spoiled(const std::string& name, const std::function<void(Quads&)>& spoil) {
  const std::pair<const char*, void (*)(const Quads&)> kWays[] = {
      {"immediate ", send_immediately}, {"arrays ", send_arrays}, {"buffer ", send_from_buffer}, {"list ", send_listed}};
  for (const auto& [way, send] : kWays) {
    Quads elements = quads();
    spoil(elements);
    glClear(GL_COLOR_BUFFER_BIT);
    send(elements);
    record_all(way + name);
  }
  glColor4f(1, 1, 1, 1);
  glTexCoord4f(0, 0, 0, 1);
  glNormal3f(0, 0, 1);
}

constexpr float kBad[] = {kNan, kInfinity, -kInfinity};

// In one vertex, and in all.
void bad_vertices(unsigned, unsigned) {
  prepare_scene();
  for (const float bad : kBad) {
    const std::string number = std::to_string(bad) + " ";
    for (int k = 0; k < 4; ++k) {
      const std::string name = number + std::to_string(k);
      spoiled("position " + name, [&](Quads& q) { q[2].position[k] = bad; });
      spoiled("positions " + name, [&](Quads& q) {
        for (Element& e : q) e.position[k] = bad;
      });
      spoiled("texture " + name, [&](Quads& q) { q[1].texture[k] = bad; });
      spoiled("colour " + name, [&](Quads& q) { q[3].colour[k] = bad; });
    }
  }
}

// Finite ones: nothing is known of what is drawn of a vertex at 1e30, but that it is the same.
void extreme_vertices(unsigned, unsigned) {
  prepare_scene();
  for (const float extreme : {0.f, 1e30f, 3e38f, 1e-30f, 1e-42f}) {
    const std::string number = std::to_string(std::ilogb(extreme)) + " ";
    // At infinity or nearly so, in a direction that leaves the picture convex.
    if (extreme < 1) {
      spoiled("w " + number, [&](Quads& q) {
        const GLfloat far[] = {0.6f, 0.3f, 0, extreme};
        std::copy(std::begin(far), std::end(far), q[2].position);
      });
    }
    spoiled("all w " + number, [&](Quads& q) {
      for (std::size_t i = 0; i < 4; ++i) q[i].position[3] = extreme;
    });
    spoiled("q " + number, [&](Quads& q) { q[2].texture[3] = extreme; });
    spoiled("s " + number, [&](Quads& q) { q[2].texture[0] = extreme; });
    spoiled("all tiny or huge " + number, [&](Quads& q) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (float& x : q[i].position) x *= extreme;
      }
    });
  }
}

void lit_by_bad_numbers(unsigned, unsigned) {
  prepare_scene();
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  for (const float bad : {kNan, kInfinity, 0.f}) {
    const std::string number = std::to_string(bad);
    const float position[] = {bad, 0, 1, 1}, fine[] = {0, 0, 1, 1};
    spoiled("normal " + number, [&](Quads& q) { q[1].normal[0] = bad; });
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    spoiled("light " + number, [](Quads&) {});
    glLightfv(GL_LIGHT0, GL_POSITION, fine);
    const float zero[] = {bad, bad, bad, bad}, white[] = {0.8f, 0.8f, 0.8f, 1};
    glMaterialfv(GL_FRONT, GL_DIFFUSE, zero);
    spoiled("material " + number, [](Quads&) {});
    glMaterialfv(GL_FRONT, GL_DIFFUSE, white);
  }
  glDisable(GL_LIGHTING);
}

void bad_matrices(unsigned, unsigned) {
  prepare_scene();
  for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
    glMatrixMode(mode);
    for (int kind = 0; kind < 8; ++kind) {
      float matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
      switch (kind) {
        case 0: matrix[0] = kNan; break;
        case 1: matrix[13] = kInfinity; break;
        case 2: matrix[15] = kNan; break;
        case 3: std::fill(std::begin(matrix), std::end(matrix), 0.f); break;
        case 4: matrix[5] = 0; break;                 // no height
        case 5: matrix[15] = 0; break;                // at infinity
        case 6: std::fill(std::begin(matrix), std::end(matrix), 0.5f); break;
        default: matrix[0] = matrix[5] = 1e30f;
      }
      glLoadMatrixf(matrix);
      spoiled("matrix " + std::to_string(mode) + " " + std::to_string(kind), [](Quads&) {});
      glLoadIdentity();
    }
  }
  glMatrixMode(GL_MODELVIEW);
}

void bad_viewports(unsigned, unsigned) {
  prepare_scene();
  constexpr int kSizes[][4] = {{0, 0, 0, 0},     {0, 0, kWidth, 0},        {0, 0, 0, kHeight},         {0, 0, -1, kHeight},
                               {5, 5, 1, 1},     {-9, -9, 1 << 30, 1 << 30}, {1 << 20, 0, kWidth, 100}, {-50, -50, 16384, 16384}};
  for (const auto& size : kSizes) {
    glViewport(size[0], size[1], size[2], size[3]);
    spoiled("viewport " + std::to_string(size[0]) + " " + std::to_string(size[2]) + " " + std::to_string(size[3]), [](Quads&) {});
    glViewport(0, 0, kWidth, kHeight);
  }
  glEnable(GL_DEPTH_TEST);
  for (const float bad : kBad) {
    glClear(GL_DEPTH_BUFFER_BIT);
    glDepthRange(bad, 1);
    spoiled("depth range " + std::to_string(bad), [](Quads&) {});
    glDepthRange(0, bad);
    spoiled("depth range to " + std::to_string(bad), [](Quads&) {});
  }
  glDepthRange(0, 1);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace

const std::vector<Scene>& hard_scenes() {
  static const std::vector<Scene> scenes = {
      {"bad_vertices", bad_vertices},   {"extreme_vertices", extreme_vertices}, {"lit_by_bad_numbers", lit_by_bad_numbers},
      {"bad_matrices", bad_matrices}, {"bad_viewports", bad_viewports},
  };
  return scenes;
}

}  // namespace truequad::semantics
