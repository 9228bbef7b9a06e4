// Views that several samples share; they leave the matrix mode at GL_MODELVIEW with an identity.
#pragma once

namespace samples {

// One unit is one pixel, origin in the middle, y up; the scale keeps a picture made for 640x480 inside a
// canvas of any size.
void view_in_pixels(int width, int height);

// Perspective with a vertical angle of view in degrees, looking along -z from the origin.
void view_in_perspective(int width, int height, double angle_deg, double near_distance, double far_distance);

}  // namespace samples
