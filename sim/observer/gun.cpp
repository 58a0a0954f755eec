#include "sim/observer/fire_direction.h"

#include <algorithm>

namespace npsee::observer {

Gun::Gun(const GunSetup& setup, const BatterySetup& battery, Vec3 muzzle_m, double first_azimuth_rad)
    : setup_(setup), muzzle_m_(muzzle_m), lay_time_s_(battery.lay_time_s), reload_time_s_(battery.reload_time_s), azimuth_rad_(first_azimuth_rad), rounds_(std::max(0, battery.rounds)) {}

double Gun::lay(double now_s, double azimuth_rad, double elevation_rad, std::vector<LayStep>& lays) {
  // How the tube stood before anybody touched it.
  if (lays.empty()) lays.push_back({0.0, 0.0, azimuth_rad_, elevation_rad_});
  const double from = std::max(now_s, laid_until_s_);
  const bool stands = azimuth_rad == azimuth_rad_ && elevation_rad == elevation_rad_;
  azimuth_rad_ = azimuth_rad;
  elevation_rad_ = elevation_rad;
  laid_until_s_ = stands ? from : from + lay_time_s_;
  if (!stands) lays.push_back({from, laid_until_s_, azimuth_rad, elevation_rad});
  return laid_until_s_;
}

double Gun::readyAt(double laid_s) const { return std::max(laid_s, loaded_at_s_); }

void Gun::fired(double time_s) {
  rounds_ = std::max(0, rounds_ - 1);
  loaded_at_s_ = time_s + reload_time_s_;
}

}  // namespace npsee::observer
