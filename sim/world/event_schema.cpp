// What events there are and what they carry, in the order in which it is written. This table is the schema of the log: the
// documentation is printed from it, and tests hold every mission's events against it.

#include <npsee/recording.h>

namespace npsee {
namespace {

constexpr std::string_view kNames[] = {"contact", "lost", "call", "solution", "refuse", "fire", "apex", "detonation", "spot", "correction", "damage", "destroyed", "danger_close", "warning", "end_of_mission", "error", "end"};
static_assert(sizeof kNames / sizeof kNames[0] == kEventKinds);

// Types: id (text, of a vehicle, gun, observer or battery), number, whole, text, bool, place ([x, y, z]), texts (list).
// A key whose explanation ends with "if any" or "left out otherwise" is not written where there is nothing to say.
constexpr EventKey kKeys[] = {
    {"contact", "observer", "id", "", "who sees it"},
    {"contact", "target", "id", "", "the vehicle seen"},
    {"contact", "type", "text", "", "name of the vehicle's type"},
    {"contact", "type_index", "whole", "", "its number, as in (mission destroy 51)"},
    {"contact", "position", "place", "m", "where he believes it to be"},
    {"contact", "range_m", "number", "m", "from him to it"},
    {"contact", "azimuth_mil", "number", "mil", "from him to where he believes it, clockwise from north"},
    {"contact", "belief", "number", "", "that it is hostile, 0 to 1"},
    {"contact", "conflict", "number", "", "of the evidence, 0 to 1"},

    {"lost", "observer", "id", "", "who saw it"},
    {"lost", "target", "id", "", "the vehicle"},
    {"lost", "position", "place", "m", "where he believes it to be"},
    {"lost", "reason", "text", "", "why it is no longer seen"},

    {"call", "observer", "id", "", "who calls for fire"},
    {"call", "mission", "whole", "", "number of the fire mission, from 1"},
    {"call", "target", "id", "", "the vehicle it is for, if any"},
    {"call", "method", "text", "", "adjust_fire, fire_for_effect, suppress, immediate_suppression, smoke or illuminate"},
    {"call", "position", "place", "m", "of the target as called"},
    {"call", "range_m", "number", "m", "from the observer to there"},
    {"call", "danger_close", "bool", "", "friendly vehicles are near the target"},
    {"call", "text", "text", "", "the target in words, or the reason, if any"},
    {"call", "rule", "text", "", "that decided it; \"person\" where a person did"},
    {"call", "facts", "texts", "", "the rule fired on"},

    {"solution", "mission", "whole", "", "number of the fire mission"},
    {"solution", "battery", "id", "", "that fires"},
    {"solution", "gun", "id", "", "it is for"},
    {"solution", "target", "id", "", "the vehicle aimed at, if any"},
    {"solution", "trajectory", "text", "", "low or high; direct for weapons that shoot straight"},
    {"solution", "charge", "text", "", "name of the charge; - where there is none"},
    {"solution", "qe_mil", "number", "mil", "quadrant elevation"},
    {"solution", "azimuth_mil", "number", "mil", "of the tube, clockwise from north"},
    {"solution", "tof_s", "number", "s", "time of flight"},
    {"solution", "apex_m", "number", "m", "greatest height over the muzzle"},
    {"solution", "range_m", "number", "m", "from the gun to the aim point"},
    {"solution", "aim", "place", "m", "aim point, with the lead"},
    {"solution", "angle_t_mil", "number", "mil", "between the observer-target and gun-target lines"},
    {"solution", "large_angle_t", "bool", "", "true: 500 mil or more; left out otherwise"},
    {"solution", "masked", "bool", "", "true: forced, comes down before the target; left out otherwise"},
    {"solution", "doubt", "texts", "", "what lies beyond the trajectory model's validity, if any"},
    {"solution", "rejected", "texts", "", "what was tried before and why it did not do, if any"},

    {"refuse", "mission", "whole", "", "number of the fire mission"},
    {"refuse", "battery", "id", "", "that refuses"},
    {"refuse", "gun", "id", "", "that refuses, where it is a single one; if any"},
    {"refuse", "target", "id", "", "the vehicle, if any"},
    {"refuse", "trajectory", "text", "", "low or high, if any"},
    {"refuse", "qe_mil", "number", "mil", "quadrant elevation that would be needed, if any"},
    {"refuse", "reason", "text", "", "out_of_range, too_close, masked, elevation, in_sea or no_convergence; no_ammunition for guns"},
    {"refuse", "text", "text", "", "the reason as a sentence, and what to do"},

    {"fire", "shell", "whole", "", "number of the shell, from 1"},
    {"fire", "gun", "id", "", "or vehicle that fires"},
    {"fire", "mission", "whole", "", "number of the fire mission, 0 for direct fire"},
    {"fire", "target", "id", "", "the vehicle aimed at, if any"},
    {"fire", "trajectory", "text", "", "low, high or direct"},
    {"fire", "weapon", "whole", "", "number in weapons.dat"},
    {"fire", "position", "place", "m", "of the muzzle"},
    {"fire", "qe_mil", "number", "mil", "quadrant elevation, if any"},
    {"fire", "azimuth_mil", "number", "mil", "of the tube, clockwise from north"},
    {"fire", "rounds_left", "whole", "", "of the gun, if any"},
    {"fire", "lay_error_mil", "number", "mil", "by which the gun was laid wrongly, right positive, if any"},

    {"apex", "shell", "whole", "", "number of the shell"},
    {"apex", "mission", "whole", "", "number of the fire mission"},
    {"apex", "position", "place", "m", "highest point of its path"},

    {"detonation", "shell", "whole", "", "number of the shell"},
    {"detonation", "gun", "id", "", "or vehicle that fired it"},
    {"detonation", "mission", "whole", "", "number of the fire mission, 0 for direct fire"},
    {"detonation", "target", "id", "", "the vehicle aimed at, if any"},
    {"detonation", "position", "place", "m", "of the burst"},
    {"detonation", "miss_m", "number", "m", "horizontal distance to where the target is then, or to the place aimed at"},
    {"detonation", "weapon", "whole", "", "number in weapons.dat"},
    {"detonation", "illumination", "bool", "", "true: it lights the ground; left out otherwise"},
    {"detonation", "smoke", "bool", "", "true: it lays smoke; left out otherwise"},

    {"spot", "observer", "id", "", "who spots the burst"},
    {"spot", "mission", "whole", "", "number of the fire mission"},
    {"spot", "round", "whole", "", "adjusting round, from 1"},
    {"spot", "shell", "whole", "", "number of the shell"},
    {"spot", "target", "id", "", "the vehicle it is for, if any"},
    {"spot", "observed", "bool", "", "false: he did not see it"},
    {"spot", "lateral_mil", "number", "mil", "burst right of the target positive, if any"},
    {"spot", "range_m", "number", "m", "burst beyond the target positive, if any"},

    {"correction", "observer", "id", "", "who corrects"},
    {"correction", "mission", "whole", "", "number of the fire mission"},
    {"correction", "target", "id", "", "the vehicle it is for, if any"},
    {"correction", "round", "whole", "", "adjusting round it follows"},
    {"correction", "right_m", "number", "m", "right of the observer-target line, left negative"},
    {"correction", "add_m", "number", "m", "along it, drop negative"},
    {"correction", "method", "text", "", "adjust_fire, or fire_for_effect where effect follows"},
    {"correction", "position", "place", "m", "aim point after it"},
    {"correction", "aim_error_m", "number", "m", "of that from the target, if any"},
    {"correction", "misheard", "text", "", "what became of it on the way to the guns, if any"},
    {"correction", "automatic_right_m", "number", "m", "what the rules would have said to a person's burst, if any"},
    {"correction", "automatic_add_m", "number", "m", "likewise along the line, if any"},
    {"correction", "grade_m", "number", "m", "distance of a person's correction from it, if any"},
    {"correction", "rule", "text", "", "that decided it"},
    {"correction", "facts", "texts", "", "the rule fired on"},

    {"damage", "target", "id", "", "the vehicle"},
    {"damage", "shell", "whole", "", "that did it"},
    {"damage", "mission", "whole", "", "number of the fire mission, 0 for direct fire"},
    {"damage", "position", "place", "m", "of the vehicle"},
    {"damage", "miss_m", "number", "m", "distance of the burst"},
    {"damage", "hull", "number", "", "damage so far; 1 is destroyed"},
    {"damage", "mobility", "bool", "", "it can still move"},
    {"damage", "firepower", "bool", "", "it can still shoot"},

    {"destroyed", "target", "id", "", "the vehicle"},
    {"destroyed", "shell", "whole", "", "that did it"},
    {"destroyed", "mission", "whole", "", "number of the fire mission, 0 for direct fire"},
    {"destroyed", "position", "place", "m", "of the vehicle"},
    {"destroyed", "miss_m", "number", "m", "distance of the burst"},

    {"danger_close", "observer", "id", "", "who calls the mission"},
    {"danger_close", "mission", "whole", "", "number of the fire mission"},
    {"danger_close", "target", "id", "", "the vehicle it is for, if any"},
    {"danger_close", "friendly", "id", "", "the friendly vehicle nearest to it"},
    {"danger_close", "distance_m", "number", "m", "of the two"},

    {"warning", "battery", "id", "", "it is about, if any"},
    {"warning", "gun", "id", "", "it is about, if any"},
    {"warning", "observer", "id", "", "it is about, if any"},
    {"warning", "mission", "whole", "", "it is about, if any"},
    {"warning", "target", "id", "", "it is about, if any"},
    {"warning", "position", "place", "m", "where, if any"},
    {"warning", "text", "text", "", "what is allowed but doubtful, or worth knowing"},
    {"warning", "rule", "text", "", "that decided it, if any"},
    {"warning", "facts", "texts", "", "the rule fired on, if any"},

    {"end_of_mission", "observer", "id", "", "who ends it"},
    {"end_of_mission", "mission", "whole", "", "number of the fire mission"},
    {"end_of_mission", "target", "id", "", "the vehicle it was for, if any"},
    {"end_of_mission", "result", "text", "", "destroyed, neutralised, suppressed, no_effect, refused, ..."},
    {"end_of_mission", "reason", "text", "", "why it ends"},
    {"end_of_mission", "rounds", "whole", "", "fired in it"},
    {"end_of_mission", "adjusting", "whole", "", "of these to adjust, one for each volley"},
    {"end_of_mission", "volleys", "whole", "", "fired for effect"},
    {"end_of_mission", "aim_error_m", "number", "m", "of the last aim point from the target, if any"},
    {"end_of_mission", "grade", "text", "", "of the adjustment: good within 50 m in at most three rounds, slow within 50 m, else off; if any"},
    {"end_of_mission", "lasted_s", "number", "s", "since the call"},
    {"end_of_mission", "rule", "text", "", "that decided it, if any"},
    {"end_of_mission", "facts", "texts", "", "the rule fired on, if any"},

    {"error", "text", "text", "", "why the mission was given up"},
    {"error", "observer", "id", "", "whose rules failed, if any"},

    {"end", "hash", "text", "", "of all lines before"},
    {"end", "events", "whole", "", "number of lines before"},
    {"end", "shells", "whole", "", "fired in all"},
    {"end", "destroyed", "whole", "", "vehicles in all"},
};

}  // namespace

std::span<const std::string_view> eventKindNames() { return kNames; }
std::span<const EventKey> eventSchema() { return kKeys; }
bool EventKey::optional() const { return doc.ends_with("if any") || doc.ends_with("left out otherwise"); }

}  // namespace npsee
