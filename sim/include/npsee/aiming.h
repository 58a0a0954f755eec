#pragma once

#include <npsee/ballistics.h>

#include <array>
#include <optional>
#include <vector>

namespace npsee {

/// What is to be hit, and with what. The line to the target is the line of fire before any correction.
struct AimRequest {
  double speed_mps = 0.0;
  FactorCurves factors;        ///< fitting factors; they follow the elevation while it is sought
  double azimuth_rad = 0.0;    ///< bearing of the target from the muzzle, clockwise from north
  Vec3 wind_mps;               ///< velocity of the air along (to the target, up, right of the line to it)
  double height_m = 0.0;       ///< of the target above the muzzle
  Vec3 muzzle_m;
};

/// An elevation and azimuth that hit.
struct AimSolution {
  Shot shot;                       ///< elevation, corrected azimuth, wind in that frame
  Flight flight;                   ///< as flown with it
  double azimuth_correction_rad = 0.0;  ///< to the right of the bearing of the target; against drift, hence mostly left
  double miss_m = 0.0;             ///< horizontal distance of the impact from the target
};

/// Finds elevations for ranges. Made once for a charge, height and wind; each solution then costs a few flights.
///
/// The horizontal distance R of the impact rises with the elevation up to one maximum and falls beyond it. A coarse sample brackets
/// it, golden section with parabolas finds the maximum, and false position (Illinois) the roots on both sides; the tolerance is
/// one of range, not of elevation, because dR/dQE vanishes at the maximum.
class Aimer {
 public:
  /// Whether a request makes sense: its height within 20 km of the muzzle (m), a shot that is possible. Error kind usage, with every fault. A target that
  /// is too high or too far may make sense; make() and checkReach() tell of that.
  static Expected<void> check(const Ballistics& ballistics, const AimRequest& request);

  /// Uses the projectile, model, atmosphere, gravity and integration of `ballistics`; its own target height and ground are not
  /// used. Error kind usage: check() refuses the request, or nothing comes down at that height.
  static Expected<Aimer> make(const Ballistics& ballistics, const AimRequest& request);

  /// Greatest horizontal distance, m, and the elevation that gives it.
  double maxRange() const { return max_range_m_; }
  double maxRangeElevation() const { return max_elevation_rad_; }  ///< rad

  /// Solution below, or above, the elevation of greatest range; nothing where that branch does not reach the distance.
  std::optional<AimSolution> low(double range_m) const;
  std::optional<AimSolution> high(double range_m) const;

  /// Error kind usage with the greatest range named, if the distance is beyond it; else nothing to say.
  Expected<void> checkReach(double range_m) const;

 private:
  struct Sample {
    double elevation_rad = 0.0, range_m = 0.0;
    double turn_rad = 0.0;  ///< of the gun to the right of the target's bearing
  };
  Aimer(Ballistics ballistics, AimRequest request);
  Shot shotAt(double elevation_rad, double turn_rad) const;
  double rangeAt(double elevation_rad, double turn_rad, Flight& flight) const;
  void findMaximum();
  void narrowMaximum();
  void searchMaximum(int flights);
  std::array<Sample, 3> aroundBest() const;
  bool turningMatters() const;
  /// The branch below (-1) or above (1) the elevation of greatest range.
  std::optional<AimSolution> branch(double range_m, int direction) const;
  Sample root(double range_m, Sample near, Sample far, double first, Flight& flight) const;
  Sample polished(double range_m, Sample start, double turn_rad, Flight& flight) const;
  std::optional<AimSolution> solve(double range_m, Sample near, Sample far, double guess_rad) const;

  Ballistics ballistics_;
  AimRequest request_;
  std::vector<Sample> samples_;  ///< by elevation
  double max_range_m_ = 0.0, max_elevation_rad_ = 0.0;
};

/// The thesis's howitzers could only be laid for multiples of this range; its "range resolution".
inline constexpr double kLegacyRangeStep_m = 250.0;
/// The range a gun with a table of such steps is laid for.
double legacyRange(double range_m, double step_m = kLegacyRangeStep_m);

}  // namespace npsee
