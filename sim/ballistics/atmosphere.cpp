#include "sim/ballistics/kernels.h"
#include "sim/core/elementary.h"

namespace npsee {
namespace ballistics {
namespace {

using namespace lanes;

#include "sim/ballistics/atmosphere.inl"

}  // namespace
}  // namespace ballistics

AirState airAt(const Atmosphere& atmosphere, double height_m) {
  if (!atmosphere.icao) return {atmosphere.density_kgm3, atmosphere.sound_speed_mps};
  AirState air;
  ballistics::standardAir(height_m, air.density_kgm3, air.sound_speed_mps);
  return air;
}

}  // namespace npsee
