#include "app/render/image.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

namespace npsee::render {
namespace {

using test::npseeRun;

constexpr const char* kTwoLayers = R"({"npsee": 1, "layers": [
  {"name": "fragments", "count": 10, "enabled": false},
  {"name": "sparks", "count": 10, "ejection_angle": 12, "speed_mean": 90}]})";

class TemplateCommand : public ::testing::Test {
 protected:
  void SetUp() override { test::spill(preset(), kTwoLayers); }
  std::string preset() const { return folder_ / "two.npsee.json"; }

  /// Pixels that the command wrote with these options added.
  std::vector<std::uint8_t> drawn(std::vector<std::string> options) {
    const std::string out = folder_ / "out.png";
    options.insert(options.begin(), {"render", preset(), "--template", "-o", out, "--size", "160x140"});
    const auto result = npseeRun(options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, out + "\n");
    const auto image = readPng(out);
    EXPECT_TRUE(image);
    EXPECT_EQ(image ? image->width : 0, 160);
    return image ? image->rgba : std::vector<std::uint8_t>();
  }
  void expectRefused(std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"render", preset(), "-o", folder_ / "out.png"});
    const auto result = npseeRun(options);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(test::slurp(folder_ / "out.png"), "");
  }

  test::TemporaryFolder folder_;
};

TEST_F(TemplateCommand, DrawsThreeDifferentViewsWithTheSurfaceAsDefault) {
  const auto surface = drawn({"--view", "surface"}), polygons = drawn({"--view", "polygons"}), splines = drawn({"--view", "splines"});
  EXPECT_NE(surface, polygons);
  EXPECT_NE(polygons, splines);
  EXPECT_NE(surface, splines);
  EXPECT_EQ(drawn({}), surface);
}

TEST_F(TemplateCommand, DrawsTheNamedLayerAndElseTheFirstEnabledOne) {
  const auto fragments = drawn({"--layer", "fragments"}), sparks = drawn({"--layer", "sparks"});
  EXPECT_NE(fragments, sparks);
  EXPECT_EQ(drawn({}), sparks);
}

TEST_F(TemplateCommand, FollowsSettingsOfTheCommandLine) {
  const auto before = drawn({});
  EXPECT_NE(drawn({"--set", "sparks.ejection_angle=60deg"}), before);
  EXPECT_NE(drawn({"--set", "burst=air"}), before);
  EXPECT_EQ(drawn({"--set", "sparks.lifetime_mean=1"}), before);
}

TEST_F(TemplateCommand, LeavesTheBackgroundTransparentOnRequest) {
  drawn({"--background", "transparent"});
  const auto image = readPng(folder_ / "out.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->pixel(0, 0)[3], 0);
}

TEST_F(TemplateCommand, RefusesAnUnknownLayerNamingTheNearestAndAll) {
  expectRefused({"--template", "--layer", "spraks"}, "Did you mean sparks?");
  expectRefused({"--template", "--layer", "spraks"}, "Its layers are fragments and sparks.");
}

TEST_F(TemplateCommand, RefusesAnUnknownViewNamingTheThree) { expectRefused({"--template", "--view", "wire"}, "Write splines, polygons or surface."); }

TEST_F(TemplateCommand, RefusesItsOptionsWithoutTemplate) {
  expectRefused({"--layer", "sparks"}, "Add --template.");
  expectRefused({"--view", "splines"}, "Add --template.");
}

TEST_F(TemplateCommand, RefusesTimeAndCameraWithTemplate) { expectRefused({"--template", "--time", "1"}, "no time and no camera"); }

TEST_F(TemplateCommand, SaysSoWhenAPresetHasNoLayer) {
  test::spill(preset(), R"({"npsee": 1, "layers": []})");
  const auto result = npseeRun({"render", preset(), "--template", "-o", folder_ / "out.png"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("the preset has no layer"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace npsee::render
