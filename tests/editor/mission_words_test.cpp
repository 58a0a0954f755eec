#include "editor/mission/clock.h"
#include "editor/mission/contours.h"
#include "editor/mission/fire_form.h"
#include "editor/mission/person.h"
#include "editor/mission/ruler.h"
#include "editor/mission/words.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::editor {
namespace {

MissionEvent event(double t, EventKind kind, std::vector<std::pair<std::string, MissionEvent::Value>> fields = {}) { return {t, kind, std::move(fields)}; }

TEST(MissionWords, EventsReadAsSentences) {
  EXPECT_EQ(eventSentence(event(1.0, EventKind::fire, {{"shell", std::int64_t{7}}, {"gun", std::string("gun2")}, {"target", std::string("t72-1")}, {"trajectory", std::string("low")}, {"qe_mil", 349.4}, {"azimuth_mil", 1600.2}})),
            "gun2 fires shell 7 at t72-1, low, elevation 349 mil, azimuth 1600 mil.");
  EXPECT_EQ(eventSentence(event(1.0, EventKind::spot, {{"observer", std::string("fo1")}, {"shell", std::int64_t{1}}, {"lateral_mil", -25.0}, {"range_m", 120.0}, {"observed", true}})), "fo1 spots shell 1: 25 mil left, 120 m over.");
  EXPECT_EQ(eventSentence(event(1.0, EventKind::spot, {{"observer", std::string("fo1")}, {"shell", std::int64_t{1}}, {"observed", false}})), "fo1 does not see where shell 1 bursts.");
  EXPECT_EQ(eventSentence(event(1.0, EventKind::warning, {{"text", std::string("Too much wind")}})), "Too much wind.");
  EXPECT_EQ(eventSentence(event(1.0, EventKind::destroyed, {{"target", std::string("t72-1")}, {"shell", std::int64_t{3}}, {"miss_m", 4.0}})), "t72-1 is destroyed by shell 3, 4.0 m from the burst.");
}

TEST(MissionWords, EveryKindReadsAsASentenceEvenWithoutItsFields) {
  for (int i = 0; i < kEventKinds; ++i) {
    const auto kind = static_cast<EventKind>(i);
    EXPECT_FALSE(eventTitle(kind).empty());
    const std::string sentence = eventSentence(event(0.0, kind));
    if (kind != EventKind::warning && kind != EventKind::error) {
      EXPECT_TRUE(sentence.ends_with('.')) << eventTitle(kind) << ": " << sentence;
    }
  }
}

TEST(MissionWords, CorrectionsMomentsAndDistancesAreWrittenAsPeopleSayThem) {
  EXPECT_EQ(correctionText(40.0, -200.0), "right 40, drop 200");
  EXPECT_EQ(correctionText(-30.0, 0.0), "left 30");
  EXPECT_EQ(correctionText(0.0, 0.0), "repeat");
  EXPECT_EQ(momentText(12.34), "12.3 s");
  EXPECT_EQ(momentText(185.24), "3:05.2");
  EXPECT_EQ(momentText(119.97), "2:00.0");
  EXPECT_EQ(momentText(3723.0), "1:02:03");
  EXPECT_EQ(distanceText(4.04), "4.0 m");
  EXPECT_EQ(distanceText(850.4), "850 m");
  EXPECT_EQ(distanceText(12400.0), "12.4 km");
}

TEST(MissionWords, TheReasonNamesRuleAndFacts) {
  const auto call = event(2.0, EventKind::call, {{"rule", std::string("engage")}, {"facts", std::vector<std::string>{"(contact (id 3))", "(self)"}}});
  EXPECT_EQ(eventReason(call), "Rule engage\n  (contact (id 3))\n  (self)");
  EXPECT_EQ(eventReason(event(2.0, EventKind::fire)), "");
}

TEST(MissionWords, TheFilterGoesByKindAndByWord) {
  EventFilter filter;
  const auto fire = event(1.0, EventKind::fire, {{"gun", std::string("gun2")}});
  EXPECT_TRUE(filter.lists(fire));
  filter.word = "GUN2";
  EXPECT_TRUE(filter.lists(fire));
  filter.word = "gun3";
  EXPECT_FALSE(filter.lists(fire));
  filter.word.clear();
  filter.kinds[static_cast<std::size_t>(EventKind::fire)] = false;
  EXPECT_FALSE(filter.lists(fire));
}

TEST(MissionClock, PausesAtChosenEventsAndGoesOnFromThere) {
  const std::vector<MissionEvent> events{event(1.0, EventKind::fire), event(5.0, EventKind::detonation), event(5.0, EventKind::damage), event(9.0, EventKind::detonation)};
  MissionClock clock;
  clock.setDuration(20.0);
  clock.pause_at[static_cast<std::size_t>(EventKind::detonation)] = true;
  clock.toggle();
  EXPECT_EQ(clock.advance(30.0, 20.0, events), std::optional<std::size_t>(1));
  EXPECT_EQ(clock.time_s, 5.0);
  EXPECT_FALSE(clock.playing);
  clock.toggle();
  EXPECT_EQ(clock.advance(30.0, 20.0, events), std::optional<std::size_t>(3)) << "not the same one again";
  clock.toggle();
  EXPECT_FALSE(clock.advance(30.0, 20.0, events).has_value());
  EXPECT_EQ(clock.time_s, 20.0);
  EXPECT_FALSE(clock.playing);
}

TEST(MissionClock, WaitsWhereTheSimulationHasNotComeYet) {
  MissionClock clock;
  clock.setDuration(100.0);
  clock.playing = true;
  clock.advance(10.0, 4.0, {});
  EXPECT_EQ(clock.time_s, 4.0);
  EXPECT_TRUE(clock.playing);
  clock.advance(1.0, 50.0, {});
  EXPECT_EQ(clock.time_s, 5.0);
}

TEST(MissionClock, StepsStandOnTheTicksAndEventsAreFoundBothWays) {
  const std::vector<MissionEvent> events{event(1.0, EventKind::fire), event(2.0, EventKind::apex), event(3.0, EventKind::detonation)};
  MissionClock clock;
  clock.setDuration(10.0);
  clock.seek(0.12);
  clock.step(1);
  EXPECT_EQ(clock.time_s, 3.0 * kMissionTick_s);
  clock.step(-3);
  EXPECT_EQ(clock.time_s, 0.0);
  EXPECT_TRUE(clock.seekEvent(1, events));
  EXPECT_EQ(clock.time_s, 1.0);
  EXPECT_TRUE(clock.seekEvent(1, events));
  EXPECT_EQ(clock.time_s, 3.0) << "an apex is no mark";
  EXPECT_FALSE(clock.seekEvent(1, events));
  EXPECT_TRUE(clock.seekEvent(-1, events));
  EXPECT_EQ(clock.time_s, 1.0);
}

TEST(MissionPerson, ANewCommandRewritesWhatTheSameOneDidLater) {
  const auto drive = [](const char* who, double t, double speed) {
    MissionCommand out;
    out.who = who;
    out.t_s = t;
    out.speed_mps = speed;
    return out;
  };
  MissionCommands all;
  for (const auto& [who, t] : {std::pair("a", 10.0), std::pair("b", 20.0), std::pair("a", 30.0)}) all = withCommand(all, drive(who, t, 1.0));
  all = withCommand(all, drive("a", 15.0, 2.0));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[1].t_s, 15.0);
  EXPECT_EQ(all[2].who, "b") << "the other one's stay";
  all = withCommand(all, drive("b", 20.0, 5.0));
  ASSERT_EQ(all.size(), 3u) << "one wish a tick";
  EXPECT_EQ(all[2].speed_mps, 5.0);
}

TEST(MissionPerson, ACommandTakesEffectWithTheNextTick) {
  EXPECT_EQ(commandTime(0.0), kMissionTick_s);
  EXPECT_EQ(commandTime(10.0), 201 * kMissionTick_s);
  EXPECT_EQ(commandTime(10.04), 202 * kMissionTick_s) << "the tick of 10.05 is simulated when 10.04 is shown";
}

TEST(MissionPerson, WhoWasTakenIsHandedBack) {
  MissionCommand take, release;
  take.kind = MissionCommand::Kind::take;
  release.kind = MissionCommand::Kind::release;
  take.who = release.who = "fo1";
  take.t_s = 10.0;
  release.t_s = 20.0;
  const MissionCommands all{take, release};
  EXPECT_FALSE(takenOver(all, "fo1", 9.0));
  EXPECT_TRUE(takenOver(all, "fo1", 10.0));
  EXPECT_FALSE(takenOver(all, "fo1", 20.0));
  EXPECT_FALSE(takenOver(all, "fo2", 15.0));
}

TEST(MissionFireForm, MilsBecomeMetresByTheObserverTargetFactor) {
  EXPECT_EQ(otFactor(4200.0), 4.0);
  EXPECT_EQ(otFactor(640.0), 0.6);
  EXPECT_EQ(lateralCorrection(25.0, 4000.0), -100.0) << "a burst right of the target is corrected to the left";
  EXPECT_EQ(lateralCorrection(-12.0, 2000.0), 20.0);
  EXPECT_FALSE(std::signbit(lateralCorrection(0.0, 2000.0)));
}

/// A recording with an observer at (1000, 1000) on level ground, and nothing else.
Recording standing() {
  Recording out;
  auto terrain = Terrain::make({}, 5000.0, 5000.0, 0.0);
  out.terrain = *terrain;
  out.scenario.world.size_x_m = out.scenario.world.size_z_m = 5000.0;
  VehicleRecord vehicle;
  vehicle.id = "fo1";
  Leg leg;
  leg.x_m = leg.z_m = 1000.0;
  vehicle.track.add(leg);
  out.vehicles.push_back(vehicle);
  leg.x_m = 2000.0;
  vehicle.id = "t72-1";
  vehicle.track = {};
  vehicle.track.add(leg);
  out.vehicles.push_back(vehicle);
  out.observers.push_back({"fo1", 0, 2.5, {{0.0, 1, true, {2000.0, 0.0, 1000.0}, 1.0, 0.0, 0}}});
  return out;
}

TEST(MissionFireForm, GridPolarAndShiftNameTheSamePlace) {
  const Recording recording = standing();
  CallForm form;
  form.grid = {2100.0, 1300.0};
  EXPECT_EQ(*placeOfCall(form, recording, 0, 5.0), form.grid);
  const auto [azimuth, distance] = polarTo(recording, 0, 5.0, form.grid);
  // East is 1600 mil; 300 m south of a line 1100 m long.
  EXPECT_NEAR(azimuth, 1600.0 + std::atan2(300.0, 1100.0) * 6400.0 / (2.0 * 3.14159265358979), 1e-6);
  form.locate = Locate::polar;
  form.azimuth_mil = azimuth;
  form.distance_m = distance;
  const Place polar = *placeOfCall(form, recording, 0, 5.0);
  EXPECT_NEAR(polar.x_m, 2100.0, 1e-6);
  EXPECT_NEAR(polar.z_m, 1300.0, 1e-6);
  form.locate = Locate::shift;
  form.known = "t72-1";
  form.right_m = 300.0;
  form.add_m = 100.0;
  const Place shifted = *placeOfCall(form, recording, 0, 5.0);
  EXPECT_NEAR(shifted.x_m, 2100.0, 1e-9) << "looking east, right is south";
  EXPECT_NEAR(shifted.z_m, 1300.0, 1e-9);
}

TEST(MissionFireForm, ACallOutsideTheWorldOrFromNoKnownPointIsRefusedWithItsReason) {
  const Recording recording = standing();
  CallForm form;
  form.grid = {9000.0, 0.0};
  EXPECT_NE(placeOfCall(form, recording, 0, 0.0).error().text().find("outside the world"), std::string::npos);
  form.locate = Locate::shift;
  form.known = "bridge";
  EXPECT_NE(placeOfCall(form, recording, 0, 0.0).error().text().find("bridge"), std::string::npos);
  EXPECT_FALSE(placeOfCall(form, recording, -1, 0.0).has_value());
}

TEST(MissionFireForm, OpenMissionsAreThoseCalledAndNotEnded) {
  Recording recording = standing();
  recording.events = {event(1.0, EventKind::call, {{"observer", std::string("fo1")}, {"mission", std::int64_t{1}}, {"method", std::string("adjust_fire")}, {"position", Vec3{2000.0, 0.0, 1000.0}}}),
                      event(9.0, EventKind::detonation, {{"mission", std::int64_t{1}}}),
                      event(12.0, EventKind::correction, {{"observer", std::string("fo1")}, {"mission", std::int64_t{1}}, {"method", std::string("fire_for_effect")}, {"grade_m", 50.0}}),
                      event(30.0, EventKind::end_of_mission, {{"mission", std::int64_t{1}}})};
  EXPECT_TRUE(openMissions(recording, "fo1", 0.5).empty());
  const auto open = openMissions(recording, "fo1", 20.0);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].rounds, 1);
  EXPECT_TRUE(open[0].effect);
  EXPECT_TRUE(openMissions(recording, "fo1", 31.0).empty());
  EXPECT_TRUE(openMissions(recording, "fo2", 20.0).empty());
  EXPECT_EQ(gradeOf(recording, "fo1", 20.0).corrections, 1);
  EXPECT_EQ(gradeOf(recording, "fo1", 20.0).mean_m, 50.0);
  EXPECT_EQ(gradeOf(recording, "fo1", 10.0).corrections, 0);
}

TEST(MissionRuler, ReadsDistanceAzimuthAndSight) {
  const auto flat = Terrain::make({}, 5000.0, 5000.0, 0.0);
  Ruler ruler;
  ruler.pick({1000.0, 0.0, 1000.0});
  EXPECT_FALSE(ruler.complete());
  ruler.pick({1000.0, 0.0, 3000.0});
  ASSERT_TRUE(ruler.complete());
  const RulerReading reading = readRuler(ruler, *flat, 11);
  EXPECT_NEAR(reading.level_m, 2000.0, 1e-9);
  EXPECT_NEAR(reading.azimuth_mil, 3200.0, 1e-9) << "z runs south";
  EXPECT_NEAR(reading.back_azimuth_mil, 0.0, 1e-9);
  EXPECT_EQ(reading.profile.size(), 11u);
  EXPECT_TRUE(reading.sight.clear);
  ruler.pick({0.0, 0.0, 0.0});
  EXPECT_FALSE(ruler.complete()) << "a third click starts anew";
}

TEST(MissionMap, ContoursOfAConeAreRingsOfTheRightRadius) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "cone";
  source.params = {{"top_x", 2000.0}, {"top_z", 2000.0}, {"top_height", 200.0}, {"radius", 1000.0}};
  const auto terrain = Terrain::make(source, 4000.0, 4000.0, -10.0);
  ASSERT_TRUE(terrain.has_value()) << terrain.error().text();
  const GroundMap map = groundMap(*terrain, {0.0, 0.0}, {4000.0, 4000.0}, 161, 161);
  EXPECT_EQ(map.interval_m, 20.0);
  ASSERT_FALSE(map.contours.empty());
  for (const GroundMap::Segment& segment : map.contours) {
    const double radius = std::hypot(segment.a.x_m - 2000.0, segment.a.z_m - 2000.0);
    // Height 200 (1 - r / 1000): every line lies on a multiple of the interval, within the grid's step.
    const double height = 200.0 * (1.0 - radius / 1000.0), off = std::abs(height - std::round(height / 20.0) * 20.0);
    EXPECT_LT(off, 3.0) << "at radius " << radius;
  }
}

TEST(MissionMap, IntervalsAreRound) {
  EXPECT_EQ(contourInterval(0.0, 240.0, 12), 20.0);
  EXPECT_EQ(contourInterval(0.0, 1100.0, 12), 100.0);
  EXPECT_EQ(contourInterval(5.0, 5.0, 12), 1.0);
}

}  // namespace
}  // namespace npsee::editor
