#include <npsee/recording.h>

#include <npsee/units.h>

#include <gtest/gtest.h>

#include <cmath>

namespace npsee {
namespace {

TEST(Pose, RunsStraightAlongTheHeadingClockwiseFromNorth) {
  const Leg east{10.0, 100.0, 200.0, 0.5 * kPi, 4.0, 0.0, 0.0};
  const Pose pose = poseOn(east, 13.0);
  EXPECT_NEAR(pose.x_m, 112.0, 1e-9);
  EXPECT_NEAR(pose.z_m, 200.0, 1e-9);
  EXPECT_EQ(poseOn(east, 0.0).x_m, 100.0) << "before its start it stands there";
  EXPECT_NEAR(poseOn({0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0}, 2.0).z_m, -8.0, 1e-12) << "north is -z";
}

TEST(Pose, ADeceleratingLegStopsAndDoesNotReverse) {
  const Leg braking{0.0, 0.0, 0.0, 0.5 * kPi, 10.0, -2.0, 0.0};
  EXPECT_NEAR(poseOn(braking, 3.0).speed_mps, 4.0, 1e-12);
  EXPECT_NEAR(poseOn(braking, 5.0).x_m, 25.0, 1e-12);
  EXPECT_NEAR(poseOn(braking, 500.0).x_m, 25.0, 1e-12);
  EXPECT_EQ(poseOn(braking, 500.0).speed_mps, 0.0);
}

TEST(Pose, ATurningLegRunsAroundItsCircle) {
  // Right turn of radius 50 m from north: the centre lies to the east.
  const Leg turn{0.0, 0.0, 0.0, 0.0, 10.0, 0.0, 0.2};
  for (const double t : {0.0, 1.0, 5.0, 20.0, 1000.0}) {
    const Pose pose = poseOn(turn, t);
    EXPECT_NEAR(std::hypot(pose.x_m - 50.0, pose.z_m), 50.0, 1e-6);
    EXPECT_EQ(pose.speed_mps, 10.0);
    // The velocity that the positions show is speed along the heading.
    const Pose after = poseOn(turn, t + 1e-4);
    EXPECT_NEAR((after.x_m - pose.x_m) / 1e-4, 10.0 * std::sin(pose.heading_rad), 2e-3);
    EXPECT_NEAR((after.z_m - pose.z_m) / 1e-4, -10.0 * std::cos(pose.heading_rad), 2e-3);
  }
  EXPECT_NEAR(poseOn(turn, 0.25 * kTwoPi / 0.2).x_m, 50.0, 1e-9) << "a quarter circle";
}

TEST(Track, FindsTheLegOfAnyTimeAsASearchThroughAllWould) {
  Track track;
  std::vector<Leg> legs;
  double start = 0.0;
  for (int i = 0; i < 500; ++i) {
    Leg leg{start, static_cast<double>(i), 0.0, 0.0, 0.0, 0.0, 0.0};
    track.add(leg);
    legs.push_back(leg);
    // Some legs last a tick, some a minute, some begin on a whole step of the index.
    start += i % 7 == 0 ? 60.0 : i % 3 == 0 ? 0.05 : i % 5 == 0 ? Track{}.index_step_s : 1.3;
  }
  for (double t = -5.0; t < start + 50.0; t += 0.37) {
    std::size_t i = 0;
    while (i + 1 < legs.size() && legs[i + 1].start_s <= t) ++i;
    ASSERT_EQ(track.at(t).x_m, static_cast<double>(i)) << t;
  }
  for (const Leg& leg : legs) EXPECT_EQ(track.at(leg.start_s).x_m, leg.x_m);
}

TEST(Track, TheIndexOfLongRestsStaysShortAndFindsEveryLeg) {
  // A burst of legs, a day's rest, another burst, and so on: an entry every 4 s would be 20,000 entries a day.
  Track track;
  std::vector<double> starts;
  double start = 0.0;
  for (int day = 0; day < 5; ++day, start += 86400.0)
    for (int i = 0; i < 20; ++i, start += i % 3 == 0 ? 0.05 : 7.0) {
      track.add({start, static_cast<double>(starts.size()), 0.0, 0.0, 0.0, 0.0, 0.0});
      starts.push_back(start);
    }
  EXPECT_LT(track.index.size(), 4 * track.legs.size() + 65);
  for (std::size_t i = 0; i < starts.size(); ++i)
    for (const double t : {starts[i], 0.5 * (starts[i] + (i + 1 < starts.size() ? starts[i + 1] : start))}) EXPECT_EQ(track.at(t).x_m, static_cast<double>(i)) << t;
}

TEST(Track, ANewLegReplacesWhatWasPlannedFromItsStartOn) {
  Track track;
  for (const double start : {0.0, 10.0, 20.0, 30.0}) track.add({start, start, 0.0, 0.0, 0.0, 0.0, 0.0});
  track.add({20.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_EQ(track.legs.size(), 3u);
  EXPECT_EQ(track.at(19.9).x_m, 10.0);
  EXPECT_EQ(track.at(35.0).x_m, 5.0);
  track.add({50.0, 7.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  for (const double t : {24.0, 32.0, 49.9}) EXPECT_EQ(track.at(t).x_m, 5.0);
  EXPECT_EQ(track.at(50.0).x_m, 7.0);
  EXPECT_EQ(Track{}.at(3.0).x_m, 0.0);
}

ShellRecord straight(double fired_s, double burst_s) {
  ShellRecord shell;
  shell.fired_s = fired_s;
  shell.burst_s = burst_s;
  shell.muzzle_m = {0.0, 2.0, 0.0};
  shell.burst_m = {100.0, 2.0, 0.0};
  return shell;
}

TEST(Shell, AStraightOneMovesEvenlyAndAFlownOneAsItsPath) {
  const ShellRecord direct = straight(10.0, 12.0);
  EXPECT_EQ(direct.at(9.0).x, 0.0);
  EXPECT_EQ(direct.at(11.0).x, 50.0);
  EXPECT_EQ(direct.at(99.0).x, 100.0);
  EXPECT_EQ(direct.velocityAt(11.0).x, 50.0);

  const auto ballistics = Ballistics::make(*findProjectile("m107"));
  ASSERT_TRUE(ballistics);
  Shot shot;
  shot.speed_mps = 297.0;
  shot.elevation_rad = 0.35;
  shot.azimuth_rad = 1.0;
  shot.muzzle_m = {500.0, 20.0, 600.0};
  ShellRecord flown;
  flown.fired_s = 30.0;
  flown.path = ballistics->path(shot);
  flown.burst_s = 30.0 + flown.path.flight().time_of_flight_s;
  EXPECT_EQ(flown.at(35.0), flown.path.inWorld(5.0).position_m);
  EXPECT_EQ(flown.velocityAt(35.0), flown.path.inWorld(5.0).velocity_mps);
  EXPECT_EQ(flown.at(999.0), flown.path.inWorld(flown.path.flight().time_of_flight_s).position_m);
}

TEST(Recording, ListsShellsInTheAirAndBurstsOfLate) {
  Recording recording;
  for (int i = 0; i < 100; ++i) recording.shells.push_back(straight(i, i + 2.5));
  std::vector<int> found;
  recording.shellsInAir(50.25, found);
  EXPECT_EQ(found, (std::vector{48, 49, 50}));
  recording.shellsInAir(-1.0, found);
  EXPECT_TRUE(found.empty());
  recording.burstsSince(50.25, 3.0, found);
  EXPECT_EQ(found, (std::vector{45, 46, 47}));
}

TEST(Recording, VehiclesStandOnTheGroundOrTheSeaAndObserversAboveThem) {
  TerrainSource source;
  source.height_m = -7.0;
  Recording recording;
  recording.terrain = *Terrain::make(source, 1000.0, 1000.0, 3.0);
  VehicleRecord vehicle;
  vehicle.id = "m577-1";
  vehicle.track.add({0.0, 100.0, 100.0, 0.5 * kPi, 1.0, 0.0, 0.0});
  recording.vehicles.push_back(vehicle);
  recording.observers.push_back({"fo1", 0, 2.5, {}});
  EXPECT_NEAR(recording.vehiclePlace(0, 10.0).x, 110.0, 1e-9);
  EXPECT_EQ(recording.vehiclePlace(0, 10.0).y, 3.0);
  EXPECT_EQ(recording.observerEye(0, 10.0).y, 5.5);
  EXPECT_EQ(recording.findVehicle("m577-1"), 0);
  EXPECT_EQ(recording.findVehicle("m577"), -1);
  EXPECT_EQ(recording.findObserver("fo1"), 0);
  EXPECT_EQ(recording.findGun("fo1"), -1);
}

TEST(VehicleRecord, DamageIsLookedUpByTime) {
  VehicleRecord vehicle;
  EXPECT_EQ(vehicle.damageAt(5.0), nullptr);
  vehicle.damage = {{10.0, 0.4, false, true}, {20.0, 1.0, false, false}};
  EXPECT_EQ(vehicle.damageAt(9.9), nullptr);
  EXPECT_EQ(vehicle.damageAt(10.0)->hull, 0.4);
  EXPECT_FALSE(vehicle.destroyedAt(19.9));
  EXPECT_TRUE(vehicle.destroyedAt(20.0));
}

}  // namespace
}  // namespace npsee
