#pragma once

#include <npsee/scenario.h>
#include <npsee/weapons.h>

#include <optional>
#include <string>
#include <vector>

namespace npsee::world {

/// Files that a mission names. A mission file comes from anywhere, so it names only what lies in its own folder or below: absolute
/// paths and ".." are refused, symbolic links are followed to regular files only. "weapons.dat" and "forwardobserver.clp" without a
/// folder mean the shipped ones where there is no such file.

/// What is wrong with a path as a mission may name it; empty if nothing. `key` names the field.
std::string wrongPath(const std::string& key, const std::string& path);

/// Where a file that the mission names lies, or nothing where the shipped one of that name is meant.
/// Error kind input: there is no such file, or it is not a regular one.
Expected<std::optional<std::filesystem::path>> findNamed(const std::filesystem::path& folder, const std::filesystem::path& name);

/// A text that a mission names.
struct NamedText {
  std::string text;
  std::string name;  ///< for messages: the path, or "shipped forwardobserver.clp"
};
/// Error kind input.
Expected<NamedText> readNamed(const std::filesystem::path& folder, const std::filesystem::path& name);

/// The mission's weapons.dat, or the shipped one. Error kind input.
Expected<Weapons> missionWeapons(const Scenario& scenario);

/// A battery of the mission with its projectile's path made ready to open, where it names a file.
BatterySetup missionBattery(const Scenario& scenario, std::size_t battery);

/// The terrain with its file's path made ready to open.
TerrainSource missionTerrain(const Scenario& scenario);

/// Gives faults that name no file the mission file, the line of their pointer in it, or of the nearest object around it that the file has.
void placeFaults(const std::filesystem::path& mission_file, std::vector<Fault>& faults);

/// The mission with what it leaves to the thesis's facts (appendix B.C): where it lists no observer, no batteries, or an observer
/// without mission orders, they come from the facts file it names, orders and guns also from an observer's own `rules` if those hold facts. Resolving
/// twice changes nothing. `warnings` gets what is doubtful: in the facts, and addDoubts. Error kind input, with file and line.
Expected<Scenario> resolved(const Scenario& scenario, std::vector<Fault>* warnings = nullptr);

/// What is allowed in a mission but hardly meant: observers without orders, and those that stand inside one another.
void addDoubts(const Scenario& scenario, std::vector<Fault>& warnings);

}  // namespace npsee::world
