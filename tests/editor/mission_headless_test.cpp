#include "tests/editor/editor_script.h"
#include "tests/support/small_mission.h"

#include <algorithm>
#include <string>

namespace npsee {
namespace {

const std::string kMissions = std::string(NPSEE_SOURCE_DIR) + "/assets/missions/";

/// The mission mode driven by scripts through the real command line.
class MissionScript : public test::ScriptedEditor {
 protected:
  /// The small mission, in a file of its own.
  std::string small(const Scenario& scenario = test::smallMission()) {
    EXPECT_TRUE(saveScenario(scenario, folder_ / "small.mission.json").has_value());
    return folder_ / "small.mission.json";
  }
};

TEST_F(MissionScript, OpensSimulatesAndShowsAMission) {
  passes("expect mode = mission\nexpect vehicles = 2\nexpect guns = 2\nexpect observers = 1\nexpect finished = yes\nexpect shots > 0\nexpect time = 0\nexpect error =\n"
         "expect visible vehicle:t72-1\nexpect visible observer:fo1\nexpect visible battery:battery\nexpect visible event:1\n",
         small());
}

TEST_F(MissionScript, ScrubbingShowsTheRecordingAtThatMomentHoweverItIsReached) {
  passes("set time 30\nset time 7.5\nwait 2\nsave " + in("there.png") + "\nset time 25\nkey Space\nwait 20\nkey Space\nset time 7.5\nmouse 5 5\nwait 2\nsave " + in("again.png") + "\n", small());
  const auto there = picture("there.png"), again = picture("again.png");
  // The viewport and the plan; the log below stays where it was scrolled to.
  int different = 0;
  for (int y = 80; y < 600; ++y)
    for (int x = 0; x < there.width; ++x) different += std::equal(there.pixel(x, y), there.pixel(x, y) + 4, again.pixel(x, y)) ? 0 : 1;
  EXPECT_EQ(different, 0);
  passes("drag time 60 0\nexpect time > 0\nexpect playing = no\n", small());
}

TEST_F(MissionScript, AClickOnAnEventGoesToItsMoment) {
  passes("click event:3\nnote\nexpect event.number >= 3\nclick tab:Shots\nclick shot:1\nexpect time > noted\nexpect playing = no\nkey shift+Period\nexpect time > noted\nclick \"button:event back\"\n", small());
}

TEST_F(MissionScript, PlayingPausesAtEventsOfTheChosenKinds) {
  passes("click \"choice:pause at\"\nclick pause:fire\nkey Escape\nclick button:play\nwait 900\nexpect playing = no\nexpect event contains fires\nexpect note contains Paused\n", small());
}

TEST_F(MissionScript, DraggingAVehicleInThePlanMovesItInOneUndoStep) {
  passes("set time 0\ndrag plan:t72-1 -30 12\nexpect selected = t72-1\nexpect selected.x < 7000\nexpect selected.z > 5000\nexpect undo = 1\nexpect dirty = yes\nexpect error =\n"
         "key ctrl+Z\nexpect selected.x = 7000\nexpect selected.z = 5000\nexpect dirty = no\nkey ctrl+shift+Z\nexpect selected.x < 7000\n",
         small());
}

TEST_F(MissionScript, ThingsArePlacedDuplicatedAndDeletedByClicks) {
  passes("click \"button:add object\"\nclick item:Observer\nclick plan\nexpect selected = fo2\nexpect observers = 2\nclick \"button:duplicate object\"\nexpect selected = fo3\nkey ctrl+Delete\nexpect observers = 2\n"
         "click menu:Mission\nclick \"item:Add gun\"\nclick plan\nexpect selected.kind = gun\nexpect guns = 3\nkey ctrl+Z\nkey ctrl+Z\n",
         small());
}

TEST_F(MissionScript, ParametersAreTypedAndTheMissionFollows) {
  passes("note\nset fo1.max_range 500\nexpect selected = fo1\nexpect shots = 0\nexpect undo = 1\nset fo1.sensing.location_cep 150 m\nset world.weather.visibility 3 km\nset duration 60\nexpect duration = 60\n"
         "set battery.preset air_burst\nkey ctrl+S\nexpect dirty = no\n",
         small());
  const auto saved = loadScenario(folder_ / "small.mission.json");
  ASSERT_TRUE(saved.has_value());
  EXPECT_EQ(saved->observers[0].max_range_m, 500.0);
  EXPECT_EQ(saved->observers[0].sensing.location_cep_m, 150.0);
  EXPECT_EQ(saved->world.weather.visibility_m, 3000.0);
  EXPECT_EQ(saved->batteries[0].preset, "air_burst");
}

TEST_F(MissionScript, AWrongValueIsRefusedWithItsLimit) {
  const auto result = run("set duration -5\n", small());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("duration"), std::string::npos) << result.err;
  const auto unknown = run("set fo1.max_rage 5\n", small());
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_NE(unknown.err.find("fo1.max_range"), std::string::npos) << "the nearest is named: " << unknown.err;
}

TEST_F(MissionScript, APersonTakesTheObserverCallsAndCorrectsFire) {
  Scenario scenario = test::smallMission();
  scenario.observers[0].human = true;
  passes("click observer:fo1\nclick tab:Fire\nclick button:take\nexpect camera = observer\nexpect live = yes\nset call.x 7000\nset call.z 4850\nclick \"button:call for fire\"\nclick button:play\nwait 120\nexpect \"open missions\" = 1\n"
         "click speed\nclick speed:8\nwait 300\nexpect rounds = 1\nset correct.right 100\nset correct.add -50\nclick button:correct\nexpect correct.right = 0\nwait 60\nexpect graded = 1\n"
         "click \"button:fire for effect\"\nwait 300\nclick \"button:end mission\"\nwait 10\nexpect \"open missions\" = 0\nclick button:release\nwait 10\nexpect live = no\nexpect error =\n",
         small(scenario));
}

TEST_F(MissionScript, AGroupIsPlacedByAClickAndEachOfItsVehiclesCanBeSelected) {
  passes("click \"button:add object\"\nclick \"item:Ten vehicles at random\"\nclick plan\nexpect selected.kind = group\nexpect selected = group1\nexpect vehicles = 12\nexpect undo = 1\nexpect error =\n"
         "click vehicle:group1-3\nexpect selected = group1-3\nexpect selected.kind = vehicle\nset group1.count 4\nexpect vehicles = 6\nexpect undo = 2\nclick tab:State\nexpect error =\n",
         small());
}

TEST_F(MissionScript, TheArrowKeysMoveEveryCameraInItsOwnWay) {
  passes("click \"toggle:camera free\"\nnote\nkey Up\nexpect eye.z < noted\nexpect target.z < noted\nkey Down\nexpect eye.z = noted\nkey Right\nexpect eye.x > noted\nkey Home\nexpect eye.y > noted\n"
         "click \"toggle:camera orbit\"\nnote\nkey Right\nexpect yaw > noted\nkey Up\nexpect pitch > noted\nkey Home\nexpect distance < noted\n"
         "click \"toggle:camera plan\"\nnote\nkey Right\nexpect target.x > noted\nkey Home\nexpect span < noted\n"
         "click observer:fo1\nclick \"toggle:camera observer\"\nnote\nkey Home\nexpect field < noted\n",
         small());
}

TEST_F(MissionScript, APlaceKeepsWhenItIsSaidInAnotherWay) {
  // 1500 m east and 200 m north of the observer.
  passes("click observer:fo1\nclick tab:Fire\nclick button:take\nset call.x 7000\nset call.z 5000\nclick \"toggle:by polar\"\nexpect call.distance = 1513\nexpect call.azimuth = 1465\n"
         "set call.distance 3026\nclick \"toggle:by grid\"\nexpect call.x > 8498\nexpect call.x < 8502\nexpect call.z > 4798\nexpect call.z < 4802\nexpect error =\n",
         small());
}

TEST_F(MissionScript, EachMissionUnderWayHasACorrectionOfItsOwn) {
  Scenario scenario = test::smallMission();
  scenario.observers[0].human = true;
  passes("click observer:fo1\nclick tab:Fire\nclick button:take\nset call.x 7000\nset call.z 4850\nclick \"button:call for fire\"\nclick button:play\nwait 60\nset call.x 6500\nclick \"button:call for fire\"\nwait 60\n"
         "expect \"open missions\" = 2\nset correct.1.right 70\nset correct.add -50\nexpect correct.right = 0\nexpect correct.add = -50\nclick \"button:end mission\"\nwait 30\n"
         "expect \"open missions\" = 1\nexpect correct.right = 70\nexpect correct.add = 0\nexpect error =\n",
         small(scenario));
}

TEST_F(MissionScript, TheReticleGivesTheCallItsDirectionAndDistance) {
  Scenario scenario = test::smallMission();
  scenario.observers[0].human = true;
  passes("click observer:fo1\nclick tab:Fire\nclick button:take\nexpect camera = observer\nset call.x 1000\nset call.z 1000\nclick \"toggle:from the reticle\"\n"
         // The glass looks over the tank, which is 1513 m off along 1466 mil, at the ground behind it.
         "expect call.distance > 1400\nexpect call.distance < 4000\nexpect call.azimuth > 1440\nexpect call.azimuth < 1490\nexpect call.x > 6900\nexpect error =\n",
         small(scenario));
}

TEST_F(MissionScript, BurstsShowThePresetThatIsBeingEditedWhereThatIsAskedFor) {
  passes("click tab:Shots\nclick shot:1\nkey Period\nwait 2\nset time 40\nset time 21.2\nclick \"toggle:camera follow\"\nsave " + in("own.png") + "\nclick button:show\nclick \"toggle:my burst\"\nkey Escape\nwait 2\nsave " + in("mine.png") + "\nexpect error =\n", small());
  EXPECT_NE(picture("own.png").rgba, picture("mine.png").rgba);
}

TEST_F(MissionScript, AVehicleIsDrivenByTheKeyboard) {
  passes("click vehicle:t72-1\nkey T\nexpect selected.taken = yes\nclick button:play\nnote\nhold shift\nkey W\nlet shift\nwait 120\nexpect selected.speed > 0\nkey A\nwait 30\nkey S\nwait 240\nexpect selected.speed = 0\nkey T\nwait 3\nexpect live = no\n", small());
}

TEST_F(MissionScript, TheRulerReadsDistanceAndSight) {
  passes("key M\nclick gun:gun1\nmouse 5 5\nclick plan\nexpect ruler = 1\nmouse 60 700\npress\nrelease\nexpect ruler = 2\nexpect ruler.distance > 100\nexpect ruler.clear = yes\nexpect visible profile\nkey Escape\n", small());
}

TEST_F(MissionScript, EveryCameraAndOverlayDraws) {
  std::string script = "set time 14\nclick observer:fo1\n";
  for (const char* camera : {"free", "orbit", "follow", "gun", "observer", "plan"}) script += std::string("click \"toggle:camera ") + camera + "\"\nexpect camera = " + camera + "\nsave " + in(std::string(camera) + ".png") + "\n";
  script += "key 2\nexpect camera = orbit\nclick button:show\nclick \"toggle:sight fan\"\nclick \"toggle:range rings\"\nclick toggle:trajectories\nkey Escape\nsave " + in("overlays.png") + "\nexpect error =\n";
  passes(script, small());
  EXPECT_NE(picture("orbit.png").rgba, picture("plan.png").rgba);
  EXPECT_NE(picture("orbit.png").rgba, picture("overlays.png").rgba);
}

TEST_F(MissionScript, AnEmptyWorldIsShownAndCanBeFilled) {
  Scenario empty;
  empty.duration_s = 10.0;
  empty.world.size_x_m = empty.world.size_z_m = 1000.0;
  passes("expect vehicles = 0\nexpect error =\nclick \"toggle:camera follow\"\nclick \"toggle:camera gun\"\nclick \"toggle:camera observer\"\nsave " + in("empty.png") + "\nclick button:play\nwait 30\nclick \"button:add object\"\nclick item:T-72\nclick plan\nexpect vehicles = 1\n", small(empty));
}

TEST_F(MissionScript, ABrokenMissionFileIsAMessageWithFileAndLine) {
  test::spill(folder_ / "broken.mission.json", "{\n  \"npsee_mission\": 1,\n  \"vehicels\": []\n}\n");
  const auto result = run("wait 1\n", folder_ / "broken.mission.json");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("broken.mission.json:3"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("vehicles"), std::string::npos) << result.err;
  // From within the editor it is a strip, and what was open stays.
  passes("key ctrl+O\nclick \"field:file name\"\ntype broken.mission.json\nkey Enter\nexpect error contains vehicels\nexpect mode = mission\nexpect vehicles = 2\nexpect visible strip:error\n", small());
}

TEST_F(MissionScript, AMissionThatNamesABrokenThingShowsWhy) {
  Scenario scenario = test::smallMission();
  scenario.batteries[0].weapon = 999;
  passes("expect error contains 999\nexpect events = 0\nset battery.weapon 110\nclick button:dismiss\nexpect error =\nexpect shots > 0\n", small(scenario));
}

TEST_F(MissionScript, TheModesAreSwitchedAndEachKeepsItsDocument) {
  passes("click mode:Explosion\nexpect mode = explosion\nexpect window.title = untitled\nexpect particles > 0\nkey F6\nexpect mode = mission\nexpect window.title = small\nclick tab:Missions\nclick tab:Objects\n", small());
}

TEST_F(MissionScript, TheShippedMissionsAreListedAndOpenByAClick) {
  passes("click tab:Missions\nclick mission:ridge_high_angle\nexpect window.title = ridge_high_angle\nexpect shots > 0\nexpect error =\nset time 30\nclick \"toggle:camera follow\"\nsave " + in("ridge.png") + "\n", kMissions + "thesis_default.mission.json");
}

TEST_F(MissionScript, AnotherMissionIsPutIntoViewInThePlanToo) {
  passes("click tab:Missions\nclick mission:foggy_night\nexpect visible plan:t72-near\nexpect visible plan:fo1\nkey ctrl+N\nexpect mode = mission\nexpect vehicles = 0\nclick mission:ridge_low\nexpect visible plan:fo1\nexpect error =\n", small());
}

TEST_F(MissionScript, FactsOfTheThesisAreShownAndWrittenIntoTheMissionToBeChanged) {
  passes("expect guns = 4\nexpect error =\nclick gun:gun1\nexpect selected.kind = gun\nclick button:adopt\nexpect undo = 1\nexpect dirty = yes\nset gun1.pos 17000,16000\nexpect selected.x = 17000\n", kMissions + "thesis_default.mission.json");
}

TEST_F(MissionScript, TheSmallestWindowAndATwiceScaledOneHoldTheirPanels) {
  for (const auto& more : {std::vector<std::string>{"--size", "1024x640"}, std::vector<std::string>{"--size", "2400x1500", "--scale", "2"}})
    passes("set time 12\nclick observer:fo1\nclick tab:Fire\nexpect visible button:take\nexpect visible viewport\nexpect visible plan\nexpect visible time\nexpect visible tab:Events\nexpect visible button:play\nexpect visible speed\n", small(), more);
}

}  // namespace
}  // namespace npsee
