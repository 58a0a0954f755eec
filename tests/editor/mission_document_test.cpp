#include "editor/document/session.h"
#include "editor/mission/document.h"
#include "editor/mission/session.h"
#include "tests/support/models.h"
#include "tests/support/process.h"
#include "tests/support/small_mission.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;

/// A document that holds the small mission, saved in a folder of its own.
class MissionDocuments : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(saveScenario(test::smallMission(), folder_ / "small.mission.json").has_value());
    const auto loaded = document.load(folder_ / "small.mission.json");
    ASSERT_TRUE(loaded.has_value()) << loaded.error().text();
  }
  Place at(const ObjectRef& ref) const { return *placeOf(document.scenario(), ref); }

  test::TemporaryFolder folder_;
  MissionDocument document;
};

TEST_F(MissionDocuments, OneDragIsOneUndoStep) {
  const ObjectRef tank{Kind::vehicle, "t72-1"};
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(document.edit("Move", "move t72-1", [&](Scenario& s) { shift(s, tank, 10.0, -5.0); }).has_value());
  document.endMerge();
  EXPECT_EQ(document.history().undoSteps(), 1u);
  EXPECT_EQ(at(tank), (Place{7100.0, 4950.0}));
  EXPECT_TRUE(document.dirty());
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(at(tank), (Place{7000.0, 5000.0}));
  EXPECT_FALSE(document.dirty()) << "back where the file is";
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(at(tank), (Place{7100.0, 4950.0}));
}

TEST_F(MissionDocuments, ADragThatComesBackIsNoStep) {
  const ObjectRef tank{Kind::vehicle, "t72-1"};
  ASSERT_TRUE(document.edit("Move", "move", [&](Scenario& s) { shift(s, tank, 64.0, 0.0); }).has_value());
  ASSERT_TRUE(document.edit("Move", "move", [&](Scenario& s) { shift(s, tank, -64.0, 0.0); }).has_value());
  document.endMerge();
  EXPECT_EQ(document.history().undoSteps(), 0u);
}

TEST_F(MissionDocuments, AnEditThatBreaksARuleIsRefusedWithItsReasonAndChangesNothing) {
  const auto refused = document.edit("Duration", {}, [](Scenario& s) { s.duration_s = -1.0; });
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::usage);
  EXPECT_NE(refused.error().text().find("duration"), std::string::npos) << refused.error().text();
  EXPECT_EQ(document.scenario().duration_s, 120.0);
  EXPECT_FALSE(document.history().canUndo());
}

TEST_F(MissionDocuments, ABatteryKeepsItsShapeAtTheWorldsEdge) {
  ASSERT_TRUE(document.edit("Move", {}, [](Scenario& s) { shift(s, {Kind::battery, "battery"}, -5000.0, 20000.0); }).has_value());
  const auto& guns = document.scenario().batteries[0].guns;
  EXPECT_EQ(guns[0].at.x_m, 0.0);
  EXPECT_EQ(guns[1].at.z_m, 10000.0);
  EXPECT_EQ(guns[1].at.z_m - guns[0].at.z_m, 20.0);
}

TEST_F(MissionDocuments, RenamingFollowsEverywhereTheNameStands) {
  ASSERT_TRUE(document.edit("Carry", {}, [](Scenario& s) {
    addVehicle(s, 8, {5400.0, 5200.0});
    s.vehicles.back().follows = "t72-1";
    s.vehicles.back().behaviour = Behaviour::follow;
    s.observers[0].batteries = {"battery"};
  }).has_value());
  document.select({Kind::vehicle, "t72-1"});
  ASSERT_TRUE(document.renameObject({Kind::vehicle, "t72-1"}, "target").has_value());
  EXPECT_EQ(document.selected(), (ObjectRef{Kind::vehicle, "target"}));
  EXPECT_EQ(document.scenario().vehicles[1].follows, "target");
  ASSERT_TRUE(document.renameObject({Kind::battery, "battery"}, "alpha").has_value());
  EXPECT_EQ(document.scenario().observers[0].batteries, std::vector<std::string>{"alpha"});
  const auto refused = document.renameObject({Kind::gun, "gun1"}, "fo1");
  EXPECT_FALSE(refused.has_value()) << "a name is given once";
}

TEST_F(MissionDocuments, AddedThingsGetFreeNamesAndAreSelected) {
  ASSERT_TRUE(document.add("Add", [](Scenario& s) { return addVehicle(s, 51, {6000.0, 6000.0}); }).has_value());
  EXPECT_EQ(document.selected().kind, Kind::vehicle);
  EXPECT_EQ(document.selected().id, "t-72-1");
  ASSERT_TRUE(document.duplicateSelected().has_value());
  EXPECT_EQ(document.selected().id, "t-72-2");
  ASSERT_TRUE(document.add("Add", [](Scenario& s) { return addGun(s, "battery", {2000.0, 5100.0}); }).has_value());
  EXPECT_EQ(document.selected().id, "gun3");
  ASSERT_TRUE(document.add("Add", [](Scenario& s) { return addObserver(s, {5000.0, 5100.0}); }).has_value());
  EXPECT_EQ(document.selected().id, "fo2");
  EXPECT_EQ(document.scenario().observers[1].missions.size(), 1u) << "against the type that stands there";
  EXPECT_TRUE(validate(document.scenario()).empty());
}

TEST_F(MissionDocuments, DuplicatingAnObserverLeavesHisVehicleWhereItIs) {
  ASSERT_TRUE(document.edit("Carry", {}, [](Scenario& s) { s.observers[0].vehicle = addVehicle(s, 8, {5400.0, 5250.0}).id; }).has_value());
  const std::string carrier = document.scenario().observers[0].vehicle;
  document.select({Kind::observer, "fo1"});
  ASSERT_TRUE(document.duplicateSelected().has_value());
  EXPECT_EQ(at({Kind::vehicle, carrier}), (Place{5400.0, 5250.0}));
  EXPECT_EQ(document.scenario().observers[0].vehicle, carrier);
  EXPECT_TRUE(document.scenario().observers[1].vehicle.empty());
  EXPECT_EQ(at(document.selected()), (Place{5430.0, 5280.0})) << "beside him";
}

TEST_F(MissionDocuments, RemovingTakesTheNameOutOfWhatNamedIt) {
  ASSERT_TRUE(document.edit("Carry", {}, [](Scenario& s) { s.observers[0].vehicle = addVehicle(s, 8, {5400.0, 5250.0}).id; }).has_value());
  const std::string carrier = document.scenario().observers[0].vehicle;
  document.select({Kind::vehicle, carrier});
  ASSERT_TRUE(document.removeSelected().has_value());
  EXPECT_TRUE(document.scenario().observers[0].vehicle.empty());
  EXPECT_EQ(document.scenario().observers[0].at, (Place{5400.0, 5250.0}));
  document.select({Kind::gun, "gun1"});
  ASSERT_TRUE(document.removeSelected().has_value());
  document.select({Kind::gun, "gun2"});
  ASSERT_TRUE(document.removeSelected().has_value());
  EXPECT_TRUE(document.scenario().batteries.empty()) << "a battery without guns is none";
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.scenario().batteries.size(), 1u);
}

TEST_F(MissionDocuments, CommandsAreUndoneButNotSaved) {
  MissionCommand take;
  take.kind = MissionCommand::Kind::take;
  take.who = "fo1";
  document.command("Take over fo1", {}, {take});
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.commands()->size(), 1u);
  EXPECT_EQ(document.history().undoLabel(), "Take over fo1");
  EXPECT_TRUE(document.undo());
  EXPECT_TRUE(document.commands()->empty());
}

TEST_F(MissionDocuments, SavingElsewhereTakesTheFilesAlongThatTheMissionNames) {
  test::spill(folder_ / "own.clp", "(mission destroy 51)\n");
  ASSERT_TRUE(document.edit("Rules", {}, [](Scenario& s) { s.observers[0].rules = "own.clp"; }).has_value());
  std::filesystem::create_directories(folder_ / "below");
  const auto saved = document.saveAs(folder_ / "below/copy");
  ASSERT_TRUE(saved.has_value()) << saved.error().text();
  EXPECT_EQ(document.path().filename(), "copy.mission.json");
  EXPECT_EQ(document.scenario().folder, std::filesystem::path(folder_ / "below"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "below/own.clp"));
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.name(), "copy");
  EXPECT_TRUE(loadScenario(document.path()).has_value());
}

TEST_F(MissionDocuments, SavingElsewhereTakesTheModelsOfABatterysOwnPresetAlong) {
  std::filesystem::create_directories(folder_ / "bursts");
  std::filesystem::create_directories(folder_ / "below");
  test::spill(folder_ / "bursts/own.npsee.json", R"({"npsee": 1, "layers": [{"name": "whole", "count": 4, "form": "pieces", "pieces": {"model": "box.obj"}}]})");
  test::spill(folder_ / "bursts/box.obj", "mtllib box.mtl\n" + test::boxObj({-1, 0, -1}, {1, 2, 1}));
  test::spill(folder_ / "bursts/box.mtl", "newmtl red\nKd 1 0 0\n");
  ASSERT_TRUE(document.edit("Preset", {}, [](Scenario& s) { s.batteries[0].preset = "bursts/own.npsee.json"; }).has_value());
  ASSERT_TRUE(document.saveAs(folder_ / "below/copy").has_value());
  for (const char* name : {"below/bursts/own.npsee.json", "below/bursts/box.obj", "below/bursts/box.mtl"}) EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
}

TEST_F(MissionDocuments, ANameWithADotGetsTheEndingAndIsOpenedAgain) {
  for (const auto& [typed, name] : {std::pair("attack 1.5", "attack 1.5"), {"defence.json", "defence"}, {"both.npsee.json", "both"}}) {
    ASSERT_TRUE(document.saveAs(folder_ / typed).has_value()) << typed;
    EXPECT_EQ(document.name(), name);
    Session session({.library = {}, .wait_for_compile = true});
    session.open(document.path());
    EXPECT_EQ(session.notices.error, "");
    EXPECT_TRUE(session.inMission());
    EXPECT_EQ(session.mission().document.scenario().title, document.scenario().title);
  }
}

TEST_F(MissionDocuments, ABrokenFileIsAMessageAndTheDocumentStays) {
  test::spill(folder_ / "broken.mission.json", "{ \"npsee_mission\": 1, \"vehicle\": [] ");
  const auto refused = document.load(folder_ / "broken.mission.json");
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().text().find("broken.mission.json"), std::string::npos);
  EXPECT_EQ(document.name(), "small");
}

TEST(MissionObjects, FreeNamesCountOn) {
  Scenario scenario = test::smallMission();
  EXPECT_EQ(freeName(scenario, "t72-1"), "t72-2");
  EXPECT_EQ(freeName(scenario, "gun1"), "gun3");
  EXPECT_EQ(freeName(scenario, "new"), "new1");
  EXPECT_EQ(freeName(scenario, ""), "object-1");
}

}  // namespace
}  // namespace npsee::editor
