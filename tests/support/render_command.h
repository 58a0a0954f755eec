#pragma once

#include "app/render/image.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace npsee::test {

using Words = std::vector<std::string>;

/// `npsee render` with small presets, and a folder for its outputs.
class RenderFixture : public ::testing::Test {
 protected:
  void SetUp() override {
    spill(preset("small"), R"({"npsee": 1, "layers": [{"name": "fragments", "count": 60, "speed_mean": 12, "size_mean": 1}]})");
    spill(preset("other"), R"({"npsee": 1, "layers": [{"name": "sparks", "count": 30, "speed_mean": 9, "form": "streak"}]})");
  }
  std::string preset(const std::string& name) const { return inputs_ / (name + ".npsee.json"); }

  static ProcessResult render(Words words, const std::map<std::string, std::string>& environment = {}) {
    words.insert(words.begin(), "render");
    return npseeRun(words, environment);
  }
  /// The same with small pictures of the small preset.
  ProcessResult small(Words words) const {
    words.insert(words.begin(), {preset("small"), "--size", "64x36"});
    return render(words);
  }
  /// Expects an exit code, and words in what is printed and in the messages.
  static void expect(const ProcessResult& result, int code, const Words& out, const Words& err = {}) {
    EXPECT_EQ(result.exit_code, code) << result.out << result.err;
    for (const std::string& word : out) EXPECT_NE(result.out.find(word), std::string::npos) << '"' << word << "\" in: " << result.out;
    for (const std::string& word : err) EXPECT_NE(result.err.find(word), std::string::npos) << '"' << word << "\" in: " << result.err;
    EXPECT_EQ(result.err.empty(), err.empty()) << result.err;
  }
  /// Files in the output folder, or one below it.
  std::set<std::string> files(const std::string& below = "") const {
    std::set<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / below)) out.insert(entry.path().filename().string());
    return out;
  }
  std::string folder(const std::string& name) const {
    std::filesystem::create_directories(folder_ / name);
    return folder_ / name;
  }
  static std::size_t lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

  TemporaryFolder folder_, inputs_;
};

}  // namespace npsee::test
