#include "tests/editor/editor_script.h"

#include <npsee/preset.h>

namespace npsee {
namespace {

using test::EditorScript;

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

TEST_F(EditorScript, SaveAsClosesWhenTheOtherModesDocumentIsShown) {
  test::spill(in("other.npsee.json"), "{\"npsee\": 1}");
  passes(R"(key ctrl+shift+S
click "field:file name"
key ctrl+A
type other
key Enter
expect files = save as
click mode:Mission
expect files = closed
click mode:Explosion
key ctrl+shift+S
key F6
expect files = closed
)");
  EXPECT_EQ(test::slurp(in("other.npsee.json")), "{\"npsee\": 1}");
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

}  // namespace
}  // namespace npsee
