// weapons.dat as appendix B.A of the thesis has it.

#include <npsee/weapons.h>

#include "tests/support/process.h"

#include <gtest/gtest.h>

namespace npsee {
namespace {

std::string weaponFaultsOf(const std::string& text) {
  const auto weapons = parseWeapons(text, "w.dat");
  return weapons ? "" : weapons.error().text();
}

const std::string kShipped = std::string(NPSEE_SOURCE_DIR) + "/assets/weapons.dat";

TEST(Weapons, TheThesisFileIsReadWithAllSevenValues) {
  const auto weapons = loadWeapons(kShipped);
  ASSERT_TRUE(weapons) << weapons.error().text();
  ASSERT_EQ(weapons->list.size(), 3u);
  const Weapon& howitzer = weapons->list[0];
  EXPECT_EQ(howitzer.name, "155mmM109Howitzer");
  EXPECT_EQ(howitzer.id, 110);
  EXPECT_TRUE(howitzer.american());
  EXPECT_EQ(howitzer.range_m, 7300);
  EXPECT_EQ(howitzer.muzzle_velocity_mps, 297.0);
  EXPECT_EQ(howitzer.kill_radius_m, 100);
  EXPECT_EQ(howitzer.damage_radius_m, 150);
  EXPECT_EQ(howitzer.knowledge_radius_m, 200);
  EXPECT_EQ(howitzer.target, TargetType::heavy_armor);
  EXPECT_EQ(howitzer.path, PathType::high_angle);
  EXPECT_EQ(weapons->list[2].path, PathType::low_angle);
  EXPECT_EQ(weapons->list[2].target, TargetType::light_armor);
  EXPECT_EQ(weapons->find("50cal"), &weapons->list[2]);
  EXPECT_EQ(weapons->find("111"), &weapons->list[1]);
  EXPECT_EQ(weapons->find("nothing"), nullptr);
}

TEST(Weapons, RangesThatNoVacuumReachesAreDoubtedWithTheirLine) {
  const auto weapons = loadWeapons(kShipped);
  ASSERT_TRUE(weapons);
  ASSERT_EQ(weapons->warnings.size(), 2u);
  EXPECT_NE(weapons->warnings[0].text().find("weapons.dat:7: 203mmM110Howitzer states a range of 16800 m, but at 370 m/s even a vacuum gives only 13959 m."), std::string::npos) << weapons->warnings[0].text();
  EXPECT_NE(weapons->warnings[1].text().find("1019 m"), std::string::npos);
}

TEST(Weapons, WritingAndReadingIsIdentityAndKeepsComments) {
  const auto weapons = loadWeapons(kShipped);
  ASSERT_TRUE(weapons);
  const std::string text = weaponsText(*weapons);
  EXPECT_NE(text.find("I 155mmM109Howitzer 110 /* Non rocket-assisted, Charge 3WB */\nD 7300 297.0 100 150 200 1 1\n"), std::string::npos) << text;
  const auto again = parseWeapons(text, "again");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(*again, *weapons);
  EXPECT_EQ(weaponsText(*again), text);

  const test::TemporaryFolder folder;
  ASSERT_TRUE(saveWeapons(*weapons, folder / "w.dat"));
  EXPECT_EQ(test::slurp(folder / "w.dat"), text);
  EXPECT_FALSE(saveWeapons(*weapons, "/nonexistent/w.dat"));
  Weapons bad = *weapons;
  bad.list[1].id = bad.list[0].id;
  EXPECT_FALSE(saveWeapons(bad, folder / "w.dat"));
  EXPECT_EQ(test::slurp(folder / "w.dat"), text);
}

TEST(Weapons, CommentsStandAnywhereBetweenWords) {
  const auto weapons = parseWeapons("/* a */ I gun /* b\nc */ 7\nD 100 /* metres */ 50.5 1 2 3 4 0 /* tail */ /* next */\n/* end */", "w.dat");
  ASSERT_TRUE(weapons) << weapons.error().text();
  EXPECT_EQ(weapons->list[0].muzzle_velocity_mps, 50.5);
  EXPECT_FALSE(weapons->list[0].american());
  const auto again = parseWeapons(weaponsText(*weapons), "w.dat");
  ASSERT_TRUE(again) << weaponsText(*weapons);
  EXPECT_EQ(*again, *weapons);
}

TEST(Weapons, EveryFaultHasFileLineAndRemedy) {
  const std::pair<const char*, const char*> cases[] = {
      {"I gun 7\n/* open", "w.dat:2: this comment has no end.\n  Close it with */."},
      {"I gun 7 // old\nD 1 2 3 4 5 1 1", "w.dat:1: a comment begins with //.\n  Write /* ... */"},
      {"X gun 7", "w.dat:1: \"X\" begins no record.\n  Records begin with I"},
      {"\n\nD 1 2 3 4 5 1 1", "w.dat:3: this D record has no I record before it."},
      {"I", "w.dat:1: the I record has no name."},
      {"I gun", "w.dat:1: the weapon gun has no id."},
      {"I gun 7", "w.dat:1: the weapon gun has no D record.\n  After I NAME ID goes: D range"},
      {"I gun 7\nI other 8\nD 1 2 3 4 5 1 1", "w.dat:2: the weapon gun has no D record."},
      {"I averyveryverylongname12 7\nD 1 2 3 4 5 1 1", "w.dat:1: the name \"averyveryverylongname12\" has 23 characters, above the limit of 20."},
      {"I my gun 7\nD 1 2 3 4 5 1 1", "w.dat:1: the id of my is \"gun\", but must be a whole number from 2.\n  USSR weapons have numbers from 2"},
      {"I gun 1\nD 1 2 3 4 5 1 1", "the id of gun is \"1\""},
      {"I gun 7.5\nD 1 2 3 4 5 1 1", "the id of gun is \"7.5\""},
      {"I gun 7\nD 1 2 3 4 5 1 1\nI two 7\nD 1 2 3 4 5 1 1", "w.dat:3: the id 7 is taken by gun on line 1."},
      {"I gun 7\nD 1 2 3", "w.dat:2: the D record of gun ends after 3 of 7 values; damagesize is next."},
      {"I gun 7\nD 1 2 3 4 5 1 1 9", "w.dat:2: the D record of gun has more than 7 values: \"9\"."},
      {"I gun 7\nD 1.5 2 3 4 5 1 1", "w.dat:2: range of gun is \"1.5\", but must be a whole number from 0"},
      {"I gun 7\nD 1 0 3 4 5 1 1", "muzzle_velocity of gun is \"0\", but must be a number from 0 to 10000 and not 0."},
      {"I gun 7\nD 1 nan 3 4 5 1 1", "muzzle_velocity of gun is \"nan\""},
      {"I gun 7\nD 1 2 -3 4 5 1 1", "killsize of gun is \"-3\""},
      {"I gun 7\nD 1 2 3 4 5 7 1", "targettype of gun is \"7\", but must be a whole number from 0 to 6.\n  targettype: 0 any, 1 heavy armor"},
      {"I gun 7\nD 1 2 3 4 5 1 4", "pathtype of gun is \"4\", but must be a whole number from 0 to 3.\n  pathtype: 0 low angle"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string faults = weaponFaultsOf(text);
    EXPECT_NE(faults.find(expected), std::string::npos) << text << "\n-> " << faults;
  }
}

TEST(Weapons, MoreThanAFileMayHoldAreRefusedAndNotDropped) {
  std::string text;
  for (int id = 2; id < 10002; ++id) text += "I w" + std::to_string(id) + ' ' + std::to_string(id) + "\nD 1000 300.0 1 2 3 0 0\n";
  const auto most = parseWeapons(text, "w.dat");
  ASSERT_TRUE(most) << most.error().text();
  EXPECT_EQ(most->list.size(), 10000u);
  const auto more = parseWeapons(text + "I one 1000000\nD 1000 300.0 1 2 3 0 0\n", "w.dat");
  ASSERT_FALSE(more);
  EXPECT_TRUE(more.error().text().starts_with("w.dat:20001: here begins more than the 10000 weapons that a file may have.")) << more.error().text();
}

TEST(Weapons, FaultsOfSeveralRecordsAreReportedTogetherAndInOrder) {
  const std::string faults = weaponFaultsOf("I gun x\nD 1 2 3 4 5 1 1\nI two 8\nD 1 2 3 4 5 9 9\nI three 9\nD 1 2 3 4 5 1 1");
  EXPECT_LT(faults.find("w.dat:1:"), faults.find("w.dat:4: targettype"));
  EXPECT_NE(faults.find("w.dat:4: pathtype"), std::string::npos);
  EXPECT_EQ(faults.find("three"), std::string::npos);
}

}  // namespace
}  // namespace npsee
