#include "tests/editor/editor_script.h"

#include <cstdlib>

namespace npsee {
namespace {

using test::EditorScript;

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

TEST_F(EditorScript, EditingKeepsTheMoment) {
  passes("set time 1.25\ndrag fragments.speed_mean 25\nexpect time = 1.25\nexpect dirty = yes\nset fragments.count 500\nexpect time = 1.25\nexpect particles = 500\n");
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

}  // namespace
}  // namespace npsee
