#include <npsee/recording.h>

#include "sim/core/elementary.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

/// Slower turns than this are straight lines: over a day they bend by less than a tenth of a degree.
constexpr double kStraight_radps = 1e-8;
/// No shell is longer on its way than the integrator flies it (Integration::time_limit_s), and direct fire is faster.
constexpr double kLongestFlight_s = 2000.0;

/// A track's index has at most this many entries for each leg, and a few besides: long rests then cost no memory, and few legs lie in a step.
constexpr double kEntriesPerLeg = 4.0, kEntries = 64.0;

/// Difference of two azimuths the shorter way round, in [-pi, pi].
double turnBetween(double from_rad, double to_rad) {
  const double turn = to_rad - from_rad;
  return turn - kTwoPi * std::floor(turn / kTwoPi + 0.5);
}

double shareOf(const LayStep& step, double time_s) {
  if (!(time_s < step.to_s)) return 1.0;
  return time_s > step.from_s ? (time_s - step.from_s) / (step.to_s - step.from_s) : 0.0;
}

/// Index of the first shell fired after a time.
std::ptrdiff_t firedBy(const std::vector<ShellRecord>& shells, double time_s) {
  return std::upper_bound(shells.begin(), shells.end(), time_s, [](double t, const ShellRecord& shell) { return t < shell.fired_s; }) - shells.begin();
}

}  // namespace

Pose poseOn(const Leg& leg, double time_s) {
  double t = std::max(0.0, time_s - leg.start_s);
  double sine = 0.0, cosine = 1.0;
  sineCosine(leg.heading_rad, sine, cosine);
  if (std::fabs(leg.turn_radps) > kStraight_radps) {
    const double heading = leg.heading_rad + leg.turn_radps * t, radius = leg.speed_mps / leg.turn_radps;
    double sine_now = 0.0, cosine_now = 1.0;
    sineCosine(heading, sine_now, cosine_now);
    // East is sin(heading), south -cos(heading): azimuths run clockwise from north.
    return {leg.x_m + radius * (cosine - cosine_now), leg.z_m - radius * (sine_now - sine), heading, leg.speed_mps};
  }
  if (leg.speed_mps * leg.acceleration_mps2 < 0.0) t = std::min(t, -leg.speed_mps / leg.acceleration_mps2);
  const double way = (leg.speed_mps + 0.5 * leg.acceleration_mps2 * t) * t;
  const bool stopped = leg.speed_mps * leg.acceleration_mps2 < 0.0 && t >= -leg.speed_mps / leg.acceleration_mps2;
  return {leg.x_m + way * sine, leg.z_m - way * cosine, leg.heading_rad, stopped ? 0.0 : leg.speed_mps + leg.acceleration_mps2 * t};
}

Pose Track::at(double time_s) const {
  if (legs.empty()) return {};
  std::size_t i = 0;
  if (!index.empty() && time_s > 0.0) i = index[static_cast<std::size_t>(std::min(time_s / index_step_s, static_cast<double>(index.size() - 1)))];
  while (i + 1 < legs.size() && legs[i + 1].start_s <= time_s) ++i;
  return poseOn(legs[i], time_s);
}

void Track::add(const Leg& leg) {
  // What was planned from this moment on no longer holds.
  while (!legs.empty() && legs.back().start_s >= leg.start_s) legs.pop_back();
  // Whole steps before the new leg belong to the one before it; from its start on, times are scanned to it.
  const auto before = static_cast<std::uint32_t>(legs.empty() ? 0 : legs.size() - 1);
  while (leg.start_s / index_step_s > kEntriesPerLeg * static_cast<double>(legs.size()) + kEntries) {
    index_step_s *= 2.0;
    for (std::size_t i = 0; 2 * i < index.size(); ++i) index[i] = index[2 * i];
    index.resize((index.size() + 1) / 2);
  }
  index.resize(leg.start_s > 0.0 ? static_cast<std::size_t>(std::ceil(leg.start_s / index_step_s)) : 0, before);
  legs.push_back(leg);
}

const DamageStep* VehicleRecord::damageAt(double time_s) const {
  const auto after = std::upper_bound(damage.begin(), damage.end(), time_s, [](double t, const DamageStep& step) { return t < step.t_s; });
  return after == damage.begin() ? nullptr : &*std::prev(after);
}

bool VehicleRecord::destroyedAt(double time_s) const {
  const DamageStep* step = damageAt(time_s);
  return step && step->hull >= 1.0;
}

std::pair<double, double> GunRecord::lineAt(double time_s) const {
  if (lays.empty()) return {0.0, 0.0};
  auto last = std::upper_bound(lays.begin(), lays.end(), time_s, [](double t, const LayStep& step) { return t < step.from_s; });
  if (last == lays.begin()) return {lays[0].azimuth_rad, lays[0].elevation_rad};
  --last;
  // A movement that was broken off hands on the line it had reached, so go back to one that was finished.
  auto first = last;
  while (first != lays.begin() && std::prev(first)->to_s > first->from_s) --first;
  const LayStep& origin = first == lays.begin() ? *first : *std::prev(first);
  double azimuth = origin.azimuth_rad, elevation = origin.elevation_rad;
  for (auto step = first; step <= last; ++step) {
    const double share = shareOf(*step, step == last ? time_s : std::next(step)->from_s);
    if (share >= 1.0) {
      azimuth = step->azimuth_rad;
      elevation = step->elevation_rad;
      continue;
    }
    azimuth += share * turnBetween(azimuth, step->azimuth_rad);
    elevation += share * (step->elevation_rad - elevation);
  }
  return {azimuth, elevation};
}

Vec3 ShellRecord::at(double time_s) const {
  const double t = std::clamp(time_s, fired_s, std::max(fired_s, burst_s));
  if (!path.nodes().empty()) return path.inWorld(t - fired_s).position_m;
  const double duration = burst_s - fired_s;
  return muzzle_m + (duration > 0.0 ? (t - fired_s) / duration : 1.0) * (burst_m - muzzle_m);
}

Vec3 ShellRecord::velocityAt(double time_s) const {
  const double t = std::clamp(time_s, fired_s, std::max(fired_s, burst_s));
  if (!path.nodes().empty()) return path.inWorld(t - fired_s).velocity_mps;
  const double duration = burst_s - fired_s;
  return duration > 0.0 ? (1.0 / duration) * (burst_m - muzzle_m) : Vec3{};
}

Vec3 Recording::vehiclePlace(std::size_t vehicle, double time_s) const {
  const Pose pose = vehicles[vehicle].track.at(time_s);
  return {pose.x_m, terrain.surface(pose.x_m, pose.z_m), pose.z_m};
}

Vec3 Recording::observerEye(std::size_t observer, double time_s) const {
  const ObserverRecord& record = observers[observer];
  if (record.vehicle < 0 || static_cast<std::size_t>(record.vehicle) >= vehicles.size()) return {};
  return vehiclePlace(static_cast<std::size_t>(record.vehicle), time_s) + Vec3{0.0, record.eye_height_m, 0.0};
}

namespace {

template <class Record>
int indexOf(const std::vector<Record>& records, std::string_view id) {
  const auto found = std::ranges::find(records, id, &Record::id);
  return found == records.end() ? -1 : static_cast<int>(found - records.begin());
}

}  // namespace

int Recording::findVehicle(std::string_view id) const { return indexOf(vehicles, id); }
int Recording::findGun(std::string_view id) const { return indexOf(guns, id); }
int Recording::findObserver(std::string_view id) const { return indexOf(observers, id); }

void Recording::shellsInAir(double time_s, std::vector<int>& out) const {
  out.clear();
  for (std::ptrdiff_t i = firedBy(shells, time_s) - 1; i >= 0 && shells[static_cast<std::size_t>(i)].fired_s > time_s - kLongestFlight_s; --i)
    if (shells[static_cast<std::size_t>(i)].burst_s > time_s) out.push_back(static_cast<int>(i));
  std::ranges::reverse(out);
}

void Recording::burstsSince(double time_s, double lasting_s, std::vector<int>& out) const {
  out.clear();
  for (std::ptrdiff_t i = firedBy(shells, time_s) - 1; i >= 0 && shells[static_cast<std::size_t>(i)].fired_s > time_s - lasting_s - kLongestFlight_s; --i) {
    const double burst = shells[static_cast<std::size_t>(i)].burst_s;
    if (burst <= time_s && burst > time_s - lasting_s) out.push_back(static_cast<int>(i));
  }
  std::ranges::reverse(out);
}

}  // namespace npsee
