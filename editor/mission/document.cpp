#include "editor/mission/document.h"

#include "editor/document/document.h"
#include "sim/core/file_kind.h"

#include <algorithm>
#include <utility>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

/// The files beside the mission that it names. A name without a file there is that of something shipped.
std::vector<fs::path> namedFiles(const Scenario& scenario) {
  std::vector<fs::path> out{scenario.weapons, scenario.facts, scenario.world.terrain.file};
  for (const ObserverSetup& observer : scenario.observers) out.push_back(observer.rules);
  for (const BatterySetup& battery : scenario.batteries) {
    out.emplace_back(battery.preset);
    out.emplace_back(battery.projectile);
  }
  std::error_code ignored;
  std::erase_if(out, [&](const fs::path& file) { return file.empty() || file.is_absolute() || !fs::is_regular_file(scenario.folder / file, ignored); });
  return out;
}

/// A battery's own preset may name models beside itself.
Expected<void> takeModelsAlong(const Scenario& scenario, const fs::path& folder) {
  std::error_code ignored;
  for (const BatterySetup& battery : scenario.batteries) {
    const fs::path file = battery.preset;
    if (file.empty() || file.is_absolute() || !fs::is_regular_file(scenario.folder / file, ignored)) continue;
    // One that cannot be read says so where it is shown.
    if (const auto preset = loadPreset(scenario.folder / file))
      if (auto brought = bringModels(*preset, (folder / file).parent_path()); !brought) return brought;
  }
  return {};
}

/// A mission names only files in its own folder or below: saved elsewhere, it takes them along. A file that is there already stays.
Expected<void> takeFilesAlong(const Scenario& scenario, const fs::path& folder) {
  for (const fs::path& file : namedFiles(scenario)) {
    std::error_code error;
    const fs::path target = folder / file;
    if (fs::exists(target, error)) continue;
    fs::create_directories(target.parent_path(), error);
    if (!error) fs::copy_file(scenario.folder / file, target, error);
    if (error) return fail(ErrorKind::output, target.string() + ", which the mission names, cannot be written: " + error.message() + ".", "Choose another folder, or copy it there by hand.");
  }
  return takeModelsAlong(scenario, folder);
}

}  // namespace

bool isMissionFile(const fs::path& path) {
  const std::string name = path.filename().string();
  if (name.ends_with(kMissionEnding) || name.ends_with(kPresetEnding)) return name.ends_with(kMissionEnding);
  return fileKindAt(path) == FileKind::mission;
}

Scenario MissionSnapshot::fresh() {
  Scenario scenario;
  scenario.title = "New mission";
  scenario.world.size_x_m = scenario.world.size_z_m = 10000.0;
  return scenario;
}

void MissionDocument::command(std::string_view label, std::string_view merge_key, MissionCommands commands) {
  if (commands == *now_.commands) return;
  record(label, merge_key);
  MissionSnapshot next = now_;
  next.commands = std::make_shared<const MissionCommands>(std::move(commands));
  take(std::move(next));
}

Expected<void> MissionDocument::add(std::string_view label, const std::function<ObjectRef(Scenario&)>& change) {
  ObjectRef added;
  auto done = edit(label, {}, [&](Scenario& scenario) { added = change(scenario); });
  if (done) select(added);
  return done;
}

Expected<void> MissionDocument::duplicateSelected() {
  if (selected().kind == ObjectRef::Kind::mission) return fail(ErrorKind::usage, "Nothing is selected that could be duplicated.", "Select a vehicle, gun, battery or observer.");
  return add("Duplicate " + std::string(kindName(selected().kind)), [this](Scenario& scenario) { return duplicate(scenario, selected()).value_or(selected()); });
}

Expected<void> MissionDocument::removeSelected() {
  if (selected().kind == ObjectRef::Kind::mission) return fail(ErrorKind::usage, "Nothing is selected that could be deleted.", "Select a vehicle, gun, battery or observer.");
  auto done = edit("Delete " + std::string(kindName(selected().kind)), {}, [this](Scenario& scenario) { remove(scenario, selected()); });
  if (done && !exists(scenario(), selected())) select({});
  return done;
}

Expected<void> MissionDocument::renameObject(const ObjectRef& ref, const std::string& name) {
  if (ref.kind == ObjectRef::Kind::mission || name == ref.id) return {};
  const auto names = allNames(scenario());
  if (std::ranges::find(names, name) != names.end()) return fail(ErrorKind::usage, "There is already something called \"" + printable(name) + "\".", "Choose another name.");
  const bool chosen = ref == selected();
  const ObjectRef renamed{ref.kind, name};
  auto done = edit("Rename " + std::string(kindName(ref.kind)), {}, [&](Scenario& scenario) { rename(scenario, ref, name); });
  if (done && chosen) select(renamed);
  return done;
}

Expected<Scenario> MissionDocument::broughtTo(const fs::path& folder) const {
  if (auto done = takeFilesAlong(scenario(), folder); !done) return tl::unexpected<Error>(std::move(done.error()));
  Scenario moved = scenario();
  moved.folder = folder;
  return moved;
}

}  // namespace npsee::editor
