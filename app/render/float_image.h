#pragma once

#include <cstddef>
#include <vector>

namespace npsee::render {

/// What is wanted of a picture in single precision.
struct FloatRequest {
  bool colour = true;
  bool linear = true;   ///< colour as scene light, premultiplied; otherwise as on the screen: highlights rolled off, sRGB-coded, straight alpha
  bool depth = false;
  bool motion = false;
  double frame_s = 1.0 / 30.0;  ///< what motion is measured over

  friend bool operator==(const FloatRequest&, const FloatRequest&) = default;
};

/// A picture in single precision, rows from the top, no padding; a pass that was not asked for is empty.
///
/// Depth and motion belong to what is seen at a pixel's centre: soft forms where they together cover at least half of what is behind
/// them (their mean, each weighted by its share of what is seen); else the nearest piece, or the ground under a sky.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<float> rgba;    ///< 4 per pixel
  std::vector<float> depth;   ///< m along the viewing direction, infinite where there is no surface
  std::vector<float> motion;  ///< 2 per pixel: to the right and up, pixels until the next frame; 0 where there is no surface
};

}  // namespace npsee::render
