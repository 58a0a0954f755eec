#pragma once

#include <npsee/recording.h>

#include <cstddef>
#include <memory>
#include <optional>

namespace npsee {

/// What a person does during a mission. A mission is a function of (scenario, seed, commands). A command that cannot be obeyed (nobody of that name, a
/// vehicle that is destroyed, a mission that is not open or another observer's) changes nothing and is told by a `warning` of the log.
struct MissionCommand {
  enum class Kind {
    drive,         ///< vehicle: wished speed and turn rate
    take,          ///< a person takes over the observer or vehicle `who`
    release,       ///< and hands it back
    call_for_fire, ///< observer `who` calls fire with `method` on `target`, a vehicle that he sees or has seen, or on `place` where that is empty
    correct,       ///< spotting correction of `who` for his `mission`: right and add, m, in the observer-target frame
    fire_for_effect,
    end_mission,
    shoot,         ///< direct fire of vehicle `who` at `place`
  };
  double t_s = 0.0;
  Kind kind = Kind::drive;
  std::string who;
  double speed_mps = 0.0, turn_radps = 0.0;
  Place place;
  std::string target;
  FireMethod method = FireMethod::automatic;
  int mission = 0;
  double right_m = 0.0, add_m = 0.0;
  std::string description;   ///< of the target, for the log
  friend bool operator==(const MissionCommand&, const MissionCommand&) = default;
};

/// What the recording of a mission may hold. A mission that would need more ends there with an `error` event that names the limit; so memory is
/// bounded, to some 2 GB with the defaults, and the same limits give the same log.
struct MissionLimits {
  std::size_t legs = 8'000'000;    ///< of all vehicles, about 70 bytes each; a meandering vehicle drives some 7,000 a day
  std::size_t shells = 100'000;    ///< fired, some kB each
  std::size_t events = 1'000'000;  ///< in the log, about 0.5 kB each
  std::size_t beliefs = 8'000'000; ///< of all observers, about 80 bytes each
};

/// Simulates a mission in ticks of kMissionTick_s. Same scenario, seed and commands: same log and same recording, bit for bit.
class Mission {
 public:
  /// Reads what the scenario names (weapons, facts, rules, terrain) and sets everything up. Error kind input: any of them is
  /// broken; then nothing is simulated.
  static Expected<Mission> make(const Scenario& scenario, const MissionLimits& limits = {});
  ~Mission();
  Mission(Mission&&) noexcept;
  Mission& operator=(Mission&&) noexcept;

  /// Simulates up to a time (s), at most the scenario's duration; at the end the `end` event closes the log.
  void advance(double until_s);
  /// A command for the tick at its time; times already simulated count as now.
  void command(const MissionCommand& command);
  double now() const;
  bool finished() const;
  /// Grows while the mission advances.
  const Recording& recording() const;
  /// Moves the recording out; the mission is then over.
  Recording take();

 private:
  struct State;
  explicit Mission(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Simulates a whole mission, or up to `until_s` (s). Errors as of Mission::make. Thread-safe: missions are independent.
Expected<Recording> runMission(const Scenario& scenario, std::optional<double> until_s = {}, const std::vector<MissionCommand>& commands = {}, const MissionLimits& limits = {});

/// The clauses of the scenario's `expect` that the log does not meet, as sentences naming file line and clause. Empty = all met.
std::vector<std::string> unmetExpectations(const Recording& recording);

}  // namespace npsee
