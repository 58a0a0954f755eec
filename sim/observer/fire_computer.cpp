#include "sim/observer/fire_computer.h"

#include "sim/ballistics/angles.h"

#include <algorithm>
#include <cmath>

namespace npsee::observer {
namespace {

constexpr std::size_t kAimers = 32;
/// Guns at more heights than this are forgotten again.
constexpr std::size_t kSites = 2048;

/// A shell may come down this far from the target and still count as unmasked, m: an observer would not correct so little
/// (misses under 30 m are ignored), and a small weapon's burst must still reach the target.
constexpr double kIgnoredMiss_m = 30.0;
/// At least well above the accuracy of a solution (0.04 m), also where it is stretched by a grazing descent.
constexpr double kLeastMaskTolerance_m = 2.0;

}  // namespace

std::string metres(double value) { return shortest(std::floor(value + 0.5) + 0.0) + " m"; }

FireComputer::FireComputer(const BatterySetup& battery, const Weapon& weapon, const Terrain& terrain, const Weather& weather, const FdcSetup& fdc, Ammunition ammunition)
    : battery_(battery),
      weapon_(weapon),
      weather_(weather),
      fdc_(fdc),
      ammunition_(std::move(ammunition)),
      surface_(std::make_shared<const Surface>(terrain)),
      range_limit_m_(HUGE_VAL),
      mask_tolerance_m_(std::clamp(0.5 * weapon.kill_radius_m, kLeastMaskTolerance_m, kIgnoredMiss_m)) {}

Expected<void> FireComputer::prepare() {
  // Anything that can be wrong with the shell or its air shows here, so that sites need no second check.
  const double height = battery_.guns.empty() ? 0.0 : surface_->height(battery_.guns[0].at.x_m, battery_.guns[0].at.z_m) + battery_.muzzle_height_m;
  if (auto good = Ballistics::make(ammunition_.projectile); !good) return tl::unexpected<Error>(good.error());
  const Site& level = site(height);
  for (const Charge& charge : ammunition_.charges) {
    AimRequest request;
    request.speed_mps = charge.speed_mps;
    request.factors = charge.factors;
    const auto aimer = Aimer::make(level.flat, request);
    if (!aimer) return tl::unexpected<Error>(Error{ErrorKind::input, aimer.error().faults});
    reach_m_.push_back(aimer->maxRange());
    max_range_m_ = std::max(max_range_m_, aimer->maxRange());
  }
  const double stated = weapon_.range_m;
  if (!ammunition_.by_weapon || !(stated > 0.0)) return {};
  const std::string who = "the battery \"" + battery_.id + "\": the weapon " + std::to_string(weapon_.id) + " (" + weapon_.name + ") states a range of " + metres(stated);
  if (stated > max_range_m_) {
    ammunition_.warnings.push_back(placeless(who + ", but its shell reaches " + metres(max_range_m_) + " on level ground.", "The stated range is not relied on."));
  } else {
    range_limit_m_ = max_range_m_ = stated;
  }
  return {};
}

const FireComputer::Site& FireComputer::site(double muzzle_y_m) {
  if (const auto found = sites_.find(muzzle_y_m); found != sites_.end()) return found->second;
  if (sites_.size() >= kSites) sites_.clear();
  Conditions conditions;
  conditions.muzzle_altitude_m = std::clamp(muzzle_y_m - surface_->terrain().seaLevel(), -5000.0, 20000.0);
  const auto flat = Ballistics::make(ammunition_.projectile, conditions);
  conditions.ground = surface_;
  const auto over_ground = Ballistics::make(ammunition_.projectile, conditions);
  return sites_.emplace(muzzle_y_m, Site{flat.value(), over_ground.value()}).first->second;
}

const Aimer* FireComputer::aimer(std::size_t charge, const Vec3& muzzle_m, const Line& line) {
  // All in the frame of the line to the target, so that without wind one aimer serves every direction.
  AimRequest request;
  request.wind_mps = weather_.wind_mps == Vec3{} ? Vec3{} : flightFromWorld(weather_.wind_mps, line.azimuth_rad);
  request.height_m = line.height_m;
  request.speed_mps = ammunition_.charges[charge].speed_mps;
  request.factors = ammunition_.charges[charge].factors;
  const AimerKey key{charge, muzzle_m.y, line.height_m, request.wind_mps};
  for (const CachedAimer& cached : aimers_)
    if (cached.key == key) return &cached.aimer;
  auto made = Aimer::make(site(muzzle_m.y).flat, request);
  if (!made) return nullptr;
  if (aimers_.size() < kAimers) {
    aimers_.push_back({key, std::move(*made)});
    return &aimers_.back().aimer;
  }
  CachedAimer& place = aimers_[next_aimer_++ % kAimers];
  place = {key, std::move(*made)};
  return &place.aimer;
}

FireComputer::Line FireComputer::lineTo(const Vec3& muzzle_m, const Vec3& point_m) const {
  const Vec3 d = point_m - muzzle_m;
  const double azimuth = ballistics::angleOf(-d.z, d.x);
  return {std::sqrt(d.x * d.x + d.z * d.z), azimuth < 0.0 ? azimuth + kTwoPi : azimuth, d.y};
}

FlightPath FireComputer::fly(const FireSolution& solution, double along_sigma, double across_sigma, double lay_error_rad) {
  // The probable error is the quartile of a normal distribution: 0.6745 of its standard deviation.
  constexpr double kQuartile = 0.67448975019608171;
  const double along = along_sigma * battery_.pe_range_m / kQuartile, across = across_sigma * battery_.pe_deflection_m / kQuartile;
  Shot shot = along != 0.0 || across != 0.0 ? displaced(solution, along, across) : solution.shot;
  if (lay_error_rad != 0.0) {
    const Vec3 wind = worldFromFlight(shot.wind_mps, shot.azimuth_rad);
    shot.azimuth_rad += lay_error_rad;
    shot.wind_mps = flightFromWorld(wind, shot.azimuth_rad);
  }
  return site(shot.muzzle_m.y).over_ground.path(shot);
}

/// The shot that comes down displaced by these distances in the plane of the aim point, right of the line of fire and along it.
///
/// Along the line the muzzle velocity makes the difference, as it mostly does with real guns; unlike the elevation it still does
/// near the greatest range, where dR/dQE vanishes. Secants on the distance, and turning by the angle that is left.
Shot FireComputer::displaced(const FireSolution& solution, double along_m, double across_m) {
  constexpr double kTolerance_m = 0.02;
  constexpr int kRounds = 16;
  const Ballistics plane = site(solution.shot.muzzle_m.y).flat.onto(solution.aim_m.y - solution.shot.muzzle_m.y);
  const Vec3 wind = worldFromFlight(solution.shot.wind_mps, solution.shot.azimuth_rad);
  const Flight base = plane.fly(solution.shot);
  const double reach = std::sqrt(base.range_m * base.range_m + base.drift_m * base.drift_m);
  if (base.end != FlightEnd::impact || !(reach > 1.0)) return solution.shot;

  // Wanted point in the frame of the undisplaced line of fire.
  const double along_x = base.range_m / reach, along_z = base.drift_m / reach;
  const double x = base.range_m + along_m * along_x - across_m * along_z, z = base.drift_m + along_m * along_z + across_m * along_x;
  const double wanted = std::max(std::sqrt(x * x + z * z), 0.05 * reach), bearing = ballistics::angleOf(x, z);

  const double first = solution.shot.speed_mps, lowest = 0.3 * first, highest = 3.0 * first;
  Shot shot = solution.shot, best = shot;
  double best_miss = HUGE_VAL, speed_before = first, reach_before = reach;
  shot.speed_mps = std::clamp(first * (1.0 + 0.6 * (wanted - reach) / reach), lowest, highest);
  double turn = ballistics::angleOf(base.range_m, base.drift_m) - bearing;
  for (int round = 0; round < kRounds; ++round) {
    shot.azimuth_rad = solution.shot.azimuth_rad - turn;
    shot.wind_mps = flightFromWorld(wind, shot.azimuth_rad);
    const Flight flight = plane.fly(shot);
    if (flight.end != FlightEnd::impact) break;
    const double here = std::sqrt(flight.range_m * flight.range_m + flight.drift_m * flight.drift_m);
    const double off = ballistics::angleOf(flight.range_m, flight.drift_m) - turn - bearing;
    const double miss = std::fabs(here - wanted) + std::fabs(off) * wanted;
    if (miss < best_miss) {
      best_miss = miss;
      best = shot;
    }
    if (miss < kTolerance_m) break;
    const double slope = shot.speed_mps != speed_before ? (here - reach_before) / (shot.speed_mps - speed_before) : 0.0;
    speed_before = shot.speed_mps;
    reach_before = here;
    if (slope > 0.0) shot.speed_mps = std::clamp(shot.speed_mps + (wanted - here) / slope, lowest, highest);
    else shot.speed_mps = std::clamp(shot.speed_mps * (1.0 + 0.6 * (wanted - here) / here), lowest, highest);
    turn += off;
  }
  return best;
}

}  // namespace npsee::observer
