#include <npsee/parameters.h>

#include "sim/core/text.h"
#include "sim/preset/json_values.h"

#include <nlohmann/json.hpp>

namespace npsee {
namespace {

using nlohmann::ordered_json;
using Rows = std::vector<const Parameter*>;

std::string_view scopeName(Scope scope) { return scope == Scope::burst ? "burst" : "layer"; }

std::string rangeText(const Range& range, Unit unit) {
  std::string out = shortest(range.min) + " to " + shortest(range.max);
  if (!symbol(unit).empty()) out += ' ' + std::string(symbol(unit));
  return out;
}

/// What values are allowed, in words.
std::string allowed(const Parameter& row) {
  switch (row.type) {
    case ParameterType::boolean: return "true or false";
    case ParameterType::choice: {
      const std::vector<std::string_view> keys(row.choices.begin(), row.choices.end());
      return "one of " + listed(keys);
    }
    case ParameterType::text: return shortest(row.hard.min) + " to " + shortest(row.hard.max) + " characters";
    case ParameterType::vector: return "[x, y, z], each " + rangeText(row.hard, row.unit);
    case ParameterType::colour: return "\"#rrggbb\", or [r, g, b] with each " + rangeText(row.hard, row.unit);
    case ParameterType::curve: return "up to " + std::to_string(kMaxCurvePoints) + " points [0 to 1, factor " + rangeText(row.hard, row.unit) + "]";
    case ParameterType::gradient: return "up to " + std::to_string(kMaxCurvePoints) + " stops [0 to 1, colour]";
    case ParameterType::integer:
    case ParameterType::number: return rangeText(row.hard, row.unit);
  }
  return {};
}

std::string initialText(const Parameter& row) {
  std::string text = valueText(row, row.initial, true);
  return text.empty() ? "(empty)" : text;
}

std::string asText(const Rows& rows) {
  std::string out;
  const Parameter* last = nullptr;
  for (const Parameter* row : rows) {
    if (last == nullptr || last->scope != row->scope) {
      if (last != nullptr) out += '\n';
      out += row->scope == Scope::burst ? "BURST (--set KEY=VALUE)\n" : "LAYER (--set LAYER.KEY=VALUE)\n";
    }
    if (last == nullptr || last->scope != row->scope || last->section != row->section) out += "\n  " + std::string(title(row->section)) + '\n';
    out += "    " + std::string(row->key) + " (" + std::string(typeName(row->type)) + "): " + std::string(row->label) + ". " + std::string(row->doc) + '\n';
    out += "        " + allowed(*row) + "; default " + initialText(*row) + '\n';
    if (!row->thesis.empty()) out += "        in the thesis: " + std::string(row->thesis) + '\n';
    last = row;
  }
  return out;
}

std::string asMarkdown(const Rows& rows) {
  std::string out = "# Preset parameters\n\nMade by `npsee params --format markdown`.\n";
  const Parameter* last = nullptr;
  for (const Parameter* row : rows) {
    if (last == nullptr || last->scope != row->scope || last->section != row->section) {
      out += "\n## " + std::string(row->scope == Scope::burst ? "Burst: " : "Layer: ") + std::string(title(row->section)) + "\n\n";
      out += "| key | name | type | allowed | default | meaning | thesis |\n|---|---|---|---|---|---|---|\n";
    }
    out += "| `" + std::string(row->key) + "` | " + std::string(row->label) + " | " + std::string(typeName(row->type)) + " | " + allowed(*row) + " | " + initialText(*row) + " | " + std::string(row->doc) + " | " + std::string(row->thesis) + " |\n";
    last = row;
  }
  return out;
}

ordered_json rowJson(const Parameter& row) {
  ordered_json out;
  out["key"] = row.key;
  out["scope"] = scopeName(row.scope);
  out["section"] = title(row.section);
  out["label"] = row.label;
  out["type"] = typeName(row.type);
  out["unit"] = symbol(row.unit);
  const bool ranged = row.type != ParameterType::boolean && row.type != ParameterType::choice;
  if (ranged) {
    out["min"] = row.hard.min;
    out["max"] = row.hard.max;
    if (row.type != ParameterType::text) out["slider"] = {row.slider.min, row.slider.max};
    out["scale"] = row.scale == Scale::linear ? "linear" : "logarithmic";
  }
  if (row.type == ParameterType::choice) out["choices"] = row.choices;
  out["default"] = valueToJson(row, row.initial);
  out["thesis"] = row.thesis;
  out["doc"] = row.doc;
  return out;
}

ordered_json numberSchema(const Range& range) { return {{"type", "number"}, {"minimum", range.min}, {"maximum", range.max}}; }

ordered_json colourSchema(const Range& range) {
  return {{"oneOf", {{{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}},
                     {{"type", "array"}, {"items", numberSchema(range)}, {"minItems", 3}, {"maxItems", 3}}}}};
}

ordered_json pointsSchema(ordered_json value) {
  const ordered_json pair = {{"type", "array"}, {"prefixItems", {numberSchema({0, 1}), std::move(value)}}, {"minItems", 2}, {"maxItems", 2}};
  return {{"type", "array"}, {"items", pair}, {"maxItems", kMaxCurvePoints}};
}

ordered_json rowSchema(const Parameter& row) {
  ordered_json out;
  switch (row.type) {
    case ParameterType::boolean: out["type"] = "boolean"; break;
    case ParameterType::integer: out = numberSchema(row.hard); out["type"] = "integer"; break;
    case ParameterType::number: out = numberSchema(row.hard); break;
    case ParameterType::choice: out["enum"] = row.choices; break;
    case ParameterType::text: out = {{"type", "string"}, {"minLength", row.hard.min}, {"maxLength", row.hard.max}}; break;
    case ParameterType::vector: out = {{"type", "array"}, {"items", numberSchema(row.hard)}, {"minItems", 3}, {"maxItems", 3}}; break;
    case ParameterType::colour: out = colourSchema(row.hard); break;
    case ParameterType::curve: out = pointsSchema(numberSchema(row.hard)); break;
    case ParameterType::gradient: out = pointsSchema(colourSchema(row.hard)); break;
  }
  out["title"] = row.label;
  out["description"] = std::string(row.doc) + (symbol(row.unit).empty() ? "" : " Unit: " + std::string(symbol(row.unit)) + ".");
  out["default"] = valueToJson(row, row.initial);
  return out;
}

ordered_json objectSchema(const Rows& rows, Scope scope) {
  ordered_json out = {{"type", "object"}, {"additionalProperties", false}, {"properties", ordered_json::object()}};
  for (const Parameter* row : rows) {
    if (row->scope != scope) continue;
    ordered_json* object = &out;
    const auto parts = splitAt(row->key, '.');
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      ordered_json& group = (*object)["properties"][std::string(parts[i])];
      if (group.is_null()) group = {{"type", "object"}, {"additionalProperties", false}, {"properties", ordered_json::object()}};
      object = &group;
    }
    (*object)["properties"][std::string(parts.back())] = rowSchema(*row);
  }
  return out;
}

std::string asSchema(const Rows& rows) {
  ordered_json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "npsee preset"}};
  out.update(objectSchema(rows, Scope::burst));
  out["properties"]["npsee"] = {{"const", kPresetVersion}};
  out["properties"]["layers"] = {{"type", "array"}, {"maxItems", kMaxLayers}, {"items", objectSchema(rows, Scope::layer)}};
  out["required"] = {"npsee", "layers"};
  return out.dump(2) + '\n';
}

/// Rows meant by a key of the command line: "speed_mean", "region.radius", "LAYER.speed_mean", or a section's or group's name.
Rows matching(std::string_view key) {
  Rows out;
  for (const Parameter& row : parameters())
    if (key.empty() || row.key == key || key.ends_with('.' + std::string(row.key))) out.push_back(&row);
  if (!out.empty()) return out;
  for (const Parameter& row : parameters())
    if (row.key.starts_with(std::string(key) + '.') || title(row.section) == key) out.push_back(&row);
  return out;
}

}  // namespace

Expected<std::string> parameterReference(ReferenceFormat format, std::string_view key) {
  const Rows rows = matching(key);
  if (rows.empty()) {
    std::vector<std::string_view> keys;
    for (const Parameter& row : parameters()) keys.push_back(row.key);
    const auto near = nearest(key, keys);
    return fail(ErrorKind::usage, "there is no parameter \"" + std::string(key) + "\"." + (near ? " Did you mean " + std::string(*near) + "?" : ""),
                "`npsee params` lists all parameters.");
  }
  switch (format) {
    case ReferenceFormat::text: return asText(rows);
    case ReferenceFormat::markdown: return asMarkdown(rows);
    case ReferenceFormat::json_schema: return asSchema(rows);
    case ReferenceFormat::json: {
      ordered_json out = ordered_json::array();
      for (const Parameter* row : rows) out.push_back(rowJson(*row));
      return out.dump(2) + '\n';
    }
  }
  return std::string();
}

}  // namespace npsee
