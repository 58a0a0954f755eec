#include "tests/observer/fire_direction_support.h"

namespace npsee::observer {
namespace {

BatterySetup crew() {
  BatterySetup b;
  b.lay_time_s = 5.0;
  b.reload_time_s = 12.0;
  b.rounds = 2;
  return b;
}

TEST(Gun, LaysThenFiresThenReloadsThenIsEmpty) {
  Gun gun({"gun1", {}}, crew(), {1.0, 2.0, 3.0}, 0.5);
  std::vector<LayStep> lays;
  EXPECT_FALSE(gun.empty());
  const double laid = gun.lay(10.0, 1.0, 0.4, lays);
  EXPECT_EQ(laid, 15.0);
  EXPECT_EQ(gun.readyAt(laid), 15.0);
  gun.fired(15.0);
  EXPECT_EQ(gun.rounds(), 1);
  EXPECT_EQ(gun.readyAt(16.0), 27.0) << "laid sooner than loaded";
  EXPECT_EQ(gun.readyAt(30.0), 30.0) << "loaded sooner than laid";
  gun.fired(27.0);
  EXPECT_TRUE(gun.empty());
  EXPECT_EQ(gun.muzzle(), (Vec3{1.0, 2.0, 3.0}));
}

TEST(Gun, ALineItAlreadyStandsOnTakesNoTime) {
  Gun gun({"gun1", {}}, crew(), {}, 0.5);
  std::vector<LayStep> lays;
  gun.lay(0.0, 1.0, 0.4, lays);
  EXPECT_EQ(gun.lay(20.0, 1.0, 0.4, lays), 20.0);
  ASSERT_EQ(lays.size(), 2u) << "how it stood first, and one movement";
  EXPECT_EQ(lays[0].azimuth_rad, 0.5);
  EXPECT_EQ(gun.lay(20.0, 1.0, 0.41, lays), 25.0);
}

TEST(Gun, TheTubeMovesEvenlyAndTheShorterWayRound) {
  Gun gun({"gun1", {}}, crew(), {}, kTwoPi - 0.1);
  GunRecord record;
  gun.lay(10.0, 0.1, 0.4, record.lays);
  EXPECT_EQ(record.lineAt(0.0), (std::pair{kTwoPi - 0.1, 0.0}));
  const auto [azimuth, elevation] = record.lineAt(12.5);
  EXPECT_NEAR(azimuth, kTwoPi, 1e-12);
  EXPECT_NEAR(elevation, 0.2, 1e-12);
  EXPECT_EQ(record.lineAt(99.0), (std::pair{0.1, 0.4}));
  // Broken off half-way: the next movement begins where the tube is.
  record.lays.push_back({12.5, 14.5, 0.0, 0.6});
  EXPECT_NEAR(record.lineAt(12.5).second, 0.2, 1e-12);
  EXPECT_NEAR(record.lineAt(13.5).second, 0.4, 1e-12);
}

}  // namespace
}  // namespace npsee::observer
