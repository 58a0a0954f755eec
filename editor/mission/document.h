#pragma once

#include "editor/document/history.h"
#include "editor/mission/objects.h"

#include <npsee/mission.h>

#include <cstdint>
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
  std::shared_ptr<const Scenario> scenario;
  std::shared_ptr<const MissionCommands> commands;
  ObjectRef selected;
};
inline bool sameContent(const MissionSnapshot& a, const MissionSnapshot& b) {
  return (a.scenario == b.scenario || *a.scenario == *b.scenario) && (a.commands == b.commands || *a.commands == *b.commands);
}
using MissionHistory = BasicHistory<MissionSnapshot>;

/// The mission being edited with its file, selection and history. Knows no window, no GL and no ImGui. The scenario is valid at
/// every moment: an edit that would break one of its rules is refused and changes nothing.
class MissionDocument {
 public:
  /// A new, unsaved mission: flat ground and nothing on it.
  MissionDocument();

  const Scenario& scenario() const { return *now_.scenario; }
  std::shared_ptr<const Scenario> snapshot() const { return now_.scenario; }
  std::shared_ptr<const MissionCommands> commands() const { return now_.commands; }
  /// Differs after every change of scenario or commands, undo and load included.
  std::uint64_t revision() const { return revision_; }

  const ObjectRef& selected() const { return now_.selected; }
  /// Selecting is no edit. What is selected need not be in the scenario: a facts file may bring it.
  void select(const ObjectRef& ref) { now_.selected = ref; }

  /// Applies `change` to a copy and takes it over if it is valid and differs. `label` names the undo step; edits with the same
  /// nonempty `merge_key` are one step until endMerge(). Error kind usage: why the change was refused.
  Expected<void> edit(std::string_view label, std::string_view merge_key, const std::function<void(Scenario&)>& change);
  /// The same for what a person did during the mission.
  void command(std::string_view label, std::string_view merge_key, MissionCommands commands);
  void endMerge() { history_.endMerge(now_); }

  /// Edits that change what is selected.
  Expected<void> add(std::string_view label, const std::function<ObjectRef(Scenario&)>& change);
  Expected<void> duplicateSelected();
  Expected<void> removeSelected();
  Expected<void> renameObject(const ObjectRef& ref, const std::string& name);

  bool undo();
  bool redo();
  const MissionHistory& history() const { return history_; }

  const std::filesystem::path& path() const { return path_; }
  /// File name without ".mission.json", or "untitled".
  std::string name() const;
  /// True if the scenario differs from what the file holds.
  bool dirty() const;

  void startNew();
  /// Errors leave the document as it was. Kinds input and output.
  Expected<void> load(const std::filesystem::path& path);
  Expected<void> save();
  /// The file that saving as `path` writes: adds ".mission.json" where the name has no extension.
  static std::filesystem::path fileFor(const std::filesystem::path& path);
  /// Saves to fileFor(path), to which the document then belongs. Files beside it that the mission names are
  /// copied along.
  Expected<void> saveAs(const std::filesystem::path& path);

 private:
  void become(Scenario scenario, std::filesystem::path path);
  void take(MissionSnapshot snapshot);

  MissionSnapshot now_;
  std::shared_ptr<const Scenario> saved_;
  MissionHistory history_;
  std::filesystem::path path_;
  std::uint64_t revision_ = 0;
};

/// True for a name that the editor opens as a mission.
bool isMissionFile(const std::filesystem::path& path);

}  // namespace npsee::editor
