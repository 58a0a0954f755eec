// docs/ci.md and docs/examples, run as they stand there.
#include "tests/support/markdown.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::string kDocs = std::string(NPSEE_SOURCE_DIR) + "/docs";

/// The lines of the configuration's `script`, as a shell script that ends at the first that fails, which is what CI systems make of it.
std::string sampleScript() {
  std::string out;
  for (const test::Block& block : test::fencedBlocks(test::slurp(kDocs + "/ci.md"))) {
    if (block.info != "yaml") continue;
    std::istringstream lines(block.text);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("    - ") && inside) out += line.substr(6) + '\n';
      else inside = line == "  script:";
    }
  }
  return out;
}

/// Slurm's sbatch as far as the examples use it. The tasks of an array run one after the other, the last first; the second one is killed when
/// it has drawn a picture (or at its end) and started again, as at a time limit.
constexpr const char* kSbatch = R"bash(#!/bin/bash
set -u
parts=0
while [[ $1 == --* ]]; do case $1 in --array=1-*) parts=${1#--array=1-};; --dependency=afterok:41|--parsable) ;; *) echo "sbatch: $1?" >&2; exit 1;; esac; shift; done
if [ "$parts" -eq 0 ]; then "$1" >slurm-verify.log 2>&1; echo $? >slurm-verify.code; echo 42; exit; fi
export SLURM_ARRAY_TASK_COUNT=$parts SLURM_CPUS_PER_TASK=1
for ((task = parts; task >= 1; --task)); do
  export SLURM_ARRAY_TASK_ID=$task
  if [ "$task" -eq 2 ]; then
    "$1" >killed.log 2>&1 & child=$!
    before=$(ls frames | wc -l)
    while kill -0 $child 2>/dev/null && [ "$(ls frames | wc -l)" -eq "$before" ]; do sleep 0.01; done
    kill -TERM $child 2>/dev/null; wait $child
  fi
  "$1" >"slurm-$task.log" 2>&1 || echo "task $task: $?" >>failed-tasks
done
echo 41
)bash";

class CiDoc : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder_ / "presets");
    fs::create_directory(folder_ / "bin");
    fs::copy(std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json", folder_ / "presets");
    test::spill(folder_ / "presets/sparks.npsee.json", R"({"npsee": 1, "layers": [{"name": "sparks", "count": 30, "speed_mean": 9, "size_mean": 0.6, "form": "streak"}]})");
    fs::create_symlink(test::npseePath(), folder_ / "bin/npsee");
    for (const auto& entry : fs::directory_iterator(kDocs + "/examples")) fs::create_symlink(entry.path(), folder_ / "bin/" + entry.path().filename().string());
    test::spill(folder_ / "bin/sbatch", kSbatch);
    fs::permissions(folder_ / "bin/sbatch", fs::perms::owner_all);
  }
  test::ProcessResult shell(const std::string& script, const std::map<std::string, std::string>& more = {}) const {
    std::map<std::string, std::string> environment{{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"NPSEE", ""}, {"SLOTS", ""}, {"PATH", folder_ / "bin:/usr/bin:/bin"}};
    environment.insert(more.begin(), more.end());
    return test::run("/bin/bash", {"-euo", "pipefail", "-c", script}, environment, folder_.path());
  }
  std::string file(const std::string& name) const { return test::slurp(folder_ / name); }
  std::size_t pictures(const std::string& folder) const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / folder)) count += entry.path().extension() == ".png" ? 1 : 0;
    return count;
  }
  static bool hasParallel() { return fs::exists("/usr/bin/parallel"); }

  test::TemporaryFolder folder_;
};

TEST_F(CiDoc, EveryRunnableBlockWorksAsWritten) {
  int count = 0;
  for (const test::Block& block : test::fencedBlocks(test::slurp(kDocs + "/ci.md"))) {
    if (block.info != "sh run" || (block.text.find("spread_frames") != std::string::npos && !hasParallel())) continue;
    const auto result = shell(block.text);
    EXPECT_EQ(result.exit_code, 0) << block.text << result.err;
    ++count;
  }
  EXPECT_GE(count, 5);
  EXPECT_EQ(pictures("goldens"), 6u);
  EXPECT_EQ(pictures("frames"), 12u);
  EXPECT_EQ(pictures("joined"), 12u);
  EXPECT_NE(file("difference.json").find("\"different\": 2"), std::string::npos) << "the step of 20 ms is seen";
  for (const char* made : {"comp_0028.exr", "deep.png", "preview.mp4", "sprites.json", "cache_0004.ply", "difference/sparks.png"}) EXPECT_FALSE(file(made).empty()) << made;
}

TEST_F(CiDoc, TheSampleConfigurationNoticesWhatChanged) {
  const std::string script = sampleScript();
  ASSERT_EQ(std::ranges::count(script, '\n'), 4) << script;
  EXPECT_EQ(shell("mkdir goldens; npsee render presets/*.npsee.json --time 10%,30%,70% --size 320x180 --golden goldens --update-golden").exit_code, 1) << "never silently";
  const auto good = shell(script);
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
  EXPECT_NE(good.out.find("6 pictures: 6 same"), std::string::npos) << good.out;
  EXPECT_NE(file("report/pictures.xml").find("tests=\"6\" failures=\"0\""), std::string::npos) << file("report/pictures.xml");
  EXPECT_TRUE(fs::exists(folder_ / "report/sparks.png")) << "the sheets";

  std::string changed = file("presets/sparks.npsee.json");
  changed.replace(changed.find("\"speed_mean\": 9"), 15, "\"speed_mean\": 8");
  test::spill(folder_ / "presets/sparks.npsee.json", changed);
  const auto different = shell(script);
  EXPECT_EQ(different.exit_code, 1);
  EXPECT_NE(different.out.find("sparks_0001.png: different"), std::string::npos) << different.out;
  EXPECT_EQ(different.out.find("classic"), std::string::npos) << different.out;
  EXPECT_NE(file("report/pictures.xml").find("failures=\"3\""), std::string::npos);
  EXPECT_NE(file("report/pictures.html").find("data:image/png;base64,"), std::string::npos);

  EXPECT_EQ(shell("npsee render presets/*.npsee.json --time 10%,30%,70% --size 320x180 --golden goldens --update-golden").exit_code, 1);
  EXPECT_EQ(shell(script).exit_code, 0) << "after the change was accepted";

  test::spill(folder_ / "presets/sparks.npsee.json", changed + "}");
  const auto broken = shell(script);
  EXPECT_NE(broken.exit_code, 0);
  EXPECT_NE(broken.out.find("sparks.npsee.json"), std::string::npos) << broken.out << broken.err;
}

TEST_F(CiDoc, ASpreadRenderHasTheBytesOfOneCallAndGoesOnAfterALoss) {
  if (!hasParallel()) GTEST_SKIP() << "GNU parallel is not installed";
  const std::string job = " presets/*.npsee.json --frames 0:0.5 --fps 12 --size 96x54";
  const auto first = shell("spread_frames 5 spread" + job, {{"SLOTS", "--jobs 2"}});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.err.find("All 12 pictures are in spread"), std::string::npos) << first.err;
  EXPECT_EQ(shell("mkdir one; npsee render" + job + " -o one/").exit_code, 0);
  for (const auto& entry : fs::directory_iterator(folder_ / "one")) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(file("one/" + name), file("spread/" + name)) << name;
  }
  fs::remove(folder_ / "spread/sparks_0003.png");
  test::spill(folder_ / "spread/classic_1993_0002.png", "damaged");
  const auto again = shell("spread_frames 5 spread" + job);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(std::ranges::count(file("spread/written.txt"), '\n'), 2) << file("spread/written.txt");
}

TEST_F(CiDoc, SpreadingSaysWhatIsWrongBeforeAnythingIsStarted) {
  const auto usage = shell("spread_frames 5");
  EXPECT_EQ(usage.exit_code, 2);
  EXPECT_NE(usage.err.find("spread_frames PARTS FOLDER FILE"), std::string::npos) << usage.err;
  const auto option = shell("spread_frames 5 spread presets/sparks.npsee.json --frames 1:0");
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_NE(option.err.find("ends before it begins"), std::string::npos) << option.err;
  EXPECT_EQ(shell("spread_frames 5 spread presets/none.npsee.json --frames 0:1").exit_code, 3);
  EXPECT_EQ(shell("slurm_submit 5").exit_code, 2);
  EXPECT_EQ(shell("slurm_submit 5 presets/none.npsee.json --frames 0:1").exit_code, 3);
  EXPECT_FALSE(fs::exists(folder_ / "render.args"));
}

TEST_F(CiDoc, ASlurmArrayDrawsAllAndItsVerificationFindsLosses) {
  const std::string job = " presets/*.npsee.json --frames 0:0.5 --fps 12 --size 96x54 --set gravity=9";
  const auto result = shell("slurm_submit 3" + job);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "12 pictures: array job 41 of 3 tasks, verified by job 42\n");
  EXPECT_FALSE(fs::exists(folder_ / "failed-tasks")) << file("failed-tasks") << file("slurm-1.log");
  EXPECT_EQ(file("slurm-verify.code"), "0\n") << file("slurm-verify.log");
  EXPECT_EQ(file("slurm-verify.log"), "All pictures are in frames/\n");
  EXPECT_EQ(pictures("frames"), 12u);
  fs::remove(folder_ / "frames/sparks_0003.png");
  const std::string cut = file("frames/classic_1993_0002.png").substr(0, 500);
  test::spill(folder_ / "frames/classic_1993_0002.png", cut);
  const auto verified = shell("slurm_verify");
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_EQ(verified.out, "frames/classic_1993_0002.png\nframes/sparks_0003.png\n");
}

// What needs other machines is this short.
TEST(CiDocText, OnlyTheseLinesAreNotRun) {
  for (const test::Block& block : test::fencedBlocks(test::slurp(kDocs + "/ci.md"))) {
    if (block.info == "sh") {
      EXPECT_NE(block.text.find("--sshloginfile hosts"), std::string::npos) << block.text;
    } else {
      EXPECT_TRUE(block.info == "sh run" || block.info == "yaml") << block.info;
    }
  }
}

TEST(CiDocText, EveryLinkLeadsToAFile) {
  const std::string text = test::slurp(kDocs + "/ci.md");
  const std::regex link(R"(\]\(([^)#]+)\))");
  int count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it, ++count) EXPECT_TRUE(fs::exists(kDocs + '/' + (*it)[1].str())) << (*it)[1];
  EXPECT_GE(count, 6);
}

}  // namespace
}  // namespace npsee
