// `npsee compare` as users call it.
#include "app/render/deep_image.h"
#include "app/render/exr.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class CompareCommand : public ::testing::Test {
 protected:
  static render::Image picture(int width, int height, int alpha = 255) {
    render::Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i)
      for (const int v : {i * 3, i / 7, 200, alpha}) image.rgba.push_back(static_cast<std::uint8_t>(v & 255));
    return image;
  }
  /// Writes a picture with one component changed by so many levels.
  std::string write(const std::string& name, int change = 0, int alpha = 255) const {
    render::Image image = picture(20, 10, alpha);
    image.pixel(12, 7)[2] = static_cast<std::uint8_t>(200 + change);
    const std::string path = folder_ / name;
    fs::create_directories(fs::path(path).parent_path());
    EXPECT_TRUE(render::writePng(image, path));
    return path;
  }
  static test::ProcessResult compare(Words words) {
    words.insert(words.begin(), "compare");
    return test::npseeRun(words);
  }
  static void expect(int code, const Words& words, const Words& out, const Words& err = {}) {
    const auto result = compare(words);
    EXPECT_EQ(result.exit_code, code) << result.out << result.err;
    for (const std::string& word : out) EXPECT_NE(result.out.find(word), std::string::npos) << '"' << word << "\" in: " << result.out;
    for (const std::string& word : err) EXPECT_NE(result.err.find(word), std::string::npos) << '"' << word << "\" in: " << result.err;
    EXPECT_EQ(result.err.empty(), err.empty()) << result.err;
  }

  test::TemporaryFolder folder_;
};

TEST_F(CompareCommand, EqualPicturesExitZero) { expect(0, {write("a.png"), write("b.png")}, {"a.png", "same"}); }

TEST_F(CompareCommand, DifferentPicturesExitOneAndSayHowMuchAndWhere) {
  expect(1, {write("a.png"), write("b.png", 5)}, {"different", "max 5 of 255", "mean 0.00833", "SSIM 0.", "1 of 200 pixels differ (0.5 %)", "1 by more than 2", "at 12,7: ", "200,255 became", "205,255", "not met: max 5 is above 0"});
}

TEST_F(CompareCommand, EachToleranceDecides) {
  const std::string a = write("a.png"), b = write("b.png", 5);
  expect(0, {a, b, "--max", "5"}, {"within the tolerance"});
  expect(1, {a, b, "--max", "4.9"}, {"max 5 is above 4.9"});
  expect(0, {a, b, "--mean", "0.01"}, {"within"});
  expect(1, {a, b, "--mean", "0.001"}, {"mean", "is above 0.001"});
  expect(0, {a, b, "--pixels", "0.5% over 2"}, {"within"});
  expect(0, {a, b, "--pixels", "0% over 5"}, {"within"});
  expect(1, {a, b, "--pixels", "0.4% over 2"}, {"1 of 200 pixels differ by more than 2, above 0.4 %"});
  expect(1, {a, b, "--pixels", "0.4 %"}, {"by more than 0"});
  expect(0, {a, b, "--ssim", "0.9"}, {"within"});
  expect(1, {a, b, "--ssim", "1"}, {"is below 1"});
  expect(1, {a, b, "--max", "9", "--ssim", "1"}, {"is below 1"});
}

TEST_F(CompareCommand, TolerancesThatCannotBeMeantExitTwo) {
  const std::string a = write("a.png");
  expect(2, {a, a, "--max", "many"}, {}, {"--max many", "0 to 255"});
  expect(2, {a, a, "--max", "256"}, {}, {"--max 256"});
  expect(2, {a, a, "--mean", "-1"}, {}, {"--mean -1"});
  expect(2, {a, a, "--ssim", "1.5"}, {}, {"-1 to 1"});
  expect(2, {a, a, "--max", "nan"}, {}, {"--max nan"});
  for (const char* text : {"3", "3%over", "% over 2", "101% over 2", "1% over 300", "1% above 2"}) expect(2, {a, a, "--pixels", text}, {}, {"0.01% over 2"});
  expect(2, {a}, {}, {"--help"});
  expect(2, {a, a, "--jobs", "0"}, {}, {"--jobs"});
}

TEST_F(CompareCommand, AlphaCountsAsAComponent) { expect(1, {write("a.png"), write("b.png", 0, 250)}, {"max 5 of 255"}); }

TEST_F(CompareCommand, SixteenBitPicturesDifferByFractions) {
  render::DeepImage image = render::deepened(picture(20, 10));
  for (const char* name : {"a.png", "b.png"}) {
    const auto bytes = render::encodeDeepPng(image);
    test::spill(folder_ / name, std::string(bytes->begin(), bytes->end()));
    image.pixel(3, 4)[0] = static_cast<std::uint16_t>(image.pixel(3, 4)[0] + 257 / 2);
  }
  expect(1, {folder_ / "a.png", folder_ / "b.png"}, {"max 0.498 of 255"});
  expect(0, {folder_ / "a.png", folder_ / "b.png", "--max", "0.5"}, {"within"});
  expect(0, {folder_ / "a.png", write("eight.png", 0), "--max", "0"}, {"same"});
}

/// An OpenEXR file of 8 x 4 pixels with all passes, changed by `change`.
std::string writeExr(const std::string& path, const std::function<void(render::FloatImage&)>& change = {}) {
  render::FloatImage image{8, 4, std::vector<float>(128, 0.5f), std::vector<float>(32, 20.0f), std::vector<float>(64, 1.5f)};
  image.depth[0] = std::numeric_limits<float>::infinity();
  if (change) change(image);
  const auto bytes = render::encodeExr(image, "");
  EXPECT_TRUE(bytes);
  test::spill(path, std::string(bytes->begin(), bytes->end()));
  return path;
}

TEST_F(CompareCommand, OpenExrPicturesAreComparedAsSeenAndPassByPass) {
  const std::string a = writeExr(folder_ / "a.exr");
  expect(0, {a, writeExr(folder_ / "b.exr")}, {"same"});
  // Pixel 11 is at 3,1.
  const std::string light = writeExr(folder_ / "light.exr", [](auto& image) { image.rgba[44] = 0.75f; });
  expect(1, {a, light}, {"different", "of 255", "light: max 0.25", "at 3,1: 0.5,0.5,0.5,0.5 became 0.75,0.5,0.5,0.5", "not met: light: max 0.25 is above 0"});
  expect(0, {a, light, "--max", "64"}, {"within"});
  expect(0, {a, light, "--light", "0.25"}, {"within"});
  expect(1, {a, light, "--light", "0.2"}, {"light: max 0.25 is above 0.2"});
  const std::string depth = writeExr(folder_ / "depth.exr", [](auto& image) { image.depth[11] = 20.5f; });
  expect(1, {a, depth}, {"depth: max 0.5 m, mean 0.01562 m, 1 pixels differ; at 3,1: 20 became 20.5", "not met: depth: max 0.5 m is above 0 m"});
  expect(0, {a, depth, "--depth", "0.5"}, {"within"});
  expect(0, {a, depth, "--max", "0"}, {"within"});
  const std::string motion = writeExr(folder_ / "motion.exr", [](auto& image) { image.motion[23] = 0.0f; });
  expect(1, {a, motion, "--motion", "1"}, {"motion: max 1.5 pixels is above 1 pixels", "at 3,1: 1.5,1.5 became 1.5,0"});
}

TEST_F(CompareCommand, ASurfaceOrAPassInOnlyOneOfThemIsADifference) {
  const std::string a = writeExr(folder_ / "a.exr");
  const std::string open = writeExr(folder_ / "open.exr", [](auto& image) { image.depth[0] = 4.0f; });
  expect(1, {a, open, "--depth", "1000"}, {"1 have one in only one of them", "not met: depth: 1 pixels have one in only one"});
  expect(1, {a, writeExr(folder_ / "flat.exr", [](auto& image) { image.depth.clear(); })}, {"only one of them holds depth"});
  const auto json = nlohmann::json::parse(compare({a, open, "--json"}).out);
  EXPECT_EQ(json["results"][0]["passes"][1]["pixels_in_one"], 1);
  EXPECT_EQ(json["results"][0]["passes"][2]["max"], 0.0);
}

TEST_F(CompareCommand, AnOpenExrPictureLooksAsItsPngDoes) {
  test::spill(folder_ / "p.npsee.json", R"({"npsee": 1, "layers": [{"name": "fragments", "count": 60, "size_mean": 1}, {"name": "smoke", "count": 9, "form": "smoke", "opacity": 0.8}]})");
  for (const char* name : {"p.png", "p.exr"})
    EXPECT_EQ(test::npseeRun({"render", folder_ / "p.npsee.json", "-o", folder_ / name, "--time", "0.3", "--size", "160x90", "--background", "transparent"}).exit_code, 0);
  // One level of rounding to eight bits, and what is left of it in half floats.
  expect(0, {folder_ / "p.png", folder_ / "p.exr", "--max", "2.5", "--ssim", "0.99"}, {"within"});
}

TEST_F(CompareCommand, OpenExrFilesThatCannotBeReadExitThree) {
  const std::string a = writeExr(folder_ / "a.exr"), bytes = test::slurp(a);
  test::spill(folder_ / "cut.exr", bytes.substr(0, bytes.size() / 2));
  test::spill(folder_ / "text.exr", "no picture");
  expect(3, {a, folder_ / "cut.exr"}, {"unreadable"}, {"cut.exr", "OpenEXR"});
  expect(3, {folder_ / "text.exr", a}, {"unreadable"}, {"text.exr", "OpenEXR"});
  expect(2, {a, a, "--depth", "deep"}, {}, {"--depth deep"});
}

TEST_F(CompareCommand, PicturesOfDifferentSizeExitOne) {
  ASSERT_TRUE(render::writePng(picture(10, 10), folder_ / "small.png"));
  expect(1, {write("a.png"), folder_ / "small.png", "--max", "255", "-o", folder_ / "d.png"}, {"sizes differ", "20 x 10", "10 x 10"});
  EXPECT_FALSE(fs::exists(folder_ / "d.png"));
}

TEST_F(CompareCommand, WritesADifferencePicture) {
  expect(1, {write("a.png"), write("b.png", 5), "-o", folder_ / "d.png"}, {"different"});
  const auto read = render::readPng(folder_ / "d.png");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->width, 20);
  EXPECT_NE(read->pixel(12, 7)[0], read->pixel(12, 7)[2]);
  EXPECT_EQ(read->pixel(11, 7)[0], read->pixel(11, 7)[2]);
}

TEST_F(CompareCommand, PlacesThatCannotBeWrittenExitFiveAndInputsAreNeverOverwritten) {
  const std::string a = write("a.png"), b = write("b.png", 5), before = test::slurp(a);
  expect(5, {a, b, "-o", folder_ / "none/d.png"}, {}, {"none/d.png", "does not exist"});
  expect(5, {a, b, "-o", folder_ / (std::string(300, 'n') + ".png")}, {}, {"nnn.png", "File name too long"});
  expect(2, {a, b, "-o", a}, {}, {"is one of the inputs"});
  expect(2, {a, b, "-o", folder_ / "d.jpg"}, {}, {".png"});
  EXPECT_EQ(test::slurp(a), before);
  write("x/1.png"), write("y/1.png", 2);
  expect(2, {folder_ / "x", folder_ / "y", "-o", folder_ / "y"}, {}, {"is one of the inputs"});
  expect(5, {folder_ / "x", folder_ / "y", "-o", folder_ / "none"}, {}, {"is no folder"});
}

TEST_F(CompareCommand, UnreadablePicturesExitThreeAndAreNamed) {
  const std::string a = write("a.png");
  test::spill(folder_ / "text.png", "no picture");
  std::string huge = test::slurp(a);
  for (const std::size_t at : {16u, 20u}) huge.replace(at, 4, std::string("\x7f\xff\xff\xff", 4));
  test::spill(folder_ / "huge.png", huge);
  expect(3, {a, folder_ / "text.png"}, {"unreadable"}, {"text.png", "not a PNG file"});
  expect(3, {folder_ / "huge.png", a}, {"unreadable"}, {"huge.png"});
  expect(3, {a, folder_ / "missing.png"}, {"unreadable"}, {"missing.png", "no such file"});
  expect(3, {"/dev/zero", a}, {}, {"/dev/zero", "not a regular file"});
}

TEST_F(CompareCommand, FoldersAreComparedNameByName) {
  for (const char* name : {"same.png", "sub/near.png", "sub/far.png", "old.png"}) write("x/" + std::string(name));
  write("y/same.png"), write("y/sub/near.png", 1), write("y/sub/far.png", 50), write("y/new.png");
  test::spill(folder_ / "x/notes.txt", "not a picture");
  fs::create_directory(folder_ / "d");
  const auto result = compare({folder_ / "x", folder_ / "y", "--max", "2", "-o", folder_ / "d"});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_EQ(result.out.find("same.png"), std::string::npos) << "what is equal is only counted";
  for (const char* word : {"sub/near.png: within", "sub/far.png: different", "old.png: missing", "only in the first", "new.png: missing", "only in the second", "5 pairs: 1 same, 1 within the tolerance, 3 different or missing"})
    EXPECT_NE(result.out.find(word), std::string::npos) << word << result.out;
  EXPECT_TRUE(fs::exists(folder_ / "d/sub/near.png"));
  EXPECT_TRUE(fs::exists(folder_ / "d/sub/far.png"));
  EXPECT_FALSE(fs::exists(folder_ / "d/same.png"));
}

TEST_F(CompareCommand, AFolderIsNoPicture) {
  write("x/1.png");
  fs::create_directories(folder_ / "empty");
  expect(2, {folder_ / "x", folder_ / "x/1.png"}, {}, {"is a folder"});
  expect(3, {folder_ / "empty", folder_ / "empty"}, {}, {"holds a *.png or *.exr file"});
  expect(3, {folder_ / "none", folder_ / "none"}, {"unreadable"}, {"no such file"});
}

TEST_F(CompareCommand, AnUnreadablePictureAmongManyDoesNotHideTheOthers) {
  write("x/a.png"), write("y/a.png", 9), write("x/b.png");
  test::spill(folder_ / "y/b.png", "broken");
  expect(3, {folder_ / "x", folder_ / "y"}, {"a.png: different", "b.png: unreadable", "2 pairs", "1 unreadable"}, {"y/b.png"});
}

TEST_F(CompareCommand, JsonHoldsTheSameAndIsEqualForAnyNumberOfJobs) {
  write("x/a.png"), write("y/a.png", 9), write("x/b.png"), write("y/b.png"), write("x/c.png");
  const auto result = compare({folder_ / "x", folder_ / "y", "--json", "--max", "10"});
  EXPECT_EQ(result.exit_code, 1);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["pairs"], 3);
  EXPECT_EQ(json["tolerance"], "max 10");
  EXPECT_EQ(json["results"][0]["name"], "a.png");
  EXPECT_EQ(json["results"][0]["verdict"], "within");
  EXPECT_EQ(json["results"][0]["difference"]["max"], 9.0);
  EXPECT_EQ(json["results"][0]["difference"]["worst"][0]["x"], 12);
  EXPECT_EQ(json["results"][1]["verdict"], "same");
  EXPECT_EQ(json["results"][2]["verdict"], "missing");
  EXPECT_TRUE(json["results"][2]["difference"].is_null());
  EXPECT_EQ(compare({folder_ / "x", folder_ / "y", "--json", "--max", "10", "-j", "7"}).out, result.out);
}

TEST_F(CompareCommand, HelpShowsEveryOptionAndExamples) {
  const auto help = compare({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"--output", "--max", "--mean", "--pixels", "--ssim", "--light", "--depth", "--motion", "--json", "--jobs", "Examples:", "Exit codes:"}) EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace npsee
