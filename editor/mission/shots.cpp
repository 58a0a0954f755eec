#include "editor/mission/shots.h"

#include "editor/mission/words.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

namespace npsee::editor {
namespace {

double keyOf(const Shot& shot, ShotColumn column) {
  switch (column) {
    case ShotColumn::fired: return shot.fired_s;
    case ShotColumn::mission: return shot.mission;
    case ShotColumn::elevation: return shot.elevation_mil;
    case ShotColumn::azimuth: return shot.azimuth_mil;
    case ShotColumn::tof: return shot.tof_s();
    case ShotColumn::apex: return shot.apex_m;
    case ShotColumn::miss: return shot.miss_m.value_or(std::numeric_limits<double>::max());
    default: return shot.shell;
  }
}

Shot shotOf(const Recording& recording, int index) {
  const ShellRecord& shell = recording.shells[static_cast<std::size_t>(index)];
  Shot out;
  out.shell = index;
  out.fired_s = shell.fired_s;
  out.burst_s = shell.burst_s;
  out.mission = shell.mission;
  if (shell.gun >= 0 && shell.gun < static_cast<int>(recording.guns.size())) out.gun = recording.guns[static_cast<std::size_t>(shell.gun)].id;
  else if (shell.shooter >= 0 && shell.shooter < static_cast<int>(recording.vehicles.size())) out.gun = recording.vehicles[static_cast<std::size_t>(shell.shooter)].id;
  if (shell.target >= 0 && shell.target < static_cast<int>(recording.vehicles.size())) out.target = recording.vehicles[static_cast<std::size_t>(shell.target)].id;
  if (shell.path.nodes().empty()) {
    const Vec3 line = shell.burst_m - shell.muzzle_m;
    out.elevation_mil = std::atan2(line.y, std::hypot(line.x, line.z)) * kMilPerRad;
    out.azimuth_mil = std::atan2(line.x, -line.z) * kMilPerRad;
    out.apex_m = std::max(0.0, line.y);
  } else {
    out.elevation_mil = shell.path.shot().elevation_rad * kMilPerRad;
    out.azimuth_mil = shell.path.shot().azimuth_rad * kMilPerRad;
    out.apex_m = shell.path.inWorld(shell.path.flight().apex_time_s).position_m.y - shell.muzzle_m.y;
  }
  if (out.azimuth_mil < 0.0) out.azimuth_mil += 6400.0;
  return out;
}

}  // namespace

std::vector<Shot> shotsOf(const Recording& recording) {
  std::vector<Shot> out;
  out.reserve(recording.shells.size());
  std::map<int, std::size_t> by_number;
  for (int i = 0; i < static_cast<int>(recording.shells.size()); ++i) {
    out.push_back(shotOf(recording, i));
    by_number.emplace(recording.shells[static_cast<std::size_t>(i)].number, out.size() - 1);
  }
  // What the log says of a shot: its trajectory when it is fired, its miss when it bursts.
  for (const MissionEvent& event : recording.events) {
    if (event.kind != EventKind::fire && event.kind != EventKind::detonation) continue;
    const auto found = by_number.find(static_cast<int>(event.number("shell")));
    if (found == by_number.end()) continue;
    if (event.kind == EventKind::fire) out[found->second].trajectory = event.text("trajectory");
    else if (event.find("miss_m") != nullptr) out[found->second].miss_m = event.number("miss_m");
  }
  return out;
}

void sortShots(std::vector<Shot>& shots, ShotColumn column, bool descending) {
  const auto text = [column](const Shot& shot) -> const std::string& { return column == ShotColumn::gun ? shot.gun : shot.target; };
  const bool by_text = column == ShotColumn::gun || column == ShotColumn::target;
  std::ranges::stable_sort(shots, [&](const Shot& first, const Shot& second) {
    const Shot &a = descending ? second : first, &b = descending ? first : second;
    return by_text ? text(a) < text(b) : keyOf(a, column) < keyOf(b, column);
  });
}

std::string shotsText(const std::vector<Shot>& shots) {
  std::string out = "shell\tfired_s\tgun\tmission\ttarget\ttrajectory\tqe_mil\tazimuth_mil\ttof_s\tapex_m\tmiss_m\n";
  for (const Shot& shot : shots) {
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, "%.2f\t%.2f\t%.2f\t%.1f\t", shot.elevation_mil, shot.azimuth_mil, shot.tof_s(), shot.apex_m);
    out += std::to_string(shot.shell + 1) + '\t' + shortest(shot.fired_s) + '\t' + shot.gun + '\t' + std::to_string(shot.mission) + '\t' + shot.target + '\t' + shot.trajectory + '\t' + numbers;
    if (shot.miss_m) out += shortest(std::round(*shot.miss_m * 10.0) / 10.0);
    out += '\n';
  }
  return out;
}

}  // namespace npsee::editor
