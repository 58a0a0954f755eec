// Large work through the command line: it is done, and in the memory that docs/trust.md states. Times are measured by hand, not here.
#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace npsee {
namespace {

using test::npseeRun;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Largest resident memory that a child of this process had, MiB.
long mostMemory() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss / 1024;
}

void expectMemoryBelow(long limit_mib) {
  if (kSanitized) return;  // a sanitizer keeps several times as much
  EXPECT_LT(mostMemory(), limit_mib);
}

/// Two hundred guns that fire forty rounds each, one every half second, at two vehicles 5 km away.
std::string barrage() {
  nlohmann::json guns = nlohmann::json::array();
  for (int i = 0; i < 200; ++i) guns.push_back({{"id", "g" + std::to_string(i)}, {"pos", {19000 + 20 * (i % 50), 26000 + 20 * (i / 50)}}});
  const nlohmann::json mission = {
      {"npsee_mission", 1},
      {"title", "Barrage"},
      {"duration", 120},
      {"world", {{"terrain", {{"kind", "hills"}, {"relief", 120}, {"scale", 5000}, {"valley", 0.8}, {"sea_fraction", 0}, {"seed", 6}}}}},
      {"vehicles", {{{"id", "bmp-1"}, {"type", 52}, {"pos", {25000, 25000}}}, {{"id", "bmp-2"}, {"type", 52}, {"pos", {25040, 24985}}}}},
      {"batteries", {{{"id", "battery"}, {"guns", guns}, {"reload_time", 0.5}, {"volley_rounds", 40}, {"rounds", 1000}}}},
      {"observers", {{{"id", "fo1"}, {"pos", {25200, 26200}}, {"sensing", "perfect"}, {"missions", {{{"action", "destroy"}, {"type", 52}}}}}}}};
  return mission.dump();
}

TEST(Load, ThousandsOfShellsInTheAirAreFlownRecordedAndDrawn) {
  const test::TemporaryFolder folder;
  test::spill(folder / "barrage.mission.json", barrage());
  const auto flown = npseeRun({"mission", folder / "barrage.mission.json", "--quiet", "--record", folder / "barrage.rec"});
  EXPECT_EQ(flown.exit_code, 0) << flown.err;
  std::size_t most = 0;
  double busiest_s = 0.0;
  for (const double time_s : {25.0, 30.0, 35.0, 40.0}) {
    const auto state = npseeRun({"replay", folder / "barrage.rec", "--at", std::to_string(time_s)});
    ASSERT_EQ(state.exit_code, 0) << state.err;
    if (const std::size_t shells = nlohmann::json::parse(state.out)["shells"].size(); shells > most) {
      most = shells;
      busiest_s = time_s;
    }
  }
  EXPECT_GE(most, 2000u);
  const auto drawn = npseeRun({"replay", folder / "barrage.rec", "--render", "t=" + std::to_string(busiest_s) + ",camera=observer,size=640x360", "-o", folder / "barrage.png"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  expectMemoryBelow(512);
}

// After the smaller one: what the largest child had is all that the system tells.
TEST(Load, TwoMillionParticlesAreDrawnWithinAGibibyte) {
  const test::TemporaryFolder folder;
  test::spill(folder / "two.npsee.json", R"({"npsee": 1, "layers": [{"name": "fragments", "count": 2000000, "speed_mean": 40, "speed_deviation": 15, "drag": 0.3, "size_mean": 0.2, "lifetime_mean": 8}]})");
  const auto drawn = npseeRun({"render", folder / "two.npsee.json", "-o", folder / "two.png", "--time", "1", "--size", "640x360"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  expectMemoryBelow(1024);
  EXPECT_GT(test::slurp(folder / "two.png").size(), 10'000u);
}

}  // namespace
}  // namespace npsee
