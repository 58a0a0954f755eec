#include "sim/world/scenario_expect.h"

#include "sim/core/text.h"
#include "sim/world/scenario_values.h"

#include <npsee/recording.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace npsee::world {
namespace {

using nlohmann::ordered_json;

constexpr int kMostEvents = 1000000;

/// Reads the keys of one clause; collects faults at their pointers.
class ClauseReader {
 public:
  ClauseReader(const JsonText& json, std::vector<Fault>& faults) : json_(json), faults_(faults), before_(faults.size()) {}

  void read(const ordered_json& clause, const std::string& pointer, Expectation& out) {
    if (!clause.is_object()) return wrong(pointer, "a clause is " + shownJson(clause) + ", but must be an object such as {\"event\": \"destroyed\"}.");
    if (clause.contains("not") && !out.negated) return readNot(clause, pointer, out);
    if (!readEvent(clause, pointer)) return;
    for (const auto& [key, value] : clause.items()) readKey(key, value, pointer + '/' + pointerToken(key), out);
    // "at most five" is met by none at all, unless a lower bound is given too.
    if (out.at_most && !clause.contains("at_least")) out.at_least = 0;
    if (out.at_most && *out.at_most < out.at_least) wrong(pointer, "at_most is " + std::to_string(*out.at_most) + ", below at_least, " + std::to_string(out.at_least) + ".");
    if (out.before_s && out.after_s && !(*out.before_s > *out.after_s)) wrong(pointer, "before is " + shortest(*out.before_s) + " s, not later than after, " + shortest(*out.after_s) + " s.");
  }

  bool fine() const { return faults_.size() == before_; }

 private:
  /// The kind of event decides which other keys there are.
  bool readEvent(const ordered_json& clause, const std::string& pointer) {
    if (!clause.contains("event")) {
      wrong(pointer, "the clause names no event.", "Add \"event\": \"destroyed\", or another kind of the log.");
      return false;
    }
    const ordered_json& event = clause["event"];
    const std::vector<std::string_view> names(eventKindNames().begin(), eventKindNames().end());
    kind_ = event.is_string() ? event.get<std::string>() : std::string();
    if (std::ranges::find(names, kind_) != names.end()) return true;
    const auto near = nearest(kind_, names);
    wrong(pointer + "/event", "event is " + shownJson(event) + ", but must be the name of an event.", near ? "Did you mean " + std::string(*near) + "?" : "Events are " + listed(names) + ".");
    return false;
  }

  /// The log's key of this name; a fault where events of the kind have none.
  const EventKey* keyOf(const std::string& key, const std::string& pointer) {
    static constexpr EventKey kTime{"", "t", "number", "s", ""};
    if (key == "t") return &kTime;
    std::vector<std::string_view> known{"within", "before", "after", "at_least", "at_most", "t"};
    for (const EventKey& row : eventSchema()) {
      if (row.event != kind_) continue;
      if (row.key == key) return &row;
      known.push_back(row.key);
    }
    const auto near = nearest(key, known);
    wrong(pointer, "events of the kind " + kind_ + " have no such key.", near ? "Did you mean " + std::string(*near) + "?" : "A clause about them knows " + listed(known) + ".");
    return nullptr;
  }

  void wrong(const std::string& pointer, std::string what, std::string remedy = {}) { faults_.push_back(json_.fault(pointer, std::move(what), std::move(remedy))); }

  void readNot(const ordered_json& clause, const std::string& pointer, Expectation& out) {
    out.negated = true;
    if (clause.size() > 1) return wrong(pointer, "a clause with \"not\" has no other keys.", "Move them into the object after \"not\".");
    const ordered_json& inner = clause["not"];
    read(inner, pointer + "/not", out);
    if (inner.is_object() && (inner.contains("at_least") || inner.contains("at_most") || inner.contains("not")))
      wrong(pointer + "/not", "\"not\" means that there is no such event; it takes neither counts nor another \"not\".", "Leave \"not\" out and write at_most.");
  }

  void readKey(const std::string& key, const ordered_json& value, const std::string& pointer, Expectation& out) {
    if (key == "within") readWithin(value, pointer, out);
    else if (key == "before") out.before_s = time(key, value, pointer);
    else if (key == "after") out.after_s = time(key, value, pointer);
    else if (key == "at_least") out.at_least = count(key, value, pointer).value_or(1);
    else if (key == "at_most") out.at_most = count(key, value, pointer);
    else if (key != "not") readField(key, value, pointer, out);
  }

  void readWithin(const ordered_json& value, const std::string& pointer, Expectation& out) {
    const bool fits = value.is_object() && value.size() == 2 && value.contains("of") && value.contains("m") && value["of"].is_string() && value["m"].is_number();
    const bool placed = std::ranges::any_of(eventSchema(), [&](const EventKey& row) { return row.event == kind_ && row.key == "position"; });
    if (!placed) return wrong(pointer, "events of the kind " + kind_ + " have no position to be within of.", "Leave within out.");
    if (!fits) return wrong(pointer, "within is " + shownJson(value) + ", but must be {\"of\": \"t72-1\", \"m\": 60}.");
    out.within_of = value["of"].get<std::string>();
    out.within_m = value["m"].get<double>();
    if (!(out.within_m > 0.0)) wrong(pointer + "/m", "m is " + shortest(out.within_m) + ", but a distance must be above 0.");
  }

  std::optional<double> time(const std::string& key, const ordered_json& value, const std::string& pointer) {
    if (value.is_number() && value.get<double>() >= 0.0 && value.get<double>() <= kMaxMissionDuration_s) return value.get<double>();
    wrong(pointer, key + " is " + shownJson(value) + ", but must be a time of 0 to " + shortest(kMaxMissionDuration_s) + " s.");
    return std::nullopt;
  }

  std::optional<int> count(const std::string& key, const ordered_json& value, const std::string& pointer) {
    if (value.is_number_integer() && value.get<double>() >= 0.0 && value.get<double>() <= kMostEvents) return value.get<int>();
    wrong(pointer, key + " is " + shownJson(value) + ", but must be a whole number of 0 to " + std::to_string(kMostEvents) + ".");
    return std::nullopt;
  }

  void readField(const std::string& key, const ordered_json& value, const std::string& pointer, Expectation& out) {
    ExpectField field;
    field.key = key;
    if (key == "event") {
      field.value = kind_;
      out.fields.push_back(std::move(field));
      return;
    }
    const EventKey* row = keyOf(key, pointer);
    if (row == nullptr) return;
    const std::string_view type = row->type;
    const bool number = type == "number" || type == "whole";
    if (type == "place") return wrong(pointer, key + " is a place, which a clause cannot compare.", "Use \"within\": {\"of\": \"t72-1\", \"m\": 60}, which is about position.");
    if (number && value.is_number()) field.value = value.get<double>();
    else if (number && value.is_object() && readBounds(value, field)) field.value = 0.0;
    else if (type == "bool" && value.is_boolean()) field.value = value.get<bool>();
    else if (!number && type != "bool" && value.is_string()) field.value = value.get<std::string>();
    else return wrong(pointer, key + " is " + shownJson(value) + ", but must be " + (number ? "a number or {\"min\": A, \"max\": B}." : type == "bool" ? "true or false." : "a text."));
    out.fields.push_back(std::move(field));
  }

  static bool readBounds(const ordered_json& value, ExpectField& field) {
    for (const auto& [key, bound] : value.items()) {
      if (!bound.is_number() || (key != "min" && key != "max")) return false;
      (key == "min" ? field.min : field.max) = bound.get<double>();
    }
    return field.min || field.max;
  }

  const JsonText& json_;
  std::vector<Fault>& faults_;
  std::size_t before_;
  std::string kind_;
};

ordered_json fieldJson(const ExpectField& field) {
  if (field.min || field.max) {
    ordered_json out = ordered_json::object();
    if (field.min) out["min"] = tidyNumber(*field.min);
    if (field.max) out["max"] = tidyNumber(*field.max);
    return out;
  }
  if (const double* number = std::get_if<double>(&field.value)) return tidyNumber(*number);
  if (const bool* flag = std::get_if<bool>(&field.value)) return *flag;
  return std::get<std::string>(field.value);
}

}  // namespace

std::optional<Expectation> readExpectation(const JsonText& json, const ordered_json& clause, const std::string& pointer, std::vector<Fault>& faults) {
  Expectation out;
  ClauseReader reader(json, faults);
  reader.read(clause, pointer, out);
  if (!reader.fine()) return std::nullopt;
  out.text = clause.dump();
  out.file = json.file();
  out.line = json.line(pointer);
  return out;
}

ordered_json expectationJson(const Expectation& clause) {
  if (!clause.text.empty()) return ordered_json::parse(clause.text, nullptr, false);
  ordered_json inner = ordered_json::object();
  for (const ExpectField& field : clause.fields) inner[field.key] = fieldJson(field);
  if (!clause.within_of.empty()) inner["within"] = {{"of", clause.within_of}, {"m", tidyNumber(clause.within_m)}};
  if (clause.before_s) inner["before"] = tidyNumber(*clause.before_s);
  if (clause.after_s) inner["after"] = tidyNumber(*clause.after_s);
  if (clause.negated) return {{"not", inner}};
  if (clause.at_least != (clause.at_most ? 0 : 1)) inner["at_least"] = clause.at_least;
  if (clause.at_most) inner["at_most"] = *clause.at_most;
  return inner;
}

}  // namespace npsee::world
