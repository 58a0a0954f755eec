#include "app/commands/replay_state.h"

#include <npsee/units.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace npsee::commands {
namespace {

using nlohmann::ordered_json;

/// Bursts are listed this long, s.
constexpr double kRecent_s = 1.0;

double rounded(double value) {
  const double out = std::floor(value * 1e4 + 0.5) / 1e4;
  return out == 0.0 ? 0.0 : out;
}
double degrees(double rad) {
  const double turns = rad / kTwoPi;
  return rounded(360.0 * (turns - std::floor(turns)));
}
double mils(double rad) { return rounded(rad * 6400.0 / kTwoPi); }
ordered_json place(const Vec3& v) { return ordered_json::array({rounded(v.x), rounded(v.y), rounded(v.z)}); }

std::string_view sideName(Side side) { return side == Side::friendly ? "friendly" : side == Side::hostile ? "hostile" : "neutral"; }

ordered_json vehicleJson(const Recording& r, std::size_t i, double t) {
  const VehicleRecord& vehicle = r.vehicles[i];
  const Pose pose = vehicle.track.at(t);
  const DamageStep* damage = vehicle.damageAt(t);
  const DamageStep whole;
  const DamageStep& now = damage ? *damage : whole;
  return {{"id", vehicle.id},
          {"type", vehicle.type.name},
          {"side", sideName(vehicle.type.side)},
          {"position", place(r.vehiclePlace(i, t))},
          {"heading_deg", degrees(pose.heading_rad)},
          {"speed_mps", rounded(pose.speed_mps)},
          {"hull", rounded(now.hull)},
          {"mobility", now.mobility},
          {"firepower", now.firepower},
          {"destroyed", now.hull >= 1.0}};
}

ordered_json shellJson(const Recording& r, const ShellRecord& shell, double t) {
  ordered_json out{{"shell", shell.number}, {"gun", shell.gun >= 0 ? r.guns[static_cast<std::size_t>(shell.gun)].id : shell.shooter >= 0 ? r.vehicles[static_cast<std::size_t>(shell.shooter)].id : std::string()}, {"weapon", shell.weapon}, {"mission", shell.mission}};
  if (shell.target >= 0) out["target"] = r.vehicles[static_cast<std::size_t>(shell.target)].id;
  if (t < shell.burst_s) {
    out["position"] = place(shell.at(t));
    out["velocity"] = place(shell.velocityAt(t));
    out["bursts_in_s"] = rounded(shell.burst_s - t);
  } else {
    out["position"] = place(shell.burst_m);
    out["since_s"] = rounded(t - shell.burst_s);
  }
  return out;
}

/// The last belief of each contact up to a time, by target.
ordered_json beliefsJson(const Recording& r, const ObserverRecord& observer, double t) {
  std::map<int, const BeliefStep*> last;
  for (const BeliefStep& belief : observer.beliefs)
    if (belief.t_s <= t) last[belief.target] = &belief;
  ordered_json out = ordered_json::array();
  for (const auto& [target, belief] : last) {
    if (target < 0) continue;
    out.push_back({{"target", r.vehicles[static_cast<std::size_t>(target)].id}, {"seen", belief->seen}, {"believed", place(belief->believed_m)}, {"hostile", rounded(belief->hostile)}, {"friendly", rounded(belief->friendly)}, {"mission", belief->mission}});
  }
  return out;
}

}  // namespace

std::string stateJson(const Recording& r, double t) {
  ordered_json vehicles = ordered_json::array(), guns = ordered_json::array(), shells = ordered_json::array(), bursts = ordered_json::array(), observers = ordered_json::array();
  for (std::size_t i = 0; i < r.vehicles.size(); ++i) vehicles.push_back(vehicleJson(r, i, t));
  for (const GunRecord& gun : r.guns) {
    const auto [azimuth, elevation] = gun.lineAt(t);
    guns.push_back({{"id", gun.id}, {"position", place(gun.muzzle_m)}, {"azimuth_mil", mils(azimuth - kTwoPi * std::floor(azimuth / kTwoPi))}, {"qe_mil", mils(elevation)}});
  }
  std::vector<int> found;
  r.shellsInAir(t, found);
  for (const int i : found) shells.push_back(shellJson(r, r.shells[static_cast<std::size_t>(i)], t));
  r.burstsSince(t, kRecent_s, found);
  for (const int i : found) bursts.push_back(shellJson(r, r.shells[static_cast<std::size_t>(i)], t));
  for (std::size_t i = 0; i < r.observers.size(); ++i) observers.push_back({{"id", r.observers[i].id}, {"eye", place(r.observerEye(i, t))}, {"beliefs", beliefsJson(r, r.observers[i], t)}});
  const ordered_json out{{"t", t}, {"vehicles", std::move(vehicles)}, {"guns", std::move(guns)}, {"shells", std::move(shells)}, {"bursts", std::move(bursts)}, {"observers", std::move(observers)}};
  return out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::string summaryText(const Recording& r) {
  std::array<int, kEventKinds> counts{};
  for (const MissionEvent& event : r.events) ++counts[static_cast<std::size_t>(event.kind)];
  const std::string title = r.scenario.title.empty() ? r.scenario.name : r.scenario.title;
  std::string out = printable(title.empty() ? "a mission without a name" : title) + ": " + shortest(rounded(r.duration_s)) + " s" + (r.finished ? "" : ", not finished") + ", seed " + std::to_string(r.scenario.seed) + '\n';
  out += "  " + std::to_string(r.vehicles.size()) + " vehicles, " + std::to_string(r.guns.size()) + " guns, " + std::to_string(r.observers.size()) + " observers, " + std::to_string(r.shells.size()) + " shells\n  events:";
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) out += ' ' + std::string(eventKindNames()[i]) + ' ' + std::to_string(counts[i]);
  out += '\n';
  if (!r.hash.empty()) out += "  hash of the log: " + printable(r.hash) + '\n';
  return out;
}

}  // namespace npsee::commands
