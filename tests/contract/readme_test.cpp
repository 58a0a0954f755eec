#include "tests/support/markdown.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

namespace npsee {
namespace {

namespace fs = std::filesystem;

const std::string kSource = NPSEE_SOURCE_DIR;

std::string readme() { return test::slurp(kSource + "/README.md"); }

// In one folder and in order, as a reader would; `npsee` is the built program.
TEST(Readme, EveryRunnableBlockWorksAsWritten) {
  const test::TemporaryFolder folder;
  fs::create_directory_symlink(kSource + "/presets", folder / "presets");
  fs::create_directory_symlink(kSource + "/assets", folder / "assets");
  const std::string npsee = test::npseePath();
  int count = 0;
  for (const test::Block& block : test::fencedBlocks(readme())) {
    if (block.info != "sh run") continue;
    const auto result = test::run("/bin/bash", {"-euo", "pipefail", "-c", "npsee() { '" + npsee + "' \"$@\"; }\n" + block.text},
                                  {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << block.text << result.err;
    ++count;
  }
  EXPECT_GE(count, 5);
  for (const char* made : {"first.png", "cascade.png", "my_burst.png", "template.png", "frame_0009.png", "editor.png", "particles.csv", "parameters.md"})
    EXPECT_FALSE(test::slurp(folder / made).empty()) << made;
}

// What cannot run in a test (it would fetch, build, or open a window) is this short and checked elsewhere.
TEST(Readme, OnlyTheseLinesAreNotRun) {
  const std::set<std::string> known{"git clone REPOSITORY npsee", "cd npsee", "scripts/run", "scripts/test", "alias npsee=\"$PWD/scripts/run\"", "npsee edit my_burst.npsee.json", "cmake --install build/release --prefix \"$HOME/npsee\"", "cd build/release && cpack --config CPackConfig.cmake",
                                    "npsee edit assets/missions/hills_patrol.mission.json"};
  for (const test::Block& block : test::fencedBlocks(readme())) {
    if (block.info == "sh run") continue;
    EXPECT_EQ(block.info, "sh");
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line);) EXPECT_TRUE(known.contains(line)) << line;
  }
}

TEST(Readme, EveryLinkLeadsToAFile) {
  const std::string text = readme();
  const std::regex link(R"(\]\(([^)#]+)\))");
  int count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it, ++count) {
    const std::string target = (*it)[1];
    EXPECT_TRUE(fs::exists(kSource + '/' + target)) << target;
  }
  EXPECT_GT(count, 4);
}

TEST(Readme, TheTableOfCommandsIsThatOfTheProgram) {
  const auto commandsIn = [](const std::string& text, const std::string& pattern) {
    std::set<std::string> out;
    const std::regex expression(pattern);
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) out.insert((*it)[1]);
    return out;
  };
  const std::string help = test::npseeRun({"--help"}).out;
  const std::size_t list = help.find("Subcommands:");
  ASSERT_NE(list, std::string::npos);
  EXPECT_EQ(commandsIn(readme(), R"(\n\| `npsee ([a-z]+))"), commandsIn(help.substr(list), R"(\n  ([a-z]+) )"));
}

}  // namespace
}  // namespace npsee
