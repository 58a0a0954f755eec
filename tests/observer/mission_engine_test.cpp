#include "sim/world/scenario_table.h"
#include "tests/support/small_mission.h"

#include <npsee/mission.h>
#include <npsee/units.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace npsee {
namespace {

using test::eventsOf;

/// The small mission with three howitzers, longer, and its observer due west of the tank.
Scenario duel() {
  Scenario sc = test::smallMission();
  sc.duration_s = 300.0;
  sc.batteries[0].guns.push_back({"gun3", {2000.0, 5030.0}});
  sc.observers[0].at = {4500.0, 5000.0};
  return sc;
}

Recording ran(const Scenario& scenario, const std::vector<MissionCommand>& commands = {}) {
  auto recording = runMission(scenario, {}, commands);
  EXPECT_TRUE(recording.has_value()) << (recording ? "" : recording.error().text());
  return recording ? std::move(*recording) : Recording{};
}

/// The duel, and a hundred vehicles that wander about.
Scenario busyDuel() {
  Scenario sc = duel();
  sc.groups.push_back({.id = "g", .type = 52, .count = 100, .from = {6500, 3000}, .to = {9500, 7000}});
  return sc;
}

TEST(MissionEngine, ARecordingBeyondALimitEndsWithAnErrorThatNamesIt) {
  const auto endOf = [](const MissionLimits& limits) {
    const auto recording = runMission(busyDuel(), {}, {}, limits);
    EXPECT_TRUE(recording && recording->finished);
    if (!recording) return std::string();
    // The error stands right before the end, at the time at which the mission stopped.
    const MissionEvent& error = recording->events[recording->events.size() - 2];
    EXPECT_EQ(error.kind, EventKind::error) << eventLog(*recording);
    EXPECT_EQ(error.t_s, recording->duration_s);
    EXPECT_LT(recording->duration_s, 300.0);
    return error.text("text");
  };
  EXPECT_EQ(endOf({.legs = 500}), "The mission ends here: its recording would hold more than 500 legs of vehicles. Shorten its duration, or let fewer vehicles drive.");
  EXPECT_EQ(endOf({.shells = 2}), "The mission ends here: its recording would hold more than 2 shells. Shorten its duration, or give the guns fewer rounds.");
  EXPECT_EQ(endOf({.events = 40}), "The mission ends here: its recording would hold more than 40 events. Shorten its duration, or take fewer observers and vehicles.");
  EXPECT_EQ(endOf({.beliefs = 200}), "The mission ends here: its recording would hold more than 200 beliefs of observers. Shorten its duration, or take fewer observers and vehicles.");
}

TEST(MissionEngine, ALimitStopsAtTheSameTickAndChangesNothingBefore) {
  const auto whole = runMission(busyDuel()), cut = runMission(busyDuel(), {}, {}, {.legs = 500}), again = runMission(busyDuel(), {}, {}, {.legs = 500});
  ASSERT_TRUE(whole && cut && again);
  EXPECT_EQ(cut->hash, again->hash);
  ASSERT_GT(cut->events.size(), 2u);
  for (std::size_t i = 0; i + 2 < cut->events.size(); ++i) EXPECT_EQ(cut->events[i], whole->events[i]) << i;
}

TEST(MissionEngine, AStaticTargetInPlainSightIsFoundFiredAtAndDestroyed) {
  const Recording recording = ran(duel());
  ASSERT_FALSE(eventsOf(recording, EventKind::contact).empty());
  ASSERT_FALSE(eventsOf(recording, EventKind::call).empty());
  const auto destroyed = eventsOf(recording, EventKind::destroyed);
  ASSERT_EQ(destroyed.size(), 1u) << eventLog(recording);
  EXPECT_EQ(destroyed.front()->text("target"), "t72-1");
  ASSERT_FALSE(eventsOf(recording, EventKind::end_of_mission).empty());
  EXPECT_EQ(eventsOf(recording, EventKind::end_of_mission).front()->text("result"), "destroyed");
  EXPECT_EQ(recording.events.back().kind, EventKind::end);
  EXPECT_TRUE(recording.finished);
}

TEST(MissionEngine, EveryDecisionNamesItsRuleAndFacts) {
  const Recording recording = ran(duel());
  for (const EventKind kind : {EventKind::call, EventKind::end_of_mission})
    for (const MissionEvent* event : eventsOf(recording, kind)) {
      EXPECT_FALSE(event->text("rule").empty()) << eventJson(*event);
      const auto* facts = event->find("facts");
      ASSERT_NE(facts, nullptr);
      EXPECT_FALSE(std::get<std::vector<std::string>>(*facts).empty()) << eventJson(*event);
    }
}

TEST(MissionEngine, TheLogIsInOrderOfTimeAndKeepsToItsSchema) {
  const Recording recording = ran(duel());
  double before = 0.0;
  for (const MissionEvent& event : recording.events) {
    EXPECT_GE(event.t_s, before - kMissionTick_s) << eventJson(event);
    before = std::max(before, event.t_s);
    const std::string_view name = eventKindNames()[static_cast<std::size_t>(event.kind)];
    for (const auto& [key, value] : event.fields) {
      const bool listed = std::any_of(eventSchema().begin(), eventSchema().end(), [&](const EventKey& row) { return row.event == name && row.key == key; });
      EXPECT_TRUE(listed) << name << " has the key " << key << ", which the schema does not list";
    }
  }
}

TEST(MissionEngine, EachDetonationHasItsFireAndLandsWhereItsPathEnds) {
  const Recording recording = ran(duel());
  std::map<std::int64_t, double> fired;
  for (const MissionEvent* event : eventsOf(recording, EventKind::fire)) fired[static_cast<std::int64_t>(event->number("shell"))] = event->t_s;
  const auto detonations = eventsOf(recording, EventKind::detonation);
  ASSERT_FALSE(detonations.empty());
  for (const MissionEvent* event : detonations) {
    const auto number = static_cast<std::int64_t>(event->number("shell"));
    ASSERT_TRUE(fired.contains(number));
    const ShellRecord& shell = recording.shells[static_cast<std::size_t>(number - 1)];
    EXPECT_EQ(shell.fired_s, fired[number]);
    EXPECT_NEAR(event->t_s - fired[number], shell.path.flight().time_of_flight_s, 1e-9);
    const Vec3 end = shell.at(event->t_s);
    EXPECT_EQ(end.x, event->place()->x);
    EXPECT_EQ(end.z, event->place()->z);
    EXPECT_NEAR(end.y, recording.terrain.height(end.x, end.z), 0.5);
  }
}

TEST(MissionEngine, GunsKeepToTheirReloadTimeAndToTheirRounds) {
  Scenario sc = duel();
  sc.batteries[0].rounds = 2;
  sc.batteries[0].pe_range_m = 400.0;  // so that the tank lives on
  sc.batteries[0].pe_deflection_m = 400.0;
  sc.duration_s = 900.0;
  const Recording recording = ran(sc);
  std::map<std::string, std::vector<double>> shots;
  for (const MissionEvent* event : eventsOf(recording, EventKind::fire)) shots[event->text("gun")].push_back(event->t_s);
  ASSERT_FALSE(shots.empty());
  for (const auto& [gun, times] : shots) {
    EXPECT_LE(times.size(), 2u) << gun;
    for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GE(times[i] - times[i - 1], sc.batteries[0].reload_time_s - 1e-9) << gun;
    EXPECT_GE(times.front(), sc.batteries[0].lay_time_s) << gun;
  }
}

/// Another allowed value than the present one, if there is a simple one.
std::optional<world::FieldValue> otherValue(const world::Field& field, const world::FieldValue& now) {
  if (const auto* on = std::get_if<bool>(&now)) return !*on;
  if (const auto* whole = std::get_if<std::int64_t>(&now)) return *whole + 1;
  if (const auto* number = std::get_if<double>(&now)) return *number + 0.01 * (toSi(field.unit, field.hard.max) - *number);
  if (std::holds_alternative<Place>(now)) return Place{100.0, 200.0};
  return std::nullopt;
}

/// Changes each field that is said to have no effect, wherever it is in a structure, and returns their names.
std::vector<std::string> changeIdleFields(const world::Struct& table, void* object) {
  std::vector<std::string> out;
  for (const world::Field& field : table.fields) {
    std::vector<std::string> inner;
    if (field.type == world::FieldType::object) inner = changeIdleFields(*field.child, field.part(object));
    if (field.type == world::FieldType::list)
      for (std::size_t i = 0; i < field.count(object); ++i) std::ranges::copy(changeIdleFields(*field.child, field.item(object, i)), std::back_inserter(inner));
    out.insert(out.end(), inner.begin(), inner.end());
    if (!field.scalar() || field.idle == nullptr || field.idle(object).empty()) continue;
    const auto value = otherValue(field, field.read(object));
    if (!value || !world::checkField(field, *value).empty()) continue;
    field.write(object, *value);
    out.emplace_back(field.key);
  }
  return out;
}

TEST(MissionEngine, FieldsSaidToHaveNoEffectHaveNone) {
  Scenario sc = duel();
  sc.vehicles[0].speed_mps = 5.0;
  sc.vehicles[0].behaviour = Behaviour::straight;
  sc.observers[0].sensing.location_cep_m = 80.0;
  sc.observers[0].sensing.limited_belief = false;
  sc.vehicles.push_back(sc.vehicles[0]);
  sc.vehicles[1].id = "carrier";
  sc.vehicles[1].type = 8;
  sc.vehicles[1].at = {4500.0, 5000.0};
  sc.observers[0].vehicle = "carrier";
  Scenario changed = sc;
  const std::vector<std::string> keys = changeIdleFields(world::missionTable(), &changed);
  for (const char* key : {"pos", "belief_near", "far", "night_range", "relief", "valley", "table_step", "read_back", "gap", "repeat_goals"}) EXPECT_TRUE(std::ranges::count(keys, key) > 0) << key;
  EXPECT_EQ(std::ranges::count(keys, "height"), 0) << "flat ground has a height";
  EXPECT_EQ(eventLog(ran(changed)), eventLog(ran(sc)));
}

TEST(MissionEngine, TheSameSeedGivesTheSameLogAndAnotherSeedAnother) {
  Scenario sc = duel();
  sc.batteries[0].pe_range_m = 15.0;
  sc.batteries[0].pe_deflection_m = 4.0;
  const std::string log = eventLog(ran(sc));
  EXPECT_EQ(eventLog(ran(sc)), log);
  sc.seed = 7;
  EXPECT_NE(eventLog(ran(sc)), log);
}

TEST(MissionEngine, AdvancingInSmallPiecesIsTheSameAsAllAtOnce) {
  const Scenario sc = duel();
  auto mission = Mission::make(sc);
  ASSERT_TRUE(mission.has_value()) << mission.error().text();
  for (double t = 0.0; t < sc.duration_s + 1.0; t += 0.37) mission->advance(t);
  EXPECT_TRUE(mission->finished());
  EXPECT_EQ(eventLog(mission->recording()), eventLog(ran(sc)));
}

TEST(MissionEngine, AnEmptyWorldRunsToItsEnd) {
  Scenario sc;
  sc.duration_s = 5.0;
  const Recording recording = ran(sc);
  ASSERT_EQ(recording.events.size(), 1u) << eventLog(recording);
  EXPECT_EQ(recording.events.front().kind, EventKind::end);
  EXPECT_EQ(recording.events.front().t_s, 5.0);
}

TEST(MissionEngine, GunsOutOfRangeRefuseWithTheReason) {
  Scenario sc = duel();
  for (GunSetup& gun : sc.batteries[0].guns) gun.at = {100, 9900};
  const Recording recording = ran(sc);
  const auto refusals = eventsOf(recording, EventKind::refuse);
  ASSERT_FALSE(refusals.empty()) << eventLog(recording);
  EXPECT_EQ(refusals.front()->text("reason"), "out_of_range");
  EXPECT_FALSE(refusals.front()->text("text").empty());
  EXPECT_TRUE(recording.shells.empty());
  // One refusal per gun and mission, and no endless calling again.
  EXPECT_LE(refusals.size(), 3u * eventsOf(recording, EventKind::call).size());
  EXPECT_LE(eventsOf(recording, EventKind::call).size(), 3u);
}

TEST(MissionEngine, ALocationErrorIsWalkedInAndTheTargetDestroyed) {
  Scenario sc = duel();
  sc.observers[0].sensing.location_cep_m = 200.0;
  sc.batteries[0].pe_range_m = 15.0;
  sc.batteries[0].pe_deflection_m = 4.0;
  sc.duration_s = 600.0;
  int destroyed = 0, corrected = 0;
  for (std::int64_t seed = 1; seed <= 20; ++seed) {
    sc.seed = seed;
    const Recording recording = ran(sc);
    destroyed += !eventsOf(recording, EventKind::destroyed).empty();
    for (const MissionEvent* event : eventsOf(recording, EventKind::spot)) {
      // What he saw is what was there: the spot's range is the burst's place along his line to the tank, which runs due east.
      const ShellRecord& shell = recording.shells[static_cast<std::size_t>(event->number("shell")) - 1];
      EXPECT_NEAR(event->number("range_m"), shell.burst_m.x - 7000.0, 1e-6);
      EXPECT_EQ(event->number("lateral_mil") > 0.0, shell.burst_m.z > 5000.0) << "south of an eastward line is right of it";
    }
    corrected += !eventsOf(recording, EventKind::correction).empty();
  }
  EXPECT_GE(destroyed, 19);
  EXPECT_GE(corrected, 5) << "some first rounds are too far off to do harm";
}

TEST(MissionEngine, APersonInTheObserversPlaceCallsCorrectsAndEnds) {
  Scenario sc = duel();
  sc.observers[0].human = true;
  const Recording idle = ran(sc);
  EXPECT_TRUE(eventsOf(idle, EventKind::call).empty()) << "the rules called although a person observes";

  using enum MissionCommand::Kind;
  const std::vector<MissionCommand> commands{
      {.t_s = 2.0, .kind = call_for_fire, .who = "fo1", .place = {7150, 5120}, .target = {}, .method = FireMethod::adjust_fire, .description = "tank in the open"},
      {.t_s = 60.0, .kind = fire_for_effect, .who = "fo1", .place = {}, .target = {}, .mission = 1, .right_m = -120.0, .add_m = -150.0, .description = {}},
      {.t_s = 200.0, .kind = end_mission, .who = "fo1", .place = {}, .target = {}, .mission = 1, .description = "target destroyed"}};
  const Recording recording = ran(sc, commands);
  EXPECT_EQ(eventsOf(recording, EventKind::call).size(), 1u) << eventLog(recording);
  ASSERT_FALSE(eventsOf(recording, EventKind::spot).empty());
  ASSERT_FALSE(eventsOf(recording, EventKind::correction).empty());
  EXPECT_NEAR(eventsOf(recording, EventKind::correction).front()->number("aim_error_m"), 0.0, 15.0);
  EXPECT_EQ(eventsOf(recording, EventKind::destroyed).size(), 1u);
  EXPECT_EQ(eventLog(ran(sc, commands)), eventLog(recording)) << "the same commands give the same mission";
}

TEST(MissionEngine, CommandsThatNameNobodyAreAnsweredByAWarning) {
  using enum MissionCommand::Kind;
  const Recording recording = ran(duel(), {{.t_s = 1.0, .kind = drive, .who = "nobody", .place = {}, .target = {}, .description = {}},
                                           {.t_s = 1.0, .kind = correct, .who = "fo1", .place = {}, .target = {}, .mission = 99, .description = {}}});
  EXPECT_GE(eventsOf(recording, EventKind::warning).size(), 2u);
}

/// A command without the fields that its kind does not need.
MissionCommand command(double t_s, MissionCommand::Kind kind, const std::string& who, const std::string& target = {}, int mission = 0) {
  return {.t_s = t_s, .kind = kind, .who = who, .place = {}, .target = target, .mission = mission, .description = {}};
}

/// The texts of all warnings, and that the log knows of nothing else that was done.
void expectOnlyWarnings(const Recording& recording, const std::vector<std::string>& texts) {
  std::vector<std::string> told;
  for (const MissionEvent* event : eventsOf(recording, EventKind::warning)) told.push_back(event->text("text"));
  EXPECT_EQ(told, texts) << eventLog(recording);
}

TEST(MissionEngine, ACallOnATargetThatIsNotKnownIsRefusedInTheLog) {
  using enum MissionCommand::Kind;
  Scenario sc = duel();
  sc.observers[0].human = true;
  sc.vehicles.push_back(sc.vehicles[0]);
  sc.vehicles[1].id = "hidden";
  sc.vehicles[1].at = {9900.0, 5000.0};  // beyond what he sees
  sc.observers[0].max_range_m = 4000.0;
  const Recording recording = ran(sc, {command(1.0, call_for_fire, "fo1", "t72-9"), command(1.0, call_for_fire, "fo1", "hidden"), command(1.0, call_for_fire, "nobody", "t72-1")});
  expectOnlyWarnings(recording, {"There is no vehicle \"t72-9\" to call fire on.", "Observer fo1 has not seen hidden; a call for fire on it needs a place.", "There is no observer \"nobody\" to call fire."});
  EXPECT_TRUE(eventsOf(recording, EventKind::call).empty());
  EXPECT_TRUE(recording.shells.empty());
}

TEST(MissionEngine, ACallOnATargetThatIsKnownGoesWhereHeBelievesIt) {
  using enum MissionCommand::Kind;
  Scenario sc = duel();
  sc.observers[0].human = true;
  const Recording recording = ran(sc, {command(2.0, call_for_fire, "fo1", "t72-1")});
  ASSERT_EQ(eventsOf(recording, EventKind::call).size(), 1u);
  EXPECT_EQ(eventsOf(recording, EventKind::call).front()->text("target"), "t72-1");
  EXPECT_NEAR(eventsOf(recording, EventKind::call).front()->number("range_m"), 2500.0, 200.0);
  EXPECT_FALSE(recording.shells.empty());
}

TEST(MissionEngine, ACallOnATargetThatHasDrivenAwayGoesWhereHeSawItLast) {
  using enum MissionCommand::Kind;
  Scenario sc = duel();
  sc.observers[0].human = true;
  sc.observers[0].max_range_m = 2600.0;
  sc.vehicles[0].behaviour = Behaviour::user;
  const Recording recording = ran(sc, {command(1.0, take, "t72-1"), [] {
                                         MissionCommand out = command(1.0, drive, "t72-1");
                                         out.speed_mps = 15.0;
                                         return out;
                                       }(), command(100.0, call_for_fire, "fo1", "t72-1")});
  const auto lost = eventsOf(recording, EventKind::lost);
  ASSERT_EQ(lost.size(), 1u) << eventLog(recording);
  const auto calls = eventsOf(recording, EventKind::call);
  ASSERT_EQ(calls.size(), 1u) << eventLog(recording);
  EXPECT_EQ(*calls.front()->find("position"), *lost.front()->find("position"));
}

TEST(MissionEngine, OnlyItsObserverCorrectsAMission) {
  using enum MissionCommand::Kind;
  Scenario sc = duel();
  sc.observers[0].human = true;
  sc.observers.push_back(sc.observers[0]);
  sc.observers[1].id = "fo2";
  sc.observers[1].at = {4500.0, 5300.0};
  std::vector<MissionCommand> commands{command(2.0, call_for_fire, "fo1", "t72-1")};
  const Recording alone = ran(sc, commands);
  for (const auto kind : {correct, fire_for_effect, end_mission})
    for (const char* who : {"fo2", "nobody", ""}) commands.push_back(command(20.0, kind, who, {}, 1));
  const Recording recording = ran(sc, commands);
  const auto warnings = eventsOf(recording, EventKind::warning);
  ASSERT_EQ(warnings.size(), 9u) << eventLog(recording);
  EXPECT_EQ(warnings.front()->text("text"), "Mission 1 is not that of \"fo2\", but of fo1; the order is dropped.");
  EXPECT_TRUE(eventsOf(recording, EventKind::correction).empty());
  EXPECT_EQ(recording.shells.size(), alone.shells.size()) << "the orders changed nothing";
}

TEST(MissionEngine, EndingAMissionThatIsNotOpenIsTold) {
  using enum MissionCommand::Kind;
  Scenario sc = duel();
  sc.observers[0].human = true;
  const Recording recording = ran(sc, {command(1.0, end_mission, "fo1", {}, 77), command(2.0, call_for_fire, "fo1", "t72-1"), command(3.0, end_mission, "fo1", {}, 1), command(4.0, end_mission, "fo1", {}, 1)});
  expectOnlyWarnings(recording, {"Mission 77 is not open; there is nothing to end.", "Mission 1 is not open; there is nothing to end."});
}

TEST(MissionEngine, DrivingOrCallingWithWhatIsDestroyedIsTold) {
  using enum MissionCommand::Kind;
  Scenario sc = duel();
  const Recording destroyed = ran(sc);
  const auto when = eventsOf(destroyed, EventKind::destroyed);
  ASSERT_EQ(when.size(), 1u);
  const Recording recording = ran(sc, {command(when.front()->t_s + 1.0, drive, "t72-1")});
  expectOnlyWarnings(recording, {"Vehicle t72-1 is destroyed and does not drive."});
}

TEST(MissionEngine, ADriverMovesHisVehicleAndItsTrackShowsIt) {
  using enum MissionCommand::Kind;
  Scenario sc = duel();
  sc.vehicles[0].behaviour = Behaviour::user;
  const Recording recording = ran(sc, {{.t_s = 1.0, .kind = drive, .who = "t72-1", .speed_mps = 8.0, .turn_radps = 0.0, .place = {}, .target = {}, .description = {}}});
  const auto& track = recording.vehicles[0].track;
  const Pose start = track.at(0.5), later = track.at(4.0);
  EXPECT_EQ(start.x_m, 7000.0);
  EXPECT_GT(std::hypot(later.x_m - start.x_m, later.z_m - start.z_m), 5.0);
}

}  // namespace
}  // namespace npsee
