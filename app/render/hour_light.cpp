#include "app/render/hour_light.h"

#include "app/render/view.h"

namespace npsee::render {

HourLight hourLight(Sky sky) {
  HourLight out;
  switch (sky) {
    case Sky::day:
      // As kHorizon and kZenith of shaders/common.glsl.
      out.horizon = {0.450, 0.510, 0.560};
      out.zenith = {0.110, 0.200, 0.345};
      break;
    case Sky::dusk:
      out.daylight = {0.500, 0.350, 0.285};
      out.horizon = {0.300, 0.205, 0.175};
      out.zenith = {0.028, 0.048, 0.105};
      out.afterglow = {0.62, 0.24, 0.07};
      out.exposure = 1.4;
      out.stars = 0.10;
      break;
    case Sky::night:
      // Moonlight; the ground is still told from the sky.
      out.daylight = {0.034, 0.043, 0.064};
      out.horizon = {0.0130, 0.0180, 0.0300};
      out.zenith = {0.0035, 0.0055, 0.0125};
      out.exposure = 2.2;
      out.stars = 0.55;
      out.shadows = false;
      break;
  }
  return out;
}

void setHour(const gl::Program& program, Sky sky) {
  const HourLight light = hourLight(sky);
  setVec3(program, "u_horizon", light.horizon);
  setVec3(program, "u_zenith", light.zenith);
  setVec3(program, "u_afterglow", light.afterglow);
  program.set("u_stars", static_cast<float>(light.stars));
  setVec3(program, "u_daylight", light.daylight);
}

}  // namespace npsee::render
