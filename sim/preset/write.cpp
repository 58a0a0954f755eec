#include "sim/core/files.h"
#include "sim/preset/json_values.h"

#include "sim/core/text.h"

#include <nlohmann/json.hpp>

namespace npsee {
namespace {

using nlohmann::ordered_json;

template <class Object>
void writeRows(Scope scope, const Object& object, ordered_json& out) {
  for (const Parameter& row : parameters(scope)) {
    const Value value = row.get(object);
    // A layer is known by its name even where that is the default one.
    if (value == row.initial && row.key != "name") continue;
    ordered_json* place = &out;
    for (const std::string_view part : splitAt(row.key, '.')) place = &(*place)[std::string(part)];
    *place = valueToJson(row, value);
  }
}

/// Short lists (points, vectors) stay on one line, so that a curve reads as a table and diffs by point.
void print(const ordered_json& json, int indent, std::string& out) {
  const auto line = [&](int depth) {
    out += '\n';
    out.append(static_cast<std::size_t>(2 * depth), ' ');
  };
  const bool nested = json.is_object() || (json.is_array() && !json.empty() && json[0].is_structured());
  if (!nested || json.empty()) {
    if (!json.is_array() || json.empty()) {
      out += json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
      return;
    }
    out += '[';
    for (std::size_t i = 0; i < json.size(); ++i) {
      if (i > 0) out += ", ";
      out += json[i].dump();
    }
    out += ']';
    return;
  }
  out += json.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    if (!first) out += ',';
    first = false;
    line(indent + 1);
    if (json.is_object()) out += ordered_json(key).dump() + ": ";
    print(value, indent + 1, out);
  }
  line(indent);
  out += json.is_object() ? '}' : ']';
}

}  // namespace

std::string presetText(const Preset& preset) {
  ordered_json root;
  root["npsee"] = kPresetVersion;
  writeRows(Scope::burst, preset, root);
  root["layers"] = ordered_json::array();
  for (const Layer& layer : preset.layers) {
    ordered_json object = ordered_json::object();
    writeRows(Scope::layer, layer, object);
    root["layers"].push_back(std::move(object));
  }
  std::string out;
  print(root, 0, out);
  out += '\n';
  return out;
}

Expected<void> savePreset(const Preset& preset, const std::filesystem::path& path) {
  if (std::vector<Fault> faults = validate(preset); !faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  return writeFileAtomically(path, presetText(preset));
}

}  // namespace npsee
