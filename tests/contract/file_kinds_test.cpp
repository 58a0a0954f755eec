#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace npsee {
namespace {

std::string sourceFile(const std::string& name) { return std::string(NPSEE_SOURCE_DIR) + '/' + name; }
const std::string kPreset = "presets/classic_1993.npsee.json", kMission = "assets/missions/ridge_low.mission.json", kRecording = "tests/data/v1/thesis_default.rec", kProjectile = "assets/projectiles/m107.json";

struct Mistake {
  std::string file, said;
  std::vector<std::string> before, after;
};

TEST(FileKinds, AFileOfAnotherKindIsNamedAndSoIsWhatTakesIt) {
  const std::vector<Mistake> mistakes{
      {kMission, "is a fire mission, not an explosion preset.\n  `npsee mission FILE`", {"render"}, {"--time", "1", "-o", "never.png"}},
      {kMission, "is a fire mission, not an explosion preset.", {"particles"}, {"--time", "1"}},
      {kMission, "is a fire mission, not a recording of a mission.", {"replay"}, {"--at", "3"}},
      {kMission, "is a fire mission, not a projectile.", {"fly", "--v0", "300", "--projectile"}, {}},
      {kPreset, "is an explosion preset, not a fire mission.\n  `npsee render FILE`", {"mission"}, {}},
      {kRecording, "is a recording of a mission, not a fire mission.\n  `npsee replay FILE`", {"mission"}, {}},
      {kRecording, "is a recording of a mission, not an explosion preset.", {"render"}, {"--time", "1", "-o", "never.png"}},
      {kProjectile, "is a projectile, not an explosion preset.\n  `npsee fly --projectile FILE`", {"render"}, {"--time", "1", "-o", "never.png"}},
  };
  for (const Mistake& mistake : mistakes) {
    auto words = mistake.before;
    words.push_back(sourceFile(mistake.file));
    words.insert(words.end(), mistake.after.begin(), mistake.after.end());
    const auto done = test::npseeRun(words);
    EXPECT_EQ(done.exit_code, 3) << mistake.file;
    EXPECT_EQ(done.err.substr(0, done.err.find('\n', done.err.find('\n') + 1)).find(sourceFile(mistake.file) + ": " + mistake.said), 0u) << done.err;
  }
}

TEST(FileKinds, CheckTakesEachForWhatItIs) {
  for (const std::string& file : {kPreset, kMission, kRecording, kProjectile}) {
    const auto done = test::npseeRun({"check", sourceFile(file)});
    EXPECT_EQ(done.exit_code, 0) << file << done.err;
    EXPECT_EQ(done.out, "1 file checked, 0 with faults\n");
  }
}

TEST(FileKinds, AFaultyFileOfTheRightKindIsToldOfItsFaults) {
  const test::TemporaryFolder folder;
  test::spill(folder / "m.json", R"({"npsee_mission": 1, "npsee": 1, "bateries": []})");
  EXPECT_NE(test::npseeRun({"mission", folder / "m.json"}).err.find("batteries"), std::string::npos);
  // A word among the values makes no kind.
  test::spill(folder / "p.json", R"({"npsee": 1, "title": "npsee_mission", "layer": []})");
  EXPECT_NE(test::npseeRun({"render", folder / "p.json", "--time", "1", "-o", folder / "never.png"}).err.find("layers"), std::string::npos);
}

TEST(ShippedNames, StandForTheirFilesWhereNoFileIsCalledSo) {
  const test::TemporaryFolder folder;
  const auto particles = [](const std::string& file) { return test::npseeRun({"particles", file, "--time", "0.2"}); };
  const auto named = particles("classic_1993");
  EXPECT_EQ(named.exit_code, 0) << named.err;
  EXPECT_EQ(named.out, particles(sourceFile(kPreset)).out);
  EXPECT_EQ(test::npseeRun({"mission", "ridge_low", "--until", "3"}).out, test::npseeRun({"mission", sourceFile(kMission), "--until", "3"}).out);
  const auto drawn = test::npseeRun({"render", "classic_1993", "cascade", "--size", "32x32", "-o", folder / "new/"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "new/cascade.png"));
  for (const std::string& unknown : {std::string("no_such_burst"), std::string("./classic_1993"), std::string("classic_1993.json"), std::string("../presets/classic_1993")}) {
    const auto refused = particles(unknown);
    EXPECT_EQ(refused.exit_code, 3) << unknown;
    EXPECT_NE(refused.err.find("there is no such file"), std::string::npos) << refused.err;
  }
}

}  // namespace
}  // namespace npsee
