#include "capture/lighting.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace truequad {
namespace {

using glm::dvec3;
using glm::dvec4;

// "d1 . d2 = max{d1 . d2, 0}", the product with the circled dot.
double dot_or_zero(const dvec3& a, const dvec3& b) { return std::max(glm::dot(a, b), 0.0); }

dvec3 unit(const dvec3& x) {
  const double length = glm::length(x);
  return length > 0 ? x / length : dvec3(0);
}

// att_i: "1 / (k0 + k1 |VP| + k2 |VP|^2) if Ppli's w is not 0, else 1.0".
double attenuation(const Light& light, double distance) {
  if (light.position.w == 0) return 1;
  return 1 / (light.constant_attenuation + light.linear_attenuation * distance +
              light.quadratic_attenuation * distance * distance);
}

// spot_i, for the unit vector from the light to the vertex.
double spot(const Light& light, const dvec3& from_light) {
  if (light.spot_cutoff == 180) return 1;
  const double cosine = dot_or_zero(from_light, unit(light.spot_direction));
  return cosine >= std::cos(glm::radians(double(light.spot_cutoff))) ? std::pow(cosine, double(light.spot_exponent)) : 0;
}

}  // namespace

LitColours light_vertex(const LightModel& model, std::span<const Light> lights, const Material& material,
                        const dvec3& position, const dvec3& normal) {
  const dvec3 ambient(material.ambient), diffuse(material.diffuse), specular(material.specular);
  // "A is always associated with the primary color": the alpha of d_cm.
  LitColours lit{dvec4(dvec3(material.emission) + ambient * dvec3(model.ambient), material.diffuse.a), dvec4(0)};
  const dvec3 to_viewer = model.local_viewer ? unit(-position) : dvec3(0, 0, 1);
  for (const Light& light : lights) {
    const dvec4 place(light.position);
    const dvec3 to_light = place.w == 0 ? dvec3(place) : dvec3(place) / place.w - position;
    const dvec3 direction = unit(to_light);
    const double strength = attenuation(light, glm::length(to_light)) * spot(light, -direction);
    const double facing = dot_or_zero(normal, direction);
    lit.primary +=
        dvec4(strength * (ambient * dvec3(light.ambient) + facing * diffuse * dvec3(light.diffuse)), 0);
    if (facing == 0) continue;  // f_i
    // A shininess of 0 makes 1 of any angle.
    const double highlight = std::pow(dot_or_zero(normal, unit(direction + to_viewer)), double(material.shininess));
    dvec4& to = model.separate_specular ? lit.secondary : lit.primary;
    to += dvec4(strength * highlight * specular * dvec3(light.specular), 0);
  }
  return lit;
}

bool EyeSpace::set(const float (&modelview)[16], bool rescale, bool normalize) {
  from_object_ = glm::dmat4(glm::make_mat4(modelview));
  if (modelview[3] != 0 || modelview[7] != 0 || modelview[11] != 0 || modelview[15] == 0) return false;
  const glm::dmat3 linear(from_object_);
  const double determinant = glm::determinant(linear);
  if (!std::isfinite(determinant) || determinant == 0) return false;
  // Normals are rows: (nx ny nz) M^-1.
  const glm::dmat3 inverse = glm::inverse(linear);
  normal_from_object_ = glm::transpose(inverse);
  if (rescale) {
    // "f = 1 / sqrt(m31^2 + m32^2 + m33^2)" of the inverse.
    normal_from_object_ *= 1 / glm::length(dvec3(inverse[0][2], inverse[1][2], inverse[2][2]));
  }
  normalize_ = normalize;
  return true;
}

dvec3 EyeSpace::normal(const dvec3& object) const {
  const dvec3 eye = normal_from_object_ * object;
  return normalize_ ? unit(eye) : eye;
}

}  // namespace truequad
