#include "sim/observer/mind_data.h"

#include <array>
#include <cmath>

namespace npsee::observer {
namespace {

constexpr std::array<std::string_view, 4> kConditions{"whole", "damaged", "suppressed", "destroyed"};
constexpr std::array<std::string_view, 6> kStates{"refused", "accepted", "splash", "effect", "effect_over", "ended"};
constexpr std::array<std::string_view, 7> kMethods{"automatic", "adjust_fire", "fire_for_effect", "suppress", "immediate_suppression", "smoke", "illuminate"};
constexpr std::array<std::string_view, 3> kActions{"destroy", "neutralize", "special"};

double roundedTo(double value, double step) { return std::isfinite(value) ? std::nearbyint(value / step) * step : 0.0; }

RuleValue whole(int value) { return static_cast<std::int64_t>(value); }
RuleValue word(std::string_view text) { return Symbol{std::string(text)}; }
RuleValue truth(bool value) { return Symbol{value ? "TRUE" : "FALSE"}; }

bool same(const Contact& a, const Contact& b) {
  return a.id == b.id && a.type == b.type && a.type_name == b.type_name && a.x_m == b.x_m && a.z_m == b.z_m && a.range_m == b.range_m && a.azimuth_mil == b.azimuth_mil &&
         a.speed_mps == b.speed_mps && a.location_error_m == b.location_error_m && a.hostile == b.hostile && a.friendly == b.friendly && a.condition == b.condition &&
         a.seen == b.seen && a.friendly_distance_m == b.friendly_distance_m;
}
bool same(const MissionFact& a, const MissionFact& b) {
  return a.mission == b.mission && a.contact == b.contact && a.state == b.state && a.method == b.method && a.rounds == b.rounds && a.danger_close == b.danger_close &&
         a.ot_distance_m == b.ot_distance_m && a.reason == b.reason;
}
bool same(const SelfFacts& a, const SelfFacts& b) {
  return a.x_m == b.x_m && a.z_m == b.z_m && a.type == b.type && a.max_range_m == b.max_range_m && a.moving == b.moving && a.night == b.night && a.method == b.method &&
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
  out.speed_mps = roundedTo(contact.speed_mps, 0.5);
  out.location_error_m = roundedTo(contact.location_error_m, 1.0);
  out.hostile = roundedTo(contact.hostile, 0.001);
  out.friendly = roundedTo(contact.friendly, 0.001);
  // Beyond every danger-close distance the exact figure would only make facts change.
  out.friendly_distance_m = roundedTo(std::min(contact.friendly_distance_m, 5000.0), 10.0);
  return out;
}

void Mind::Data::tellSettings() {
  host.assertFact("settings", {{"danger-close", setup.danger_close_m}, {"hostile-belief", setup.hostile_belief}});
  for (int number = 1; number <= std::max(1, setup.max_missions); ++number) host.assertFact("channel", {{"number", whole(number)}});
  for (const MissionOrder& order : setup.orders) host.assertOrdered("mission", {word(actionWord(order.action)), whole(order.type)});
}

void Mind::Data::tellChanges() {
  if (new_self && !(self && same(*self, *new_self))) {
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
  // A mission that ended is told once; its number stays known, so that telling it again changes nothing.
  for (auto& [number, known] : missions) {
    if (known.value.state != MissionFact::State::ended || known.fact == nullptr) continue;
    host.retract(known.fact);
    known.fact = nullptr;
  }
}

void Mind::self(const SelfFacts& self) { data_->new_self = self; }

void Mind::contact(const Contact& contact) {
  const Contact told = rounded(contact);
  const auto known = data_->contacts.find(told.id);
  if (known != data_->contacts.end() && same(known->second.value, told)) {
    data_->new_contacts.erase(told.id);
    return;
  }
  data_->new_contacts.insert_or_assign(told.id, told);
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
