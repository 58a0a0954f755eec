#pragma once

#include "app/render/image.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace npsee::test {

/// Scripted sessions of the editor in a folder of their own, through the real command line.
class ScriptedEditor : public testing::Test {
 protected:
  ProcessResult run(const std::string& script, const std::string& file, const std::vector<std::string>& more = {}) {
    spill(folder_ / "script.txt", script);
    std::vector<std::string> arguments{"edit", file, "--headless", "--script", folder_ / "script.txt"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return npseeRun(arguments);
  }
  void passes(const std::string& script, const std::string& file, const std::vector<std::string>& more = {}) {
    const auto result = run(script, file, more);
    EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  }
  /// A picture that a script saved.
  render::Image picture(const std::string& name) {
    auto image = render::readPng(folder_ / name);
    EXPECT_TRUE(image.has_value()) << name;
    return image ? std::move(*image) : render::Image{};
  }
  /// Path of a file beside the document.
  std::string in(const std::string& name) { return folder_ / (below_ + name); }

  std::string below_;  ///< where the document lies in the folder
  TemporaryFolder folder_;
};

/// The explosion mode with a copy of the thesis's preset, so that scripts may save.
class EditorScript : public ScriptedEditor {
 protected:
  ProcessResult run(const std::string& script, const std::vector<std::string>& more = {}) { return ScriptedEditor::run(script, preset(), more); }
  void passes(const std::string& script, const std::vector<std::string>& more = {}) { ScriptedEditor::passes(script, preset(), more); }
  std::string preset() {
    std::filesystem::create_directories(folder_ / below_);
    const std::string copy = in("work.npsee.json");
    if (!std::filesystem::exists(copy)) std::filesystem::copy_file(classic(), copy);
    return copy;
  }
  static std::string classic() { return std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json"; }
};

}  // namespace npsee::test
