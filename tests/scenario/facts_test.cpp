// What a mission leaves to the thesis's facts file.

#include "sim/world/scenario_files.h"

#include "tests/scenario/sample.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

namespace npsee {
namespace {

Scenario resolvedOf(const Scenario& scenario) {
  const auto out = world::resolved(scenario);
  EXPECT_TRUE(out) << out.error().text();
  return out ? *out : scenario;
}

TEST(ResolvedMission, TakesObserverGunsAndOrdersFromTheFacts) {
  Scenario s;
  s.facts = "forwardobserver.clp";
  const Scenario out = resolvedOf(s);
  ASSERT_EQ(out.observers.size(), 1u);
  EXPECT_EQ(out.observers[0].id, "fo1");
  EXPECT_EQ(out.observers[0].at, (Place{25000, 25000}));
  EXPECT_EQ(out.observers[0].type, 8);
  EXPECT_EQ(out.observers[0].missions, (std::vector<MissionOrder>{{MissionAction::destroy, 51}, {MissionAction::destroy, 52}, {MissionAction::destroy, 53}}));
  ASSERT_EQ(out.batteries.size(), 1u);
  EXPECT_EQ(out.batteries[0].weapon, 110);
  ASSERT_EQ(out.batteries[0].guns.size(), 4u);
  EXPECT_EQ(out.batteries[0].guns[1].id, "gun2");
  EXPECT_EQ(out.batteries[0].guns[1].at, (Place{25505, 25506}));
  EXPECT_TRUE(validate(out).empty());
  EXPECT_EQ(resolvedOf(out), out) << "twice changes nothing";
}

TEST(ResolvedMission, KeepsWhatTheMissionSaysItself) {
  Scenario s = test::sampleScenario();
  s.facts = "forwardobserver.clp";
  EXPECT_EQ(resolvedOf(s), s);
  s.observers[0].missions.clear();
  Scenario out = resolvedOf(s);
  EXPECT_EQ(out.observers[0].missions.size(), 3u);
  out.observers[0].missions.clear();
  EXPECT_EQ(out, s);
}

TEST(ResolvedMission, TakesOrdersFromAnObserversOwnFactsFirst) {
  const test::TemporaryFolder folder;
  test::spill(folder / "mine.clp", "(mission destroy 8)\n(location gun7 100 200)\n");
  Scenario s = test::sampleScenario();
  s.folder = folder.path();
  s.facts = "forwardobserver.clp";
  s.observers[0].rules = "mine.clp";
  s.observers[0].missions.clear();
  EXPECT_EQ(resolvedOf(s).observers[0].missions, (std::vector<MissionOrder>{{MissionAction::destroy, 8}}));
  EXPECT_EQ(resolvedOf(s).batteries, s.batteries);
  s.batteries.clear();
  s.facts.clear();
  const Scenario out = resolvedOf(s);
  ASSERT_EQ(out.batteries.size(), 1u);
  EXPECT_EQ(out.batteries[0].guns, (std::vector<GunSetup>{{"gun7", {100, 200}}}));
}

TEST(ResolvedMission, BareFactsComeWithAWarning) {
  const test::TemporaryFolder folder;
  test::spill(folder / "mine.clp", "(location observer 100 200)\n");
  Scenario s;
  s.folder = folder.path();
  s.facts = "mine.clp";
  std::vector<Fault> warnings;
  ASSERT_TRUE(world::resolved(s, &warnings));
  EXPECT_FALSE(warnings.empty());
}

TEST(ResolvedMission, BrokenFactsAreAnInputErrorWithFileAndLine) {
  const test::TemporaryFolder folder;
  test::spill(folder / "mine.clp", "(mountedon 8)\n(location observer here there)\n");
  Scenario s;
  s.folder = folder.path();
  s.facts = "mine.clp";
  const auto out = world::resolved(s);
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().kind, ErrorKind::input);
  EXPECT_TRUE(out.error().text().starts_with(folder / "mine.clp:2: ")) << out.error().text();
  s.facts = "other.clp";
  EXPECT_FALSE(world::resolved(s));
}

TEST(MissionWeapons, AreTheShippedOnesWhereNoneAreNamed) {
  const auto shipped = world::missionWeapons(Scenario{});
  ASSERT_TRUE(shipped) << shipped.error().text();
  EXPECT_NE(shipped->find("110"), nullptr);
  Scenario named;
  named.weapons = "weapons.dat";
  named.folder = "/no/such/folder";
  EXPECT_EQ(*world::missionWeapons(named), *shipped);
  named.weapons = "other.dat";
  EXPECT_FALSE(world::missionWeapons(named));
}

}  // namespace
}  // namespace npsee
