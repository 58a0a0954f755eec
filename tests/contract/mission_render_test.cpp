#include "app/render/deep_image.h"
#include "app/render/image_compare.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace npsee {
namespace {

using test::npseeRun;

std::string mission() { return std::string(NPSEE_SOURCE_DIR) + "/assets/missions/thesis_default.mission.json"; }

test::ProcessResult drawn(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"mission", mission(), "--quiet", "--until", "20"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return npseeRun(arguments);
}

TEST(MissionPictures, APictureIsDrawnOfAMissionAndTheSameOneOfItsRecording) {
  const test::TemporaryFolder folder;
  const std::string view = "t=13,camera=orbit,size=320x180,smooth=0";
  const auto made = drawn({"--render", view, "-o", folder / "a.png", "--record", folder / "run.jsonl"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.out, "");
  EXPECT_NE(made.err.find("a.png"), std::string::npos);
  const auto image = render::readPng(folder / "a.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 320);
  EXPECT_EQ(image->height, 180);
  const auto replayed = npseeRun({"replay", folder / "run.jsonl", "--render", view, "-o", folder / "b.png"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(replayed.out, folder / "b.png\n");
  EXPECT_EQ(test::slurp(folder / "a.png"), test::slurp(folder / "b.png"));
}

TEST(MissionPictures, QualityIsThatOfPresets) {
  const test::TemporaryFolder folder;
  const std::string view = "t=13,camera=orbit,size=320x180";
  const auto draw = [&](const std::string& quality) {
    std::vector<std::string> words{"--render", view, "-o", folder / (quality + ".png"), "--record", folder / "run.jsonl"};
    if (quality != "none") words.insert(words.end(), {"--quality", quality});
    const auto made = drawn(words);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    auto image = render::readPng(folder / (quality + ".png"));
    EXPECT_TRUE(image);
    return render::deepened(image ? *image : render::Image{});
  };
  const auto none = draw("none"), normal = draw("normal"), draft = draw("draft"), fine = draw("fine");
  EXPECT_EQ(none.rgba, normal.rgba);
  for (const auto* other : {&draft, &fine}) {
    const auto d = render::compareImages(normal, *other);
    EXPECT_GT(d.ssim, 0.7);
    EXPECT_LT(d.mean, 6.0);
    EXPECT_GT(d.max, 0.0) << "it is another picture";
  }
  const auto replayed = npseeRun({"replay", folder / "run.jsonl", "--render", view, "--quality", "draft", "-o", folder / "again.png"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(test::slurp(folder / "again.png"), test::slurp(folder / "draft.png"));
}

TEST(MissionPictures, SeveralViewsAreNumberedOrCarryTheirOwnNames) {
  const test::TemporaryFolder folder;
  const auto made = drawn({"--render", "t=1,size=64x48", "--render", "t=2,size=64x48,camera=plan", "--render", "t=3,size=64x48,out=" + (folder / "own.png"), "-o", folder / "v_%d.png"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  for (const char* name : {"v_0.png", "v_1.png", "own.png"}) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
}

TEST(MissionPictures, ASequenceHasAFrameForEveryStepOfTheRate) {
  const test::TemporaryFolder folder;
  const auto made = drawn({"--render", "camera=observer,size=64x48", "--frames", "12:13", "--fps", "4", "-o", folder / "f_%03d.png"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  for (const char* name : {"f_048.png", "f_049.png", "f_050.png", "f_051.png"}) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_FALSE(std::filesystem::exists(folder / "f_052.png"));
}

TEST(MissionPictures, MistakesAreToldBeforeAnythingIsSimulated) {
  const test::TemporaryFolder folder;
  const struct {
    std::vector<std::string> arguments;
    int code;
    std::string message;
  } cases[] = {
      {{"--render", "camera=obsrver", "-o", folder / "a.png"}, 2, "Did you mean observer?"},
      {{"--render", "t=3"}, 2, "there is no name for the picture"},
      {{"-o", folder / "a.png"}, 2, "names a picture, and none is asked for"},
      {{"--quality", "fine"}, 2, "is that of a picture, and none is asked for"},
      {{"--quality", "good", "--render", "t=3", "-o", folder / "a.png"}, 2, "draft, normal or fine"},
      {{"--render", "t=3", "--render", "t=4", "--frames", "0:1", "-o", folder / "a.png"}, 2, "a sequence of one view"},
      {{"--render", "camera=gun:gun9", "-o", folder / "a.png"}, 2, "there is no gun \"gun9\""},
      {{"--render", "t=3", "--monte-carlo", "3", "-o", folder / "a.png"}, 2, "draws no pictures"},
      {{"--render", "t=3", "-o", folder / "missing/a.png"}, 5, "missing"},
  };
  for (const auto& one : cases) {
    const auto result = drawn(one.arguments);
    EXPECT_EQ(result.exit_code, one.code) << one.arguments[1] << '\n' << result.err;
    EXPECT_NE(result.err.find(one.message), std::string::npos) << result.err;
  }
  const auto both = npseeRun({"replay", "none.jsonl", "--render", "t=1", "--at", "3", "-o", folder / "a.png"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.err.find("Ask for one at a time"), std::string::npos) << both.err;
}

TEST(MissionPictures, TheHelpListsTheKeysOfAView) {
  const auto help = npseeRun({"mission", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* key : {"camera", "target", "field", "show", "preset"}) EXPECT_NE(help.out.find(std::string("  ") + key), std::string::npos) << key;
}

}  // namespace
}  // namespace npsee
