#pragma once

#include "app/gl/program.h"

#include <npsee/preset.h>
#include <npsee/vec3.h>

namespace npsee::render {

/// Sky and daylight of an hour; colours are linear.
struct HourLight {
  Vec3 daylight{1.0, 1.0, 1.0};  ///< on the light of shaders/common.glsl
  Vec3 horizon, zenith;
  Vec3 afterglow;                ///< added to the sky where the sun went down
  double exposure = 1.0;         ///< on what shines by itself: eyes and cameras adapt to the dark
  double stars = 0.0;            ///< brightness of the brightest
  bool shadows = true;           ///< the light throws shadows
};

HourLight hourLight(Sky sky);

/// Sets u_horizon, u_zenith, u_afterglow, u_stars and u_daylight.
void setHour(const gl::Program& program, Sky sky);

}  // namespace npsee::render
