// Quads that are corrected: what is drawn in their place, in which order, and what the program finds afterwards.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../trials.h"
#include "program.h"

namespace truequad::fake {
namespace {

// Unit patches have s = u and t = v, so a mesh's vertex says where it is in its quad.
Value bilinear(const std::vector<Values>& quad, unsigned place, double u, double v) {
  Value result;
  for (int i = 0; i < 4; ++i) {
    result[i] = float((1 - u) * (1 - v) * quad[0][place][i] + u * (1 - v) * quad[1][place][i] +
                      u * v * quad[2][place][i] + (1 - u) * v * quad[3][place][i]);
  }
  return result;
}
void expect_close(const Value& a, const Value& b, const char* what) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 2e-6 * (1 + std::abs(b[i]))) << what << " " << i;
}

// Corners A B C D of what a primitive draws.
std::vector<std::vector<Values>> quads_of(const Primitive& p) {
  std::vector<std::vector<Values>> quads;
  const auto& x = p.vertices;
  if (p.mode == GL_QUADS) {
    for (std::size_t i = 0; i + 4 <= x.size(); i += 4) quads.push_back({x[i], x[i + 1], x[i + 2], x[i + 3]});
  } else if (p.mode == GL_QUAD_STRIP) {
    for (std::size_t i = 0; i + 4 <= x.size(); i += 2) quads.push_back({x[i], x[i + 1], x[i + 3], x[i + 2]});
  } else if (p.mode == GL_POLYGON && x.size() == 4) {
    quads.push_back(x);
  }
  return quads;
}

struct Shape {
  bool triangle;
  std::vector<Values> vertices;
};
std::vector<Shape> shapes_of(const Gl& g) {
  std::vector<Shape> shapes;
  for (const Primitive& p : g.drawn) {
    if (p.mode == GL_TRIANGLES) {
      EXPECT_EQ(p.vertices.size() % 3, 0u);
      for (std::size_t i = 0; i + 3 <= p.vertices.size(); i += 3) {
        shapes.push_back({true, {p.vertices.begin() + long(i), p.vertices.begin() + long(i) + 3}});
      }
    } else {
      for (auto& quad : quads_of(p)) shapes.push_back({false, quad});
    }
  }
  return shapes;
}

double patch_area(const std::vector<Values>& triangle) {
  const auto s = [&](int i) { return double(triangle[i][kTexture][0]); };
  const auto t = [&](int i) { return double(triangle[i][kTexture][1]); };
  return ((s(1) - s(0)) * (t(2) - t(0)) - (s(2) - s(0)) * (t(1) - t(0))) / 2;
}

// Every native quad is there, in order: as it was, or as triangles that tile it and are bilinear in every attribute.
// Textures must be unit patches wherever a quad is warped. Returns how many were triangles.
unsigned expect_same_quads(const Gl& ours, const Gl& native, SlotMask exact = 0) {
  const auto wanted = shapes_of(native), drawn = shapes_of(ours);
  unsigned meshes = 0;
  std::size_t next = 0;
  for (const Shape& quad : wanted) {
    if (next >= drawn.size()) {
      ADD_FAILURE() << "a quad is missing";
      return meshes;
    }
    if (!drawn[next].triangle) {
      EXPECT_EQ(drawn[next].vertices, quad.vertices);
      ++next;
      continue;
    }
    ++meshes;
    double area = 0;
    unsigned corners_seen = 0;
    while (next < drawn.size() && drawn[next].triangle && area < 1 - 1e-5) {
      const auto& triangle = drawn[next++].vertices;
      area += patch_area(triangle);
      EXPECT_GE(patch_area(triangle), 0) << "winding";
      for (const Values& vertex : triangle) {
        const double u = vertex[kTexture][0], v = vertex[kTexture][1];
        for (Slot slot : {kPosition, kColor, kSecondaryColor, kFogCoord, kTexture + 1, kMaterial + 1}) {
          if (exact & bit(slot)) continue;
          expect_close(vertex[slot], bilinear(quad.vertices, slot, u, v), "slot");
        }
        for (unsigned i = 0; i < 4; ++i) {
          if (u == (i == 1 || i == 2) && v == (i >= 2)) {
            EXPECT_EQ(vertex[kPosition], quad.vertices[i][kPosition]);
            corners_seen |= 1u << i;
          }
        }
      }
    }
    EXPECT_NEAR(area, 1, 1e-5) << "the triangles tile the quad";
    EXPECT_EQ(corners_seen, 15u);
  }
  EXPECT_EQ(next, drawn.size()) << "nothing else is drawn";
  return meshes;
}

void expect_same_afterwards(const Gl& ours, const Gl& native) {
  EXPECT_EQ(ours.current, native.current);
  EXPECT_TRUE(ours.all_errors.empty());
  EXPECT_EQ(ours.get_errors, 0u);
  EXPECT_EQ(ours.active_unit, native.active_unit);
  EXPECT_EQ(ours.inside, native.inside);
  EXPECT_EQ(ours.enabled, native.enabled);
  EXPECT_EQ(ours.unit_enabled, native.unit_enabled);
}

void draw_trapezoid(const Driver& gl, GLenum mode) {
  constexpr int kOrder[2][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}};
  gl.Begin(mode);
  for (int i : kOrder[mode == GL_QUAD_STRIP]) kTrapezoid.vertex(gl, i);
  gl.End();
}

TEST(Correction, ATrapezoidBecomesAMeshInEveryMode) {
  for (GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    const Program program = [mode](const Driver& gl) { draw_trapezoid(gl, mode); };
    const Gl native = natively(program), ours = through_doors(program);
    EXPECT_EQ(expect_same_quads(ours, native), 1u);
    expect_same_afterwards(ours, native);
  }
}

// A random program of quads with every interpolated attribute; some quads affine, some not.
void random_program(const Driver& gl, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return float(int(random() % 256)) / 256; };
  const auto attributes = [&] {
    if (random() % 2) gl.Color4f(number(), number(), number(), number());
    if (random() % 4 == 0) gl.SecondaryColor3d(number(), number(), number());
    if (random() % 4 == 0) gl.FogCoordd(number());
    if (random() % 4 == 0) gl.MultiTexCoord2s(GL_TEXTURE1, GLshort(random() % 8), GLshort(random() % 8));
    const GLfloat diffuse[4] = {number(), number(), number(), 1};
    if (random() % 4 == 0) gl.Materialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    if (random() % 8 == 0) gl.EdgeFlag(random() % 2);
  };
  for (unsigned primitive = 0, n = 1 + random() % 4; primitive < n; ++primitive) {
    if (random() % 2) attributes();
    const GLenum mode = GL_QUADS + random() % 3;
    gl.Begin(mode);
    const unsigned quads = random() % 5;
    if (mode == GL_QUADS) {
      for (unsigned i = 0; i < quads; ++i) {
        const bool warped = random() % 2;
        for (int k = 0; k < 4; ++k) {
          attributes();
          (warped ? kTrapezoid : kSquare).vertex(gl, k);
        }
      }
      for (unsigned i = 0, rest = random() % 4; i < rest; ++i) kTrapezoid.vertex(gl, int(i));
    } else if (mode == GL_POLYGON) {
      for (unsigned k = 0, sides = 3 + random() % 3; k < sides; ++k) {
        attributes();
        kTrapezoid.vertex(gl, int(k % 4));
      }
    } else {
      for (unsigned i = 0; i <= quads; ++i) {
        // s alternates, so that each quad has a unit patch (mirrored every second time).
        const float width = random() % 2 ? 0.9f : 0.3f;
        for (float side : {-1.f, 1.f}) {
          attributes();
          gl.TexCoord2f(float(i % 2), side > 0 ? 1.f : 0.f);
          gl.Vertex2f(-0.9f + 0.4f * float(i), side * width);
        }
      }
      if (random() % 3 == 0) gl.Vertex2f(0.8f, -0.2f);
    }
    if (random() % 2) attributes();
    gl.End();
  }
}

// Polygons of five sides are drawn as they are; quads_of() does not list them, so they are compared here.
std::vector<Primitive> other_polygons(const Gl& g) {
  std::vector<Primitive> found;
  for (const Primitive& p : g.drawn) {
    if (p.mode == GL_POLYGON && p.vertices.size() != 4) found.push_back(p);
  }
  return found;
}

// As expect_same_quads for strips whose s runs backwards in every second quad: only counts and order are compared.
TEST(Correction, RandomProgramsLeaveEveryCurrentValueAndNoError) {
  std::uint64_t all = 0;
  for (unsigned seed = 0; seed < test::trials(3000, 16); ++seed) {
    SCOPED_TRACE(seed);
    const Program program = [seed](const Driver& gl) { random_program(gl, seed); };
    const Gl native = natively(program);
    Gl ours;
    all += growth(corrected, [&] { ours = through_doors(program); });
    expect_same_afterwards(ours, native);
    const auto a = other_polygons(ours), b = other_polygons(native);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].vertices, b[i].vertices);
    if (HasFailure()) return;
  }
  EXPECT_GT(all, test::trials(3000, 16));
}

TEST(Correction, RandomQuadsKeepTheirOrderAndAreBilinearInEveryAttribute) {
  unsigned meshes = 0;
  for (unsigned seed = 0; seed < test::trials(1500, 16); ++seed) {
    SCOPED_TRACE(seed);
    const Program program = [seed](const Driver& gl) {
      std::mt19937 random(seed);
      const auto number = [&] { return float(random() % 256) / 256; };
      gl.Color4f(number(), number(), number(), number());
      gl.FogCoordf(number());
      gl.Begin(GL_QUADS);
      for (unsigned i = 0, n = 1 + random() % 6; i < n; ++i) {
        const UnitPatch& patch = random() % 2 ? kTrapezoid : kSquare;
        for (int k = 0; k < 4; ++k) {
          if (random() % 2) gl.Color4ub(GLubyte(random()), GLubyte(random()), GLubyte(random()), 255);
          if (random() % 4 == 0) gl.SecondaryColor3f(number(), number(), number());
          if (random() % 4 == 0) gl.FogCoordf(number());
          if (random() % 4 == 0) gl.MultiTexCoord2f(GL_TEXTURE1, number(), number());
          const GLfloat diffuse[4] = {number(), number(), number(), 1};
          if (random() % 4 == 0) gl.Materialfv(GL_FRONT, GL_DIFFUSE, diffuse);
          patch.vertex(gl, k);
        }
      }
      gl.End();
    };
    const Gl native = natively(program), ours = through_doors(program);
    meshes += expect_same_quads(ours, native);
    expect_same_afterwards(ours, native);
    if (HasFailure()) return;
  }
  EXPECT_GT(meshes, test::trials(1000, 16));
}

TEST(Correction, AnAttributeThatIsSetLateHasTheDriversValueBefore) {
  struct Late {
    const char* name;
    std::function<void(const Driver&, float)> set;
  };
  const Late calls[] = {
      {"colour", [](const Driver& gl, float x) { gl.Color4f(x, x, 0, 1); }},
      {"secondary", [](const Driver& gl, float x) { gl.SecondaryColor3f(x, x, 0); }},
      {"fog", [](const Driver& gl, float x) { gl.FogCoordf(x); }},
      {"unit 1", [](const Driver& gl, float x) { gl.MultiTexCoord2f(GL_TEXTURE1, x, x); }},
      {"material",
       [](const Driver& gl, float x) {
         const GLfloat v[4] = {x, x, x, 1};
         gl.Materialfv(GL_FRONT, GL_DIFFUSE, v);
       }},
  };
  for (GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    for (const Late& late : calls) {
      for (int at = 0; at < 4; ++at) {
        SCOPED_TRACE(std::string(late.name) + " before vertex " + std::to_string(at));
        const Program program = [&](const Driver& gl) {
          constexpr int kOrder[2][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}};
          late.set(gl, 0.25f);
          gl.Begin(mode);
          for (int i = 0; i < 4; ++i) {
            if (i == at) late.set(gl, 0.75f);
            kTrapezoid.vertex(gl, kOrder[mode == GL_QUAD_STRIP][i]);
          }
          gl.End();
        };
        const Gl native = natively(program), ours = through_doors(program);
        EXPECT_EQ(expect_same_quads(ours, native), 1u);
        expect_same_afterwards(ours, native);
      }
    }
  }
}

TEST(Correction, ATextureCoordinateThatIsSetLateIsTakenFromTheDriver) {
  const Program program = [](const Driver& gl) {
    gl.TexCoord2f(0, 0);
    gl.Begin(GL_QUADS);
    gl.Vertex2f(kTrapezoid.corner[0].x, kTrapezoid.corner[0].y);
    for (int i = 1; i < 4; ++i) kTrapezoid.vertex(gl, i);
    gl.End();
  };
  const Gl native = natively(program), ours = through_doors(program);
  EXPECT_EQ(expect_same_quads(ours, native), 1u);
  expect_same_afterwards(ours, native);
}

TEST(Correction, UnitOneIsReadAndTheActiveUnitStays) {
  Gl start;
  start.active_unit = 3;
  start.unit_enabled = {{1, {GL_TEXTURE_2D}}};
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      gl.MultiTexCoord2f(GL_TEXTURE1, float(i == 1 || i == 2), float(i >= 2));
      gl.Vertex2f(kTrapezoid.corner[i].x, kTrapezoid.corner[i].y);
    }
    gl.End();
  };
  const Gl native = natively(program, start);
  Gl ours;
  EXPECT_EQ(growth(corrected, [&] { ours = through_doors(program, start); }), 1u);
  expect_same_afterwards(ours, native);
  EXPECT_EQ(ours.active_unit, 3u);
}

// Flat shading: the colours of a quad are those of one corner, whatever triangles it is made of.
TEST(Correction, FlatShadingTakesTheProvokingCorner) {
  struct Case {
    GLenum mode;
    bool first_convention, quads_follow;
    int provoking;  // of the vertices in the program's order
  };
  for (const Case& k : {Case{GL_QUADS, false, true, 3}, Case{GL_QUAD_STRIP, false, true, 3},
                        Case{GL_POLYGON, false, true, 0}, Case{GL_QUADS, true, true, 0},
                        Case{GL_QUAD_STRIP, true, true, 0}, Case{GL_POLYGON, true, true, 0},
                        Case{GL_QUADS, true, false, 3}, Case{GL_QUAD_STRIP, true, false, 3}}) {
    Gl start;
    start.extensions = {"GL_ARB_provoking_vertex"};
    start.numbers[GL_SHADE_MODEL] = {GL_FLAT};
    start.numbers[GL_PROVOKING_VERTEX] = {
        double(k.first_convention ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION)};
    start.numbers[GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION] = {double(k.quads_follow)};
    const Program program = [&](const Driver& gl) {
      constexpr int kOrder[2][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}};
      gl.Begin(k.mode);
      for (int i = 0; i < 4; ++i) {
        gl.Color3f(float(i + 1) / 4, 0, 0);
        kTrapezoid.vertex(gl, kOrder[k.mode == GL_QUAD_STRIP][i]);
      }
      gl.End();
    };
    const Gl native = natively(program, start), ours = through_doors(program, start);
    EXPECT_EQ(expect_same_quads(ours, native, bit(kColor)), 1u);
    for (const Shape& triangle : shapes_of(ours)) {
      for (const Values& vertex : triangle.vertices) {
        ASSERT_EQ(vertex[kColor][0], float(k.provoking + 1) / 4) << k.mode << k.first_convention;
      }
    }
    expect_same_afterwards(ours, native);
  }
}

TEST(Correction, NormalsKeepTheInterpolatedLength) {
  Gl start;
  start.enabled.insert(GL_LIGHTING);
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      const float length = float(i + 1);
      gl.Normal3f(i % 2 ? length : 0, 0, i % 2 ? 0 : length);
      kTrapezoid.vertex(gl, i);
    }
    gl.End();
  };
  const Gl native = natively(program, start), ours = through_doors(program, start);
  for (const Shape& triangle : shapes_of(ours)) {
    for (const Values& vertex : triangle.vertices) {
      const double u = vertex[kTexture][0], v = vertex[kTexture][1];
      const double expected = (1 - u) * (1 - v) + 2 * u * (1 - v) + 3 * u * v + 4 * (1 - u) * v;
      const Value& n = vertex[kNormal];
      ASSERT_NEAR(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), expected, 1e-5);
    }
  }
  EXPECT_EQ(expect_same_quads(ours, native, bit(kColor)), 1u);
}

TEST(Correction, UnlitColoursAreClampedBeforeTheyAreInterpolated) {
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      gl.Color3f(i < 2 ? 3 : -1, 0.5f, 0.5f);
      kTrapezoid.vertex(gl, i);
    }
    gl.End();
  };
  // … unless that was switched off (ARB_color_buffer_float).
  for (const bool clamped : {true, false}) {
    Gl start;
    start.extensions = {"GL_ARB_color_buffer_float"};
    if (!clamped) start.numbers[GL_CLAMP_VERTEX_COLOR] = {GL_FALSE};
    unsigned inner = 0;
    for (const Shape& triangle : shapes_of(through_doors(program, start))) {
      for (const Values& vertex : triangle.vertices) {
        const double v = vertex[kTexture][1];
        if (v == 0 || v == 1) continue;
        ++inner;
        ASSERT_NEAR(vertex[kColor][0], clamped ? 1 - v : 3 - 4 * v, 1e-5);
      }
    }
    EXPECT_GT(inner, 0u);
  }
}

TEST(Correction, ProjectiveQuadsStayQuads) {
  const Settings before = chosen_settings(entry);
  Settings projective = before;
  projective.mode = Mode::kProjective;
  ASSERT_TRUE(choose_settings(entry, projective));
  for (GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    const Program program = [mode](const Driver& gl) { draw_trapezoid(gl, mode); };
    const Gl native = natively(program), ours = through_doors(program);
    const auto a = shapes_of(ours), b = shapes_of(native);
    ASSERT_EQ(a.size(), 1u);
    ASSERT_FALSE(a[0].triangle);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(a[0].vertices[i][kPosition], b[0].vertices[i][kPosition]);
      const Value &x = a[0].vertices[i][kTexture], &y = b[0].vertices[i][kTexture];
      EXPECT_GT(x[3], 0);
      EXPECT_NEAR(x[0] / x[3], y[0], 1e-6);
      EXPECT_NEAR(x[1] / x[3], y[1], 1e-6);
    }
    // The far edge is a third as long as the near one, so it is three times as far (Heckbert 1989): q is 1/distance.
    EXPECT_NEAR(a[0].vertices[3][kTexture][3] / a[0].vertices[0][kTexture][3], 1 / 3.0, 1e-6);
    expect_same_afterwards(ours, native);
  }
  choose_settings(entry, before);
}

TEST(Correction, TheOverlayLeavesEverythingAsItWas) {
  draw_trapezoid(doors(), GL_QUADS);
  static Options overlay = *entry.own->options;
  overlay.overlay = true;
  const Options* const before = entry.own->options;
  entry.own->options = &overlay;
  const Program program = [](const Driver& gl) {
    gl.Color3f(0.5f, 0.25f, 0);
    draw_trapezoid(gl, GL_QUADS);
    draw_trapezoid(gl, GL_QUAD_STRIP);
  };
  Gl start;
  const Gl native = natively(program, start), ours = through_doors(program, start);
  expect_same_afterwards(ours, native);
  EXPECT_TRUE(ours.attribute_stack.empty());
  // The cut primitive, and for each quad its mesh and the mesh's edges.
  ASSERT_EQ(ours.drawn.size(), 5u);
  for (int i : {1, 3}) {
    ASSERT_EQ(ours.drawn[i].vertices.size(), ours.drawn[i + 1].vertices.size());
    for (std::size_t k = 0; k < ours.drawn[i].vertices.size(); ++k) {
      ASSERT_EQ(ours.drawn[i].vertices[k][kPosition], ours.drawn[i + 1].vertices[k][kPosition]);
    }
  }

  start.attribute_stack.resize(16);
  const Gl full = through_doors(program, start);
  expect_same_afterwards(full, native);
  entry.own->options = before;
}

TEST(Correction, NeighboursShareOneBegin) {
  const Program program = [](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 10; ++i) kTrapezoid.draw(gl);
    gl.End();
  };
  const Gl ours = through_doors(program);
  EXPECT_EQ(ours.drawn.size(), 2u);  // the cut one, without vertices that GL would draw, and the meshes
  EXPECT_EQ(ours.drawn[0].vertices.size(), 3u);
  EXPECT_EQ(ours.drawn[1].mode, GLenum(GL_TRIANGLES));
  EXPECT_EQ(expect_same_quads(ours, natively(program)), 10u);
}

}  // namespace
}  // namespace truequad::fake
