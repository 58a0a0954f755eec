#include "sim/observer/mind.h"
#include "sim/observer/mind_data.h"

namespace npsee::observer {
namespace {

/// Types the made-up contacts have: those ordered, his own, and some of the thesis.
std::vector<int> typesOf(const MindSetup& setup) {
  std::vector<int> out{51, 52, 53, 8};
  for (const MissionOrder& order : setup.orders) out.push_back(order.type);
  return out;
}

Contact madeUp(int id, int type, double drift) {
  Contact out;
  out.id = id;
  out.type = type;
  out.type_name = "type" + std::to_string(type);
  out.range_m = 300.0 + 90.0 * id + drift;
  out.x_m = 25000.0 + out.range_m;
  out.z_m = 25000.0 + 7.0 * id;
  out.azimuth_mil = 1600.0 + id;
  out.speed_mps = id % 3 == 0 ? 8.0 : 0.0;
  out.location_error_m = id % 2 == 0 ? 200.0 : 0.0;
  out.hostile = type == 8 ? 0.0 : id % 5 == 0 ? 0.4 : 1.0;
  out.friendly = type == 8 ? 1.0 : 0.0;
  out.seen = id % 7 != 6;
  out.condition = static_cast<Contact::Condition>(id % 11 < 4 ? id % 11 : 0);
  out.friendly_distance_m = id % 4 == 0 ? 300.0 : 9000.0;
  return out;
}

/// Answers the decisions of one run as a fire direction centre would, going through every state.
void answer(Mind& mind, const std::vector<Decision>& decisions, int round, int& next_mission) {
  for (const Decision& decision : decisions) {
    MissionFact mission;
    mission.contact = decision.contact;
    mission.mission = decision.mission;
    mission.method = decision.method == FireMethod::automatic ? FireMethod::adjust_fire : decision.method;
    mission.ot_distance_m = 1800.0;
    mission.danger_close = round % 2 == 1;
    mission.rounds = round;
    switch (decision.kind) {
      case Decision::Kind::call:
        mission.mission = ++next_mission;
        mission.state = next_mission % 3 == 0 ? MissionFact::State::refused : MissionFact::State::accepted;
        mission.reason = "rehearsal";
        break;
      case Decision::Kind::correct: mission.state = MissionFact::State::splash; break;
      case Decision::Kind::fire_for_effect: mission.state = MissionFact::State::effect_over; break;
      case Decision::Kind::end: mission.state = MissionFact::State::ended; break;
      default: continue;
    }
    mind.mission(mission);
    mind.spot({mission.mission, round, round % 4 != 3, 40.0 - 15.0 * round, 320.0 - 130.0 * round});
  }
}

}  // namespace

Expected<void> rehearse(Mind& mind, const MindSetup& setup) {
  const std::vector<int> types = typesOf(setup);
  int next_mission = 0;
  SelfFacts self;
  self.x_m = self.z_m = 25000.0;
  self.type = 8;
  for (int round = 0; round < 12; ++round) {
    self.moving = round % 5 == 4;
    self.night = round >= 8;
    mind.self(self);
    for (int id = 0; id < 40; ++id) {
      if (round > 0 && id % 4 != round % 4) continue;
      if (round == 9 && id < 6)
        mind.forget(id);
      else
        mind.contact(madeUp(id, types[static_cast<std::size_t>(id) % types.size()], 5.0 * round));
    }
    if (round % 3 == 2) mind.incoming(120.0);
    std::vector<Decision> decisions;
    if (auto thought = mind.think(decisions); !thought) return thought;
    answer(mind, decisions, round, next_mission);
    // Rules that never call for fire are shown missions all the same.
    if (round == 2 && next_mission == 0) answer(mind, {Decision{Decision::Kind::call, 1, 0, FireMethod::adjust_fire, 0.0, 0.0, {}, {}, {}}}, round, next_mission);
  }
  return {};
}

std::vector<Fault> checkRules(std::string_view text, std::string_view file) {
  // The shipped files define what every other file is checked against.
  for (const ShippedFile& shipped : shippedFiles(true))
    if (text == shipped.text) return {};
  if (const auto facts = parseObserverFacts(text, file); !facts) return facts.error().faults;
  MindSetup setup;
  setup.rules = std::string(text);
  setup.rules_name = std::string(file);
  setup.orders = {{MissionAction::destroy, 51}, {MissionAction::neutralize, 52}, {MissionAction::special, 53}};
  if (const auto mind = Mind::make(setup); !mind) return mind.error().faults;
  return {};
}

}  // namespace npsee::observer
