// What a plan draws, measured against the exact map.
#pragma once

#include <vector>

#include "quads.h"
#include "truequad_reference/reference.h"

namespace truequad::test {

struct Mesh {
  std::vector<Param> vertices;
  std::vector<Triangle> triangles;
};
Mesh mesh_of(const Plan& plan);
// The driver's two triangles, cut along AC or BD.
Mesh two_triangles(bool along_ac);

// A point that a triangle draws: window coordinates, texture coordinates; `visible`: inside the clip volume.
struct Drawn {
  reference::Point window;
  reference::Real s, t;
  bool visible;
};
// b0, b1, b2: barycentric weights in clip space.
Drawn drawn_point(const Quad& quad, const Mesh& mesh, const Triangle& triangle, reference::Real b0,
                  reference::Real b1, reference::Real b2);

// Largest displacement in pixels among the visible ones of `samples` points: edge midpoints and random points
// of random triangles (all triangles in turn if samples allows).
struct Measured {
  double largest_px = 0;
  int visible = 0;
};
Measured measure(const Quad& quad, const Mesh& mesh, int samples, unsigned seed);

// Largest displacement over a fine even sampling of every triangle; for figures.
double measure_finely(const Quad& quad, const Mesh& mesh, int divisions);

// One plan for each thread of tests; plans are large.
Plan& scratch_plan();

}  // namespace truequad::test
