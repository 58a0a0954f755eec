// What a pipeline relies on: work shared between calls, resumed, planned, verified and summed up, with the same bytes always.
#include "tests/support/render_command.h"

#include <nlohmann/json.hpp>

#include <map>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using test::Words;

class RenderPipeline : public test::RenderFixture {
 protected:
  /// Two presets with six frames each, into a folder.
  test::ProcessResult frames(const std::string& folder_name, Words more = {}) const {
    more.insert(more.begin(), {preset("small"), preset("other"), "--frames", "0:0.6", "--fps", "10", "--size", "64x36", "-o", folder(folder_name)});
    return render(more);
  }
  std::map<std::string, std::string> contents(const std::string& name) const {
    std::map<std::string, std::string> out;
    for (const std::string& file : files(name)) out[file] = test::slurp(folder_ / (name + "/" + file));
    return out;
  }
};

TEST_F(RenderPipeline, ShardsShareTheWorkAndGiveTheSameBytesInAnyOrder) {
  expect(frames("whole"), 0, {"small_0000.png", "other_0005.png"});
  std::size_t printed = 0;
  for (const char* shard : {"3/5", "1/5", "5/5", "2/5", "4/5"}) {
    const auto result = frames("parts", {"--shard", shard, "-j", shard[0] == '1' ? "7" : "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_LE(lines(result.out), 3u) << "no part is much longer than another";
    printed += lines(result.out);
  }
  EXPECT_EQ(printed, 12u) << "no frame is drawn twice";
  EXPECT_EQ(contents("whole").size(), 12u);
  EXPECT_EQ(contents("parts"), contents("whole"));
}

// Pictures of many compressed bands, most of which are as they were in the frame before.
TEST_F(RenderPipeline, AFramesBytesDependOnNeitherThreadsNorTheFramesBeforeIt) {
  const auto large = [&](const std::string& name, Words more) {
    more.insert(more.begin(), {preset("small"), "--size", "640x360", "-o", folder(name)});
    return render(more);
  };
  const Words sequence{"--frames", "0:0.8", "--fps", "10"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), sequence.begin(), sequence.end());
    return more;
  };
  ASSERT_EQ(large("one", with({"-j", "1"})).exit_code, 0);
  const auto one = contents("one");
  ASSERT_EQ(one.size(), 8u);
  EXPECT_EQ(large("five", with({"-j", "5"})).exit_code, 0);
  EXPECT_EQ(contents("five"), one);
  for (const char* shard : {"3/3", "1/3", "2/3"}) EXPECT_EQ(large("parts", with({"--shard", shard, "-j", "2"})).exit_code, 0);
  EXPECT_EQ(contents("parts"), one);
  // Left are frames that do not follow each other.
  for (const char* name : {"small_0001.png", "small_0004.png", "small_0005.png"}) fs::remove(folder_ / (std::string("five/") + name));
  EXPECT_EQ(lines(large("five", with({"--resume"})).out), 3u);
  EXPECT_EQ(contents("five"), one);
  EXPECT_EQ(large("alone", {"--time", "0.4"}).exit_code, 0);
  EXPECT_EQ(contents("alone").begin()->second, one.at("small_0004.png"));
}

TEST_F(RenderPipeline, MoreShardsThanFilesAreNoFault) {
  EXPECT_EQ(small({"--shard", "2/9", "-o", folder_ / "a.png"}).exit_code, 0);
  EXPECT_TRUE(files().empty());
}

TEST_F(RenderPipeline, ResumeDrawsOnlyWhatIsMissingDamagedOrMadeFromSomethingElse) {
  frames("a");
  const auto before = contents("a");
  fs::remove(folder_ / "a/small_0001.png");
  test::spill(folder_ / "a/small_0002.png", before.at("small_0002.png").substr(0, 300));
  std::string flipped = before.at("other_0003.png");
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
  test::spill(folder_ / "a/other_0003.png", flipped);
  test::spill(folder_ / "a/other_0004.png", before.at("other_0005.png"));
  expect(frames("a", {"--resume"}), 0, {"small_0001.png\n", "small_0002.png\n", "other_0003.png\n", "other_0004.png\n"});
  EXPECT_EQ(contents("a"), before);
  expect(frames("a", {"--resume"}), 0, {});
  EXPECT_EQ(frames("a", {"--resume"}).out, "") << "nothing is left to do";
  // Another seed is other work: all of it is done anew.
  EXPECT_EQ(lines(frames("a", {"--resume", "--seed", "77"}).out), 12u);
  EXPECT_NE(contents("a"), before);
}

TEST_F(RenderPipeline, ResumeNeedsNoGraphicsWhereNothingIsLeft) {
  small({"-o", folder_ / "a.png"});
  EXPECT_EQ(render({preset("small"), "--size", "64x36", "-o", folder_ / "a.png", "--resume"}, {{"NPSEE_OSMESA", "libNone.so"}}).exit_code, 0);
  EXPECT_EQ(render({preset("small"), "--size", "64x36", "-o", folder_ / "a.png"}, {{"NPSEE_OSMESA", "libNone.so"}}).exit_code, 4);
}

TEST_F(RenderPipeline, FramesOfTwoBuildsAreNotMixedUnlessThatIsAskedFor) {
  const auto result = small({"-o", folder_ / "a.png", "--summary", "json"});
  const std::string build = nlohmann::json::parse(result.out)["build"];
  ASSERT_GE(build.size(), 16u);
  // Another build: the same program, but for the identifier in it.
  std::string program = test::slurp(test::npseePath()), id;
  for (std::size_t i = 0; i + 1 < build.size(); i += 2) id += static_cast<char>(std::stoi(build.substr(i, 2), nullptr, 16));
  const std::size_t at = program.find(id);
  ASSERT_NE(at, std::string::npos);
  program[at] = static_cast<char>(program[at] ^ 1);
  const std::string other = folder_ / "other_build";
  test::spill(other, program);
  fs::permissions(other, fs::perms::owner_all);
  const auto run = [&](Words more) {
    more.insert(more.begin(), {"render", preset("small"), "--size", "64x36", "-o", folder_ / "a.png"});
    return test::run(other, more);
  };
  const auto verified = run({"--verify"});
  EXPECT_EQ(verified.exit_code, 1) << verified.err;
  EXPECT_NE(verified.out.find("a.png"), std::string::npos);
  expect(run({"--verify", "--any-build"}), 0, {});
  EXPECT_EQ(run({"--resume", "--any-build"}).out, "");
  EXPECT_EQ(lines(run({"--resume"}).out), 1u) << "drawn anew";
  EXPECT_EQ(small({"-o", folder_ / "a.png", "--verify"}).exit_code, 1) << "now it is the other's";
  expect(small({"-o", folder_ / "a.png", "--any-build"}), 2, {}, {"--resume or --verify"});
}

TEST_F(RenderPipeline, EveryOptionThatChangesThePictureChangesItsRecipe) {
  const auto recipe = [&](Words words) {
    words.insert(words.end(), {"-o", folder_ / "a.png", "--dry-run", "--summary", "json"});
    return nlohmann::json::parse(small(words).out)["files"][0]["recipe"].get<std::string>();
  };
  const std::string plain = recipe({});
  EXPECT_EQ(recipe({"--time", "25%"}), plain);
  EXPECT_EQ(recipe({"-j", "5"}), plain);
  EXPECT_EQ(recipe({"--camera", "auto", "--background", "sky"}), plain);
  std::set<std::string> all{plain};
  for (const Words& words : std::vector<Words>{{"--time", "1"}, {"--time", "30%"}, {"--seed", "5"}, {"--set", "gravity=5"}, {"--camera", "top"}, {"--background", "black"}, {"--background", "transparent"}, {"--sheet", "2x2"},
                                               {"--sheet", "2x3"}, {"--sheet", "2x2", "--frames", "0:1"}, {"--template"}, {"--template", "--view", "splines"}, {"--quality", "draft"}, {"--quality", "fine"}})
    all.insert(recipe(words));
  EXPECT_EQ(all.size(), 15u);
  EXPECT_EQ(recipe({"--quality", "normal"}), plain);
}

TEST_F(RenderPipeline, ADryRunPrintsThePlanAndWritesNothing) {
  const auto result = render({preset("small"), preset("other"), "--frames", "0:0.6", "--fps", "10", "-o", folder("a"), "--dry-run"}, {{"NPSEE_OSMESA", "libNone.so"}});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(lines(result.out), 12u);
  EXPECT_TRUE(files("a").empty());
  frames("a", {"--shard", "1/2"});
  EXPECT_EQ(lines(frames("a", {"--dry-run", "--resume"}).out), 6u) << "what is left";
  EXPECT_EQ(lines(frames("a", {"--dry-run"}).out), 12u);
}

TEST_F(RenderPipeline, VerifyNamesWhatIsMissingAndExitsOne) {
  frames("a");
  expect(frames("a", {"--verify"}), 0, {});
  EXPECT_EQ(frames("a", {"--verify"}).out, "");
  fs::remove(folder_ / "a/other_0002.png");
  test::spill(folder_ / "a/small_0004.png", "damaged");
  const auto result = frames("a", {"--verify"});
  expect(result, 1, {"small_0004.png\n", "other_0002.png\n"});
  EXPECT_EQ(lines(result.out), 2u);
  EXPECT_FALSE(fs::exists(folder_ / "a/other_0002.png"));
}

TEST_F(RenderPipeline, TheJsonSummaryTellsWhatWasDone) {
  fs::create_directory(folder_ / "a");
  frames("a", {"--shard", "1/2"});
  const auto json = nlohmann::json::parse(frames("a", {"--resume", "--summary", "json"}).out);
  EXPECT_EQ(json["written"], 6);
  EXPECT_EQ(json["skipped"], 6);
  EXPECT_EQ(json["planned"], 0);
  EXPECT_EQ(json["width"], 64);
  EXPECT_NE(json["driver"].get<std::string>().find("llvmpipe"), std::string::npos);
  EXPECT_NE(json["processor"].get<std::string>(), "");
  ASSERT_EQ(json["files"].size(), 12u);
  EXPECT_EQ(json["files"][3]["file"], folder_ / "a/small_0003.png");
  EXPECT_EQ(json["files"][3]["number"], 3);
  EXPECT_EQ(json["files"][3]["time_s"], 0.3);
  EXPECT_EQ(json["files"][3]["preset"], preset("small"));
  EXPECT_EQ(json["files"][2]["state"], "skipped");
  EXPECT_EQ(json["files"][3]["state"], "written");
  const auto verified = nlohmann::json::parse(frames("b", {"--verify", "--summary", "json"}).out);
  EXPECT_EQ(verified["missing"], 12);
}

TEST_F(RenderPipeline, SeveralMomentsAreNumberedPictures) {
  expect(small({"--time", "0,500ms, 50%", "-o", folder_ / "a_%d.png"}), 0, {"a_0.png", "a_1.png", "a_2.png"});
  small({"--time", "500ms", "-o", folder_ / "half.png"});
  EXPECT_EQ(test::slurp(folder_ / "half.png"), test::slurp(folder_ / "a_1.png"));
  EXPECT_EQ(files().size(), 4u);
  small({"--time", "10%,20%", "-o", folder("b")});
  EXPECT_EQ(files("b"), (std::set<std::string>{"small_0000.png", "small_0001.png"}));
}

TEST_F(RenderPipeline, OptionsThatCannotBeMeantExitTwo) {
  const std::string out = folder_ / "a.png";
  for (const char* shard : {"0/3", "4/3", "3", "a/b", "1/2/3", "-1/3", "1/1000000"}) expect(small({"-o", out, "--shard", shard}), 2, {}, {"--shard 2/5"});
  expect(small({"-o", out, "--time", "101%"}), 2, {}, {"--time 25%"});
  expect(small({"-o", out, "--time", "1,soon"}), 2, {}, {"--time 1,soon"});
  std::string many = "1";
  for (int i = 0; i < 1000; ++i) many += ",1";
  expect(small({"-o", out, "--time", many}), 2, {}, {"more than 1000 moments"});
  expect(small({"-o", out, "--summary", "xml"}), 2, {}, {"text or json"});
  expect(small({"-o", out, "--progress", "often"}), 2, {}, {"auto, never or always"});
  expect(small({"-o", out, "--verify", "--resume"}), 2, {}, {"--verify only looks"});
  expect(small({"-o", out, "--verify", "--dry-run"}), 2, {}, {"--verify only looks"});
  EXPECT_TRUE(files().empty());
}

TEST_F(RenderPipeline, ProgressIsWrittenAsLinesForLogsWhenAskedFor) {
  const auto result = frames("a", {"--progress", "always"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("frame 12 of 12, 100 %"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\r'), std::string::npos);
  EXPECT_EQ(frames("b", {"--progress", "never"}).err, "");
}

// A batch system's time limit is a SIGTERM.
TEST_F(RenderPipeline, ASignalEndsTheRunBetweenFramesAndResumeGoesOn) {
  const std::string script = R"("$0" render "$1" -o "$2/a_%04d.png" --frames 0:1000 --fps 10 --size 64x36 & child=$!
    until [ -e "$2/a_0003.png" ]; do sleep 0.01; done; kill -TERM $child; wait $child)";
  const auto result = test::run("/bin/bash", {"-c", script, test::npseePath(), preset("small"), folder_.path()});
  EXPECT_EQ(result.exit_code, 128 + 15) << "ended by the signal";
  EXPECT_NE(result.err.find("--resume"), std::string::npos) << result.err;
  std::size_t count = 0;
  for (const std::string& name : files()) {
    EXPECT_TRUE(name.starts_with("a_")) << "left behind: " << name;
    EXPECT_TRUE(render::readPng(folder_ / name)) << name;
    ++count;
  }
  EXPECT_LT(count, 10'000u);
  const auto left = small({"--frames", "0:1000", "--fps", "10", "-o", folder_ / "a_%04d.png", "--resume", "--dry-run"});
  EXPECT_EQ(lines(left.out), 10'000u - count) << "each frame that is there is whole and need not be drawn again";
}

}  // namespace
}  // namespace npsee
