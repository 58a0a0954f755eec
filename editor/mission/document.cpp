#include "editor/mission/document.h"

#include <algorithm>
#include <utility>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".mission.json";

Scenario starter() {
  Scenario scenario;
  scenario.title = "New mission";
  scenario.world.size_x_m = scenario.world.size_z_m = 10000.0;
  return scenario;
}

std::shared_ptr<const MissionCommands> noCommands() { return std::make_shared<const MissionCommands>(); }

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
  return {};
}

}  // namespace

bool isMissionFile(const fs::path& path) { return path.filename().string().ends_with(kEnding); }

MissionDocument::MissionDocument() { startNew(); }

Expected<void> MissionDocument::edit(std::string_view label, std::string_view merge_key, const std::function<void(Scenario&)>& change) {
  Scenario changed = scenario();
  change(changed);
  if (changed == scenario()) return {};
  if (const std::vector<Fault> faults = validate(changed); !faults.empty()) return fail(ErrorKind::usage, faults.front());
  history_.record(now_, label, merge_key);
  take({std::make_shared<const Scenario>(std::move(changed)), now_.commands, now_.selected});
  return {};
}

void MissionDocument::command(std::string_view label, std::string_view merge_key, MissionCommands commands) {
  if (commands == *now_.commands) return;
  history_.record(now_, label, merge_key);
  take({now_.scenario, std::make_shared<const MissionCommands>(std::move(commands)), now_.selected});
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

bool MissionDocument::undo() {
  if (!history_.canUndo()) return false;
  endMerge();
  if (history_.canUndo()) take(history_.undo(now_));
  return true;
}

bool MissionDocument::redo() {
  if (!history_.canRedo()) return false;
  take(history_.redo(now_));
  return true;
}

std::string MissionDocument::name() const {
  if (path_.empty()) return "untitled";
  std::string name = path_.filename().string();
  for (const std::string_view ending : {kEnding, std::string_view(".json")})
    if (name.size() > ending.size() && name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

bool MissionDocument::dirty() const { return now_.scenario != saved_ && *now_.scenario != *saved_; }

void MissionDocument::startNew() { become(starter(), {}); }

Expected<void> MissionDocument::load(const fs::path& path) {
  auto scenario = loadScenario(path);
  if (!scenario) return tl::unexpected<Error>(std::move(scenario.error()));
  become(std::move(*scenario), path);
  return {};
}

Expected<void> MissionDocument::save() {
  if (path_.empty()) return fail(ErrorKind::output, "The mission has no file yet.", "Use Save as and give it a name.");
  auto done = saveScenario(scenario(), path_);
  if (done) saved_ = now_.scenario;
  return done;
}

fs::path MissionDocument::fileFor(const fs::path& path) {
  fs::path out = path;
  if (!out.filename().empty() && out.extension().empty()) out += kEnding;
  return out;
}

Expected<void> MissionDocument::saveAs(const fs::path& path) {
  fs::path target = fileFor(path);
  if (target.filename().empty()) return fail(ErrorKind::output, "The name of the file is missing.", "Write a name after the folder.");
  Scenario moved = scenario();
  moved.folder = target.parent_path();
  auto done = takeFilesAlong(scenario(), moved.folder);
  if (done) done = saveScenario(moved, target);
  if (!done) return done;
  if (moved != scenario()) take({std::make_shared<const Scenario>(std::move(moved)), now_.commands, now_.selected});
  saved_ = now_.scenario;
  path_ = std::move(target);
  return done;
}

void MissionDocument::become(Scenario scenario, fs::path path) {
  now_ = {std::make_shared<const Scenario>(std::move(scenario)), noCommands(), {}};
  saved_ = now_.scenario;
  path_ = std::move(path);
  history_.clear();
  ++revision_;
}

void MissionDocument::take(MissionSnapshot snapshot) {
  now_ = std::move(snapshot);
  ++revision_;
}

}  // namespace npsee::editor
