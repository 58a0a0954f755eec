#include "app/commands/mission_statistics.h"

#include <npsee/mission.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

namespace npsee::commands {
namespace {

using Json = nlohmann::ordered_json;

/// A quantity some runs have: its quantiles by the nearest rank, and how many of all runs had it.
struct Quantiles {
  std::size_t runs = 0;
  double median = 0.0, p90 = 0.0, p99 = 0.0, mean = 0.0;
};

Quantiles quantiles(const std::vector<MissionOutcome>& outcomes, const std::function<std::optional<double>(const MissionOutcome&)>& get) {
  std::vector<double> values;
  for (const MissionOutcome& outcome : outcomes)
    if (const auto value = get(outcome)) values.push_back(*value);
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto rank = [&](double p) { return values[std::min(values.size() - 1, static_cast<std::size_t>(std::ceil(p * static_cast<double>(values.size()))) - 1)]; };
  double sum = 0.0;
  for (const double value : values) sum += value;
  return {values.size(), rank(0.5), rank(0.9), rank(0.99), sum / static_cast<double>(values.size())};
}

double share(const std::vector<MissionOutcome>& outcomes, const std::function<bool(const MissionOutcome&)>& test) {
  const auto count = std::count_if(outcomes.begin(), outcomes.end(), test);
  return outcomes.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(outcomes.size());
}

struct Row {
  const char* key;
  const char* label;
  std::function<std::optional<double>(const MissionOutcome&)> get;
};
const std::array<Row, 5>& rows() {
  static const std::array<Row, 5> all{{
      {"effect_rounds", "adjusting rounds before effect", [](const MissionOutcome& o) { return o.effect_rounds; }},
      {"effect_error_m", "aim off the target at effect, m", [](const MissionOutcome& o) { return o.effect_error_m; }},
      {"first_destroyed_s", "first hostile destroyed after, s", [](const MissionOutcome& o) { return o.first_destroyed_s; }},
      {"shells", "shells fired", [](const MissionOutcome& o) { return std::optional(static_cast<double>(o.shells)); }},
      {"destroyed", "hostiles destroyed", [](const MissionOutcome& o) { return std::optional(static_cast<double>(o.destroyed)); }},
  }};
  return all;
}

struct Share {
  const char* key;
  const char* label;
  std::function<bool(const MissionOutcome&)> test;
};
const std::array<Share, 6>& shares() {
  static const std::array<Share, 6> all{{
      {"expectations_met", "expectations met", [](const MissionOutcome& o) { return o.expectations_met; }},
      {"any_destroyed", "a hostile destroyed", [](const MissionOutcome& o) { return o.destroyed > 0; }},
      {"all_destroyed", "all hostiles destroyed", [](const MissionOutcome& o) { return o.hostiles > 0 && o.destroyed == o.hostiles; }},
      {"effect_within_50_m", "effect within 5 rounds and 50 m", [](const MissionOutcome& o) { return o.effect_rounds && *o.effect_rounds <= 5 && *o.effect_error_m <= 50.0; }},
      {"effect_within_75_m", "effect within 75 m", [](const MissionOutcome& o) { return o.effect_error_m && *o.effect_error_m <= 75.0; }},
      {"friendly_losses", "friendly losses", [](const MissionOutcome& o) { return o.friendly_losses > 0; }},
  }};
  return all;
}

}  // namespace

MissionOutcome outcomeOf(const Recording& recording) {
  MissionOutcome out;
  out.seed = recording.scenario.seed;
  out.shells = static_cast<int>(recording.shells.size());
  for (const VehicleRecord& vehicle : recording.vehicles) {
    const bool gone = vehicle.destroyedAt(recording.duration_s);
    if (vehicle.type.side == Side::hostile) ++out.hostiles, out.destroyed += gone;
    if (vehicle.type.side == Side::friendly) out.friendly_losses += gone;
  }
  for (const MissionEvent& event : recording.events) {
    if (event.kind == EventKind::call) ++out.missions;
    if (event.kind == EventKind::refuse) ++out.refusals;
    if (event.kind == EventKind::correction && event.text("method") == "fire_for_effect" && !out.effect_rounds && event.number("round") > 0) {
      out.effect_rounds = event.number("round");
      out.effect_error_m = event.number("aim_error_m");
    }
    if (event.kind == EventKind::destroyed && !out.first_destroyed_s) {
      const int vehicle = recording.findVehicle(event.text("target"));
      if (vehicle >= 0 && recording.vehicles[static_cast<std::size_t>(vehicle)].type.side == Side::hostile) out.first_destroyed_s = event.t_s;
    }
  }
  out.expectations_met = unmetExpectations(recording).empty();
  return out;
}

std::string statisticsText(const std::vector<MissionOutcome>& outcomes) {
  char line[200];
  std::snprintf(line, sizeof line, "%zu runs, seeds %lld to %lld\n\n", outcomes.size(), static_cast<long long>(outcomes.front().seed), static_cast<long long>(outcomes.back().seed));
  std::string text = line;
  for (const Share& s : shares()) {
    std::snprintf(line, sizeof line, "%-34s %7.1f %%\n", s.label, 100.0 * share(outcomes, s.test));
    text += line;
  }
  std::snprintf(line, sizeof line, "\n%-34s %8s %9s %9s %9s %9s\n", "", "runs", "mean", "median", "p90", "p99");
  text += line;
  for (const Row& row : rows()) {
    const Quantiles q = quantiles(outcomes, row.get);
    if (q.runs == 0) std::snprintf(line, sizeof line, "%-34s %8d %9s %9s %9s %9s\n", row.label, 0, "-", "-", "-", "-");
    else std::snprintf(line, sizeof line, "%-34s %8zu %9.1f %9.1f %9.1f %9.1f\n", row.label, q.runs, q.mean, q.median, q.p90, q.p99);
    text += line;
  }
  return text;
}

std::string statisticsJson(const std::vector<MissionOutcome>& outcomes) {
  Json out;
  out["runs"] = outcomes.size();
  out["first_seed"] = outcomes.front().seed;
  out["last_seed"] = outcomes.back().seed;
  for (const Share& s : shares()) out["share"][s.key] = share(outcomes, s.test);
  for (const Row& row : rows()) {
    const Quantiles q = quantiles(outcomes, row.get);
    Json& one = out[row.key] = {{"runs", q.runs}};
    if (q.runs > 0) one.update({{"mean", q.mean}, {"median", q.median}, {"p90", q.p90}, {"p99", q.p99}});
  }
  return out.dump(2) + '\n';
}

}  // namespace npsee::commands
