#include "sim/observer/mind_data.h"

#include <array>
#include <cmath>

namespace npsee::observer {
namespace {

constexpr std::array<std::string_view, 4> kConditions{"whole", "damaged", "suppressed", "destroyed"};
constexpr std::array<std::string_view, 6> kStates{"refused", "accepted", "splash", "effect", "effect_over", "ended"};
constexpr std::array<std::string_view, 7> kMethods{"automatic", "adjust_fire", "fire_for_effect", "suppress", "immediate_suppression", "smoke", "illuminate"};
constexpr std::array<std::string_view, 3> kActions{"destroy", "neutralize", "special"};

// Rules are told of a change when it is worth their while: every changed fact costs about ten microseconds, and none of their
// decisions depends on less. What is told is then exact (rounded), not the step.
constexpr double kPlaceStep_m = 20.0, kAzimuthStep_mil = 20.0, kSpeedStep_mps = 1.0, kErrorStep_m = 10.0, kBeliefStep = 0.02, kFriendlyStep_m = 50.0;
// Beyond every danger-close distance the exact figure is of no interest.
constexpr double kFarFriendly_m = 5000.0;

double roundedTo(double value, double step) { return std::isfinite(value) ? std::nearbyint(value / step) * step : 0.0; }

RuleValue whole(int value) { return static_cast<std::int64_t>(value); }
RuleValue word(std::string_view text) { return Symbol{std::string(text)}; }
RuleValue truth(bool value) { return Symbol{value ? "TRUE" : "FALSE"}; }

bool near(double a, double b, double step) { return std::abs(a - b) < step; }
/// Two values that lie close together and on the same side of what rules compare them with.
bool alike(double a, double b, double step, double edge) { return near(a, b, step) && (a < edge) == (b < edge); }

bool alikeInKind(const Contact& a, const Contact& b, const MindSetup& setup) {
  return a.type == b.type && a.condition == b.condition && alike(a.hostile, b.hostile, kBeliefStep, setup.hostile_belief) &&
         alike(a.friendly, b.friendly, kBeliefStep, setup.hostile_belief) && a.type_name == b.type_name;
}
bool alikeInPlace(const Contact& a, const Contact& b, const MindSetup& setup) {
  return a.seen == b.seen && near(a.x_m, b.x_m, kPlaceStep_m) && near(a.z_m, b.z_m, kPlaceStep_m) && near(a.range_m, b.range_m, kPlaceStep_m) &&
         near(a.azimuth_mil, b.azimuth_mil, kAzimuthStep_mil) && near(a.speed_mps, b.speed_mps, kSpeedStep_mps) &&
         near(a.location_error_m, b.location_error_m, kErrorStep_m) && alike(std::min(a.friendly_distance_m, kFarFriendly_m), std::min(b.friendly_distance_m, kFarFriendly_m), kFriendlyStep_m, setup.danger_close_m);
}
bool same(const MissionFact& a, const MissionFact& b) {
  return a.mission == b.mission && a.contact == b.contact && a.state == b.state && a.method == b.method && a.rounds == b.rounds && a.danger_close == b.danger_close &&
         a.ot_distance_m == b.ot_distance_m && a.reason == b.reason;
}
bool alike(const SelfFacts& a, const SelfFacts& b) {
  return near(a.x_m, b.x_m, kPlaceStep_m) && near(a.z_m, b.z_m, kPlaceStep_m) && a.type == b.type && a.max_range_m == b.max_range_m && a.moving == b.moving && a.night == b.night && a.method == b.method &&
         a.self_preservation == b.self_preservation;
}

FactHandle tell(ClipsHost& host, const SelfFacts& self) {
  return host.assertFact("self", {{"x", self.x_m},
                                  {"z", self.z_m},
                                  {"type", whole(self.type)},
                                  {"max-range", self.max_range_m},
                                  {"moving", truth(self.moving)},
                                  {"night", truth(self.night)},
                                  {"method", word(methodWord(self.method))},
                                  {"self-preservation", truth(self.self_preservation)}});
}

FactHandle tell(ClipsHost& host, const Contact& contact) {
  return host.assertFact("contact", {{"id", whole(contact.id)},
                                     {"type", whole(contact.type)},
                                     {"name", word(contact.type_name.empty() ? "unknown" : contact.type_name)},
                                     {"x", contact.x_m},
                                     {"z", contact.z_m},
                                     {"range", contact.range_m},
                                     {"azimuth", contact.azimuth_mil},
                                     {"speed", contact.speed_mps},
                                     {"location-error", contact.location_error_m},
                                     {"hostile", contact.hostile},
                                     {"friendly", contact.friendly},
                                     {"condition", word(conditionWord(contact.condition))},
                                     {"seen", truth(contact.seen)},
                                     {"friendly-distance", contact.friendly_distance_m}});
}

FactHandle tell(ClipsHost& host, const MissionFact& mission) {
  return host.assertFact("fire-mission", {{"mission", whole(mission.mission)},
                                          {"contact", whole(mission.contact)},
                                          {"state", word(stateWord(mission.state))},
                                          {"method", word(methodWord(mission.method))},
                                          {"rounds", whole(mission.rounds)},
                                          {"danger-close", truth(mission.danger_close)},
                                          {"ot-distance", mission.ot_distance_m},
                                          {"reason", mission.reason}});
}

}  // namespace

std::string_view conditionWord(Contact::Condition condition) { return kConditions[static_cast<std::size_t>(condition)]; }
std::string_view stateWord(MissionFact::State state) { return kStates[static_cast<std::size_t>(state)]; }
std::string_view methodWord(FireMethod method) { return kMethods[static_cast<std::size_t>(method)]; }
std::string_view actionWord(MissionAction action) { return kActions[static_cast<std::size_t>(action)]; }

std::optional<FireMethod> methodOf(std::string_view word) {
  for (std::size_t i = 0; i < kMethods.size(); ++i)
    if (kMethods[i] == word) return static_cast<FireMethod>(i);
  return {};
}

Contact rounded(const Contact& contact) {
  Contact out = contact;
  out.x_m = roundedTo(contact.x_m, 1.0);
  out.z_m = roundedTo(contact.z_m, 1.0);
  out.range_m = roundedTo(contact.range_m, 1.0);
  out.azimuth_mil = roundedTo(contact.azimuth_mil, 1.0);
  out.speed_mps = roundedTo(contact.speed_mps, 0.1);
  out.location_error_m = roundedTo(contact.location_error_m, 1.0);
  out.hostile = roundedTo(contact.hostile, 0.001);
  out.friendly = roundedTo(contact.friendly, 0.001);
  out.friendly_distance_m = roundedTo(std::min(contact.friendly_distance_m, kFarFriendly_m), 1.0);
  return out;
}

void Mind::Data::tellSettings() {
  host.assertFact("settings", {{"danger-close", setup.danger_close_m}, {"hostile-belief", setup.hostile_belief}});
  for (int number = 1; number <= std::max(1, setup.max_missions); ++number) host.assertFact("channel", {{"number", whole(number)}});
  for (const MissionOrder& order : setup.orders) host.assertOrdered("mission", {word(actionWord(order.action)), whole(order.type)});
}

void Mind::Data::tellChanges() {
  if (new_self && !(self && alike(*self, *new_self))) {
    host.retract(self_fact);
    self_fact = tell(host, *new_self);
    self = new_self;
  }
  new_self.reset();
  for (auto& [id, contact] : new_contacts) {
    KnownContact& known = contacts[id];
    host.retract(known.fact);
    known.fact = nullptr;
    if (!contact) {
      contacts.erase(id);
      continue;
    }
    known.value = *contact;
    known.fact = tell(host, *contact);
    known.dismissed = false;
    told_contacts.push_back(id);
  }
  new_contacts.clear();
  for (const auto& [number, mission] : new_missions) {
    KnownMission& known = missions[number];
    host.retract(known.fact);
    known.value = mission;
    known.fact = tell(host, mission);
  }
  new_missions.clear();
  for (const Spot& spot : new_spots)
    passing.push_back(host.assertFact("spot", {{"mission", whole(spot.mission)},
                                               {"round", whole(spot.round)},
                                               {"observed", truth(spot.observed)},
                                               {"lateral", roundedTo(spot.lateral_mil, 0.1)},
                                               {"range", roundedTo(spot.range_m, 0.1)}}));
  new_spots.clear();
  for (const double distance : new_incoming) passing.push_back(host.assertFact("incoming", {{"distance", roundedTo(distance, 1.0)}}));
  new_incoming.clear();
}

void Mind::Data::forgetPassing() {
  for (const FactHandle fact : passing) host.retract(fact);
  passing.clear();
  for (const int id : told_contacts) {
    const auto known = contacts.find(id);
    if (known != contacts.end()) known->second.dismissed = !host.exists(known->second.fact);
  }
  told_contacts.clear();
  // A mission that ended is told once; its number stays known, so that telling it again changes nothing.
  for (auto& [number, known] : missions) {
    if (known.value.state != MissionFact::State::ended || known.fact == nullptr) continue;
    host.retract(known.fact);
    known.fact = nullptr;
  }
}

void Mind::self(const SelfFacts& self) { data_->new_self = self; }

void Mind::contact(const Contact& contact) {
  Data& data = *data_;
  // What rules have dismissed (retracted) is of interest again only when it seems to be something else.
  const auto known = data.contacts.find(contact.id);
  if (known != data.contacts.end() && alikeInKind(known->second.value, contact, data.setup) &&
      (known->second.dismissed || alikeInPlace(known->second.value, contact, data.setup))) {
    if (!data.new_contacts.empty()) data.new_contacts.erase(contact.id);
    return;
  }
  data.new_contacts.insert_or_assign(contact.id, rounded(contact));
}

void Mind::forget(int contact) {
  if (data_->contacts.contains(contact))
    data_->new_contacts.insert_or_assign(contact, std::nullopt);
  else
    data_->new_contacts.erase(contact);
}

void Mind::mission(const MissionFact& mission) {
  MissionFact told = mission;
  told.ot_distance_m = roundedTo(told.ot_distance_m, 1.0);
  const auto known = data_->missions.find(told.mission);
  if (known != data_->missions.end() && same(known->second.value, told)) {
    data_->new_missions.erase(told.mission);
    return;
  }
  data_->new_missions.insert_or_assign(told.mission, std::move(told));
}

void Mind::spot(const Spot& spot) { data_->new_spots.push_back(spot); }
void Mind::incoming(double distance_m) { data_->new_incoming.push_back(distance_m); }

}  // namespace npsee::observer
