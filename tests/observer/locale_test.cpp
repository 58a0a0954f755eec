// A program that embeds the simulator may have a locale that writes numbers with commas (Python's locale.setlocale, GTK and Qt set the user's).

#include "tests/support/process.h"
#include "tests/support/small_mission.h"

#include <npsee/aiming.h>
#include <npsee/ballistics.h>
#include <npsee/mission.h>
#include <npsee/preset.h>
#include <npsee/terrain.h>
#include <npsee/units.h>

#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace npsee {
namespace {

/// A locale of LC_NUMERIC alone, made of nothing but this: no package of locales is needed.
void describeCommas(const test::TemporaryFolder& folder) {
  std::string characters = "<code_set_name> ANSI_X3.4-1968\n<comment_char> %\n<escape_char> /\nCHARMAP\n";
  for (int c = 0; c < 128; ++c) {
    char line[40];
    std::snprintf(line, sizeof line, "<U%04X> /x%02x\n", static_cast<unsigned>(c), static_cast<unsigned>(c));
    characters += line;
  }
  test::spill(folder / "characters", characters + "END CHARMAP\n");
  test::spill(folder / "commas", "comment_char %\nescape_char /\nLC_NUMERIC\ndecimal_point \"<U002C>\"\nthousands_sep \"<U002E>\"\ngrouping 3;3\nEND LC_NUMERIC\n");
}

class Commas : public testing::Test {
 protected:
  void SetUp() override {
    describeCommas(folder_);
    // Its other parts are missing, which localedef says, with exit code 1, and -c forgives.
    const auto made = test::run("/usr/bin/localedef", {"-c", "-i", folder_ / "commas", "-f", folder_ / "characters", folder_ / "xx_XX"});
    ::setenv("LOCPATH", folder_.path().c_str(), 1);
    if (std::setlocale(LC_NUMERIC, "xx_XX") == nullptr) GTEST_SKIP() << "localedef (of Debian's libc-bin) makes no locale here: " << made.exit_code << ' ' << made.err.substr(0, 200);
    std::setlocale(LC_NUMERIC, "C");
  }
  void TearDown() override {
    std::setlocale(LC_NUMERIC, "C");
    ::unsetenv("LOCPATH");
  }

  /// What `work` gives is the same with a point and with a comma.
  template <class Work>
  void expectSame(const Work& work) {
    const auto usual = work();
    ASSERT_NE(std::setlocale(LC_NUMERIC, "xx_XX"), nullptr);
    EXPECT_EQ(std::to_string(0.5).substr(0, 3), "0,5") << "the test itself";
    const auto here = work();
    EXPECT_STREQ(std::setlocale(LC_NUMERIC, nullptr), "xx_XX") << "the host's locale stays";
    EXPECT_EQ(std::to_string(0.5).substr(0, 3), "0,5") << "and that of this thread";
    std::setlocale(LC_NUMERIC, "C");
    EXPECT_EQ(here, usual);
  }

  const test::TemporaryFolder folder_;
};

TEST_F(Commas, ChangeNoMission) {
  Scenario small = test::smallMission();
  small.observers[0].sensing.location_cep_m = 150.0;
  const auto shipped = loadScenario(std::string(NPSEE_SOURCE_DIR) + "/assets/missions/moving_column.mission.json");
  ASSERT_TRUE(shipped);
  for (const Scenario& scenario : {small, *shipped})
    expectSame([&] {
      const auto recording = runMission(scenario);
      EXPECT_TRUE(recording);
      return recording ? eventLog(*recording) : std::string();
    });
}

TEST_F(Commas, ChangeNoFile) {
  const auto preset = loadPreset(std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json");
  const auto projectile = findProjectile("m107");
  const auto scenario = loadScenario(std::string(NPSEE_SOURCE_DIR) + "/assets/missions/hills_patrol.mission.json");
  ASSERT_TRUE(preset && projectile && scenario);
  expectSame([&] { return presetText(*preset) + projectileText(*projectile) + scenarioText(*scenario); });
  expectSame([&] {
    const auto again = parsePreset(presetText(*preset), "again", {});
    return again && *again == *preset;
  });
}

TEST_F(Commas, ChangeNoNumberAndNoMessage) {
  expectSame([] {
    std::string out;
    for (const Unit unit : {Unit::degree, Unit::mil, Unit::fraction, Unit::degree_per_second})
      for (const double value : {0.1, 52.3, 1234.5678, -1e-7}) out += shortest(toUnit(unit, toSi(unit, value))) + ' ' + quantity(value, unit) + '\n';
    return out;
  });
  expectSame([] {
    const auto ballistics = Ballistics::make(*findProjectile("m107"));
    AimRequest request;
    request.speed_mps = 300.0;
    const auto aimer = Aimer::make(*ballistics, request);
    const auto reach = aimer->checkReach(1e6);
    return reach ? std::string() : reach.error().text();
  });
}

}  // namespace
}  // namespace npsee
