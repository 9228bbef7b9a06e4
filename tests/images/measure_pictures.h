// Pictures measured against the exact maps of the quads that they show.
#pragma once

#include "pictures.h"
#include "scenes.h"

namespace truequad::images {

// What the kernel plans for a quad says what its picture must keep.
struct Promise {
  bool corrected = false;
  bool capped = false;
  bool measurable = false;  // a bound is promised
  bool projective = false;  // the exact map is the homography
  double bound_px = 0;      // of the map's error; infinite if nothing is promised
};
Promise promise_of(const DrawnQuad& quad, const Settings& settings);

struct Measurement {
  long quads = 0, corrected = 0, capped = 0, unmeasured = 0;
  long pixels = 0;         // of quads with a promise
  double largest_px = 0;   // how far texels are from their exact place
  double worst_ratio = 0;  // the largest displacement in relation to the quad's own limit
  unsigned worst_seed = 0;
  long strays = 0;         // pixels beyond the limit of their quad
};
Measurement measure(const Job& job, const Pictures& pictures, const Settings& settings);

// Distance of a pixel's centre from the nearest place where the exact map has a texel that the pixel may
// show, since it tells its coordinates only to within kCoordinateStep / 2. What is at most `enough_px` may be
// any number up to that.
double displacement_px(const DrawnQuad& quad, bool projective, double x, double y, const Texel& texel,
                       double enough_px);

}  // namespace truequad::images
