#include "editor/document/document.h"

#include <algorithm>
#include <utility>

namespace npsee::editor {
namespace {

Preset starter() {
  Preset preset;
  preset.title = "New effect";
  Layer layer;
  layer.count = 100;  // the size of the thesis's own example
  preset.layers.push_back(layer);
  return preset;
}

/// Indices of `root` and of every layer that hangs on it, directly or not.
std::vector<bool> subtree(const Preset& preset, std::size_t root) {
  std::vector<bool> in(preset.layers.size(), false);
  in[root] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const int parent = in[i] || preset.layers[i].parent.empty() ? -1 : findLayer(preset, preset.layers[i].parent);
      if (parent >= 0 && in[static_cast<std::size_t>(parent)]) in[i] = grown = true;
    }
  }
  return in;
}

}  // namespace

Document::Document() { startNew(); }

void Document::select(int layer) {
  now_.layer = std::clamp(layer, 0, std::max(0, static_cast<int>(preset().layers.size()) - 1));
}

Expected<void> Document::edit(std::string_view label, std::string_view merge_key, const std::function<void(Preset&)>& change) {
  Preset changed = preset();
  change(changed);
  if (changed == preset()) return {};
  if (const std::vector<Fault> faults = validate(changed); !faults.empty()) return fail(ErrorKind::usage, faults.front());
  history_.record(now_, label, merge_key);
  take({std::make_shared<const Preset>(std::move(changed)), now_.layer});
  return {};
}

Expected<void> Document::assign(const Parameter& parameter, const Value& value, std::string_view merge_key) {
  if (parameter.scope == Scope::layer && !hasLayer()) return fail(ErrorKind::usage, "There is no layer to change.", "Add a layer first.");
  if (parameter.scope == Scope::layer && parameter.key == "name") return renameLayer(std::get<std::string>(value));
  if (std::string wrong = checkValue(parameter, value); !wrong.empty()) return fail(ErrorKind::usage, std::move(wrong));
  return edit(parameter.label, merge_key, [&](Preset& preset) {
    if (parameter.scope == Scope::burst) return parameter.assign(preset, value);
    Layer& layer = preset.layers[static_cast<std::size_t>(now_.layer)];
    parameter.assign(layer, value);
    if (parameter.key != "parent") return;
    // A layer hangs on another by an event, and on the burst by none.
    if (layer.parent.empty()) layer.trigger = Trigger::none;
    else if (layer.trigger == Trigger::none) layer.trigger = Trigger::birth;
  });
}

Value Document::value(const Parameter& parameter) const {
  return parameter.scope == Scope::burst ? parameter.get(preset()) : parameter.get(layer());
}

Expected<void> Document::addLayer() {
  const std::size_t at = hasLayer() ? static_cast<std::size_t>(selected()) + 1 : 0;
  auto done = edit("Add layer", {}, [at](Preset& preset) {
    Layer layer;
    layer.name = freeLayerName(preset, "layer");
    layer.count = 100;
    preset.layers.insert(preset.layers.begin() + static_cast<std::ptrdiff_t>(at), layer);
  });
  if (done) select(static_cast<int>(at));
  return done;
}

Expected<void> Document::duplicateLayer() {
  if (!hasLayer()) return fail(ErrorKind::usage, "There is no layer to duplicate.");
  const std::size_t at = static_cast<std::size_t>(selected()) + 1;
  auto done = edit("Duplicate layer", {}, [at](Preset& preset) {
    Layer layer = preset.layers[at - 1];
    layer.name = freeLayerName(preset, layer.name);
    preset.layers.insert(preset.layers.begin() + static_cast<std::ptrdiff_t>(at), layer);
  });
  if (done) select(static_cast<int>(at));
  return done;
}

Expected<void> Document::deleteLayer() {
  if (!hasLayer()) return fail(ErrorKind::usage, "There is no layer to delete.");
  auto done = edit("Delete layer", {}, [this](Preset& preset) {
    const std::vector<bool> gone = subtree(preset, static_cast<std::size_t>(selected()));
    std::vector<Layer> kept;
    for (std::size_t i = 0; i < gone.size(); ++i)
      if (!gone[i]) kept.push_back(std::move(preset.layers[i]));
    preset.layers = std::move(kept);
  });
  select(selected());
  return done;
}

Expected<void> Document::moveLayer(int by) {
  const int to = selected() + by;
  if (!hasLayer() || to < 0 || to >= static_cast<int>(preset().layers.size())) return {};
  auto done = edit("Move layer", {}, [&](Preset& preset) {
    std::swap(preset.layers[static_cast<std::size_t>(selected())], preset.layers[static_cast<std::size_t>(to)]);
  });
  if (done) select(to);
  return done;
}

Expected<void> Document::renameLayer(std::string_view name) {
  if (!hasLayer()) return fail(ErrorKind::usage, "There is no layer to rename.");
  if (name == layer().name) return {};
  Expected<void> renamed;
  auto done = edit("Rename layer", {}, [&](Preset& preset) { renamed = npsee::renameLayer(preset, static_cast<std::size_t>(selected()), name); });
  return renamed ? done : renamed;
}

bool Document::undo() {
  if (!history_.canUndo()) return false;
  endMerge();
  if (history_.canUndo()) take(history_.undo(now_));
  return true;
}

bool Document::redo() {
  if (!history_.canRedo()) return false;
  take(history_.redo(now_));
  return true;
}

std::string Document::name() const {
  if (path_.empty()) return "untitled";
  std::string name = path_.filename().string();
  for (const std::string_view ending : {".npsee.json", ".json"})
    if (name.size() > ending.size() && name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

bool Document::dirty() const { return now_.preset != saved_ && *now_.preset != *saved_; }

void Document::startNew() { become(starter(), {}); }

Expected<void> Document::load(const std::filesystem::path& path) {
  auto preset = loadPreset(path);
  if (!preset) return tl::unexpected<Error>(std::move(preset.error()));
  become(std::move(*preset), path);
  return {};
}

Expected<void> Document::save() {
  if (path_.empty()) return fail(ErrorKind::output, "The preset has no file yet.", "Use Save as and give it a name.");
  auto done = savePreset(preset(), path_);
  if (done) saved_ = now_.preset;
  return done;
}

std::filesystem::path Document::fileFor(const std::filesystem::path& path) {
  std::filesystem::path out = path;
  if (!out.filename().empty() && out.extension().empty()) out += ".npsee.json";
  return out;
}

Expected<void> Document::saveAs(const std::filesystem::path& path) {
  std::filesystem::path target = fileFor(path);
  if (target.filename().empty()) return fail(ErrorKind::output, "The name of the file is missing.", "Write a name after the folder.");
  auto done = savePreset(preset(), target);
  if (!done) return done;
  saved_ = now_.preset;
  path_ = std::move(target);
  return done;
}

void Document::become(Preset preset, std::filesystem::path path) {
  now_ = {std::make_shared<const Preset>(std::move(preset)), 0};
  saved_ = now_.preset;
  path_ = std::move(path);
  history_.clear();
  ++revision_;
}

void Document::take(Snapshot snapshot) {
  now_ = std::move(snapshot);
  select(now_.layer);
  ++revision_;
}

}  // namespace npsee::editor
