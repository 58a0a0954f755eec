// The event log as text.

#include <npsee/recording.h>

#include "sim/core/text.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

/// Decimals of numbers in the log: a tenth of a millimetre, of a millisecond, of a thousandth of a mil. More would be digits of
/// rounding, and the file would be twice as long.
constexpr double kPlaces = 1e4;

std::string numberText(double value) {
  if (!std::isfinite(value)) return "null";
  if (std::fabs(value) < 1e11) value = std::floor(value * kPlaces + 0.5) / kPlaces;
  // No "-0".
  return shortest(value == 0.0 ? 0.0 : value);
}

void appendText(std::string& out, std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  out += '"';
  const bool valid = validUtf8(text);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') (out += '\\') += c;
    else if (c == '\n') out += "\\n";
    else if (c == '\t') out += "\\t";
    else if (byte < 0x20 || byte == 0x7f) out.append("\\u00").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
    // Names come from files; what is not text must not make the log unreadable.
    else if (byte >= 0x80 && !valid) out += "\\ufffd";
    else out += c;
  }
  out += '"';
}

struct Append {
  std::string& out;
  void operator()(bool value) const { out += value ? "true" : "false"; }
  void operator()(std::int64_t value) const { out += std::to_string(value); }
  void operator()(double value) const { out += numberText(value); }
  void operator()(const std::string& value) const { appendText(out, value); }
  void operator()(const Vec3& value) const { out += '[' + numberText(value.x) + ',' + numberText(value.y) + ',' + numberText(value.z) + ']'; }
  void operator()(const std::vector<std::string>& value) const {
    out += '[';
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) out += ',';
      appendText(out, value[i]);
    }
    out += ']';
  }
};

/// The schema's rows of one kind of event; they stand together.
std::span<const EventKey> rowsOf(std::string_view kind) {
  const auto rows = eventSchema();
  const auto first = std::ranges::find(rows, kind, &EventKey::event);
  const auto last = std::find_if(first, rows.end(), [&](const EventKey& row) { return row.event != kind; });
  return {first, last};
}

bool saysNothing(const MissionEvent::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return text->empty();
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) return texts->empty();
  return false;
}

}  // namespace

const MissionEvent::Value* MissionEvent::find(std::string_view key) const {
  for (const auto& [name, value] : fields)
    if (name == key) return &value;
  return nullptr;
}

std::string MissionEvent::text(std::string_view key) const {
  const Value* value = find(key);
  const auto* text = value ? std::get_if<std::string>(value) : nullptr;
  return text ? *text : std::string();
}

double MissionEvent::number(std::string_view key, double otherwise) const {
  const Value* value = find(key);
  if (!value) return otherwise;
  if (const auto* real = std::get_if<double>(value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(value)) return static_cast<double>(*whole);
  return otherwise;
}

const Vec3* MissionEvent::place(std::string_view key) const {
  const Value* value = find(key);
  return value ? std::get_if<Vec3>(value) : nullptr;
}

std::string eventJson(const MissionEvent& event) {
  const auto names = eventKindNames();
  const std::string_view kind = static_cast<std::size_t>(event.kind) < names.size() ? names[static_cast<std::size_t>(event.kind)] : "error";
  std::string out = "{\"t\":" + numberText(event.t_s) + ",\"ev\":";
  appendText(out, kind);
  const auto write = [&](const auto& field) {
    out += ',';
    appendText(out, field.first);
    out += ':';
    std::visit(Append{out}, field.second);
  };
  std::size_t known = 0;
  for (const EventKey& row : rowsOf(kind)) {
    const auto field = std::ranges::find(event.fields, row.key, &std::pair<std::string, MissionEvent::Value>::first);
    if (field == event.fields.end()) continue;
    ++known;
    if (!row.optional() || !saysNothing(field->second)) write(*field);
  }
  // What the schema does not know comes last; a test sees to it that no mission gets here.
  if (known < event.fields.size())
    for (const auto& field : event.fields)
      if (std::ranges::find(rowsOf(kind), field.first, &EventKey::key) == rowsOf(kind).end()) write(field);
  return out += '}';
}

std::string eventLog(const Recording& recording) {
  std::string out;
  for (const MissionEvent& event : recording.events) (out += eventJson(event)) += '\n';
  return out;
}

}  // namespace npsee
