#include "tests/world/vehicles_support.h"

#include <npsee/units.h>

#include <algorithm>

namespace npsee {
namespace {

using test::Convoy;
using test::flatTerrain;
using test::kEast;
using test::scenarioOf;
using test::vehicle;

Scenario meanderers(int count, std::int64_t seed, double size_m) {
  Scenario scenario = scenarioOf({}, size_m);
  scenario.seed = seed;
  VehicleGroup group;
  group.id = "g";
  group.type = 51;
  group.count = count;
  group.to = {size_m, size_m};
  scenario.groups.push_back(group);
  return scenario;
}

Terrain coast() {
  auto source = test::hills(5);
  source.scale_m = 1500.0;
  source.sea_fraction = 0.35;
  return test::terrain(source, 8000.0, 8000.0);
}

TEST(Vehicles, StaticOnesStandAndStraightOnesKeepHeadingAndSpeed) {
  Convoy convoy(scenarioOf({vehicle("a", {500, 600}, Behaviour::stationary), vehicle("b", {100, 5000}, Behaviour::straight, 10.0, kEast)}), flatTerrain());
  convoy.runTo(300.0, [&](double t) {
    EXPECT_EQ(convoy.vehicles().x()[0], 500.0);
    EXPECT_NEAR(convoy.vehicles().x()[1], 100.0 + 10.0 * t, 1e-6);
    EXPECT_NEAR(convoy.vehicles().z()[1], 5000.0, 1e-6);
    EXPECT_NEAR(convoy.vehicles().velocity(1).x, 10.0, 1e-9);
    EXPECT_EQ(convoy.vehicles().speed()[0], 0.0);
  });
  // Nothing was decided, so nothing was written.
  EXPECT_EQ(convoy.records()[0].track.legs.size(), 1u);
  EXPECT_EQ(convoy.records()[1].track.legs.size(), 1u);
}

TEST(Vehicles, NorthIsAgainstZAndHeadingsRunClockwise) {
  Convoy convoy(scenarioOf({vehicle("n", {5000, 5000}, Behaviour::straight, 10.0, 0.0), vehicle("s", {5000, 5000}, Behaviour::straight, 10.0, kPi)}), flatTerrain());
  convoy.runTo(10.0);
  EXPECT_NEAR(convoy.vehicles().z()[0], 4900.0, 1e-6);
  EXPECT_NEAR(convoy.vehicles().z()[1], 5100.0, 1e-6);
}

TEST(Vehicles, AWishedSpeedAboveTheTypesIsTheTypes) {
  Convoy convoy(scenarioOf({vehicle("a", {100, 5000}, Behaviour::straight, 300.0, kEast)}), flatTerrain());
  convoy.runTo(5.0);
  EXPECT_EQ(convoy.vehicles().speed()[0], convoy.records()[0].type.speed_mps);
}

TEST(Vehicles, StraightOnesStopAtTheEdgeAndAtTheShore) {
  const Terrain slope = test::terrain(test::function("slope", {{"from", 3000}, {"to", 4000}, {"low", 30}, {"high", -10}}), 10000.0, 10000.0);
  Convoy convoy(scenarioOf({vehicle("shore", {2500, 5000}, Behaviour::straight, 10.0, kEast), vehicle("edge", {300, 5000}, Behaviour::straight, 10.0, -kEast)}), slope);
  convoy.runTo(400.0, [&](double) {
    for (std::size_t v = 0; v < 2; ++v) EXPECT_TRUE(slope.inside(convoy.vehicles().x()[v], convoy.vehicles().z()[v]) && !slope.sea(convoy.vehicles().x()[v], convoy.vehicles().z()[v]));
  });
  // The shore is where the slope meets 0.
  EXPECT_NEAR(convoy.vehicles().x()[0], 3750.0, 45.0);
  EXPECT_NEAR(convoy.vehicles().x()[1], 0.0, 45.0);
  EXPECT_EQ(convoy.vehicles().speed()[0], 0.0);
  EXPECT_EQ(convoy.vehicles().speed()[1], 0.0);
}

TEST(Vehicles, MeanderingOnesNeverLeaveTheLandNorClimbCliffs) {
  const Terrain ground = coast();
  Convoy convoy(meanderers(150, 3, 8000.0), ground);
  std::vector<double> way(150, 0.0), last_x = convoy.vehicles().x(), last_z = convoy.vehicles().z();
  convoy.runTo(1800.0, [&](double t) {
    for (std::size_t v = 0; v < 150; ++v) {
      const double x = convoy.vehicles().x()[v], z = convoy.vehicles().z()[v];
      ASSERT_TRUE(ground.inside(x, z)) << v << " left the world at " << t;
      ASSERT_FALSE(ground.sea(x, z)) << v << " is in the sea at " << t << " s, (" << x << ", " << z << ")";
      ASSERT_GT(ground.normal(x, z).y, 0.8) << v << " climbs a cliff at " << t;
      way[v] += std::hypot(x - last_x[v], z - last_z[v]);
    }
    last_x = convoy.vehicles().x();
    last_z = convoy.vehicles().z();
  });
  for (std::size_t v = 0; v < 150; ++v) {
    EXPECT_GT(way[v], 800.0) << v << " got stuck";
    EXPECT_LT(convoy.records()[v].track.legs.size(), 600u) << v;
  }
}

TEST(Vehicles, MeanderingOnesTurnBackFromTheirStraightLine) {
  Convoy convoy(scenarioOf({vehicle("m", {5000, 5000}, Behaviour::meander, 10.0)}), flatTerrain());
  double least = 10.0, most = -10.0;
  convoy.runTo(1200.0, [&](double t) {
    const double heading = convoy.records()[0].track.at(t).heading_rad;
    least = std::min(least, std::cos(heading));
    most = std::max(most, std::cos(heading));
  });
  EXPECT_LT(least, 0.3);
  EXPECT_GT(most, 0.7);
}

TEST(Vehicles, LegsJoinAndKeepToTheTypesLimits) {
  Convoy convoy(meanderers(60, 4, 8000.0), coast());
  convoy.runTo(900.0, [&](double t) {
    for (std::size_t v = 0; v < 60; ++v) {
      const Pose pose = convoy.records()[v].track.at(t);
      EXPECT_EQ(pose.x_m, convoy.vehicles().x()[v]);
      EXPECT_EQ(pose.z_m, convoy.vehicles().z()[v]);
      EXPECT_EQ(pose.speed_mps, convoy.vehicles().speed()[v]);
    }
  });
  for (const VehicleRecord& record : convoy.records())
    for (std::size_t i = 0; i < record.track.legs.size(); ++i) {
      const Leg& leg = record.track.legs[i];
      EXPECT_LE(std::fabs(leg.turn_radps), record.type.turn_radps + 1e-9);
      EXPECT_GE(leg.speed_mps, 0.0);
      EXPECT_LE(leg.speed_mps, record.type.speed_mps + 1e-9);
      if (i == 0) continue;
      const Pose before = poseOn(record.track.legs[i - 1], leg.start_s);
      EXPECT_NEAR(before.x_m, leg.x_m, 1e-6);
      EXPECT_NEAR(before.z_m, leg.z_m, 1e-6);
      EXPECT_NEAR(std::cos(before.heading_rad - leg.heading_rad), 1.0, 1e-9);
      EXPECT_NEAR(before.speed_mps, leg.speed_mps, 0.2);
    }
}

TEST(Vehicles, LegsAreCountedForTheMissionsLimit) {
  Convoy convoy(meanderers(30, 4, 8000.0), flatTerrain(8000.0));
  convoy.runTo(600.0);
  std::size_t legs = 0;
  for (const VehicleRecord& record : convoy.records()) legs += record.track.legs.size();
  // Besides the first leg of each; one that replaces another at the same moment counts all the same.
  EXPECT_GE(convoy.vehicles().legs() + 30, legs);
  EXPECT_LE(convoy.vehicles().legs(), legs + 30);
}

TEST(Vehicles, GoalsAreReachedInTurnAndTheLastIsWhereItStops) {
  VehicleSetup driver = vehicle("g", {1000, 1000}, Behaviour::goals, 12.0);
  driver.goals = {{3000, 1000}, {3000, 3000}, {1000, 3000}};
  Convoy convoy(scenarioOf({driver}), flatTerrain());
  std::size_t next = 0;
  convoy.runTo(900.0, [&](double) {
    if (next < 3 && convoy.distanceTo(0, driver.goals[next]) < 20.0) ++next;
  });
  EXPECT_EQ(next, 3u);
  EXPECT_LT(convoy.distanceTo(0, driver.goals[2]), 4.0);
  EXPECT_EQ(convoy.vehicles().speed()[0], 0.0);
  EXPECT_LT(convoy.records()[0].track.legs.size(), 30u);
}

TEST(Vehicles, RepeatedGoalsAreARound) {
  VehicleSetup driver = vehicle("g", {1000, 1000}, Behaviour::goals, 12.0);
  driver.goals = {{1600, 1000}, {1600, 1600}, {1000, 1600}};
  driver.repeat_goals = true;
  Convoy convoy(scenarioOf({driver}), flatTerrain());
  int passed = 0;
  std::size_t next = 0;
  convoy.runTo(1200.0, [&](double) {
    if (convoy.distanceTo(0, driver.goals[next]) > 25.0) return;
    next = (next + 1) % 3;
    ++passed;
  });
  EXPECT_GE(passed, 12);
  EXPECT_GT(convoy.vehicles().speed()[0], 0.0);
}

TEST(Vehicles, AGoalBehindALakeIsReachedAroundIt) {
  // A round lake 2.6 km across between start and goal.
  const Terrain lake = test::terrain(test::function("cone", {{"top_x", 5000}, {"top_z", 5000}, {"top_height", -40}, {"radius", 2000}, {"base_height", 20}}), 10000.0, 10000.0);
  VehicleSetup driver = vehicle("g", {1000, 5000}, Behaviour::goals, 14.0, kEast);
  driver.goals = {{9000, 5000}};
  Convoy convoy(scenarioOf({driver}), lake);
  convoy.runTo(1500.0, [&](double t) { ASSERT_FALSE(lake.sea(convoy.vehicles().x()[0], convoy.vehicles().z()[0])) << t; });
  EXPECT_LT(convoy.distanceTo(0, driver.goals[0]), 35.0);
}

TEST(Vehicles, AGoalWithoutAWayIsGivenUpForTheNext) {
  // A river from edge to edge.
  const Terrain river = test::terrain(test::function("ridge", {{"crest_x", 5000}, {"crest_height", -20}, {"foot_before", 300}, {"foot_after", 300}, {"base_height", 20}}), 10000.0, 10000.0);
  VehicleSetup driver = vehicle("g", {3000, 5000}, Behaviour::goals, 14.0);
  driver.goals = {{8000, 5000}, {3000, 8000}};
  Convoy convoy(scenarioOf({driver}), river);
  convoy.runTo(900.0, [&](double t) { ASSERT_FALSE(river.sea(convoy.vehicles().x()[0], convoy.vehicles().z()[0])) << t; });
  EXPECT_LT(convoy.distanceTo(0, driver.goals[1]), 10.0);
}

std::vector<VehicleSetup> column(int count) {
  std::vector<VehicleSetup> out;
  for (int i = 0; i < count; ++i) {
    out.push_back(vehicle("c" + std::to_string(i), {2000.0 - 40.0 * i, 2000}, i == 0 ? Behaviour::goals : Behaviour::follow, 10.0, kEast));
    if (i > 0) {
      out.back().follows = "c" + std::to_string(i - 1);
      out.back().gap_m = 40.0;
    }
  }
  out[0].goals = {{5000, 2000}, {5000, 6000}};
  return out;
}

/// Distance of a pose from where a vehicle has been in the last minute.
double offTrail(const Track& trail, const Pose& pose, double now_s) {
  double least = INFINITY;
  for (double t = std::max(0.0, now_s - 60.0); t <= now_s; t += 0.1) least = std::min(least, std::hypot(trail.at(t).x_m - pose.x_m, trail.at(t).z_m - pose.z_m));
  return least;
}

TEST(Vehicles, AColumnKeepsItsGapsAndTurnsWhereItsHeadTurned) {
  Convoy convoy(scenarioOf(column(5)), flatTerrain());
  convoy.runTo(1500.0, [&](double t) {
    if (t < 60.0 || t > 650.0) return;
    for (std::size_t v = 1; v < 5; ++v) {
      const Pose pose = convoy.pose(v), ahead = convoy.pose(v - 1);
      EXPECT_NEAR(std::hypot(pose.x_m - ahead.x_m, pose.z_m - ahead.z_m), 40.0, 20.0) << v << " at " << t;
      EXPECT_LT(offTrail(convoy.records()[0].track, pose, t), 6.0) << v << " at " << t;
    }
  });
  for (std::size_t v = 1; v < 5; ++v) {
    EXPECT_EQ(convoy.vehicles().speed()[v], 0.0);
    EXPECT_NEAR(std::hypot(convoy.pose(v).x_m - convoy.pose(v - 1).x_m, convoy.pose(v).z_m - convoy.pose(v - 1).z_m), 40.0, 20.0);
  }
}

TEST(Vehicles, WhenItsHeadIsStoppedTheNextLeadsTheColumnOn) {
  Convoy convoy(scenarioOf(column(4)), flatTerrain());
  convoy.runTo(120.0);
  convoy.vehicles().immobilise(0, convoy.nextTick() - 1);
  const Pose wreck = convoy.pose(0);
  convoy.runTo(1500.0);
  EXPECT_LT(std::hypot(convoy.pose(0).x_m - wreck.x_m, convoy.pose(0).z_m - wreck.z_m), 20.0);
  EXPECT_LT(convoy.distanceTo(1, {5000, 6000}), 5.0);
  EXPECT_LT(convoy.distanceTo(3, {5000, 6000}), 150.0);
}

TEST(Vehicles, OneThatRetiresDrivesAwayFromTheFireAtHighSpeed) {
  VehicleSetup setup = vehicle("r", {5000, 5000}, Behaviour::stationary);
  setup.reaction = Reaction::retire;
  Convoy convoy(scenarioOf({setup}), flatTerrain());
  convoy.runTo(10.0);
  EXPECT_FALSE(convoy.vehicles().noticesFire(0, convoy.nextTick() - 1, {5000, 5080}));
  double fastest = 0.0;
  convoy.runTo(200.0, [&](double) { fastest = std::max(fastest, convoy.vehicles().speed()[0]); });
  EXPECT_NEAR(fastest, convoy.records()[0].type.speed_mps, 1e-6);
  // The burst was south of it.
  EXPECT_LT(convoy.pose(0).z_m, 4700.0);
  EXPECT_EQ(convoy.vehicles().speed()[0], 0.0);
}

TEST(Vehicles, ReactionsToFireAreThoseAskedFor) {
  std::vector<VehicleSetup> setups;
  for (const Reaction reaction : {Reaction::none, Reaction::return_fire, Reaction::retire, Reaction::both}) {
    setups.push_back(vehicle("v" + std::to_string(setups.size()), {5000, 5000}, Behaviour::stationary));
    setups.back().reaction = reaction;
  }
  Convoy convoy(scenarioOf(setups), flatTerrain());
  convoy.runTo(1.0);
  const bool shoots[] = {false, true, false, true}, leaves[] = {false, false, true, true};
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(convoy.vehicles().noticesFire(v, convoy.nextTick() - 1, {5050, 5000}), shoots[v]) << v;
  convoy.runTo(60.0);
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(convoy.distanceTo(v, {5000, 5000}) > 100.0, leaves[v]) << v;
}

TEST(Vehicles, ARetreatEndsAndTheOldWayIsTakenUpAgain) {
  VehicleSetup driver = vehicle("g", {2000, 5000}, Behaviour::goals, 12.0, kEast);
  driver.goals = {{6000, 5000}};
  driver.reaction = Reaction::retire;
  Convoy convoy(scenarioOf({driver}), flatTerrain());
  convoy.runTo(100.0);
  convoy.vehicles().noticesFire(0, convoy.nextTick() - 1, {3400, 5000});
  convoy.runTo(150.0);
  EXPECT_LT(convoy.pose(0).x_m, 3150.0);
  convoy.runTo(900.0);
  EXPECT_LT(convoy.distanceTo(0, {6000, 5000}), 5.0);
}

TEST(Vehicles, WhatLostItsMobilityStaysWhereItIs) {
  Convoy convoy(scenarioOf({vehicle("m", {5000, 5000}, Behaviour::meander, 12.0)}), flatTerrain());
  convoy.runTo(30.0);
  convoy.vehicles().immobilise(0, convoy.nextTick() - 1);
  convoy.runTo(34.0);
  const Pose still = convoy.pose(0);
  EXPECT_EQ(convoy.vehicles().speed()[0], 0.0);
  convoy.vehicles().withdraw(0, convoy.nextTick() - 1, {5000, 5000});
  convoy.vehicles().drive(0, convoy.nextTick() - 1, 10.0, 0.1);
  convoy.vehicles().hand(0, convoy.nextTick() - 1, true);
  convoy.runTo(200.0);
  EXPECT_EQ(convoy.pose(0).x_m, still.x_m);
  EXPECT_EQ(convoy.pose(0).heading_rad, still.heading_rad);
}

TEST(Vehicles, APersonsVehicleObeysAndStandsWithoutCommands) {
  Convoy convoy(scenarioOf({vehicle("u", {5000, 5000}, Behaviour::user, 12.0, 0.0)}), flatTerrain());
  convoy.runTo(20.0);
  EXPECT_EQ(convoy.vehicles().speed()[0], 0.0);
  convoy.vehicles().drive(0, convoy.nextTick(), 8.0, 0.0);
  convoy.runTo(40.0);
  EXPECT_NEAR(convoy.vehicles().speed()[0], 8.0, 1e-9);
  EXPECT_LT(convoy.pose(0).z_m, 4900.0);
  convoy.vehicles().drive(0, convoy.nextTick(), 8.0, 0.1);
  convoy.runTo(50.0);
  EXPECT_NEAR(convoy.pose(0).heading_rad, 1.0, 0.1);
  convoy.vehicles().drive(0, convoy.nextTick(), 0.0, 0.0);
  convoy.runTo(60.0);
  EXPECT_EQ(convoy.vehicles().speed()[0], 0.0);
  // Beyond its type's limits, and no number at all: clamped.
  convoy.vehicles().drive(0, convoy.nextTick(), 1e9, NAN);
  convoy.runTo(80.0);
  EXPECT_LE(convoy.vehicles().speed()[0], convoy.records()[0].type.speed_mps);
}

TEST(Vehicles, APersonCannotDriveIntoTheSeaOrOffTheWorld) {
  const Terrain slope = test::terrain(test::function("slope", {{"from", 3000}, {"to", 4000}, {"low", 30}, {"high", -10}}), 10000.0, 10000.0);
  Convoy convoy(scenarioOf({vehicle("u", {3000, 200}, Behaviour::user, 12.0, kEast), vehicle("v", {300, 200}, Behaviour::user, 12.0, 0.0)}), slope);
  for (int second = 0; second < 120; second += 5) {
    convoy.vehicles().drive(0, convoy.nextTick(), 15.0, 0.01 * (second % 3 - 1));
    convoy.vehicles().drive(1, convoy.nextTick(), 15.0, -0.02);
    convoy.runTo(second + 5.0, [&](double t) {
      for (std::size_t v = 0; v < 2; ++v) {
        ASSERT_TRUE(slope.inside(convoy.vehicles().x()[v], convoy.vehicles().z()[v])) << t;
        ASSERT_FALSE(slope.sea(convoy.vehicles().x()[v], convoy.vehicles().z()[v])) << t;
      }
    });
  }
}

TEST(Vehicles, HandingOverGoesOnAsItWasAndHandingBackResumes) {
  VehicleSetup driver = vehicle("g", {1000, 5000}, Behaviour::goals, 10.0, kEast);
  driver.goals = {{4000, 5000}};
  Convoy convoy(scenarioOf({driver}), flatTerrain());
  convoy.runTo(50.0);
  convoy.vehicles().hand(0, convoy.nextTick(), true);
  convoy.runTo(60.0);
  EXPECT_NEAR(convoy.pose(0).x_m, 1600.0, 1.0);
  convoy.vehicles().drive(0, convoy.nextTick(), 10.0, 0.2);
  convoy.runTo(80.0);
  convoy.vehicles().hand(0, convoy.nextTick(), false);
  convoy.runTo(600.0);
  EXPECT_LT(convoy.distanceTo(0, {4000, 5000}), 5.0);
}

TEST(Vehicles, GroupsStandOnLandInTheirAreaBySeed) {
  const Terrain ground = coast();
  Scenario scenario = meanderers(80, 1, 8000.0);
  scenario.groups[0].from = {6000, 5000};
  scenario.groups[0].to = {1000, 2000};
  Convoy one(scenario, ground), same(scenario, ground);
  scenario.seed = 2;
  Convoy other(scenario, ground);
  int different = 0;
  for (std::size_t v = 0; v < 80; ++v) {
    const Leg& leg = one.records()[v].track.legs[0];
    EXPECT_EQ(one.records()[v].id, "g-" + std::to_string(v + 1));
    EXPECT_TRUE(leg.x_m >= 1000 && leg.x_m <= 6000 && leg.z_m >= 2000 && leg.z_m <= 5000);
    EXPECT_FALSE(ground.sea(leg.x_m, leg.z_m));
    EXPECT_GE(leg.speed_mps, 2.0);
    EXPECT_LE(leg.speed_mps, 10.0);
    EXPECT_EQ(leg, same.records()[v].track.legs[0]);
    different += leg != other.records()[v].track.legs[0] ? 1 : 0;
  }
  EXPECT_EQ(different, 80);
}

TEST(Vehicles, AVehiclesWayDoesNotDependOnThoseAfterIt) {
  const Terrain ground = coast();
  Convoy few(meanderers(5, 9, 8000.0), ground), many(meanderers(50, 9, 8000.0), ground);
  few.runTo(600.0);
  many.runTo(600.0);
  for (std::size_t v = 0; v < 5; ++v) EXPECT_EQ(few.records()[v].track, many.records()[v].track);
}

TEST(Vehicles, ObserversWithoutAVehicleAreCarriedByOneOfTheirType) {
  Scenario scenario = scenarioOf({vehicle("t72", {4000, 4000}, Behaviour::stationary)});
  ObserverSetup observer;
  observer.id = "fo1";
  observer.at = {6000, 6500};
  observer.type = 8;
  scenario.observers = {observer};
  observer.id = "fo2";
  observer.vehicle = "t72";
  scenario.observers.push_back(observer);
  Convoy convoy(scenario, flatTerrain());
  ASSERT_EQ(convoy.records().size(), 2u);
  EXPECT_EQ(convoy.records()[1].type.index, 8);
  EXPECT_EQ(convoy.vehicles().z()[1], 6500.0);
  // He leaves when told to.
  convoy.runTo(1.0);
  convoy.vehicles().withdraw(1, convoy.nextTick() - 1, {6000, 6000});
  convoy.runTo(60.0);
  EXPECT_GT(convoy.pose(1).z_m, 6800.0);
}

TEST(Vehicles, BoatsFloatAndAircraftCrossTheShore) {
  const Terrain slope = test::terrain(test::function("slope", {{"from", 3000}, {"to", 4000}, {"low", 30}, {"high", -10}}), 10000.0, 10000.0);
  Scenario scenario = scenarioOf({vehicle("boat", {8000, 5000}, Behaviour::meander, 8.0), vehicle("plane", {500, 5000}, Behaviour::straight, 80.0, kEast)});
  VehicleType boat;
  boat.index = 200;
  boat.target_class = TargetClass::watercraft;
  VehicleType plane = boat;
  plane.index = 201;
  plane.target_class = TargetClass::aircraft;
  plane.speed_mps = 100.0;
  scenario.types = {boat, plane};
  scenario.vehicles[0].type = 200;
  scenario.vehicles[1].type = 201;
  Convoy convoy(scenario, slope);
  convoy.runTo(100.0, [&](double t) { ASSERT_TRUE(slope.sea(convoy.vehicles().x()[0], convoy.vehicles().z()[0])) << t; });
  EXPECT_GT(convoy.vehicles().x()[1], 8000.0);
}

TEST(Vehicles, PlacesWhereNothingCanStandAreRefused) {
  const Terrain slope = test::terrain(test::function("slope", {{"from", 3000}, {"to", 4000}, {"low", 30}, {"high", -10}}), 10000.0, 10000.0);
  const auto refusal = [&](const Scenario& scenario) {
    std::vector<VehicleRecord> records;
    const auto made = world::Vehicles::make(scenario, slope, records);
    EXPECT_FALSE(made);
    if (made) return std::string();
    EXPECT_EQ(made.error().kind, ErrorKind::input);
    return made.error().text();
  };
  const auto says = [&](const Scenario& scenario, const std::string& part) { EXPECT_NE(refusal(scenario).find(part), std::string::npos) << refusal(scenario); };
  says(scenarioOf({vehicle("wet", {9000, 100}, Behaviour::stationary)}), "/vehicles/0/pos: Vehicle wet stands at (9000, 100), in the sea.");
  says(scenarioOf({vehicle("dry", {100, 100}, Behaviour::stationary), vehicle("out", {-5, 100}, Behaviour::stationary)}), "Vehicle out stands at (-5, 100), outside the world.");
  Scenario group = meanderers(3, 1, 10000.0);
  group.groups[0].from = {5000, 5000};
  says(group, "Group g finds no land between (5000, 5000) and (10000, 10000).");
  Scenario unknown = scenarioOf({vehicle("a", {100, 100}, Behaviour::stationary)});
  unknown.vehicles[0].type = 4711;
  says(unknown, "There is no vehicle type 4711.");
  Scenario observer = scenarioOf({});
  observer.observers.resize(1);
  observer.observers[0].id = "fo";
  observer.observers[0].at = {7000, 7000};
  says(observer, "Observer fo stands at (7000, 7000), in the sea.");
}

}  // namespace
}  // namespace npsee
