// Real missions: their logs keep to the schema, and their recordings read back to the same bits.

#include "tests/support/process.h"
#include "tests/support/source_directory.h"

#include <npsee/exports.h>
#include <npsee/mission.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace npsee {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> missionsIn(const std::string& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(std::string(NPSEE_SOURCE_DIR) + '/' + folder))
    if (entry.path().string().ends_with(".mission.json")) out.push_back(entry.path());
  std::ranges::sort(out);
  return out;
}

/// Long enough for a fire mission from call to effect, short enough for a quick test.
constexpr double kUntil_s = 240.0;

std::string_view typeOf(const MissionEvent::Value& value) {
  constexpr std::string_view names[] = {"bool", "whole", "number", "text", "place", "texts"};
  return names[value.index()];
}

std::string schemaFault(const MissionEvent& event) {
  const std::string_view kind = eventKindNames()[static_cast<std::size_t>(event.kind)];
  for (const auto& [key, value] : event.fields) {
    const auto row = std::ranges::find_if(eventSchema(), [&](const EventKey& r) { return r.event == kind && r.key == key; });
    if (row == eventSchema().end()) return "unknown key " + key;
    if (typeOf(value) != (row->type == "id" ? "text" : row->type)) return key + " is " + std::string(typeOf(value)) + ", not " + std::string(row->type);
    if (const auto* text = std::get_if<std::string>(&value); text && text->empty() && !row->optional()) return key + " is empty";
    if (std::ranges::count(event.fields, key, &std::pair<std::string, MissionEvent::Value>::first) != 1) return key + " is given twice";
  }
  for (const EventKey& row : eventSchema())
    if (row.event == kind && !row.optional() && !event.find(row.key)) return "no " + std::string(row.key);
  return {};
}

class MissionRecording : public testing::TestWithParam<fs::path> {};

/// The one mission whose rules do not parse, so that nothing is simulated.
bool meantToFail(const fs::path& mission) { return mission.filename() == "i_broken_rules.mission.json"; }

TEST_P(MissionRecording, ItsLogKeepsToTheSchemaAndItReadsBackToTheSameBits) {
  const auto scenario = loadScenario(GetParam());
  ASSERT_TRUE(scenario) << scenario.error().text();
  const auto before = runMission(*scenario, std::min(scenario->duration_s, kUntil_s));
  if (meantToFail(GetParam())) {
    ASSERT_FALSE(before);
    EXPECT_NE(before.error().text().find("broken.clp:2: The rule fire-at-will has no =>."), std::string::npos) << before.error().text();
    return;
  }
  ASSERT_TRUE(before) << before.error().text();
  for (const MissionEvent& event : before->events) ASSERT_EQ(schemaFault(event), "") << eventJson(event);
  EXPECT_TRUE(std::ranges::is_sorted(before->shells, {}, &ShellRecord::fired_s));

  const test::TemporaryFolder folder;
  const auto saved = saveRecording(*before, folder / "run.jsonl");
  ASSERT_TRUE(saved) << saved.error().text();
  const auto after = loadRecording(folder / "run.jsonl");
  ASSERT_TRUE(after) << after.error().text();
  EXPECT_EQ(after->events, before->events);
  EXPECT_EQ(after->hash, before->hash);
  ASSERT_EQ(after->shells.size(), before->shells.size());
  for (std::size_t i = 0; i < before->shells.size(); ++i)
    for (double share : {0.0, 0.3, 0.9, 1.0}) {
      const double t = before->shells[i].fired_s + share * (before->shells[i].burst_s - before->shells[i].fired_s);
      EXPECT_EQ(after->shells[i].at(t), before->shells[i].at(t));
    }
  ASSERT_EQ(after->vehicles.size(), before->vehicles.size());
  for (std::size_t i = 0; i < before->vehicles.size(); ++i) {
    EXPECT_EQ(after->vehicles[i].track, before->vehicles[i].track);
    EXPECT_EQ(after->vehicles[i].damage, before->vehicles[i].damage);
    EXPECT_EQ(after->vehicles[i].type, before->vehicles[i].type);
  }
  for (std::size_t i = 0; i < before->guns.size(); ++i) EXPECT_EQ(after->guns[i].lineAt(77.7), before->guns[i].lineAt(77.7));
  EXPECT_EQ(csvText(*after).value_or(""), csvText(*before).value_or("no"));
}

TEST(MissionFiles, AProjectileBesideTheMissionFileIsFoundFromAnywhereAndByItsRecording) {
  const test::TemporaryFolder folder;
  test::spill(folder / "shell.json", test::slurp(std::string(NPSEE_SOURCE_DIR) + "/assets/projectiles/m107.json"));
  auto scenario = loadScenario(std::string(NPSEE_SOURCE_DIR) + "/assets/missions/ridge_low.mission.json");
  ASSERT_TRUE(scenario) << scenario.error().text();
  scenario->folder = folder.path();
  scenario->weapons.clear();  // the shipped one: nothing else lies in the folder
  scenario->batteries[0].projectile = "shell.json";
  const auto run = runMission(*scenario, 60.0);
  ASSERT_TRUE(run) << run.error().text();
  ASSERT_FALSE(run->shells.empty());
  ASSERT_TRUE(saveRecording(*run, folder / "run.jsonl"));
  const auto read = loadRecording(folder / "run.jsonl");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->shells[0].at(read->shells[0].fired_s + 3.0), run->shells[0].at(run->shells[0].fired_s + 3.0));
}

std::string nameOf(const testing::TestParamInfo<fs::path>& info) {
  std::string out = info.param.parent_path().filename().string() + "_" + info.param.filename().string();
  out.resize(out.find('.'));
  std::ranges::replace_if(out, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return out;
}
INSTANTIATE_TEST_SUITE_P(Shipped, MissionRecording, testing::ValuesIn(missionsIn("assets/missions")), nameOf);
INSTANTIATE_TEST_SUITE_P(Acceptance, MissionRecording, testing::ValuesIn(missionsIn("tests/scenario/acceptance")), nameOf);

}  // namespace
}  // namespace npsee
