#include "editor/document/clipboard.h"

#include "sim/core/json_text.h"
#include "sim/core/text.h"
#include "sim/preset/json_values.h"

#include <nlohmann/json.hpp>

#include <map>

namespace npsee::editor {
namespace {

using nlohmann::ordered_json;

constexpr const char* kRemedy = "Copy a layer or a section first, or the text of a preset's file.";

tl::unexpected<Error> unfit(const Error& error) {
  Error out{ErrorKind::input, error.faults};
  out.faults.insert(out.faults.begin(), Fault{.what = "The clipboard holds nothing that can be pasted.", .remedy = kRemedy, .file = {}, .line = 0, .pointer = {}});
  if (out.faults.size() > 4) out.faults.resize(4);  // a whole book in the clipboard needs no more
  return tl::unexpected<Error>(std::move(out));
}

/// What a layer from the clipboard hung on outside of it.
struct Hook {
  std::string parent;
  Trigger trigger = Trigger::birth;
};

std::string textOf(const ordered_json& json, const char* key) { return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string(); }

/// Takes parents out of `layers` that are not among them, which a preset would not allow.
std::map<std::string, Hook> unhook(ordered_json& layers) {
  std::map<std::string, Hook> out;
  if (!layers.is_array()) return out;
  const Parameter& trigger = *findParameter(Scope::layer, "trigger");
  for (ordered_json& layer : layers) {
    if (!layer.is_object()) continue;
    const std::string parent = textOf(layer, "parent"), event = textOf(layer, "trigger");
    const bool inside = std::ranges::any_of(layers, [&](const ordered_json& other) { return other.is_object() && textOf(other, "name") == parent; });
    if (parent.empty() || inside) continue;
    Layer hung;
    if (!event.empty() && checkValue(trigger, event).empty()) trigger.assign(hung, event);
    if (hung.trigger == Trigger::none) hung.trigger = Trigger::birth;
    out[textOf(layer, "name")] = {parent, hung.trigger};
    layer.erase("parent");
    if (checkValue(trigger, event).empty()) layer.erase("trigger");
  }
  return out;
}

std::string plural(std::size_t count, const std::string& word) { return std::to_string(count) + ' ' + word + (count == 1 ? "" : "s"); }

Expected<std::string> pasteLayers(Document& document, const JsonText& json) {
  ordered_json root = json.root();
  const std::map<std::string, Hook> hooks = unhook(root["layers"]);
  const auto parsed = parsePreset(root.dump(2), "clipboard");
  if (!parsed) return unfit(parsed.error());
  if (parsed->layers.empty()) return unfit(Error{ErrorKind::input, {{.what = "Its list of layers is empty.", .remedy = {}, .file = {}, .line = 0, .pointer = {}}}});
  std::vector<Layer> layers = parsed->layers;
  std::string missing;
  for (Layer& layer : layers) {
    const auto hook = hooks.find(layer.name);
    if (hook == hooks.end()) continue;
    if (findLayer(document.preset(), hook->second.parent) < 0) {
      missing = hook->second.parent;
      continue;
    }
    layer.parent = hook->second.parent;
    layer.trigger = hook->second.trigger;
  }
  if (auto done = document.insertLayers(layers, "Paste"); !done) return tl::unexpected<Error>(done.error());
  std::string note = "Pasted " + plural(parsed->layers.size(), "layer") + '.';
  if (!missing.empty()) note += " There is no layer " + missing + " here, so that what hung on it hangs on the burst.";
  return note;
}

struct Setting {
  const Parameter* row = nullptr;
  Value value;
};

/// The settings of the object at `base`, groups in it by a dot, as in files.
void readSettings(const JsonText& json, const std::string& base, const std::string& prefix, std::vector<Setting>& out, std::vector<Fault>& faults) {
  for (const auto& [key, value] : json.root().at(ordered_json::json_pointer(base)).items()) {
    const std::string full = prefix + key, pointer = base + '/' + pointerToken(key);
    const Parameter* row = findParameter(Scope::layer, full);
    if (row == nullptr) row = findParameter(Scope::burst, full);
    if (row != nullptr) {
      if (auto read = valueFromJson(*row, json, pointer, faults)) out.push_back({row, std::move(*read)});
    } else if (value.is_object()) {
      readSettings(json, pointer, full + '.', out, faults);
    } else {
      std::vector<std::string_view> known;
      for (const Parameter& other : parameters()) known.push_back(other.key);
      const auto near = nearest(full, known);
      faults.push_back(json.fault(pointer, "there is no such parameter.", near ? "Did you mean " + std::string(*near) + "?" : ""));
    }
  }
}

Expected<std::string> pasteSettings(Document& document, const JsonText& json) {
  std::vector<Setting> settings;
  std::vector<Fault> faults;
  if (!json.root()["parameters"].is_object()) faults.push_back(json.fault("/parameters", "parameters must be an object { ... }."));
  else readSettings(json, "/parameters", {}, settings, faults);
  if (!faults.empty()) return unfit(Error{ErrorKind::input, std::move(faults)});
  std::erase_if(settings, [](const Setting& setting) { return setting.row->scope == Scope::layer && setting.row->key == "name"; });
  const bool layered = std::ranges::any_of(settings, [](const Setting& setting) { return setting.row->scope == Scope::layer; });
  if (layered && !document.hasLayer()) return fail(ErrorKind::input, "There is no layer that could take the parameters.", "Add a layer first.");
  const auto done = document.edit("Paste parameters", {}, [&](Preset& preset) {
    for (const Setting& setting : settings) {
      if (setting.row->scope == Scope::burst) setting.row->assign(preset, setting.value);
      else setting.row->assign(preset.layers[static_cast<std::size_t>(document.selected())], setting.value);
    }
    if (!layered) return;
    Layer& layer = preset.layers[static_cast<std::size_t>(document.selected())];
    if (layer.parent.empty()) layer.trigger = Trigger::none;
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return "Pasted " + plural(settings.size(), "parameter") + (layered ? " into " + document.layer().name : std::string()) + '.';
}

}  // namespace

std::string layerText(const Preset& preset, int layer) {
  Preset out;
  const std::vector<bool> in = withChildren(preset, static_cast<std::size_t>(layer));
  for (std::size_t i = 0; i < in.size(); ++i)
    if (in[i]) out.layers.push_back(preset.layers[i]);
  return presetText(out);
}

std::string sectionText(const Preset& preset, const Layer* layer, Section section) {
  ordered_json values = ordered_json::object();
  for (const Parameter& row : parameters()) {
    if (row.section != section || (row.scope == Scope::layer && (layer == nullptr || row.key == "name"))) continue;
    ordered_json* place = &values;
    for (const std::string_view part : splitAt(row.key, '.')) place = &(*place)[std::string(part)];
    *place = valueToJson(row, row.scope == Scope::burst ? row.get(preset) : row.get(*layer));
  }
  return ordered_json{{"npsee", kPresetVersion}, {"parameters", std::move(values)}}.dump(2) + '\n';
}

Expected<std::string> paste(Document& document, std::string_view text) {
  if (trimmed(text).empty()) return fail(ErrorKind::input, "The clipboard is empty.", kRemedy);
  auto json = JsonText::parse(text, "clipboard");
  if (!json) return unfit(json.error());
  const ordered_json& root = json->root();
  if (!root.is_object() || !(root.contains("layers") || root.contains("parameters"))) return unfit(Error{ErrorKind::input, {json->fault("", "it is JSON, but has neither layers nor parameters.")}});
  return root.contains("layers") ? pasteLayers(document, *json) : pasteSettings(document, *json);
}

}  // namespace npsee::editor
