#include "sim/world/event_reference.h"

#include <npsee/recording.h>

#include <nlohmann/json.hpp>

namespace npsee::world {
namespace {

using nlohmann::ordered_json;

/// What every line has.
constexpr EventKey kCommon[] = {{"", "t", "number", "s", "time in the mission"}, {"", "ev", "text", "", "kind of the event"}};

template <class Line, class Head>
std::string byEvent(const Head& head, const Line& line) {
  std::string out;
  for (const std::string_view kind : eventKindNames()) {
    out += head(kind);
    for (const EventKey& key : eventSchema())
      if (key.event == kind) out += line(key);
  }
  return out;
}

std::string asText() {
  const auto line = [](const EventKey& key) {
    return "  " + std::string(key.key) + " (" + std::string(key.type) + (key.unit.empty() ? "" : ", " + std::string(key.unit)) + "): " + std::string(key.doc) + '\n';
  };
  std::string out = "every line\n";
  for (const EventKey& key : kCommon) out += line(key);
  return out + byEvent([](std::string_view kind) { return std::string(kind) + '\n'; }, line);
}

std::string asMarkdown() {
  const auto line = [](std::string_view event, const EventKey& key) {
    return "| " + (event.empty() ? std::string() : '`' + std::string(event) + '`') + " | `" + std::string(key.key) + "` | " + std::string(key.type) + " | " + std::string(key.unit) + " | " + std::string(key.doc) + " |\n";
  };
  std::string out = "| `ev` | key | type | unit | meaning |\n|---|---|---|---|---|\n";
  for (const EventKey& key : kCommon) out += "| every | `" + std::string(key.key) + "` | " + std::string(key.type) + " | " + std::string(key.unit) + " | " + std::string(key.doc) + " |\n";
  // The name of the event stands in its first row only.
  std::string_view last;
  for (const EventKey& key : eventSchema()) {
    out += line(key.event == last ? std::string_view() : key.event, key);
    last = key.event;
  }
  return out;
}

ordered_json typeSchema(std::string_view type) {
  if (type == "number") return {{"type", "number"}};
  if (type == "whole") return {{"type", "integer"}};
  if (type == "bool") return {{"type", "boolean"}};
  if (type == "place") return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
  if (type == "texts") return {{"type", "array"}, {"items", {{"type", "string"}}}};
  return {{"type", "string"}};
}

std::string lineSchema() {
  ordered_json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "one line of the event log of npsee mission"}, {"oneOf", ordered_json::array()}};
  for (const std::string_view kind : eventKindNames()) {
    ordered_json properties = {{"t", {{"type", "number"}, {"minimum", 0}}}, {"ev", {{"const", kind}}}}, required = {"t", "ev"};
    for (const EventKey& key : eventSchema()) {
      if (key.event != kind) continue;
      ordered_json schema = typeSchema(key.type);
      schema["description"] = std::string(key.doc) + (key.unit.empty() ? "" : " [" + std::string(key.unit) + "]");
      properties[std::string(key.key)] = std::move(schema);
      if (!key.optional()) required.push_back(key.key);
    }
    out["oneOf"].push_back({{"type", "object"}, {"properties", std::move(properties)}, {"required", std::move(required)}});
  }
  return out.dump(2) + '\n';
}

std::string asJson() {
  ordered_json out = ordered_json::array();
  for (const EventKey& key : eventSchema()) out.push_back({{"event", key.event}, {"key", key.key}, {"type", key.type}, {"unit", key.unit}, {"doc", key.doc}, {"optional", key.optional()}});
  return out.dump(2) + '\n';
}

}  // namespace

std::string eventReference(ReferenceFormat format) {
  switch (format) {
    case ReferenceFormat::text: return asText();
    case ReferenceFormat::markdown: return asMarkdown();
    case ReferenceFormat::json: return asJson();
    case ReferenceFormat::json_schema: return lineSchema();
  }
  return {};
}

}  // namespace npsee::world
