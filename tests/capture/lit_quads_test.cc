// Corrected quads under GL_LIGHTING: they are drawn without it, in the colours that their corners have with it, and the program
// finds everything as it left it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "capture/lighting.h"
#include "program.h"

namespace truequad::fake {
namespace {

// A lamp close to the surface.
Gl lit() {
  Gl start;
  start.enabled = {GL_LIGHTING, GL_LIGHT0};
  start.lights[GL_LIGHT0][GL_POSITION] = {0.25f, 0.5f, 0.75f, 1};
  start.lights[GL_LIGHT0][GL_LINEAR_ATTENUATION] = {0.5f};
  for (unsigned face = 0; face < 2; ++face) {
    const unsigned first = kMaterial + face * kMaterialProperties;
    start.current[first] = {0.2f, 0.2f, 0.2f, 1};
    start.current[first + 1] = face ? Value{0.1f, 0.3f, 0.7f, 0.5f} : Value{0.8f, 0.6f, 0.4f, 0.75f};
    start.current[first + 2] = {0.4f, 0.4f, 0.4f, 1};
    start.current[first + 4] = {8, 0, 0, 1};
  }
  return start;
}

glm::vec4 vector(const std::vector<float>& x) { return {x[0], x[1], x[2], x[3]}; }
glm::vec4 vector(const Value& x) { return {x[0], x[1], x[2], x[3]}; }

// What light 0 makes of a vertex that the program gave; the modelview matrix is the identity.
LitColours expected(const Gl& g, const Values& vertex, unsigned face = 0) {
  const LightModel model{{0.2f, 0.2f, 0.2f, 1},
                         g.numbers.at(GL_LIGHT_MODEL_LOCAL_VIEWER)[0] != 0,
                         g.numbers.at(GL_LIGHT_MODEL_COLOR_CONTROL)[0] == GL_SEPARATE_SPECULAR_COLOR};
  const auto& from = g.lights.at(GL_LIGHT0);
  const Light light{vector(from.at(GL_AMBIENT)),         vector(from.at(GL_DIFFUSE)),
                    vector(from.at(GL_SPECULAR)),        vector(from.at(GL_POSITION)),
                    {0, 0, -1},                          0,
                    180,                                 from.at(GL_CONSTANT_ATTENUATION)[0],
                    from.at(GL_LINEAR_ATTENUATION)[0],   from.at(GL_QUADRATIC_ATTENUATION)[0]};
  const unsigned first = kMaterial + face * kMaterialProperties;
  Material material{vector(vertex[first]), vector(vertex[first + 1]), vector(vertex[first + 2]),
                    {0, 0, 0, 1},          vertex[first + 4][0]};
  const Value &p = vertex[kPosition], &n = vertex[kNormal];
  const glm::dvec3 normal(n[0], n[1], n[2]);
  return light_vertex(model, {&light, 1}, material, {p[0], p[1], p[2]}, face ? -normal : normal);
}

std::vector<const fake::Primitive*> meshes(const Gl& g) {
  std::vector<const fake::Primitive*> found;
  for (const fake::Primitive& p : g.drawn) {
    if (p.mode == GL_TRIANGLES && !p.vertices.empty()) found.push_back(&p);
  }
  return found;
}

double clamped(double x) { return x > 0 ? std::min(x, 1.0) : 0; }

// Every vertex has the bilinear mean of these corners' colours, clamped first.
void expect_bilinear(const fake::Primitive& mesh, const std::function<glm::dvec4(int)>& corner, unsigned place) {
  for (const Values& vertex : mesh.vertices) {
    const double u = vertex[kTexture][0], v = vertex[kTexture][1];
    const double weight[] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    for (int k = 0; k < (place == kColor ? 4 : 3); ++k) {
      double sum = 0;
      for (int i = 0; i < 4; ++i) sum += weight[i] * clamped(corner(i)[k]);
      ASSERT_NEAR(vertex[place][k], sum, 1e-6) << u << " " << v << " " << k;
    }
  }
}

void expect_as_before(const Gl& ours, const Gl& native) {
  EXPECT_EQ(ours.current, native.current);
  EXPECT_EQ(ours.enabled, native.enabled);
  EXPECT_EQ(ours.unit_enabled, native.unit_enabled);
  EXPECT_EQ(ours.active_unit, native.active_unit);
  EXPECT_TRUE(ours.all_errors.empty());
  EXPECT_EQ(ours.get_errors, 0u);
  EXPECT_TRUE(ours.attribute_stack.empty());
}

// One corrected quad; `attributes` before each vertex.
Program one_quad(std::function<void(const Driver&, int)> attributes) {
  return [=](const Driver& gl) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      attributes(gl, i);
      kTrapezoid.vertex(gl, i);
    }
    gl.End();
  };
}
void nothing(const Driver&, int) {}

struct Drawn {
  Gl native, ours;
  const std::vector<Values>& corners() const { return native.drawn.at(0).vertices; }
};
Drawn draw(const Program& program, const Gl& start) { return {natively(program, start), through_doors(program, start)}; }

void expect_lit_by_corners(const Program& program, const Gl& start) {
  const Drawn d = draw(program, start);
  const auto drawn = meshes(d.ours);
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_FALSE(drawn[0]->enabled.contains(GL_LIGHTING));
  EXPECT_FALSE(drawn[0]->enabled.contains(GL_COLOR_MATERIAL));
  EXPECT_FALSE(drawn[0]->enabled.contains(GL_COLOR_SUM));
  expect_bilinear(*drawn[0], [&](int i) { return expected(start, d.corners()[i]).primary; }, kColor);
  expect_as_before(d.ours, d.native);
}

TEST(LitQuads, AreInterpolatedBetweenTheirCorners) {
  expect_lit_by_corners(one_quad(nothing), lit());
  Gl local = lit();
  local.numbers[GL_LIGHT_MODEL_LOCAL_VIEWER] = {GL_TRUE};
  local.enabled.insert(GL_COLOR_SUM);
  expect_lit_by_corners(one_quad(nothing), local);
  expect_lit_by_corners(one_quad([](const Driver& gl, int i) { gl.Normal3f(0.5f * float(i) - 1, 0.3f, 0.7f); }), lit());
  Gl bright = lit();
  bright.lights[GL_LIGHT0][GL_DIFFUSE] = {9, 9, 9, 1};
  expect_lit_by_corners(one_quad(nothing), bright);
}

TEST(LitQuads, HaveTheMaterialsOfTheirCorners) {
  const auto material = [](const Driver& gl, int i) {
    const GLfloat diffuse[] = {0.25f * float(i), 0.5f, 1 - 0.25f * float(i), 0.2f * float(i)};
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, float(1 + 9 * i));
  };
  expect_lit_by_corners(one_quad(material), lit());
  const auto late = [=](const Driver& gl, int i) {
    if (i >= 2) material(gl, i);
  };
  expect_lit_by_corners(one_quad(late), lit());
}

// The current colour is a material as long as GL_COLOR_MATERIAL is enabled, and ours must not become one.
TEST(LitQuads, TrackTheProgramsColour) {
  for (const GLenum property : {GL_DIFFUSE, GL_AMBIENT, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR}) {
    for (const int from : {0, 2, 4}) {
      SCOPED_TRACE(property * 10 + unsigned(from));
      Gl start = lit();
      start.numbers[GL_COLOR_MATERIAL_PARAMETER] = {double(property)};
      const Program program = [=](const Driver& gl) {
        gl.Color4f(0.1f, 0.2f, 0.3f, 0.4f);
        gl.Enable(GL_COLOR_MATERIAL);
        one_quad([=](const Driver& g, int i) {
          const GLfloat ignored[] = {1, 1, 1, 1};
          if (i >= from) g.Color3f(0.2f * float(i), 0.5f, 0.9f);
          if (i >= from) g.Materialfv(GL_FRONT, property, ignored);
        })(gl);
      };
      expect_lit_by_corners(program, start);
    }
  }
}

TEST(LitQuads, LeaveColoursThatTheProgramDidNotSet) {
  for (const bool color_material : {false, true}) {
    Gl start = lit();
    if (color_material) start.enabled.insert(GL_COLOR_MATERIAL);
    start.set(kColor, {0.3f, 0.6f, 0.9f, 0.5f});
    start.set(kSecondaryColor, {0.1f, 0.2f, 0.3f, 1});
    // The second quad sets a colour midway, when ours was the driver's current one.
    const Program program = [](const Driver& gl) {
      gl.Begin(GL_QUADS);
      kTrapezoid.draw(gl);
      for (int i = 0; i < 4; ++i) {
        if (i == 2) gl.Color3f(1, 0, 1);
        kTrapezoid.vertex(gl, i);
      }
      kSquare.draw(gl);
      gl.End();
    };
    const Drawn d = draw(program, start);
    expect_as_before(d.ours, d.native);
    ASSERT_EQ(meshes(d.ours).size(), 2u);
    const auto& corners = d.corners();
    expect_bilinear(*meshes(d.ours)[1], [&](int i) { return expected(start, corners[4 + i]).primary; }, kColor);
    const fake::Primitive& last = d.ours.drawn.back();
    EXPECT_TRUE(last.enabled.contains(GL_LIGHTING));
    ASSERT_EQ(last.vertices.size(), 4u);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(last.vertices[i], corners[8 + i]);
  }
}

TEST(LitQuads, HaveTheirHighlightsInTheSecondaryColour) {
  for (const bool summed : {false, true}) {
    Gl start = lit();
    start.numbers[GL_LIGHT_MODEL_COLOR_CONTROL] = {GL_SEPARATE_SPECULAR_COLOR};
    if (summed) start.enabled.insert(GL_COLOR_SUM);
    start.current[kSecondaryColor] = {0.1f, 0.2f, 0.3f, 1};
    const Drawn d = draw(one_quad(nothing), start);
    ASSERT_EQ(meshes(d.ours).size(), 1u);
    const fake::Primitive& mesh = *meshes(d.ours)[0];
    EXPECT_TRUE(mesh.enabled.contains(GL_COLOR_SUM));
    expect_bilinear(mesh, [&](int i) { return expected(start, d.corners()[i]).primary; }, kColor);
    expect_bilinear(mesh, [&](int i) { return expected(start, d.corners()[i]).secondary; }, kSecondaryColor);
    expect_as_before(d.ours, d.native);
  }
}

TEST(LitQuads, WithoutClampingKeepColoursOutOfRange) {
  Gl start = lit();
  start.extensions = {"GL_ARB_color_buffer_float"};
  start.lights[GL_LIGHT0][GL_DIFFUSE] = {9, 9, 9, 1};
  for (const GLenum clamp : {GLenum(GL_FALSE), GLenum(GL_FIXED_ONLY), GLenum(GL_TRUE)}) {
    start.numbers[GL_CLAMP_VERTEX_COLOR] = {double(clamp)};
    for (const bool float_buffer : {false, true}) {
      start.numbers[GL_RGBA_FLOAT_MODE_ARB] = {double(float_buffer)};
      float brightest = 0;
      const auto drawn = draw(one_quad(nothing), start);
      for (const Values& vertex : meshes(drawn.ours).at(0)->vertices) {
        brightest = std::max(brightest, vertex[kColor][0]);
      }
      EXPECT_EQ(brightest > 1, clamp == GL_FALSE || (clamp == GL_FIXED_ONLY && float_buffer));
    }
  }
}

TEST(LitQuads, WhenFlatHaveTheColourOfTheProvokingCorner) {
  Gl start = lit();
  start.numbers[GL_SHADE_MODEL] = {GL_FLAT};
  for (const GLenum mode : {GL_QUADS, GL_POLYGON}) {
    const Program program = [mode](const Driver& gl) {
      gl.Begin(mode);
      for (int i = 0; i < 4; ++i) {
        gl.Normal3f(0.25f * float(i), 0, 1);
        kTrapezoid.vertex(gl, i);
      }
      gl.End();
    };
    const Drawn d = draw(program, start);
    const auto drawn = meshes(d.ours);
    ASSERT_EQ(drawn.size(), 1u);
    const Values& provoking = d.corners()[mode == GL_POLYGON ? 0 : 3];
    expect_bilinear(*drawn[0], [&](int) { return expected(start, provoking).primary; }, kColor);
    // Normals are still for whoever generates texture coordinates from them.
    for (const Values& vertex : drawn[0]->vertices) {
      const double u = vertex[kTexture][0], v = vertex[kTexture][1];
      ASSERT_NEAR(vertex[kNormal][0] / vertex[kNormal][2], 0.25 * (u * (1 - v) + 2 * u * v + 3 * (1 - u) * v), 1e-5);
    }
  }
}

TEST(LitQuads, AreLitOnTheSideThatIsSeen) {
  for (const bool turned : {false, true}) {
    for (const GLenum front : {GL_CCW, GL_CW}) {
      Gl start = lit();
      start.numbers[GL_LIGHT_MODEL_TWO_SIDE] = {GL_TRUE};
      start.numbers[GL_FRONT_FACE] = {double(front)};
      if (turned) start.numbers[GL_PROJECTION_MATRIX][0] = -1;
      const unsigned face = turned == (front == GL_CCW);
      const Drawn d = draw(one_quad([=](const Driver& gl, int) { gl.Normal3f(0, 0, face ? -1.f : 1.f); }), start);
      ASSERT_EQ(meshes(d.ours).size(), 1u);
      expect_bilinear(*meshes(d.ours)[0], [&](int i) { return expected(start, d.corners()[i], face).primary; }, kColor);
      expect_as_before(d.ours, d.native);
    }
  }
}

// A crossed quad shows its front in one half and its back in the other.
TEST(LitQuads, ThatShowBothSidesAreLitOnBoth) {
  Gl start = lit();
  start.numbers[GL_LIGHT_MODEL_TWO_SIDE] = {GL_TRUE};
  const UnitPatch crossed{{{-0.9f, -0.9f}, {0.9f, 0.8f}, {0.9f, -0.9f}, {-0.8f, 0.9f}}};
  const Drawn d = draw(
      [&](const Driver& gl) {
        gl.Begin(GL_QUADS);
        crossed.draw(gl);
        gl.End();
      },
      start);
  ASSERT_EQ(meshes(d.ours).size(), 1u);
  const auto& vertices = meshes(d.ours)[0]->vertices;
  unsigned seen[2] = {};
  for (std::size_t t = 0; t + 3 <= vertices.size(); t += 3) {
    const auto at = [&](int i, int k) { return double(vertices[t + std::size_t(i)][kPosition][std::size_t(k)]); };
    const double area = (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) - (at(1, 1) - at(0, 1)) * (at(2, 0) - at(0, 0));
    if (std::abs(area) < 1e-6) continue;
    const unsigned face = area < 0;
    ++seen[face];
    const fake::Primitive triangle{GL_TRIANGLES, {vertices.begin() + long(t), vertices.begin() + long(t) + 3}, {}};
    expect_bilinear(triangle, [&](int i) { return expected(start, d.corners()[i], face).primary; }, kColor);
  }
  EXPECT_GT(seen[0], 0u);
  EXPECT_GT(seen[1], 0u);
  expect_as_before(d.ours, d.native);
}

bool changes_state(const Gl& g) {
  return std::any_of(g.log.begin(), g.log.end(),
                     [](const Call& x) { return x.command == kCommandEnable || x.command == kCommandDisable; });
}

TEST(LitQuads, OfOneColourAreLeftToTheDriver) {
  Gl start = lit();
  start.lights[GL_LIGHT0][GL_POSITION] = {0.25f, 0.5f, 0.75f, 0};
  const auto normal = [](const Driver& gl, int) { gl.Normal3f(0, 0, 1); };
  for (const auto& attributes : {std::function<void(const Driver&, int)>(nothing), {normal}}) {
    const Drawn d = draw(one_quad(attributes), start);
    ASSERT_EQ(meshes(d.ours).size(), 1u);
    EXPECT_TRUE(meshes(d.ours)[0]->enabled.contains(GL_LIGHTING));
    EXPECT_FALSE(changes_state(d.ours));
    expect_as_before(d.ours, d.native);
  }
}

TEST(LitQuads, ThatAreLitInAWayWeDoNotKnowAreLeftToTheDriver) {
  const std::function<void(Gl&)> changes[] = {
      [](Gl& g) { g.numbers[GL_RGBA_MODE] = {GL_FALSE}; },
      [](Gl& g) { g.numbers[GL_MODELVIEW_MATRIX][11] = -0.125; },
      [](Gl& g) { g.numbers[GL_MODELVIEW_MATRIX][10] = 0; },
      // A material that does not have the current colour, though it should.
      [](Gl& g) { g.enabled.insert(GL_COLOR_MATERIAL); },
  };
  for (const auto& change : changes) {
    Gl start = lit();
    change(start);
    const Drawn d = draw(one_quad(nothing), start);
    ASSERT_EQ(meshes(d.ours).size(), 1u);
    EXPECT_TRUE(meshes(d.ours)[0]->enabled.contains(GL_LIGHTING));
    EXPECT_FALSE(changes_state(d.ours));
    expect_as_before(d.ours, d.native);
  }
}

TEST(LitQuads, ThatFragmentsLightPass) {
  Gl fragments = lit();
  fragments.extensions = {"GL_SGIX_fragment_lighting"};
  fragments.enabled.insert(GL_FRAGMENT_LIGHTING_SGIX);
  Gl no_color_sum = lit();
  no_color_sum.version = "1.2 fake";
  no_color_sum.numbers[GL_LIGHT_MODEL_COLOR_CONTROL] = {GL_SEPARATE_SPECULAR_COLOR};
  for (const Gl& start : {fragments, no_color_sum}) {
    Gl ours;
    EXPECT_EQ(growth([] { return passed(Reason::kLighting); }, [&] { ours = through_doors(one_quad(nothing), start); }), 1u);
    EXPECT_TRUE(meshes(ours).empty());
    EXPECT_TRUE(ours.all_errors.empty());
  }
}

TEST(LitQuads, AskAnOldDriverOnlyWhatItKnows) {
  for (const char* version : {"1.0", "1.1", "1.2", "1.3", "1.4", "2.1", "3.0"}) {
    Gl start = lit();
    start.version = version;
    start.enabled.insert(GL_NORMALIZE);
    const Drawn d = draw(one_quad(nothing), start);
    EXPECT_EQ(meshes(d.ours).size(), 1u);
    expect_as_before(d.ours, d.native);
  }
}

// State is read once for a Begin, and switched once for each run of corrected quads.
TEST(LitQuads, AreCheapInRuns) {
  const auto program = [](int quads, int runs) {
    return [=](const Driver& gl) {
      gl.Begin(GL_QUADS);
      for (int run = 0; run < runs; ++run) {
        for (int i = 0; i < quads; ++i) kTrapezoid.draw(gl);
        if (run + 1 < runs) kSquare.draw(gl);
      }
      gl.End();
    };
  };
  const auto count = [](const Gl& g, unsigned command) {
    return std::count_if(g.log.begin(), g.log.end(), [&](const Call& x) { return x.command == command; });
  };
  for (const int runs : {1, 3}) {
    const Gl one = through_doors(program(1, runs), lit()), many = through_doors(program(50, runs), lit());
    EXPECT_EQ(one.gets, many.gets);
    EXPECT_EQ(count(one, kCommandDisable), runs);
    EXPECT_EQ(count(many, kCommandDisable), runs);
    EXPECT_EQ(count(many, kCommandEnable), runs);
  }
  const std::size_t unlit = through_doors(program(1, 1)).gets;
  EXPECT_LE(through_doors(program(1, 1), lit()).gets, unlit + 45);
  // Lit, but of one colour.
  Gl sun = lit();
  sun.lights[GL_LIGHT0][GL_POSITION] = {0, 0, 1, 0};
  EXPECT_LE(through_doors(program(1, 1), sun).gets, unlit + 11);
}

TEST(LitQuads, ThatAreAffineCostNoQueries) {
  const Gl ours = through_doors(
      [](const Driver& gl) {
        gl.Begin(GL_QUADS);
        for (int i = 0; i < 10; ++i) kSquare.draw(gl);
        gl.End();
      },
      lit());
  EXPECT_EQ(ours.gets, 0u);
  EXPECT_FALSE(changes_state(ours));
}

}  // namespace
}  // namespace truequad::fake
