#include "tests/editor/editor_script.h"

namespace npsee {
namespace {

using test::EditorScript;

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

TEST(EditCommand, AWorkingFolderThatIsGoneEndsNothingUnasked) {
  const test::TemporaryFolder folder;
  const std::string there = "mkdir " + (folder / "gone") + " && cd " + (folder / "gone") + " && rmdir ../gone && " + test::npseePath();
  EXPECT_EQ(test::run("/bin/sh", {"-c", there + " edit --headless --screenshot " + (folder / "a.png")}).exit_code, 0);
  const std::string mission = std::string(NPSEE_SOURCE_DIR) + "/assets/missions/thesis_default.mission.json";
  const auto refused = test::run("/bin/sh", {"-c", there + " mission " + mission + " --quiet --render t=1,size=64x36,preset=nope -o " + (folder / "b.png")});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("there is no explosion preset \"nope\""), std::string::npos) << refused.err;
}

TEST(EditCommand, AFileWithNeitherEndingIsOpenedAsWhatItHolds) {
  const test::TemporaryFolder folder;
  test::spill(folder / "script.txt", "print mode\nprint dirty\n");
  for (const auto& [text, mode] : {std::pair{R"({"npsee_mission": 1})", "mission"}, {R"({"npsee": 1, "layers": [{"name": "a"}]})", "explosion"}}) {
    test::spill(folder / "attack 1.5", text);
    const auto opened = test::npseeRun({"edit", folder / "attack 1.5", "--headless", "--script", folder / "script.txt"});
    EXPECT_EQ(opened.out, "mode=" + std::string(mode) + "\ndirty=no\n") << opened.err;
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
  const test::TemporaryFolder folder;
  const auto result = test::npseeRun({"edit", std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json"},
                                     {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"XDG_CONFIG_HOME", folder / "c"}, {"XDG_STATE_HOME", folder / "s"}, {"XDG_CACHE_HOME", folder / "k"}});
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
