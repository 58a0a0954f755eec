// npsee fly, table and aim through the real command line: every option, every message.

#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace npsee {
namespace {

using nlohmann::json;
using test::npseeRun;
using test::ProcessResult;
using Arguments = std::vector<std::string>;

const std::string kTable = std::string(NPSEE_SOURCE_DIR) + "/tests/data/m107_table.json";

Arguments plus(Arguments base, const Arguments& more) {
  base.insert(base.end(), more.begin(), more.end());
  return base;
}

json flyJson(const Arguments& arguments) {
  const ProcessResult result = npseeRun(plus({"fly", "--json"}, arguments));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json::parse(result.out, nullptr, false);
}

double rangeOf(const Arguments& arguments) { return flyJson(arguments)["range_m"]; }

const Arguments kCharge7{"--charge", "7W", "--qe", "533.33mil"};
const Arguments kOptionsOnly{"--mass", "43.0913", "--diameter", "0.155", "--cd", "0.30", "--atmosphere", "constant:1.225", "--v0", "568", "--qe", "533.3333333333333mil"};

TEST(FlyCommand, JsonHasEveryPromisedKey) {
  const json flight = flyJson(kCharge7);
  for (const char* key : {"range_m", "drift_m", "time_of_flight_s", "max_ordinate_m", "apex_time_s", "apex_range_m", "impact_speed_mps", "angle_of_fall_rad", "spin_muzzle_radps", "spin_impact_radps", "yaw_max_rad", "evaluations"})
    EXPECT_TRUE(flight[key].is_number()) << key;
  EXPECT_TRUE(flight["valid"].get<bool>());
  EXPECT_NEAR(flight["range_m"], 13154.0, 2.0);
  EXPECT_NEAR(flight["drift_m"], 220.0, 2.0);
  EXPECT_NEAR(flight["spin_muzzle_radps"], 2.0 * 3.14159265358979 * 568.0 / (20 * 0.155), 1e-6);
}

TEST(FlyCommand, AProjectileWhollyGivenByOptionsMeetsTheQuadrature) {
  const json flight = flyJson(kOptionsOnly);
  EXPECT_NEAR(flight["range_m"], 12252.110113432851, 0.01);
  EXPECT_NEAR(flight["time_of_flight_s"], 44.354567082745966, 1e-4);
  EXPECT_EQ(flight["yaw_max_rad"], 0.0);
  EXPECT_EQ(flight["drift_m"].get<double>(), 0.0 * flight["range_m"].get<double>());
}

TEST(FlyCommand, ACoefficientTableMeetsTheIndependentCode) {
  const json flight = flyJson({"--mass", "43.0913", "--diameter", "0.155", "--inertia", "0.1461", "--twist", "20", "--aero", kTable, "--interpolation", "linear", "--v0", "297", "--qe", "800mil"});
  EXPECT_NEAR(flight["range_m"], 7264.1529, 0.05);
  EXPECT_NEAR(flight["drift_m"], 176.6965, 0.05);
  const json over = flyJson({"--projectile", "m107", "--unfitted", "--aero", kTable, "--interpolation", "linear", "--charge", "3W", "--qe", "800mil"});
  EXPECT_NEAR(over["range_m"], 7264.1529, 0.05);
}

TEST(FlyCommand, SpinDampingCanBeGivenByOneCoefficient) {
  const Arguments spin = plus(kOptionsOnly, {"--inertia", "0.1461", "--twist", "20", "--cspin", "-0.01"});
  const json flight = flyJson(spin);
  EXPECT_LT(flight["spin_impact_radps"], flight["spin_muzzle_radps"]);
  EXPECT_NEAR(flight["range_m"], 12252.110113432851, 0.01);
}

TEST(FlyCommand, CoriolisInAVacuumMeetsTheMatrixExponential) {
  const Arguments base{"--model", "vacuum", "--v0", "568", "--qe", "700mil", "--latitude", "36deg"};
  const json on = flyJson(plus(base, {"--coriolis", "on"}));
  EXPECT_NEAR(on["range_m"], 32266.41993842894, 0.01);
  EXPECT_NEAR(on["drift_m"], 63.367086011657605, 0.01);
  EXPECT_EQ(flyJson(plus(base, {"--coriolis", "off"}))["drift_m"], 0.0);
  EXPECT_EQ(flyJson(base), on) << "a latitude turns it on";
}

TEST(FlyCommand, AnglesTakeMilsDegreesAndRadiansAndMeanMilsWithoutAUnit) {
  const double mils = rangeOf({"--charge", "3W", "--qe", "800mil"});
  EXPECT_EQ(rangeOf({"--charge", "3W", "--qe", "800"}), mils);
  EXPECT_NEAR(rangeOf({"--charge", "3W", "--qe", "45deg"}), mils, 1e-6);
  EXPECT_NEAR(rangeOf({"--charge", "3W", "--qe", "0.7853981633974483rad"}), mils, 1e-6);
}

TEST(FlyCommand, EveryOptionOfTheSurroundingsChangesTheFlight) {
  const double plain = rangeOf(kCharge7);
  EXPECT_GT(rangeOf(plus(kCharge7, {"--wind", "10,0,0"})), plain + 50.0);
  EXPECT_LT(rangeOf(plus(kCharge7, {"--wind", "-10,0,0"})), plain - 50.0);
  EXPECT_NEAR(rangeOf(plus(kCharge7, {"--gravity", "curved"})), plain + 14.0, 4.0);
  EXPECT_GT(rangeOf(plus(kCharge7, {"--gravity", "inverse-square"})), plain);
  EXPECT_GT(rangeOf(plus(kCharge7, {"--g", "9.7"})), plain + 10.0);
  EXPECT_LT(rangeOf(plus(kCharge7, {"--atmosphere", "constant:1.225"})), plain - 500.0);
  EXPECT_GT(rangeOf(plus(kCharge7, {"--altitude", "1km"})), plain + 200.0);
  EXPECT_LT(rangeOf(plus(kCharge7, {"--height-of-target", "300"})), plain - 200.0);
  EXPECT_GT(rangeOf(plus(kCharge7, {"--height-of-target", "-300"})), plain + 200.0);
  EXPECT_NE(rangeOf(plus(kCharge7, {"--latitude", "36", "--azimuth", "1600mil"})), rangeOf(plus(kCharge7, {"--latitude", "36", "--azimuth", "270deg"})));
}

TEST(FlyCommand, EveryOptionOfTheProjectileChangesTheFlight) {
  const json plain = flyJson(kCharge7);
  const double range = plain["range_m"];
  EXPECT_NE(rangeOf(plus(kCharge7, {"--unfitted"})), range);
  EXPECT_GT(rangeOf(plus(kCharge7, {"--mass", "45"})), range);
  EXPECT_GT(rangeOf(plus(kCharge7, {"--set", "mass=99.2lb"})), range);
  EXPECT_LT(rangeOf(plus(kCharge7, {"--diameter", "0.16"})), range);
  EXPECT_LT(rangeOf(plus(kCharge7, {"--set", "form=1.1"})), range);
  // Blanks around the key change nothing, and a factor of 1 is set by hand too.
  EXPECT_EQ(rangeOf(plus(kCharge7, {"--set", " form =1.1"})), rangeOf(plus(kCharge7, {"--set", "form=1.1"})));
  EXPECT_EQ(rangeOf(plus(kCharge7, {"--set", "form =1"})), rangeOf(plus(kCharge7, {"--unfitted"})));
  EXPECT_NE(rangeOf(plus(kCharge7, {"--cd", "0.3"})), range);
  EXPECT_LT(flyJson(plus(kCharge7, {"--twist", "25"}))["drift_m"].get<double>(), plain["drift_m"].get<double>() - 20.0);
  EXPECT_NEAR(flyJson(plus(kCharge7, {"--left-hand"}))["drift_m"].get<double>(), -plain["drift_m"].get<double>(), 1e-9);
  EXPECT_EQ(flyJson(plus(kCharge7, {"--inertia", "0"}))["drift_m"], 0.0) << "without a moment of inertia there is no yaw of repose";
  EXPECT_EQ(rangeOf({"--projectile", "m107", "--charge", "7W", "--qe", "533.33mil"}), range);
  EXPECT_GT(rangeOf({"--projectile", "m33", "--charge", "service", "--qe", "30deg"}), 3000.0);
  EXPECT_GT(rangeOf({"--projectile", std::string(NPSEE_SOURCE_DIR) + "/assets/projectiles/m1.json", "--v0", "470", "--qe", "30deg"}), 5000.0);
}

TEST(FlyCommand, EveryModelAndIntegratorIsSelectable) {
  const double full = rangeOf(kCharge7);
  EXPECT_NEAR(rangeOf(plus(kCharge7, {"--model", "vacuum"})), 568.0 * 568.0 * std::sin(2 * 533.33 * 3.14159265358979323846 / 3200.0) / 9.80665, 0.01);
  EXPECT_EQ(flyJson(plus(kCharge7, {"--model", "point-mass"}))["drift_m"], 0.0);
  EXPECT_NEAR(rangeOf(plus(kCharge7, {"--model", "simplified-modified-point-mass"})), full, 5.0);
  EXPECT_EQ(rangeOf(plus(kCharge7, {"--model", "thesis"})), rangeOf(plus(kCharge7, {"--model", "simplified-modified-point-mass"})));
  EXPECT_EQ(rangeOf(plus(kCharge7, {"--model", "modified-point-mass"})), full);
  EXPECT_NEAR(rangeOf(plus(kCharge7, {"--integrator", "rk4", "--dt", "0.05"})), full, 0.05);
  EXPECT_NEAR(rangeOf(plus(kCharge7, {"--integrator", "predictor-corrector"})), full, 0.5);
  EXPECT_NEAR(rangeOf(plus(kCharge7, {"--tolerance", "1e-6"})), full, 0.05);
  EXPECT_EQ(rangeOf(plus(kCharge7, {"--integrator", "dormand-prince"})), full);
}

TEST(FlyCommand, TheSummarySaysWhatIsFlownAndWhatIsDoubtful) {
  const ProcessResult good = npseeRun(plus({"fly"}, kCharge7));
  EXPECT_EQ(good.exit_code, 0);
  for (const char* word : {"charge 7W, 568 m/s, fitted", "range               1315", "drift", "time of flight", "angle of fall", "valid               yes"}) EXPECT_NE(good.out.find(word), std::string::npos) << word << good.out;
  const ProcessResult steep = npseeRun({"fly", "--charge", "3W", "--qe", "1200mil"});
  EXPECT_EQ(steep.exit_code, 0);
  EXPECT_NE(steep.out.find("NO: steeper than 1150 mil"), std::string::npos) << steep.out;
  EXPECT_NE(npseeRun({"fly", "--projectile", "m106", "--charge", "estimate", "--qe", "45deg"}).out.find("[ESTIMATE, not data]"), std::string::npos);
}

TEST(FlyCommand, ThePathGoesToStandardOutputOrAFileWithTheChosenStep) {
  const ProcessResult printed = npseeRun(plus({"fly", "--csv", "--step", "10"}, kCharge7));
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  std::istringstream lines(printed.out);
  std::string line;
  std::vector<std::string> rows;
  while (std::getline(lines, line)) rows.push_back(line);
  ASSERT_EQ(rows.size(), 7u) << printed.out;  // heading, 0, 10, 20, 30, 40 s and the impact
  EXPECT_EQ(rows[0], "t_s,range_m,height_m,drift_m,v_range_mps,v_up_mps,v_right_mps,speed_mps,spin_radps");
  EXPECT_TRUE(rows[1].starts_with("0,0,0,0,"));
  EXPECT_TRUE(rows[2].starts_with("10,"));
  const double impact_range = std::stod(rows[6].substr(rows[6].find(',') + 1));
  EXPECT_NEAR(impact_range, rangeOf(kCharge7), 1e-6);

  const test::TemporaryFolder folder;
  const ProcessResult filed = npseeRun(plus({"fly", "--csv", folder / "path.csv", "--step", "10", "--json"}, kCharge7));
  EXPECT_EQ(filed.exit_code, 0);
  EXPECT_EQ(test::slurp(folder / "path.csv"), printed.out);
  EXPECT_TRUE(json::accept(filed.out));
  EXPECT_EQ(npseeRun(plus({"fly", "--csv", "/nonexistent/path.csv"}, kCharge7)).exit_code, 5);
}

TEST(FlyCommand, AShellThatNeverComesDownThereIsANegativeAnswer) {
  const ProcessResult result = npseeRun({"fly", "--charge", "3W", "--qe", "100mil", "--height-of-target", "5000", "--json"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("never comes down on a surface 5000 m above the muzzle (summit 42."), std::string::npos) << result.err;
  const json flight = json::parse(result.out);
  EXPECT_TRUE(flight["range_m"].is_null());
  EXPECT_FALSE(flight["valid"].get<bool>());
}

struct Refusal {
  Arguments arguments;
  int exit_code;
  const char* message;
};

void expectRefusals(const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals) {
    const ProcessResult result = npseeRun(refusal.arguments);
    std::string line;
    for (const std::string& argument : refusal.arguments) line += argument + ' ';
    EXPECT_EQ(result.exit_code, refusal.exit_code) << line << result.err;
    EXPECT_EQ(result.out, "") << line;
    EXPECT_NE(result.err.find(refusal.message), std::string::npos) << line << "\n-> " << result.err;
  }
}

TEST(FlyCommand, EveryMistakeIsNamedWithItsRemedy) {
  expectRefusals({
      {{"fly", "--charge", "7W"}, 2, "no elevation is given.\n  Give it with --qe"},
      {{"fly", "--qe", "30deg"}, 2, "no muzzle velocity is given.\n  Give --charge (3W, 4W, 5W, 6W, 7W, 8, 4G and 5G) or --v0."},
      {{"fly", "--projectile", "m1", "--qe", "30deg"}, 2, "Give it with --v0"},
      {{"fly", "--charge", "9W", "--qe", "30deg"}, 2, "the projectile m107 has no charge \"9W\".\n  It has 3W, 4W"},
      {{"fly", "--charge", "7W", "--v0", "300", "--qe", "30deg"}, 2, "--charge and --v0 both give the muzzle velocity."},
      {{"fly", "--projectile", "m10", "--charge", "7W", "--qe", "30deg"}, 2, "there is no projectile \"m10\".\n  Did you mean m1? There are m1, m106, m107"},
      {{"fly", "--projectile", "nothing.json", "--charge", "7W", "--qe", "30deg"}, 3, "nothing.json: cannot be read: there is no such file."},
      {{"fly", "--charge", "7W", "--qe", "91deg"}, 2, "the elevation is 1617.7777777777778 mil, outside -1600 to 1600 mil.\n  1600 mil (90 deg) is straight up"},
      {{"fly", "--charge", "7W", "--qe", "30furlong"}, 2, "--qe: \"furlong\" is not a unit for this value; units are deg, rad, mil"},
      {{"fly", "--charge", "7W", "--qe", "steep"}, 2, "--qe: \"steep\" is not a finite number."},
      {{"fly", "--v0", "nan", "--qe", "30deg"}, 2, "--v0: \"nan\" is not a finite number."},
      {{"fly", "--v0", "0", "--qe", "30deg"}, 2, "the muzzle velocity is 0 m/s, outside 0.01 to 10000 m/s."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--twist", "-20"}, 2, "--twist -20: twist is -20 cal/turn, outside 0 to 1000 cal/turn.\n  Calibres per turn of the rifling, never negative"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--mass", "0"}, 2, "--mass 0: mass is 0 kg, outside 1e-05 to 100000 kg."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--mass", "3stone"}, 2, "--mass 3stone: \"stone\" is not a unit of mass; units are kg, g and lb."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--set", "mas=3"}, 2, "--set mas=3: a projectile has no \"mas\".\n  Did you mean mass?"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--set", "mass"}, 2, "--set mass: not of the form KEY=VALUE."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--set", "form=big"}, 2, "--set form=big: \"big\" is not a finite number."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--set", "form=-1"}, 2, "the form factor is -1, outside 0 to 100."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--cd", "-0.3"}, 2, "--cd -0.3: a drag coefficient lies between 0 and 100."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--cspin", "0.1"}, 2, "--cspin 0.1: the spin damping coefficient lies between -100 and 0.\n  It is negative"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--model", "vacum"}, 2, "--model: there is no \"vacum\".\n  Did you mean vacuum? It is one of vacuum, point-mass"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--integrator", "euler"}, 2, "--integrator: there is no \"euler\".\n  It is one of dormand-prince, predictor-corrector, rk4."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--gravity", "none"}, 2, "--gravity: there is no \"none\""},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--g", "0"}, 2, "--g 0: gravity lies between 0.01 and 100 m/s2."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--atmosphere", "mars"}, 2, "--atmosphere: there is no \"mars\".\n  It is icao, or constant:RHO"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--atmosphere", "constant:"}, 2, "--atmosphere constant: lacks the density."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--atmosphere", "constant:-1"}, 2, "a density is not negative"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--wind", "5,3"}, 2, "--wind 5,3: there are 2 numbers instead of three."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--wind", "5,x,3"}, 2, "--wind: \"x\" is not a finite number."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--wind", "5000,0,0"}, 2, "the wind is 5000 m/s, outside -1000 to 1000 m/s."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--coriolis", "on"}, 2, "the Coriolis force needs a latitude.\n  Give one, e.g. --latitude 36deg."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--coriolis", "maybe"}, 2, "--coriolis: there is no \"maybe\""},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--latitude", "95"}, 2, "the latitude is 95 deg, outside -90 to 90 deg."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--tolerance", "0"}, 2, "the tolerance is 0 m"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--integrator", "rk4", "--dt", "0"}, 2, "the integration step is 0 s, outside 0.0001 to 10 s."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--csv", "--step", "0"}, 2, "--step 0: the path would have no end of rows."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--csv", "--step", "1e-9"}, 2, "more than a million rows"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--height-of-target", "1e9"}, 2, "the height of the target is 1000000000 m, outside -20000 to 100000 m."},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--aero", "nothing.json"}, 3, "nothing.json: cannot be read"},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--aero", kTable, "--interpolation", "cubic"}, 2, "--interpolation: there is no \"cubic\""},
      {{"fly", "--charge", "7W", "--qe", "30deg", "--speed", "3"}, 2, "npsee fly --help"},
  });
}

TEST(FlyCommand, ABrokenTableOrProjectileIsNamedWithFileAndLine) {
  const test::TemporaryFolder folder;
  test::spill(folder / "t.json", "{\"M\": [0, 1,\n 0.5],\n\"CD0\": [0.2, 0.3, 0.4]}");
  test::spill(folder / "p.json", "{\n\"npsee_projectile\": 1,\n\"nam\": 3}");
  const Arguments base{"fly", "--v0", "300", "--qe", "30deg"};
  const ProcessResult table = npseeRun(plus(base, {"--model", "point-mass", "--aero", folder / "t.json"}));
  EXPECT_EQ(table.exit_code, 3);
  EXPECT_NE(table.err.find((folder / "t.json") + ":2: /M/2: Mach 0.5 follows 1, but Mach numbers must rise."), std::string::npos) << table.err;
  const ProcessResult columns = npseeRun(plus(base, {"--aero", folder / "t.json"}));
  EXPECT_EQ(columns.exit_code, 3);
  EXPECT_NE(columns.err.find("/CLa: the column is missing."), std::string::npos) << columns.err;
  const ProcessResult projectile = npseeRun(plus(base, {"--projectile", folder / "p.json"}));
  EXPECT_EQ(projectile.exit_code, 3);
  EXPECT_NE(projectile.err.find((folder / "p.json") + ":3: /nam: there is no such key.\n  Did you mean name?"), std::string::npos) << projectile.err;
}

TEST(TableCommand, RowsByElevationComeAsTextCsvAndJson) {
  const Arguments base{"table", "--charge", "7W", "--qe", "200:800:300"};
  const ProcessResult text = npseeRun(base), csv = npseeRun(plus(base, {"--csv"})), as_json = npseeRun(plus(base, {"--format", "json"}));
  EXPECT_EQ(text.exit_code + csv.exit_code + as_json.exit_code, 0);
  EXPECT_NE(text.out.find("QE mil  range m  drift m  time s"), std::string::npos) << text.out;
  const json rows = json::parse(as_json.out)["rows"];
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_NEAR(rows[1]["elevation_mil"], 500.0, 1e-9);
  EXPECT_EQ(rows[1]["range_m"].get<double>(), rangeOf({"--charge", "7W", "--qe", "500mil"}));
  EXPECT_TRUE(csv.out.starts_with("elevation_mil,range_m,drift_m,time_of_flight_s,max_ordinate_m,angle_of_fall_mil,impact_speed_mps,yaw_max_deg,valid\n"));
  EXPECT_EQ(std::ranges::count(csv.out, '\n'), 4);
  EXPECT_EQ(npseeRun(plus(base, {"--json"})).out, as_json.out);
}

TEST(TableCommand, RowsByRangeGiveTheElevations) {
  const ProcessResult result = npseeRun({"table", "--charge", "3W", "--range", "3000:9000:3000", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json rows = json::parse(result.out)["rows"];
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_NEAR(std::hypot(rows[1]["range_m"].get<double>(), rows[1]["drift_m"].get<double>()), 6000.0, 0.5);
  EXPECT_TRUE(rows[2]["elevation_mil"].is_null());
  const ProcessResult high = npseeRun({"table", "--charge", "3W", "--range", "3000:6000:3000", "--solution", "high", "--json"});
  EXPECT_GT(json::parse(high.out)["rows"][0]["elevation_mil"], rows[0]["elevation_mil"]);
}

TEST(TableCommand, TheThesisTablesStandBesideOursWithErrorsInCeps) {
  const ProcessResult result = npseeRun({"table", "--thesis", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json rows = json::parse(result.out)["rows"];
  ASSERT_EQ(rows.size(), 6u);
  const double thesis[] = {2.0, 1.93, 1.08, 4.43, 4.72, 2.67}, vacuum[] = {136.7, 126.2, 126.8, 868.3, 1093.5, 1101.7};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(rows[i]["thesis_model_ceps"], thesis[i], 0.02) << i;
    EXPECT_NEAR(rows[i]["thesis_vacuum_ceps"], vacuum[i], 0.3) << i;
    EXPECT_LT(rows[i]["unfitted_ceps"], 5.5) << i;
    EXPECT_LT(rows[i]["fitted_ceps"], rows[i]["charge"] == "7W" ? 1.0 : 1.6) << i;
  }
  const ProcessResult text = npseeRun({"table", "--thesis"});
  for (const char* word : {"firing table", "thesis vacuum", "our vacuum", "thesis model", "unfitted", "fitted", "worst row"}) EXPECT_NE(text.out.find(word), std::string::npos) << word;
  EXPECT_EQ(npseeRun({"table", "--thesis", "--gravity", "curved"}).exit_code, 0);
}

TEST(TableCommand, EveryMistakeIsNamedWithItsRemedy) {
  expectRefusals({
      {{"table"}, 2, "no muzzle velocity is given."},
      {{"table", "--charge", "7W", "--qe", "1:2"}, 2, "--qe 1:2: not of the form FROM:TO:STEP."},
      {{"table", "--charge", "7W", "--qe", "1:2:0"}, 2, "the step must be above 0 and TO not below FROM."},
      {{"table", "--charge", "7W", "--qe", "9:2:1"}, 2, "the step must be above 0 and TO not below FROM."},
      {{"table", "--charge", "7W", "--qe", "1:1000:0.0001"}, 2, "that makes more than 10000 rows."},
      {{"table", "--charge", "7W", "--qe", "100:1700:100"}, 2, "the elevation is 1700"},
      {{"table", "--charge", "7W", "--qe", "1:2:1", "--range", "1:2:1"}, 2, "--qe and --range both say what the rows are."},
      {{"table", "--charge", "7W", "--range", "1:x:1"}, 2, "--range: \"x\" is not a finite number."},
      {{"table", "--charge", "7W", "--format", "xml"}, 2, "--format: there is no \"xml\".\n  It is text, csv or json."},
      {{"table", "--charge", "7W", "--solution", "both"}, 2, "--solution: there is no \"both\".\n  It is low or high."},
      {{"table", "--thesis", "--projectile", "m33"}, 2, "the projectile m33 has no charge \"3W\"."},
  });
}

TEST(AimCommand, BothSolutionsHitAndTheAzimuthGoesAgainstTheDrift) {
  const ProcessResult result = npseeRun({"aim", "--charge", "7W", "--range", "10km", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json answer = json::parse(result.out);
  EXPECT_TRUE(answer["reachable"].get<bool>());
  ASSERT_EQ(answer["solutions"].size(), 2u);
  for (const json& solution : answer["solutions"]) {
    EXPECT_LT(solution["miss_m"], 0.5);
    const json flight = flyJson({"--charge", "7W", "--qe", std::to_string(solution["elevation_rad"].get<double>()) + "rad"});
    EXPECT_NEAR(std::hypot(flight["range_m"].get<double>(), flight["drift_m"].get<double>()), 10000.0, 0.5);
    EXPECT_NEAR(std::tan(-solution["azimuth_correction_rad"].get<double>()), flight["drift_m"].get<double>() / flight["range_m"].get<double>(), 1e-4);
  }
  EXPECT_EQ(answer["solutions"][0]["branch"], "low");
  EXPECT_TRUE(answer["solutions"][0]["valid"].get<bool>());
  EXPECT_EQ(json::parse(npseeRun({"aim", "--charge", "7W", "--range", "10000", "--solution", "high", "--json"}).out)["solutions"].size(), 1u);
  EXPECT_NE(npseeRun({"aim", "--charge", "7W", "--range", "10000", "--wind", "0,0,12", "--height-of-target", "150"}).out.find("low   elevation"), std::string::npos);
}

TEST(AimCommand, OutOfReachIsANegativeAnswerThatNamesTheMaximum) {
  const ProcessResult result = npseeRun({"aim", "--charge", "3W", "--range", "9000"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("a range of 9000 m is out of reach: the maximum is 73"), std::string::npos) << result.err;
  const ProcessResult as_json = npseeRun({"aim", "--charge", "3W", "--range", "9000", "--json"});
  EXPECT_EQ(as_json.exit_code, 1);
  const json answer = json::parse(as_json.out);
  EXPECT_FALSE(answer["reachable"].get<bool>());
  EXPECT_NEAR(answer["max_range_m"], 7310.0, 20.0);
  const ProcessResult high = npseeRun({"aim", "--charge", "3W", "--range", "5000", "--height-of-target", "9000", "--json"});
  EXPECT_EQ(high.exit_code, 1);
  EXPECT_FALSE(json::parse(high.out)["reachable"].get<bool>());
  EXPECT_EQ(json::parse(high.out)["solutions"].size(), 0u);
  EXPECT_TRUE(answer["solutions"].empty());
}

TEST(AimCommand, TheLegacyTableMissesByItsStep) {
  const json answer = json::parse(npseeRun({"aim", "--charge", "3W", "--range", "5100", "--legacy-step", "--solution", "low", "--json"}).out);
  EXPECT_EQ(answer["laid_range_m"], 5000.0);
  EXPECT_NEAR(answer["solutions"][0]["miss_m"], 100.0, 0.5);
  EXPECT_EQ(json::parse(npseeRun({"aim", "--charge", "3W", "--range", "5130", "--legacy-step", "100", "--solution", "low", "--json"}).out)["laid_range_m"], 5100.0);
}

TEST(AimCommand, EveryMistakeIsNamedWithItsRemedy) {
  expectRefusals({
      {{"aim", "--charge", "3W"}, 2, "no range is given."},
      {{"aim", "--charge", "3W", "--range", "-5"}, 2, "the range is -5 m, but must be above 0."},
      {{"aim", "--charge", "3W", "--range", "far"}, 2, "--range: \"far\" is not a finite number."},
      {{"aim", "--charge", "3W", "--range", "5000", "--solution", "middle"}, 2, "--solution: there is no \"middle\".\n  It is low, high or both."},
      {{"aim", "--charge", "3W", "--range", "5000", "--legacy-step", "0"}, 2, "--legacy-step 0: the step lies between 1 and 10000 m."},
      {{"aim", "--charge", "3W", "--range", "5000", "--height-of-target", "9000"}, 1, "no elevation brings the shell down on a target 9000 m above the muzzle."},
      {{"aim", "--range", "5000"}, 2, "no muzzle velocity is given."},
  });
}

TEST(WeaponsCommand, ShowsAndWritesBackTheFileOf1993) {
  const std::string shipped = std::string(NPSEE_SOURCE_DIR) + "/assets/weapons.dat";
  const ProcessResult text = npseeRun({"weapons", shipped});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.out.find("155mmM109Howitzer (110): range 7300 m, 297 m/s, radii 100 / 150 / 200 m (kill, damage, noticed), against heavy armor, high angle"), std::string::npos) << text.out;
  EXPECT_NE(text.err.find("weapons.dat:7: 203mmM110Howitzer states a range of 16800 m"), std::string::npos) << text.err;
  const json list = json::parse(npseeRun({"weapons", shipped, "--json"}).out);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[2]["target_type"], 2);
  EXPECT_EQ(list[2]["path"], "low angle");
  const test::TemporaryFolder folder;
  EXPECT_EQ(npseeRun({"weapons", shipped, "-o", folder / "w.dat"}).exit_code, 0);
  EXPECT_EQ(test::slurp(folder / "w.dat"), npseeRun({"weapons", shipped, "-o", "-"}).out);
  EXPECT_EQ(json::parse(npseeRun({"weapons", folder / "w.dat", "--json"}).out), list);
  EXPECT_EQ(npseeRun({"weapons", shipped, "-o", "/nonexistent/w.dat"}).exit_code, 5);
}

TEST(WeaponsCommand, FaultsHaveFileAndLineHereAndInCheck) {
  const test::TemporaryFolder folder;
  test::spill(folder / "w.dat", "I gun 7\nD 1 2 3 4 5 9 1\n");
  const std::string message = (folder / "w.dat") + ":2: targettype of gun is \"9\", but must be a whole number from 0 to 6.";
  const ProcessResult shown = npseeRun({"weapons", folder / "w.dat"}), checked = npseeRun({"check", folder / "w.dat"});
  EXPECT_EQ(shown.exit_code, 3);
  EXPECT_NE(shown.err.find(message), std::string::npos) << shown.err;
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_NE(checked.out.find(message), std::string::npos) << checked.out;
  EXPECT_EQ(npseeRun({"weapons", folder / "none.dat"}).exit_code, 3);
  EXPECT_EQ(npseeRun({"check", std::string(NPSEE_SOURCE_DIR) + "/assets/weapons.dat", std::string(NPSEE_SOURCE_DIR) + "/assets/projectiles/m107.json"}).exit_code, 0);
  test::spill(folder / "p.json", "{\n\"npsee_projectile\": 1,\n\"nam\": 3}");
  const ProcessResult projectile = npseeRun({"check", folder / "p.json"});
  EXPECT_EQ(projectile.exit_code, 1);
  EXPECT_NE(projectile.out.find("p.json:3: /nam: there is no such key."), std::string::npos) << projectile.out;
}

TEST(BallisticsCommands, HelpHasExamplesAndEveryOption) {
  for (const char* command : {"fly", "table", "aim"}) {
    const ProcessResult help = npseeRun({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("Examples:\n  npsee " + std::string(command)), std::string::npos);
    for (const char* option : {"--projectile", "--charge", "--v0", "--twist", "--mass", "--diameter", "--inertia", "--cd", "--cspin", "--aero", "--interpolation", "--set", "--unfitted", "--left-hand", "--azimuth", "--wind", "--atmosphere",
                               "--gravity", "--g", "--latitude", "--coriolis", "--altitude", "--height-of-target", "--model", "--integrator", "--tolerance", "--dt"})
      EXPECT_NE(help.out.find(option), std::string::npos) << command << ' ' << option;
  }
}

}  // namespace
}  // namespace npsee
