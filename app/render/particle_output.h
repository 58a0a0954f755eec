#pragma once

#include "app/gl/program.h"

namespace npsee::render {

/// What the particle passes write.
enum class ParticleOutput {
  light,    ///< premultiplied light and cover
  surface,  ///< depth and motion, see shaders/surface.glsl
};

/// What surfaces need beside the view.
struct SurfaceFrame {
  int width = 0, height = 0;  ///< pixels
  int low = 0;                ///< rows of the picture below those that are drawn
  double frame_s = 0.0;       ///< that motion is measured over
};

/// Sets u_size, u_low and u_frame with the program in use.
inline void setSurfaceFrame(const gl::Program& program, const SurfaceFrame& frame) {
  program.set("u_size", static_cast<float>(frame.width), static_cast<float>(frame.height));
  program.set("u_low", static_cast<float>(frame.low));
  program.set("u_frame", static_cast<float>(frame.frame_s));
}

}  // namespace npsee::render
