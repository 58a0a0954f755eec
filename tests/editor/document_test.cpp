#include "editor/document/session.h"
#include "tests/support/models.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace npsee::editor {
namespace {

const Parameter& row(std::string_view key) { return *findParameter(Scope::layer, key); }

void setAngle(Document& document, double rad, std::string_view merge_key = {}) {
  ASSERT_TRUE(document.assign(row("ejection_angle"), rad, merge_key).has_value());
}

TEST(Document, StartsUnchangedWithOneLayerAndNothingToUndo) {
  const Document document;
  EXPECT_TRUE(validate(document.preset()).empty());
  EXPECT_EQ(document.preset().layers.size(), 1u);
  EXPECT_FALSE(document.dirty());
  EXPECT_FALSE(document.history().canUndo());
  EXPECT_EQ(document.name(), "untitled");
}

TEST(Document, EveryParameterIsAssignedUndoneAndRedone) {
  for (const Parameter& parameter : parameters()) {
    Document document;
    const Value before = document.value(parameter);
    const auto& range = parameter.slider;
    Value other = before;
    if (auto* number = std::get_if<double>(&other)) *number = toSi(parameter.unit, range.min + 0.37 * (range.max - range.min));
    else if (auto* whole = std::get_if<std::int64_t>(&other)) *whole = static_cast<std::int64_t>(range.min) + 3;
    else if (auto* flag = std::get_if<bool>(&other)) *flag = !*flag;
    else if (auto* vector = std::get_if<Vec3>(&other)) vector->x = 0.5;
    else if (auto* colour = std::get_if<Colour>(&other)) colour->g = 0.25;
    else if (auto* curve = std::get_if<Curve>(&other)) curve->push_back({0.5, 0.5});
    else if (auto* gradient = std::get_if<Gradient>(&other)) gradient->push_back({0.5, {1, 0, 0}});
    else if (parameter.type == ParameterType::choice && parameter.key != "trigger") other = std::string(parameter.choices.back());
    else if (parameter.type == ParameterType::text && parameter.key != "parent") other = std::string("word");
    if (other == before) continue;
    const auto assigned = document.assign(parameter, other);
    ASSERT_TRUE(assigned.has_value()) << parameter.key << ": " << assigned.error().text();
    EXPECT_EQ(document.value(parameter), other) << parameter.key;
    EXPECT_TRUE(document.dirty()) << parameter.key;
    EXPECT_EQ(document.history().undoSteps(), 1u) << parameter.key;
    EXPECT_TRUE(document.undo());
    EXPECT_EQ(document.value(parameter), before) << parameter.key;
    EXPECT_FALSE(document.dirty()) << parameter.key;
    EXPECT_TRUE(document.redo());
    EXPECT_EQ(document.value(parameter), other) << parameter.key;
  }
}

TEST(Document, ARefusedEditChangesNothingAndSaysWhy) {
  Document document;
  const auto revision = document.revision();
  const auto refused = document.assign(row("speed_mean"), 5000.0);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().text().find("above the limit of 3000 m/s"), std::string::npos);
  EXPECT_EQ(document.revision(), revision);
  EXPECT_FALSE(document.history().canUndo());
  EXPECT_FALSE(document.assign(row("count"), std::int64_t{1'000'000'000}).has_value());
  EXPECT_FALSE(document.dirty());
}

TEST(Document, AnEditThatChangesNothingIsNoStep) {
  Document document;
  setAngle(document, document.layer().ejection_angle_rad);
  EXPECT_FALSE(document.history().canUndo());
}

TEST(Document, HangingALayerOnAnotherGivesItATriggerAndBack) {
  Document document;
  ASSERT_TRUE(document.addLayer().has_value());
  ASSERT_TRUE(document.assign(row("parent"), std::string("fragments")).has_value());
  EXPECT_EQ(document.layer().trigger, Trigger::birth);
  ASSERT_TRUE(document.assign(row("parent"), std::string()).has_value());
  EXPECT_EQ(document.layer().trigger, Trigger::none);
}

TEST(Document, DeletingALayerDeletesWhatHangsOnItAndUndoBringsAllBack) {
  Document document;
  ASSERT_TRUE(document.addLayer().has_value());
  ASSERT_TRUE(document.assign(row("parent"), std::string("fragments")).has_value());
  const Preset before = document.preset();
  document.select(0);
  ASSERT_TRUE(document.deleteLayer().has_value());
  EXPECT_TRUE(document.preset().layers.empty());
  EXPECT_FALSE(document.hasLayer());
  document.undo();
  EXPECT_EQ(document.preset(), before);
}

TEST(Document, DuplicatesMovesAndRenamesLayers) {
  Document document;
  ASSERT_TRUE(document.duplicateLayer().has_value());
  EXPECT_EQ(document.selected(), 1);
  EXPECT_EQ(document.layer().name, "fragments 2");
  ASSERT_TRUE(document.renameLayer("sparks").has_value());
  ASSERT_TRUE(document.moveLayer(-1).has_value());
  EXPECT_EQ(document.preset().layers[0].name, "sparks");
  EXPECT_EQ(document.selected(), 0);
  EXPECT_TRUE(document.moveLayer(-1).has_value());
  EXPECT_FALSE(document.renameLayer("fragments").has_value());
  EXPECT_EQ(document.history().undoSteps(), 3u);
}

TEST(History, OneDragIsOneUndoStep) {
  Document document;
  const Preset before = document.preset();
  for (int i = 1; i <= 20; ++i) setAngle(document, 0.02 * i, "angle");
  EXPECT_EQ(document.history().undoSteps(), 1u);
  document.endMerge();
  for (int i = 1; i <= 20; ++i) setAngle(document, 0.01 * i, "angle");
  EXPECT_EQ(document.history().undoSteps(), 2u);
  document.undo();
  EXPECT_EQ(document.layer().ejection_angle_rad, 0.02 * 20);
  document.undo();
  EXPECT_EQ(document.preset(), before);
  EXPECT_FALSE(document.undo());
}

TEST(History, ADragThatComesBackIsNoStep) {
  Document document;
  const double before = document.layer().ejection_angle_rad;
  setAngle(document, 0.1, "angle");
  setAngle(document, before, "angle");
  document.endMerge();
  EXPECT_FALSE(document.history().canUndo());
}

TEST(History, AnEditAfterUndoForgetsWhatCouldBeRedone) {
  Document document;
  setAngle(document, 0.1);
  document.undo();
  EXPECT_TRUE(document.history().canRedo());
  setAngle(document, 0.2);
  EXPECT_FALSE(document.history().canRedo());
  EXPECT_EQ(document.history().undoLabel(), "Ejection angle");
}

TEST(History, IsBounded) {
  Document document;
  for (std::size_t i = 0; i < History::kMaxSteps + 50; ++i) setAngle(document, 0.001 * static_cast<double>(i + 1));
  EXPECT_EQ(document.history().undoSteps(), History::kMaxSteps);
}

TEST(Document, SavesOpensAndKnowsWhatIsUnsaved) {
  const test::TemporaryFolder folder;
  Document document;
  setAngle(document, 0.5);
  EXPECT_FALSE(document.save().has_value()) << "there is no file yet";
  ASSERT_TRUE(document.saveAs(folder / "mine").has_value());
  EXPECT_EQ(document.path(), folder / "mine.npsee.json");
  EXPECT_EQ(document.name(), "mine");
  EXPECT_FALSE(document.dirty());
  setAngle(document, 0.6);
  EXPECT_TRUE(document.dirty());
  document.undo();
  EXPECT_FALSE(document.dirty()) << "undone to what the file holds";

  Document other;
  ASSERT_TRUE(other.load(folder / "mine.npsee.json").has_value());
  EXPECT_EQ(other.preset(), document.preset());
  EXPECT_FALSE(other.history().canUndo());
}

TEST(Document, ANameWithADotGetsTheEnding) {
  const test::TemporaryFolder folder;
  Document document;
  for (const auto& [typed, file] : {std::pair("burst 1.5", "burst 1.5.npsee.json"), {"x.mission.json", "x.npsee.json"}, {"plain.json", "plain.npsee.json"}, {"kept.npsee.json", "kept.npsee.json"}, {".json", ".json.npsee.json"}}) {
    ASSERT_TRUE(document.saveAs(folder / typed).has_value()) << typed;
    EXPECT_EQ(document.path().filename(), file);
    EXPECT_TRUE(std::filesystem::exists(folder / file));
  }
  EXPECT_FALSE(document.saveAs(folder / "").has_value()) << "a folder is no name";
}

TEST(Document, AFailedSaveOrLoadLosesNothing) {
  const test::TemporaryFolder folder;
  Document document;
  setAngle(document, 0.5);
  const Preset before = document.preset();
  const auto saved = document.saveAs(folder / "no such folder/mine.npsee.json");
  ASSERT_FALSE(saved.has_value());
  EXPECT_EQ(saved.error().kind, ErrorKind::output);
  test::spill(folder / "bad.npsee.json", "{\"npsee\": 1, \"layers\": [{\"speed_meen\": 3}]}");
  const auto loaded = document.load(folder / "bad.npsee.json");
  ASSERT_FALSE(loaded.has_value());
  EXPECT_NE(loaded.error().text().find("speed_mean"), std::string::npos) << "names the nearest key";
  EXPECT_EQ(document.preset(), before);
  EXPECT_TRUE(document.dirty());
  EXPECT_TRUE(document.path().empty());
}

TEST(Document, SavedElsewhereItTakesTheModelsBesideItAlong) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "from/models");
  std::filesystem::create_directories(folder / "to");
  test::spill(folder / "from/models/a.mtl", "newmtl red\nKd 1 0 0\n");
  test::spill(folder / "from/models/a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  test::spill(folder / "from/whole.npsee.json", R"({"npsee": 1, "layers": [{"name": "whole", "count": 4, "form": "pieces", "pieces": {"model": "models/a.obj"}}]})");
  Document document;
  ASSERT_TRUE(document.load(folder / "from/whole.npsee.json").has_value());
  ASSERT_TRUE(document.saveAs(folder / "to/whole").has_value());
  EXPECT_EQ(test::slurp(folder / "to/models/a.obj"), test::slurp(folder / "from/models/a.obj"));
  EXPECT_EQ(test::slurp(folder / "to/models/a.mtl"), test::slurp(folder / "from/models/a.mtl"));
  EXPECT_EQ(document.preset().folder.path, std::filesystem::path(folder / "to"));
  EXPECT_FALSE(document.dirty());
}

TEST(Document, SavingAfterSwapTakesTheModelAlong) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a");
  std::filesystem::create_directories(folder / "b");
  test::spill(folder / "b/own.obj", test::boxObj({-1, 0, -1}, {1, 2, 1}));
  test::spill(folder / "b/y.npsee.json", R"({"npsee": 1, "layers": [{"name": "whole", "count": 4, "form": "pieces", "pieces": {"model": "own.obj"}}]})");
  Session session({.library = {}, .wait_for_compile = true});
  ASSERT_TRUE(session.document.saveAs(folder / "a/x").has_value());
  const std::filesystem::path file = session.document.path();
  session.compareWithFile(folder / "b/y.npsee.json");
  session.swapCompared();
  session.save();
  EXPECT_EQ(session.notices.error, "");
  EXPECT_FALSE(session.document.dirty());
  EXPECT_EQ(session.document.preset().folder.path, std::filesystem::path(folder / "a"));
  EXPECT_TRUE(std::filesystem::exists(folder / "a/own.obj"));
  Session again({.library = {}, .wait_for_compile = true});
  again.open(file);
  again.update(0.0);
  EXPECT_EQ(again.notices.error, "");
  ASSERT_NE(again.explosion(), nullptr);
  EXPECT_EQ(again.explosion()->particleCount(), 4u);
}

TEST(Document, UndonePastSaveAsAndSavedItTakesTheFormerModelAlong) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a", "b"}) std::filesystem::create_directories(folder / name);
  for (const char* name : {"a/one.obj", "a/two.obj"}) test::spill(folder / name, test::boxObj({-1, 0, -1}, {1, 2, 1}));
  test::spill(folder / "a/x.npsee.json", R"({"npsee": 1, "layers": [{"name": "whole", "count": 4, "form": "pieces", "pieces": {"model": "one.obj"}}]})");
  Document document;
  ASSERT_TRUE(document.load(folder / "a/x.npsee.json").has_value());
  ASSERT_TRUE(document.assign(*findParameter(Scope::layer, "pieces.model"), std::string("two.obj")).has_value());
  ASSERT_TRUE(document.saveAs(folder / "b/x").has_value());
  EXPECT_FALSE(std::filesystem::exists(folder / "b/one.obj"));
  ASSERT_TRUE(document.undo());
  ASSERT_TRUE(document.save().has_value());
  EXPECT_TRUE(std::filesystem::exists(folder / "b/one.obj"));
}

}  // namespace
}  // namespace npsee::editor
