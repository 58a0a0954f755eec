#include "editor/document/clipboard.h"
#include "tests/editor/editor_script.h"

#include <gtest/gtest.h>

namespace npsee::editor {
namespace {

const Parameter& layerRow(std::string_view key) { return *findParameter(Scope::layer, key); }

/// shell, with sparks that start at its death, and dust.
Document family() {
  Document document;
  EXPECT_TRUE(document.renameLayer("shell").has_value());
  EXPECT_TRUE(document.addLayer().has_value());
  EXPECT_TRUE(document.renameLayer("sparks").has_value());
  EXPECT_TRUE(document.assign(layerRow("parent"), std::string("shell")).has_value());
  EXPECT_TRUE(document.assign(layerRow("trigger"), std::string("death")).has_value());
  EXPECT_TRUE(document.addLayer().has_value());
  EXPECT_TRUE(document.renameLayer("dust").has_value());
  return document;
}

TEST(Clipboard, ALayerIsPastedIntoAnotherPresetWithAllItsParametersAndWhatHangsOnIt) {
  const Document from = family();
  const std::string text = layerText(from.preset(), 0);
  Document to;
  const auto done = paste(to, text);
  ASSERT_TRUE(done.has_value()) << done.error().text();
  EXPECT_EQ(*done, "Pasted 2 layers.");
  ASSERT_EQ(to.preset().layers.size(), 3u);
  EXPECT_EQ(to.preset().layers[1], from.preset().layers[0]);
  EXPECT_EQ(to.preset().layers[2], from.preset().layers[1]);
  EXPECT_EQ(to.history().undoSteps(), 1u);
  EXPECT_EQ(to.selected(), 1);
}

TEST(Clipboard, NamesThatAreTakenBecomeFreeOnesAndChildrenFollow) {
  Document document = family();
  document.select(0);
  ASSERT_TRUE(paste(document, layerText(document.preset(), 0)).has_value());
  EXPECT_EQ(document.preset().layers[1].name, "shell 2");
  EXPECT_EQ(document.preset().layers[2].name, "sparks 2");
  EXPECT_EQ(document.preset().layers[2].parent, "shell 2");
  EXPECT_EQ(document.preset().layers[2].trigger, Trigger::death);
}

TEST(Clipboard, AChildAloneHangsOnTheSameParentWhereThereIsOneAndOnTheBurstElsewhere) {
  Document document = family();
  const std::string text = layerText(document.preset(), 1);
  document.select(2);
  ASSERT_TRUE(paste(document, text).has_value());
  EXPECT_EQ(document.layer().parent, "shell");
  EXPECT_EQ(document.layer().trigger, Trigger::death);
  Document other;
  const auto done = paste(other, text);
  ASSERT_TRUE(done.has_value()) << done.error().text();
  EXPECT_TRUE(other.layer().parent.empty());
  EXPECT_EQ(other.layer().trigger, Trigger::none);
  EXPECT_NE(done->find("There is no layer shell here"), std::string::npos) << *done;
}

TEST(Clipboard, ASectionCarriesEveryParameterOfItAndNothingElse) {
  Document from, to;
  for (const auto& [key, text] : {std::pair{"speed_mean", "62"}, {"ejection_angle", "33"}, {"size_distribution", "uniform"}})
    ASSERT_TRUE(from.assign(layerRow(key), *parseValue(layerRow(key), text)).has_value());
  ASSERT_TRUE(to.assign(layerRow("spin_mean"), 1.0).has_value());
  ASSERT_TRUE(to.assign(layerRow("opacity"), 0.5).has_value());
  const auto done = paste(to, sectionText(from.preset(), &from.layer(), Section::launch));
  ASSERT_TRUE(done.has_value()) << done.error().text();
  for (const Parameter& parameter : parameters(Scope::layer)) {
    if (parameter.section != Section::launch) continue;
    EXPECT_EQ(to.value(parameter), from.value(parameter)) << parameter.key;
  }
  EXPECT_EQ(to.layer().opacity, 0.5);
  EXPECT_EQ(to.history().undoLabel(), "Paste parameters");
}

TEST(Clipboard, EverySectionOfTheTableIsReadBack) {
  Document document;
  for (const Parameter& parameter : parameters()) {
    const auto done = paste(document, sectionText(document.preset(), &document.layer(), parameter.section));
    EXPECT_TRUE(done.has_value()) << title(parameter.section) << ": " << done.error().text();
  }
  EXPECT_FALSE(document.canUndo()) << "what is pasted is what was there";
}

TEST(Clipboard, BadTextSaysWhatIsWrongAndChangesNothing) {
  Document document;
  const Preset before = document.preset();
  const std::pair<const char*, const char*> cases[] = {
      {"", "The clipboard is empty."},
      {"some words", "nothing that can be pasted"},
      {"[1, 2]", "neither layers nor parameters"},
      {"{\"npsee\": 1}", "neither layers nor parameters"},
      {"{\"npsee\": 1, \"parameters\": {\"speed_meen\": 3}}", "Did you mean speed_mean?"},
      {"{\"npsee\": 1, \"parameters\": {\"speed_mean\": 5000}}", "above the limit of 3000 m/s"},
      {"{\"npsee\": 1, \"parameters\": 3}", "must be an object"},
      {"{\"npsee\": 1, \"layers\": []}", "list of layers is empty"},
      {"{\"npsee\": 1, \"layers\": 7}", "must be a list"},
      {"{\"npsee\": 1, \"layers\": [3]}", "must be an object"},
      {"{\"npsee\": 9, \"layers\": [{}]}", "newer than"},
      {"{\"npsee\": 1, \"layers\": [{\"colour\": \"puce\"}]}", "colour"},
  };
  for (const auto& [text, wrong] : cases) {
    const auto done = paste(document, text);
    ASSERT_FALSE(done.has_value()) << text;
    EXPECT_NE(done.error().text().find(wrong), std::string::npos) << text << " says " << done.error().text();
    EXPECT_EQ(document.preset(), before) << text;
  }
  EXPECT_FALSE(document.canUndo());
}

TEST(Document, MovingALayerPassesTheNextThatHangsOnTheSame) {
  Document document = family();
  document.select(0);
  ASSERT_TRUE(document.moveLayer(1).has_value());
  EXPECT_EQ(document.layer().name, "shell");
  EXPECT_EQ(document.preset().layers[0].name, "dust");
  ASSERT_TRUE(document.moveLayer(1).has_value());
  EXPECT_EQ(document.history().undoLabel(), "Move layer");
  EXPECT_EQ(findLayer(document.preset(), "shell"), 2) << "there is nothing more to pass";
}

TEST(Document, ALayerIsPutBesideAnotherOrHungOnItButNotOnItsOwnChild) {
  Document document = family();
  ASSERT_TRUE(document.placeLayer(2, 0, Document::Place::inside).has_value());
  EXPECT_EQ(document.layer().name, "dust");
  EXPECT_EQ(document.layer().parent, "shell");
  EXPECT_EQ(document.layer().trigger, Trigger::birth);
  ASSERT_TRUE(document.placeLayer(document.selected(), findLayer(document.preset(), "shell"), Document::Place::before).has_value());
  EXPECT_EQ(document.preset().layers[0].name, "dust");
  EXPECT_TRUE(document.preset().layers[0].parent.empty());
  EXPECT_EQ(document.preset().layers[0].trigger, Trigger::none);
  EXPECT_FALSE(document.placeLayer(findLayer(document.preset(), "shell"), findLayer(document.preset(), "sparks"), Document::Place::inside).has_value());
}

using test::EditorScript;

TEST_F(EditorScript, LayersAndSectionsAreCopiedAndPastedThroughTheClipboard) {
  passes(R"(key ctrl+C
expect clipboard contains "layers"
key ctrl+V
expect layers = 2
expect layer = fragments 2
expect note = Pasted 1 layer.
expect undo = 1
key ctrl+X
expect layers = 1
key ctrl+V
expect layers = 2
set "fragments 2.speed_mean" 44
rightclick section:Launch
click "item:Copy Launch"
click layer:fragments
click menu:Edit
click item:Paste
expect fragments.speed_mean = 44
rightclick section:Launch
click "item:Reset Launch"
expect fragments.speed_mean = 15
note
clipboard this is no layer
key ctrl+V
expect error contains nothing that can be pasted
expect layers = noted
expect undo = noted
)");
}

TEST_F(EditorScript, ALayerShownAloneHidesTheOthersUntilAllAreShown) {
  passes(R"(key ctrl+V
set time 0.5
key ctrl+D
expect alive = 200
click "button:solo:fragments 2"
expect alive = 100
expect solo = 1
expect dirty = yes
expect undo = 1
click "button:solo:fragments"
expect alive = 200
key shift+S
expect solo = 0
key S
expect solo = 1
doubleclick "layer:fragments 2"
type sparks
key Enter
expect alive = 100
key ctrl+Z
key ctrl+Z
expect solo = 0
expect alive = 100
)");
}

TEST_F(EditorScript, LayersAreDraggedIntoAnotherOrderAndOntoOneAnother) {
  passes(R"(key ctrl+D
drag "layer:fragments 2" 0 -26
expect layer = fragments 2
expect "fragments 2.parent" = fragments
expect "fragments 2.trigger" = birth
expect undo = 2
expect undo.label = Move layer
drag "layer:fragments 2" 0 -36
expect "fragments 2.parent" =
expect undo = 3
key alt+Down
expect undo = 4
)");
}

TEST_F(EditorScript, TheTemplateShowsWhereParticlesStart) {
  passes(R"(set time 0
expect visible template:particles
save )" + in("with.png") + R"(
rightclick template
click "item:Particles at t = 0"
key Escape
mouse 700 300
wait 3
expect hidden template:particles
save )" + in("without.png") + "\n");
  const auto with = picture("with.png"), without = picture("without.png");
  int different = 0;
  for (int y = 530; y < 810; ++y)
    for (int x = 12; x < 240; ++x)
      if (std::abs(with.pixel(x, y)[0] - without.pixel(x, y)[0]) > 24) ++different;
  EXPECT_GT(different, 60);
  EXPECT_LT(different, 4000);
}

TEST_F(EditorScript, TheWordOfItsYearFindsEveryControlOfTheThesis) {
  std::string script = "click field:search\ntype 1993\n";
  for (const Parameter& parameter : parameters())
    if (!parameter.thesis.empty() && parameter.section != Section::hierarchy) script += "hover \"row:" + std::string(parameter.scope == Scope::layer ? "fragments." : "") + std::string(parameter.key) + "\"\n";
  passes(script + "expect hidden row:fragments.bounce_limit\n");
}

}  // namespace
}  // namespace npsee::editor
