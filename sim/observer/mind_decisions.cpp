#include "sim/observer/mind_data.h"

#include <cmath>
#include <stdexcept>

namespace npsee::observer {
namespace {

using Arguments = std::vector<RuleValue>;
constexpr std::size_t kMaxDecisions = 1000;
constexpr double kMaxShift_m = 10000.0;
constexpr std::size_t kMaxReason = 400;

[[noreturn]] void refuse(std::size_t index, const std::string& what) { throw std::invalid_argument("argument " + std::to_string(index + 1) + " " + what); }

int wholeNumber(const Arguments& arguments, std::size_t index, const char* what) {
  double value = 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(&arguments[index]))
    value = static_cast<double>(*whole);
  else if (const auto* number = std::get_if<double>(&arguments[index]))
    value = *number;
  else
    refuse(index, std::string("is not ") + what);
  if (!(value >= -1e9 && value <= 1e9) || value != std::nearbyint(value)) refuse(index, std::string("is not ") + what);
  return static_cast<int>(value);
}

double metres(const Arguments& arguments, std::size_t index) {
  if (index >= arguments.size()) return 0.0;
  double value = 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(&arguments[index]))
    value = static_cast<double>(*whole);
  else if (const auto* number = std::get_if<double>(&arguments[index]))
    value = *number;
  else
    refuse(index, "is not a number of metres");
  if (!(std::abs(value) <= kMaxShift_m)) refuse(index, "is " + plainText(arguments[index]) + " m, beyond 10000 m");
  return value + 0.0;  // no negative zero
}

std::string sentence(const Arguments& arguments, std::size_t from) {
  std::string out;
  for (std::size_t i = from; i < arguments.size(); ++i) out += plainText(arguments[i]);
  if (out.size() > kMaxReason) out.resize(kMaxReason);
  return printable(out);
}

}  // namespace

void Mind::Data::decide(Decision decision) {
  if (decisions.size() >= kMaxDecisions) throw std::length_error("more than " + std::to_string(kMaxDecisions) + " decisions in one run");
  decision.rule = host.firingRule();
  decision.facts = host.firingFacts();
  decisions.push_back(std::move(decision));
}

void Mind::Data::defineDecisions() {
  const auto missionOf = [this](const Arguments& arguments) {
    const int number = wholeNumber(arguments, 0, "the number of a mission");
    if (!missions.contains(number)) refuse(0, "is " + std::to_string(number) + ", which is no mission of his");
    return number;
  };
  host.define("call-for-fire", 2, 2, [this](const Arguments& arguments) {
    Decision out;
    out.kind = Decision::Kind::call;
    out.contact = wholeNumber(arguments, 0, "the id of a contact");
    if (!contacts.contains(out.contact)) refuse(0, "is " + std::to_string(out.contact) + ", which is no contact of his");
    const std::string word = plainText(arguments[1]);
    const auto method = methodOf(word);
    if (!method || *method == FireMethod::automatic) refuse(1, "is " + word + ", not adjust_fire, fire_for_effect, suppress, immediate_suppression, smoke or illuminate");
    out.method = *method;
    decide(std::move(out));
  });
  host.define("correct", 3, 3, [this, missionOf](const Arguments& arguments) {
    Decision out;
    out.kind = Decision::Kind::correct;
    out.mission = missionOf(arguments);
    out.contact = missions.at(out.mission).value.contact;
    out.right_m = metres(arguments, 1);
    out.add_m = metres(arguments, 2);
    decide(std::move(out));
  });
  host.define("fire-for-effect", 1, 3, [this, missionOf](const Arguments& arguments) {
    Decision out;
    out.kind = Decision::Kind::fire_for_effect;
    out.mission = missionOf(arguments);
    out.contact = missions.at(out.mission).value.contact;
    out.method = FireMethod::fire_for_effect;
    out.right_m = metres(arguments, 1);
    out.add_m = metres(arguments, 2);
    decide(std::move(out));
  });
  host.define("end-of-mission", 2, -1, [this, missionOf](const Arguments& arguments) {
    Decision out;
    out.kind = Decision::Kind::end;
    out.mission = missionOf(arguments);
    out.contact = missions.at(out.mission).value.contact;
    out.reason = sentence(arguments, 1);
    decide(std::move(out));
  });
  for (const auto kind : {Decision::Kind::withdraw, Decision::Kind::warn})
    host.define(kind == Decision::Kind::withdraw ? "withdraw" : "warn", 1, -1, [this, kind](const Arguments& arguments) {
      Decision out;
      out.kind = kind;
      out.reason = sentence(arguments, 0);
      decide(std::move(out));
    });
}

}  // namespace npsee::observer
