#include "editor/desk/exports.h"
#include "editor/desk/thumbnails.h"
#include "editor/panels/desk/view_tools.h"
#include "tests/editor/desk_script.h"

#include <npsee/preset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace npsee {
namespace {

using test::DeskScript;

std::size_t filesIn(const std::string& folder, const std::string& ending) {
  std::error_code none;
  return static_cast<std::size_t>(std::ranges::count_if(std::filesystem::directory_iterator(folder, none), [&](const auto& entry) { return entry.path().string().ends_with(ending); }));
}

std::string after(const std::string& text, const std::string& start) {
  const std::size_t at = text.rfind(start);
  if (at == std::string::npos) return {};
  return text.substr(at + start.size(), text.find('\n', at) - at - start.size());
}

TEST(Settings, BetweenPresetsLeadFromOneToTheOther) {
  const auto from = loadPreset(std::string(NPSEE_SOURCE_DIR) + "/presets/cascade.npsee.json");
  ASSERT_TRUE(from.has_value());
  Preset to = *from;
  to.title = "it's \"new\", 100 %";
  to.wind_mps = {1.0, 0.1, -2.5};
  to.layers[0].speed_mean_mps = 1.0 / 3.0;
  to.layers.back().colour_over_life = {{0.0, {1.0, 0.5, 0.25}}, {0.75, {0.1, 0.2, 0.3}}};
  to.layers.back().size_over_life = {{0.0, 0.3}, {1.0, 2.0}};
  const auto settings = editor::settingsBetween(*from, to);
  ASSERT_TRUE(settings.has_value());
  EXPECT_EQ(settings->size(), 5u);
  Preset reached = *from;
  for (const std::string& setting : *settings) ASSERT_TRUE(applySetting(reached, setting).has_value()) << setting;
  EXPECT_EQ(reached, to);
  to.layers.pop_back();
  EXPECT_FALSE(editor::settingsBetween(*from, to).has_value()) << "layers cannot be set";
}

TEST(ShellLine, IsReadBackByAShell) {
  const std::vector<std::string> words{"/bin/echo", "plain", "with space", "it's", "a\"b", "$HOME", "#10141e", "eye=1,2,3 target=0,0,0", "", "*"};
  const auto echoed = test::run("/bin/sh", {"-c", "for w in " + editor::shellLine(words) + "; do printf '%s\\n' \"$w\"; done"});
  std::string wanted;
  for (const std::string& word : words) wanted += word + '\n';
  EXPECT_EQ(echoed.out, wanted);
}

TEST(ViewTools, WhatIsUnderAPointOfThePictureIsShownThere) {
  const render::Camera camera{{12.0, 9.0, 30.0}, {1.0, 4.0, -2.0}};
  const editor::Box box{{100.0f, 50.0f}, 900.0f, 500.0f};
  for (double x = -8.0; x <= 8.0; x += 4.0)
    for (double z = -8.0; z <= 8.0; z += 4.0) {
      const Vec3 ground{x, 0.5, z};
      const auto at = editor::placeInPicture(camera, box, ground);
      ASSERT_TRUE(at.has_value());
      EXPECT_LT(length(editor::placeUnder(camera, box, *at, 0.5) - ground), 0.01) << x << ' ' << z;
    }
  const auto middle = editor::placeInPicture(camera, box, camera.target);
  EXPECT_NEAR(static_cast<double>(middle->x), 550.0, 0.01);
  EXPECT_NEAR(static_cast<double>(middle->y), 300.0, 0.01);
  EXPECT_FALSE(editor::placeInPicture(camera, box, camera.eye + 2.0 * (camera.eye - camera.target)).has_value()) << "behind the eye";
  // Above the horizon: on the upright plane through the burst.
  const Vec3 high = editor::placeUnder(camera, box, {550.0f, 52.0f}, 0.0);
  EXPECT_GT(high.y, 5.0);
  EXPECT_NEAR(dot(high, Vec3{camera.target.x - camera.eye.x, 0.0, camera.target.z - camera.eye.z}), 0.0, 1e-6);
}

TEST_F(DeskScript, TheLibrarySearchesTagsAndKeepsFavourites) {
  remembers(R"(click "button:tour skip"
click field:library
type peony
expect visible preset:firework_peony
expect hidden preset:air_burst
key ctrl+A
key Backspace
key Escape
click choice:tag
click choice:tag=firework
expect visible preset:firework_willow
expect hidden preset:air_burst
click choice:tag
click choice:tag=
click preset:air_burst
click button:favourite:air_burst
click button:favourite:cascade
expect favourites = 2
click "toggle:library Favourites"
expect visible preset:cascade
expect hidden preset:classic_1993
click "toggle:library Recent"
expect visible preset:air_burst
wait 70
)");
  remembers(R"(expect favourites = 2
expect recent contains air_burst
click "toggle:library Favourites"
click button:favourite:cascade
expect hidden preset:cascade
expect favourites = 1
)");
}

TEST_F(DeskScript, ThumbnailsAreRenderedOnceForEachStateOfAPreset) {
  const std::string library = folder_ / "library", file = library + "/mine.npsee.json";
  std::filesystem::create_directories(library);
  std::filesystem::copy_file(classic(), file);
  const auto look = [&](const std::string& picture) {
    auto words = arguments("wait 2\nsettle\nwait 2\nsave " + picture + "\n", "");
    words.insert(words.end(), {"--library", library, "--time", "0.5"});
    const auto result = test::npseeRun(words, environment());
    EXPECT_EQ(result.exit_code, 0) << result.err;
  };
  const std::string cache = folder_ / "cache/npsee/thumbnails";
  remembers("click \"button:tour skip\"\nwait 70\n");
  look(folder_ / "1.png");
  EXPECT_EQ(filesIn(cache, ".png"), 1u);
  look(folder_ / "2.png");
  EXPECT_EQ(filesIn(cache, ".png"), 1u);
  Preset changed = *loadPreset(file);
  changed.ground_colour = {0.9, 0.2, 0.2};
  ASSERT_TRUE(savePreset(changed, file).has_value());
  look(folder_ / "3.png");
  EXPECT_EQ(filesIn(cache, ".png"), 2u) << "another state, another picture";
  EXPECT_EQ(filesIn(cache, ".json"), 0u);
  // Bytes of pictures are no reading matter for a report.
  EXPECT_TRUE(test::slurp(folder_ / "1.png") == test::slurp(folder_ / "2.png"));
  EXPECT_FALSE(test::slurp(folder_ / "1.png") == test::slurp(folder_ / "3.png"));
}

TEST_F(DeskScript, TheLibraryFollowsItsFolder) {
  const std::string library = folder_ / "library";
  std::filesystem::create_directories(library);
  std::filesystem::copy_file(classic(), library + "/mine.npsee.json");
  passes("wait 70\nexpect visible preset:mine\nexpect hidden preset:other\nkey ctrl+shift+S\nclick \"field:file name\"\nkey ctrl+A\ntype " + library + "/other\nkey Enter\nexpect files = closed\nwait 70\nexpect visible preset:other\n",
         {"--library", library});
}

TEST_F(DeskScript, DroppedFilesAreOpened) {
  test::spill(folder_ / "notes.txt", "x");
  passes("drop " + std::string(NPSEE_SOURCE_DIR) + "/presets/air_burst.npsee.json\nexpect window.title = air_burst\ndrop " + (folder_ / "notes.txt") +
         "\nexpect error contains \"notes.txt is neither a preset nor a mission\"\ndrop " + folder_.path() + "\nexpect files = open\nexpect visible file:work.npsee.json\n");
}

/// What a script types to set an export up.
std::string exportTo(const std::string& folder, const std::string& size) {
  return "click \"field:export size\"\nkey ctrl+A\ntype " + size + "\nkey Enter\nclick \"field:export folder\"\nkey ctrl+A\ntype " + folder + "\nkey Enter\n";
}

TEST_F(DeskScript, TheCopiedCommandLineMakesTheExportedPictureByteForByte) {
  for (const std::string change : {"set fragments.speed_mean 61\nset title it's \"new\"\n", "click \"button:add layer\"\n"}) {
    std::filesystem::create_directories(folder_ / "out");
    const auto result = start("click \"button:tour skip\"\nset time 0.7\n" + change + "drag viewport 60 20\nkey ctrl+E\nexpect sheet = export\n" + exportTo(folder_ / "out", "160x90") +
                                  "click button:export\nexpect exports = 1\nsettle\nexpect error =\nexpect note contains Exported\nclick \"button:copy command line\"\nexpect error =\nprint clipboard\n",
                              preset());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string line = after(result.out, "clipboard=npsee "), exported = folder_ / "out/work.png";
    ASSERT_FALSE(line.empty()) << result.out;
    const std::string bytes = test::slurp(exported);
    ASSERT_FALSE(bytes.empty());
    std::filesystem::remove(exported);
    const auto again = test::run("/bin/sh", {"-c", test::npseePath() + ' ' + line});
    EXPECT_EQ(again.exit_code, 0) << line << again.err;
    EXPECT_TRUE(test::slurp(exported) == bytes) << line;
    EXPECT_EQ(loadPreset(in("work.npsee.json")).value(), loadPreset(classic()).value()) << "nothing was saved for it";
    std::filesystem::remove(exported);
    std::filesystem::remove_all(folder_ / "state");
    std::filesystem::remove_all(folder_ / "config");
  }
}

TEST_F(DeskScript, ExportsOfEveryKindAreMadeBesideTheEditing) {
  std::filesystem::create_directories(folder_ / "out");
  passes("set time 0.2\nclick menu:Export\nclick \"item:Export sequence\"\n" + exportTo(folder_ / "out", "64x36, 5 fps") +
         "click button:export\nset fragments.speed_mean 61\nexpect fragments.speed_mean = 61 m/s\nclick menu:Export\nclick \"item:Export contact sheet\"\n" + exportTo(folder_ / "out", "64x36, 2x2") +
         "click button:export\nclick menu:Export\nclick \"item:Export sprite sheet\"\n" + exportTo(folder_ / "out", "32x32, 2x2") +
         "click button:export\nexpect exports = 3\nsettle\nexpect exporting = 0\nexpect error =\nclick \"button:clear exports\"\nexpect exports = 0\n");
  EXPECT_GT(filesIn(folder_ / "out", ".png"), 20u);
  for (const char* name : {"work_sheet.png", "work_sprites.png", "work_sprites.json"}) EXPECT_TRUE(std::filesystem::exists(folder_ / ("out/" + std::string(name)))) << name;
}

TEST_F(DeskScript, WhatWasWrittenForAnExportStaysAndWhatWasProposedFollows) {
  const std::string air = std::string(NPSEE_SOURCE_DIR) + "/presets/air_burst.npsee.json", copy = "click \"button:copy command line\"\n";
  std::filesystem::create_directories(folder_ / "other");
  std::filesystem::copy_file(air, folder_ / "other/air.npsee.json");
  const std::string to = "expect clipboard contains \"-o " + folder_.path();
  passes("key ctrl+E\n" + copy + to + "/work.png\"\n"
         "click choice:export\nclick choice:export=video\n" + copy + to + "/work.mp4\"\nexpect clipboard contains \"--fps 30 \"\n"
         "click \"field:export size\"\nkey ctrl+A\ntype 640x360, 29.97 fps\nkey Enter\n"
         "drop " + (folder_ / "other/air.npsee.json") + "\nexpect window.title = air\n" + copy + to + "/other/air.mp4\"\nexpect clipboard contains \"--fps 29.97 \"\n"
         "click \"field:export file\"\nkey ctrl+A\ntype take.mp4\nkey Enter\nclick choice:export\nclick choice:export=sequence\n" + copy + to + "/other/take_%04d.png\"\n"
         "expect clipboard contains \"--fps 29.97 \"\nexpect clipboard contains \"--size 640x360 \"\n"
         "click \"field:export folder\"\nkey ctrl+A\ntype " + folder_.path() + "/typed\nkey Enter\ndrop " + preset() + "\nexpect window.title = work\n" + copy + to + "/typed/take_%04d.png\"\n");
}

TEST_F(DeskScript, TheExportSheetSaysThatLayersNotShownAreExportedToo) {
  passes("click \"button:add layer\"\nkey ctrl+E\nwait 2\nexpect hidden \"export:all layers\"\nclick button:solo:fragments\nexpect solo = 1\nexpect visible \"export:all layers\"\nsave " + in("sheet.png") + "\n");
}

TEST_F(DeskScript, AnExportIsCancelledAndAFailedOneSaysWhy) {
  std::filesystem::create_directories(folder_ / "out");
  passes("click menu:Export\nclick \"item:Export sequence\"\n" + exportTo(folder_ / "out", "1920x1080, 60 fps") +
         "click button:export\nexpect exporting = 1\nclick \"button:cancel export 0\"\nsettle\nexpect exporting = 0\nexpect note contains Cancelled\n" + exportTo(folder_ / "nowhere", "64x36, 5 fps") +
         "click button:export\nsettle\nexpect error contains \"was not made\"\nexpect error contains nowhere\nclick \"field:export size\"\nkey ctrl+A\ntype wide\nclick button:export\nexpect exports = 2\n");
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out")) EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST_F(DeskScript, ViewsBookmarksDistanceRulerAndOverlays) {
  passes(R"(note
key 4
expect eye.z < -5
key 5
expect eye.x < -5
key ctrl+shift+2
note
key F
expect eye.x != noted
key ctrl+2
expect eye.x = noted
expect eye.z = noted
doubleclick number:distance
type 40 m
key Enter
expect distance > 39.999
expect distance < 40.001
drag number:distance 30
expect distance > 41
key M
click viewport
mouse 640 600
press
release
wait 3
expect ruler.length > 1
key M
expect ruler.length = 0
key B
expect extent = yes
click toggle:grid
expect grid = no
click toggle:view
click item:Night
click "item:Draft quality"
expect background = #10141e
expect quality = draft
wait 2
expect drawn = draft
)");
}

TEST_F(DeskScript, TheTourHasAtMostFiveHintsAndIsShownOnce) {
  std::string script = "expect tour = 1\n";
  for (int i = 2; i <= 5; ++i) script += "click \"button:tour next\"\nexpect tour = " + std::to_string(i) + "\n";
  remembers(script + "click \"button:tour next\"\nexpect tour = 0\nwait 70\n");
  remembers("expect tour = 0\nclick menu:Help\nclick \"item:First steps\"\nexpect tour = 1\n");
  passes("expect tour = 0\n");
}

}  // namespace
}  // namespace npsee
