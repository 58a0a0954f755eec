// What must not get lost, and what a preset takes along.

#include "editor/desk/desk.h"
#include "editor/desk/recovery.h"
#include "editor/desk/settings.h"
#include "editor/desk/thumbnails.h"
#include "editor/desk/work_folder.h"
#include "editor/document/library.h"
#include "editor/document/shelf.h"
#include "editor/document/statistics.h"
#include "tests/editor/desk_script.h"
#include "tests/support/models.h"
#include "tests/support/running.h"
#include "tests/support/scene.h"

#include <npsee/preset.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sys/resource.h>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using test::DeskScript;

/// No file can be written while it lives, as on a full disk.
class FullDisk {
 public:
  FullDisk() : before_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    rlimit none = limit_;
    none.rlim_cur = 0;
    ::setrlimit(RLIMIT_FSIZE, &none);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, before_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*before_)(int);
  rlimit limit_{};
};

std::size_t unsavedIn(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) count += entry.path().extension() == ".unsaved";
  return count;
}

TEST(UnsavedWork, ThatWasBroughtBackStaysUntilItIsWrittenAgain) {
  const test::TemporaryFolder folder;
  editor::Writer writer;
  editor::Session lost({.library = {}, .wait_for_compile = true});
  ASSERT_TRUE(lost.document.addLayer().has_value());
  editor::Recovery(folder.path(), writer).update(1.0, lost, true);
  ASSERT_EQ(unsavedIn(folder.path()), 1u);

  editor::Session session({.library = {}, .wait_for_compile = true});
  editor::Recovery recovery(folder.path(), writer);
  recovery.bringBack(session);
  EXPECT_EQ(session.document.preset().layers.size(), 2u);
  {
    const FullDisk full;
    for (int i = 0; i < 10; ++i) recovery.update(1.0, session, true);
    EXPECT_FALSE(recovery.safe(session));
    EXPECT_EQ(unsavedIn(folder.path()), 1u) << "the old record is all there is";
    EXPECT_TRUE(writer.takeError().has_value());
  }
  for (int i = 0; i < 10; ++i) recovery.update(1.0, session, true);
  EXPECT_TRUE(recovery.safe(session)) << "tried again without an edit";
  EXPECT_EQ(unsavedIn(folder.path()), 1u) << "the new record alone";
}

TEST(UnsavedWork, ThatCannotBeReadIsKeptAndTold) {
  const test::TemporaryFolder folder;
  test::spill(folder / "session-abcdef.lock", "");
  test::spill(folder / "session-abcdef.preset.unsaved", "{ half");
  editor::Writer writer;
  editor::Recovery recovery(folder.path(), writer);
  EXPECT_TRUE(recovery.found().empty());
  EXPECT_TRUE(fs::exists(folder / "session-abcdef.preset.unsaved.bad"));
  const std::string told = recovery.takeProblem();
  EXPECT_NE(told.find("session-abcdef.preset.unsaved.bad"), std::string::npos) << told;
  EXPECT_EQ(recovery.takeProblem(), "");
}

TEST(UnsavedWork, IsNotPromisedWhereNothingCanBeKept) {
  const test::TemporaryFolder folder;
  test::spill(folder / "file", "no folder");
  editor::Writer writer;
  editor::Recovery recovery(folder / "file/unsaved", writer);
  EXPECT_NE(recovery.takeProblem().find("cannot be kept"), std::string::npos);
  editor::Session session({.library = {}, .wait_for_compile = true});
  ASSERT_TRUE(session.document.addLayer().has_value());
  recovery.update(1.0, session, true);
  EXPECT_FALSE(recovery.safe(session));
}

TEST(Settings, OfTwoEditorsKeepWhatEachHasChanged) {
  editor::Settings before;
  before.favourites = {"/a", "/b"};
  before.recent = {"/a"};
  editor::Settings mine = before, theirs = before;
  mine.left_width = 300;
  mine.favourites = {"/b", "/mine"};
  mine.recent = {"/mine", "/a"};
  theirs.light = true;
  theirs.favourites = {"/a", "/b", "/theirs"};
  theirs.recent = {"/theirs", "/a"};
  const editor::Settings both = editor::changedSettings(theirs, before, mine);
  EXPECT_EQ(both.left_width, 300);
  EXPECT_TRUE(both.light);
  EXPECT_EQ(both.favourites, (std::vector<std::string>{"/b", "/theirs", "/mine"}));
  EXPECT_EQ(both.recent, (std::vector<std::string>{"/mine", "/a", "/theirs"}));
  EXPECT_EQ(editor::changedSettings(theirs, mine, mine), theirs) << "nothing was changed here";
}

TEST(Settings, ThatCouldNotBeWrittenAreWrittenWithTheNextChange) {
  const test::TemporaryFolder folder;
  editor::Session session({.library = {}, .wait_for_compile = true});
  editor::Desk desk({folder / "config", {}, {}}, {}, true);
  const auto pass = [&] {
    for (int i = 0; i < 3; ++i) {
      desk.update(1.0, session);
      desk.finish(false);
    }
  };
  const auto kept = [&] { return editor::loadSettings(folder / "config/settings.json").settings; };
  desk.settings.left_width = 300;
  pass();
  ASSERT_EQ(kept().left_width, 300);
  {
    const FullDisk full;
    desk.settings.light = true;
    pass();
    EXPECT_NE(session.notices.error.find("cannot be kept"), std::string::npos) << session.notices.error;
  }
  EXPECT_FALSE(kept().light);
  desk.settings.left_width = 310;
  pass();
  EXPECT_EQ(kept().left_width, 310);
  EXPECT_TRUE(kept().light) << "it was not on the disk yet";
}

TEST(Library, NamesLoseTheirEndingAndFilesAreReadOnceForEachChange) {
  EXPECT_EQ(editor::bareName("/x/v1.2.npsee.json"), "v1.2");
  EXPECT_EQ(editor::bareName("ridge.mission.json"), "ridge");
  EXPECT_EQ(editor::bareName("odd.json"), "odd");
  EXPECT_EQ(editor::bareName(".npsee.json"), ".npsee");
  const test::TemporaryFolder folder;
  editor::Library library;
  const std::string file = folder / "a.npsee.json";
  EXPECT_FALSE(library.entry(file).readable);
  Preset preset;
  preset.title = "one";
  ASSERT_TRUE(savePreset(preset, file).has_value());
  EXPECT_EQ(library.entry(file).title, "one");
  preset.title = "two";
  ASSERT_TRUE(savePreset(preset, file).has_value());
  EXPECT_EQ(library.entry(file).title, "two");
}

TEST(OpeningAnother, ForgetsWhatWasSaidAboutTheLayersOfTheLast) {
  const test::TemporaryFolder folder;
  editor::Session session({.library = {}, .wait_for_compile = true});
  session.update(0.0);
  ASSERT_TRUE(session.document.saveAs(folder / "a.npsee.json").has_value());
  session.design.solo = {"fragments"};
  session.design.locked = {"fragments.speed_mean"};
  session.keepForComparing();
  session.open(folder / "a.npsee.json");
  session.update(0.0);
  EXPECT_TRUE(session.design.solo.empty());
  EXPECT_TRUE(session.design.locked.empty());
  EXPECT_FALSE(session.compare.on());
  EXPECT_EQ(session.alive(), session.explosion()->particleCount());
}

TEST(Shelf, SaysWhyAPresetCannotBeShown) {
  auto bad = std::make_shared<Preset>();
  bad->layers.emplace_back();
  bad->layers[0].speed_mean_mps = -1.0;
  editor::Shelf shelf;
  shelf.request({bad});
  EXPECT_EQ(shelf.fault(0), "");
  shelf.poll(true);
  EXPECT_NE(shelf.fault(0).find("speed_mean"), std::string::npos) << shelf.fault(0);
  EXPECT_EQ(shelf.fault(7), "");
}

TEST(Figures, PiecesHaveTheEnergyOfTheirMassAndOthersThatOfAKilogram) {
  const auto fragments = test::cut(test::modelOf(test::boxObj({0, 0, 0}, {1, 2, 1})), 4, 500.0);
  test::HandMade made;
  for (int i = 0; i < 4; ++i) made.add(Form::pieces, {}, 1.0, {}, 1.0, {3.0, 0.0, 4.0});
  made.layers[0].pieces = fragments;
  made.add(Form::sphere, {}, 1.0, {}, 1.0, {0.0, 6.0, 0.0});
  made.add(Form::sphere, {}, 1.0, {}, 1.0, {0.0, 8.0, 0.0});
  const auto figures = editor::figuresOf(made.frame, made.layers);
  EXPECT_EQ(figures.alive, 6u);
  EXPECT_EQ(figures.massive, 4u);
  EXPECT_NEAR(figures.energy_J, 0.5 * 2.0 * 500.0 * 25.0, 1e-6 * 12500.0) << "two cubic metres of 500 kg each at 5 m/s";
  EXPECT_NEAR(figures.energy_Jpkg, 0.25 * (36.0 + 64.0), 1e-5);
  EXPECT_NEAR(editor::figuresOf(made.frame).energy_Jpkg, 0.5 * (4 * 25.0 + 36.0 + 64.0) / 6.0, 1e-5) << "without layers nothing has a mass";
}

/// A preset with a model of its own beside it.
class OwnModel : public DeskScript {
 protected:
  std::string withModel() {
    Preset preset;
    preset.title = "box";
    Layer layer;
    layer.name = "box";
    layer.form = Form::pieces;
    layer.pieces_model = "box.obj";
    layer.count = 8;
    preset.layers.push_back(layer);
    fs::create_directories(folder_ / "made");
    fs::create_directories(folder_ / "out");
    test::spill(folder_ / "made/box.obj", test::boxObj({-1, 0, -1}, {1, 2, 1}));
    EXPECT_TRUE(savePreset(preset, folder_ / "made/box.npsee.json").has_value());
    return folder_ / "made/box.npsee.json";
  }
  std::string exported(const std::string& name, const std::string& open = "key ctrl+E\n", const std::string& size = "96x54") {
    return open + "click \"field:export size\"\nkey ctrl+A\ntype " + size + "\nclick \"field:export file\"\nkey ctrl+A\ntype " + name + "\nclick \"field:export folder\"\nkey ctrl+A\ntype " + std::string(folder_ / "out") + "\n";
  }
};

TEST_F(OwnModel, GoesWithExportsCommandLinesAndThumbnails) {
  const std::string file = withModel();
  // A new layer cannot be said with --set, so that the line names a copy.
  const auto result = start("click \"button:tour skip\"\nset time 0.2\nexpect particles = 8\nclick \"button:add layer\"\n" + exported("a.png") +
                                "click button:export\nsettle\nexpect error =\nclick \"button:copy command line\"\nprint clipboard\nkey ctrl+Z\n", file);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string bytes = test::slurp(folder_ / "out/a.png");
  ASSERT_FALSE(bytes.empty());
  fs::remove(folder_ / "out/a.png");
  const std::size_t line = result.out.rfind("clipboard=npsee ") + 16;
  const auto again = test::run("/bin/sh", {"-c", test::npseePath() + ' ' + result.out.substr(line, result.out.find('\n', line) - line)});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(test::slurp(folder_ / "out/a.png") == bytes);
  auto listing = arguments("settle\nexpect visible preset:box\n", "");
  listing.insert(listing.end(), {"--library", folder_ / "made"});
  EXPECT_EQ(test::npseeRun(listing, environment()).exit_code, 0);
  std::size_t pictures = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "cache/npsee/thumbnails")) {
    EXPECT_EQ(entry.path().extension(), ".png") << entry.path();
    ++pictures;
  }
  EXPECT_EQ(pictures, 1u);
}

TEST_F(OwnModel, GoesWithItsColoursAndAsItIsNow) {
  const std::string file = withModel();
  const auto paint = [&](const std::string& colour) {
    test::spill(folder_ / "made/box.mtl", "newmtl red\nKd " + colour + "\n");
    test::spill(folder_ / "made/box.obj", "mtllib box.mtl\nusemtl red\n" + test::boxObj({-1, 0, -1}, {1, 2, 1}));
  };
  const auto copied = [&](const std::string& edit, const std::string& name) {
    const auto result = start("wait 2\nset time 0.2\nexpect particles = 8\n" + edit + exported(name) + "click button:export\nsettle\nexpect error =\nclick \"button:copy command line\"\nprint clipboard\nkey ctrl+Z\n", file);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::size_t line = result.out.rfind("clipboard=npsee ") + 16;
    return result.out.substr(line, result.out.find('\n', line) - line);
  };
  remembers("click \"button:tour skip\"\nwait 70\n");
  paint("1 0 0");
  // The line of a preset without changes names the file itself, with everything beside it.
  const std::string direct = copied("", "a.png"), bytes = test::slurp(folder_ / "out/a.png");
  EXPECT_NE(direct.find(file), std::string::npos) << direct;
  ASSERT_FALSE(bytes.empty());
  fs::remove(folder_ / "out/a.png");
  EXPECT_EQ(test::run("/bin/sh", {"-c", test::npseePath() + ' ' + direct}).exit_code, 0);
  EXPECT_TRUE(test::slurp(folder_ / "out/a.png") == bytes) << "an export has the colours";
  const std::string red = copied("click \"button:add layer\"\n", "b.png");
  paint("0 0 1");
  const std::string blue = copied("click \"button:add layer\"\n", "c.png");
  const auto recipe = [](const std::string& line) { return line.substr(0, line.find(".npsee.json")); };
  EXPECT_NE(recipe(red), recipe(blue)) << "other models, another recipe";
  EXPECT_FALSE(test::slurp(folder_ / "out/b.png") == test::slurp(folder_ / "out/c.png"));
  std::size_t libraries = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "state/npsee/recipes")) libraries += entry.path().filename() == "box.mtl";
  EXPECT_EQ(libraries, 2u);
}

TEST_F(OwnModel, HasAnotherThumbnailAfterAChangeOfItsColoursAlone) {
  const std::string file = withModel();
  test::spill(folder_ / "made/box.obj", "mtllib box.mtl\nusemtl red\n" + test::boxObj({-1, 0, -1}, {1, 2, 1}));
  editor::Thumbnails thumbnails(folder_ / "cache", test::npseePath());
  const auto picture = [&](const std::string& colour) {
    test::spill(folder_ / "made/box.mtl", "newmtl red\nKd " + colour + "\n");
    thumbnails.lookAgain();
    thumbnails.picture(file);
    thumbnails.update(true);
    return thumbnails.picture(file);
  };
  const fs::path grey = thumbnails.picture(file), red = picture("1 0 0"), blue = picture("0 0 1.0");
  ASSERT_FALSE(red.empty());
  ASSERT_FALSE(blue.empty());
  EXPECT_NE(red, blue);
  EXPECT_FALSE(test::slurp(red.string()) == test::slurp(blue.string()));
}

TEST_F(OwnModel, IsFoundWhenUnsavedWorkIsBroughtBackAndSavedElsewhere) {
  const std::string file = withModel();
  remembers("click \"button:tour skip\"\nset box.count 6\nwait 40\nexpect autosaved = yes\n", file);
  remembers("expect unsaved = 1\nclick \"button:bring back\"\nwait 2\nexpect error =\nexpect particles = 6\nkey ctrl+shift+S\nclick \"field:file name\"\nkey ctrl+A\ntype " + std::string(folder_ / "out/kept") + "\nkey Enter\nexpect dirty = no\nexpect error =\n");
  EXPECT_TRUE(fs::exists(folder_ / "out/box.obj"));
  EXPECT_TRUE(loadPreset(folder_ / "out/kept.npsee.json").has_value());
  // Even where the file itself is gone.
  remembers("set box.count 5\nwait 40\n", file);
  fs::remove(file);
  remembers("click \"button:bring back\"\nwait 2\nexpect error =\nexpect particles = 5\n");
}

TEST_F(OwnModel, AnExportAsksBeforeItReplacesAFile) {
  fs::create_directories(folder_ / "out");
  test::spill(folder_ / "out/a.png", "mine");
  passes("set time 0.2\n" + exported("a.png") + "click button:export\nexpect exports = 0\nexpect visible button:export\nwait 2\n", std::vector<std::string>{});
  EXPECT_EQ(test::slurp(folder_ / "out/a.png"), "mine");
  passes("set time 0.2\n" + exported("a.png") + "click button:export\nclick button:export\nexpect exports = 1\nsettle\nexpect error =\n", std::vector<std::string>{});
  EXPECT_NE(test::slurp(folder_ / "out/a.png"), "mine");
}

TEST_F(OwnModel, QuittingWhileAnExportIsAtWorkAsks) {
  fs::create_directories(folder_ / "out");
  const std::string large = exported("large_%04d.png", "click menu:Export\nclick \"item:Export sequence\"\n", "1920x1080, 60 fps") + "click button:export\nexpect exporting = 1\n";
  passes(large + "key ctrl+Q\nexpect question = yes\nexpect quitting = no\nexpect visible \"button:quit when done\"\nkey Escape\nexpect question = no\nexpect exporting = 1\n"
                 "key ctrl+Q\nkey ctrl+Delete\nexpect quitting = no\nkey Delete\nexpect quitting = no\nkey ctrl+Z\nhover strip:question\nkey Delete\nexpect quitting = yes\n");
  passes("set time 0.2\n" + exported("small.png") + "click button:export\nkey ctrl+Q\nkey Enter\nsettle\nwait 3\nexpect quitting = yes\nexpect exporting = 0\n");
  EXPECT_TRUE(fs::exists(folder_ / "out/small.png"));
}

TEST_F(OwnModel, WithoutAFolderForTemporaryFilesAnExportIsRefusedAndEditingGoesOn) {
  fs::create_directories(folder_ / "out");
  auto environment = this->environment();
  environment["TMPDIR"] = folder_ / "no such";
  const auto result = test::npseeRun(arguments("click \"button:tour skip\"\nset time 0.2\n" + exported("a.png") + "click button:export\nexpect exports = 0\nexpect error contains TMPDIR\nexpect error contains \"no such\"\nset fragments.speed_mean 61\nkey ctrl+S\nexpect dirty = no\n", preset()), environment);
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

std::size_t foldersIn(const fs::path& folder) { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator())); }

TEST_F(OwnModel, WhatAKilledEditorLeavesOfAnExportGoesWithTheNext) {
  fs::create_directories(folder_ / "out");
  fs::create_directories(folder_ / "tmp");
  auto environment = this->environment();
  environment["TMPDIR"] = folder_ / "tmp";
  const std::string skip = "click \"button:tour skip\"\n", large = exported("large_%04d.png", "click menu:Export\nclick \"item:Export sequence\"\n", "1920x1080, 60 fps") + "click button:export\nexpect exporting = 1\n";
  test::Running killed(test::npseePath(), arguments(skip + large + "print exporting\nwait 36000\n", preset()), environment);
  EXPECT_EQ(killed.readLines(1), "exporting=1\n");
  EXPECT_EQ(foldersIn(folder_ / "tmp"), 1u);
  killed.kill();
  EXPECT_EQ(foldersIn(folder_ / "tmp"), 1u) << "nobody could tidy up";
  const auto next = test::npseeRun(arguments("set time 0.2\n" + exported("small.png") + "click button:export\nsettle\nexpect error =\n", preset()), environment);
  EXPECT_EQ(next.exit_code, 0) << next.err;
  EXPECT_EQ(foldersIn(folder_ / "tmp"), 0u);
}

TEST(WorkFolder, IsKeptWhileItIsUsedAndRemovedAfterwards) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "npsee-export-abcdef/models");
  test::spill(folder / "npsee-export-abcdef/models/a.obj", "v 0 0 0\n");
  test::spill(folder / "npsee-export-file", "no folder");
  fs::create_directory(folder / "another");
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", folder.path().c_str(), 1);
  {
    auto first = editor::WorkFolder::make();
    ASSERT_TRUE(first.has_value()) << first.error().text();
    EXPECT_FALSE(fs::exists(folder / "npsee-export-abcdef"));
    auto second = editor::WorkFolder::make();
    ASSERT_TRUE(second.has_value());
    EXPECT_TRUE(fs::is_directory(first->path())) << "it is at work";
    EXPECT_TRUE(fs::is_directory(second->path()));
    const editor::WorkFolder moved = std::move(*first);
    EXPECT_TRUE(fs::is_directory(moved.path()));
  }
  EXPECT_EQ(foldersIn(folder.path()), 2u) << "the file and the other folder are somebody else's";
  ::setenv("TMPDIR", (folder / "no such").c_str(), 1);
  const auto refused = editor::WorkFolder::make();
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::output);
  if (before != nullptr) ::setenv("TMPDIR", kept.c_str(), 1);
  else ::unsetenv("TMPDIR");
}

TEST_F(OwnModel, AVideoIsExportedOrItsReasonTold) {
  fs::create_directories(folder_ / "out");
  passes(exported("a.mp4", "click menu:Export\nclick \"item:Export video\"\n", "96x54, 5 fps") + "click button:export\nsettle\nexpect error =\nexpect note contains a.mp4\n");
  EXPECT_GT(fs::file_size(folder_ / "out/a.mp4"), 500u);
}

}  // namespace
}  // namespace npsee
