#pragma once

#include "editor/document/edited_document.h"

#include <npsee/parameters.h>
#include <npsee/preset.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace npsee::editor {

/// A moment of the edited preset: the immutable value and what was selected in it.
struct Snapshot {
  using Content = Preset;
  static constexpr std::string_view kWhat = "preset", kEnding = kPresetEnding;
  /// One layer, so that there is something to see.
  static Preset fresh();
  static Expected<Preset> read(const std::filesystem::path& path) { return loadPreset(path); }
  static Expected<void> write(const Preset& preset, const std::filesystem::path& path) { return savePreset(preset, path); }
  static std::string text(const Preset& preset) { return presetText(preset); }
  static const std::filesystem::path& folderOf(const Preset& preset) { return preset.folder.path; }
  static Expected<Preset> parse(std::string_view text, const std::filesystem::path& path) { return parsePreset(text, path.string(), path.parent_path()); }

  std::shared_ptr<const Preset> content;
  int layer = 0;
  /// The selected layer is one of the preset's.
  void settle();
};
inline bool sameContent(const Snapshot& a, const Snapshot& b) { return a.content == b.content || *a.content == *b.content; }
using History = BasicHistory<Snapshot>;

/// Puts the models that a preset names beside its file (Preset::folder), and their colours, into another folder, where it is to be read as well.
/// A file that is there already stays. Error kind output.
Expected<void> bringModels(const Preset& preset, const std::filesystem::path& folder);

/// The preset being edited with its file, selection and history. Knows no window, no GL and no ImGui.
class Document : public EditedDocument<Snapshot> {
 public:
  const Preset& preset() const { return content(); }

  /// Index of the selected layer; 0 in a preset without layers, where `hasLayer()` is false.
  int selected() const { return now_.layer; }
  bool hasLayer() const { return !preset().layers.empty(); }
  const Layer& layer() const { return preset().layers[static_cast<std::size_t>(now_.layer)]; }
  /// Selecting is no edit: it is neither undone nor saved. Out-of-range indices are clamped.
  void select(int layer);

  /// One parameter of the burst or of the selected layer. Keeps parent and trigger consistent.
  Expected<void> assign(const Parameter& parameter, const Value& value, std::string_view merge_key = {});
  /// Value of a parameter of the burst or of the selected layer.
  Value value(const Parameter& parameter) const;

  /// Layers of the list, each one undo step. A new layer is placed after the selected one and selected.
  Expected<void> addLayer();
  Expected<void> duplicateLayer();
  /// Layers that hang on the deleted one are deleted with it.
  Expected<void> deleteLayer();
  /// Past the next (by = 1) or previous (-1) layer that hangs on the same.
  Expected<void> moveLayer(int by);
  /// Puts a layer, with what hangs on it, before or after another, or hangs it on that one.
  enum class Place { before, after, inside };
  Expected<void> placeLayer(int layer, int target, Place place);
  /// Adds layers after the selected one; names that are taken become free ones, and parents among the layers follow.
  Expected<void> insertLayers(const std::vector<Layer>& layers, std::string_view label);
  Expected<void> renameLayer(std::string_view name);

 protected:
  /// Models that lay beside the file it was read from are taken along.
  Expected<Preset> broughtTo(const std::filesystem::path& folder) const override;
};

/// By index: the layer and every one that hangs on it, directly or not.
std::vector<bool> withChildren(const Preset& preset, std::size_t layer);

}  // namespace npsee::editor
