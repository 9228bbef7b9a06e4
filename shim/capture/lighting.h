// The lighting equation of GL 2.1 section 2.14.1, for one vertex. Pure: no GL, no state.
//
// A quad is lit at its corners, and what lies between them is interpolated (Gouraud). The vertices that a mesh inserts are
// none of the program's, so they must not be lit for themselves: they get the interpolated colours of the corners.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace truequad {

// Table 2.10. Places and directions are in eye coordinates, as glGetLight returns them.
struct Light {
  glm::vec4 ambient, diffuse, specular;
  glm::vec4 position;  // w = 0: at infinity
  glm::vec3 spot_direction;
  float spot_exponent, spot_cutoff;  // degrees; 180: no spot
  float constant_attenuation, linear_attenuation, quadratic_attenuation;
};

struct Material {
  glm::vec4 ambient, diffuse, specular, emission;
  float shininess;
};

struct LightModel {
  glm::vec4 ambient;
  bool local_viewer, separate_specular;
};

struct LitColours {
  glm::dvec4 primary, secondary;  // not clamped
};

// A vertex at `position` with `normal`, both in eye coordinates. The side that is lit by the reversed normal is the
// caller's to reverse.
LitColours light_vertex(const LightModel& model, std::span<const Light> lights, const Material& material,
                        const glm::dvec3& position, const glm::dvec3& normal);

// From object to eye coordinates (section 2.11.3).
class EyeSpace {
 public:
  // `rescale`, `normalize`: GL_RESCALE_NORMAL and GL_NORMALIZE are enabled. False if the modelview matrix (column-major) is
  // not affine or has no inverse: what becomes of normals then is left to the implementation.
  bool set(const float (&modelview)[16], bool rescale, bool normalize);

  // w = 0: the vertex is at infinity.
  glm::dvec4 position(const glm::dvec4& object) const { return from_object_ * object; }
  glm::dvec3 normal(const glm::dvec3& object) const;

 private:
  glm::dmat4 from_object_;
  glm::dmat3 normal_from_object_;
  bool normalize_;
};

}  // namespace truequad
