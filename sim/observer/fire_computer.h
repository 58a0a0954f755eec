#pragma once

#include "sim/observer/fire_charges.h"
#include "sim/observer/fire_direction.h"

#include <map>
#include <optional>

namespace npsee::observer {

/// What shells fall on: the ground, and the sea where it is higher.
class Surface final : public Ground {
 public:
  explicit Surface(Terrain terrain) : terrain_(std::move(terrain)) {}
  double height(double x_m, double z_m) const override { return terrain_.surface(x_m, z_m); }
  double detail() const override { return terrain_.detail(); }
  bool flat() const override { return terrain_.flat(); }
  const Terrain& terrain() const { return terrain_; }

 private:
  Terrain terrain_;
};

/// "1234 m", to the nearest metre.
std::string metres(double value);

/// The arithmetic behind FireDirection. Not thread-safe: it remembers what it computed, without any effect on results.
class FireComputer {
 public:
  FireComputer(const BatterySetup& battery, const Weapon& weapon, const Terrain& terrain, const Weather& weather, const FdcSetup& fdc, Ammunition ammunition);
  /// Finds the greatest ranges. Error kind input: the projectile does not fly.
  Expected<void> prepare();

  FireSolution solve(const FireRequest& request);
  FlightPath fly(const FireSolution& solution, double along_sigma, double across_sigma, double lay_error_rad);

  const std::vector<Charge>& charges() const { return ammunition_.charges; }
  double maxRange() const { return max_range_m_; }
  const std::vector<Fault>& warnings() const { return ammunition_.warnings; }

 private:
  /// One charge and branch tried on a request.
  struct Attempt {
    Refusal refusal = Refusal::none;
    std::string reason;
    bool masked = false;         ///< comes down before the target; `refusal` is then what it would be if that were not allowed
    bool hopeless = false;       ///< no other charge or branch will do either
    AimSolution aim;
    double bearing_rad = 0.0, distance_m = 0.0;
    Vec3 aim_m, laid_m;          ///< the two differ for a gun with a table of ranges
    Vec3 impact_m;
    double time_of_flight_s = 0.0;
    Flight flight;               ///< over the ground
  };
  struct Line {
    double distance_m = 0.0, azimuth_rad = 0.0, height_m = 0.0;
  };
  /// The shell under one gun's air.
  struct Site {
    Ballistics flat, over_ground;
  };
  struct AimerKey {
    std::size_t charge = 0;
    double muzzle_y_m = 0.0, height_m = 0.0;
    Vec3 wind_mps;
    friend bool operator==(const AimerKey&, const AimerKey&) = default;
  };
  struct CachedAimer {
    AimerKey key;
    Aimer aimer;
  };

  const Site& site(double muzzle_y_m);
  const Aimer* aimer(std::size_t charge, const Vec3& muzzle_m, const Line& line);
  Line lineTo(const Vec3& muzzle_m, const Vec3& point_m) const;
  Vec3 onSurface(const Vec3& point_m, const FireRequest& request) const;
  Vec3 laidPoint(const FireRequest& request, const Vec3& aim_m) const;
  bool reaches(std::size_t charge, const FireRequest& request) const;
  Attempt attempt(const FireRequest& request, std::size_t charge, bool high);
  bool aimAt(const FireRequest& request, std::size_t charge, bool high, const Vec3& aim_m, Attempt& out);
  bool followLead(const FireRequest& request, std::size_t charge, bool high, Attempt& out);
  void checkElevation(std::size_t charge, bool high, Attempt& out) const;
  void flyOver(const FireRequest& request, std::size_t charge, bool high, Attempt& out);
  FireSolution accepted(const Attempt& attempt, std::size_t charge, bool high) const;
  std::string farText(const FireRequest& request) const;
  Shot displaced(const FireSolution& solution, double along_m, double across_m);

  BatterySetup battery_;
  Weapon weapon_;
  Weather weather_;
  FdcSetup fdc_;
  Ammunition ammunition_;
  std::shared_ptr<const Surface> surface_;
  std::vector<double> reach_m_;     ///< of each charge on level ground
  double max_range_m_ = 0.0;
  double range_limit_m_ = 0.0;      ///< the weapon's stated range, where it is the lower; else beyond everything
  double mask_tolerance_m_ = 0.0;
  std::map<double, Site> sites_;    ///< by height of the muzzle
  std::vector<CachedAimer> aimers_; ///< used in turn
  std::size_t next_aimer_ = 0;
};

}  // namespace npsee::observer
