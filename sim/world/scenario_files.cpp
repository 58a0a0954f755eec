#include "sim/world/scenario_files.h"

#include "sim/core/files.h"
#include "sim/core/text.h"
#include "sim/world/shipped_texts.h"

#include <system_error>

namespace npsee::world {

namespace fs = std::filesystem;

namespace {

/// Largest rules, facts or weapons file, bytes.
constexpr std::size_t kMaxNamed = 1u << 20;

std::optional<std::string_view> shippedText(const fs::path& name) {
  if (name == "weapons.dat") return shippedWeapons();
  if (name == "forwardobserver.clp") return shippedFacts();
  return std::nullopt;
}

}  // namespace

std::string wrongPath(const std::string& key, const std::string& path) {
  if (path.empty()) return {};
  if (path.find('\0') != std::string::npos || path.find('\\') != std::string::npos) return key + " is \"" + printable(path) + "\", which is not a path with / between folders.";
  if (fs::path(path).is_absolute()) return key + " is \"" + path + "\", but a mission names files relative to its own folder; an absolute path is refused.";
  for (const fs::path& part : fs::path(path))
    if (part == "..") return key + " is \"" + path + "\", but a mission names files in its own folder or below; .. is refused.";
  return {};
}

Expected<std::optional<fs::path>> findNamed(const fs::path& folder, const fs::path& name) {
  if (std::string wrong = wrongPath("the file", name.generic_string()); !wrong.empty()) return fail(ErrorKind::input, std::move(wrong), "Put the file beside the mission file.");
  const fs::path path = folder / name;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_regular_file(status)) return path;
  if (status.type() == fs::file_type::not_found && shippedText(name)) return std::optional<fs::path>();
  const std::string shown = "\"" + path.generic_string() + "\"";
  if (status.type() == fs::file_type::not_found) return fail(ErrorKind::input, "there is no file " + shown + ".", "Paths are relative to the mission file's folder.");
  return fail(ErrorKind::input, shown + " is not a regular file that can be read.", "Name a file, not a folder or device.");
}

Expected<NamedText> readNamed(const fs::path& folder, const fs::path& name) {
  const auto found = findNamed(folder, name);
  if (!found) return tl::unexpected<Error>(found.error());
  if (!*found) return NamedText{std::string(*shippedText(name)), "shipped " + name.generic_string()};
  auto text = readTextFile(**found, kMaxNamed);
  if (!text) return tl::unexpected<Error>(text.error());
  return NamedText{std::move(*text), (*found)->generic_string()};
}

Expected<Weapons> missionWeapons(const Scenario& scenario) {
  if (scenario.weapons.empty()) return parseWeapons(shippedWeapons(), "shipped weapons.dat");
  const auto text = readNamed(scenario.folder, scenario.weapons);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseWeapons(text->text, text->name);
}

BatterySetup missionBattery(const Scenario& scenario, std::size_t battery) {
  BatterySetup out = scenario.batteries[battery];
  // A dot or a slash makes it a file, as it does for the ballistics library.
  if (out.projectile.find_first_of("./\\") != std::string::npos) out.projectile = (scenario.folder / out.projectile).string();
  return out;
}

TerrainSource missionTerrain(const Scenario& scenario) {
  TerrainSource source = scenario.world.terrain;
  if (!source.file.empty()) source.file = scenario.folder / source.file;
  return source;
}

}  // namespace npsee::world
