#include "tests/editor/editor_script.h"

#include <iterator>
#include <string>

namespace npsee {
namespace {

using test::EditorScript;

TEST_F(EditorScript, StandardViewsLookAlongTheAxes) {
  passes("key 1\nexpect eye.z > 10\nkey 3\nexpect eye.y > 10\nnote\nkey 2\nexpect eye.y < noted\n");
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

TEST_F(EditorScript, EverySizeShowsTheWholeLayout) {
  for (const std::string size : {"1024x640", "1280x720", "1440x900", "1920x1080", "3840x2160"})
    passes("expect visible viewport\nexpect visible template\nexpect visible menu:Help\nexpect visible time\nexpect visible speed\nexpect visible field:search\nexpect visible layer:fragments\n"
           "expect visible \"button:add layer\"\nexpect visible title:saved\nset fragments.speed_mean 61\nkey ctrl+Q\nexpect visible button:save\nexpect visible button:cancel\n", {"--size", size});
}

TEST_F(EditorScript, SplittersResizeThePanels) {
  passes("drag splitter:left 40\ndrag splitter:right -40\ndrag splitter:template 0 60\nexpect visible viewport\nkey F2\nexpect hidden template\nkey F5\nexpect hidden field:search\nexpect visible viewport\n");
}

TEST_F(EditorScript, TheSameScriptGivesTheSameBytes) {
  const std::string script = "wait 40\ndrag fragments.speed_mean 15\nhover row:fragments.speed_mean\n";
  passes(script, {"--screenshot", in("a.png")});
  passes(script, {"--screenshot", in("b.png")});
  const std::string a = test::slurp(in("a.png"));
  EXPECT_GT(a.size(), 10000u);
  EXPECT_TRUE(a == test::slurp(in("b.png")));
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

}  // namespace
}  // namespace npsee
