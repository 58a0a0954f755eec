// `npsee render --golden`: verdicts, updating, tolerance by machine, the page and the JUnit file.
#include "tests/support/render_command.h"

#include <nlohmann/json.hpp>

#include <regex>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using test::Words;

class RenderGolden : public test::RenderFixture {
 protected:
  /// Three moments of the small preset against the goldens.
  test::ProcessResult check(Words more = {}) const {
    more.insert(more.begin(), {"--time", "10%,30%,70%", "--golden", folder("golden")});
    return small(more);
  }
  void makeGoldens() const {
    const auto made = check({"--update-golden"});
    ASSERT_EQ(made.exit_code, 1) << made.err;
  }
  /// Changes one component of one pixel of a golden.
  void change(const std::string& name, int levels) const {
    const std::string path = folder_ / ("golden/" + name);
    auto image = render::readPng(path);
    ASSERT_TRUE(image);
    std::uint8_t& value = image->pixel(20, 10)[1];
    value = static_cast<std::uint8_t>(value >= 128 ? value - levels : value + levels);
    ASSERT_TRUE(render::writePng(*image, path));
  }
};

TEST_F(RenderGolden, UnchangedPicturesPass) {
  makeGoldens();
  expect(check(), 0, {"3 pictures: 3 same, 0 within the tolerance, 0 different or missing"});
}

TEST_F(RenderGolden, MissingGoldensFailAndNothingIsWrittenWithoutAsking) {
  expect(check(), 1, {"small_0000.png: missing", "there is no golden of this name", "3 different or missing"});
  EXPECT_TRUE(files("golden").empty());
  EXPECT_EQ(files(), (std::set<std::string>{"golden"}));
}

TEST_F(RenderGolden, UpdatingNamesEachGoldenAndStillFailsTheRun) {
  const auto first = check({"--update-golden"});
  expect(first, 1, {"golden updated: ", "small_0002.png", "3 goldens were updated, so this run counts as failed"});
  EXPECT_EQ(files("golden"), (std::set<std::string>{"small_0000.json", "small_0000.png", "small_0001.json", "small_0001.png", "small_0002.json", "small_0002.png"}));
  expect(check({"--update-golden"}), 0, {"3 same"});
  change("small_0001.png", 40);
  const std::string changed = test::slurp(folder_ / "golden/small_0001.png");
  expect(check(), 1, {"small_0001.png: different", "at 20,10"});
  EXPECT_EQ(test::slurp(folder_ / "golden/small_0001.png"), changed);
  const auto second = check({"--update-golden"});
  expect(second, 1, {"1 goldens were updated"});
  EXPECT_EQ(second.out.find("small_0000.png"), std::string::npos) << "what is the same is not touched";
  expect(check(), 0, {"3 same"});
}

TEST_F(RenderGolden, TheDriverAndProcessorAreRecordedBesideEachGolden) {
  makeGoldens();
  const auto json = nlohmann::json::parse(test::slurp(folder_ / "golden/small_0000.json"));
  EXPECT_NE(json["driver"].get<std::string>().find("llvmpipe"), std::string::npos);
  EXPECT_TRUE(std::regex_match(json["processor"].get<std::string>(), std::regex("(intel|amd|other) x86-64(-v[234])?|other"))) << json["processor"];
  EXPECT_EQ(json["npsee"], "1.0.0");
}

TEST_F(RenderGolden, NothingMayDifferOnTheSameMachineAndALittleElsewhere) {
  makeGoldens();
  change("small_0000.png", 1);
  expect(check(), 1, {"small_0000.png: different", "max 1 is above 0"});
  // Drawn elsewhere, one level is within the tolerance, but of 64 x 36 pixels not a single one may be off by more than two.
  const std::string record = folder_ / "golden/small_0000.json";
  test::spill(record, std::regex_replace(test::slurp(record), std::regex("x86-64[-v0-9]*"), "x86-64-v9"));
  expect(check(), 0, {"2 same, 1 within the tolerance"});
  change("small_0000.png", 5);
  expect(check(), 1, {"small_0000.png: different", "1 of 2304 pixels differ by more than 2, above 0.01 %"});
  // A tolerance given on the command line counts on every machine.
  expect(check({"--max", "6"}), 0, {"1 within the tolerance"});
  expect(check({"--max", "4"}), 1, {"is above 4"});
  expect(check({"--pixels", "0.1% over 2", "--ssim", "0.9", "--mean", "1"}), 0, {"within"});
}

TEST_F(RenderGolden, AGoldenWithoutRecordOrWithABrokenOneIsFromElsewhere) {
  makeGoldens();
  change("small_0000.png", 1);
  for (const char* text : {"", "{}", "[1]", "{\"driver\": 3}", "not json"}) {
    test::spill(folder_ / "golden/small_0000.json", text);
    expect(check(), 0, {"1 within the tolerance"});
  }
}

TEST_F(RenderGolden, AnUnreadableGoldenFailsAndCanBeReplaced) {
  makeGoldens();
  test::spill(folder_ / "golden/small_0001.png", "no picture");
  expect(check({"--report", folder_ / "r.html"}), 1, {"small_0001.png: unreadable"});
  check({"--update-golden"});
  expect(check(), 0, {"3 same"});
  ASSERT_TRUE(render::writePng(render::Image{2, 2, std::vector<std::uint8_t>(16, 9)}, folder_ / "golden/small_0001.png"));
  expect(check({"--report", folder_ / "r.html"}), 1, {"sizes differ", "2 x 2", "64 x 36"});
}

TEST_F(RenderGolden, TheNewPicturesAreKeptWhereWanted) {
  makeGoldens();
  check({"-o", folder("new")});
  EXPECT_EQ(test::slurp(folder_ / "new/small_0001.png"), test::slurp(folder_ / "golden/small_0001.png"));
  EXPECT_EQ(files("new").size(), 3u);
}

TEST_F(RenderGolden, SheetsAndTemplatesAreComparedToo) {
  for (const Words& words : std::vector<Words>{{"--sheet", "2x2"}, {"--template", "--view", "polygons"}}) {
    Words call = words;
    call.insert(call.end(), {"--golden", folder("g" + words[0])});
    EXPECT_EQ(small(call).exit_code, 1);
    call.push_back("--update-golden");
    EXPECT_EQ(small(call).exit_code, 1);
    call.pop_back();
    expect(small(call), 0, {"1 picture: 1 same"});
  }
}

TEST_F(RenderGolden, ThePageHoldsBeforeAfterAndDifferenceAndNeedsNothingElse) {
  makeGoldens();
  change("small_0002.png", 30);
  expect(check({"--report", folder_ / "r.html"}), 1, {"small_0002.png: different"});
  const std::string page = test::slurp(folder_ / "r.html");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  for (const char* word : {"1 of 3 failed", "small_0002.png", "llvmpipe", "alt=\"before\"", "alt=\"after\"", "alt=\"difference\"", "max 30", "</html>"}) EXPECT_NE(page.find(word), std::string::npos) << word;
  // Nothing is fetched: the only sources are data URIs, and there is no script or style sheet beside the page.
  const std::regex source("(src|href)=\"([^\"]{0,22})");
  std::size_t pictures = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), source), end; it != end; ++it, ++pictures) EXPECT_EQ((*it)[2], "data:image/png;base64,");
  EXPECT_EQ(pictures, 4u) << "before, after with before to flip to, difference";
  EXPECT_EQ(page.find("http"), std::string::npos);
}

TEST_F(RenderGolden, ThePicturesInThePageAreWholePngs) {
  makeGoldens();
  change("small_0002.png", 30);
  check({"--report", folder_ / "r.html"});
  // Decoded by another program.
  const auto decoded = test::run("/usr/bin/python3", {"-c", R"(
import base64, re, sys
page = open(sys.argv[1]).read()
for k, text in enumerate(re.findall(r'base64,([^"]*)', page)): open(sys.argv[2] + '/%d.png' % k, 'wb').write(base64.b64decode(text, validate=True))
)", folder_ / "r.html", folder("decoded")});
  ASSERT_EQ(decoded.exit_code, 0) << decoded.err;
  EXPECT_EQ(test::slurp(folder_ / "decoded/0.png"), test::slurp(folder_ / "golden/small_0002.png"));
  for (const std::string& name : files("decoded")) EXPECT_TRUE(render::readPng(folder_ / ("decoded/" + name))) << name;
}

TEST_F(RenderGolden, TheJunitFileNamesEachPictureAndWhyItFailed) {
  makeGoldens();
  change("small_0001.png", 30);
  check({"--junit", folder_ / "r.xml"});
  const auto read = test::run("/usr/bin/python3", {"-c", R"(
import sys, xml.etree.ElementTree as tree
root = tree.parse(sys.argv[1]).getroot()
print(root.tag, root.get('tests'), root.get('failures'))
for case in root.iter('testcase'):
    failure = case.find('failure')
    print(case.get('name'), 'passed' if failure is None else failure.get('type') + ': ' + failure.get('message'))
)", folder_ / "r.xml"});
  EXPECT_EQ(read.out, "testsuites 3 1\nsmall_0000.png passed\nsmall_0001.png different: max 30 is above 0\nsmall_0002.png passed\n") << read.err;
}

TEST_F(RenderGolden, NamesAreEscapedInPageAndJunit) {
  test::spill(preset("a<b&\"c"), test::slurp(preset("small")));
  const auto result = render({preset("a<b&\"c"), "--size", "64x36", "--golden", folder("golden"), "--report", folder_ / "r.html", "--junit", folder_ / "r.xml"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(test::slurp(folder_ / "r.html").find("a&lt;b&amp;&quot;c.png"), std::string::npos);
  EXPECT_EQ(test::run("/usr/bin/python3", {"-c", "import sys, xml.etree.ElementTree as t; t.parse(sys.argv[1])", folder_ / "r.xml"}).exit_code, 0);
}

TEST_F(RenderGolden, TheSummaryHoldsTheVerdicts) {
  makeGoldens();
  change("small_0001.png", 30);
  const auto result = check({"--summary", "json"});
  EXPECT_EQ(result.exit_code, 1);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["golden"]["failed"], 1);
  EXPECT_EQ(json["golden"]["same"], 2);
  EXPECT_EQ(json["golden"]["results"][1]["verdict"], "different");
  EXPECT_EQ(json["golden"]["results"][1]["difference"]["max"], 30.0);
  EXPECT_EQ(json["golden"]["results"][1]["same_machine"], true);
}

TEST_F(RenderGolden, OptionsThatCannotBeMeantExitTwo) {
  for (const Words& words : std::vector<Words>{{"--update-golden"}, {"--report", folder_ / "r.html"}, {"--junit", folder_ / "r.xml"}, {"--max", "3"}}) {
    Words call = words;
    call.insert(call.end(), {"-o", folder_ / "a.png"});
    expect(small(call), 2, {}, {"--golden DIR"});
  }
  for (const char* option : {"--resume", "--dry-run", "--verify"}) expect(small({"--golden", folder("golden"), option}), 2, {}, {"--golden draws every picture anew"});
  expect(small({"--golden", folder("golden"), "--max", "x"}), 2, {}, {"--max x"});
}

TEST_F(RenderGolden, FoldersThatAreNotThereAreNamed) {
  expect(small({"--golden", folder_ / "none"}), 3, {}, {"none", "no folder of goldens"});
  expect(small({"--golden", folder("golden"), "--report", folder_ / "no/r.html"}), 5, {}, {"no/r.html", "does not exist"});
  expect(small({"--golden", folder("golden"), "--junit", folder_ / "no/r.xml"}), 5, {}, {"no/r.xml"});
  expect(small({"--golden", folder("golden"), "-o", folder_ / "no/no/"}), 5, {}, {"does not exist"});
}

}  // namespace
}  // namespace npsee
