// Clauses of `expect` against event logs made by hand.

#include "tests/scenario/sample.h"

#include <npsee/mission.h>

#include <gtest/gtest.h>

namespace npsee {
namespace {

using Fields = std::vector<std::pair<std::string, MissionEvent::Value>>;

MissionEvent event(double t_s, EventKind kind, Fields fields) {
  MissionEvent out;
  out.t_s = t_s;
  out.kind = kind;
  out.fields = std::move(fields);
  return out;
}

/// Two solutions, three shots, a burst 50 m from a vehicle that drives east at 10 m/s.
Recording sampleRecording(const std::string& clauses) {
  const std::string text = "{\"npsee_mission\": 1, \"vehicles\": [{\"id\": \"t72-1\", \"type\": 51, \"pos\": [1000, 1000]}],\n\"expect\": [" + clauses + "]}";
  Recording r;
  auto scenario = parseScenario(text, "m.mission.json");
  if (!scenario) throw std::runtime_error(scenario.error().text());
  r.scenario = *scenario;
  VehicleRecord vehicle;
  vehicle.id = "t72-1";
  vehicle.track.add({.start_s = 0.0, .x_m = 1000.0, .z_m = 1000.0, .heading_rad = kPi / 2.0, .speed_mps = 10.0});
  r.vehicles.push_back(vehicle);
  GunRecord gun;
  gun.id = "gun1";
  gun.muzzle_m = {0.0, 2.0, 0.0};
  r.guns.push_back(gun);
  r.events = {
      event(5.0, EventKind::solution, {{"gun", std::string("gun1")}, {"trajectory", std::string("low")}, {"qe_mil", 349.25}, {"rejected", std::vector<std::string>{"a", "b"}}}),
      event(6.0, EventKind::fire, {{"shell", std::int64_t{1}}, {"trajectory", std::string("low")}, {"position", Vec3{0, 2, 0}}}),
      event(7.0, EventKind::fire, {{"shell", std::int64_t{2}}, {"trajectory", std::string("low")}, {"position", Vec3{0, 2, 0}}}),
      event(20.0, EventKind::detonation, {{"shell", std::int64_t{1}}, {"position", Vec3{1200.0, 30.0, 1050.0}}, {"miss_m", 50.0}}),
      event(21.0, EventKind::spot, {{"observed", true}, {"lateral_mil", -3.0}}),
  };
  return r;
}

std::string unmet(const std::string& clauses) {
  std::string out;
  for (const std::string& sentence : unmetExpectations(sampleRecording(clauses))) out += (out.empty() ? "" : "\n") + sentence;
  return out;
}

TEST(Expect, EqualValuesOfEveryTypeAreMet) {
  EXPECT_EQ(unmet(""), "");
  EXPECT_EQ(unmet(R"({"event":"solution","trajectory":"low","gun":"gun1"})"), "");
  EXPECT_EQ(unmet(R"({"event":"solution","qe_mil":349.25})"), "");
  EXPECT_EQ(unmet(R"({"event":"fire","shell":2})"), "");
  EXPECT_EQ(unmet(R"({"event":"spot","observed":true})"), "");
  EXPECT_EQ(unmet(R"({"event":"solution","rejected":"b"})"), "");
  EXPECT_EQ(unmet(R"({"event":"solution","t":5})"), "");
}

TEST(Expect, NumbersBetweenBoundsAreMet) {
  EXPECT_EQ(unmet(R"({"event":"solution","qe_mil":{"min":349.25,"max":349.25}})"), "");
  EXPECT_EQ(unmet(R"({"event":"solution","qe_mil":{"min":340}})"), "");
  EXPECT_EQ(unmet(R"({"event":"spot","lateral_mil":{"max":0}})"), "");
  EXPECT_NE(unmet(R"({"event":"spot","lateral_mil":{"min":0}})"), "");
}

TEST(Expect, WithinMeasuresOnTheMapAndAtTheTimeOfTheEvent) {
  EXPECT_EQ(unmet(R"({"event":"detonation","within":{"of":"t72-1","m":50.01}})"), "");
  EXPECT_EQ(unmet(R"({"event":"detonation","within":{"of":"t72-1","m":49}})"),
            "m.mission.json:2: /expect/0: {\"event\":\"detonation\",\"within\":{\"of\":\"t72-1\",\"m\":49}} is not met. "
            "No detonation event is like that; nearest is the one at t = 20 s, but it is 50 m from t72-1.");
}

TEST(Expect, CountsEvents) {
  EXPECT_EQ(unmet(R"({"event":"fire","at_least":2,"at_most":2})"), "");
  EXPECT_EQ(unmet(R"({"event":"destroyed","at_most":3})"), "");
  EXPECT_NE(unmet(R"({"event":"fire","at_least":3})").find("Only 2 of at least 3 fire events are like that."), std::string::npos);
  EXPECT_NE(unmet(R"({"event":"fire","at_most":1})").find("At most 1 may be found, but there are 2, the first: {\"t\":6,\"ev\":\"fire\",\"shell\":1,"), std::string::npos) << unmet(R"({"event":"fire","at_most":1})");
}

TEST(Expect, TimesBoundEvents) {
  EXPECT_EQ(unmet(R"({"event":"fire","after":6,"before":7.5,"at_most":1,"at_least":1})"), "");
  EXPECT_NE(unmet(R"({"event":"fire","before":6})").find("nearest is the one at t = 6 s, but it is not before 6 s."), std::string::npos);
  EXPECT_NE(unmet(R"({"event":"fire","after":7})").find("it is not after 7 s."), std::string::npos);
}

TEST(Expect, NotMeansNone) {
  EXPECT_EQ(unmet(R"({"not":{"event":"fire","trajectory":"high"}})"), "");
  EXPECT_NE(unmet(R"({"not":{"event":"fire","trajectory":"low"}})").find("There must be none, but there are 2, the first: {\"t\":6"), std::string::npos);
  EXPECT_NE(unmet(R"({"not":{"event":"fire","shell":1}})").find("There must be none, but there is one: {\"t\":6"), std::string::npos);
}

TEST(Expect, NamesWhatCameNearest) {
  EXPECT_NE(unmet(R"({"event":"destroyed"})").find("No destroyed event is like that; the log has none at all."), std::string::npos);
  EXPECT_NE(unmet(R"({"event":"solution","trajectory":"high","gun":"gun1","qe_mil":{"min":1000}})")
                .find("nearest is the one at t = 5 s, but trajectory is \"low\" and qe_mil is 349.25."),
            std::string::npos);
  EXPECT_NE(unmet(R"({"event":"solution","battery":"b"})").find("but it has no battery."), std::string::npos);
  EXPECT_NE(unmet(R"({"event":"fire","shell":9,"before":6.5})").find("nearest is the one at t = 6 s, but shell is 1."), std::string::npos);
}

TEST(Expect, EveryUnmetClauseIsNamed) {
  const auto all = unmetExpectations(sampleRecording(R"({"event":"fire"},{"event":"lost"},{"event":"error"})"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0].starts_with("m.mission.json:2: /expect/1: {\"event\":\"lost\"} is not met."));
  EXPECT_TRUE(all[1].starts_with("m.mission.json:2: /expect/2: "));
}

}  // namespace
}  // namespace npsee
