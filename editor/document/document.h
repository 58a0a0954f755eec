#pragma once

#include "editor/document/history.h"

#include <npsee/parameters.h>
#include <npsee/preset.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace npsee::editor {

/// A moment of the edited preset: the immutable value and what was selected in it.
struct Snapshot {
  std::shared_ptr<const Preset> preset;
  int layer = 0;
};
inline bool sameContent(const Snapshot& a, const Snapshot& b) { return a.preset == b.preset || *a.preset == *b.preset; }
using History = BasicHistory<Snapshot>;

/// The preset being edited with its file, selection and history. Knows no window, no GL and no ImGui. The preset is valid
/// at every moment: an edit that would break a rule of the preset as a whole is refused and changes nothing.
class Document {
 public:
  /// A new, unsaved preset with one layer.
  Document();

  const Preset& preset() const { return *now_.preset; }
  std::shared_ptr<const Preset> snapshot() const { return now_.preset; }
  /// Differs after every change of the preset, undo and load included.
  std::uint64_t revision() const { return revision_; }

  /// Index of the selected layer; 0 in a preset without layers, where `hasLayer()` is false.
  int selected() const { return now_.layer; }
  bool hasLayer() const { return !preset().layers.empty(); }
  const Layer& layer() const { return preset().layers[static_cast<std::size_t>(now_.layer)]; }
  /// Selecting is no edit: it is neither undone nor saved. Out-of-range indices are clamped.
  void select(int layer);

  /// Applies `change` to a copy and takes it over if it is valid and differs. `label` names the undo step; edits with the
  /// same nonempty `merge_key` are one step until endMerge(). Error kind usage: why the change was refused.
  Expected<void> edit(std::string_view label, std::string_view merge_key, const std::function<void(Preset&)>& change);
  /// One parameter of the burst or of the selected layer. Keeps parent and trigger consistent.
  Expected<void> assign(const Parameter& parameter, const Value& value, std::string_view merge_key = {});
  /// Value of a parameter of the burst or of the selected layer.
  Value value(const Parameter& parameter) const;
  void endMerge() { history_.endMerge(now_); }

  /// Layers of the list, each one undo step. A new layer is placed after the selected one and selected.
  Expected<void> addLayer();
  Expected<void> duplicateLayer();
  /// Layers that hang on the deleted one are deleted with it.
  Expected<void> deleteLayer();
  Expected<void> moveLayer(int by);
  Expected<void> renameLayer(std::string_view name);

  bool undo();
  bool redo();
  const History& history() const { return history_; }

  /// Path of the file, empty for a preset never saved.
  const std::filesystem::path& path() const { return path_; }
  /// File name without ".npsee.json", or "untitled".
  std::string name() const;
  /// True if the preset differs from what the file holds.
  bool dirty() const;

  void startNew();
  /// Errors leave the document as it was. Kinds input and output.
  Expected<void> load(const std::filesystem::path& path);
  Expected<void> save();
  /// The file that saving as `path` writes: adds ".npsee.json" where the name has no extension.
  static std::filesystem::path fileFor(const std::filesystem::path& path);
  /// Saves to fileFor(path), to which the document then belongs.
  Expected<void> saveAs(const std::filesystem::path& path);

 private:
  void become(Preset preset, std::filesystem::path path);
  void take(Snapshot snapshot);

  Snapshot now_;
  std::shared_ptr<const Preset> saved_;
  History history_;
  std::filesystem::path path_;
  std::uint64_t revision_ = 0;
};

}  // namespace npsee::editor
