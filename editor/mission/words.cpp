#include "editor/mission/words.h"

#include "sim/core/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

std::string fixed(double value, int decimals) {
  const double tenth = decimals == 0 ? 0.5 : decimals == 1 ? 0.05 : 0.005;
  // No "-0".
  return withDecimals(std::abs(value) < tenth ? 0.0 : value, decimals);
}

std::string whole(double value) { return std::to_string(std::llround(std::clamp(value, -1e15, 1e15))); }
std::string mils(double value) { return whole(value) + " mil"; }

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return out;
}

/// "fire_for_effect" as people write it.
std::string spaced(std::string text) {
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string endingWithStop(std::string text) { return text.empty() || text.ends_with('.') ? text : text + '.'; }

/// An event with shorthand for what sentences are made of.
struct Line {
  const MissionEvent& e;

  std::string text(std::string_view key) const { return e.text(key); }
  bool has(std::string_view key) const { return e.find(key) != nullptr && (!std::holds_alternative<std::string>(*e.find(key)) || !text(key).empty()); }
  bool flag(std::string_view key, bool otherwise) const {
    const auto* value = e.find(key);
    return value != nullptr && std::holds_alternative<bool>(*value) ? std::get<bool>(*value) : otherwise;
  }
  std::string count(std::string_view key) const { return whole(e.number(key)); }
  /// " word NAME" if the event has the key.
  std::string with(std::string_view word, std::string_view key) const { return has(key) ? ' ' + std::string(word) + ' ' + text(key) : std::string(); }
  std::string mission() const { return e.number("mission") > 0.0 ? "Mission " + count("mission") : std::string(); }
  std::string at() const {
    const Vec3* place = e.place();
    return place == nullptr ? std::string() : " at " + placeText(place->x, place->z);
  }
};

std::string contact(const Line& l) {
  std::string out = l.text("observer") + " sees " + l.text("target") + (l.has("type") ? " (" + l.text("type") + ')' : "");
  if (l.has("range_m")) out += ", " + distanceText(l.e.number("range_m")) + " away, azimuth " + mils(l.e.number("azimuth_mil"));
  if (l.has("belief") && l.e.number("belief") < 0.995) out += ", hostile with belief " + fixed(l.e.number("belief"), 2);
  return out + '.';
}

std::string call(const Line& l) {
  std::string out = l.text("observer") + " calls " + spaced(l.text("method")) + (l.has("target") ? " on " + l.text("target") : "") + l.at() + ", mission " + l.count("mission");
  if (l.flag("danger_close", false)) out += ", danger close";
  return out + '.';
}

std::string solution(const Line& l) {
  std::string out = (l.has("gun") ? l.text("gun") : l.text("battery")) + ": " + l.text("trajectory") + " trajectory, elevation " + mils(l.e.number("qe_mil")) + ", azimuth " + mils(l.e.number("azimuth_mil"));
  out += ", " + fixed(l.e.number("tof_s"), 1) + " s of flight";
  if (l.has("charge")) out += ", charge " + l.text("charge");
  if (l.e.number("angle_t_mil") >= 500.0) out += ", angle T " + mils(l.e.number("angle_t_mil"));
  if (l.flag("masked", false)) out += "; masked, it comes down before the target";
  return out + '.';
}

std::string refuse(const Line& l) {
  const std::string who = l.has("gun") ? l.text("gun") : l.text("battery");
  const std::string why = l.has("text") ? l.text("text") : spaced(l.text("reason"));
  return endingWithStop(who + " refuses" + (l.has("trajectory") ? " the " + l.text("trajectory") + " trajectory" : "") + (why.empty() ? "" : ": " + why));
}

std::string fire(const Line& l) {
  std::string out = l.text("gun") + " fires shell " + l.count("shell") + l.with("at", "target");
  if (l.has("trajectory")) out += ", " + l.text("trajectory");
  if (l.has("qe_mil")) out += ", elevation " + mils(l.e.number("qe_mil")) + ", azimuth " + mils(l.e.number("azimuth_mil"));
  return out + '.';
}

std::string detonation(const Line& l) {
  std::string out = "Shell " + l.count("shell") + " bursts" + l.at();
  if (l.has("miss_m")) out += ", " + distanceText(l.e.number("miss_m")) + " from " + (l.has("target") ? l.text("target") : "its aim");
  return out + '.';
}

std::string spot(const Line& l) {
  const std::string who = l.text("observer"), shell = "shell " + l.count("shell");
  if (!l.flag("observed", true)) return who + " does not see where " + shell + " bursts.";
  const double mil = l.e.number("lateral_mil"), metres = l.e.number("range_m");
  const std::string across = std::abs(mil) < 0.5 ? "on line" : mils(std::abs(mil)) + (mil > 0.0 ? " right" : " left");
  const std::string along = std::abs(metres) < 0.5 ? "at the range" : distanceText(std::abs(metres)) + (metres > 0.0 ? " over" : " short");
  return who + " spots " + shell + ": " + across + ", " + along + '.';
}

std::string correction(const Line& l) {
  std::string out = l.text("observer") + " corrects: " + correctionText(l.e.number("right_m"), l.e.number("add_m"));
  if (l.text("method") == "fire_for_effect") out += ", fire for effect";
  if (l.has("grade_m")) out += "; the rules would say " + correctionText(l.e.number("automatic_right_m"), l.e.number("automatic_add_m")) + ", " + distanceText(l.e.number("grade_m")) + " apart";
  if (l.has("misheard")) out += "; misheard: " + l.text("misheard");
  return endingWithStop(out);
}

std::string damage(const Line& l) {
  std::string out = l.text("target") + " is damaged, hull at " + whole(100.0 * (1.0 - std::clamp(l.e.number("hull"), 0.0, 1.0))) + " %";
  if (!l.flag("mobility", true)) out += ", cannot move";
  if (!l.flag("firepower", true)) out += ", cannot shoot";
  return out + (l.has("miss_m") ? "; the burst was " + distanceText(l.e.number("miss_m")) + " away." : ".");
}

std::string endOfMission(const Line& l) {
  std::string out = l.mission() + " ends" + (l.has("result") ? ": " + spaced(l.text("result")) : "");
  if (l.has("reason") && l.text("reason") != l.text("result")) out += "; " + l.text("reason");
  if (l.has("rounds")) out += (out.ends_with('.') ? " " : "; ") + l.count("rounds") + (l.e.number("rounds") == 1.0 ? " round" : " rounds");
  if (l.has("grade")) out += ", adjustment " + l.text("grade");
  return endingWithStop(out);
}

std::string dangerClose(const Line& l) {
  return "Danger close: friendly " + l.text("friendly") + " is " + distanceText(l.e.number("distance_m")) + " from " + (l.has("target") ? l.text("target") : "the target") + '.';
}

}  // namespace

std::string eventTitle(EventKind kind) {
  std::string name = spaced(std::string(eventKindNames()[static_cast<std::size_t>(kind)]));
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

std::string eventSentence(const MissionEvent& event) {
  const Line l{event};
  switch (event.kind) {
    case EventKind::contact: return contact(l);
    case EventKind::lost: return l.text("observer") + " loses " + l.text("target") + (l.has("reason") ? ": " + endingWithStop(spaced(l.text("reason"))) : ".");
    case EventKind::call: return call(l);
    case EventKind::solution: return solution(l);
    case EventKind::refuse: return refuse(l);
    case EventKind::fire: return fire(l);
    case EventKind::apex: return "Shell " + l.count("shell") + " is at its highest" + (event.place() != nullptr ? ", " + distanceText(event.place()->y) + " up." : ".");
    case EventKind::detonation: return detonation(l);
    case EventKind::spot: return spot(l);
    case EventKind::correction: return correction(l);
    case EventKind::damage: return damage(l);
    case EventKind::destroyed: return l.text("target") + " is destroyed" + (l.has("shell") ? " by shell " + l.count("shell") : "") + (l.has("miss_m") ? ", " + distanceText(event.number("miss_m")) + " from the burst." : ".");
    case EventKind::danger_close: return dangerClose(l);
    case EventKind::warning: return endingWithStop(l.text("text"));
    case EventKind::error: return endingWithStop(l.text("text"));
    case EventKind::end_of_mission: return endOfMission(l);
    case EventKind::end: return "The simulation ends: " + l.count("shells") + (event.number("shells") == 1.0 ? " shell, " : " shells, ") + l.count("destroyed") + " destroyed; log hash " + l.text("hash") + '.';
  }
  return {};
}

std::string eventReason(const MissionEvent& event) {
  const std::string rule = event.text("rule");
  if (rule.empty()) return {};
  std::string out = rule == "person" ? "A person decided it." : "Rule " + rule;
  if (const auto* facts = event.find("facts"))
    if (const auto* list = std::get_if<std::vector<std::string>>(facts))
      for (const std::string& fact : *list) out += "\n  " + fact;
  return out;
}

bool marked(EventKind kind) {
  using enum EventKind;
  return kind == call || kind == refuse || kind == fire || kind == detonation || kind == damage || kind == destroyed || kind == danger_close || kind == warning || kind == error || kind == end_of_mission;
}

std::string momentText(double time_s) {
  const double t = std::max(0.0, time_s);
  if (t < 60.0) return fixed(t, 1) + " s";
  // Tenths first, so that 59.97 s never reads as 60.0.
  const long long tenths = std::llround(t * 10.0);
  char text[48];
  if (tenths < 36000) std::snprintf(text, sizeof text, "%lld:%04.1f", tenths / 600, static_cast<double>(tenths % 600) / 10.0);
  else std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", tenths / 36000, tenths / 600 % 60, tenths / 10 % 60);
  return text;
}

std::string distanceText(double metres) {
  const double size = std::abs(metres);
  if (size < 9.95) return fixed(metres, 1) + " m";
  if (size < 9999.5) return whole(metres) + " m";
  return fixed(metres / 1000.0, 1) + " km";
}

std::string correctionText(double right_m, double add_m) {
  std::string out;
  if (std::abs(right_m) >= 0.5) out = (right_m > 0.0 ? "right " : "left ") + whole(std::abs(right_m));
  if (std::abs(add_m) >= 0.5) out += (out.empty() ? "" : ", ") + std::string(add_m > 0.0 ? "add " : "drop ") + whole(std::abs(add_m));
  return out.empty() ? "repeat" : out;
}

std::string placeText(double x_m, double z_m) { return whole(x_m) + ' ' + whole(z_m); }

bool EventFilter::lists(const MissionEvent& event) const {
  if (!kinds[static_cast<std::size_t>(event.kind)]) return false;
  return word.empty() || lower(eventSentence(event)).find(lower(word)) != std::string::npos;
}

std::size_t eventsUntil(const std::vector<MissionEvent>& events, double time_s) {
  return static_cast<std::size_t>(std::ranges::upper_bound(events, time_s, {}, &MissionEvent::t_s) - events.begin());
}

bool names(const MissionEvent& event, const std::string& id) {
  constexpr std::array<std::string_view, 5> kKeys{"target", "observer", "gun", "battery", "friendly"};
  return std::ranges::any_of(kKeys, [&](std::string_view key) { return event.text(key) == id; });
}

}  // namespace npsee::editor
