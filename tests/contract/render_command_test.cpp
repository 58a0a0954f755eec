// `npsee render` as users call it: options, messages, exit codes, names, and what is left behind when it fails.
#include "app/commands/progress.h"
#include "app/render/image.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using test::npseeRun;
using Words = std::vector<std::string>;

class RenderCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    test::spill(preset(), R"({"npsee": 1, "layers": [{"name": "fragments", "count": 60, "speed_mean": 12, "size_mean": 1}]})");
  }
  std::string preset() const { return inputs_ / "small.npsee.json"; }

  static test::ProcessResult render(Words words, const std::map<std::string, std::string>& environment = {}) {
    words.insert(words.begin(), "render");
    return npseeRun(words, environment);
  }
  /// Runs with the small preset and expects success.
  std::string rendered(Words words) const {
    words.insert(words.begin(), preset());
    const auto result = render(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "") << "no progress without a terminal";
    return result.out;
  }
  /// Bytes of one picture.
  std::string picture(Words words) const {
    const std::string path = folder_ / "picture.png";
    words.insert(words.end(), {"-o", path});
    if (std::ranges::find(words, "--size") == words.end()) words.insert(words.end(), {"--size", "160x90"});
    EXPECT_EQ(rendered(words), path + "\n");
    return test::slurp(path);
  }
  render::Image image(Words words) const {
    picture(std::move(words));
    auto read = render::readPng(folder_ / "picture.png");
    EXPECT_TRUE(read) << (read ? "" : read.error().text());
    return read ? *read : render::Image{};
  }
  /// Expects a refusal that names all the words, and an empty folder.
  void expectRefused(int code, Words words, const Words& named) const {
    words.insert(words.begin(), preset());
    const auto result = render(words);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(result.out, "");
    for (const std::string& word : named) EXPECT_NE(result.err.find(word), std::string::npos) << "\"" << word << "\" in: " << result.err;
    EXPECT_TRUE(fs::is_empty(folder_.path())) << "something was left behind";
  }
  std::set<std::string> files() const {
    std::set<std::string> out;
    for (const auto& entry : fs::directory_iterator(folder_.path())) out.insert(entry.path().filename().string());
    return out;
  }

  test::TemporaryFolder folder_, inputs_;
};

TEST_F(RenderCommand, WritesAPictureOfTheWantedSizeAndSaysWhere) {
  const render::Image drawn = image({"--size", "200x120", "--time", "0.5"});
  EXPECT_EQ(drawn.width, 200);
  EXPECT_EQ(drawn.height, 120);
}

TEST_F(RenderCommand, IsHighDefinitionWithoutASize) {
  rendered({"-o", folder_ / "a.png"});
  const auto drawn = render::readPng(folder_ / "a.png");
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->width, 1280);
  EXPECT_EQ(drawn->height, 720);
}

TEST_F(RenderCommand, GivesTheSameBytesOnEveryRunAndForEveryNumberOfThreads) {
  const std::string one = picture({"--threads", "1"});
  EXPECT_EQ(picture({"--threads", "1"}), one);
  EXPECT_EQ(picture({"--jobs", "7"}), one);
  EXPECT_EQ(picture({"-j", "2"}), one);
}

TEST_F(RenderCommand, TimeSeedSettingsCameraAndBackgroundEachChangeThePicture) {
  const std::string plain = picture({"--time", "0.5"});
  EXPECT_EQ(picture({"--time", "500ms"}), plain);
  EXPECT_NE(picture({"--time", "0.6"}), plain);
  EXPECT_NE(picture({"--time", "0.5", "--seed", "7"}), plain);
  EXPECT_NE(picture({"--time", "0.5", "--set", "fragments.size_mean=2"}), plain);
  EXPECT_NE(picture({"--time", "0.5", "--camera", "top"}), plain);
  EXPECT_NE(picture({"--time", "0.5", "--camera", "eye=0,5,30 target=0,4,0 fov=50deg"}), plain);
  EXPECT_NE(picture({"--time", "0.5", "--background", "black"}), plain);
  EXPECT_EQ(picture({"--time", "0.5", "--background", "sky", "--camera", "auto"}), plain);
}

TEST_F(RenderCommand, BackgroundsAreExactColoursOrTransparent) {
  const render::Image coloured = image({"--background", "#1a80ff"});
  EXPECT_EQ(coloured.pixel(0, 0)[0], 0x1a);
  EXPECT_EQ(coloured.pixel(0, 0)[1], 0x80);
  EXPECT_EQ(coloured.pixel(159, 89)[2], 0xff);
  const render::Image clear = image({"--background", "transparent"});
  EXPECT_EQ(clear.pixel(0, 0)[3], 0);
  EXPECT_TRUE(std::ranges::any_of(clear.rgba, [](int v) { return v > 0; })) << "the effect itself is there";
}

TEST_F(RenderCommand, SequenceNamesFollowThePatternAndTheFrameNumber) {
  EXPECT_EQ(rendered({"--frames", "0:0.2", "--fps", "20", "--size", "64x36", "-o", folder_ / "a_%03d.png"}),
            (folder_ / "a_000.png\n") + (folder_ / "a_001.png\n") + (folder_ / "a_002.png\n") + (folder_ / "a_003.png\n"));
  rendered({"--frames", "0.1:0.2", "--fps", "20", "--size", "64x36", "-o", folder_ / "b.png"});
  rendered({"--frames", "0:0.1", "--fps", "10", "--size", "64x36", "-o", folder_.path()});
  EXPECT_EQ(files(), (std::set<std::string>{"a_000.png", "a_001.png", "a_002.png", "a_003.png", "b_0002.png", "b_0003.png", "small_0000.png"}));
  // Frame k shows the time k / fps, however it was asked for.
  EXPECT_EQ(test::slurp(folder_ / "a_002.png"), test::slurp(folder_ / "b_0002.png"));
  EXPECT_EQ(picture({"--time", "0.15", "--size", "64x36"}), test::slurp(folder_ / "b_0003.png"));
}

TEST_F(RenderCommand, SequencesHaveTheSameBytesForEveryNumberOfThreads) {
  for (const std::string threads : {"1", "5"})
    rendered({"--frames", "0:0.4", "--fps", "30000/1001", "--size", "64x36", "--threads", threads, "-o", folder_ / ("t" + threads + "_%02d.png")});
  EXPECT_EQ(files().size(), 24u);
  for (int k = 0; k < 12; ++k) {
    const std::string number = (k < 10 ? "0" : "") + std::to_string(k) + ".png";
    EXPECT_EQ(test::slurp(folder_ / ("t1_" + number)), test::slurp(folder_ / ("t5_" + number)));
  }
}

TEST_F(RenderCommand, ASheetHoldsThePicturesInReadingOrderWithCaptions) {
  rendered({"--sheet", "3x2", "--frames", "0:1.2", "--size", "96x54", "-o", folder_ / "sheet.png"});
  const auto sheet = render::readPng(folder_ / "sheet.png");
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->width, 288);
  EXPECT_EQ(sheet->height, 108);
  // The fourth of six times from 0 to 1.2 s is 0.6 s; its cell is the first of the second row. The caption is below.
  const render::Image alone = image({"--time", "0.6", "--size", "96x54"});
  for (int y = 0; y < 35; ++y) EXPECT_TRUE(std::equal(alone.pixel(0, y), alone.pixel(0, y) + 96 * 4, sheet->pixel(0, 54 + y))) << y;
  EXPECT_FALSE(std::equal(alone.pixel(0, 0), alone.pixel(0, 0) + 96 * 54 * 4, sheet->pixel(0, 54)));
}

TEST_F(RenderCommand, ATransparentSheetHoldsTheEffectAlone) {
  rendered({"--sheet", "2x1", "--frames", "0.5:0.6", "--size", "80x80", "--background", "transparent", "-o", folder_ / "sprites.png"});
  const auto sheet = render::readPng(folder_ / "sprites.png");
  ASSERT_TRUE(sheet);
  const render::Image alone = image({"--time", "0.5", "--size", "80x80", "--background", "transparent"});
  for (int y = 0; y < 80; ++y) EXPECT_TRUE(std::equal(alone.pixel(0, y), alone.pixel(0, y) + 80 * 4, sheet->pixel(0, y))) << y;
}

TEST_F(RenderCommand, SeveralPresetsGoIntoAFolderUnderTheirNames) {
  test::spill(inputs_ / "other.npsee.json", R"({"npsee": 1, "layers": [{"name": "a", "count": 5}]})");
  const auto result = render({preset(), inputs_ / "other.npsee.json", "--size", "64x36", "-o", folder_.path()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, (folder_ / "small.png\n") + (folder_ / "other.png\n"));
  EXPECT_EQ(files(), (std::set<std::string>{"small.png", "other.png"}));
}

TEST_F(RenderCommand, ManyPresetsWithOneNameOrOneFileAreRefused) {
  test::spill(inputs_ / "other.npsee.json", R"({"npsee": 1, "layers": []})");
  EXPECT_EQ(render({preset(), preset(), "-o", folder_.path()}).exit_code, 2);
  const auto result = render({preset(), inputs_ / "other.npsee.json", "-o", folder_ / "a.png"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("folder"), std::string::npos) << result.err;
}

TEST_F(RenderCommand, AnEmptyPresetIsAnEmptyRange) {
  test::spill(preset(), R"({"npsee": 1, "layers": []})");
  EXPECT_EQ(image({}).width, 160);
}

TEST_F(RenderCommand, OptionsThatCannotBeMeantExitTwoAndSayHowToWriteThem) {
  const std::string out = folder_ / "a.png";
  expectRefused(2, {"-o", out, "--time", "soon"}, {"--time soon", "--time 0.5"});
  expectRefused(2, {"-o", out, "--time", "-1"}, {"0 to 86400"});
  expectRefused(2, {"-o", out, "--time", "nan"}, {"--time nan"});
  expectRefused(2, {"-o", out, "--size", "big"}, {"--size big", "1280x720"});
  expectRefused(2, {"-o", out, "--size", "0x720"}, {"1 to 8192"});
  expectRefused(2, {"-o", out, "--size", "99999x2"}, {"1 to 8192"});
  expectRefused(2, {"-o", out, "--size", "8192x8192"}, {"33554432"});
  expectRefused(2, {"-o", out, "--frames", "3:1"}, {"ends before it begins", "--frames 0:2"});
  expectRefused(2, {"-o", out, "--frames", "1"}, {"--frames 0:2"});
  expectRefused(2, {"-o", out, "--frames", "0:1e9"}, {"86400"});
  expectRefused(2, {"-o", out, "--frames", "0:1", "--fps", "0"}, {"--fps 0", "--fps 30"});
  expectRefused(2, {"-o", out, "--frames", "0:1", "--fps", "-5"}, {"--fps 30"});
  expectRefused(2, {"-o", out, "--frames", "0:1", "--fps", "1e9"}, {"--fps 30"});
  expectRefused(2, {"-o", out, "--frames", "0:86400", "--fps", "60"}, {"5184000 frames", "100000"});
  expectRefused(2, {"-o", out, "--frames", "0.01:0.02", "--fps", "1"}, {"no frame"});
  expectRefused(2, {"-o", out, "--fps", "30"}, {"--frames FROM:TO"});
  expectRefused(2, {"-o", out, "--time", "1", "--frames", "0:1"}, {"Leave one of them out"});
  expectRefused(2, {"-o", out, "--sheet", "4"}, {"--sheet 4x4"});
  expectRefused(2, {"-o", out, "--sheet", "0x4"}, {"1 to 64"});
  expectRefused(2, {"-o", out, "--sheet", "64x64", "--size", "640x480"}, {"above the limit of 33554432"});
  expectRefused(2, {"-o", out, "--sheet", "2x2", "--fps", "5"}, {"--fps"});
  expectRefused(2, {"-o", out, "--camera", "behind"}, {"--camera behind", "eye=X,Y,Z"});
  expectRefused(2, {"-o", out, "--background", "purpleish"}, {"--background purpleish", "transparent"});
  expectRefused(2, {"-o", out, "--threads", "0"}, {"1 to 256"});
  expectRefused(2, {"-o", out, "--view", "splines"}, {"--template"});
  expectRefused(2, {"-o", out, "--template", "--view", "wire"}, {"splines, polygons or surface"});
  expectRefused(2, {"-o", out, "--template", "--time", "1"}, {"--time"});
  expectRefused(2, {"-o", out, "--set", "fragments.sped_mean=3"}, {"Did you mean"});
  expectRefused(2, {"-o", out, "--seed", "x"}, {"--seed x"});
  expectRefused(2, {"-o", folder_ / "a.jpg"}, {".png"});
  expectRefused(2, {"-o", folder_ / "a_%s.png", "--frames", "0:1"}, {"%04d"});
  expectRefused(2, {}, {"--output"});
}

TEST_F(RenderCommand, APresetThatCannotBeReadExitsThree) {
  EXPECT_EQ(render({inputs_ / "none.npsee.json", "-o", folder_ / "a.png"}).exit_code, 3);
  test::spill(preset(), "{\"npsee\": 1, \"layers\": [{\"count\": 1000000000}]}");
  const auto result = render({preset(), "-o", folder_ / "a.png"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(files().empty());
}

TEST_F(RenderCommand, AFolderNamedWithASlashIsMade) {
  const std::vector<std::string> words{preset(), "--size", "64x36", "--time", "1", "-o", folder_ / "new/"};
  auto dry = words;
  dry.push_back("--dry-run");
  EXPECT_EQ(render(dry).exit_code, 0);
  EXPECT_TRUE(files().empty()) << "a dry run writes nothing";
  const auto result = render(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "new"), {}), 1);
  EXPECT_EQ(render(words).exit_code, 0) << "and may be there already";
}

TEST_F(RenderCommand, PlacesThatCannotBeWrittenExitFive) {
  expectRefused(5, {"-o", folder_ / "no/such/a.png"}, {"does not exist", "no/such"});
  expectRefused(5, {"-o", folder_ / "none/none/", "--frames", "0:1"}, {"does not exist"});
  expectRefused(5, {"-o", preset() + "/a.png"}, {"not a folder"});
  expectRefused(5, {"-o", "/dev/full", "--size", "64x36"}, {"/dev/full", "No space left"});
  // Longer than any file system takes, for whomever and wherever the test runs.
  expectRefused(5, {"-o", folder_ / (std::string(300, 'n') + ".png"), "--size", "64x36"}, {"nnn.png", "File name too long"});
  if (::geteuid() == 0) return;  // whom no folder's rights stop
  const test::TemporaryFolder locked;
  fs::permissions(locked.path(), fs::perms::owner_read | fs::perms::owner_exec);
  expectRefused(5, {"-o", locked / "a.png", "--size", "64x36"}, {"a.png", "Permission denied"});
  fs::permissions(locked.path(), fs::perms::owner_all);
}

TEST_F(RenderCommand, AFileOverTheSizeLimitEndsTheSequenceAndLeavesOnlyWholePictures) {
  // 512-byte blocks: the small pictures fit, as a disk that fills up would take some.
  const auto result = test::run("/bin/sh", {"-c", "ulimit -f 8; exec \"$0\" render \"$1\" -o \"$2\" --frames 0:1 --fps 20 --size 640x360", test::npseePath(), preset(), folder_ / "a_%02d.png"});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  EXPECT_NE(result.err.find("cannot be written"), std::string::npos) << result.err;
  for (const std::string& name : files()) {
    EXPECT_TRUE(name.starts_with("a_")) << name;
    EXPECT_TRUE(render::readPng(folder_ / name)) << name;
  }
}

TEST_F(RenderCommand, AnExistingFileSurvivesAFailedRun) {
  test::spill(folder_ / "a.png", "precious");
  EXPECT_EQ(render({preset(), "-o", folder_ / "a.png"}, {{"NPSEE_OSMESA", "libNoSuchOSMesa.so"}}).exit_code, 4);
  EXPECT_EQ(test::slurp(folder_ / "a.png"), "precious");
}

TEST_F(RenderCommand, WithoutTheOffscreenLibraryExitsFourAndNamesThePackage) {
  const auto result = render({preset(), "-o", folder_ / "a.png"}, {{"NPSEE_OSMESA", "libNoSuchOSMesa.so"}});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("libosmesa6"), std::string::npos) << result.err;
  EXPECT_TRUE(files().empty());
  // A library that is none of this kind is refused too, not called.
  EXPECT_EQ(render({preset(), "-o", folder_ / "a.png"}, {{"NPSEE_OSMESA", "libz.so.1"}}).exit_code, 4);
}

TEST_F(RenderCommand, CommandsThatDrawNothingNeedNoGraphics) {
  EXPECT_EQ(npseeRun({"params"}, {{"NPSEE_OSMESA", "libNoSuchOSMesa.so"}}).exit_code, 0);
  EXPECT_EQ(npseeRun({"render", "--help"}, {{"NPSEE_OSMESA", "libNoSuchOSMesa.so"}}).exit_code, 0);
}

TEST_F(RenderCommand, HelpShowsEveryOptionAndExamples) {
  const auto help = npseeRun({"render", "--help"});
  for (const char* word : {"--output", "--time", "--frames", "--fps", "--size", "--quality", "--camera", "--seed", "--set", "--background", "--sheet", "--caption", "--index", "--format", "--template", "--view", "--layer", "--threads", "--shard", "--resume", "--dry-run", "--verify", "--summary", "--progress",
                           "--golden", "--update-golden", "--report", "--junit", "--max", "--mean", "--pixels", "--ssim", "Examples:"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

TEST(Progress, TellsTheCountAndTheTimeLeft) {
  EXPECT_EQ(commands::progressText("frame", 0, 60, 0.0), "frame 0 of 60, 0 %");
  EXPECT_EQ(commands::progressText("frame", 15, 60, 1.0), "frame 15 of 60, 25 %, 3 s left");
  EXPECT_EQ(commands::progressText("frame", 1, 1000, 1.0), "frame 1 of 1000, 0 %, 16 min left");
}

}  // namespace
}  // namespace npsee
