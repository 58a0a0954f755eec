// Elevations for requests: what to try in which order, and why something will not do.

#include "sim/observer/fire_computer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace npsee::observer {
namespace {

/// Howitzers depress a little below the horizontal; 3 degrees is what data sheets give for the M109.
constexpr double kLowestElevation_rad = -3.0 * kPi / 180.0;
/// A shell must get this far from the gun whatever its weapon, m.
constexpr double kLeastRange_m = 50.0;
/// The lead has converged when the aim point moves less than this, m, and is given up after so many rounds.
constexpr double kLeadTolerance_m = 0.2;
constexpr int kLeadRounds = 16;
/// Refused attempts that a reason quotes.
constexpr std::size_t kQuoted = 4;

std::string tenths(double value) { return shortest(std::floor(value * 10.0 + 0.5) / 10.0); }
std::string mils(double rad) { return shortest(std::floor(rad * 6400.0 / kTwoPi + 0.5) + 0.0) + " mil"; }

std::string heightText(double height_m) {
  if (std::fabs(height_m) < 0.5) return "level with the gun";
  return metres(std::fabs(height_m)) + (height_m > 0.0 ? " above the gun" : " below the gun");
}

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// What to do about a refusal, as a sentence.
std::string_view remedyOf(Refusal refusal) {
  switch (refusal) {
    case Refusal::out_of_range: return "Move the guns nearer or give the battery a stronger charge.";
    case Refusal::too_close: return "Move the guns away from the target.";
    case Refusal::masked: return "Move the guns to where no ground stands in between.";
    case Refusal::elevation: return "Move the guns or allow another charge.";
    case Refusal::in_sea: return "Place it on land.";
    case Refusal::no_convergence: return "Fire when the target is slower.";
    case Refusal::none: break;
  }
  return "";
}

/// Which of several refusals names the reason best: the one that came closest to firing.
int closeness(Refusal refusal) {
  switch (refusal) {
    case Refusal::masked: return 5;
    case Refusal::elevation: return 4;
    case Refusal::no_convergence: return 3;
    case Refusal::too_close: return 2;
    default: return 1;
  }
}

FireSolution refused(Refusal refusal, std::string reason) {
  FireSolution out;
  out.refusal = refusal;
  out.reason = std::move(reason) + ' ' + std::string(remedyOf(refusal));
  return out;
}

FireSolution concluded(FireSolution out) {
  const auto worst = std::ranges::max_element(out.rejected, {}, [](const FireSolution::Rejected& r) { return closeness(r.refusal); });
  out.refusal = worst->refusal;
  for (std::size_t i = 0; i < out.rejected.size() && i < kQuoted; ++i) out.reason += out.rejected[i].reason + ' ';
  out.reason += remedyOf(out.refusal);
  return out;
}

}  // namespace

Vec3 FireComputer::onSurface(const Vec3& point_m, const FireRequest& request) const {
  return {point_m.x, surface_->height(point_m.x, point_m.z) + (request.illumination ? request.burst_height_m : 0.0), point_m.z};
}

/// Where a gun with a table of ranges is laid for: the aim point, moved along the line to it to the next range of the table.
Vec3 FireComputer::laidPoint(const FireRequest& request, const Vec3& aim_m) const {
  if (fdc_.solver != ElevationSolver::table) return aim_m;
  const Line line = lineTo(request.muzzle_m, aim_m);
  if (!(line.distance_m > 0.0)) return aim_m;
  const double share = legacyRange(line.distance_m, std::max(1.0, fdc_.table_step_m)) / line.distance_m;
  return onSurface({request.muzzle_m.x + share * (aim_m.x - request.muzzle_m.x), 0.0, request.muzzle_m.z + share * (aim_m.z - request.muzzle_m.z)}, request);
}

/// Cheap and generous: whether it is worth a closer look. The greatest range grows by no more than the drop (in vacuum it does by
/// just that), and a following wind adds less than 2 % per m/s.
bool FireComputer::reaches(std::size_t charge, const FireRequest& request) const {
  const Line line = lineTo(request.muzzle_m, onSurface(request.target_m, request));
  const double speed = length(request.target_velocity_mps);
  return line.distance_m <= reach_m_[charge] * (1.05 + 0.02 * length(weather_.wind_mps)) + 2.0 * std::max(0.0, -line.height_m) + speed * (request.delay_s + 200.0);
}

std::string FireComputer::farText(const FireRequest& request) const {
  const Line line = lineTo(request.muzzle_m, onSurface(request.target_m, request));
  std::string text = "The target is " + metres(line.distance_m) + " away, " + heightText(line.height_m) + ": out of range. The greatest range on level ground is " + metres(max_range_m_);
  if (range_limit_m_ == max_range_m_) return text + ", as the weapon states.";
  return text + ", with charge " + ammunition_.charges.back().name + ".";
}

FireSolution FireComputer::solve(const FireRequest& request) {
  if (!finite(request.muzzle_m) || !finite(request.target_m) || !finite(request.target_velocity_mps)) return refused(Refusal::no_convergence, "The place or velocity of gun or target is no number.");
  if (surface_->terrain().sea(request.muzzle_m.x, request.muzzle_m.z))
    return refused(Refusal::in_sea, "The gun at " + metres(request.muzzle_m.x) + " east, " + metres(request.muzzle_m.z) + " south stands in the sea.");

  const TrajectoryChoice choice = request.trajectory != TrajectoryChoice::automatic ? request.trajectory : fdc_.trajectory;
  const bool forced = choice != TrajectoryChoice::automatic;
  FireSolution out;
  bool low_masked = false;
  std::string far = farText(request);
  for (std::size_t charge = 0; charge < ammunition_.charges.size(); ++charge) {
    if (!reaches(charge, request)) continue;
    for (const bool high : {false, true}) {
      if (choice == (high ? TrajectoryChoice::low : TrajectoryChoice::high)) continue;
      // A stronger charge's low trajectory lies below a weaker one's all the way: it is masked too.
      if (!high && low_masked) continue;
      // Weapons for direct fire are not lobbed unless somebody insists.
      if (high && !forced && weapon_.path == PathType::low_angle) continue;
      Attempt attempt = this->attempt(request, charge, high);
      if (attempt.refusal == Refusal::none || (forced && attempt.refusal == Refusal::masked)) {
        FireSolution solution = accepted(attempt, charge, high);
        solution.rejected = std::move(out.rejected);
        return solution;
      }
      if (attempt.refusal == Refusal::out_of_range) {
        far = attempt.reason;
        continue;
      }
      low_masked = low_masked || (!high && attempt.refusal == Refusal::masked);
      out.rejected.push_back({high, attempt.refusal, attempt.aim.shot.elevation_rad, attempt.reason});
      if (attempt.hopeless) return concluded(std::move(out));
    }
  }
  return out.rejected.empty() ? refused(Refusal::out_of_range, far) : concluded(std::move(out));
}

FireComputer::Attempt FireComputer::attempt(const FireRequest& request, std::size_t charge, bool high) {
  Attempt out;
  if (!followLead(request, charge, high, out)) return out;
  checkElevation(charge, high, out);
  if (out.refusal == Refusal::none) flyOver(request, charge, high, out);
  return out;
}

/// Solves for one aim point; false with a refusal where there is no solution.
bool FireComputer::aimAt(const FireRequest& request, std::size_t charge, bool high, const Vec3& aim_m, Attempt& out) {
  out.aim_m = aim_m;
  out.laid_m = laidPoint(request, aim_m);
  const Line line = lineTo(request.muzzle_m, out.laid_m);
  out.bearing_rad = line.azimuth_rad;
  out.distance_m = line.distance_m;
  const auto refuse = [&](Refusal refusal, std::string reason) {
    out.refusal = refusal;
    out.reason = std::move(reason);
    return false;
  };
  const double least = std::max(kLeastRange_m, static_cast<double>(weapon_.damage_radius_m));
  const double true_distance = lineTo(request.muzzle_m, aim_m).distance_m;
  out.hopeless = true_distance < least || line.distance_m < 1.0;
  if (out.hopeless)
    return refuse(Refusal::too_close, "The target is " + metres(true_distance) + " from the gun; nearer than " + metres(least) + " the burst would reach the gun itself.");

  const std::string& charge_name = ammunition_.charges[charge].name;
  const Aimer* aimer = this->aimer(charge, request.muzzle_m, line);
  if (!aimer) return refuse(Refusal::out_of_range, "The target is " + heightText(line.height_m) + ", higher than charge " + charge_name + " carries the shell.");
  if (line.distance_m > range_limit_m_ || line.distance_m > aimer->maxRange())
    return refuse(Refusal::out_of_range, "The target is " + metres(line.distance_m) + " away, " + heightText(line.height_m) + ": beyond the greatest range there of " + metres(std::min(range_limit_m_, aimer->maxRange())) + ", with charge " + charge_name + ".");
  auto solution = high ? aimer->high(line.distance_m) : aimer->low(line.distance_m);
  if (!solution)
    return refuse(Refusal::too_close, std::string("The ") + (high ? "high" : "low") + " trajectory with charge " + charge_name + " comes down no nearer than the target at " + metres(line.distance_m) + ", " + heightText(line.height_m) + ".");
  solution->shot.azimuth_rad += line.azimuth_rad;
  if (solution->shot.azimuth_rad < 0.0) solution->shot.azimuth_rad += kTwoPi;
  if (solution->shot.azimuth_rad >= kTwoPi) solution->shot.azimuth_rad -= kTwoPi;
  solution->shot.muzzle_m = request.muzzle_m;
  out.aim = *solution;
  return true;
}

/// Aims where the target will be: the fixed point of aim = target + velocity (delay + time of flight to aim).
bool FireComputer::followLead(const FireRequest& request, std::size_t charge, bool high, Attempt& out) {
  Vec3 aim = onSurface(request.target_m, request);
  const Vec3 velocity = fdc_.lead ? Vec3{request.target_velocity_mps.x, 0.0, request.target_velocity_mps.z} : Vec3{};
  const bool moves = !(velocity == Vec3{});
  if (!aimAt(request, charge, high, aim, out)) {
    if (!moves) return false;
    // Out of reach now, it may drive into it while the shell flies: begin from a rough time of flight.
    const double speed = ammunition_.charges[charge].speed_mps, rough = high ? 1.7 * speed / kStandardGravity_mps2 : out.distance_m / (0.7 * speed);
    Attempt later;
    aim = onSurface(request.target_m + (request.delay_s + rough) * velocity, request);
    if (!aimAt(request, charge, high, aim, later)) return false;
    out = later;
  }
  if (!moves) return true;
  for (int round = 0; round < kLeadRounds; ++round) {
    const Vec3 next = onSurface(request.target_m + (request.delay_s + out.aim.flight.time_of_flight_s) * velocity, request);
    const Vec3 step{next.x - aim.x, 0.0, next.z - aim.z};
    if (length(step) < kLeadTolerance_m) return true;
    aim = next;
    if (!aimAt(request, charge, high, aim, out)) return false;
  }
  out.refusal = Refusal::no_convergence;
  out.reason = std::string("No lead was found on the ") + (high ? "high" : "low") + " trajectory for a target that moves at " + tenths(length(velocity)) + " m/s.";
  return false;
}

void FireComputer::checkElevation(std::size_t charge, bool high, Attempt& out) const {
  const double elevation = out.aim.shot.elevation_rad, highest = std::max(0.2, battery_.max_elevation_rad);
  if (elevation >= kLowestElevation_rad && elevation <= highest) return;
  out.refusal = Refusal::elevation;
  const bool over = elevation > highest;
  out.reason = std::string("The ") + (high ? "high" : "low") + " trajectory with charge " + ammunition_.charges[charge].name + " needs an elevation of " + mils(elevation) + (over ? ", above" : ", below") + " the gun's limit of " +
               mils(over ? highest : kLowestElevation_rad) + ".";
}

/// Flies the shell over the ground: does it get to the target?
void FireComputer::flyOver(const FireRequest& request, std::size_t charge, bool high, Attempt& out) {
  out.flight = site(request.muzzle_m.y).over_ground.fly(out.aim.shot);
  const auto placeOf = [&](const Flight& f) { return request.muzzle_m + worldFromFlight({f.range_m, f.height_m, f.drift_m}, out.aim.shot.azimuth_rad); };
  const std::string which = std::string("The ") + (high ? "high" : "low") + " trajectory with charge " + ammunition_.charges[charge].name + " (" + mils(out.aim.shot.elevation_rad) + ")";
  if (out.flight.end != FlightEnd::impact) {
    out.refusal = Refusal::no_convergence;
    out.reason = which + " never comes down.";
    return;
  }
  out.impact_m = placeOf(out.flight);
  out.time_of_flight_s = out.flight.time_of_flight_s;
  const double burst = out.aim.flight.time_of_flight_s;
  bool masked = false;
  if (request.illumination) {
    masked = out.flight.time_of_flight_s < burst - 1e-3;
    if (!masked) {
      out.impact_m = placeOf(out.aim.flight);
      out.time_of_flight_s = burst;
    }
  } else {
    masked = lineTo(out.laid_m, out.impact_m).distance_m > mask_tolerance_m_;
  }
  if (!masked) return;
  out.masked = true;
  out.refusal = Refusal::masked;
  const double down = lineTo(request.muzzle_m, out.impact_m).distance_m, off = out.distance_m - down;
  out.reason = which + " comes down at " + metres(down) + ", " + metres(std::fabs(off)) + (off >= 0.0 ? " short of" : " beyond") + " the target at " + metres(out.distance_m) + ": the ground is in its way.";
}

FireSolution FireComputer::accepted(const Attempt& attempt, std::size_t charge, bool high) const {
  FireSolution out;
  out.high = high;
  out.masked = attempt.masked;
  out.charge = static_cast<int>(charge);
  out.shot = attempt.aim.shot;
  out.time_of_flight_s = attempt.time_of_flight_s;
  out.apex_m = attempt.flight.max_ordinate_m;
  out.aim_m = attempt.aim_m;
  out.impact_m = attempt.impact_m;
  out.doubts = attempt.flight.doubts;
  if (attempt.masked) out.reason = attempt.reason;
  return out;
}

}  // namespace npsee::observer
