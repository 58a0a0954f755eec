// Missions in `npsee check` and `npsee params`.

#include "sim/world/scenario_table.h"

#include "tests/support/process.h"

#include <npsee/recording.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace npsee {
namespace {

const std::string kSource = NPSEE_SOURCE_DIR;

TEST(CheckCommand, KnowsMissionsByNameAndByContent) {
  const test::TemporaryFolder folder;
  test::spill(folder / "good.mission.json", R"({"npsee_mission": 1})");
  test::spill(folder / "bad.mission.json", "{\"npsee_mission\": 1,\n\"sead\": 3}");
  const auto checked = test::npseeRun({"check", folder.path(), kSource + "/tests/scenario/data/npsnet_scenario.json"});
  EXPECT_EQ(checked.exit_code, 1) << checked.err;
  EXPECT_EQ(checked.out, folder / "bad.mission.json:2: /sead: a mission has no such key.\n  Did you mean seed?\n3 files checked, 1 with faults\n");
}

TEST(CheckCommand, FindsNoFaultInTheShippedMissions) {
  const auto checked = test::npseeRun({"check", kSource + "/assets/missions"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

TEST(MissionCommand, TheRecordingAndThePictureAreWrittenThoughNobodyTakesTheLog) {
  const test::TemporaryFolder folder;
  // /dev/full takes nothing, like a pipe whose reader is gone; the shell only redirects.
  const auto done = test::run("/bin/sh", {"-c", "exec " + test::npseePath() + " mission '" + kSource + "/assets/missions/thesis_default.mission.json' --until 30 --record run.rec --render t=10,size=64x36 -o seen.png > /dev/full"}, {}, folder.path());
  EXPECT_EQ(done.exit_code, 5) << done.err;
  EXPECT_EQ(test::npseeRun({"replay", folder / "run.rec"}).exit_code, 0);
  EXPECT_TRUE(test::slurp(folder / "seen.png").starts_with("\x89PNG"));
}

TEST(MissionCommand, WhatHasNoUseBesideOrWithoutMonteCarloIsRefused) {
  const test::TemporaryFolder folder;
  const struct {
    std::vector<std::string> arguments;
    std::string message;
  } cases[] = {
      {{"--monte-carlo", "3", "--record", folder / "run.rec"}, "--monte-carlo prints a summary of many runs and records none."},
      {{"--monte-carlo", "0"}, "--monte-carlo takes 1 to "},
      {{"--monte-carlo", "-1"}, "--monte-carlo takes 1 to "},
      {{"--jobs", "2"}, "--jobs is the number of threads of --monte-carlo"},
      {{"--format", "json"}, "--format json is that of the summary of --monte-carlo"},
  };
  for (const auto& one : cases) {
    std::vector<std::string> arguments{"mission", kSource + "/assets/missions/thesis_default.mission.json", "--until", "5"};
    arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
    const auto done = test::npseeRun(arguments);
    EXPECT_EQ(done.exit_code, 2) << one.arguments[0] << '\n' << done.err;
    EXPECT_NE(done.err.find(one.message), std::string::npos) << done.err;
    EXPECT_EQ(done.out, "");
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "run.rec"));
  EXPECT_EQ(test::npseeRun({"mission", kSource + "/assets/missions/thesis_default.mission.json", "--until", "5", "--monte-carlo", "1", "--jobs", "0", "--format", "text"}).exit_code, 0);
}

TEST(ParamsCommand, ShowsTheKeysOfMissions) {
  const auto one = test::npseeRun({"params", "--missions", "lay_time"});
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(one.out, "battery: Guns that fire together for one fire direction centre.\n  lay_time = 5 s  [0 to 3600 s]\n    Time to lay a gun on new data.\n");
  const auto all = test::npseeRun({"params", "--missions"});
  for (const world::Struct* table : world::missionTables())
    for (const world::Field& field : table->fields) EXPECT_NE(all.out.find("  " + std::string(field.key) + " = "), std::string::npos) << field.key;
}

TEST(ParamsCommand, NamesTheNearestKeyOfMissions) {
  const auto wrong = test::npseeRun({"params", "--missions", "laytime"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.err, "there is no key \"laytime\" in mission files. Did you mean lay_time?\n  `npsee params --missions` lists all keys.\n");
}

TEST(ParamsCommand, GivesTheSchemaOfMissionsWithAllReferencesResolved) {
  const auto run = test::npseeRun({"params", "--missions", "--format", "schema"});
  ASSERT_EQ(run.exit_code, 0);
  const auto schema = nlohmann::json::parse(run.out);
  EXPECT_EQ(schema.at("properties").at("npsee_mission").at("const"), 1);
  EXPECT_EQ(schema.at("$defs").at("battery").at("properties").at("lay_time").at("maximum"), 3600);
  EXPECT_EQ(schema.at("$defs").at("battery").at("required"), nlohmann::json::array({"guns"}));
  for (std::size_t at = 0; (at = run.out.find("#/$defs/", at)) != std::string::npos; ++at) {
    const std::string name = run.out.substr(at + 8, run.out.find('"', at) - at - 8);
    EXPECT_TRUE(schema.at("$defs").contains(name)) << name;
  }
}

TEST(ParamsCommand, GivesTheKeysOfMissionsAsJson) {
  const auto run = test::npseeRun({"params", "--missions", "--format", "json", "trajectory"});
  ASSERT_EQ(run.exit_code, 0);
  const auto rows = nlohmann::json::parse(run.out);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].at("choices"), nlohmann::json::array({"auto", "low", "high"}));
  EXPECT_EQ(rows[0].at("default"), "auto");
}

TEST(ParamsCommand, ShowsTheKeysOfTheEventLog) {
  const auto text = test::npseeRun({"params", "--events"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.out.find("\nsolution\n  mission (whole): "), std::string::npos);
  const auto schema = nlohmann::json::parse(test::npseeRun({"params", "--events", "--format", "schema"}).out);
  ASSERT_EQ(schema.at("oneOf").size(), static_cast<std::size_t>(kEventKinds));
  EXPECT_EQ(schema.at("oneOf")[0].at("properties").at("ev").at("const"), "contact");
  EXPECT_EQ(nlohmann::json::parse(test::npseeRun({"params", "--events", "--format", "json"}).out).size(), eventSchema().size());
  EXPECT_EQ(test::npseeRun({"params", "--events", "--missions"}).exit_code, 2);
}

// The references in the manual are what the program prints.
TEST(MissionManual, HoldsTheReferencesAsThisProgramPrintsThem) {
  const std::string manual = test::slurp(kSource + "/docs/missions.md");
  for (const char* what : {"--missions", "--events"}) {
    const auto printed = test::npseeRun({"params", what, "--format", "markdown"});
    ASSERT_EQ(printed.exit_code, 0);
    EXPECT_NE(manual.find(printed.out), std::string::npos) << "run scripts/update_manual.py build/dev/npsee";
  }
}

}  // namespace
}  // namespace npsee
