#pragma once

#include <npsee/recording.h>
#include <npsee/units.h>

#include <cstddef>
#include <string>
#include <vector>

namespace npsee::editor {

inline constexpr double kMilPerRad = 6400.0 / kTwoPi;

/// A readable sentence for a line of the event log: who, what, with figures rounded for people, e.g. "gun2 fires shell 7 at t72-1,
/// low, elevation 349 mil, azimuth 1600 mil."
std::string eventSentence(const MissionEvent& event);
/// Why it happened, where a rule decided it: the rule and the facts it fired on, one per line. Empty otherwise.
std::string eventReason(const MissionEvent& event);
/// "Danger close", "End of mission": the kind for people.
std::string eventTitle(EventKind kind);

/// True for events that stand on the time line as marks; the rest (contacts, solutions, apexes) would hide them.
bool marked(EventKind kind);

/// "12.5 s", "3:05.2": a moment of the mission.
std::string momentText(double time_s);
/// Metres as people read them: "850 m", "12.4 km".
std::string distanceText(double metres);
/// "right 40, add 200", "drop 100", "repeat": a correction.
std::string correctionText(double right_m, double add_m);
/// "24950 13200": x and z as whole metres.
std::string placeText(double x_m, double z_m);

/// Which events the log lists.
struct EventFilter {
  std::vector<bool> kinds = std::vector<bool>(static_cast<std::size_t>(kEventKinds), true);
  std::string word;  ///< in the sentence, upper or lower case
  bool lists(const MissionEvent& event) const;
  friend bool operator==(const EventFilter&, const EventFilter&) = default;
};

/// Index of the first event after a moment.
std::size_t eventsUntil(const std::vector<MissionEvent>& events, double time_s);

/// Everything that the log calls the object by, so that its events can be found: true if the event names `id`.
bool names(const MissionEvent& event, const std::string& id);

}  // namespace npsee::editor
