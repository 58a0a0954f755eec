#include "app/render/image.h"
#include "tests/support/process.h"

#include <npsee/preset.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace npsee {
namespace {

const std::string kClassic = std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json";

/// A scripted session in a folder of its own, through the real command line.
class EditorScript : public testing::Test {
 protected:
  test::ProcessResult run(const std::string& script, const std::vector<std::string>& more = {}) {
    test::spill(folder_ / "script.txt", script);
    std::vector<std::string> arguments{"edit", preset(), "--headless", "--script", folder_ / "script.txt"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::npseeRun(arguments);
  }
  void passes(const std::string& script, const std::vector<std::string>& more = {}) {
    const auto result = run(script, more);
    EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  }
  /// A copy, so that scripts may save.
  std::string preset() {
    std::filesystem::create_directories(folder_ / below_);
    const std::string copy = in("work.npsee.json");
    if (!std::filesystem::exists(copy)) std::filesystem::copy_file(kClassic, copy);
    return copy;
  }
  render::Image picture(const std::string& name) {
    auto image = render::readPng(folder_ / name);
    EXPECT_TRUE(image.has_value()) << name;
    return image ? std::move(*image) : render::Image{};
  }
  std::string in(const std::string& name) { return folder_ / (below_ + name); }

  std::string below_;  ///< where the document lies in the folder
  test::TemporaryFolder folder_;
};

/// Pixels that differ by more than 8 in a channel inside a box of the picture.
int differing(const render::Image& a, const render::Image& b, int x0, int y0, int x1, int y1) {
  int count = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const auto *p = a.pixel(x, y), *q = b.pixel(x, y);
      for (int c = 0; c < 3; ++c)
        if (std::abs(p[c] - q[c]) > 8) {
          ++count;
          break;
        }
    }
  return count;
}

TEST_F(EditorScript, DraggingTheEjectionAngleChangesTheValueAndTheTemplate) {
  passes("set time 0.8\nnote\nsave " + in("a.png") + "\ndrag fragments.ejection_angle -40\nexpect fragments.ejection_angle < 45\nexpect fragments.ejection_angle > 1\nsave " + in("b.png") + "\n");
  const auto a = picture("a.png"), b = picture("b.png");
  ASSERT_EQ(a.width, 1440);
  ASSERT_EQ(b.height, 900);
  EXPECT_GT(differing(a, b, 12, 530, 240, 810), 300) << "the template, lower left";
  EXPECT_GT(differing(a, b, 260, 40, 1060, 810), 50) << "the explosion";
}

TEST_F(EditorScript, OneDragIsOneUndoStepAndUndoClearsTheMark) {
  passes(R"(expect dirty = no
expect visible title:saved
drag fragments.ejection_angle 30
expect undo = 1
expect undo.label = Ejection angle
expect dirty = yes
expect visible title:unsaved
drag fragments.speed_mean 20
expect undo = 2
key ctrl+Z
key ctrl+Z
expect fragments.ejection_angle = 50deg
expect fragments.speed_mean = 15
expect dirty = no
key ctrl+shift+Z
expect fragments.ejection_angle > 50
click menu:Edit
click item:Redo
expect undo = 2
)");
}

TEST_F(EditorScript, ValuesAreTypedWithAnyFittingUnit) {
  passes(R"(doubleclick value:fragments.speed_mean
expect typing = fragments.speed_mean
type 216 km/h
key Enter
expect fragments.speed_mean = 60
expect typing =
doubleclick slider:fragments.ejection_angle
type 0.5 rad
key Enter
expect fragments.ejection_angle = 0.5 rad
expect undo = 2
doubleclick value:fragments.speed_mean
type 70
key Escape
expect fragments.speed_mean = 60
doubleclick value:fragments.speed_mean
type 9000
key Enter
expect error contains above the limit of 3000 m/s
expect fragments.speed_mean = 60
expect visible strip:error
key Escape
click button:dismiss
expect hidden strip:error
doubleclick number:wind.x
type 36 km/h
key Enter
expect wind = 10,0,0
click button:reset:wind
expect wind = 0,0,0
)");
}

TEST_F(EditorScript, ShiftDragsTenTimesFinerAndControlClickTypes) {
  passes(R"(set fragments.ejection_angle 45
drag fragments.ejection_angle 40
expect fragments.ejection_angle > 60
key ctrl+Z
hold shift
drag fragments.ejection_angle 40
let shift
expect fragments.ejection_angle > 45
expect fragments.ejection_angle < 50
hold ctrl
click slider:fragments.ejection_angle
let ctrl
expect typing = fragments.ejection_angle
type 30
key Enter
expect fragments.ejection_angle = 30
)");
}

TEST_F(EditorScript, AClickOnTheTrackJumpsThereAndADoubleClickDoesNot) {
  passes(R"(set fragments.ejection_angle 10
click slider:fragments.ejection_angle
expect fragments.ejection_angle >= 44
expect fragments.ejection_angle <= 46
expect undo = 2
key ctrl+Z
doubleclick slider:fragments.ejection_angle
key Escape
wait 40
expect fragments.ejection_angle = 10
expect undo = 1
)");
}

TEST_F(EditorScript, StandardViewsLookAlongTheAxes) {
  passes("key 1\nexpect eye.z > 10\nkey 3\nexpect eye.y > 10\nnote\nkey 2\nexpect eye.y < noted\n");
}

TEST_F(EditorScript, ThousandsOfRandomInputsBreakNothing) {
  const char* const keys[] = {"Up", "KP8", "Home", "Space", "F", "1", "L", "Period", "F1", "F2", "F5", "Escape", "Enter", "Delete", "Tab", "ctrl+Z", "ctrl+shift+Z", "ctrl+D", "ctrl+N", "ctrl+O",
                              "ctrl+S", "ctrl+shift+S", "ctrl+Q", "ctrl+Delete", "ctrl+shift+N", "alt+Up", "alt+Down", "Backspace", "ctrl+A"};
  const char* const texts[] = {"1", "1e9", "-", "nan", "name", "12 cm", "{}", "'", "\xc3\xa4\xe2\x82\xac", "[[0,1],[1,0]]"};
  below_ = "a/b/c/d/";  // so that no random walk through the folders leaves the test's own
  for (unsigned seed = 1; seed <= 4; ++seed) {
    unsigned state = seed * 2654435761u;
    const auto draw = [&state](unsigned limit) {
      state = state * 1664525u + 1013904223u;
      return (state >> 8) % limit;
    };
    std::string script;
    for (int i = 0; i < 900; ++i) {
      const unsigned kind = draw(12);
      if (kind < 5) script += "mouse " + std::to_string(draw(1024)) + ' ' + std::to_string(draw(640)) + "\npress\n" + (draw(3) == 0 ? "mouse " + std::to_string(draw(1024)) + ' ' + std::to_string(draw(640)) + '\n' : "") + "release\n";
      else if (kind == 5) script += "press right\nrelease right\n";
      else if (kind == 6) script += "wheel " + std::to_string(static_cast<int>(draw(9)) - 4) + '\n';
      else if (kind == 7) script += "press\nrelease\npress\nrelease\n";
      else if (kind < 10) script += "key " + std::string(keys[draw(std::size(keys))]) + '\n';
      else script += "type " + std::string(texts[draw(std::size(texts))]) + '\n';
    }
    const auto result = run(script, {"--size", "1024x640", "--library", folder_.path(), "--screenshot", in("end.png")});
    EXPECT_EQ(result.exit_code, 0) << "seed " << seed << '\n' << result.err;
  }
}

TEST_F(EditorScript, EveryKindOfWidgetSetsItsParameter) {
  passes(R"(click toggle:fragments.outward
expect fragments.outward = false
click choice:fragments.region.shape
click choice:fragments.region.shape=ring
expect fragments.region.shape = ring
drag fragments.count 10
expect fragments.count != 100
drag number:fragments.direction.x 30
expect fragments.direction != 0,1,0
doubleclick number:fragments.direction.z
type -1
key Enter
click value:fragments.colour
type #336699
key Enter
expect fragments.colour = #336699
click life:fragments.size_over_life
click button:add:fragments.size_over_life
click button:add:fragments.size_over_life
expect fragments.size_over_life = [[0,1],[1,1]]
doubleclick number:fragments.size_over_life.1.value
type 0.25
key Enter
expect fragments.size_over_life = [[0,1],[1,0.25]]
click button:delete:fragments.size_over_life.0
expect fragments.size_over_life = [[1,0.25]]
click text:title
type A title with words
key Enter
expect title = A title with words
)");
}

TEST_F(EditorScript, EveryThesisKeyMovesTheCameraAsPrinted) {
  passes(R"(note
key Up
expect eye.z < noted
expect eye.x = noted
expect target.z = noted
key Down
expect eye.z = noted
key Down
expect eye.z > noted
note
key Left
expect eye.x > noted
key Right
key Right
expect eye.x < noted
note
key Home
expect eye.y > noted
expect target.y = noted
key End
key End
expect eye.y < noted
note
key KP8
expect target.y > noted
expect eye.y = noted
key KP2
key KP2
expect target.y < noted
note
key KP4
expect target.x < noted
expect eye.x = noted
key KP6
key KP6
expect target.x > noted
key F
note
key F
expect eye.x = noted
)");
}

TEST_F(EditorScript, TheMouseTurnsShiftsAndDolliesTheView) {
  passes(R"(note
drag viewport 80 30
expect eye.x != noted
expect target.x = noted
expect undo = 0
note
mouse 600 400
press middle
mouse 660 420
release middle
expect target.x != noted
note
wheel 2
expect distance < noted
wheel -4
expect distance > noted
)");
}

TEST_F(EditorScript, TheTemplatesRightMouseMenuChoosesItsView) {
  passes(R"(expect template.view = surface
rightclick template
click item:Splines
expect template.view = splines
rightclick template
click item:Polygons
expect template.view = polygons
note
mouse 40 780
press
mouse 70 770
release
expect template.yaw != noted
expect dirty = no
)");
}

TEST_F(EditorScript, DraggingTheTemplatesHandlesSetsItsParametersInOneStepEach) {
  passes(R"(note
drag handle:rim -25 -8
expect fragments.ejection_angle != noted
expect undo = 1
drag handle:top 0 -20
expect fragments.speed_mean > noted
expect undo = 2
drag handle:foot -12 0
expect fragments.region.radius != noted
expect undo = 3
expect template.yaw = noted
key ctrl+Z
key ctrl+Z
key ctrl+Z
expect dirty = no
hover handle:rim
)");
}

TEST_F(EditorScript, TheTimeLinePlaysPausesStepsScrubsAndLoops) {
  passes(R"(expect playing = yes
wait 30
expect time >= 0.4
expect time < 0.8
key Space
expect playing = no
note
wait 10
expect time = noted
key Period
expect time > noted
key Comma
key Comma
expect time < noted
click button:to end
note
expect alive = 0
click button:to start
expect time = 0
drag thumb:time 300
expect time > 1
expect playing = no
click speed
click speed:0.25
expect speed = 0.25
note
click button:play
wait 60
expect time > noted
click button:loop
expect loop = no
)");
}

TEST_F(EditorScript, EditingKeepsTheMoment) {
  passes("set time 1.25\ndrag fragments.speed_mean 25\nexpect time = 1.25\nexpect dirty = yes\nset fragments.count 500\nexpect time = 1.25\nexpect particles = 500\n");
}

TEST_F(EditorScript, LayersAreAddedDuplicatedRenamedDisabledAndDeleted) {
  passes(R"(click "button:add layer"
expect layers = 2
expect layer = layer
doubleclick layer:layer
type sparks
key Enter
expect layer = sparks
click "button:duplicate layer"
expect layer = sparks 2
expect particles = 300
click "button:enable:sparks 2"
expect "sparks 2.enabled" = false
expect particles = 200
click "button:delete layer"
expect layers = 2
click layer:fragments
expect layer = fragments
set sparks.parent fragments
expect sparks.trigger = birth
click "menu:Layer"
click "item:Delete layer"
expect layers = 1
)");
}

TEST_F(EditorScript, AnAddedLayerIsScrolledIntoView) {
  std::string script;
  for (int i = 0; i < 12; ++i) script += "key ctrl+shift+N\n";
  passes(script + "wait 2\nexpect layers = 13\nexpect layer = layer 12\nexpect visible layer:layer 12\nexpect hidden layer:fragments\nclick layer:fragments\nexpect layer = fragments\n");
}

TEST_F(EditorScript, SaveAndOpenRoundTrip) {
  passes(R"(set fragments.speed_mean 61
key ctrl+S
expect dirty = no
expect note contains Saved
set fragments.speed_mean 62
click menu:File
click "item:Save as"
click "field:file name"
type other
key Enter
expect files = closed
expect window.title = other
expect dirty = no
click menu:File
click item:Open
click file:work.npsee.json
click button:open
expect window.title = work
expect fragments.speed_mean = 61
expect undo = 0
)");
  const auto work = loadPreset(in("work.npsee.json")), other = loadPreset(in("other.npsee.json"));
  ASSERT_TRUE(work && other);
  EXPECT_EQ(work->layers[0].speed_mean_mps, 61.0);
  EXPECT_EQ(other->layers[0].speed_mean_mps, 62.0);
}

TEST_F(EditorScript, SavingOverAnotherFileAsksOnceMore) {
  test::spill(in("other.npsee.json"), "{\"npsee\": 1}");
  passes(R"(set fragments.speed_mean 64
key ctrl+shift+S
click "field:file name"
type other
key Enter
expect files = save as
expect dirty = yes
click "button:save as"
expect files = closed
expect window.title = other
)");
  EXPECT_EQ(loadPreset(in("other.npsee.json"))->layers.at(0).speed_mean_mps, 64.0);
}

TEST_F(EditorScript, AFieldThatIsLeftByItsLayerIsGivenUpAndFilesCanBeSavedFromWithinOne) {
  passes(R"(click "button:add layer"
doubleclick value:layer.speed_mean
type 77
key ctrl+S
expect dirty = no
click layer:fragments
expect typing =
expect fragments.speed_mean = 15
)");
}

TEST_F(EditorScript, EscapeClosesMenusAndTheLibraryOpensPresets) {
  passes(R"(click menu:File
expect visible item:Open
key Escape
expect hidden item:Open
click preset:air_burst
expect window.title = air_burst
expect burst = air
)");
}

TEST_F(EditorScript, UnsavedWorkIsAskedAboutBeforeQuittingAndBeforeOpening) {
  passes(R"(set fragments.speed_mean 61
key ctrl+Q
expect question = yes
expect quitting = no
expect visible strip:question
click button:cancel
expect question = no
expect dirty = yes
click menu:File
click item:New
expect question = yes
click button:discard
expect window.title = untitled
set fragments.speed_mean 63
key ctrl+Q
click button:save
expect files = save as
click "field:file name"
type kept.npsee.json
key Enter
expect quitting = yes
)");
  const auto kept = loadPreset(in("kept.npsee.json"));
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->layers[0].speed_mean_mps, 63.0);
}

TEST_F(EditorScript, AFileThatCannotBeReadIsAMessageInTheEditor) {
  test::spill(in("bad.npsee.json"), "{ not json");
  passes("key ctrl+O\nclick file:bad.npsee.json\nclick button:open\nexpect visible strip:error\nexpect error contains bad.npsee.json:1\nexpect window.title = work\n");
}

TEST_F(EditorScript, TheSameScriptGivesTheSameBytes) {
  const std::string script = "wait 40\ndrag fragments.speed_mean 15\nhover row:fragments.speed_mean\n";
  passes(script, {"--screenshot", in("a.png")});
  passes(script, {"--screenshot", in("b.png")});
  const std::string a = test::slurp(in("a.png"));
  EXPECT_GT(a.size(), 10000u);
  EXPECT_TRUE(a == test::slurp(in("b.png")));
}

TEST_F(EditorScript, EverySizeShowsTheWholeLayout) {
  for (const std::string size : {"1024x640", "1280x720", "1440x900", "1920x1080", "3840x2160"})
    passes("expect visible viewport\nexpect visible template\nexpect visible menu:Help\nexpect visible time\nexpect visible speed\nexpect visible field:search\nexpect visible layer:fragments\n"
           "expect visible \"button:add layer\"\nexpect visible title:saved\nset fragments.speed_mean 61\nkey ctrl+Q\nexpect visible button:save\nexpect visible button:cancel\n", {"--size", size});
}

TEST_F(EditorScript, SplittersResizeThePanels) {
  passes("drag splitter:left 40\ndrag splitter:right -40\ndrag splitter:template 0 60\nexpect visible viewport\nkey F2\nexpect hidden template\nkey F5\nexpect hidden field:search\nexpect visible viewport\n");
}

TEST_F(EditorScript, AnExpectationThatDoesNotHoldExitsOneWithScriptAndLine) {
  const auto result = run("wait 1\nexpect dirty = yes\nprint dirty\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("script.txt:2: dirty is \"no\", expected = \"yes\"."), std::string::npos) << result.err;
  EXPECT_EQ(result.out, "") << "the script stops there";
}

TEST_F(EditorScript, BadScriptsExitThreeWithFileLineAndTheNearestName) {
  const struct { const char *script, *message; } cases[] = {
      {"wait 1\nclik button:play\n", "script.txt:2: there is no command \"clik\".\n  Did you mean click?"},
      {"click button:pley\n", "script.txt:1: there is no item \"button:pley\".\n  Did you mean button:play?"},
      {"set fragments.speed_meen 3\n", "script.txt:1: there is no parameter \"fragments.speed_meen\".\n  Did you mean fragments.speed_mean?"},
      {"\n\nset fragments.speed_mean 9000\n", "script.txt:3: speed_mean is 9000 m/s, above the limit of 3000 m/s."},
      {"expect dirtie = no\n", "script.txt:1: there is no fact \"dirtie\".\n  Did you mean dirty?"},
      {"expect dirty is no\n", "script.txt:1: \"is\" is no comparison."},
      {"expect eye.x = noted\n", "script.txt:1: eye.x was not noted."},
      {"wait long\n", "script.txt:1: \"long\" is not a number."},
      {"press fifth\n", "script.txt:1: there is no mouse button \"fifth\"."},
      {"drag viewport far\n", "script.txt:1: the distance is not a number."},
  };
  for (const auto& [script, message] : cases) {
    const auto result = run(script);
    EXPECT_EQ(result.exit_code, 3) << script;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  }
}

TEST(EditCommand, BadOptionsExitTwoAndSayHowToMendThem) {
  const struct { std::vector<std::string> arguments; const char* message; } cases[] = {
      {{"edit", "--headless", "--screenshot", "x.png", "--size", "10x10"}, "--size 10x10 is not a size of a window."},
      {{"edit", "--headless", "--screenshot", "x.png", "--size", "wide"}, "--size wide is not a size of a window."},
      {{"edit", "--headless", "--screenshot", "x.png", "--time", "-1"}, "--time -1 is not a time."},
      {{"edit", "--headless", "--screenshot", "x.png", "--scale", "9"}, "--scale 9 is not a scale of the panels."},
      {{"edit", "--screenshot", "x.png"}, "Add --headless."},
      {{"edit", "--headless"}, "--headless alone has nothing to do."},
  };
  for (const auto& [arguments, message] : cases) {
    const auto result = test::npseeRun(arguments);
    EXPECT_EQ(result.exit_code, 2) << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  }
}

TEST(EditCommand, UnreadableInputsExitThreeAndUnwritablePicturesExitFive) {
  const test::TemporaryFolder folder;
  const auto missing = test::npseeRun({"edit", folder / "none.npsee.json", "--headless", "--screenshot", folder / "x.png"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_NE(missing.err.find("none.npsee.json"), std::string::npos);
  const auto script = test::npseeRun({"edit", "--headless", "--script", folder / "none.txt"});
  EXPECT_EQ(script.exit_code, 3);
  EXPECT_NE(script.err.find("none.txt"), std::string::npos);
  const auto library = test::npseeRun({"edit", "--headless", "--screenshot", folder / "x.png", "--library", folder / "nowhere"});
  EXPECT_EQ(library.exit_code, 3);
  EXPECT_NE(library.err.find("nowhere is no folder."), std::string::npos);
  const auto picture = test::npseeRun({"edit", "--headless", "--screenshot", folder / "no folder/x.png"});
  EXPECT_EQ(picture.exit_code, 5);
  EXPECT_NE(picture.err.find("x.png"), std::string::npos) << picture.err;
}

TEST(EditCommand, WithoutADisplayItSaysSoAndExitsFour) {
  const auto result = test::npseeRun({"edit", kClassic}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("cannot open a window: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("npsee render"), std::string::npos) << result.err;
}

TEST(EditCommand, HelpListsTheScriptLanguage) {
  const auto result = test::npseeRun({"edit", "--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* word : {"--headless", "--script", "drag ITEM DX [DY]", "expect FACT OP VALUE", "Examples:"}) EXPECT_NE(result.out.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace npsee
