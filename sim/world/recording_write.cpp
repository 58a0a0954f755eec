// A recording as JSON lines: a head, the scenario, the weapons, then what moved, was fired, was believed and happened.

#include "sim/core/files.h"
#include "sim/world/recording_file.h"
#include "sim/world/scenario_files.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace npsee {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

ordered_json place(const Vec3& v) { return ordered_json::array({v.x, v.y, v.z}); }

void append(std::string& out, const char* key, ordered_json value) {
  ordered_json line;
  line[key] = std::move(value);
  // Names come from files: what is not UTF-8 is replaced.
  out += line.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  out += '\n';
}

ordered_json vehicleJson(const VehicleRecord& vehicle) {
  ordered_json legs = ordered_json::array(), damage = ordered_json::array();
  for (const Leg& leg : vehicle.track.legs) legs.push_back({leg.start_s, leg.x_m, leg.z_m, leg.heading_rad, leg.speed_mps, leg.acceleration_mps2, leg.turn_radps});
  for (const DamageStep& step : vehicle.damage) damage.push_back({step.t_s, step.hull, step.mobility ? 1 : 0, step.firepower ? 1 : 0});
  return {{"id", vehicle.id}, {"type", vehicle.type.index}, {"legs", std::move(legs)}, {"damage", std::move(damage)}};
}

ordered_json gunJson(const GunRecord& gun) {
  ordered_json lays = ordered_json::array();
  for (const LayStep& step : gun.lays) lays.push_back({step.from_s, step.to_s, step.azimuth_rad, step.elevation_rad});
  return {{"id", gun.id}, {"battery", gun.battery}, {"muzzle", place(gun.muzzle_m)}, {"lays", std::move(lays)}};
}

ordered_json shotJson(const Shot& shot) {
  const Factors& f = shot.factors;
  return {{"speed", shot.speed_mps}, {"elevation", shot.elevation_rad}, {"azimuth", shot.azimuth_rad}, {"wind", place(shot.wind_mps)}, {"factors", {f.form, f.lift, f.magnus, f.yaw_drag}}, {"muzzle", place(shot.muzzle_m)}};
}

ordered_json shellJson(const ShellRecord& shell) {
  ordered_json out{{"number", shell.number}, {"gun", shell.gun}, {"shooter", shell.shooter}, {"weapon", shell.weapon}, {"mission", shell.mission}, {"target", shell.target}, {"fired_s", shell.fired_s}, {"burst_s", shell.burst_s},
                   {"burst", place(shell.burst_m)}, {"muzzle", place(shell.muzzle_m)}, {"preset", shell.preset}, {"seed", shell.seed}, {"illumination", shell.illumination}, {"smoke", shell.smoke}};
  if (!shell.path.nodes().empty()) out["shot"] = shotJson(shell.path.shot());
  return out;
}

ordered_json observerJson(const ObserverRecord& observer) {
  ordered_json beliefs = ordered_json::array();
  for (const BeliefStep& b : observer.beliefs) beliefs.push_back({b.t_s, b.target, b.seen ? 1 : 0, b.believed_m.x, b.believed_m.y, b.believed_m.z, b.hostile, b.friendly, b.mission});
  return {{"id", observer.id}, {"vehicle", observer.vehicle}, {"eye_height", observer.eye_height_m}, {"beliefs", std::move(beliefs)}};
}

ordered_json eventValue(const MissionEvent::Value& value) {
  if (const auto* v = std::get_if<Vec3>(&value)) return place(*v);
  return std::visit(
      [](const auto& v) -> ordered_json {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Vec3>) return nullptr;
        else return v;
      },
      value);
}

/// Unlike the log's lines these keep every digit.
ordered_json eventLine(const MissionEvent& event) {
  ordered_json out{{"t", event.t_s}, {"ev", eventKindNames()[static_cast<std::size_t>(event.kind)]}};
  for (const auto& [key, value] : event.fields) out[key] = eventValue(value);
  return out;
}

/// The mission's folder as seen from the recording's, so that both can be moved together.
std::string folderFrom(const fs::path& folder, const fs::path& recording) {
  std::error_code error;
  const fs::path here = recording.has_parent_path() ? recording.parent_path() : fs::path(".");
  const fs::path relative = fs::proximate(folder.empty() ? fs::path(".") : folder, here, error);
  return (error ? folder : relative).generic_string();
}

}  // namespace

Expected<void> saveRecording(const Recording& recording, const fs::path& path) {
  const auto weapons = world::missionWeapons(recording.scenario);
  if (!weapons) return tl::unexpected<Error>(weapons.error());
  std::string out;
  try {
    append(out, "npsee_recording",
           {{"version", world::kRecordingVersion}, {"duration_s", recording.duration_s}, {"finished", recording.finished}, {"hash", recording.hash}, {"folder", folderFrom(recording.scenario.folder, path)}, {"terrain", world::terrainMark(recording.terrain)}});
    append(out, "scenario", ordered_json::parse(scenarioText(recording.scenario)));
    append(out, "weapons", weaponsText(*weapons));
    for (const VehicleRecord& vehicle : recording.vehicles) append(out, "vehicle", vehicleJson(vehicle));
    for (const GunRecord& gun : recording.guns) append(out, "gun", gunJson(gun));
    for (const ShellRecord& shell : recording.shells) append(out, "shell", shellJson(shell));
    for (const ObserverRecord& observer : recording.observers) append(out, "observer", observerJson(observer));
    for (const MissionEvent& event : recording.events) append(out, "event", eventLine(event));
  } catch (const ordered_json::exception& error) {
    return fail(ErrorKind::output, "the recording cannot be written as JSON: " + std::string(error.what()) + ".");
  }
  // A file that ends too early can be told from a whole one.
  append(out, "end", {{"vehicles", recording.vehicles.size()}, {"shells", recording.shells.size()}, {"events", recording.events.size()}});
  return writeFileAtomically(path, out);
}

}  // namespace npsee
