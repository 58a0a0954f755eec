#include "sim/world/scenario_read.h"

#include "sim/core/file_kind.h"
#include "sim/core/files.h"
#include "sim/world/scenario_files.h"
#include "sim/world/scenario_validate.h"
#include "sim/world/scenario_values.h"

#include <nlohmann/json.hpp>

namespace npsee {
namespace world {
namespace {

using nlohmann::ordered_json;

constexpr int kMissionVersion = 1;
constexpr std::string_view kForeign = "npsnet-scenario/1";

/// Whether the file is one of ours or of the older format; faults where it is neither.
bool foreignFormat(const JsonText& json, std::vector<Fault>& faults) {
  const ordered_json& root = json.root();
  if (root.contains("npsee_mission")) {
    const ordered_json& version = root["npsee_mission"];
    if (!version.is_number_integer() || version.get<double>() < 1.0)
      faults.push_back(json.fault("/npsee_mission", "the version must be a whole number from 1.", "This program writes \"npsee_mission\": 1."));
    else if (version.get<double>() > kMissionVersion)
      faults.push_back(json.fault("/npsee_mission", "the file has version " + version.dump() + ", newer than 1, the newest this program reads.", "Use a newer npsee."));
    return false;
  }
  if (!root.contains("format")) {
    faults.push_back(json.fault("", "the file's version is missing.", "Add \"npsee_mission\": 1 as the first key."));
    return false;
  }
  if (root["format"] != kForeign)
    faults.push_back(json.fault("/format", "the format is " + shownJson(root["format"]) + ", which this program does not know.", "It reads \"npsee_mission\": 1 and \"format\": \"npsnet-scenario/1\"."));
  return true;
}

/// What only the older format has: a fixed tick, and a georeference that must be none.
void checkForeign(const JsonText& json, std::vector<Fault>& faults) {
  const ordered_json& root = json.root();
  if (root.contains("dt") && root["dt"] != kMissionTick_s)
    faults.push_back(json.fault("/dt", "dt is " + shownJson(root["dt"]) + ", but the tick is always " + shortest(kMissionTick_s) + " s.", "Leave dt out."));
  if (!root.contains("world") || !root["world"].is_object() || !root["world"].contains("georef")) return;
  const ordered_json& georef = root["world"]["georef"];
  const auto zero = [&](const char* key) { return !georef.contains(key) || georef[key] == 0.0; };
  if (!georef.is_object() || !zero("lat0") || !zero("lon0"))
    faults.push_back(json.fault("/world/georef", "the world is synthetic and has no place on Earth, so lat0 and lon0 must be 0.", "Leave georef out."));
}

/// Files that the mission names must be there.
void checkFiles(const Struct& table, const void* object, const std::string& pointer, const std::filesystem::path& folder, std::vector<ScenarioFault>& faults) {
  for (const Field& field : table.fields) {
    const std::string here = pointer + '/' + std::string(field.key);
    if (field.type == FieldType::object) checkFiles(*field.child, field.partOf(object), here, folder, faults);
    if (field.type == FieldType::list)
      for (std::size_t i = 0; i < field.count(object); ++i) checkFiles(*field.child, field.itemOf(object, i), here + '/' + std::to_string(i), folder, faults);
    if (field.type != FieldType::file) continue;
    const auto path = std::get<std::string>(field.read(object));
    if (path.empty()) continue;
    if (const auto found = findNamed(folder, path); !found) faults.push_back({here, found.error().faults.front().what, found.error().faults.front().remedy});
  }
}

/// Pointer of the object in the file that is the value meant, or the nearest around it.
std::string nearestPointer(const JsonText& json, std::string pointer, bool foreign) {
  if (foreign)
    for (const auto& [plural, single] : {std::pair<std::string, std::string>{"/batteries/0", "/battery"}, {"/observers/0", "/observer"}})
      if (pointer.starts_with(plural) && json.line(plural) == 0) pointer = single + pointer.substr(plural.size());
  while (!pointer.empty() && json.line(pointer) == 0) pointer.resize(pointer.rfind('/'));
  return pointer;
}

Expected<Scenario> readScenario(std::string_view text, std::string_view name, const std::filesystem::path& folder, bool files) {
  const auto json = JsonText::parse(text, name);
  if (!json) return tl::unexpected<Error>(json.error());
  if (!json->root().is_object())
    return fail(ErrorKind::input, json->fault("", "a mission is an object { ... }, but this is " + std::string(jsonTypeName(json->root())) + ".", ""));

  Scenario scenario;
  scenario.folder = folder;
  std::vector<Fault> faults;
  const bool foreign = foreignFormat(*json, faults);
  // A file of another version may mean anything by its keys; listing them as unknown would only mislead.
  if (!faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  if (foreign) checkForeign(*json, faults);
  const std::vector<std::string_view> extra = foreign ? std::vector<std::string_view>{"format", "dt"} : std::vector<std::string_view>{"npsee_mission"};
  TableReader(*json, faults, foreign).read(missionTable(), json->root(), "", &scenario, extra);
  // Relations between values say something only where each value could be read.
  if (faults.empty()) {
    std::vector<ScenarioFault> relations = relationFaults(scenario);
    if (files) checkFiles(missionTable(), &scenario, "", folder, relations);
    for (const ScenarioFault& fault : relations) faults.push_back(json->fault(nearestPointer(*json, fault.pointer, foreign), fault.what, fault.remedy));
  }
  if (faults.size() >= kMostFaults) faults.push_back(json->fault("", "there may be more faults; the first " + std::to_string(kMostFaults) + " are listed.", ""));
  if (!faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  return scenario;
}

}  // namespace

void placeFaults(const std::filesystem::path& mission_file, std::vector<Fault>& faults) {
  const auto text = readTextFile(mission_file);
  const auto json = text ? JsonText::parse(*text, mission_file.string()) : Expected<JsonText>(fail(ErrorKind::input, ""));
  for (Fault& fault : faults) {
    if (!fault.file.empty()) continue;
    fault.file = mission_file.string();
    if (!json || fault.pointer.empty()) continue;
    fault.pointer = nearestPointer(*json, fault.pointer, json->root().contains("format"));
    fault.line = json->line(fault.pointer);
  }
}

}  // namespace world

Expected<Scenario> parseScenario(std::string_view text, std::string_view name, const std::filesystem::path& folder) {
  // Without a folder there is nothing that paths could be relative to; who opens the files then sees whether they are there.
  return readAs(FileKind::mission, text, name, world::readScenario(text, name, folder, !folder.empty()));
}

Expected<Scenario> loadScenario(const std::filesystem::path& path) {
  const auto text = readTextFile(path);
  if (!text) return tl::unexpected<Error>(text.error());
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  return parseScenario(*text, path.string(), folder);
}

}  // namespace npsee
