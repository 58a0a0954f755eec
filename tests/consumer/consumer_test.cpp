// Other programs embed the simulator: what an installed npsee gives them must be enough to build one, and its results those of the tool.

#include "tests/scenario/mission_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace npsee {
namespace {

using test::missionRun;
using test::ProcessResult;

/// Words of the consumer's line that begins with `first`.
std::vector<std::string> line(const std::string& text, const std::string& first) {
  std::istringstream lines(text);
  for (std::string each; std::getline(lines, each);) {
    if (!each.starts_with(first + " ")) continue;
    std::istringstream words(each);
    std::vector<std::string> out;
    for (std::string word; words >> word;) out.push_back(word);
    return out;
  }
  return {};
}

/// An installed npsee and a program built against it, in a folder of their own.
class Consumer : public testing::Test {
 protected:
  ProcessResult cmake(const std::vector<std::string>& arguments) { return test::run(NPSEE_CMAKE, arguments, {{"CMAKE_PREFIX_PATH", ""}, {"DESTDIR", ""}}); }
  ProcessResult configure(const std::string& only_c = "OFF") {
    return cmake({"-S", std::string(NPSEE_SOURCE_DIR) + "/tests/consumer", "-B", folder_ / "build", "-DCMAKE_PREFIX_PATH=" + folder_ / "installed", std::string("-DCMAKE_CXX_COMPILER=") + NPSEE_COMPILER,
                  std::string("-DCMAKE_C_COMPILER=") + NPSEE_C_COMPILER, std::string("-DCMAKE_CXX_FLAGS=") + NPSEE_FLAGS, std::string("-DCMAKE_C_FLAGS=") + NPSEE_FLAGS, "-DCMAKE_BUILD_TYPE=Debug", "-DONLY_C=" + only_c});
  }
  test::TemporaryFolder folder_;
};

TEST_F(Consumer, AnInstalledLibraryGivesTheToolsResults) {
  const auto installed = cmake({"--install", NPSEE_BUILD_DIR, "--prefix", folder_ / "installed"});
  ASSERT_EQ(installed.exit_code, 0) << installed.err;
  const auto configured = configure();
  ASSERT_EQ(configured.exit_code, 0) << configured.err;
  const auto built = cmake({"--build", folder_ / "build"});
  ASSERT_EQ(built.exit_code, 0) << built.out << built.err;

  const std::string source = NPSEE_SOURCE_DIR, preset = source + "/presets/classic_1993.npsee.json", mission = source + "/assets/missions/thesis_default.mission.json";
  const auto run = test::run(folder_ / "build/consumer", {preset, "0.5", mission});
  ASSERT_EQ(run.exit_code, 0) << run.err;

  const auto states = nlohmann::json::parse(test::npseeRun({"particles", preset, "--time", "0.5", "--format", "json"}).out);
  std::size_t alive = 0;
  double highest_m = 0.0;
  for (const auto& particle : states) {
    if (particle.at("alive") == 0) continue;
    ++alive;
    highest_m = std::max(highest_m, particle.at("y_m").get<double>());
  }
  const auto particles = line(run.out, "particles");
  ASSERT_EQ(particles.size(), 6u) << run.out;
  EXPECT_EQ(particles[1], std::to_string(states.size()));
  EXPECT_EQ(particles[3], std::to_string(alive));
  EXPECT_EQ(std::stod(particles[5]), highest_m);

  const auto flown = nlohmann::json::parse(test::npseeRun({"fly", "--v0", "300", "--qe", "0.7rad", "--json"}).out);
  const auto range = line(run.out, "range_m");
  ASSERT_EQ(range.size(), 4u) << run.out;
  EXPECT_EQ(std::stod(range[1]), flown.at("range_m").get<double>());
  EXPECT_EQ(std::stod(range[3]), flown.at("time_of_flight_s").get<double>());
  const auto aimed = nlohmann::json::parse(test::npseeRun({"aim", "--v0", "300", "--range", "5000", "--solution", "low", "--json"}).out);
  const auto elevation = line(run.out, "qe_rad");
  ASSERT_EQ(elevation.size(), 4u) << run.out;
  EXPECT_EQ(std::stod(elevation[1]), aimed.at("solutions")[0].at("elevation_rad").get<double>());

  const auto fought = line(run.out, "events");
  ASSERT_EQ(fought.size(), 6u) << run.out;
  EXPECT_EQ(fought[5], missionRun(mission).hash());

  const auto in_c = test::run(folder_ / "build/c_consumer", {"mission", mission});
  EXPECT_EQ(in_c.exit_code, 0) << in_c.err;
  EXPECT_EQ(in_c.out, test::npseeRun({"mission", mission}).out);
}

TEST_F(Consumer, AProgramInCNeedsOnlyTheSharedLibrary) {
  for (const char* component : {"library", "development"}) {
    const auto installed = cmake({"--install", NPSEE_BUILD_DIR, "--prefix", folder_ / "installed", "--component", component});
    ASSERT_EQ(installed.exit_code, 0) << installed.err;
  }
  // With this component nothing that npsee::sim links is looked for.
  const auto configured = configure("ON");
  ASSERT_EQ(configured.exit_code, 0) << configured.err;
  const auto built = cmake({"--build", folder_ / "build"});
  ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  const auto refused = test::run(folder_ / "build/c_consumer", {"errors", std::string(NPSEE_SOURCE_DIR) + "/tests/data/v1/thesis_default.rec"});
  EXPECT_EQ(refused.exit_code, 0) << refused.err;
  const std::string preset = std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json";
  const auto installed = test::run(folder_ / "build/c_consumer", {"particles", preset, "0.5", "1"}), ours = test::run(NPSEE_C_CONSUMER, {"particles", preset, "0.5", "1"});
  EXPECT_EQ(installed.exit_code, 0) << installed.err;
  EXPECT_FALSE(installed.out.empty());
  EXPECT_EQ(installed.out, ours.out);
}

TEST_F(Consumer, WithoutAnInstalledLibraryCMakeSaysSo) {
  const auto configured = configure();
  EXPECT_NE(configured.exit_code, 0);
  EXPECT_NE(configured.err.find("npseeConfig.cmake"), std::string::npos) << configured.err;
}

}  // namespace
}  // namespace npsee
