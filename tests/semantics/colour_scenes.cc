// Colours, secondary colours and fog coordinates: flat ones exactly, and those that are linear in the
// position.
#include "cases.h"
#include "scene_tools.h"

namespace truequad::semantics {
namespace {

void colour_of(int number) {
  glColor3ub(GLubyte(40 + 53 * number % 200), GLubyte(30 + 97 * number % 210),
             GLubyte(20 + 31 * number % 220));
}

template <GLenum convention>
void flat(unsigned first, unsigned seeds) {
  prepare_scene();
  glShadeModel(GL_FLAT);
  glProvokingVertex(convention);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    send_with(shape, [](const Vertex&, int number) { colour_of(number); });
  });
}

// The colour is the current one at the first quad's vertices, and set from the second vertex on.
void flat_late(unsigned first, unsigned seeds) {
  prepare_scene();
  glShadeModel(GL_FLAT);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glColor3ub(10, 20, 30);
    send_with(shape, [](const Vertex&, int number) {
      if (number >= 2) colour_of(number);
    });
  });
}

void flat_secondary(unsigned first, unsigned seeds) {
  prepare_scene();
  glShadeModel(GL_FLAT);
  glEnable(GL_COLOR_SUM);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glColor3f(0.1f, 0.1f, 0.1f);
    send_with(shape, [](const Vertex&, int number) {
      glSecondaryColor3ub(GLubyte(50 * number % 200), GLubyte(70 * number % 200), 99);
    });
  });
  glDisable(GL_COLOR_SUM);
}

void smooth(unsigned first, unsigned seeds) {
  prepare_scene();
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp red(shape, 1, 0.5f, 0.2f), green(shape, -0.5f, 1, 0.1f);
    send_with(shape, [&](const Vertex& v, int) { glColor3f(red(v), green(v), 0.5f); });
  });
}

void secondary(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_COLOR_SUM);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp red(shape, 1, 0.5f, 0.2f), green(shape, -0.5f, 1, 0.1f);
    glColor3f(0, 0, 0);
    send_with(shape, [&](const Vertex& v, int) { glSecondaryColor3f(red(v), green(v), 0.5f); });
  });
  glDisable(GL_COLOR_SUM);
}

// Colours out of range, without clamping at the vertices: what is seen is the clamped ramp, as natively.
void unclamped(unsigned first, unsigned seeds) {
  prepare_scene();
  glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp ramp(shape, 1, 0.5f, 0.2f);
    send_with(shape, [&](const Vertex& v, int) {
      const float at = 3 * ramp(v) - 1;
      glColor3f(at, 1 - at, 0.5f);
    });
  });
  glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
}

void fog_coordinate(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  const float colour[] = {0, 0.5f, 1, 1};
  glFogfv(GL_FOG_COLOR, colour);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const Ramp ramp(shape, 1, 0.5f, 0.2f);
    send_with(shape, [&](const Vertex& v, int) { glFogCoordf(ramp(v)); });
  });
}

// Secondary colours and fog coordinates that no map of the position makes: what is seen is ours alone, and the same whichever
// way the vertices come.
float unrelated(int number) { return float(number * 7 % 11) / 10; }

void bent_secondary(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_COLOR_SUM);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glColor3f(0.1f, 0, 0.2f);
    send_with(shape, [&](const Vertex&, int number) {
      glSecondaryColor3f(unrelated(number), unrelated(number + 1), unrelated(number + 2));
    });
  });
  glDisable(GL_COLOR_SUM);
}

void bent_fog(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, GL_EXP2);
  glFogf(GL_FOG_DENSITY, 1.5f);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    send_with(shape, [&](const Vertex&, int number) { glFogCoordf(unrelated(number)); });
  });
}

// Mesa takes the fog of a vertex behind the eye for that of one in front, so the floor's is no ramp natively.
void fog_of_depth(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0.5f);
  glFogf(GL_FOG_END, 8);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    const bool behind = shape.modelview[9] == -1;
    if (!behind) send_with(shape, [](const Vertex&, int) {});
  });
}

// Translucent, over itself and its neighbours: each pixel is blended once for each quad that covers it.
void translucent(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    for (int layer = 0; layer < 3; ++layer) {
      glColor4f(1, 0.5f * float(layer), 0.25f, 0.375f);
      send_with(shape, [](const Vertex&, int) {});
    }
  });
}

// Every second quad is discarded as a whole.
void alpha_test(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_ALPHA_TEST);
  glShadeModel(GL_FLAT);
  glAlphaFunc(GL_GEQUAL, 0.5f);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    send_with(shape, [](const Vertex&, int number) {
      glColor4f(1, 0.5f, 0.25f, (number / 4 + number) % 2 ? 0.75f : 0.25f);
    });
  });
  glDisable(GL_ALPHA_TEST);
}

void logic_operation(unsigned first, unsigned seeds) {
  prepare_scene();
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_XOR);
  for_each_planar(first, seeds, "", [](const Shape& shape) {
    glColor3ub(0x55, 0x0f, 0xff);
    for (int layer = 0; layer < 3; ++layer) send_with(shape, [](const Vertex&, int) {});
  });
  glDisable(GL_COLOR_LOGIC_OP);
}

// Colours that no map of the position makes, for the pictures that TRUEQUAD_COLOR=1 changes: given or of a lamp, on textured
// quads and others, in immediate mode or a list, from arrays or by glRect.
template <bool arrays>
void kinked(unsigned first, unsigned seeds) {
  prepare_scene();
  const float place[] = {0.25f, 0.5f, -1, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, place);
  glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.5f);
  glEnable(GL_LIGHT0);
  glNormal3f(0, 0, 1);
  for (const bool textured : {false, true}) {
    textured ? glEnable(GL_TEXTURE_2D) : glDisable(GL_TEXTURE_2D);
    for (const bool lit : {false, true}) {
      lit ? glEnable(GL_LIGHTING) : glDisable(GL_LIGHTING);
      const std::string name = std::string(textured ? "textured " : "") + (lit ? "lit " : "given ");
      for_each_planar(first, seeds, name, [](const Shape& shape) {
        const Listed listed;
        for (const Primitive& primitive : shape.primitives) {
          struct Colour {
            float rgb[3];
          };
          std::vector<Colour> colours;
          for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
            colours.push_back({{i % 3 == 0 ? 0.9f : 0.2f, i % 4 < 2 ? 0.1f : 0.8f, i % 5 == 2 ? 0.7f : 0.3f}});
          }
          if (arrays) {
            glEnableClientState(GL_VERTEX_ARRAY);
            glEnableClientState(GL_COLOR_ARRAY);
            glEnableClientState(GL_TEXTURE_COORD_ARRAY);
            const Vertex& vertex = primitive.vertices[0];
            glVertexPointer(3, GL_FLOAT, sizeof(Vertex), vertex.position.data());
            glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &vertex.u);
            glColorPointer(3, GL_FLOAT, 0, colours[0].rgb);
            glDrawArrays(primitive.mode, 0, GLsizei(primitive.vertices.size()));
            glDisableClientState(GL_VERTEX_ARRAY);
            glDisableClientState(GL_COLOR_ARRAY);
            glDisableClientState(GL_TEXTURE_COORD_ARRAY);
            continue;
          }
          glBegin(primitive.mode);
          for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
            const Vertex& v = primitive.vertices[i];
            glColor3fv(colours[i].rgb);
            glTexCoord2f(v.u, v.v);
            glVertex3fv(v.position.data());
          }
          glEnd();
        }
      });
    }
  }
  glDisable(GL_LIGHTING);
  glEnable(GL_TEXTURE_2D);
}

}  // namespace

const std::vector<Scene>& colour_scenes() {
  static const std::vector<Scene> scenes = {
      {"flat_last", flat<GL_LAST_VERTEX_CONVENTION>},
      {"flat_first", flat<GL_FIRST_VERTEX_CONVENTION>},
      {"flat_late", flat_late},
      {"flat_secondary", flat_secondary},
      {"smooth", smooth},
      {"secondary", secondary},
      {"unclamped", unclamped},
      {"fog_coordinate", fog_coordinate},
      {"fog_of_depth", fog_of_depth},
      {"bent_secondary", bent_secondary},
      {"bent_fog", bent_fog},
      {"translucent", translucent},
      {"alpha_test", alpha_test},
      {"logic_operation", logic_operation},
      {"kinked", kinked<false>},
      {"kinked_arrays", kinked<true>},
  };
  return scenes;
}

}  // namespace truequad::semantics
