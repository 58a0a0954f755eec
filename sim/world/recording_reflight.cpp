#include "sim/world/recording_file.h"
#include "sim/world/scenario_files.h"

#include <npsee/units.h>

#include <bit>
#include <cmath>

namespace npsee::world {
namespace {

/// A re-flown shell has the same bits where the program and the files are the same; where it is further off than this (m), they are not.
constexpr double kSamePlace_m = 0.01;

constexpr std::string_view kRecordAgain = "The recording is of another version, or a file the mission names has changed. Run the mission again with --record.";

tl::unexpected<Error> broken(std::string what) { return fail(ErrorKind::input, std::move(what), std::string(kRecordAgain)); }

}  // namespace

std::string terrainMark(const Terrain& terrain) {
  // FNV-1a over the bits of the heights and the size of the grid.
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&](std::uint64_t value) {
    for (int i = 0; i < 64; i += 8) hash = (hash ^ ((value >> i) & 0xff)) * 1099511628211ull;
  };
  for (const double value : {terrain.sizeX(), terrain.sizeZ(), terrain.seaLevel()}) add(std::bit_cast<std::uint64_t>(value));
  add(static_cast<std::uint64_t>(terrain.columns()));
  for (const float height : terrain.heights()) hash = (hash ^ std::bit_cast<std::uint32_t>(height)) * 1099511628211ull;
  constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  for (int i = 60; i >= 0; i -= 4) out += kHex[(hash >> i) & 15];
  return out;
}

Expected<FlightPath> Reflight::fly(const ShellRecord& shell, const Shot& shot) {
  const std::string who = "shell " + std::to_string(shell.number);
  const auto index = static_cast<std::size_t>(recording_.guns[static_cast<std::size_t>(shell.gun)].battery);
  auto& direction = batteries_[index];
  if (!direction) {
    const BatterySetup battery = missionBattery(recording_.scenario, index);
    const Weapon* weapon = weapons_.find(std::to_string(battery.weapon));
    if (!weapon) return broken(who + " is of a weapon " + std::to_string(battery.weapon) + " that there is not.");
    auto made = observer::FireDirection::make(battery, *weapon, recording_.terrain, recording_.scenario.world.weather, recording_.scenario.fdc);
    if (!made) return tl::unexpected<Error>(made.error());
    direction = std::move(*made);
  }
  observer::FireSolution solution;
  solution.shot = shot;
  FlightPath path = direction->fly(solution, 0.0, 0.0);
  if (path.nodes().empty()) return broken(who + " has a shot that cannot be fired.");
  const double off = length(path.inWorld(shell.burst_s - shell.fired_s).position_m - shell.burst_m);
  if (!(off <= kSamePlace_m)) return broken(who + " comes down " + shortest(std::floor(off * 100.0 + 0.5) / 100.0) + " m from where it was recorded.");
  return path;
}

}  // namespace npsee::world
