#pragma once

#include "app/gl/program.h"

#include <npsee/preset.h>
#include <npsee/vec3.h>

namespace npsee::render {

/// Sky and daylight of an hour; colours are linear.
struct HourLight {
  Vec3 towards_key{-0.5263, 0.7105, 0.4671};  ///< where the sun or the moon stands, unit; as in shaders/common.glsl by day
  Vec3 key{1.42, 1.32, 1.16};    ///< its light beside that of the sky
  Vec3 daylight{1.0, 1.0, 1.0};  ///< on the light of both
  Vec3 horizon, zenith;
  Vec3 afterglow;                ///< added to the sky where the sun went down
  double exposure = 1.0;         ///< on what shines by itself: eyes and cameras adapt to the dark
  double stars = 0.0;            ///< brightness of the brightest

  /// Share of a level ground's light that comes from the sun or the moon.
  double keyShare() const;
};

HourLight hourLight(Sky sky);

/// Sets u_towards_key and u_key_light.
void setKey(const gl::Program& program, const Vec3& towards_key, const Vec3& key);

/// Sets u_horizon, u_zenith, u_afterglow, u_stars, u_daylight and the key.
void setHour(const gl::Program& program, Sky sky);

}  // namespace npsee::render
