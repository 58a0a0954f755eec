// Missions that cannot be simulated, or in which nothing can be done: a message with its place, a proper exit code, and no crash.

#include "tests/scenario/mission_run.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace npsee {
namespace {

using test::missionRun;

/// Writes a mission into a folder of its own and runs it.
class BadMission : public testing::Test {
 protected:
  /// `keys` follow the version.
  test::MissionRun run(const std::string& keys, std::vector<std::string> arguments = {}) {
    test::spill(file_, "{\"npsee_mission\": 1, \"duration\": 20" + (keys.empty() ? "" : ",\n" + keys) + "\n}");
    return missionRun(file_, std::move(arguments));
  }
  /// What the message must begin with where the fault stands on a line of the file.
  std::string at(int line, const std::string& pointer) const { return file_ + ":" + std::to_string(line) + ": " + pointer + ": "; }

  test::TemporaryFolder folder_;
  std::string file_ = folder_ / "bad.mission.json";
};

const std::string kTank = "\"vehicles\": [{\"id\": \"t72-1\", \"type\": 51, \"pos\": [27500, 25000]}]";
const std::string kObserver = "\"observers\": [{\"id\": \"fo1\", \"pos\": [25000, 25000], \"missions\": [{\"type\": 51}]}]";
const std::string kGuns = "\"guns\": [{\"id\": \"gun1\", \"pos\": [24000, 24000]}]";

std::string battery(const std::string& keys) { return "\"batteries\": [{\n" + keys + "\n}]"; }

TEST_F(BadMission, AnEmptyWorldRunsToItsEnd) {
  const auto empty = run("");
  EXPECT_EQ(empty.exit_code, 0) << empty.err;
  ASSERT_EQ(empty.events.size(), 1u);
  EXPECT_EQ(empty.events[0].at("ev"), "end");
  EXPECT_EQ(empty.events[0].at("t"), 20);
}

TEST_F(BadMission, AnUnknownWeaponIsNamedWithItsLine) {
  const auto bad = run(kTank + ",\n" + battery("\"weapon\": 77,\n" + kGuns));
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_EQ(bad.out, "");
  EXPECT_EQ(bad.err, at(4, "/batteries/0/weapon") + "battery battery has weapon 77, which the weapons file does not list.\n  `npsee weapons FILE` shows the ids there are.\n");
}

TEST_F(BadMission, UnknownProjectilesAndChargesAreNamedWithTheirLine) {
  const auto shell = run(battery("\"projectile\": \"m108\",\n" + kGuns));
  EXPECT_EQ(shell.exit_code, 3);
  EXPECT_TRUE(shell.err.starts_with(at(2, "/batteries/0"))) << shell.err;
  EXPECT_NE(shell.err.find("m108"), std::string::npos);
  const auto charge = run(battery("\"charges\": [\"9Z\"],\n" + kGuns));
  EXPECT_EQ(charge.exit_code, 3);
  EXPECT_NE(charge.err.find("9Z"), std::string::npos) << charge.err;
}

TEST_F(BadMission, AnUnknownTerrainFunctionIsNamedWithItsLine) {
  const auto bad = run("\"world\": {\n\"terrain\": {\"kind\": \"function\", \"expr\": \"rigde\"}}");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_TRUE(bad.err.starts_with(at(3, "/world/terrain"))) << bad.err;
  EXPECT_NE(bad.err.find("Did you mean ridge?"), std::string::npos) << bad.err;
}

TEST_F(BadMission, BrokenTerrainFilesAreRefused) {
  test::spill(folder_ / "hills.png", "this is no picture");
  test::spill(folder_ / "hills.hgt", "odd");
  for (const char* kind : {"png", "hgt"}) {
    const auto bad = run(std::string("\"world\": {\"terrain\": {\"kind\": \"") + kind + "\", \"file\": \"hills." + kind + "\"}}");
    EXPECT_EQ(bad.exit_code, 3) << kind;
    EXPECT_EQ(bad.out, "");
    EXPECT_NE(bad.err.find(std::string("hills.") + kind), std::string::npos) << bad.err;
  }
}

TEST_F(BadMission, ATerrainFileSaysHowLargeTheWorldIs) {
  // 1201 x 1201 samples 90 m apart, all at 100 m.
  std::string heights;
  for (int i = 0; i < 1201 * 1201; ++i) heights += std::string("\0d", 2);
  test::spill(folder_ / "flat.hgt", heights);
  const std::string world = "\"world\": {\"size\": [0, 0], \"terrain\": {\"kind\": \"hgt\", \"file\": \"flat.hgt\"}},\n";
  const auto good = run(world + kTank + ",\n" + battery(kGuns) + ",\n" + kObserver);
  EXPECT_EQ(good.exit_code, 0) << good.err;
  ASSERT_EQ(good.of("fire").size(), 1u) << good.out;
  EXPECT_NEAR(good.of("call")[0].at("position")[0].get<double>(), 27500.0, 1.0);
  const auto outside = run(world + "\"vehicles\": [\n{\"id\": \"t72-1\", \"type\": 51, \"pos\": [200000, 1]}]");
  EXPECT_EQ(outside.exit_code, 3);
  EXPECT_TRUE(outside.err.starts_with(at(4, "/vehicles/0/pos"))) << outside.err;
}

TEST_F(BadMission, NothingStandsInTheSea) {
  const auto bad = run("\"world\": {\"sea_level\": 10},\n" + kTank);
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_TRUE(bad.err.starts_with(at(3, "/vehicles/0/pos"))) << bad.err;
}

TEST_F(BadMission, AGunInTheSeaRefusesWithTheReason) {
  const auto wet = run("\"world\": {\"sea_level\": 1, \"terrain\": {\"kind\": \"function\", \"expr\": \"slope\", \"params\": {\"from\": 24200, \"to\": 24800, \"low\": 0, \"high\": 10}}},\n" + kTank + ",\n" + battery(kGuns) + ",\n" + kObserver);
  EXPECT_EQ(wet.exit_code, 0) << wet.err;
  ASSERT_FALSE(wet.of("refuse").empty()) << wet.out;
  EXPECT_EQ(wet.of("refuse")[0].at("reason"), "in_sea");
  EXPECT_TRUE(wet.of("fire").empty());
}

TEST_F(BadMission, WithoutASolutionTheMissionEndsWithTheReason) {
  const auto far = run(kTank + ",\n" + battery("\"guns\": [{\"id\": \"gun1\", \"pos\": [1000, 1000]}]") + ",\n" + kObserver);
  EXPECT_EQ(far.exit_code, 0) << far.err;
  ASSERT_FALSE(far.of("refuse").empty()) << far.out;
  EXPECT_EQ(far.of("refuse")[0].at("reason"), "out_of_range");
  ASSERT_FALSE(far.of("end_of_mission").empty());
  EXPECT_FALSE(far.of("end_of_mission")[0].contains("grade")) << "nothing was fired";
}

TEST_F(BadMission, WithoutGunsOrRoundsTheObserverIsRefused) {
  const auto none = run(kTank + ",\n" + kObserver);
  EXPECT_EQ(none.exit_code, 0) << none.err;
  EXPECT_EQ(none.of("call").size(), 1u) << none.out;
  EXPECT_EQ(none.of("end_of_mission").size(), 1u);
  const auto empty = run(kTank + ",\n" + battery("\"rounds\": 0,\n" + kGuns) + ",\n" + kObserver);
  EXPECT_EQ(empty.exit_code, 0) << empty.err;
  ASSERT_FALSE(empty.of("refuse").empty());
  EXPECT_EQ(empty.of("refuse")[0].at("reason"), "no_ammunition");
}

TEST_F(BadMission, AnObserverWithoutOrdersIsWarnedOf) {
  const auto idle = run(kTank + ",\n\"observers\": [{\"id\": \"fo1\", \"pos\": [25000, 25000]}]");
  EXPECT_EQ(idle.exit_code, 0) << idle.err;
  ASSERT_FALSE(idle.of("warning").empty()) << idle.out;
  EXPECT_EQ(idle.of("warning")[0].at("text"), "Observer fo1 has no mission orders: he watches, but calls fire on nothing.");
}

TEST_F(BadMission, BrokenWeaponsFilesAreNamedWithTheirOwnLine) {
  test::spill(folder_ / "w.dat", "/* one */\nI a 1\n");
  const auto bad = run("\"weapons\": \"w.dat\"");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_TRUE(bad.err.starts_with(folder_ / "w.dat:2: ")) << bad.err;
}

TEST_F(BadMission, SettingsThatDoNotFitAreUsageErrors) {
  EXPECT_EQ(run(kTank, {"--set", "vehicles.t72-1.type=7"}).exit_code, 2);
  const auto unknown = run(kTank, {"--set", "vehicles.t72-2.type=52"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("Did you mean vehicles.t72-1?"), std::string::npos) << unknown.err;
  EXPECT_EQ(run(kTank, {"--seed", "x"}).exit_code, 2);
  EXPECT_EQ(run(kTank, {"--until", "-1"}).exit_code, 2);
}

TEST_F(BadMission, AnUnmetClauseExitsOneWithItsLine) {
  const auto unmet = run(kTank + ",\n\"expect\": [\n{\"event\": \"destroyed\"}]", {"--expect"});
  EXPECT_EQ(unmet.exit_code, 1);
  EXPECT_TRUE(unmet.err.starts_with(at(4, "/expect/0"))) << unmet.err;
}

TEST_F(BadMission, CheckFindsWhatOnlySettingUpShows) {
  run(kTank + ",\n" + battery("\"weapon\": 77,\n" + kGuns));
  const auto checked = test::npseeRun({"check", file_});
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_TRUE(checked.out.starts_with(at(4, "/batteries/0/weapon"))) << checked.out;
}

TEST_F(BadMission, AVehicleTypeByNameIsToldItsIndex) {
  const auto known = run("\"vehicles\": [\n{\"id\": \"a\", \"type\": \"T-72\", \"pos\": [1, 1]}]");
  EXPECT_EQ(known.exit_code, 3);
  EXPECT_EQ(known.err, at(3, "/vehicles/0/type") + "type is \"T-72\", but must be a whole number.\n  T-72 is type 51.\n");
  const auto unknown = run("\"vehicles\": [\n{\"id\": \"a\", \"type\": \"tiger\", \"pos\": [1, 1]}]");
  EXPECT_NE(unknown.err.find("Types go by their index: 1 infantry squad, "), std::string::npos) << unknown.err;
}

TEST_F(BadMission, ANumberTooLargeIsToldWithItsLine) {
  const auto bad = run("\"name\": \"a\",\n\"seed\": 1e999");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_EQ(bad.err, file_ + ":3: is not JSON: number overflow parsing '1e999'.\n  Numbers must be finite and fit a double.\n");
}

TEST_F(BadMission, ABatteryOrVehicleThatIsNotThereIsToldWithARemedy) {
  const auto battery_missing = run("\"observers\": [{\"id\": \"fo1\", \"pos\": [1, 1], \"batteries\": [\"alpha\"]}]");
  EXPECT_EQ(battery_missing.err, at(2, "/observers/0/batteries/0") + "there is no battery \"alpha\".\n  The mission has no battery; add one, or leave this out.\n");
  const auto vehicle_missing = run("\"observers\": [{\"id\": \"fo1\", \"pos\": [1, 1], \"vehicle\": \"jeep\"}]");
  EXPECT_EQ(vehicle_missing.err, at(2, "/observers/0/vehicle") + "there is no vehicle \"jeep\".\n  The mission has no vehicle; add one, or leave this out.\n");
}

TEST_F(BadMission, RulesOnATemplateThatIsNotThereNameTheNearest) {
  test::spill(folder_ / "own.clp", "(defrule a\n  (contct (id ?x))\n  =>\n  (warn ?x))\n");
  const auto bad = run("\"observers\": [{\"id\": \"fo1\", \"pos\": [1, 1], \"rules\": \"own.clp\"}]");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_EQ(bad.err, folder_ / "own.clp:2: There is no template contct with a slot id.\n  Did you mean contact? docs/rules.md lists the templates; a deftemplate makes others.\n");
}

TEST_F(BadMission, ThoseThatStandInsideOneAnotherAreWarnedOf) {
  const auto doubtful = run("\"vehicles\": [{\"id\": \"a\", \"type\": 51, \"pos\": [500, 500]}, {\"id\": \"b\", \"type\": 51, \"pos\": [501, 500]}, {\"id\": \"c\", \"type\": 51, \"pos\": [510, 500]}]");
  EXPECT_EQ(doubtful.exit_code, 0) << doubtful.err;
  ASSERT_EQ(doubtful.of("warning").size(), 1u) << doubtful.out;
  EXPECT_EQ(doubtful.of("warning")[0].at("text"), "b stands inside a, at (501, 500).");
}

TEST_F(BadMission, PicturesOfWhatTheMissionDoesNotHaveAreRefused) {
  const auto drawn = [&](const std::string& view) {
    const auto bad = run(kTank, {"--quiet", "--render", view, "-o", folder_ / "seen.png"});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "seen.png"));
    return bad.err;
  };
  const std::string remedy = "\n  Choose another camera: free, orbit or plan need nothing to look at.\n";
  EXPECT_EQ(drawn("camera=observer"), "--render camera=observer: the mission has no observer to look through." + remedy);
  EXPECT_EQ(drawn("camera=gun"), "--render camera=gun: the mission has no gun to look at." + remedy);
  EXPECT_EQ(drawn("camera=follow"), "--render camera=follow: there is no shell to follow: none was fired up to 20 s." + remedy);
}

}  // namespace
}  // namespace npsee
