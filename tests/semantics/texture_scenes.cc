// Kinds of textures and coordinates. Unit 0 is white and warped, so its quads are corrected; unit 1 shows a
// ramp by coordinates that are linear in the position, which a correction must not move.
#include <vector>

#include "cases.h"
#include "scene_tools.h"

namespace truequad::semantics {
namespace {

constexpr int kTexels = 64;

std::vector<unsigned char> ramp(int texels) {
  std::vector<unsigned char> image;
  for (int i = 0; i < texels; ++i) {
    const int at = i % kTexels;
    for (const int value : {4 * at, 255 - 4 * at, 2 * at, 255}) image.push_back((unsigned char)(value));
  }
  return image;
}

void bind_new(GLenum target) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(target, texture);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
  }
}

// A ramp along s as the texture `target` of the active unit.
void bind_ramp(GLenum target) {
  bind_new(target);
  const auto image = ramp(kTexels * 4);
  if (target == GL_TEXTURE_1D) {
    glTexImage1D(target, 0, GL_RGBA8, kTexels, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  } else if (target == GL_TEXTURE_3D) {
    glTexImage3D(target, 0, GL_RGBA8, kTexels, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  } else if (target == GL_TEXTURE_CUBE_MAP) {
    std::vector<unsigned char> square;
    for (int i = 0; i < kTexels; ++i) square.insert(square.end(), image.begin(), image.begin() + 4 * kTexels);
    for (GLenum face = 0; face < 6; ++face) {
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, kTexels, kTexels, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, square.data());
    }
  } else {
    glTexImage2D(target, 0, GL_RGBA8, kTexels, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  }
}

void prepare_ramp(GLenum target) {
  prepare_scene();
  glActiveTexture(GL_TEXTURE1);
  bind_ramp(target);
  glEnable(target);
  glActiveTexture(GL_TEXTURE0);
}

template <GLenum target>
void second_unit(unsigned first, unsigned seeds) {
  prepare_ramp(target);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp s(shape, 1, 0.5f, 0.2f), t(shape, -0.5f, 1, 0.1f);
    const float size = target == GL_TEXTURE_RECTANGLE ? kTexels : 1;
    send_with(shape, [&](const Vertex& v, int) {
      if (target == GL_TEXTURE_1D)
        glMultiTexCoord1f(GL_TEXTURE1, s(v));
      else if (target == GL_TEXTURE_3D)
        glMultiTexCoord3f(GL_TEXTURE1, s(v), t(v), 0.5f);
      else if (target == GL_TEXTURE_CUBE_MAP)
        glMultiTexCoord3f(GL_TEXTURE1, 2 * s(v) - 1, 2 * t(v) - 1, 1.5f);
      else
        glMultiTexCoord2f(GL_TEXTURE1, size * s(v), t(v));
    });
  });
}

// The texture matrices turn, scale and move: that of the warped unit too.
void matrices(unsigned first, unsigned seeds) {
  prepare_ramp(GL_TEXTURE_2D);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0.25f, 0.5f, 0);
  glRotatef(30, 0, 0, 1);
  glScalef(3, 2, 1);
  glActiveTexture(GL_TEXTURE1);
  glRotatef(20, 0, 0, 1);
  glScalef(0.5f, 2, 1);
  glActiveTexture(GL_TEXTURE0);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp s(shape, 1, 0.5f, 0.2f), t(shape, -0.5f, 1, 0.1f);
    send_with(shape, [&](const Vertex& v, int) { glMultiTexCoord2f(GL_TEXTURE1, s(v), t(v)); });
  });
}

// A matrix that makes q of s and t: light projected from a slide.
void projective_matrix(unsigned first, unsigned seeds) {
  prepare_ramp(GL_TEXTURE_2D);
  const float slide[] = {1, 0, 0, 0.5f, 0.25f, 1, 0, 0.25f, 0, 0, 1, 0, 0, 0, 0, 0.75f};
  glMatrixMode(GL_TEXTURE);
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
    glActiveTexture(unit);
    glLoadMatrixf(slide);
  }
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp s(shape, 1, 0.5f, 0.2f), t(shape, -0.5f, 1, 0.1f);
    send_with(shape, [&](const Vertex& v, int) { glMultiTexCoord2f(GL_TEXTURE1, s(v), t(v)); });
  });
}

// Generated coordinates on the second unit, from object and eye: linear in the position as well.
void generated(unsigned first, unsigned seeds) {
  prepare_ramp(GL_TEXTURE_2D);
  glActiveTexture(GL_TEXTURE1);
  const float plane[] = {0.2f, 0.1f, 0.05f, 0.4f};
  glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
  glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTexGenfv(GL_T, GL_EYE_PLANE, plane);
  glEnable(GL_TEXTURE_GEN_S);
  glEnable(GL_TEXTURE_GEN_T);
  glActiveTexture(GL_TEXTURE0);
  for_each_planar(first, seeds, "", [](const Shape& shape) { send_with(shape, [](const Vertex&, int) {}); });
  glActiveTexture(GL_TEXTURE1);
  glDisable(GL_TEXTURE_GEN_S);
  glDisable(GL_TEXTURE_GEN_T);
  glActiveTexture(GL_TEXTURE0);
}

// Unit 1 has no coordinate calls: its current coordinates are those of every vertex.
void constant_second(unsigned first, unsigned seeds) {
  prepare_ramp(GL_TEXTURE_2D);
  glMultiTexCoord2f(GL_TEXTURE1, 0.3f, 0.5f);
  for_each_planar(first, seeds, "", [](const Shape& shape) { send_with(shape, [](const Vertex&, int) {}); });
}

// The unit that is active when the quads are drawn is not the one that they are textured by.
void other_unit_active(unsigned first, unsigned seeds) {
  prepare_ramp(GL_TEXTURE_2D);
  glActiveTexture(GL_TEXTURE3);
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp s(shape, 1, 0.5f, 0.2f), t(shape, -0.5f, 1, 0.1f);
    glMatrixMode(GL_TEXTURE);
    send_with(shape, [&](const Vertex& v, int) { glMultiTexCoord2f(GL_TEXTURE1, s(v), t(v)); });
    GLint active = 0, mode = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    glGetIntegerv(GL_MATRIX_MODE, &mode);
    if (active != GL_TEXTURE3 || mode != GL_TEXTURE) glClear(GL_COLOR_BUFFER_BIT);
  });
}

// White textures of other kinds, warped: s alone, s t r, s t r 1, in texels.
template <GLenum target>
void warped(unsigned first, unsigned seeds) {
  prepare_scene();
  glDisable(GL_TEXTURE_2D);
  bind_ramp(target);
  const std::vector<unsigned char> white(kTexels * kTexels * 4, 255);
  if (target == GL_TEXTURE_1D) {
    glTexImage1D(target, 0, GL_RGBA8, kTexels, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  } else if (target == GL_TEXTURE_3D) {
    glTexImage3D(target, 0, GL_RGBA8, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  } else {
    glTexImage2D(target, 0, GL_RGBA8, kTexels, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  }
  glEnable(target);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp red(shape, 1, 0.5f, 0.2f), green(shape, -0.5f, 1, 0.1f);
    const Listed listed;
    for (const Primitive& primitive : shape.primitives) {
      glBegin(primitive.mode);
      for (const Vertex& v : primitive.vertices) {
        glColor3f(red(v), green(v), 1);
        if (target == GL_TEXTURE_1D)
          glTexCoord1f(v.u);
        else if (target == GL_TEXTURE_3D)
          glTexCoord4f(v.u, v.v, v.u * v.v, 1);
        else
          glTexCoord2f(kTexels * v.u, 4 * v.v);
        glVertex3f(v.position[0], v.position[1], v.position[2]);
      }
      glEnd();
    }
  });
  glDisable(target);
  glEnable(GL_TEXTURE_2D);
}

// A ramp that is seen, in a texture of another kind and in one of two dimensions: with the same coordinates, which warp it.
template <GLenum target>
void seen(unsigned first, unsigned seeds) {
  prepare_scene();
  for (const bool plane : {false, true}) {
    glDisable(target);
    glDisable(GL_TEXTURE_2D);
    const GLenum kind = plane ? GLenum(GL_TEXTURE_2D) : target;
    bind_ramp(kind);
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(kind);
    for_each_planar(first, seeds, plane ? "plane " : "seen ", [&](const Shape& shape) {
      const float size = kind == GL_TEXTURE_RECTANGLE ? kTexels : 1;
      for (const Primitive& primitive : shape.primitives) {
        glBegin(primitive.mode);
        for (const Vertex& v : primitive.vertices) {
          if (target == GL_TEXTURE_1D) glTexCoord1f(v.u);
          else if (target == GL_TEXTURE_3D) glTexCoord3f(v.u, v.v, 0.5f);
          else glTexCoord2f(size * v.u, (size == 1 ? 1 : 4) * v.v);
          glVertex3f(v.position[0], v.position[1], v.position[2]);
        }
        glEnd();
      }
    });
  }
  glDisable(target);
  glEnable(GL_TEXTURE_2D);
}

// The program's own q, on a ramp that is seen: left alone to the last bit.
void own_q(unsigned first, unsigned seeds) {
  prepare_scene();
  bind_ramp(GL_TEXTURE_2D);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Listed listed;
    for (const Primitive& primitive : shape.primitives) {
      glBegin(primitive.mode);
      int number = 0;
      for (const Vertex& v : primitive.vertices) {
        const float q = 1 + 0.25f * float(number++ % 3);
        glTexCoord4f(v.u * q, v.v * q, 0, q);
        glVertex3f(v.position[0], v.position[1], v.position[2]);
      }
      glEnd();
    }
  });
}

// Coordinates that are generated by a sphere map are the driver's.
void sphere_map(unsigned first, unsigned seeds) {
  prepare_scene();
  bind_ramp(GL_TEXTURE_2D);
  for (const GLenum coordinate : {GL_S, GL_T}) glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
  glEnable(GL_TEXTURE_GEN_S);
  glEnable(GL_TEXTURE_GEN_T);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    send_with(shape, [](const Vertex&, int number) { glNormal3f(0.3f * float(number % 2), 0.6f, 0.8f); });
  });
}

}  // namespace

const std::vector<Scene>& texture_scenes() {
  static const std::vector<Scene> scenes = {
      {"second_unit_1d", second_unit<GL_TEXTURE_1D>},
      {"second_unit_2d", second_unit<GL_TEXTURE_2D>},
      {"second_unit_3d", second_unit<GL_TEXTURE_3D>},
      {"second_unit_rectangle", second_unit<GL_TEXTURE_RECTANGLE>},
      {"second_unit_cube", second_unit<GL_TEXTURE_CUBE_MAP>},
      {"matrices", matrices},
      {"projective_matrix", projective_matrix},
      {"generated", generated},
      {"constant_second", constant_second},
      {"other_unit_active", other_unit_active},
      {"warped_1d", warped<GL_TEXTURE_1D>},
      {"warped_3d", warped<GL_TEXTURE_3D>},
      {"warped_rectangle", warped<GL_TEXTURE_RECTANGLE>},
      {"seen_1d", seen<GL_TEXTURE_1D>},
      {"seen_3d", seen<GL_TEXTURE_3D>},
      {"seen_rectangle", seen<GL_TEXTURE_RECTANGLE>},
      {"own_q", own_q},
      {"sphere_map", sphere_map},
  };
  return scenes;
}

}  // namespace truequad::semantics
