// The lighting equation against one written from the specification in the plainest way, in long double.
#include "capture/lighting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <random>
#include <vector>

namespace truequad {
namespace {

using Real = long double;

struct R3 {
  Real x, y, z;
};
R3 operator+(R3 a, R3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
R3 operator-(R3 a, R3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
R3 operator*(Real k, R3 a) { return {k * a.x, k * a.y, k * a.z}; }
Real dot(R3 a, R3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Real norm(R3 a) { return std::sqrt(dot(a, a)); }
R3 unit(R3 a) { return norm(a) > 0 ? (1 / norm(a)) * a : a; }
Real positive(Real x) { return x > 0 ? x : 0; }

// Equations 2.2 to 2.5 of GL 2.1 section 2.14.1, one colour component at a time.
void reference(const LightModel& model, const std::vector<Light>& lights, const Material& material, R3 v, R3 n,
               Real (&primary)[4], Real (&secondary)[3]) {
  primary[3] = material.diffuse[3];
  for (int k = 0; k < 3; ++k) {
    Real pri = Real(material.emission[k]) + Real(material.ambient[k]) * model.ambient[k], sec = 0;
    for (const Light& light : lights) {
      const Real w = light.position[3];
      const R3 p{light.position[0], light.position[1], light.position[2]};
      const R3 vp = w != 0 ? unit((1 / w) * p - v) : unit(p);
      Real att = 1;
      if (w != 0) {
        const Real d = norm((1 / w) * p - v);
        att = 1 / (light.constant_attenuation + light.linear_attenuation * d + light.quadratic_attenuation * d * d);
      }
      Real spot = 1;
      if (light.spot_cutoff != 180) {
        const R3 s = unit({light.spot_direction[0], light.spot_direction[1], light.spot_direction[2]});
        const Real cosine = positive(dot(Real(-1) * vp, s));
        const Real limit = std::cos(light.spot_cutoff * 3.14159265358979323846264338327950288L / 180);
        spot = cosine >= limit ? std::pow(cosine, Real(light.spot_exponent)) : 0;
      }
      const R3 h = vp + (model.local_viewer ? unit(Real(-1) * v) : R3{0, 0, 1});
      const Real f = dot(n, vp) > 0 ? 1 : 0;
      const Real specular = att * spot * f * std::pow(positive(dot(n, unit(h))), Real(material.shininess)) *
                            material.specular[k] * light.specular[k];
      pri += att * spot * (Real(material.ambient[k]) * light.ambient[k] +
                           positive(dot(n, vp)) * material.diffuse[k] * light.diffuse[k]);
      (model.separate_specular ? sec : pri) += specular;
    }
    primary[k] = pri;
    secondary[k] = sec;
  }
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  bool one_of(unsigned n) { return engine_() % n == 0; }
  float between(float low, float high) { return low + (high - low) * float(engine_() % 65536) / 65535; }
  glm::vec4 colour() { return {between(-0.5f, 2), between(0, 1), between(0, 1), between(0, 1)}; }
  glm::vec3 direction() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

 private:
  std::mt19937 engine_;
};

Light random_light(Random& random) {
  Light light;
  light.ambient = random.colour();
  light.diffuse = random.colour();
  light.specular = random.colour();
  light.position = glm::vec4(3.f * random.direction(), random.one_of(3) ? 0 : random.one_of(3) ? 2 : 1);
  light.spot_direction = random.direction();
  light.spot_exponent = random.one_of(2) ? 0 : random.between(0, 20);
  light.spot_cutoff = random.one_of(2) ? 180 : random.between(0, 90);
  light.constant_attenuation = random.between(0.2f, 2);
  light.linear_attenuation = random.one_of(2) ? 0 : random.between(0, 1);
  light.quadratic_attenuation = random.one_of(2) ? 0 : random.between(0, 1);
  return light;
}

TEST(Lighting, IsTheSpecificationsEquation) {
  long lit = 0;
  for (unsigned seed = 0; seed < 20000; ++seed) {
    Random random(seed);
    const LightModel model{random.colour(), random.one_of(2), random.one_of(2)};
    std::vector<Light> lights(seed % 5);
    for (Light& light : lights) light = random_light(random);
    const Material material{random.colour(), random.colour(), random.colour(), random.colour(),
                            random.one_of(4) ? 0 : random.between(0, 128)};
    const glm::dvec3 position = 2.f * random.direction(), normal = random.direction();
    const LitColours colours = light_vertex(model, lights, material, position, normal);
    Real primary[4], secondary[3];
    reference(model, lights, material, {position.x, position.y, position.z}, {normal.x, normal.y, normal.z}, primary,
              secondary);
    for (int k = 0; k < 4; ++k) {
      ASSERT_NEAR(colours.primary[k], double(primary[k]), 1e-12 * (1 + std::abs(double(primary[k])))) << seed;
    }
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(colours.secondary[k], double(secondary[k]), 1e-12 * (1 + std::abs(double(secondary[k])))) << seed;
    }
    lit += secondary[0] != 0;
  }
  EXPECT_GT(lit, 1000);
}

TEST(Lighting, ALampAtTheVertexAndASpotAlongItsAxisAreDefined) {
  Light light{};
  light.diffuse = light.ambient = {1, 1, 1, 1};
  light.position = {1, 2, 3, 1};
  light.spot_cutoff = 180;
  light.constant_attenuation = 1;
  Material material{};
  material.ambient = {0.5f, 0.5f, 0.5f, 1};
  material.diffuse = {1, 1, 1, 0.25f};
  const LightModel model{};
  const Light lights[] = {light};
  const LitColours at = light_vertex(model, lights, material, {1, 2, 3}, {0, 0, 1});
  EXPECT_EQ(at.primary, glm::dvec4(0.5, 0.5, 0.5, 0.25));
}

// Section 2.11.3: the normal's row vector times the inverse of the upper leftmost 3x3 matrix.
TEST(Lighting, NormalsStayNormalToTheirSurface) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    float m[16];
    for (float& x : m) x = random.between(-2, 2);
    m[3] = m[7] = m[11] = 0;
    m[15] = 1;
    const glm::dmat3 linear(glm::dmat4(glm::make_mat4(m)));
    if (std::abs(glm::determinant(linear)) < 0.1) continue;
    EyeSpace as_given, rescaled, normalized;
    ASSERT_TRUE(as_given.set(m, false, false) && rescaled.set(m, true, false) && normalized.set(m, true, true));
    const glm::dvec3 normal = random.direction();
    const glm::dvec3 tangent = glm::cross(normal, glm::dvec3(random.direction()));
    const glm::dvec3 eye = as_given.normal(normal);
    EXPECT_NEAR(glm::dot(eye, linear * tangent), 0, 1e-9);
    EXPECT_NEAR(glm::dot(eye, linear * normal), glm::dot(normal, normal), 1e-9);
    EXPECT_NEAR(glm::length(normalized.normal(normal)), 1, 1e-12);
    // "the transformed normal [of a matrix that scales uniformly] has unit length"; the factor is that of (0, 0, 1).
    const double factor = glm::length(rescaled.normal(normal)) / glm::length(eye);
    EXPECT_NEAR(factor * glm::length(glm::row(glm::inverse(linear), 2)), 1, 1e-9);
  }
}

TEST(Lighting, RescalingUndoesAUniformScale) {
  const float m[16] = {0, 3, 0, 0, -3, 0, 0, 0, 0, 0, 3, 0, 5, 6, 7, 1};
  EyeSpace eye;
  ASSERT_TRUE(eye.set(m, true, false));
  EXPECT_NEAR(glm::length(eye.normal({0.6, 0, 0.8})), 1, 1e-12);
  EXPECT_EQ(eye.position({1, 0, 0, 1}), glm::dvec4(5, 9, 7, 1));
}

TEST(Lighting, MatricesWithoutDefinedNormalsAreRefused) {
  float flat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.2f, -1, 0, 0, -2.2f, 0};
  float infinite[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, INFINITY, 0, 0, 0, 0, 1};
  EyeSpace eye;
  EXPECT_FALSE(eye.set(flat, false, true));
  EXPECT_FALSE(eye.set(projection, false, false));
  EXPECT_FALSE(eye.set(infinite, false, false));
}

}  // namespace
}  // namespace truequad
