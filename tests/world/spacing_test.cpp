// Vehicles keep clear of one another: where they start, where they stand, and where they drive.

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

/// Radius of the circle around a vehicle.
double radius(const VehicleRecord& record) { return 0.5 * std::hypot(record.type.length_m, record.type.width_m); }

/// Distance between the circles around two vehicles at their last step; negative where they overlap.
double between(Convoy& convoy, std::size_t a, std::size_t b) {
  const auto &x = convoy.vehicles().x(), &z = convoy.vehicles().z();
  return std::hypot(x[a] - x[b], z[a] - z[b]) - radius(convoy.records()[a]) - radius(convoy.records()[b]);
}

double least(Convoy& convoy) {
  double out = INFINITY;
  for (std::size_t a = 0; a < convoy.records().size(); ++a)
    for (std::size_t b = 0; b < a; ++b) out = std::min(out, between(convoy, a, b));
  return out;
}

Scenario crowd(int count, double size_m, Behaviour behaviour = Behaviour::meander) {
  Scenario scenario = scenarioOf({}, size_m);
  VehicleGroup group;
  group.id = "g";
  group.type = 51;
  group.count = count;
  group.to = {size_m, size_m};
  group.behaviour = behaviour;
  scenario.groups.push_back(group);
  return scenario;
}

TEST(Spacing, GroupsDoNotStartInsideOneAnother) {
  Convoy convoy(crowd(200, 600.0), flatTerrain(600.0));
  EXPECT_GE(least(convoy), 2.0);
}

TEST(Spacing, WhereThereIsNoRoomForAllTheyStartAllTheSame) {
  Convoy convoy(crowd(100, 40.0, Behaviour::stationary), flatTerrain(40.0));
  EXPECT_EQ(convoy.records().size(), 100u);
}

TEST(Spacing, MeanderingOnesDoNotDriveThroughOneAnother) {
  // Forty tanks on a square kilometre meet all the time.
  Convoy convoy(crowd(40, 1000.0), flatTerrain(1000.0));
  double nearest = INFINITY, way = 0.0;
  auto last_x = convoy.vehicles().x();
  convoy.runTo(1800.0, [&](double) {
    nearest = std::min(nearest, least(convoy));
    for (std::size_t v = 0; v < 40; ++v) way += std::fabs(convoy.vehicles().x()[v] - last_x[v]);
    last_x = convoy.vehicles().x();
  });
  EXPECT_GT(nearest, 0.0);
  // Nor do they stand about for it: 1 m/s along x, on average.
  EXPECT_GT(way, 40 * 1800 * 1.0);
}

TEST(Spacing, AParkedVehicleIsDrivenAround) {
  VehicleSetup driver = vehicle("g", {1000, 1000}, Behaviour::goals, 12.0, kEast);
  driver.goals = {{3000, 1000}};
  // Some before it in the mission, some after it; the last one close by the way.
  Convoy convoy(scenarioOf({vehicle("a", {1500, 1000}, Behaviour::stationary), driver, vehicle("b", {2000, 1002}, Behaviour::stationary), vehicle("c", {2500, 994}, Behaviour::user)}), flatTerrain());
  double nearest = INFINITY;
  convoy.runTo(400.0, [&](double) {
    for (const std::size_t v : {0u, 2u, 3u}) nearest = std::min(nearest, between(convoy, 1, v));
  });
  EXPECT_LT(convoy.distanceTo(1, {3000, 1000}), 4.0);
  EXPECT_GT(nearest, 1.0);
}

TEST(Spacing, AGoalThatIsTakenIsGivenUpForTheNext) {
  VehicleSetup driver = vehicle("g", {1000, 1000}, Behaviour::goals, 12.0, kEast);
  driver.goals = {{2000, 1000}, {2000, 2000}};
  Convoy convoy(scenarioOf({driver, vehicle("a", {2000, 1000}, Behaviour::stationary)}), flatTerrain());
  convoy.runTo(600.0, [&](double t) { ASSERT_GT(between(convoy, 0, 1), 0.0) << t; });
  EXPECT_LT(convoy.distanceTo(0, {2000, 2000}), 4.0);
}

TEST(Spacing, TwoThatMeetHeadOnPassAndBothArrive) {
  VehicleSetup east = vehicle("e", {1000, 1000}, Behaviour::goals, 12.0, kEast), west = vehicle("w", {3000, 1000}, Behaviour::goals, 12.0, -kEast);
  east.goals = {{3000, 1000}};
  west.goals = {{1000, 1000}};
  Convoy convoy(scenarioOf({east, west}), flatTerrain());
  double nearest = INFINITY;
  convoy.runTo(400.0, [&](double) { nearest = std::min(nearest, between(convoy, 0, 1)); });
  EXPECT_GT(nearest, 0.0);
  EXPECT_LT(convoy.distanceTo(0, east.goals[0]), 4.0);
  EXPECT_LT(convoy.distanceTo(1, west.goals[0]), 4.0);
}

TEST(Spacing, WayIsGivenToThoseThatKeepStraightOn) {
  // The two would meet at (2000, 1000) after 100 s.
  VehicleSetup driver = vehicle("g", {1000, 1000}, Behaviour::goals, 10.0, kEast);
  driver.goals = {{3000, 1000}};
  Convoy convoy(scenarioOf({vehicle("s", {2000, 2000}, Behaviour::straight, 10.0, 0.0), driver}), flatTerrain());
  double nearest = INFINITY;
  convoy.runTo(400.0, [&](double) { nearest = std::min(nearest, between(convoy, 0, 1)); });
  EXPECT_GT(nearest, 0.0);
  EXPECT_NEAR(convoy.records()[0].track.at(150.0).z_m, 500.0, 1e-6);
  EXPECT_LT(convoy.distanceTo(1, {3000, 1000}), 4.0);
}

TEST(Spacing, AWreckOnTheWayIsDrivenAround) {
  VehicleSetup first = vehicle("a", {2000, 1000}, Behaviour::goals, 10.0, kEast), second = vehicle("b", {1900, 1000}, Behaviour::goals, 10.0, kEast);
  first.goals = second.goals = {{4000, 1000}};
  Convoy convoy(scenarioOf({first, second}), flatTerrain());
  convoy.runTo(30.0);
  convoy.vehicles().immobilise(0, convoy.nextTick() - 1);
  convoy.runTo(400.0, [&](double t) { ASSERT_GT(between(convoy, 0, 1), 0.0) << t; });
  EXPECT_LT(convoy.distanceTo(1, {4000, 1000}), 4.0);
}

TEST(Spacing, AColumnWithTooSmallAGapKeepsItsVehiclesApart) {
  std::vector<VehicleSetup> column{vehicle("a", {2000, 2000}, Behaviour::goals, 10.0, kEast)};
  column[0].goals = {{4000, 2000}, {4000, 3000}};
  for (int i = 1; i < 4; ++i) {
    column.push_back(vehicle("f" + std::to_string(i), {2000.0 - 20.0 * i, 2000}, Behaviour::follow, 10.0, kEast));
    column.back().follows = column[static_cast<std::size_t>(i - 1)].id;
    column.back().gap_m = 1.0;
  }
  Convoy convoy(scenarioOf(column), flatTerrain());
  convoy.runTo(500.0, [&](double t) { ASSERT_GT(least(convoy), 0.0) << t; });
  EXPECT_LT(convoy.distanceTo(0, {4000, 3000}), 4.0);
  EXPECT_GT(least(convoy), 0.0);
}

TEST(Spacing, ThoseThatStartAtOnePlaceGetAwayFromOneAnother) {
  VehicleSetup a = vehicle("a", {1000, 1000}, Behaviour::goals, 10.0, kEast), b = vehicle("b", {1001, 1000}, Behaviour::goals, 10.0, kEast);
  a.goals = {{3000, 1000}};
  b.goals = {{3000, 1500}};
  Convoy convoy(scenarioOf({a, b}), flatTerrain());
  convoy.runTo(400.0);
  EXPECT_LT(convoy.distanceTo(0, {3000, 1000}), 4.0);
  EXPECT_LT(convoy.distanceTo(1, {3000, 1500}), 4.0);
}

TEST(Spacing, AircraftAndGroundVehiclesDoNotMeet) {
  Scenario scenario = scenarioOf({vehicle("plane", {1000, 1000}, Behaviour::goals, 40.0, kEast), vehicle("tank", {2000, 1000}, Behaviour::stationary)});
  VehicleType plane;
  plane.index = 201;
  plane.target_class = TargetClass::aircraft;
  plane.speed_mps = 60.0;
  scenario.types = {plane};
  scenario.vehicles[0].type = 201;
  scenario.vehicles[0].goals = {{3000, 1000}};
  Convoy convoy(scenario, flatTerrain());
  convoy.runTo(45.0);
  for (const Leg& leg : convoy.records()[0].track.legs) EXPECT_NEAR(leg.z_m, 1000.0, 1e-6);
}

}  // namespace
}  // namespace npsee
