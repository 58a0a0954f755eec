// Every command of the menus: its key, its place in the cheat sheet, and that it does what it says.

#include "editor/panels/actions.h"
#include "editor/script/parser.h"
#include "tests/editor/desk_script.h"
#include "tests/support/small_mission.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace npsee {
namespace {

using editor::WorkMode;
using test::DeskScript;

constexpr std::array kModes{WorkMode::explosion, WorkMode::mission};

std::vector<editor::Action> actionsOf(WorkMode mode) {
  std::vector<editor::Action> out;
  for (const editor::Action& action : editor::actions())
    if (!action.only || *action.only == mode) out.push_back(action);
  return out;
}

TEST(Shortcuts, MeanOneThingInEachMode) {
  for (const WorkMode mode : kModes) {
    std::map<std::string, std::string> keys;
    const auto add = [&](std::string_view key, std::string_view what) {
      const auto stroke = editor::parseKeyStroke(key);
      ASSERT_TRUE(stroke.has_value()) << key;
      const auto [known, fresh] = keys.emplace(editor::keyText(*stroke), what);
      EXPECT_TRUE(fresh) << key << ": " << known->second << " and " << what;
    };
    for (const editor::Action& action : actionsOf(mode))
      if (!action.shortcut.empty()) add(action.shortcut, action.label);
    if (mode == WorkMode::explosion)
      for (const editor::CameraKeyInfo& info : editor::cameraKeys()) add(info.key, info.doc);
    else
      for (const char* key : {"W", "A", "S", "D"}) add(key, "drives");
  }
}

TEST(Shortcuts, AreTheSameInBothModesForTheSameCommand) {
  for (const editor::Action& one : actionsOf(WorkMode::explosion))
    for (const editor::Action& other : actionsOf(WorkMode::mission)) {
      if (one.label != other.label) continue;
      EXPECT_EQ(one.shortcut, other.shortcut) << one.label;
    }
}

TEST(Commands, HaveDifferentNamesAndSomethingToDo) {
  for (const WorkMode mode : kModes) {
    std::set<std::string_view> labels;
    for (const editor::Action& action : actionsOf(mode)) {
      EXPECT_TRUE(labels.insert(action.label).second) << action.label;
      EXPECT_NE(action.run, nullptr) << action.label;
    }
  }
}

/// What a script does before a command, and what holds after it.
struct Case {
  const char *label, *before, *after;
};

const std::vector<Case> kInExplosions{
    {"Frame all", "key Right\nkey Right\nnote\n", "expect eye.x != noted\n"},
    {"From the front", "note\n", "expect eye.z > 10\n"},
    {"From the side", "", "expect eye.x > 10\n"},
    {"From above", "", "expect eye.y > 20\nexpect visible axis:x\nexpect visible axis:z\n"},
    {"From behind", "", "expect eye.z < -10\n"},
    {"From the left", "", "expect eye.x < -10\n"},
    {"Template as splines", "", "expect template.view = splines\n"},
    {"Template as polygons", "", "expect template.view = polygons\n"},
    {"Template as surface", "", "expect template.view = surface\n"},
    {"Left panels", "", "expect hidden template\nkey F2\nwait 2\nexpect visible template\n"},
    {"Right panels", "", "expect hidden field:search\nkey F5\nwait 2\nexpect visible field:search\n"},
    {"Light theme", "", "expect theme = light\nclick menu:View\nclick \"item:Light theme\"\nkey Escape\nexpect theme = dark\n"},
    {"Add layer", "", "expect layers = 2\n"},
    {"Duplicate layer", "", "expect layers = 3\n"},
    {"Move layer up", "", "expect undo.label = Move layer\nnote\n"},
    {"Move layer down", "", "expect undo = 4\n"},
    {"Rename layer", "", "expect typing = layer name\nkey Escape\n"},
    {"Copy layer", "clipboard nothing\n", "expect clipboard contains layers\n"},
    {"Cut layer", "", "expect layers = 2\n"},
    {"Paste", "", "expect layers = 3\n"},
    {"Delete layer", "", "expect layers = 2\n"},
    {"Show alone", "", "expect solo = 1\n"},
    {"Show all layers", "", "expect solo = 0\n"},
    {"Play or pause", "", "expect playing = yes\n"},
    {"Go to the burst", "key Space\n", "expect time = 0\n"},
    {"Step on", "note\n", "expect time > noted\n"},
    {"Step back", "note\n", "expect time < noted\n"},
    {"Slower", "note\n", "expect speed < noted\n"},
    {"Faster", "note\n", "expect speed > noted\n"},
    {"Loop", "expect loop = yes\n", "expect loop = no\nkey L\n"},
    {"Next mark", "key 0\n", "expect time > 0\n"},
    {"Previous mark", "", "expect time = 0\n"},
    {"Loop from here", "set time 0.4\n", "expect loop.from = 0.4\n"},
    {"Loop to here", "set time 0.8\n", "expect loop.to = 0.8\n"},
    {"Loop everything", "", "expect loop.to = 0\n"},
    {"Onion skin", "", "expect overlays contains onion\nkey N\n"},
    {"Trails", "", "expect overlays contains trails\nkey T\n"},
    {"Speed arrows", "", "expect overlays contains speed\nkey V\n"},
    {"Figures", "", "expect overlays contains figures\nexpect visible figures\nkey K\nexpect overlays =\n"},
    {"Randomise layer", "note\n", "expect undo.label = Randomise\nexpect undo > noted\n"},
    {"Randomise all layers", "note\n", "expect undo > noted\n"},
    {"Vary seed", "note\n", "expect seed != noted\n"},
    {"Variations", "", "expect variations = yes\nexpect visible variation:5\nkey shift+V\n"},
    {"Keep state as A", "", "expect compare.name = kept state\nkey C\nexpect compare = off\n"},
    {"Compare A and B", "", "expect compare = split\n"},
    {"Flip A and B", "", "expect compare = flip\nexpect compare.flipped = yes\n"},
    {"Swap A and B", "set fragments.speed_mean 31\nnote\n", "expect undo.label = Swap A and B\nkey X\nkey X\nclick \"button:end comparing\"\nexpect compare = off\n"},
    {"Unlock all parameters", "rightclick row:fragments.speed_mean\nclick \"item:Lock against randomising\"\nexpect locked = 1\n", "expect locked = 0\n"},
    {"Extent box", "expect extent = no\n", "expect extent = yes\nkey B\n"},
    {"Ground grid", "", "expect grid = no\nkey G\n"},
    {"Ruler", "", "expect ruling = yes\nkey M\n"},
    {"Keep bookmark 1", "key 1\n", "expect note contains Ctrl+1\n"},
    {"Keep bookmark 2", "key 2\n", "expect note contains Ctrl+2\n"},
    {"Keep bookmark 3", "key 3\n", "expect note contains Ctrl+3\n"},
    {"Keep bookmark 4", "key 4\n", "expect note contains Ctrl+4\nkey Right\n"},
    {"Go to bookmark 1", "", "expect eye.z > 10\n"},
    {"Go to bookmark 2", "", "expect eye.x > 10\n"},
    {"Go to bookmark 3", "", "expect eye.y > 20\n"},
    {"Go to bookmark 4", "", "expect eye.z < -10\n"},
    {"Draft quality", "", "expect quality = draft\n"},
    {"Normal quality", "", "expect quality = normal\n"},
    {"Fine quality when still", "", "expect quality = fine\n"},
    {"Automatic quality", "", "expect quality = automatic\n"},
    {"Expose longer", "", "expect exposure > 0.3\n"},
    {"Expose shorter", "key shift+E\n", "expect exposure < -0.3\n"},
    {"Usual exposure", "", "expect exposure = 0\n"},
    {"Export picture", "", "expect sheet = export\nexpect export = picture\n"},
    {"Export sequence", "", "expect export = sequence\n"},
    {"Export contact sheet", "", "expect export = contact sheet\n"},
    {"Export sprite sheet", "", "expect export = sprite sheet\n"},
    {"Export video", "", "expect export = video\n"},
    {"Copy command line", "clipboard nothing\n", "expect clipboard contains \"npsee render\"\n"},
    {"History", "", "expect sheet = history\n"},
    {"Find command or parameter", "", "expect sheet = find\nkey Escape\n"},
    {"Messages", "", "expect sheet = messages\nkey Escape\n"},
    {"First steps", "", "expect tour = 1\nclick \"button:tour skip\"\n"},
    {"Keys and mouse", "", "expect visible \"button:close help\"\nkey F1\n"},
    {"Undo", "note\n", "expect undo < noted\n"},
    {"Redo", "note\n", "expect undo > noted\n"},
    {"Save", "expect dirty = yes\n", "expect dirty = no\n"},
    {"Save as", "", "expect files = save as\n"},
    {"Open", "click \"button:close files\"\n", "expect files = open\nclick \"button:close files\"\n"},
    {"Mission mode", "", "expect mode = mission\nkey F6\nexpect mode = explosion\n"},
    {"New", "", "expect file =\nexpect window.title = untitled\n"},
    {"Quit", "", "expect quitting = yes\n"},
};

const std::vector<Case> kInMissions{
    {"Frame all", "click \"toggle:camera orbit\"\nwheel 5\nnote\n", "expect distance != noted\n"},
    {"Show the selected", "click vehicle:t72-1\nnote\n", "expect target.x != noted\n"},
    {"Free camera", "", "expect camera = free\n"},
    {"Orbit camera", "", "expect camera = orbit\n"},
    {"Follow the shell", "", "expect camera = follow\n"},
    {"At the gun", "", "expect camera = gun\n"},
    {"The observer's eye", "click observer:fo1\n", "expect camera = observer\n"},
    {"Plan camera", "", "expect camera = plan\n"},
    {"Left panels", "", "expect hidden plan\nkey F2\nwait 2\nexpect visible plan\n"},
    {"Right panels", "", "expect hidden tab:Fire\nkey F5\nwait 2\n"},
    {"Light theme", "", "expect theme = light\nclick menu:View\nclick \"item:Light theme\"\nkey Escape\nexpect theme = dark\n"},
    {"Draft quality", "", "expect quality = draft\n"},
    {"Normal quality", "", "expect quality = normal\n"},
    {"Fine quality when still", "", "expect quality = fine\n"},
    {"Automatic quality", "", "expect quality = automatic\n"},
    {"Expose longer", "", "expect exposure > 0.3\n"},
    {"Expose shorter", "key shift+E\n", "expect exposure < -0.3\n"},
    {"Usual exposure", "", "expect exposure = 0\n"},
    {"Play or pause", "", "expect playing = yes\n"},
    {"Go to the start", "key Space\n", "expect time = 0\n"},
    {"Step on", "note\n", "expect time > noted\n"},
    {"Step back", "note\n", "expect time < noted\n"},
    {"Next event", "note\n", "expect time > noted\n"},
    {"Event before", "key shift+Period\nnote\n", "expect time < noted\n"},
    {"Slower", "note\n", "expect speed < noted\n"},
    {"Faster", "note\n", "expect speed > noted\n"},
    {"Take over", "click vehicle:t72-1\n", "expect selected.taken = yes\nkey T\n"},
    {"Ruler", "", "expect ruling = yes\n"},
    {"Cancel", "", "expect ruling = no\n"},
    {"Add observer", "", "click plan\nexpect selected = fo2\n"},
    {"Add gun", "", "click plan\nexpect selected.kind = gun\n"},
    {"Duplicate", "click vehicle:t72-1\nnote\n", "expect undo > noted\n"},
    {"Delete", "note\n", "expect undo > noted\n"},
    {"History", "", "expect sheet = history\n"},
    {"Find command or parameter", "", "expect sheet = find\nkey Escape\n"},
    {"Messages", "", "expect sheet = messages\nkey Escape\n"},
    {"Keys and mouse", "", "expect visible \"button:close help\"\nkey F1\n"},
    {"Undo", "note\n", "expect undo < noted\n"},
    {"Redo", "note\n", "expect undo > noted\n"},
    {"Save", "expect dirty = yes\n", "expect dirty = no\n"},
    {"Save as", "", "expect files = save as\n"},
    {"Open", "click \"button:close files\"\n", "expect files = open\nclick \"button:close files\"\n"},
    {"Mission mode", "", "expect mode = explosion\nkey F6\nexpect mode = mission\n"},
    {"New", "", "expect file =\nexpect vehicles = 0\n"},
    {"Quit", "", "expect quitting = yes\n"},
};

std::string throughThePalette(const std::vector<Case>& cases) {
  std::string out;
  for (const Case& one : cases) {
    out += std::string(one.before) + "key ctrl+P\n";
    // It opens over another sheet, and closes where it is open already.
    out += "type " + std::string(one.label) + "\nwait 2\nclick \"found:" + one.label + "\"\nwait 2\n" + one.after;
  }
  return out;
}

void expectAll(const std::vector<Case>& cases, WorkMode mode) {
  std::set<std::string> tried, known;
  for (const Case& one : cases) tried.insert(one.label);
  for (const editor::Action& action : actionsOf(mode)) known.insert(std::string(action.label));
  for (const std::string& label : known) EXPECT_TRUE(tried.contains(label)) << label << " is tried by no test";
  for (const std::string& label : tried) EXPECT_TRUE(known.contains(label)) << label << " is no command";
}

TEST_F(DeskScript, EachCommandOfTheExplosionModeWorksFromThePalette) {
  expectAll(kInExplosions, WorkMode::explosion);
  remembers("click \"button:tour skip\"\nset time 0.5\n" + throughThePalette(kInExplosions), preset());
}

TEST_F(DeskScript, EachCommandOfTheMissionModeWorksFromThePalette) {
  expectAll(kInMissions, WorkMode::mission);
  ASSERT_TRUE(saveScenario(test::smallMission(), folder_ / "small.mission.json").has_value());
  remembers(throughThePalette(kInMissions), folder_ / "small.mission.json");
}

TEST_F(DeskScript, TheCheatSheetShowsEachCommandOfItsMode) {
  for (const WorkMode mode : kModes) {
    const auto result = run(std::string(mode == WorkMode::mission ? "key F6\n" : "") + "key F1\nwait 2\nprint items\n");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const editor::Action& action : actionsOf(mode)) EXPECT_NE(result.out.find(" key:" + std::string(action.label) + '\n'), std::string::npos) << action.label;
  }
}

}  // namespace
}  // namespace npsee
