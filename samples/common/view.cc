#include "common/view.h"

#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace samples {
namespace {

void begin_projection() {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
}

void end_projection() {
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

}  // namespace

void view_in_pixels(int width, int height) {
  constexpr double kWidth = 640, kHeight = 480;
  const double scale = std::min(width / kWidth, height / kHeight);
  begin_projection();
  glOrtho(-width / (2 * scale), width / (2 * scale), -height / (2 * scale), height / (2 * scale), -1, 1);
  end_projection();
}

void view_in_perspective(int width, int height, double angle_deg, double near_distance, double far_distance) {
  const double top = near_distance * std::tan(angle_deg * std::numbers::pi / 360);
  const double right = top * width / height;
  begin_projection();
  glFrustum(-right, right, -top, top, near_distance, far_distance);
  end_projection();
}

}  // namespace samples
