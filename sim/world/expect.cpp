// Holds the clauses of `expect` against the event log.

#include <npsee/mission.h>

#include "sim/core/text.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

/// Numbers of the log are rounded to this; equal within it is equal.
constexpr double kLogStep = 1e-4;

std::string rounded(double value) { return shortest(std::floor(value * 1000.0 + 0.5) / 1000.0); }

std::string valueText(const MissionEvent::Value& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const double* number = std::get_if<double>(&value)) return rounded(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return '"' + *text + '"';
  if (const auto* place = std::get_if<Vec3>(&value)) return "[" + rounded(place->x) + ", " + rounded(place->y) + ", " + rounded(place->z) + "]";
  const auto& texts = std::get<std::vector<std::string>>(value);
  return '[' + listed({texts.begin(), texts.end()}) + ']';
}

std::string_view kindName(const MissionEvent& event) { return eventKindNames()[static_cast<std::size_t>(event.kind)]; }

bool numberFits(const ExpectField& field, double number) {
  if (field.min || field.max) return (!field.min || number >= *field.min) && (!field.max || number <= *field.max);
  const double* wanted = std::get_if<double>(&field.value);
  return wanted != nullptr && std::fabs(number - *wanted) <= kLogStep;
}

bool valueFits(const ExpectField& field, const MissionEvent::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return numberFits(field, static_cast<double>(*whole));
  if (const double* number = std::get_if<double>(&value)) return numberFits(field, *number);
  if (field.min || field.max) return false;
  if (const bool* flag = std::get_if<bool>(&value)) return std::holds_alternative<bool>(field.value) && std::get<bool>(field.value) == *flag;
  const auto* wanted = std::get_if<std::string>(&field.value);
  if (wanted == nullptr) return false;
  if (const auto* text = std::get_if<std::string>(&value)) return *text == *wanted;
  const auto* texts = std::get_if<std::vector<std::string>>(&value);
  return texts != nullptr && std::ranges::find(*texts, *wanted) != texts->end();
}

/// Where something that has an id is at a time; nothing if there is no such thing.
std::optional<Vec3> placeOf(const Recording& recording, const std::string& id, double time_s) {
  if (const int vehicle = recording.findVehicle(id); vehicle >= 0) return recording.vehiclePlace(static_cast<std::size_t>(vehicle), time_s);
  if (const int gun = recording.findGun(id); gun >= 0) return recording.guns[static_cast<std::size_t>(gun)].muzzle_m;
  if (const int observer = recording.findObserver(id); observer >= 0) return recording.observerEye(static_cast<std::size_t>(observer), time_s);
  return std::nullopt;
}

class Clause {
 public:
  Clause(const Recording& recording, const Expectation& clause) : recording_(recording), clause_(clause) {
    for (const ExpectField& field : clause.fields)
      if (field.key == "event" && std::holds_alternative<std::string>(field.value)) kind_ = std::get<std::string>(field.value);
  }

  /// Why the log does not meet the clause; empty if it does.
  std::string unmet() const {
    std::vector<const MissionEvent*> found;
    const MissionEvent* nearest = nullptr;
    std::vector<std::string> lacking;
    for (const MissionEvent& event : recording_.events) {
      if (kindName(event) != kind_) continue;
      std::vector<std::string> against = conditionsAgainst(event);
      if (against.empty()) {
        found.push_back(&event);
      } else if (nearest == nullptr || against.size() < lacking.size()) {
        nearest = &event;
        lacking = std::move(against);
      }
    }
    const int count = static_cast<int>(found.size());
    if (clause_.negated) return count == 0 ? std::string() : "There must be none, but there " + counted(found) + ".";
    if (clause_.at_most && count > *clause_.at_most) return "At most " + std::to_string(*clause_.at_most) + " may be found, but there " + counted(found) + ".";
    if (count >= clause_.at_least) return {};
    return tooFew(count, nearest, lacking);
  }

 private:
  /// Conditions that the event does not fulfil, in words.
  std::vector<std::string> conditionsAgainst(const MissionEvent& event) const {
    std::vector<std::string> out;
    for (const ExpectField& field : clause_.fields) {
      if (field.key == "event") continue;
      if (field.key == "t") {
        if (!numberFits(field, event.t_s)) out.push_back("t is " + rounded(event.t_s));
        continue;
      }
      const MissionEvent::Value* value = event.find(field.key);
      if (value == nullptr) out.push_back("it has no " + field.key);
      else if (!valueFits(field, *value)) out.push_back(field.key + " is " + valueText(*value));
    }
    if (clause_.before_s && !(event.t_s < *clause_.before_s)) out.push_back("it is not before " + shortest(*clause_.before_s) + " s");
    if (clause_.after_s && !(event.t_s > *clause_.after_s)) out.push_back("it is not after " + shortest(*clause_.after_s) + " s");
    if (!clause_.within_of.empty())
      if (std::string far = tooFar(event); !far.empty()) out.push_back(std::move(far));
    return out;
  }

  std::string tooFar(const MissionEvent& event) const {
    const Vec3* at = event.place();
    if (at == nullptr) return "it has no position";
    const auto place = placeOf(recording_, clause_.within_of, event.t_s);
    if (!place) return "there is no " + clause_.within_of;
    const double distance = std::sqrt((at->x - place->x) * (at->x - place->x) + (at->z - place->z) * (at->z - place->z));
    return distance <= clause_.within_m ? std::string() : "it is " + rounded(distance) + " m from " + clause_.within_of;
  }

  static std::string counted(const std::vector<const MissionEvent*>& found) {
    const std::string first = eventJson(*found.front());
    return (found.size() == 1 ? "is one: " : "are " + std::to_string(found.size()) + ", the first: ") + first;
  }

  std::string tooFew(int count, const MissionEvent* nearest, const std::vector<std::string>& lacking) const {
    std::string out = count == 0 ? "No " + kind_ + " event is like that" : "Only " + std::to_string(count) + " of at least " + std::to_string(clause_.at_least) + " " + kind_ + " events are like that";
    if (nearest == nullptr) return out + (count == 0 ? "; the log has none at all." : ".");
    return out + "; nearest is the one at t = " + rounded(nearest->t_s) + " s, but " + listed({lacking.begin(), lacking.end()}) + ".";
  }

  const Recording& recording_;
  const Expectation& clause_;
  std::string kind_;
};

}  // namespace

std::vector<std::string> unmetExpectations(const Recording& recording) {
  std::vector<std::string> out;
  const std::vector<Expectation>& clauses = recording.scenario.expect;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    const std::string why = Clause(recording, clauses[i]).unmet();
    if (why.empty()) continue;
    std::string where = clauses[i].file;
    if (clauses[i].line > 0) where += (where.empty() ? "line " : ":") + std::to_string(clauses[i].line);
    out.push_back(printable((where.empty() ? "" : where + ": ") + "/expect/" + std::to_string(i) + ": " + clauses[i].text + " is not met. " + why));
  }
  return out;
}

}  // namespace npsee
