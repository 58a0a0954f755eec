#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace npsee {
namespace {

using test::npseeRun;
using test::ProcessResult;

const std::string kClassic = std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json";

std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    rows.push_back(cells);
  }
  return rows;
}

TEST(ParticlesCommand, PrintsOneRowPerParticleUnderTheDocumentedHeader) {
  const ProcessResult result = npseeRun({"particles", kClassic, "--time", "0.5"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with("layer,index,alive,age_s,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,size_m,r,g,b,a,bounces\n")) << result.out.substr(0, 200);
  const auto rows = rowsOf(result.out);
  ASSERT_EQ(rows.size(), 101u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 16u);
    EXPECT_EQ(rows[i][1], std::to_string(i - 1));
    EXPECT_EQ(std::stod(rows[i][3]), 0.5);
  }
  EXPECT_EQ(result.err, "");
}

TEST(ParticlesCommand, FullPrecisionLetsAnOutsiderCheckTheParabola) {
  const auto start = rowsOf(npseeRun({"particles", kClassic, "--time", "0"}).out), later = rowsOf(npseeRun({"particles", kClassic, "--time", "0.75s"}).out);
  for (std::size_t i = 1; i < start.size(); ++i) {
    const double y = std::stod(start[i][5]) + 0.75 * std::stod(start[i][8]) - 0.5 * 9.80665 * 0.75 * 0.75;
    if (later[i][15] == "0") {
      EXPECT_NEAR(std::stod(later[i][5]), y, 1e-12);
    }
  }
}

TEST(ParticlesCommand, JsonSaysTheSameAsCsv) {
  const auto rows = rowsOf(npseeRun({"particles", kClassic, "--time", "1.5", "--seed", "7"}).out);
  const auto json = nlohmann::json::parse(npseeRun({"particles", kClassic, "--time", "1.5", "--seed", "7", "--format", "json"}).out);
  ASSERT_EQ(json.size() + 1, rows.size());
  for (std::size_t i = 0; i < json.size(); ++i)
    for (std::size_t column = 1; column < 16; ++column) EXPECT_EQ(json[i][rows[0][column]].get<double>(), std::stod(rows[i + 1][column]));
}

TEST(ParticlesCommand, SeedAndSettingsChangeTheStates) {
  const std::string plain = npseeRun({"particles", kClassic, "--time", "1"}).out;
  EXPECT_NE(npseeRun({"particles", kClassic, "--time", "1", "--seed", "7"}).out, plain);
  EXPECT_NE(npseeRun({"particles", kClassic, "--time", "1", "--set", "fragments.speed_mean=60"}).out, plain);
  EXPECT_EQ(npseeRun({"particles", kClassic, "--time", "1", "--seed", "1993"}).out, plain);
  const std::string two = npseeRun({"particles", kClassic, "--time", "1", "--set", "fragments.count=3", "--set", "gravity=0"}).out;
  EXPECT_EQ(rowsOf(two).size(), 4u);
}

void expectRefused(const std::vector<std::string>& arguments, int code, const std::string& message) {
  const ProcessResult result = npseeRun(arguments);
  EXPECT_EQ(result.exit_code, code) << result.err;
  EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  EXPECT_EQ(result.out, "");
}

TEST(ParticlesCommand, UnknownParameterExitsTwoAndNamesTheNearest) {
  expectRefused({"particles", kClassic, "--time", "1", "--set", "fragments.speed_men=60"}, 2, "Did you mean fragments.speed_mean?");
  expectRefused({"particles", kClassic, "--time", "1", "--set", "gravty=1"}, 2, "--set gravty=1: no such parameter. Did you mean gravity?");
}

TEST(ParticlesCommand, BadTimesSeedsAndFormatsExitTwo) {
  expectRefused({"particles", kClassic, "--time", "soon"}, 2, "--time soon: \"soon\" is not a finite number.");
  expectRefused({"particles", kClassic, "--time", "nan"}, 2, "is not a finite number");
  expectRefused({"particles", kClassic, "--time", "1", "--seed", "-1"}, 2, "--seed -1: seed is -1, below the limit of 0.");
  expectRefused({"particles", kClassic, "--time", "1", "--seed", "x"}, 2, "is not a whole number");
  expectRefused({"particles", kClassic, "--time", "1", "--format", "xml"}, 2, "--format");
  expectRefused({"particles", kClassic}, 2, "--time is required");
  expectRefused({"particles", "--time", "1"}, 2, "FILE is required");
}

TEST(ParticlesCommand, ABillionParticlesAreRefusedWithTheLimitNamed) {
  expectRefused({"particles", kClassic, "--time", "1", "--set", "fragments.count=1000000000"}, 2, "above the limit of 4000000 particles");
  expectRefused({"particles", kClassic, "--time", "1", "--set", "fragments.count=0", "--set", "fragments.density=1000000", "--set", "fragments.region.radius=1000"}, 2, "above the limit of 4000000");
}

TEST(ParticlesCommand, MissingAndBrokenFilesExitThree) {
  const test::TemporaryFolder folder;
  expectRefused({"particles", folder / "none.json", "--time", "1"}, 3, "none.json: cannot be read: there is no such file.");
  expectRefused({"particles", folder.path(), "--time", "1"}, 3, "it is a folder");
  test::spill(folder / "broken.npsee.json", "{ \"npsee\": 1,\n \"layers\": [ }");
  expectRefused({"particles", folder / "broken.npsee.json", "--time", "1"}, 3, "broken.npsee.json:2: is not JSON");
  test::spill(folder / "range.npsee.json", "{ \"npsee\": 1,\n \"layers\": [ {\n \"drag\": -1 } ] }");
  expectRefused({"particles", folder / "range.npsee.json", "--time", "1"}, 3, "range.npsee.json:3: /layers/0/drag: drag is -1 1/s, below the limit of 0 1/s.");
}

TEST(ParticlesCommand, AFullDiskExitsFive) {
  // /dev/full takes nothing; the shell only redirects.
  const ProcessResult result = test::run("/bin/sh", {"-c", std::string("exec ") + test::npseePath() + " particles '" + kClassic + "' --time 1 > /dev/full"});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_NE(result.err.find("standard output cannot be written"), std::string::npos);
}

TEST(CommandLine, UnknownCommandsAreNamedWithTheNearest) {
  expectRefused({"particle"}, 2, "there is no command \"particle\". Did you mean particles?");
  expectRefused({"particles", kClassic, "--tme", "1"}, 2, "there is no option --tme. Did you mean --time?");
  expectRefused({"particles", kClassic, "extra", "--time", "1"}, 2, "\"extra\" was not expected.");
}

TEST(CommandLine, EveryCommandHasHelpWithExamplesOnStdout) {
  const ProcessResult all = npseeRun({"--help"});
  EXPECT_EQ(all.exit_code, 0);
  std::istringstream lines(all.out.substr(all.out.find("Subcommands:")));
  std::string line;
  int commands = 0;
  while (std::getline(lines, line)) {
    if (!line.starts_with("  ") || line.starts_with("   ")) continue;
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    const ProcessResult help = npseeRun({name, "--help"});
    EXPECT_EQ(help.exit_code, 0) << name;
    EXPECT_NE(help.out.find("npsee " + name), std::string::npos) << name;
    EXPECT_NE(help.out.find("Example"), std::string::npos) << name;
    ++commands;
  }
  EXPECT_GE(commands, 3);
  EXPECT_TRUE(npseeRun({"--version"}).out.starts_with("npsee "));
}

TEST(ParamsCommand, PrintsOneParameterAndNamesTheNearestOfAnUnknownOne) {
  EXPECT_NE(npseeRun({"params", "speed_mean"}).out.find("Y-mag"), std::string::npos);
  EXPECT_NE(npseeRun({"params", "fragments.speed_mean"}).out.find("Y-mag"), std::string::npos);
  EXPECT_TRUE(nlohmann::json::accept(npseeRun({"params", "--format", "json"}).out));
  EXPECT_TRUE(nlohmann::json::accept(npseeRun({"params", "--format", "schema"}).out));
  EXPECT_NE(npseeRun({"params", "--format", "markdown"}).out.find("| `speed_mean` |"), std::string::npos);
  expectRefused({"params", "sped_mean"}, 2, "Did you mean speed_mean?");
}

TEST(CheckCommand, ReportsEveryFaultAndExitsOne) {
  const test::TemporaryFolder folder;
  test::spill(folder / "a.npsee.json", "{ \"npsee\": 1,\n \"gravty\": 1, \"layers\": [ ] }");
  const ProcessResult result = npseeRun({"check", folder.path()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("a.npsee.json:2: /gravty: there is no such parameter.\n  Did you mean gravity?"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("1 file checked, 1 with faults"), std::string::npos);
  const auto json = nlohmann::json::parse(npseeRun({"check", folder.path(), "--json"}).out);
  EXPECT_EQ(json["bad"], 1);
  EXPECT_EQ(json["faults"][0]["line"], 2);
  EXPECT_EQ(npseeRun({"check", std::string(NPSEE_SOURCE_DIR) + "/presets"}).exit_code, 0);
  EXPECT_EQ(npseeRun({"check", folder / "none"}).exit_code, 3);
}

}  // namespace
}  // namespace npsee
