#pragma once

#include "editor/document/edited_document.h"
#include "editor/mission/objects.h"

#include <npsee/mission.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace npsee::editor {

using MissionCommands = std::vector<MissionCommand>;

/// A moment of the edited mission: the immutable scenario, and what a person did in it. Commands are not saved with the mission,
/// but undone like any edit.
struct MissionSnapshot {
  using Content = Scenario;
  static constexpr std::string_view kWhat = "mission", kEnding = kMissionEnding;
  /// Flat ground and nothing on it.
  static Scenario fresh();
  static Expected<Scenario> read(const std::filesystem::path& path) { return loadScenario(path); }
  static Expected<void> write(const Scenario& scenario, const std::filesystem::path& path) { return saveScenario(scenario, path); }
  static std::string text(const Scenario& scenario) { return scenarioText(scenario); }
  static const std::filesystem::path& folderOf(const Scenario& scenario) { return scenario.folder; }
  static Expected<Scenario> parse(std::string_view text, const std::filesystem::path& path) { return parseScenario(text, path.string(), path.parent_path()); }

  std::shared_ptr<const Scenario> content;
  std::shared_ptr<const MissionCommands> commands = std::make_shared<const MissionCommands>();
  ObjectRef selected;
  // What is selected need not be in the scenario: a facts file may bring it.
  void settle() {}
};
inline bool sameContent(const MissionSnapshot& a, const MissionSnapshot& b) {
  return (a.content == b.content || *a.content == *b.content) && (a.commands == b.commands || *a.commands == *b.commands);
}
using MissionHistory = BasicHistory<MissionSnapshot>;

/// The mission being edited with its file, selection and history. Knows no window, no GL and no ImGui.
class MissionDocument : public EditedDocument<MissionSnapshot> {
 public:
  const Scenario& scenario() const { return content(); }
  std::shared_ptr<const MissionCommands> commands() const { return now_.commands; }

  const ObjectRef& selected() const { return now_.selected; }
  /// Selecting is no edit. What is selected need not be in the scenario: a facts file may bring it.
  void select(const ObjectRef& ref) { now_.selected = ref; }

  /// Edits what a person did during the mission, as edit() does the scenario.
  void command(std::string_view label, std::string_view merge_key, MissionCommands commands);

  /// Edits that change what is selected.
  Expected<void> add(std::string_view label, const std::function<ObjectRef(Scenario&)>& change);
  Expected<void> duplicateSelected();
  Expected<void> removeSelected();
  Expected<void> renameObject(const ObjectRef& ref, const std::string& name);

 protected:
  /// Files beside it that the mission names are copied along.
  Expected<Scenario> broughtTo(const std::filesystem::path& folder) const override;
};

/// True for a file that the editor opens as a mission: by its ending, or by what it holds where it has neither kind's.
bool isMissionFile(const std::filesystem::path& path);

}  // namespace npsee::editor
