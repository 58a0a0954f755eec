#include "editor/document/design.h"
#include "editor/document/life_presets.h"
#include "editor/document/session.h"
#include "editor/document/vary.h"
#include "tests/editor/editor_script.h"

#include <npsee/preset.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace npsee::editor {
namespace {

using test::EditorScript;

Preset shipped(const std::string& name) {
  auto preset = loadPreset(std::string(NPSEE_SOURCE_DIR) + "/presets/" + name + ".npsee.json");
  EXPECT_TRUE(preset.has_value());
  return preset ? *preset : Preset();
}

TEST(Vary, IsAPureFunctionThatStaysValidWithinSlidersAndKeepsWhatIsOff) {
  for (const char* name : {"classic_1993", "ground_burst_soil", "firework_crossette", "dense_fragments"}) {
    const Preset preset = shipped(name);
    for (std::uint64_t draw = 0; draw < 20; ++draw) {
      const Variation variation{1.0, draw};
      const Preset out = varied(preset, variation);
      EXPECT_EQ(out, varied(preset, variation));
      EXPECT_NE(out, preset);
      EXPECT_TRUE(validate(out).empty());
      for (std::size_t i = 0; i < preset.layers.size(); ++i)
        for (const Parameter& row : parameters(Scope::layer)) {
          const Value was = row.get(preset.layers[i]), is = row.get(out.layers[i]);
          if (!varies(row) || was == Value(0.0) || was == Value(std::int64_t{0})) {
            EXPECT_EQ(is, was) << row.key;
          }
          if (row.type != ParameterType::number) continue;
          const double low = std::min(row.slider.min, toUnit(row.unit, std::get<double>(was))), high = std::max(row.slider.max, toUnit(row.unit, std::get<double>(was)));
          EXPECT_GE(toUnit(row.unit, std::get<double>(is)), low * 0.999 - 1e-9) << row.key;
          EXPECT_LE(toUnit(row.unit, std::get<double>(is)), high * 1.001 + 1e-9) << row.key;
        }
    }
  }
}

TEST(Vary, TheAmountBoundsHowFarValuesGo) {
  const Preset preset = shipped("classic_1993");
  double furthest = 0.0;
  for (std::uint64_t draw = 0; draw < 200; ++draw) {
    const double speed = varied(preset, {0.2, draw}).layers[0].speed_mean_mps / preset.layers[0].speed_mean_mps;
    furthest = std::max(furthest, std::abs(std::log2(speed)));
  }
  // 2^(2 x 0.2) at most, rounded to three digits; 200 draws come near it.
  EXPECT_LT(furthest, 0.405);
  EXPECT_GT(furthest, 0.35);
}

TEST(Vary, LocksSectionsAndLayersAreKept) {
  Preset preset = shipped("classic_1993");
  preset.layers.push_back(preset.layers[0]);
  preset.layers[1].name = "others";
  const std::set<std::string> locked{preset.layers[0].name + ".ejection_angle"};
  const Preset out = varied(preset, {0.5, 3, 0, Section::launch, &locked});
  EXPECT_EQ(out.layers[0].ejection_angle_rad, preset.layers[0].ejection_angle_rad);
  EXPECT_NE(out.layers[0].speed_mean_mps, preset.layers[0].speed_mean_mps);
  EXPECT_EQ(out.layers[0].region_radius_m, preset.layers[0].region_radius_m) << "another section";
  for (std::size_t i = 1; i < preset.layers.size(); ++i) EXPECT_EQ(out.layers[i], preset.layers[i]);
}

TEST(Vary, NeverGoesOverTheParticleLimit) {
  Preset preset = shipped("classic_1993");
  preset.layers[0].count = kMaxParticles;
  for (std::uint64_t draw = 0; draw < 10; ++draw) EXPECT_TRUE(validate(varied(preset, {1.0, draw})).empty());
}

TEST_F(EditorScript, LocksAndLayersShownAloneFollowEveryRenaming) {
  passes(R"(click "button:add layer"
click layer:fragments
hover row:fragments.speed_mean
click button:lock:fragments.speed_mean
click button:solo:fragments
expect locked = 1
expect solo = 1
set fragments.name splinters
expect solo = 1
note
key D
expect splinters.speed_mean = noted
expect splinters.ejection_angle != noted
key ctrl+Z
key ctrl+Z
expect layer = fragments
expect solo = 1
note
key D
expect fragments.speed_mean = noted
expect fragments.ejection_angle != noted
)");
}

TEST(Design, RenamingALayerTakesItsLocksAlong) {
  Design design;
  design.locked = {"a.speed_mean", "ab.speed_mean"};
  design.solo = {"a"};
  design.rename("a", "new");
  EXPECT_EQ(design.locked, (std::set<std::string>{"new.speed_mean", "ab.speed_mean"}));
  EXPECT_TRUE(design.shows("new"));
  EXPECT_FALSE(design.shows("ab"));
}

TEST(LifePresets, AreAllAllowedByTheirParametersAndReverseTwiceIsTheSame) {
  for (const char* key : {"opacity_over_life", "size_over_life"}) {
    const Parameter& row = *findParameter(Scope::layer, key);
    EXPECT_GE(curvePresets(row).size(), 6u) << key;
    for (const auto& preset : curvePresets(row)) {
      EXPECT_EQ(checkValue(row, preset.course), "") << preset.name;
      for (const CurvePoint& point : reversed(preset.course)) EXPECT_NEAR(valueOf(preset.course, 1.0 - point.at), point.value, 1e-12);
    }
  }
  const Parameter& colour = *findParameter(Scope::layer, "colour_over_life");
  EXPECT_GE(gradientPresets(colour).size(), 8u);
  for (const auto& preset : gradientPresets(colour)) EXPECT_EQ(checkValue(colour, reversed(preset.course)), "") << preset.name;
}

TEST_F(EditorScript, PointsOfACurveAreAddedDraggedSnappedAndTakenAway) {
  passes(R"(set fragments.size_over_life [[0,1],[1,1]]
click life:fragments.size_over_life
click graph:fragments.size_over_life
expect fragments.size_over_life contains [0.5
expect undo = 2
drag point:fragments.size_over_life.1 40 -30
expect undo = 3
expect fragments.size_over_life != [[0,1],[0.5,1],[1,1]]
click "toggle:snap:fragments.size_over_life"
drag point:fragments.size_over_life.1 3 3
expect undo = 4
rightclick point:fragments.size_over_life.1
expect fragments.size_over_life = [[0,1],[1,1]]
expect undo = 5
click point:fragments.size_over_life.1
key Delete
expect fragments.size_over_life = [[0,1]]
click "choice:course:fragments.size_over_life"
click "choice:course:fragments.size_over_life=Shrink"
expect fragments.size_over_life = [[0,1],[1,0.1]]
click "toggle:reverse:fragments.size_over_life"
expect fragments.size_over_life = [[0,0.1],[1,1]]
)");
}

TEST_F(EditorScript, SnappedPointsStandOnTheGridAndAPointStaysBetweenItsNeighbours) {
  passes(R"(set fragments.opacity_over_life [[0,1],[0.5,0.5],[1,0]]
click life:fragments.opacity_over_life
hold ctrl
drag point:fragments.opacity_over_life.1 37 -19
let ctrl
expect fragments.opacity_over_life contains 0.
drag point:fragments.opacity_over_life.1 900 0
expect fragments.opacity_over_life contains [1.0,
drag point:fragments.opacity_over_life.1 -900 900
expect fragments.opacity_over_life = [[0,1],[0,0],[1,0]]
)");
}

TEST_F(EditorScript, StopsOfAGradientAreAddedDraggedAndTakenAway) {
  passes(R"(click life:fragments.colour_over_life
click "choice:course:fragments.colour_over_life"
click "choice:course:fragments.colour_over_life=White smoke"
expect fragments.colour_over_life = [[0,"#f4f4f2"],[1,"#b9bcc0"]]
expect undo = 1
click graph:fragments.colour_over_life
expect undo = 2
expect fragments.colour_over_life contains [0.5,"#d7d8d9"]
drag point:fragments.colour_over_life.1 40 0
expect undo = 3
rightclick point:fragments.colour_over_life.1
expect fragments.colour_over_life = [[0,"#f4f4f2"],[1,"#b9bcc0"]]
doubleclick point:fragments.colour_over_life.0
expect visible swatch:fragments.colour_over_life.0.picker
)");
}

TEST_F(EditorScript, AltDragsToRoundValues) {
  passes(R"(set fragments.ejection_angle 45
hold alt
drag fragments.ejection_angle 23
let alt
expect fragments.ejection_angle >= 50
expect fragments.ejection_angle <= 80
)");
  const auto result = run("hold alt\ndrag fragments.ejection_angle 23\nlet alt\nprint fragments.ejection_angle\n");
  const std::size_t at = result.out.find('=');
  ASSERT_NE(at, std::string::npos) << result.err;
  EXPECT_EQ(std::fmod(std::strtod(result.out.c_str() + at + 1, nullptr), 5.0), 0.0) << result.out;
}

TEST_F(EditorScript, TabGoesFromFieldToField) {
  passes(R"(doubleclick value:fragments.speed_mean
type 30
key Tab
expect fragments.speed_mean = 30
expect typing = fragments.speed_deviation
type 4
key Tab
expect fragments.speed_deviation = 4
wait 3
expect typing = fragments.size_mean
key shift+Tab
wait 3
expect typing = fragments.speed_deviation
key Escape
expect typing =
expect undo = 2
)");
}

TEST_F(EditorScript, RandomisingIsOneStepAndLeavesLockedRows) {
  passes(R"(hover row:fragments.ejection_angle
click button:lock:fragments.ejection_angle
expect locked = 1
note
click button:randomise
expect undo = 1
expect undo.label = Randomise
expect fragments.ejection_angle = noted
expect fragments.speed_mean != noted
key ctrl+Z
expect fragments.speed_mean = noted
key D
expect fragments.speed_mean != noted
rightclick row:fragments.ejection_angle
click item:Unlock
expect locked = 0
doubleclick slider:vary.amount
type 60
key Enter
expect vary.amount = 0.6
key shift+D
expect seed = 1994
expect undo = 2
rightclick section:Launch
click "item:Randomise Launch"
expect undo = 3
)");
}

SessionOptions patient() { return {.library = {}, .wait_for_compile = true}; }

void setSpeed(Session& session, double speed) { ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, "speed_mean"), speed).has_value()); }

TEST(Compare, ShowsTheKeptStateAtTheSameTimeWhileTheOtherIsEdited) {
  Session session(patient());
  session.playback.playing = false;
  session.update(0.0);
  session.playback.seek(0.8);
  session.keepForComparing();
  session.update(0.0);
  ASSERT_NE(session.compare.explosion(), nullptr);
  const auto heights = [](const Frame& frame) { return std::vector<float>(frame.y.begin(), frame.y.begin() + static_cast<std::ptrdiff_t>(frame.count)); };
  EXPECT_EQ(heights(session.compare.frame), heights(session.frame()));
  const std::vector<float> before = heights(session.compare.frame);
  setSpeed(session, 70.0);
  session.update(0.0);
  EXPECT_EQ(heights(session.compare.frame), before);
  EXPECT_NE(heights(session.frame()), before);
  session.playback.seek(1.2);
  session.update(0.0);
  EXPECT_EQ(session.compare.frame.time_s, session.frame().time_s);
}

TEST(Compare, UndoStatesAreReachedWithoutUndoing) {
  Session session(patient());
  session.update(0.0);
  const double first = session.document.layer().speed_mean_mps;
  setSpeed(session, 50.0);
  setSpeed(session, 80.0);
  session.compareWithUndo(2);
  EXPECT_EQ(session.compare.preset->layers[0].speed_mean_mps, first);
  session.compareWithUndo(1);
  EXPECT_EQ(session.compare.preset->layers[0].speed_mean_mps, 50.0);
  EXPECT_EQ(session.document.history().undoSteps(), 2u);
  const auto kept = session.compare.preset;
  session.compareWithUndo(3);
  EXPECT_EQ(session.compare.preset, kept) << "there is no such state";
}

TEST(Compare, SwappingIsOneUndoStepAndSwapsBack) {
  Session session(patient());
  session.keepForComparing();
  setSpeed(session, 50.0);
  session.swapCompared();
  EXPECT_EQ(session.compare.preset->layers[0].speed_mean_mps, 50.0);
  EXPECT_NE(session.document.layer().speed_mean_mps, 50.0);
  EXPECT_EQ(session.document.history().undoLabel(), "Swap A and B");
  EXPECT_EQ(session.compare.name, "untitled, before the swap") << "A is the edited preset now";
  session.swapCompared();
  EXPECT_EQ(session.compare.name, "kept state") << "to and fro, the same names";
  session.swapCompared();
  setSpeed(session, 40.0);
  session.swapCompared();
  EXPECT_EQ(session.compare.name, "untitled, before the swap") << "it was edited meanwhile, and is what was kept no longer";
  EXPECT_EQ(session.document.layer().speed_mean_mps, 50.0);
}

TEST(Compare, AFileThatCannotBeReadIsAMessage) {
  Session session(patient());
  session.compareWithFile("/no/such/preset.npsee.json");
  EXPECT_FALSE(session.notices.error.empty());
  EXPECT_FALSE(session.compare.on());
}

TEST(Variations, AreNineDifferentNeighboursOfWhichAnyIsAdoptedInOneStep) {
  Session session(patient());
  session.update(0.0);
  session.showVariations();
  session.update(0.0);
  ASSERT_TRUE(session.variations.open);
  std::set<double> speeds;
  for (std::size_t i = 0; i < Variations::kCount; ++i) {
    ASSERT_NE(session.variations.shelf.at(i), nullptr) << i;
    speeds.insert(session.variations.presets[i]->layers[0].speed_mean_mps);
  }
  EXPECT_GE(speeds.size(), 6u) << "three digits may fall together";
  EXPECT_EQ(*session.variations.presets[Variations::kMiddle], session.document.preset());
  const Preset chosen = *session.variations.presets[2], before = session.document.preset();
  session.adoptVariation(2);
  EXPECT_EQ(session.document.preset(), chosen);
  session.update(0.0);
  EXPECT_EQ(*session.variations.presets[Variations::kMiddle], chosen) << "the grid follows";
  EXPECT_EQ(session.document.history().undoSteps(), 1u);
  session.undo();
  EXPECT_EQ(session.document.preset(), before);
}

TEST(Variations, FollowTheAmountAndTheLocks) {
  Session session(patient());
  session.update(0.0);
  session.design.locked = {"fragments.speed_mean"};
  session.showVariations();
  const auto first = session.variations.presets[0];
  EXPECT_EQ(first->layers[0].speed_mean_mps, session.document.layer().speed_mean_mps);
  session.design.amount = 0.8;
  session.update(0.0);
  EXPECT_NE(*session.variations.presets[0], *first);
}

TEST(Variations, TooManyParticlesAreRefusedWithAReason) {
  Session session(patient());
  ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, "count"), std::int64_t{50'000}).has_value());
  session.update(0.0);
  session.showVariations();
  EXPECT_FALSE(session.variations.open);
  EXPECT_NE(session.notices.error.find("50000 particles"), std::string::npos) << session.notices.error;
}

TEST(Shelf, ANewSetReplacesTheOneUnderWayAndABadPresetLeavesAGap) {
  auto good = std::make_shared<Preset>();
  good->layers.emplace_back();
  auto bad = std::make_shared<Preset>(*good);
  bad->layers[0].speed_mean_mps = -1.0;
  Shelf shelf;
  shelf.poll(true);
  EXPECT_EQ(shelf.at(0), nullptr);
  for (int i = 0; i < 50; ++i) {
    auto other = std::make_shared<Preset>(*good);
    other->seed = i;
    shelf.request({other, other, other});
  }
  shelf.request({good, bad});
  shelf.poll(true);
  EXPECT_NE(shelf.at(0), nullptr);
  EXPECT_EQ(shelf.at(1), nullptr);
  EXPECT_EQ(shelf.at(2), nullptr);
  EXPECT_FALSE(shelf.busy());
}

TEST_F(EditorScript, AKeptStateIsComparedBesideALineThatIsDragged) {
  passes(R"(set time 0.8
key shift+C
expect compare = split
expect compare.name = kept state
set fragments.speed_mean 60
expect compare.alive = 100
drag compare:divider 200 0
expect compare.split > 0.7
key C
expect compare = off
key C
expect compare = split
click "button:end comparing"
expect compare = off
expect undo = 1
)");
}

TEST_F(EditorScript, FlippingShowsTheStateBeforeTheLastEditAndSwappingEditsIt) {
  passes(R"(set time 0.8
set fragments.speed_mean 60
key X
expect compare = flip
expect compare.flipped = yes
expect compare.name contains Y-mag
key X
expect compare.flipped = no
click "choice:compare"
click "choice:compare=now"
expect compare.name = kept state
click toggle:swap
expect compare != off
)");
}

TEST_F(EditorScript, BothSidesOfAComparisonHaveTheChosenBackground) {
  passes("set time 0.8\nclick toggle:view\nclick item:Black\nkey Escape\nkey shift+C\nexpect compare = split\nmouse 3 200\nwait 40\nsave " + in("split.png") + "\n", {"--size", "1280x760"});
  // Left and right of the viewport's upper part, where there is sky otherwise.
  const render::Image image = picture("split.png");
  for (const int x : {300, 830}) EXPECT_EQ(image.pixel(x, 200)[0] + image.pixel(x, 200)[1] + image.pixel(x, 200)[2], 0) << x;
}

TEST_F(EditorScript, AVariationIsAdoptedByAClickOrItsNumber) {
  passes(R"(set time 0.6
key shift+V
expect variations = yes
expect visible variation:1
expect visible variation:9
note
click variation:3
expect undo = 1
expect undo.label = Adopt variation
expect fragments.speed_mean != noted
key alt+1
expect undo = 2
click variation:5
expect undo = 2
click "button:other variations"
expect undo = 2
key Escape
expect variations = no
key ctrl+Z
key ctrl+Z
expect fragments.speed_mean = noted
expect dirty = no
)");
}

}  // namespace
}  // namespace npsee::editor
