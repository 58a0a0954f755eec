#pragma once

#include <npsee/aiming.h>
#include <npsee/recording.h>

#include <memory>
#include <string>
#include <vector>

namespace npsee::observer {

/// The fire direction centre's arithmetic for one battery: elevation and azimuth that hit a place on the real terrain, checked by
/// flying the shell over it with the same integrator that flies the shot.

struct FireRequest {
  Vec3 muzzle_m;
  Vec3 target_m;                   ///< on the ground
  Vec3 target_velocity_mps;        ///< zero, or led if the setup leads
  double delay_s = 0.0;            ///< until the shot, for the lead
  TrajectoryChoice trajectory = TrajectoryChoice::automatic;  ///< low and high are flown even where masked, with `masked` set
  bool illumination = false;       ///< burst over the target instead of on it
  double burst_height_m = 0.0;
};

/// Why there is no solution; the words of the log's `reason`.
enum class Refusal {
  none,
  out_of_range,    ///< beyond the greatest range of every charge
  too_close,       ///< below the least range (elevation or arming)
  masked,          ///< ground in the way on every allowed trajectory
  elevation,       ///< beyond what the gun can elevate
  in_sea,          ///< the gun stands in the sea
  no_convergence,
};
std::string_view refusalWord(Refusal refusal);   ///< "out_of_range", ...

struct FireSolution {
  Refusal refusal = Refusal::none;
  std::string reason;              ///< full sentence with figures, for the log
  bool high = false;
  bool masked = false;             ///< forced, and lands before the target
  int charge = 0;                  ///< index of the battery's charges
  Shot shot;                       ///< elevation, azimuth, wind, factors, muzzle
  double time_of_flight_s = 0.0, apex_m = 0.0;
  Vec3 aim_m;                      ///< with the lead
  Vec3 impact_m;                   ///< where this shot comes down, without dispersion
  std::uint32_t doubts = doubt_none;
  /// Tried and rejected before this one, e.g. the low trajectory as masked: kind and sentence.
  struct Rejected { bool high = false; Refusal refusal = Refusal::none; double elevation_rad = 0.0; std::string reason; };
  std::vector<Rejected> rejected;
  double elevation_mil() const { return shot.elevation_rad * 6400.0 / kTwoPi; }
  double azimuth_mil() const { return shot.azimuth_rad * 6400.0 / kTwoPi; }
};

class FireDirection {
 public:
  /// Error kind input: the projectile or charge is unknown, the weapon has no such numbers.
  static Expected<FireDirection> make(const BatterySetup& battery, const Weapon& weapon, const Terrain& terrain, const Weather& weather, const FdcSetup& fdc);
  ~FireDirection();
  FireDirection(FireDirection&&) noexcept;
  FireDirection& operator=(FireDirection&&) noexcept;

  FireSolution solve(const FireRequest& request) const;

  /// The shell as it flies: the solution's shot with the gun's dispersion (two standard normal draws, along and across, scaled by
  /// the probable errors: sigma = PE / 0.6745) and a laying error, flown over the terrain with dense output. The dispersed shell
  /// lands displaced by exactly those distances on level ground: the shot is solved for the displaced aim point.
  FlightPath fly(const FireSolution& solution, double along_sigma, double across_sigma, double lay_error_rad = 0.0) const;

  const std::vector<Charge>& charges() const;
  double maxRange() const;         ///< on level ground, m, over all charges
  std::vector<Fault> warnings() const;  ///< e.g. the weapon's `range` is not reachable

 private:
  struct Data;
  std::unique_ptr<Data> data_;
  explicit FireDirection(std::unique_ptr<Data> data);
};

/// One gun: where its tube points, when it may fire next, what it has left. Times are mission times.
class Gun {
 public:
  Gun(const GunSetup& setup, const BatterySetup& battery, Vec3 muzzle_m, double first_azimuth_rad);
  bool empty() const { return rounds_ == 0; }
  int rounds() const { return rounds_; }
  /// Starts laying; returns when the tube stands.
  double lay(double now_s, double azimuth_rad, double elevation_rad, std::vector<LayStep>& lays);
  /// Earliest moment of the next shot if it is laid at `laid_s`.
  double readyAt(double laid_s) const;
  void fired(double time_s);
  Vec3 muzzle() const { return muzzle_m_; }
 private:
  GunSetup setup_;
  Vec3 muzzle_m_;
  double lay_time_s_ = 0.0, reload_time_s_ = 0.0, laid_until_s_ = 0.0, loaded_at_s_ = 0.0;
  double azimuth_rad_ = 0.0, elevation_rad_ = 0.0;  ///< of the last order
  int rounds_ = 0;
};

}  // namespace npsee::observer
