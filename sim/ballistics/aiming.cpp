#include <npsee/aiming.h>

#include "sim/ballistics/angles.h"
#include "sim/core/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace npsee {

using namespace ballistics;

namespace {

/// Range error a solution is sought to, m: well within the half metre that is promised.
constexpr double kRangeTolerance_m = 0.02;
/// Accuracy of the greatest range, m: a small part of the thousandth of it that need not be reached.
constexpr double kMaximumTolerance_m = 0.03;
constexpr int kSamples = 12;  // whole fours fill the lanes
constexpr double kSteepest_rad = 0.5 * kPi;
/// Marks an elevation whose shell never comes down at the target's height.
constexpr double kNoRange = -1.0;

/// Elevation at a range on the parabola through three samples (Lagrange).
template <class Sample>
double parabola(double range, const Sample& a, const Sample& b, const Sample& c) {
  const auto term = [&](const Sample& p, const Sample& q, const Sample& r) {
    return p.elevation_rad * (range - q.range_m) * (range - r.range_m) / ((p.range_m - q.range_m) * (p.range_m - r.range_m));
  };
  return term(a, b, c) + term(b, c, a) + term(c, a, b);
}

/// Elevation of the greatest range of the parabola through three samples; that of the middle one where it has no top.
template <class Sample>
double vertex(const Sample& a, const Sample& b, const Sample& c) {
  const double ab = b.elevation_rad - a.elevation_rad, cb = c.elevation_rad - b.elevation_rad;
  const double fa = b.range_m - a.range_m, fc = b.range_m - c.range_m;
  const double denominator = ab * fc + cb * fa;
  return denominator > 0.0 ? b.elevation_rad + 0.5 * (cb * cb * fa - ab * ab * fc) / denominator : b.elevation_rad;
}

/// Angle of the impact to the right of the line of fire.
double offLine(const Flight& flight) { return angleOf(flight.range_m, flight.drift_m); }

double distance(const Flight& flight) { return std::sqrt(flight.range_m * flight.range_m + flight.drift_m * flight.drift_m); }

}  // namespace

Aimer::Aimer(Ballistics ballistics, AimRequest request) : ballistics_(std::move(ballistics)), request_(std::move(request)) {}

Expected<void> Aimer::check(const Ballistics& ballistics, const AimRequest& request) {
  if (!(std::fabs(request.height_m) <= 20000.0)) return fail(ErrorKind::usage, "the height of the target is " + shortest(request.height_m) + " m, outside -20000 to 20000 m.");
  return ballistics.checkShot(Aimer(ballistics, request).shotAt(0.5, 0.0));
}

Expected<Aimer> Aimer::make(const Ballistics& ballistics, const AimRequest& request) {
  if (auto good = check(ballistics, request); !good) return tl::unexpected<Error>(good.error());
  Aimer aimer(ballistics.onto(request.height_m), request);
  aimer.findMaximum();
  if (aimer.max_range_m_ <= 0.0)
    return fail(ErrorKind::usage, "no elevation brings the shell down on a target " + shortest(request.height_m) + " m above the muzzle.", "It is higher than the shell flies: choose a stronger charge or a lower target.");
  return aimer;
}

Shot Aimer::shotAt(double elevation_rad, double turn_rad) const {
  Shot shot;
  shot.speed_mps = request_.speed_mps;
  shot.elevation_rad = elevation_rad;
  shot.azimuth_rad = request_.azimuth_rad + turn_rad;
  // The air moves as it does; only the frame turns with the gun.
  shot.wind_mps = turn_rad == 0.0 ? request_.wind_mps : flightFromWorld(worldFromFlight(request_.wind_mps, request_.azimuth_rad), shot.azimuth_rad);
  shot.factors = request_.factors.at(elevation_rad);
  shot.muzzle_m = request_.muzzle_m;
  return shot;
}

bool Aimer::turningMatters() const { return !(request_.wind_mps == Vec3{}) || ballistics_.conditions().coriolis; }

double Aimer::rangeAt(double elevation_rad, double turn_rad, Flight& flight) const {
  flight = ballistics_.fly(shotAt(elevation_rad, turn_rad));
  return flight.end == FlightEnd::impact ? distance(flight) : kNoRange;
}

void Aimer::findMaximum() {
  // A target below may have to be fired at downwards.
  const double lowest = request_.height_m < 0.0 ? -0.49 * kPi : 0.0;
  std::array<Shot, kSamples> shots;
  std::array<Flight, kSamples> flights;
  for (std::size_t i = 0; i < kSamples; ++i) samples_.push_back({lowest + (kSteepest_rad - lowest) * static_cast<double>(i) / (kSamples - 1), kNoRange, 0.0});
  // Wind and Coriolis force act differently on a gun that is turned against the drift: a second pass flies it turned.
  for (int pass = 0; pass < (turningMatters() ? 2 : 1); ++pass) {
    for (std::size_t i = 0; i < kSamples; ++i) shots[i] = shotAt(samples_[i].elevation_rad, samples_[i].turn_rad);
    ballistics_.flyMany(shots, flights, 1);
    for (std::size_t i = 0; i < kSamples; ++i) {
      if (flights[i].end != FlightEnd::impact) continue;
      samples_[i].range_m = distance(flights[i]);
      if (turningMatters()) samples_[i].turn_rad = -offLine(flights[i]);
    }
  }

  narrowMaximum();
  std::ranges::sort(samples_, {}, &Sample::elevation_rad);
}

void Aimer::narrowMaximum() {
  const auto [a, b, c] = aroundBest();
  // Four flights about the top of the parabola cost little more than one; a second parabola through them is nearly exact.
  const double top = vertex(a, b, c);
  bool narrow = a.range_m > 0.0 && c.range_m > 0.0 && top > a.elevation_rad && top < c.elevation_rad;
  if (narrow) {
    constexpr double kApart_rad = 16.0 * kPi / 3200.0;
    std::array<Shot, 4> shots;
    std::array<Flight, 4> flights;
    std::array<double, 4> turns;
    for (std::size_t i = 0; i < 4; ++i) {
      const double e = std::clamp(top + (static_cast<double>(i) - 1.5) * kApart_rad, a.elevation_rad, std::min(c.elevation_rad, kSteepest_rad));
      turns[i] = b.turn_rad + (e - b.elevation_rad) * (c.turn_rad - a.turn_rad) / (c.elevation_rad - a.elevation_rad);
      shots[i] = shotAt(e, turns[i]);
    }
    ballistics_.flyMany(shots, flights, 1);
    for (std::size_t i = 0; i < 4; ++i)
      if (flights[i].end == FlightEnd::impact) samples_.push_back({shots[i].elevation_rad, distance(flights[i]), turns[i]});
    std::ranges::sort(samples_, {}, &Sample::elevation_rad);
    const auto same = [](const Sample& one, const Sample& next) { return one.elevation_rad == next.elevation_rad; };
    samples_.erase(std::unique(samples_.begin(), samples_.end(), same), samples_.end());
    narrow = samples_.size() == kSamples + 4;
  }
  searchMaximum(narrow ? 1 : 60);
}

std::array<Aimer::Sample, 3> Aimer::aroundBest() const {
  const auto best = static_cast<std::size_t>(std::ranges::max_element(samples_, {}, &Sample::range_m) - samples_.begin());
  return {samples_[best > 0 ? best - 1 : 0], samples_[best], samples_[std::min(best + 1, samples_.size() - 1)]};
}

/// Successive parabolas through the best sample and its neighbours; golden section where a parabola does not narrow the bracket.
void Aimer::searchMaximum(int flights) {
  auto [a, b, c] = aroundBest();
  Flight flight;
  for (int i = 0; i < flights && c.elevation_rad - a.elevation_rad > 1e-7; ++i) {
    const double ab = b.elevation_rad - a.elevation_rad, cb = c.elevation_rad - b.elevation_rad;
    double e = vertex(a, b, c);
    const bool usable = i % 4 != 3 && a.range_m > 0.0 && c.range_m > 0.0 && e > a.elevation_rad && e < c.elevation_rad && std::fabs(e - b.elevation_rad) > 1e-9;
    if (!usable) e = cb > ab ? b.elevation_rad + 0.381966 * cb : b.elevation_rad - 0.381966 * ab;
    const double turn = b.turn_rad + (e - b.elevation_rad) * (c.turn_rad - a.turn_rad) / (c.elevation_rad - a.elevation_rad);
    const double range = rangeAt(e, turn, flight);
    const Sample here{e, range, turn};
    const double gain = range - b.range_m;
    if (range > b.range_m) {
      (e > b.elevation_rad ? a : c) = b;
      b = here;
    } else {
      (e > b.elevation_rad ? c : a) = here;
    }
    // Near the top a parabola's step changes the range by less than the tolerance.
    if (usable && std::fabs(gain) < kMaximumTolerance_m && std::fabs(e - b.elevation_rad) < 0.02) break;
  }
  max_range_m_ = b.range_m;
  max_elevation_rad_ = b.elevation_rad;
  if (std::ranges::find(samples_, b.elevation_rad, &Sample::elevation_rad) == samples_.end()) samples_.push_back(b);
}

std::optional<AimSolution> Aimer::branch(double range_m, int direction) const {
  if (!(range_m > 0.0 && range_m <= max_range_m_)) return std::nullopt;
  const auto top = std::ranges::find(samples_, max_elevation_rad_, &Sample::elevation_rad) - samples_.begin();
  const auto count = static_cast<std::ptrdiff_t>(samples_.size());
  for (std::ptrdiff_t i = top + direction; i >= 0 && i < count; i += direction) {
    const Sample near = samples_[static_cast<std::size_t>(i)], far = samples_[static_cast<std::size_t>(i - direction)];
    if (near.range_m >= range_m) continue;
    // A parabola of the elevation over the range through a third sample comes close, away from the top where it turns.
    double guess = std::numeric_limits<double>::quiet_NaN();
    const std::ptrdiff_t third = near.range_m > 0.0 && i + direction >= 0 && i + direction < count ? i + direction : i - 2 * direction;
    if (near.range_m > 0.0 && third >= 0 && third < count && (third - top) * direction >= 0) {
      const Sample other = samples_[static_cast<std::size_t>(third)];
      if (other.range_m > 0.0) guess = parabola(range_m, near, far, other);
    }
    const auto [low, high] = std::minmax(near.elevation_rad, far.elevation_rad);
    if (!(guess > low && guess < high)) guess = std::numeric_limits<double>::quiet_NaN();
    return solve(range_m, near, far, guess);
  }
  return std::nullopt;
}

std::optional<AimSolution> Aimer::low(double range_m) const { return branch(range_m, -1); }
std::optional<AimSolution> Aimer::high(double range_m) const { return branch(range_m, 1); }

/// Elevation between one that falls short and one that reaches whose shell comes down at the range, by false position
/// (Illinois). The gun is turned as between the two samples; `first` is tried first where it is a number.
Aimer::Sample Aimer::root(double range_m, Sample a, Sample b, double first, Flight& flight) const {
  const double turn_at_a = a.turn_rad, turn_slope = (b.turn_rad - a.turn_rad) / (b.elevation_rad - a.elevation_rad), start = a.elevation_rad;
  double fa = a.range_m > 0.0 ? a.range_m - range_m : -range_m, fb = b.range_m - range_m;
  int side = 0;
  Sample here = b;
  for (int i = 0; i < 80; ++i) {
    double e = (a.elevation_rad * fb - b.elevation_rad * fa) / (fb - fa);
    if (i == 0 && first == first) e = first;
    // Where the near end never comes down there is a cliff, not a slope; and every fourth step halves for safety.
    else if (a.range_m < 0.0 || i % 4 == 3) e = 0.5 * (a.elevation_rad + b.elevation_rad);
    const double turn = turn_at_a + (e - start) * turn_slope;
    here = {e, rangeAt(e, turn, flight), turn};
    const double f = here.range_m - range_m;
    if (std::fabs(f) < kRangeTolerance_m || std::fabs(b.elevation_rad - a.elevation_rad) < 1e-12) break;
    if (f > 0.0) {
      b = here, fb = f;
      if (side == 1) fa *= 0.5;
      side = 1;
    } else {
      a = here, fa = f;
      if (side == -1) fb *= 0.5;
      side = -1;
    }
  }
  return here;
}

/// The same by secants from an elevation close by, for small changes after which the root may have left its bracket.
Aimer::Sample Aimer::polished(double range_m, Sample start, double turn_rad, Flight& flight) const {
  Sample before{start.elevation_rad + 1e-4, rangeAt(start.elevation_rad + 1e-4, turn_rad, flight), turn_rad};
  Sample here{start.elevation_rad, rangeAt(start.elevation_rad, turn_rad, flight), turn_rad};
  for (int i = 0; i < 8 && std::fabs(here.range_m - range_m) >= kRangeTolerance_m; ++i) {
    const double slope = (here.range_m - before.range_m) / (here.elevation_rad - before.elevation_rad);
    // At the very top there is no slope to follow; the round before was good enough then.
    const double step = std::clamp((range_m - here.range_m) / slope, -0.01, 0.01);
    if (!(std::fabs(step) > 1e-12)) break;
    before = here;
    here.elevation_rad += step;
    here.range_m = rangeAt(here.elevation_rad, turn_rad, flight);
  }
  return here;
}

std::optional<AimSolution> Aimer::solve(double range_m, Sample near, Sample far, double guess_rad) const {
  AimSolution solution;
  Flight flight;
  Sample found = root(range_m, near, far, guess_rad, flight);
  // The further rounds follow what turning the gun a little more changes through wind and Coriolis force.
  for (int round = 0; round < 8; ++round) {
    if (flight.end != FlightEnd::impact) return std::nullopt;
    const double off = offLine(flight), turn = turningMatters() ? found.turn_rad : -off;
    const Vec3 impact = worldFromFlight({flight.range_m, 0.0, flight.drift_m}, turn), target = worldFromFlight({range_m, 0.0, 0.0}, 0.0);
    const AimSolution here{shotAt(found.elevation_rad, turn), flight, turn, length(impact - target)};
    if (round == 0 || here.miss_m < solution.miss_m) solution = here;
    if (solution.miss_m < 2.0 * kRangeTolerance_m) break;
    found = polished(range_m, found, -off, flight);
  }
  return solution;
}

Expected<void> Aimer::checkReach(double range_m) const {
  if (!(range_m > 0.0)) return fail(ErrorKind::usage, "the range is " + shortest(range_m) + " m, but must be above 0.", "Give the horizontal distance to the target.");
  if (range_m <= max_range_m_) return {};
  const std::string limit = withDecimals(max_range_m_, 1), angle = withDecimals(max_elevation_rad_ * 3200.0 / kPi, 1);
  return fail(ErrorKind::usage, "a range of " + shortest(range_m) + " m is out of reach: the maximum is " + limit + " m, at " + angle + " mil.", "Choose a stronger charge or a nearer target.");
}

double legacyRange(double range_m, double step_m) { return step_m * std::floor(range_m / step_m + 0.5); }

}  // namespace npsee
