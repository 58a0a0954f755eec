// Videos, sprite sheets with their index, captions: what is written and what is refused.
#include "app/render/image_compare.h"
#include "tests/support/render_command.h"

#include <nlohmann/json.hpp>

#include <cmath>

#include <sys/stat.h>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using test::Words;

class RenderOutputs : public test::RenderFixture {
 protected:
  /// What ffprobe says about the first stream.
  static nlohmann::json probed(const std::string& path) {
    const auto result = test::run("/usr/bin/ffprobe", {"-v", "error", "-count_frames", "-show_streams", "-of", "json", path});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(result.out)["streams"][0];
  }
  /// Frame `number` of a video as a picture.
  render::Image frameOf(const std::string& path, int number) const {
    const std::string out = folder_ / "decoded.png";
    Words words{"-v", "error", "-y"};
    if (path.ends_with(".webm")) words.insert(words.end(), {"-c:v", "libvpx-vp9"});  // ffmpeg's own decoder leaves alpha out
    words.insert(words.end(), {"-i", path, "-vf", "select=eq(n\\," + std::to_string(number) + ")", "-frames:v", "1", "-pix_fmt", "rgba", out});
    const auto result = test::run("/usr/bin/ffmpeg", words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto image = render::readPng(out);
    fs::remove(out);
    return image ? *image : render::Image{};
  }
  render::Image picture(Words words) const {
    words.insert(words.end(), {"-o", folder_ / "picture.png"});
    EXPECT_EQ(small(words).exit_code, 0);
    const auto image = render::readPng(folder_ / "picture.png");
    fs::remove(folder_ / "picture.png");
    return image ? *image : render::Image{};
  }
};

TEST_F(RenderOutputs, QualitiesAreThreePicturesOfTheSame) {
  const render::Image normal = picture({"--time", "0.3"}), draft = picture({"--time", "0.3", "--quality", "draft"}), fine = picture({"--time", "0.3", "--quality", "fine"});
  EXPECT_EQ(picture({"--time", "0.3", "--quality", "normal"}).rgba, normal.rgba);
  for (const render::Image* other : {&draft, &fine}) {
    const auto d = render::compareImages(render::deepened(normal), render::deepened(*other));
    EXPECT_GT(d.max, 0.0);
    EXPECT_GT(d.ssim, 0.8);
  }
  expect(small({"--quality", "best", "-o", folder_ / "a.png"}), 2, {}, {"--quality best", "draft, normal or fine"});
}

TEST_F(RenderOutputs, ResumeDrawsPicturesOfAnotherQualityAnew) {
  const std::string path = folder_ / "a.png";
  expect(small({"--quality", "draft", "-o", path}), 0, {path});
  EXPECT_EQ(small({"--quality", "draft", "--resume", "-o", path}).out, "");
  expect(small({"--resume", "-o", path}), 0, {path});
  const auto summary = nlohmann::json::parse(small({"--quality", "fine", "--resume", "--summary", "json", "-o", path}).out);
  EXPECT_EQ(summary["quality"], "fine");
  EXPECT_EQ(summary["written"], 1);
}

TEST_F(RenderOutputs, VideosHoldTheFramesOfTheSequence) {
  const render::Image third = picture({"--time", "0.2"});
  for (const std::string name : {"a.mp4", "a.webm", "a.gif"}) {
    const std::string path = folder_ / name;
    expect(small({"--frames", "0:1", "--fps", "10", "-o", path}), 0, {path + "\n"});
    const auto stream = probed(path);
    EXPECT_EQ(stream["width"], 64) << name;
    EXPECT_EQ(stream["height"], 36) << name;
    EXPECT_EQ(stream["nb_read_frames"], "10") << name;
    EXPECT_EQ(stream["r_frame_rate"], "10/1") << name;
    // Encoders lose some; another frame differs far more.
    const auto d = render::compareImages(render::deepened(third), render::deepened(frameOf(path, 2)));
    EXPECT_LT(d.mean, name == "a.gif" ? 6.0 : 4.0) << name;
    EXPECT_GT(d.ssim, 0.9) << name;
  }
  EXPECT_EQ(files(), (std::set<std::string>{"a.mp4", "a.webm", "a.gif"})) << "nothing else is left";
}

TEST_F(RenderOutputs, AVideoWithoutARangeShowsTheWholeEffect) {
  const auto planned = test::npseeRun({"render", preset("small"), "-o", folder_ / "a.mp4", "--size", "64x36", "--fps", "5"});
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
  const int frames = std::stoi(probed(folder_ / "a.mp4")["nb_read_frames"].get<std::string>());
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 200);
}

TEST_F(RenderOutputs, VideosHaveTheSameBytesOnEveryRunAndForEveryNumberOfThreads) {
  for (const std::string ending : {".mp4", ".webm", ".gif"}) {
    small({"--frames", "0:0.5", "--fps", "10", "-o", folder_ / ("a" + ending), "-j", "1"});
    small({"--frames", "0:0.5", "--fps", "10", "-o", folder_ / ("b" + ending), "-j", "5"});
    EXPECT_FALSE(test::slurp(folder_ / ("a" + ending)).empty());
    EXPECT_EQ(test::slurp(folder_ / ("a" + ending)), test::slurp(folder_ / ("b" + ending))) << ending;
  }
}

TEST_F(RenderOutputs, WebmAndGifKeepTransparency) {
  for (const std::string name : {"a.webm", "a.gif"}) {
    small({"--frames", "0:0.5", "--fps", "10", "--background", "transparent", "-o", folder_ / name});
    const render::Image frame = frameOf(folder_ / name, 3);
    ASSERT_EQ(frame.width, 64);
    EXPECT_LT(frame.pixel(0, 0)[3], 8) << name;
    int opaque = 0;
    for (std::size_t i = 3; i < frame.rgba.size(); i += 4) opaque += frame.rgba[i] > 200 ? 1 : 0;
    EXPECT_GT(opaque, 20) << name;
  }
}

TEST_F(RenderOutputs, ResumeKnowsFinishedVideos) {
  for (const std::string name : {"a.mp4", "a.webm", "a.gif"}) {
    const Words words{"--frames", "0:0.3", "--fps", "10", "--resume", "-o", folder_ / name};
    EXPECT_EQ(small(words).out, (folder_ / name) + "\n");
    EXPECT_EQ(small(words).out, "") << name;
    Words other = words;
    other.insert(other.end(), {"--seed", "9"});
    EXPECT_EQ(small(other).out, (folder_ / name) + "\n") << name;
  }
}

TEST_F(RenderOutputs, SeveralVideosGoIntoAFolder) {
  expect(render({preset("small"), preset("other"), "--format", "gif", "--frames", "0:0.2", "--fps", "10", "--size", "64x36", "-o", folder("v")}), 0, {"small.gif", "other.gif"});
  EXPECT_EQ(files("v"), (std::set<std::string>{"small.gif", "other.gif"}));
}

TEST_F(RenderOutputs, NamesAreTakenAsTheyAreAndNoShellSeesThem) {
  for (const std::string name : {"a b; touch c.mp4", "-i.mp4", "%03d $(x) 'q\".gif", "concat:x|y.webm"}) {
    const auto result = test::run(test::npseePath(), {"render", preset("small"), "--size", "64x36", "--frames", "0:0.2", "--fps", "10", "-o", "./" + name}, {}, folder_.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(files(), std::set<std::string>{name});
    fs::remove(fs::path(folder_.path()) / name);
  }
}

TEST_F(RenderOutputs, WithoutFfmpegNothingIsDrawnAndThePackageIsNamed) {
  for (const char* program : {"/no/such/ffmpeg", "no-such-ffmpeg"}) {
    const auto result = render({preset("small"), "-o", folder_ / "a.mp4"}, {{"NPSEE_FFMPEG", program}, {"NPSEE_OSMESA", "libNone.so"}});
    expect(result, 5, {}, {"ffmpeg", program, "Debian's package ffmpeg", "frame_%04d.png"});
  }
  expect(render({preset("small"), "-o", folder_ / "a.mp4"}, {{"PATH", "/nowhere"}}), 5, {}, {"there is no ffmpeg to run"});
  EXPECT_TRUE(files().empty());
}

TEST_F(RenderOutputs, WhatFfmpegSaysWhenItFailsIsPassedOnAndNothingIsLeft) {
  test::spill(folder_ / "a.mp4", "precious");
  const std::string program = inputs_ / "failing";
  test::spill(program, "#!/bin/sh\necho 'the encoder is on strike' >&2\nexit 3\n");
  fs::permissions(program, fs::perms::owner_all);
  expect(render({preset("small"), "-o", folder_ / "a.mp4", "--size", "640x360", "--frames", "0:2"}, {{"NPSEE_FFMPEG", program}}), 5, {}, {"a.mp4", "the encoder is on strike", "nothing was changed"});
  // One that ends well at once but has read nothing.
  test::spill(program, "#!/bin/sh\nexit 0\n");
  EXPECT_EQ(render({preset("small"), "-o", folder_ / "a.mp4", "--size", "640x360", "--frames", "0:2"}, {{"NPSEE_FFMPEG", program}}).exit_code, 5);
  test::spill(program, "not a program");
  EXPECT_EQ(render({preset("small"), "-o", folder_ / "a.mp4", "--size", "64x36"}, {{"NPSEE_FFMPEG", program}}).exit_code, 5);
  EXPECT_EQ(files(), std::set<std::string>{"a.mp4"});
  EXPECT_EQ(test::slurp(folder_ / "a.mp4"), "precious");
}

// Renaming over a device would replace the device; as root, for everybody.
TEST_F(RenderOutputs, AVideoReplacesNoPipeAndNoLink) {
  const std::string pipe = folder_ / "pipe.mp4";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect(small({"-o", pipe, "--frames", "0:0.2", "--fps", "10"}), 5, {}, {"pipe.mp4", "no regular file"});
  EXPECT_TRUE(fs::is_fifo(pipe));
  test::spill(folder_ / "real.mp4", "old");
  fs::permissions(folder_ / "real.mp4", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.mp4", folder_ / "link.mp4");
  expect(small({"-o", folder_ / "link.mp4", "--frames", "0:0.2", "--fps", "10"}), 0, {"link.mp4"});
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.mp4"));
  EXPECT_EQ(probed(folder_ / "real.mp4")["nb_read_frames"], "2");
  EXPECT_EQ(fs::status(folder_ / "real.mp4").permissions(), fs::perms::owner_read | fs::perms::owner_write) << "a replaced file keeps its mode";
  EXPECT_EQ(files(), (std::set<std::string>{"pipe.mp4", "real.mp4", "link.mp4"}));
}

TEST_F(RenderOutputs, AVideoThatLostItsEndIsNotTakenForWhole) {
  for (const std::string name : {"a.mp4", "a.webm", "a.gif"}) {
    const Words words{"--frames", "0:0.3", "--fps", "10", "--verify", "-o", folder_ / name};
    small({"--frames", "0:0.3", "--fps", "10", "-o", folder_ / name});
    EXPECT_EQ(small(words).exit_code, 0) << name;
    const std::string whole = test::slurp(folder_ / name);
    test::spill(folder_ / name, whole.substr(0, whole.size() - 1));
    expect(small(words), 1, {folder_ / name});
  }
}

TEST_F(RenderOutputs, APictureGoesIntoAPipe) {
  const auto result = test::run("/bin/bash", {"-c", R"("$0" render "$1" --size 64x36 -o /dev/stdout --format png | cat >"$2")", test::npseePath(), preset("small"), folder_ / "piped.png"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  small({"-o", folder_ / "plain.png"});
  EXPECT_EQ(test::slurp(folder_ / "piped.png"), test::slurp(folder_ / "plain.png")) << "and nothing else does";
}

TEST_F(RenderOutputs, WhatAVideoCannotBeExitsTwo) {
  const std::string mp4 = folder_ / "a.mp4", gif = folder_ / "a.gif";
  expect(render({preset("small"), "-o", mp4, "--size", "63x36"}), 2, {}, {"--size 63x36", "even numbers"});
  expect(small({"-o", mp4, "--background", "transparent"}), 2, {}, {"mp4 videos cannot be transparent", ".webm"});
  expect(render({preset("small"), "-o", gif, "--frames", "0:60", "--fps", "30", "--size", "1280x720"}), 2, {}, {"1800 frames", "more than 2 GB", "--size"});
  expect(small({"-o", mp4, "--time", "1"}), 2, {}, {"in motion"});
  expect(small({"-o", mp4, "--sheet", "2x2"}), 2, {}, {"in motion"});
  expect(small({"-o", mp4, "--template"}), 2, {}, {"in motion"});
  expect(small({"-o", mp4, "--fps", "0"}), 2, {}, {"--fps 0"});
  expect(small({"-o", mp4, "--frames", "1:1"}), 2, {}, {"--frames 1:1", "the range is empty"});
  expect(small({"-o", mp4, "--frames", "1:1.01", "--fps", "10"}), 0, {"a.mp4"});
  fs::remove(mp4);
  expect(small({"-o", mp4, "--frames", "1.01:1.02", "--fps", "10"}), 2, {}, {"no frame of 10 per second"});
  expect(small({"-o", mp4, "--golden", folder("g")}), 2, {}, {"goldens are PNG pictures"});
  expect(small({"-o", folder_ / "a.avi"}), 2, {}, {".mp4, .webm or .gif"});
  expect(small({"-o", mp4, "--format", "gif"}), 2, {}, {"contradict each other"});
  expect(small({"-o", folder("g"), "--format", "tiff"}), 2, {}, {"--format tiff", "png, exr, mp4, webm or gif"});
  EXPECT_EQ(render({preset("small"), "-o", gif, "--size", "63x35", "--frames", "0:0.1"}).exit_code, 0) << "a GIF may have any size";
}

TEST_F(RenderOutputs, TheIndexOfASheetTellsEnginesWhereThePicturesAre) {
  expect(small({"--sheet", "3x2", "--frames", "0:1.2", "--camera", "eye=0,0,10 target=0,0,0 fov=40deg", "--background", "transparent", "--index", "-o", folder_ / "sprites.png"}), 0, {"sprites.png"});
  const auto json = nlohmann::json::parse(test::slurp(folder_ / "sprites.json"));
  ASSERT_EQ(json["frames"].size(), 6u);
  const auto& fifth = json["frames"][4];
  EXPECT_EQ(fifth["filename"], "small_0004");
  EXPECT_EQ(fifth["frame"], (nlohmann::json{{"x", 64}, {"y", 36}, {"w", 64}, {"h", 36}}));
  EXPECT_EQ(fifth["sourceSize"], (nlohmann::json{{"w", 64}, {"h", 36}}));
  EXPECT_EQ(fifth["rotated"], false);
  EXPECT_NEAR(fifth["duration"].get<double>(), 200.0, 1e-9);
  // The camera looks at the burst from the side, so it lies in the middle; the scale follows from the field of view.
  EXPECT_NEAR(fifth["pivot"]["x"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(fifth["pivot"]["y"].get<double>(), 0.5, 1e-6);
  const auto& meta = json["meta"];
  EXPECT_EQ(meta["image"], "sprites.png");
  EXPECT_EQ(meta["size"], (nlohmann::json{{"w", 192}, {"h", 72}}));
  EXPECT_NEAR(meta["pixels_per_metre"].get<double>(), 36.0 / (2.0 * 10.0 * std::tan(20.0 * 3.14159265358979 / 180.0)), 1e-6);
  EXPECT_NEAR(meta["times_s"][4].get<double>(), 0.8, 1e-12);
  EXPECT_EQ(meta["frameTags"][0]["to"], 5);
  const auto sheet = render::readPng(folder_ / "sprites.png");
  EXPECT_EQ(sheet->width, 192);
  EXPECT_EQ(sheet->height, 72);
}

TEST_F(RenderOutputs, APivotIsWhereTheBurstIsDrawn) {
  // A single particle that stays at the burst.
  test::spill(preset("dot"), R"({"npsee": 1, "gravity": 0, "layers": [{"name": "dot", "count": 1, "region": {"shape": "point"}, "speed_mean": 0, "size_mean": 0.4, "form": "sphere", "lifetime_mean": 9}]})");
  const auto result = render({preset("dot"), "--sheet", "1x1", "--size", "200x120", "--camera", "eye=3,2,9 target=1,1,0", "--background", "transparent", "--index", "-o", folder_ / "dot.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto image = render::readPng(folder_ / "dot.png");
  double x = 0, y = 0, sum = 0;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 200; ++u) {
      const double a = image->pixel(u, v)[3];
      x += a * (u + 0.5), y += a * (v + 0.5), sum += a;
    }
  ASSERT_GT(sum, 0.0);
  const auto pivot = nlohmann::json::parse(test::slurp(folder_ / "dot.json"))["frames"][0]["pivot"];
  EXPECT_NEAR(pivot["x"].get<double>() * 200.0, x / sum, 1.5);
  // A piece on the ground is lifted onto it by up to half its size.
  EXPECT_NEAR(pivot["y"].get<double>() * 120.0, y / sum, 5.0);
}

TEST_F(RenderOutputs, ResumeDrawsASheetAgainWhoseIndexIsMissing) {
  const Words words{"--sheet", "2x1", "--index", "--resume", "-o", folder_ / "s.png"};
  EXPECT_NE(small(words).out, "");
  EXPECT_EQ(small(words).out, "");
  fs::remove(folder_ / "s.json");
  EXPECT_NE(small(words).out, "");
  EXPECT_TRUE(fs::exists(folder_ / "s.json"));
}

TEST_F(RenderOutputs, CaptionsSayWhatIsWanted) {
  const Words sheet{"--sheet", "1x1", "--frames", "0.5:0.6", "--size", "320x180"};
  const auto with = [&](const Words& more) {
    Words words{preset("small")};
    words.insert(words.end(), sheet.begin(), sheet.end());
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), {"-o", folder_ / "s.png"});
    const auto result = render(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return render::readPng(folder_ / "s.png")->rgba;
  };
  const auto plain = with({});
  EXPECT_EQ(with({"--caption", "t={time} s"}), plain);
  EXPECT_EQ(with({"--caption", "t=0.50 s"}), plain);
  const auto none = with({"--caption", "none"});
  EXPECT_NE(none, plain);
  render(Words{preset("small"), "--time", "0.5", "--size", "320x180", "-o", folder_ / "alone.png"});
  EXPECT_EQ(none, render::readPng(folder_ / "alone.png")->rgba);
  EXPECT_EQ(with({"--caption", "{name} {frame} {seed} {title}"}), with({"--caption", "small 0 1993 small"}));
  EXPECT_NE(with({"--caption", "aaaa"}), with({"--caption", "bbbb"}));
  EXPECT_EQ(with({"--caption", "a {brace"}), with({"--caption", "a {brace"}));
  EXPECT_NE(with({"--background", "transparent", "--caption", "x"}), with({"--background", "transparent"}));
}

TEST_F(RenderOutputs, SheetOptionsElsewhereAreRefused) {
  const std::string out = folder_ / "a.png";
  expect(small({"-o", out, "--index"}), 2, {}, {"--index and --caption belong to a sheet"});
  expect(small({"-o", out, "--caption", "x"}), 2, {}, {"--sheet 4x4"});
  expect(small({"-o", out, "--sheet", "2x2", "--caption", "{tme}"}), 2, {}, {"there is no {tme}", "Did you mean {time}?"});
  expect(small({"--golden", folder("g"), "--sheet", "2x2", "--index"}), 2, {}, {"--format and --index"});
}

}  // namespace
}  // namespace npsee
