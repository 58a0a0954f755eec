#include "tests/observer/fire_direction_support.h"

namespace npsee::observer {
namespace {

using namespace test;

std::string textOf(const std::vector<Fault>& faults) {
  std::string out;
  for (const Fault& fault : faults) out += fault.text() + '\n';
  return out;
}

std::string refusalOf(const BatterySetup& b, const Weapon& w) {
  const auto made = FireDirection::make(b, w, level(), {}, {});
  EXPECT_FALSE(made);
  if (made) return {};
  EXPECT_EQ(made.error().kind, ErrorKind::input);
  return made.error().text();
}

TEST(FireCharges, TheHowitzerOfTheShippedFileFiresThe155MillimetreShellWithCharge3W) {
  const FireDirection fdc = centre(battery(), level());
  ASSERT_EQ(fdc.charges().size(), 1u);
  EXPECT_EQ(fdc.charges()[0].name, "3W");
  EXPECT_EQ(fdc.charges()[0].speed_mps, 297.0);
  EXPECT_EQ(fdc.maxRange(), 7300.0) << "as the file states, for the shell would reach a little further";
  EXPECT_EQ(textOf(fdc.warnings()), "");
  Weapon boastful = weapon(110);
  boastful.range_m = 16800;
  const FireDirection less = centre(battery(), level(), {}, {}, boastful);
  const std::string warnings = textOf(less.warnings());
  EXPECT_NE(warnings.find("states a range of 16800 m, but its shell reaches " + shortest(std::floor(less.maxRange() + 0.5)) + " m"), std::string::npos) << warnings;
}

TEST(FireCharges, AWeaponWithoutAFittedChargeKeepsItsOwnMuzzleVelocityAndWarns) {
  const FireDirection fdc = centre(battery(), level(), {}, {}, weapon(111));
  ASSERT_EQ(fdc.charges().size(), 1u);
  EXPECT_EQ(fdc.charges()[0].speed_mps, 370.0);
  EXPECT_NE(textOf(fdc.warnings()).find("370 m/s, which is no charge of the m106"), std::string::npos) << textOf(fdc.warnings());

  Weapon strange = weapon(110);
  strange.name = "BigGun";
  strange.muzzle_velocity_mps = 420.0;
  const FireDirection unknown = centre(battery(), level(), {}, {}, strange);
  EXPECT_EQ(unknown.charges()[0].speed_mps, 420.0);
  EXPECT_NE(textOf(unknown.warnings()).find("flies like the m107"), std::string::npos) << textOf(unknown.warnings());
}

TEST(FireCharges, AStatedRangeBelowWhatTheShellReachesIsALimit) {
  Weapon w = weapon(110);
  w.range_m = 5000;
  const Terrain t = level();
  const FireDirection fdc = centre(battery(), t, {}, {}, w);
  EXPECT_EQ(fdc.maxRange(), 5000.0);
  EXPECT_EQ(fdc.solve(request(t, 4990.0)).refusal, Refusal::none);
  const FireSolution far = fdc.solve(request(t, 5200.0));
  EXPECT_EQ(far.refusal, Refusal::out_of_range);
  EXPECT_NE(far.reason.find("5000 m"), std::string::npos) << far.reason;
}

TEST(FireCharges, WrongNamesAndWeaponsAreRefusedWithWhatThereIs) {
  BatterySetup b = battery();
  b.projectile = "m170";
  EXPECT_NE(refusalOf(b, weapon(110)).find("there is no projectile \"m170\""), std::string::npos) << refusalOf(b, weapon(110));
  b = battery();
  b.charges = {"3W", "9Q"};
  EXPECT_NE(refusalOf(b, weapon(110)).find("9Q"), std::string::npos);
  EXPECT_NE(refusalOf(b, weapon(110)).find("battery \"alpha\""), std::string::npos);

  Weapon laser = weapon(110);
  laser.path = PathType::linear;
  EXPECT_NE(refusalOf(battery(), laser).find("path type 2"), std::string::npos);
  Weapon slow = weapon(110);
  slow.muzzle_velocity_mps = 0.0;
  EXPECT_NE(refusalOf(battery(), slow).find("between 20 and 3000 m/s"), std::string::npos);
}

TEST(FireCharges, ADirectWeaponIsNotLobbedUnlessForced) {
  const Terrain t = ridge(200.0);
  Weapon direct = weapon(110);
  direct.path = PathType::low_angle;
  const FireDirection fdc = centre(battery(), t, {}, {}, direct);
  EXPECT_EQ(fdc.solve(request(t, 5000.0)).refusal, Refusal::masked);
  FireRequest forced = request(t, 5000.0);
  forced.trajectory = TrajectoryChoice::high;
  EXPECT_TRUE(fdc.solve(forced).high);
}

}  // namespace
}  // namespace npsee::observer
