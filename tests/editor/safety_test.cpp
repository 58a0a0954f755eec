#include "editor/desk/recovery.h"
#include "editor/document/camera_moves.h"
#include "editor/mission/session.h"
#include "tests/editor/desk_script.h"
#include "tests/support/running.h"
#include "tests/support/small_mission.h"

#include <npsee/preset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace npsee {
namespace {

using test::DeskScript;

double numberAfter(const std::string& text, const std::string& name) {
  const std::size_t at = text.rfind(name + '=');
  return at == std::string::npos ? -1.0 : std::strtod(text.c_str() + at + name.size() + 1, nullptr);
}

double speedIn(const std::string& file) {
  const auto preset = loadPreset(file);
  EXPECT_TRUE(preset.has_value()) << preset.error().text();
  return preset ? preset->layers.at(0).speed_mean_mps : -1.0;
}

TEST(HistoryList, GoesToAnyStepAndBack) {
  editor::Document document;
  const auto speed = [&](double v) { ASSERT_TRUE(document.assign(*findParameter(Scope::layer, "speed_mean"), v).has_value()); };
  for (const double v : {11.0, 12.0, 13.0, 14.0}) speed(v);
  ASSERT_TRUE(document.addLayer().has_value());
  EXPECT_EQ(document.undoLabels().size(), 5u);
  EXPECT_EQ(document.undoLabels().back(), "Add layer");
  document.jump(-3);
  EXPECT_EQ(document.preset().layers.size(), 1u);
  EXPECT_EQ(document.layer().speed_mean_mps, 12.0);
  EXPECT_EQ(document.redoLabels().back(), "Add layer");
  document.jump(+3);
  EXPECT_EQ(document.preset().layers.size(), 2u);
  document.jump(-100);
  EXPECT_FALSE(document.canUndo()) << "as far as there are steps";
  EXPECT_FALSE(document.dirty());
}

TEST(FileOutside, WhatAnotherProgramWritesIsNoticedAndOneselfIsNot) {
  const test::TemporaryFolder folder;
  editor::Document document;
  ASSERT_TRUE(document.saveAs(folder / "a.npsee.json").has_value());
  EXPECT_FALSE(document.changedOutside());
  Preset other = document.preset();
  other.title = "another";
  ASSERT_TRUE(savePreset(document.preset(), folder / "a.npsee.json").has_value());
  EXPECT_FALSE(document.changedOutside()) << "written again, but the same";
  ASSERT_TRUE(savePreset(other, folder / "a.npsee.json").has_value());
  EXPECT_TRUE(document.changedOutside());
  ASSERT_TRUE(document.reload().has_value());
  EXPECT_EQ(document.preset().title, "another");
  EXPECT_FALSE(document.dirty());
  EXPECT_FALSE(document.changedOutside());
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.preset().title, "New effect");
  EXPECT_TRUE(document.dirty());
  std::filesystem::remove(folder / "a.npsee.json");
  EXPECT_TRUE(document.changedOutside());
  document.keepOwn();
  EXPECT_FALSE(document.changedOutside());
  EXPECT_TRUE(document.dirty()) << "no file holds it";
}

TEST(FileOutside, IsReadAgainWhereNothingIsUnsavedAndElseAsked) {
  const test::TemporaryFolder folder;
  editor::Session session({.library = {}, .wait_for_compile = true});
  const std::string file = folder / "a.npsee.json";
  ASSERT_TRUE(session.document.saveAs(file).has_value());
  session.update(0.0);
  session.playback.playing = false;
  session.playback.seek(0.4);
  const render::Camera camera = session.camera = moved(session.camera, editor::CameraKey::viewpoint_y_plus, 2.0);
  Preset other = session.document.preset();
  other.layers[0].speed_mean_mps = 33.0;
  ASSERT_TRUE(savePreset(other, file).has_value());
  session.update(1.0);
  EXPECT_EQ(session.document.layer().speed_mean_mps, 33.0);
  EXPECT_EQ(session.camera, camera);
  EXPECT_EQ(session.playback.time_s, 0.4);
  EXPECT_FALSE(session.outside());

  ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, "speed_mean"), 44.0).has_value());
  other.layers[0].speed_mean_mps = 55.0;
  ASSERT_TRUE(savePreset(other, file).has_value());
  session.save();
  EXPECT_TRUE(session.outside()) << "saving at once does not overwrite it unseen";
  EXPECT_EQ(speedIn(file), 55.0);
  session.update(1.0);
  EXPECT_EQ(session.document.layer().speed_mean_mps, 44.0);
  session.keepOwn();
  session.save();
  EXPECT_EQ(speedIn(file), 44.0);
  EXPECT_FALSE(session.file().dirty());

  test::spill(file, "{ half a fi");
  session.update(1.0);
  EXPECT_EQ(session.document.layer().speed_mean_mps, 44.0) << "the last good state stays";
  EXPECT_FALSE(session.notices.error.empty());
  ASSERT_TRUE(savePreset(other, file).has_value());
  session.update(1.0);
  session.reloadFile();
  EXPECT_EQ(session.document.layer().speed_mean_mps, 55.0);
}

TEST(UnsavedWork, SurvivesItsTextFormat) {
  const editor::UnsavedWork work{editor::WorkMode::explosion, "/a/b \"c\".npsee.json", "{\n\"npsee\": 1}\n"};
  const auto read = editor::parseUnsaved(editor::unsavedText(work), "x");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->file, work.file);
  EXPECT_EQ(read->text, work.text);
  EXPECT_FALSE(editor::parseUnsaved("{\"kind\": \"letter\"}", "x").has_value());
  EXPECT_FALSE(editor::parseUnsaved("[1, 2", "x").has_value());
}

TEST(UnsavedWork, FindsTheFilesBesideItsPresetAgain) {
  const auto preset = editor::Snapshot::parse("{\"npsee\": 1, \"layers\": [{}]}", "/some/where/work.npsee.json");
  ASSERT_TRUE(preset) << preset.error().text();
  EXPECT_EQ(preset->folder.path, "/some/where") << "models that it names lie beside its file";
}

TEST(UnsavedWork, OfARunningEditorIsNobodyElses) {
  const test::TemporaryFolder folder;
  editor::Writer writer;
  editor::Session session({.library = {}, .wait_for_compile = true});
  ASSERT_TRUE(session.document.addLayer().has_value());
  auto running = std::make_unique<editor::Recovery>(folder.path(), writer);
  EXPECT_FALSE(running->safe(session));
  running->update(1.0, session, true);
  EXPECT_TRUE(running->safe(session));
  {
    const editor::Recovery other(folder.path(), writer);
    EXPECT_TRUE(other.found().empty()) << "it is being worked on";
  }
  running.reset();  // ends without its questions being answered
  editor::Recovery next(folder.path(), writer);
  ASSERT_EQ(next.found().size(), 1u);
  {
    const editor::Recovery third(folder.path(), writer);
    EXPECT_TRUE(third.found().empty()) << "one editor offers it, not two";
  }
  editor::Session fresh({.library = {}, .wait_for_compile = true});
  ASSERT_TRUE(fresh.document.addLayer().has_value());
  next.bringBack(fresh);
  fresh.answer(editor::Answer::cancel);
  next.update(1.0, fresh, true);
  EXPECT_EQ(next.found().size(), 1u) << "cancelled: still offered";
  next.bringBack(fresh);
  fresh.answer(editor::Answer::discard);
  EXPECT_EQ(fresh.document.preset().layers.size(), 2u);
  next.update(1.0, fresh, true);
  EXPECT_TRUE(next.found().empty());
  next.update(1.0, fresh, true);
  next.finish();
  writer.wait();
  EXPECT_EQ(std::ranges::count_if(std::filesystem::directory_iterator(folder.path()), [](const auto& entry) { return entry.path().extension() == ".unsaved"; }), 0);
}

TEST(UnsavedWork, OnAMissionIsKeptToo) {
  const test::TemporaryFolder folder;
  editor::Writer writer;
  const std::string file = folder / "small.mission.json";
  ASSERT_TRUE(saveScenario(test::smallMission(), file).has_value());
  {
    editor::Session session({.library = {}, .wait_for_compile = true});
    session.open(file);
    ASSERT_TRUE(session.mission().document.edit("Title", {}, [](Scenario& s) { s.title = "changed"; }).has_value());
    editor::Recovery recovery(folder / "state", writer);
    recovery.update(1.0, session, true);
  }
  editor::Session session({.library = {}, .wait_for_compile = true});
  editor::Recovery recovery(folder / "state", writer);
  ASSERT_EQ(recovery.found().size(), 1u);
  recovery.bringBack(session);
  EXPECT_TRUE(session.inMission());
  EXPECT_EQ(session.mission().document.scenario().title, "changed");
  EXPECT_EQ(session.file().path(), file);
  EXPECT_TRUE(session.file().dirty());
  session.undo();
  EXPECT_FALSE(session.file().dirty()) << "undo shows what the file holds";
}

TEST_F(DeskScript, TheHistoryListGoesToAStepByAClick) {
  passes(R"(set fragments.speed_mean 61
set fragments.speed_mean 62
set fragments.speed_mean 63
key ctrl+H
expect sheet = history
expect visible history:3
click history:1
expect fragments.speed_mean = 61
expect redo = 2
click history:3
expect fragments.speed_mean = 63
click history:0
expect dirty = no
key Escape
expect sheet = none
)");
}

TEST_F(DeskScript, TheQuestionIsAnsweredByKeys) {
  passes(R"(set fragments.speed_mean 61
key ctrl+Q
expect question = yes
key Escape
expect question = no
expect quitting = no
key ctrl+Q
key Enter
expect quitting = yes
expect dirty = no
)");
  EXPECT_EQ(speedIn(in("work.npsee.json")), 61.0);
}

TEST_F(DeskScript, DeletingWhileEditingGoesOnDoesNotAnswerTheQuestion) {
  passes(R"(set fragments.size_over_life [[0,1],[0.5,0.5],[1,1]]
click "button:add layer"
click layer:fragments
click life:fragments.size_over_life
hover point:fragments.size_over_life.1
key ctrl+Q
expect question = yes
expect layers = 2
click point:fragments.size_over_life.1
key Delete
expect fragments.size_over_life = [[0,1],[1,1]]
expect question = yes
expect quitting = no
key ctrl+Delete
expect layers = 1
expect question = yes
expect quitting = no
hover strip:question
key ctrl+Delete
expect question = yes
key Delete
expect quitting = yes
)");
}

TEST_F(DeskScript, UnsavedWorkIsOfferedBroughtBackAndThrownAway) {
  remembers("set fragments.speed_mean 61\nexpect autosaved = yes\n", preset());
  remembers(R"(expect unsaved = 1
expect visible strip:unsaved
click "button:bring back"
expect window.title = work *
expect fragments.speed_mean = 61
expect undo = 1
expect unsaved = 0
key ctrl+Z
expect dirty = no
key ctrl+shift+Z
wait 31
)");
  remembers(R"(expect unsaved = 1
click button:later
expect unsaved = 0
)");
  remembers(R"(expect unsaved = 1
click "button:throw away"
expect unsaved = 0
)");
  remembers("expect unsaved = 0\n");
  EXPECT_EQ(speedIn(in("work.npsee.json")), speedIn(classic())) << "nothing was saved by itself";
}

TEST_F(DeskScript, WorkThatWasAskedAboutIsNotOffered) {
  remembers("set fragments.speed_mean 61\nkey ctrl+Q\nclick button:discard\nexpect quitting = yes\n", preset());
  remembers("expect unsaved = 0\n");
  remembers("set fragments.speed_mean 62\nkey ctrl+S\n", preset());
  remembers("expect unsaved = 0\n");
}

TEST_F(DeskScript, AKillAtAnyMomentLosesAtMostHalfASecond) {
  std::string script = "note\n";
  for (int i = 0; i < 60; ++i) {
    script += "set fragments.speed_mean " + std::to_string(100 + i) + "\nwait 31\nprint fragments.speed_mean\n";
    // Drags and saves are under way when the process dies.
    if (i % 3 == 1) script += "key ctrl+S\n";
    if (i % 3 == 2) script += "drag fragments.size_mean 40\n";
  }
  for (const int lines : {1, 2, 3, 4, 7, 12}) {
    test::Running editor(test::npseePath(), arguments(script, preset()), environment());
    const std::string printed = editor.readLines(lines);
    editor.kill();
    const double reached = numberAfter(printed, "fragments.speed_mean");
    ASSERT_GE(reached, 100.0) << printed;
    double kept = speedIn(in("work.npsee.json"));
    const auto found = start("print unsaved\n", "");
    ASSERT_EQ(found.exit_code, 0) << found.err;
    if (numberAfter(found.out, "unsaved") > 0.0) {
      const auto back = start("click \"button:bring back\"\nexpect error =\nprint fragments.speed_mean\nkey ctrl+Q\nclick button:discard\n", "");
      ASSERT_EQ(back.exit_code, 0) << back.err;
      kept = std::max(kept, numberAfter(back.out, "fragments.speed_mean"));
    }
    EXPECT_GE(kept, reached) << "killed after " << lines << " lines";
    remembers("expect unsaved = 0\n");
  }
}

TEST_F(DeskScript, SettingsAreRememberedAndABadFileIsToldOf) {
  remembers("click menu:View\nclick \"item:Light theme\"\nexpect theme = light\ndrag splitter:left 30\n");
  remembers("expect theme = light\n");
  const std::string file = folder_ / "config/npsee/settings.json", good = test::slurp(file);
  EXPECT_NE(good.find("\"left_width\": 282"), std::string::npos) << good;
  test::spill(file, "{ \"light_theme\": tr");
  remembers("expect theme = dark\nexpect error contains settings.json:1\nexpect visible strip:error\n");
  EXPECT_TRUE(std::filesystem::exists(file + ".bad")) << "what may be mended is kept";
  test::spill(file, "{ \"light_theme\": true, \"left_width\": -4, \"of a later version\": 7 }");
  remembers("expect theme = light\nexpect error contains \"left_width is -4\"\n");
}

TEST_F(DeskScript, WithoutRememberNothingIsKept) {
  const auto result = test::npseeRun({"edit", "--headless", "--screenshot", folder_ / "x.png"}, environment());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* name : {"config", "state", "cache"}) EXPECT_FALSE(std::filesystem::exists(folder_ / (std::string(name) + "/npsee")));
  const auto window = test::npseeRun({"edit", "--remember"}, environment());
  EXPECT_EQ(window.exit_code, 2);
  EXPECT_NE(window.err.find("--remember belongs to --headless."), std::string::npos) << window.err;
}

TEST_F(DeskScript, ThePaletteFindsCommandsParametersAndPresets) {
  passes(R"(key ctrl+P
expect sheet = find
type ejec angle
key Enter
expect sheet = none
expect visible row:fragments.ejection_angle
expect typing = fragments.ejection_angle
type 40 deg
key Enter
expect fragments.ejection_angle = 40 deg
key ctrl+P
type light th
key Enter
expect theme = light
key ctrl+P
type add layer
key Down
key Up
key Enter
expect layers = 2
key ctrl+P
type zzz
expect hidden "found:Add layer"
key Escape
expect sheet = none
)");
}

}  // namespace
}  // namespace npsee
