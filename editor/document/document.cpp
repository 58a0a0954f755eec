#include "editor/document/document.h"

#include <npsee/fragments.h>

#include <algorithm>
#include <map>
#include <utility>

namespace npsee::editor {

std::vector<bool> withChildren(const Preset& preset, std::size_t root) {
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

Preset Snapshot::fresh() {
  Preset preset;
  preset.title = "New effect";
  Layer layer;
  layer.count = 100;  // the size of the thesis's own example
  preset.layers.push_back(layer);
  return preset;
}

void Snapshot::settle() { layer = std::clamp(layer, 0, std::max(0, static_cast<int>(content->layers.size()) - 1)); }

Expected<void> bringModels(const Preset& preset, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  for (const fs::path& file : modelFiles(preset)) {
    std::error_code error;
    const fs::path from = preset.folder.path / file, target = folder / file;
    if (!fs::is_regular_file(from, error) || fs::exists(target, error)) continue;
    fs::create_directories(target.parent_path(), error);
    if (!error) fs::copy_file(from, target, error);
    if (error) return fail(ErrorKind::output, target.string() + ", which the preset names, cannot be written: " + error.message() + ".", "Choose another folder, or copy it there by hand.");
  }
  return {};
}

Expected<Preset> Document::broughtTo(const std::filesystem::path& folder) const {
  if (auto brought = bringModels(preset(), folder); !brought) return tl::unexpected<Error>(brought.error());
  Preset moved = preset();
  moved.folder.path = folder;
  return moved;
}

void Document::select(int layer) {
  now_.layer = layer;
  now_.settle();
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
    const std::vector<bool> gone = withChildren(preset, static_cast<std::size_t>(selected()));
    std::vector<Layer> kept;
    for (std::size_t i = 0; i < gone.size(); ++i)
      if (!gone[i]) kept.push_back(std::move(preset.layers[i]));
    preset.layers = std::move(kept);
  });
  select(selected());
  return done;
}

Expected<void> Document::moveLayer(int by) {
  if (!hasLayer() || by == 0) return {};
  const int last = static_cast<int>(preset().layers.size()) - 1;
  int to = selected() + (by > 0 ? 1 : -1);
  // Layers in between hang on others: passing them would change nothing that is seen.
  while (to >= 0 && to <= last && preset().layers[static_cast<std::size_t>(to)].parent != layer().parent) to += by > 0 ? 1 : -1;
  if (to < 0 || to > last) return {};
  auto done = edit("Move layer", {}, [&](Preset& preset) {
    std::swap(preset.layers[static_cast<std::size_t>(selected())], preset.layers[static_cast<std::size_t>(to)]);
  });
  if (done) select(to);
  return done;
}

Expected<void> Document::placeLayer(int which, int target, Place place) {
  const int count = static_cast<int>(preset().layers.size());
  if (which < 0 || which >= count || target < 0 || target >= count || which == target) return {};
  if (withChildren(preset(), static_cast<std::size_t>(which))[static_cast<std::size_t>(target)])
    return fail(ErrorKind::usage, "A layer cannot hang on what hangs on it.", "Drop it on another layer.");
  const std::string name = preset().layers[static_cast<std::size_t>(which)].name, beside = preset().layers[static_cast<std::size_t>(target)].name;
  auto done = edit("Move layer", {}, [&](Preset& preset) {
    Layer layer = preset.layers[static_cast<std::size_t>(which)];
    preset.layers.erase(preset.layers.begin() + which);
    auto at = preset.layers.begin() + findLayer(preset, beside);
    layer.parent = place == Place::inside ? beside : at->parent;
    if (layer.parent.empty()) layer.trigger = Trigger::none;
    else if (layer.trigger == Trigger::none) layer.trigger = Trigger::birth;
    preset.layers.insert(place == Place::before ? at : at + 1, std::move(layer));
  });
  if (done) select(findLayer(preset(), name));
  return done;
}

Expected<void> Document::insertLayers(const std::vector<Layer>& layers, std::string_view label) {
  const std::size_t at = hasLayer() ? static_cast<std::size_t>(selected()) + 1 : 0;
  auto done = edit(label, {}, [&](Preset& preset) {
    std::map<std::string, std::string> renamed;
    std::vector<Layer> added = layers;
    for (std::size_t i = 0; i < added.size(); ++i) {
      added[i].name = renamed[layers[i].name] = freeLayerName(preset, layers[i].name);
      preset.layers.insert(preset.layers.begin() + static_cast<std::ptrdiff_t>(at + i), added[i]);
    }
    for (std::size_t i = 0; i < added.size(); ++i)
      if (const auto found = renamed.find(layers[i].parent); found != renamed.end()) preset.layers[at + i].parent = found->second;
  });
  if (done) select(static_cast<int>(at));
  return done;
}

Expected<void> Document::renameLayer(std::string_view name) {
  if (!hasLayer()) return fail(ErrorKind::usage, "There is no layer to rename.");
  if (name == layer().name) return {};
  Expected<void> renamed;
  auto done = edit("Rename layer", {}, [&](Preset& preset) { renamed = npsee::renameLayer(preset, static_cast<std::size_t>(selected()), name); });
  return renamed ? done : renamed;
}

}  // namespace npsee::editor
