#include <npsee/parameters.h>

#include "sim/core/file_kind.h"
#include "sim/core/files.h"
#include "sim/core/json_text.h"
#include "sim/core/text.h"
#include "sim/preset/json_values.h"
#include "sim/preset/validate.h"

#include <nlohmann/json.hpp>

namespace npsee {
namespace {

using nlohmann::ordered_json;

/// Reads all rows of one scope from the object at `base` into `object`; keys that no row has are faults.
template <class Object>
class ObjectReader {
 public:
  ObjectReader(Scope scope, const JsonText& json, std::string base, Object& object, std::vector<Fault>& faults)
      : scope_(scope), json_(json), base_(std::move(base)), object_(object), faults_(faults) {}

  /// `extra` keys at the top belong to the caller.
  void read(const std::vector<std::string_view>& extra) { readObject("", extra); }

 private:
  void readObject(const std::string& prefix, const std::vector<std::string_view>& extra) {
    const std::string pointer = base_ + slashed(prefix);
    const ordered_json& here = json_.root().at(ordered_json::json_pointer(pointer));
    for (const auto& [key, value] : here.items()) {
      if (std::ranges::find(extra, key) != extra.end()) continue;
      const std::string full = prefix.empty() ? key : prefix + '.' + key;
      const std::string child = pointer + '/' + pointerToken(key);
      if (const Parameter* row = key.find('.') == std::string::npos ? findParameter(scope_, full) : nullptr) {
        if (const auto read = valueFromJson(*row, json_, child, faults_)) row->assign(object_, *read);
      } else if (isGroup(full)) {
        if (value.is_object()) readObject(full, {});
        else faults_.push_back(json_.fault(child, full + " is " + std::string(jsonTypeName(value)) + ", but must be an object.", ""));
      } else {
        faults_.push_back(json_.fault(child, "there is no such parameter.", remedyFor(full, extra)));
      }
    }
  }

  static std::string slashed(const std::string& prefix) {
    std::string out;
    if (prefix.empty()) return out;
    for (const std::string_view part : splitAt(prefix, '.')) out += '/' + std::string(part);
    return out;
  }

  bool isGroup(const std::string& key) const {
    for (const Parameter& row : parameters(scope_))
      if (row.key.starts_with(key + '.')) return true;
    return false;
  }

  std::string remedyFor(const std::string& key, const std::vector<std::string_view>& extra) const {
    std::vector<std::string_view> known(extra.begin(), extra.end());
    for (const Parameter& row : parameters(scope_)) known.push_back(row.key);
    if (const auto near = nearest(key, known)) return "Did you mean " + std::string(*near) + "?";
    return "`npsee params` lists all parameters.";
  }

  Scope scope_;
  const JsonText& json_;
  std::string base_;
  Object& object_;
  std::vector<Fault>& faults_;
};

/// Version of the file; a fault if it is missing, unfit or newer than this program.
void checkVersion(const JsonText& json, std::vector<Fault>& faults) {
  const ordered_json& root = json.root();
  const std::string current = std::to_string(kPresetVersion);
  if (!root.contains("npsee")) {
    faults.push_back(json.fault("", "the file's version is missing.", "Add \"npsee\": " + current + " as the first key."));
    return;
  }
  const ordered_json& version = root["npsee"];
  if (!version.is_number_integer() || version.get<double>() < 1.0) {
    faults.push_back(json.fault("/npsee", "the version must be a whole number from 1.", "This program writes \"npsee\": " + current + "."));
  } else if (version.get<double>() > kPresetVersion) {
    faults.push_back(json.fault("/npsee", "the file has version " + version.dump() + ", newer than " + current + ", the newest this program reads.",
                                "Use a newer npsee, or save the preset for version " + current + "."));
  }
}

void readLayers(const JsonText& json, Preset& preset, std::vector<Fault>& faults) {
  const ordered_json& root = json.root();
  if (!root.contains("layers")) {
    faults.push_back(json.fault("", "the list of layers is missing.", "Add \"layers\": [ { } ] for one layer with all defaults."));
    return;
  }
  const ordered_json& layers = root["layers"];
  if (!layers.is_array()) {
    faults.push_back(json.fault("/layers", "layers is " + std::string(jsonTypeName(layers)) + ", but must be a list of objects.", ""));
    return;
  }
  if (layers.size() > kMaxLayers) {
    faults.push_back(json.fault("/layers", "there are " + std::to_string(layers.size()) + " layers, above the limit of " + std::to_string(kMaxLayers) + ".", ""));
    return;
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string pointer = "/layers/" + std::to_string(i);
    Layer layer;
    if (layers[i].is_object()) ObjectReader<Layer>(Scope::layer, json, pointer, layer, faults).read({});
    else faults.push_back(json.fault(pointer, "a layer is " + std::string(jsonTypeName(layers[i])) + ", but must be an object.", ""));
    preset.layers.push_back(std::move(layer));
  }
}

Expected<Preset> parse(std::string_view text, std::string_view name, const std::filesystem::path& folder) {
  auto json = JsonText::parse(text, name);
  if (!json) return tl::unexpected<Error>(json.error());
  if (!json->root().is_object())
    return fail(ErrorKind::input, json->fault("", "a preset is an object { ... }, but this is " + std::string(jsonTypeName(json->root())) + ".", ""));

  Preset preset;
  preset.folder.path = folder;
  std::vector<Fault> faults;
  checkVersion(*json, faults);
  // A newer file may mean anything by its keys; listing them as unknown would only mislead.
  if (faults.empty()) {
    ObjectReader<Preset>(Scope::burst, *json, "", preset, faults).read({"npsee", "layers"});
    readLayers(*json, preset, faults);
    // Rules between values say something only where each value could be read.
    if (faults.empty())
      for (const PresetFault& fault : relationFaults(preset)) faults.push_back(json->fault(json->line(fault.pointer) > 0 ? fault.pointer : fault.fallback, fault.what, fault.remedy));
  }
  if (!faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  return preset;
}

}  // namespace

Expected<Preset> parsePreset(std::string_view text, std::string_view name, const std::filesystem::path& folder) {
  return readAs(FileKind::preset, text, name, parse(text, name, folder));
}

Expected<Preset> loadPreset(const std::filesystem::path& path) {
  const auto text = readTextFile(path);
  if (!text) return tl::unexpected<Error>(text.error());
  return parsePreset(*text, path.string(), path.parent_path());
}

}  // namespace npsee
