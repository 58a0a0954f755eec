#include "sim/core/text.h"
#include "sim/world/scenario_table.h"
#include "sim/world/scenario_values.h"

#include <nlohmann/json.hpp>

namespace npsee::world {
namespace {

using nlohmann::ordered_json;

/// Fields of one structure that are to be shown.
struct Part {
  const Struct* table;
  std::vector<const Field*> fields;
};

std::string initialText(const Struct& table, const Field& field) {
  if (field.required) return "(required)";
  if (!field.scalar()) return field.type == FieldType::object ? "defaults" : "none";
  const std::string text = fieldText(field, defaultOf(table, field), true);
  return text.empty() ? "(empty)" : text;
}

std::string asText(const std::vector<Part>& parts) {
  std::string out;
  for (const Part& part : parts) {
    if (!out.empty()) out += '\n';
    out += std::string(part.table->name) + ": " + std::string(part.table->doc) + '\n';
    for (const Field* field : part.fields)
      out += "  " + std::string(field->key) + " = " + initialText(*part.table, *field) + "  [" + allowed(*field) + "]\n    " + std::string(field->doc) + '\n';
  }
  return out;
}

/// A bar would end the cell.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string asMarkdown(const std::vector<Part>& parts) {
  std::string out;
  for (const Part& part : parts) {
    if (!out.empty()) out += '\n';
    out += "### " + std::string(part.table->name) + "\n\n" + std::string(part.table->doc) + "\n\n| key | default | allowed | meaning |\n|---|---|---|---|\n";
    for (const Field* field : part.fields)
      out += "| `" + std::string(field->key) + "` | " + cell(initialText(*part.table, *field)) + " | " + cell(allowed(*field)) + " | " + cell(std::string(field->doc)) + " |\n";
  }
  return out;
}

std::string_view typeName(FieldType type) {
  switch (type) {
    case FieldType::boolean: return "boolean";
    case FieldType::integer: return "integer";
    case FieldType::number: return "number";
    case FieldType::choice: return "choice";
    case FieldType::text: return "text";
    case FieldType::id: return "id";
    case FieldType::file: return "file";
    case FieldType::place: return "place";
    case FieldType::vector: return "vector";
    case FieldType::texts: return "texts";
    case FieldType::places: return "places";
    case FieldType::parameters: return "parameters";
    case FieldType::object: return "object";
    case FieldType::list: return "list";
    case FieldType::expectations: return "clauses";
  }
  return "";
}

std::string asJson(const std::vector<Part>& parts) {
  ordered_json out = ordered_json::array();
  for (const Part& part : parts)
    for (const Field* field : part.fields) {
      ordered_json row = {{"object", part.table->name}, {"key", field->key}, {"type", typeName(field->type)}, {"doc", field->doc}, {"required", field->required}};
      if (!symbol(field->unit).empty()) row["unit"] = symbol(field->unit);
      if (field->hard.min != field->hard.max) row["range"] = {tidyNumber(field->hard.min), tidyNumber(field->hard.max)};
      for (const std::string_view choice : field->choices) row["choices"].push_back(choice);
      if (field->child != nullptr) row["of"] = field->child->name;
      if (field->scalar() && !field->required) row["default"] = fieldToJson(*field, defaultOf(*part.table, *field));
      out.push_back(std::move(row));
    }
  return out.dump(2) + '\n';
}

ordered_json numberSchema(const Field& field, const char* type = "number") {
  return {{"type", type}, {"minimum", tidyNumber(field.hard.min)}, {"maximum", tidyNumber(field.hard.max)}};
}

ordered_json tuple(const ordered_json& item, int count) { return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}}; }

/// Name among the definitions; a space would have to be escaped in references.
std::string definition(const Struct& table) {
  std::string out(table.name);
  for (char& c : out)
    if (c == ' ') c = '_';
  return out;
}

ordered_json reference(const Struct& table) { return {{"$ref", "#/$defs/" + definition(table)}}; }

ordered_json fieldSchema(const Field& field) {
  switch (field.type) {
    case FieldType::boolean: return {{"type", "boolean"}};
    case FieldType::integer: return numberSchema(field, "integer");
    case FieldType::number: return numberSchema(field);
    case FieldType::choice: return {{"enum", std::vector<std::string_view>(field.choices.begin(), field.choices.end())}};
    case FieldType::id: return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_-]+$"}, {"maxLength", tidyNumber(field.hard.max)}};
    case FieldType::text:
    case FieldType::file: return {{"type", "string"}, {"maxLength", tidyNumber(field.hard.max)}};
    case FieldType::place: return tuple(numberSchema(field), 2);
    case FieldType::vector: return tuple(numberSchema(field), 3);
    case FieldType::texts: return {{"type", "array"}, {"items", {{"type", "string"}}}, {"maxItems", tidyNumber(field.hard.max)}};
    case FieldType::places: return {{"type", "array"}, {"items", tuple({{"type", "number"}}, 2)}, {"maxItems", tidyNumber(field.hard.max)}};
    case FieldType::parameters: return {{"type", "object"}, {"additionalProperties", {{"type", {"number", "string"}}}}};
    case FieldType::object:
      if (field.word.empty()) return reference(*field.child);
      return {{"anyOf", {reference(*field.child), {{"const", field.word}}}}};
    case FieldType::list: return {{"type", "array"}, {"items", reference(*field.child)}, {"minItems", tidyNumber(field.hard.min)}, {"maxItems", tidyNumber(field.hard.max)}};
    case FieldType::expectations: return {{"type", "array"}, {"items", {{"type", "object"}}}, {"maxItems", tidyNumber(field.hard.max)}};
  }
  return {};
}

ordered_json structSchema(const Struct& table) {
  ordered_json properties = ordered_json::object(), required = ordered_json::array();
  for (const Field& field : table.fields) {
    ordered_json schema = fieldSchema(field);
    schema["description"] = std::string(field.doc) + (symbol(field.unit).empty() ? std::string() : " Unit: " + std::string(symbol(field.unit)) + ".");
    if (field.scalar() && !field.required) schema["default"] = fieldToJson(field, defaultOf(table, field));
    if (field.required) required.push_back(field.key);
    properties[std::string(field.key)] = std::move(schema);
  }
  ordered_json out = {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
  if (!required.empty()) out["required"] = std::move(required);
  return out;
}

std::string missionSchema() {
  ordered_json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "npsee mission"}};
  out.update(structSchema(missionTable()));
  out["properties"]["npsee_mission"] = {{"const", 1}};
  out["required"] = {"npsee_mission"};
  for (const Struct* table : missionTables())
    if (table != &missionTable()) out["$defs"][definition(*table)] = structSchema(*table);
  return out.dump(2) + '\n';
}

std::vector<Part> matching(std::string_view key) {
  std::vector<Part> out;
  for (const Struct* table : missionTables()) {
    Part part{table, {}};
    for (const Field& field : table->fields)
      if (key.empty() || field.key == key || table->name == key) part.fields.push_back(&field);
    if (!part.fields.empty()) out.push_back(std::move(part));
  }
  return out;
}

}  // namespace

Expected<std::string> missionReference(ReferenceFormat format, std::string_view key) {
  const std::vector<Part> parts = matching(key);
  if (parts.empty()) {
    std::vector<std::string_view> known;
    for (const Struct* table : missionTables()) {
      known.push_back(table->name);
      for (const Field& field : table->fields) known.push_back(field.key);
    }
    const auto near = nearest(key, known);
    return fail(ErrorKind::usage, "there is no key \"" + std::string(key) + "\" in mission files." + (near ? " Did you mean " + std::string(*near) + "?" : ""), "`npsee params --missions` lists all keys.");
  }
  switch (format) {
    case ReferenceFormat::text: return asText(parts);
    case ReferenceFormat::markdown: return asMarkdown(parts);
    case ReferenceFormat::json: return asJson(parts);
    case ReferenceFormat::json_schema: return missionSchema();
  }
  return std::string();
}

}  // namespace npsee::world
