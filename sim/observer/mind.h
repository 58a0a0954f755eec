#pragma once

#include <npsee/error.h>
#include <npsee/scenario.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace npsee::observer {

/// The rule-driven part of a forward observer: facts go in when they change, decisions come out. Everything that is arithmetic on
/// the world (sight, beliefs, ballistics) is done outside; bracketing, choice of target and method, and ending a mission are rules
/// (assets/rules/observer.clp), so that users can change them.

/// A vehicle the observer knows of.
struct Contact {
  int id = -1;                 ///< index of the vehicle in the recording
  int type = 0;
  std::string type_name;
  double x_m = 0.0, z_m = 0.0; ///< where he believes it to be
  double range_m = 0.0;        ///< from him
  double azimuth_mil = 0.0;    ///< from him
  double speed_mps = 0.0;
  double location_error_m = 0.0;  ///< circular error probable of x and z, as he judges it; 0 = certain
  double hostile = 1.0, friendly = 0.0;  ///< beliefs
  enum class Condition { whole, damaged, suppressed, destroyed } condition = Condition::whole;
  bool seen = true;            ///< in sight now
  double friendly_distance_m = 1e9;  ///< of the nearest known friendly from it (danger close)
};

/// A fire mission as he knows it.
struct MissionFact {
  enum class State {
    refused,     ///< the fire direction centre could not do it; `reason`
    accepted,    ///< being computed, laid and fired; wait
    splash,      ///< rounds have landed, a Spot follows if they were seen
    effect,      ///< fire for effect under way
    effect_over, ///< all rounds of fire for effect have landed
    ended,
  };
  int mission = 0;             ///< number, from 1
  int contact = -1;
  State state = State::accepted;
  FireMethod method = FireMethod::adjust_fire;  ///< never automatic
  int rounds = 0;              ///< adjusting rounds spotted so far
  bool danger_close = false;
  double ot_distance_m = 0.0;  ///< observer to target
  std::string reason;
};

/// What he saw of a burst, in his own frame: along the observer-target line and across it.
struct Spot {
  int mission = 0;
  int round = 0;
  bool observed = true;        ///< false: lost (masked or in the fog)
  double lateral_mil = 0.0;    ///< burst right of the target positive
  double range_m = 0.0;        ///< sensed: beyond the target (over) positive, short negative
};

struct SelfFacts {
  double x_m = 0.0, z_m = 0.0;
  int type = 0;
  double max_range_m = 4000.0;
  bool moving = false;
  bool night = false;
  FireMethod method = FireMethod::automatic;
  bool self_preservation = true;
};

struct Decision {
  enum class Kind {
    call,            ///< fire mission on `contact` with `method`
    correct,         ///< `mission`: right_m and add_m in the observer-target frame, then one more adjusting round
    fire_for_effect, ///< `mission`, with a last correction right_m, add_m
    end,             ///< `mission`, with `reason`
    withdraw,        ///< self-preservation: leave this place
    warn,            ///< `reason` for the log
  };
  Kind kind = Kind::warn;
  int contact = -1, mission = 0;
  FireMethod method = FireMethod::adjust_fire;
  double right_m = 0.0, add_m = 0.0;
  std::string reason;
  std::string rule;                ///< that fired
  std::vector<std::string> facts;  ///< it fired on, as text: "(contact (id 3) ...)"
};

struct MindSetup {
  std::string rules;               ///< text of own rules or facts; may be empty
  std::string rules_name;          ///< file name for messages
  bool shipped_rules = true;
  std::vector<MissionOrder> orders;
  double danger_close_m = 600.0;
  double hostile_belief = 0.6;     ///< from which a contact counts as hostile, or as friendly
  int max_missions = 1;            ///< open at a time; more only with more batteries
};

/// One CLIPS environment. Not thread-safe; different minds are independent.
class Mind {
 public:
  /// Error kind input with file and line: the rules are broken or use what is not allowed; nothing is kept of them.
  static Expected<Mind> make(const MindSetup& setup);
  ~Mind();
  Mind(Mind&&) noexcept;
  Mind& operator=(Mind&&) noexcept;

  void self(const SelfFacts& self);
  /// New or changed. Rules are not told of changes too small to matter to them (20 m of place or range, 20 mil, 1 m/s, 0.02 of
  /// belief, unless a limit they compare with is crossed), so that it may be called for every contact at every tick.
  void contact(const Contact& contact);
  void forget(int contact);
  void mission(const MissionFact& mission);    ///< new or changed
  void spot(const Spot& spot);
  void incoming(double distance_m);            ///< a hostile burst or shot was noticed this far away
  /// Runs the rules to completion and appends their decisions, in order. Error kind input: a rule failed, or the limit of
  /// firings or of memory or the watchdog stopped them; the mission must then end.
  Expected<void> think(std::vector<Decision>& decisions);
  /// For the editor and tests: facts now, as text; and the last rule that fired.
  std::vector<std::string> facts() const;
  std::string lastRule() const;

 private:
  struct Data;
  explicit Mind(std::unique_ptr<Data> data);
  std::unique_ptr<Data> data_;
};

/// The thesis's facts file (appendix B.C): bare facts, or wrapped in deffacts.
struct ObserverFacts {
  bool has_observer = false;
  Place observer;
  int mounted_on = 8;
  std::vector<MissionOrder> missions;
  std::vector<GunSetup> guns;
  bool only_facts = true;          ///< nothing else stands in the file
  std::vector<Fault> warnings;     ///< e.g. bare facts were wrapped
};
/// Error kind input with file and line.
Expected<ObserverFacts> parseObserverFacts(std::string_view text, std::string_view file);

/// Checks a rules file without a mission (`npsee check`): every fault with file and line. Empty = loads and runs.
std::vector<Fault> checkRules(std::string_view text, std::string_view file);

}  // namespace npsee::observer
