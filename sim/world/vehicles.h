#pragma once

#include <npsee/recording.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace npsee::world {

/// All vehicles of a mission: poses as tracks of legs, behaviours that decide only when a leg ends, something happens, or their
/// look-ahead says so. A vehicle costs nothing in a tick in which it decides nothing.
class Vehicles {
 public:
  /// Fills `records` (one per vehicle of the scenario, then those of its groups, in order, then one per observer without a vehicle
  /// of his own) and remembers them; `records` must outlive this. Random groups are placed on land. Error kind input: a place in the sea
  /// or outside the world.
  static Expected<Vehicles> make(const Scenario& scenario, const Terrain& terrain, std::vector<VehicleRecord>& records);
  ~Vehicles();
  Vehicles(Vehicles&&) noexcept;
  Vehicles& operator=(Vehicles&&) noexcept;

  /// Decisions due at this tick; `tick` counts from 0, time = tick * kMissionTick_s. In order of index.
  void step(std::int64_t tick);

  /// Poses at the last step, structure of arrays, for sensing and impacts.
  const std::vector<double>& x() const; const std::vector<double>& z() const; const std::vector<double>& speed() const;
  Vec3 velocity(std::size_t vehicle) const;
  /// Legs written to the records so far, for the mission's limit.
  std::size_t legs() const;

  /// The vehicle notices fire (burst within a weapon's knowledge radius, or it was shot at) from a place; reacts by its setup.
  /// Returns true if it wants to shoot back at `from` (return fire), which the mission then does.
  bool noticesFire(std::size_t vehicle, std::int64_t tick, const Place& from);
  void withdraw(std::size_t vehicle, std::int64_t tick, const Place& from);  ///< leaves the place at high speed
  void immobilise(std::size_t vehicle, std::int64_t tick);                   ///< mobility kill or destroyed: stops
  void drive(std::size_t vehicle, std::int64_t tick, double speed_mps, double turn_radps);  ///< by a person
  void hand(std::size_t vehicle, std::int64_t tick, bool to_person);         ///< a person takes over or hands back

 private:
  struct State;
  explicit Vehicles(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Graded damage of one burst to one target: the state after it, given the state before (hull accumulates, 1 = destroyed; mobility
/// and firepower stay lost). A weapon whose target type does not fit does less. Draws come from (seed, vehicle, Purpose::damage,
/// count). Game values, nothing operational. The numbers: the table in damage.cpp.
DamageStep harmed(const Weapon& weapon, TargetClass target, double miss_m, const DamageStep& earlier, std::int64_t seed, std::uint32_t vehicle, std::uint32_t count, double time_s);

}  // namespace npsee::world
