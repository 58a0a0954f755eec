#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace npsee {
namespace {

nlohmann::json presetsFile() { return nlohmann::json::parse(test::slurp(std::string(NPSEE_SOURCE_DIR) + "/CMakePresets.json")); }

std::set<std::string> visibleNames(const nlohmann::json& presets) {
  std::set<std::string> names;
  for (const auto& preset : presets)
    if (!preset.value("hidden", false)) names.insert(preset.at("name").get<std::string>());
  return names;
}

TEST(CmakePresets, ConfigureAndBuildWaysAreDevReleaseAsanTsanAndFuzz) {
  const auto file = presetsFile();
  const std::set<std::string> wanted{"dev", "release", "asan", "tsan", "fuzz"};
  EXPECT_EQ(visibleNames(file.at("configurePresets")), wanted);
  EXPECT_EQ(visibleNames(file.at("buildPresets")), wanted);
}

TEST(CmakePresets, EachBuildsInAFolderOfItsOwnAndSanitizersAreOn) {
  const auto file = presetsFile();
  for (const auto& preset : file.at("configurePresets")) {
    const std::string name = preset.at("name");
    if (name == "base") {
      EXPECT_EQ(preset.at("binaryDir"), "${sourceDir}/build/${presetName}");
      continue;
    }
    EXPECT_EQ(preset.at("inherits"), "base") << name;
    const std::string sanitize = preset.at("cacheVariables").value("NPSEE_SANITIZE", "");
    EXPECT_EQ(sanitize, name == "tsan" ? "thread" : name == "asan" || name == "fuzz" ? "address,undefined" : "") << name;
  }
}

// CMake itself reads and resolves the file; a preset it cannot use is an error of this call.
TEST(CmakePresets, CmakeAcceptsTheFile) {
  const auto listed = test::run("/usr/bin/cmake", {"--list-presets=configure"}, {}, NPSEE_SOURCE_DIR);
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  for (const char* name : {"dev", "release", "asan", "tsan", "fuzz"}) EXPECT_NE(listed.out.find('"' + std::string(name) + '"'), std::string::npos) << listed.out;
}

}  // namespace
}  // namespace npsee
