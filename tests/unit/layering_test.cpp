#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace npsee {
namespace {

namespace fs = std::filesystem;

/// Include targets of every source file below a folder of the project.
std::vector<std::pair<std::string, std::string>> includesBelow(const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> out;
  const std::regex pattern(R"(#\s*include\s*[<"]([^>"]+)[>"])");
  for (const auto& entry : fs::recursive_directory_iterator(std::string(NPSEE_SOURCE_DIR) + "/" + folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".cpp" && extension != ".h" && extension != ".inl") continue;
    const std::string text = test::slurp(entry.path().string());
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
      out.emplace_back(fs::relative(entry.path(), NPSEE_SOURCE_DIR).string(), (*it)[1]);
  }
  return out;
}

void expectNone(const std::string& folder, const std::string& forbidden) {
  const std::regex pattern(forbidden);
  const auto includes = includesBelow(folder);
  for (const auto& [file, target] : includes) EXPECT_FALSE(std::regex_search(target, pattern)) << file << " includes " << target;
}

TEST(Layering, TheSimulatorKnowsNeitherGlNorImguiNorTheRoomsAboveIt) { expectNone("sim", "^(imgui|GLFW/|glad/|GL/|app/|editor/|tests/|CLI/)"); }

TEST(Layering, ContextsAndRendererKnowNeitherEditorNorCommandsNorImgui) {
  expectNone("app/gl", "^(imgui|editor/|app/commands/|app/render/|tests/|CLI/)");
  expectNone("app/render", "^(imgui|GLFW/|editor/|app/commands/|tests/|CLI/)");
}

TEST(Layering, WhatTheEditorWorksOnKnowsNeitherGlNorImguiNorPanels) {
  for (const char* folder : {"editor/desk", "editor/document", "editor/mission"}) expectNone(folder, "^(imgui|GLFW/|glad/|app/gl/|editor/(ui|panels|script)/)");
}

TEST(Layering, TheEditorKnowsNoCommand) { expectNone("editor", "^(app/commands/|tests/|CLI/)"); }

TEST(Layering, PublicHeadersIncludeOnlyPublicHeadersAndTheStandardLibrary) {
  for (const auto& [file, target] : includesBelow("sim/include"))
    EXPECT_TRUE(target.starts_with("npsee/") || target == "tl/expected.hpp" || target.find('/') == std::string::npos) << file << " includes " << target;
}

}  // namespace
}  // namespace npsee
