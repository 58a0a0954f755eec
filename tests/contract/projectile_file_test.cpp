// Projectile files and coefficient tables: what is read, what is refused and how it is said.

#include <npsee/ballistics.h>

#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace npsee {
namespace {

/// A small valid file; tests change one line of it.
const std::string kGood = R"({
"npsee_projectile": 1,
"name": "ball",
"status": "test",
"constants": {
"mass": {"value": 10, "unit": "kg", "source": "X"},
"diameter": {"value": 100, "unit": "mm", "source": "X"}
},
"coefficients": {
"CD0": {"mach": [0, 1, 2],
"value": [0.2, 0.4, 0.3],
"source": "X"}
},
"charges": [
{"name": "1", "muzzle_velocity": 300, "unit": "m/s", "source": "X"}
],
"sources": {"X": "a book"}
})";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string faultsOf(const std::string& text) {
  const auto projectile = parseProjectile(text, "p.json");
  return projectile ? "" : projectile.error().text();
}

TEST(ProjectileFile, AGoodFileIsReadInItsUnits) {
  const auto p = parseProjectile(kGood, "p.json");
  ASSERT_TRUE(p) << p.error().text();
  EXPECT_EQ(p->mass_kg, 10.0);
  EXPECT_DOUBLE_EQ(p->diameter_m, 0.1);
  EXPECT_EQ(p->charges[0].speed_mps, 300.0);
  EXPECT_EQ(p->sources[0].second, "a book");
  EXPECT_DOUBLE_EQ(p->curve(Coefficient::cd0).at(1.0), 0.4);
  EXPECT_DOUBLE_EQ(p->curve(Coefficient::cd0).at(9.0), 0.3);
}

TEST(ProjectileFile, EveryShippedFileIsValidAndInTheFormTheProgramWrites) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(NPSEE_SOURCE_DIR) + "/assets/projectiles")) {
    const auto p = loadProjectile(entry.path());
    ASSERT_TRUE(p) << p.error().text();
    EXPECT_EQ(projectileText(*p), test::slurp(entry.path().string())) << entry.path();
    const auto again = parseProjectile(projectileText(*p), "again");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(*again, *p);
    const auto shipped = findProjectile(entry.path().stem().string());
    ASSERT_TRUE(shipped);
    EXPECT_EQ(*shipped, *p) << "the file's name is the projectile's, and the build holds this text";
    EXPECT_EQ(p->name, entry.path().stem());
    for (const auto& curve : p->aero) EXPECT_TRUE(curve.empty() || !curve.source.empty());
    EXPECT_TRUE(Ballistics::make(*p));
    ++count;
  }
  EXPECT_EQ(count, shippedProjectiles().size());
  EXPECT_GE(count, 4u);
}

TEST(ProjectileFile, TheDataFileOfTheM107HasItsCharges) {
  const auto p = findProjectile("m107");
  ASSERT_TRUE(p);
  std::string names;
  for (const Charge& charge : p->charges) names += charge.name + ' ';
  EXPECT_EQ(names, "3W 4W 5W 6W 7W 8 4G 5G ");
  EXPECT_EQ(findProjectile("m106")->status, "ESTIMATE");
}

TEST(ProjectileFile, EveryFaultHasFileLinePointerAndRemedy) {
  const std::tuple<std::string, std::string, const char*> cases[] = {
      {"\"npsee_projectile\": 1", "\"npsee_projectile\": 2", "p.json:2: /npsee_projectile: the file has version 2, but this program reads version 1."},
      {"\"name\": \"ball\"", "\"nmae\": \"ball\"", "p.json:3: /nmae: there is no such key.\n  Did you mean name?"},
      {"\"name\": \"ball\"", "\"name\": 3", "p.json:3: /name: this is 3, but must be a text."},
      {"\"value\": 10,", "\"value\": 0,", "p.json:6: /constants/mass/value: mass is 0 kg, outside 1e-05 to 100000 kg."},
      {"\"value\": 10,", "\"value\": \"ten\",", "p.json:6: /constants/mass/value: this is \"ten\", but must be a number."},
      {"\"unit\": \"mm\"", "\"unit\": \"furlong\"", "p.json:7: /constants/diameter/unit: \"furlong\" is not a unit of diameter; units are m, mm and in.\n  Convert the value."},
      {"\"value\": 10, \"unit\": \"kg\"", "\"value\": 10", "p.json:6: /constants/mass/unit: this is missing."},
      {"\"source\": \"X\"},\n\"diameter\"", "\"source\": \"Y\"},\n\"diameter\"", "/constants/mass/source: \"Y\" is not among the file's sources."},
      {"[0, 1, 2]", "[0, 2, 1]", "p.json:10: /coefficients/CD0/mach/2: Mach 1 follows 2, but Mach numbers must rise.\n  Sort the rows"},
      {"[0, 1, 2]", "[0, 1, 1]", "Mach 1 follows 1"},
      {"[0, 1, 2]", "[0, 1]", "p.json:10: /coefficients/CD0: there are 2 Mach numbers but 3 values."},
      {"[0.2, 0.4, 0.3]", "[0.2, null, 0.3]", "p.json:11: /coefficients/CD0/value/1: this is null, but must be a number."},
      {"[0.2, 0.4, 0.3]", "[0.2, NaN, 0.3]", "p.json:11: is not JSON"},
      {"[0.2, 0.4, 0.3]", "[0.2, 1e9, 0.3]", "the coefficient is 1000000000, beyond +-10000"},
      {"\"value\": [0.2, 0.4, 0.3],\n", "", "/coefficients/CD0/value: this is missing."},
      {"\"CD0\": {", "\"CD1\": {", "/coefficients/CD1: there is no such key.\n  Did you mean CD0?"},
      {"\"muzzle_velocity\": 300", "\"muzzle_velocity\": -3", "p.json:15: /charges/0/muzzle_velocity: the muzzle velocity is -3 m/s, outside 0 to 10000 m/s."},
      {"\"unit\": \"m/s\"", "\"unit\": \"knots\"", "/charges/0/unit: \"knots\" is not a unit of a muzzle velocity; units are m/s and ft/s."},
      {"\"charges\": [", "\"charges\": 3, \"x\": [", "/charges: this is 3, but must be a list."},
      {"\"source\": \"X\"}\n]", "\"source\": \"X\", \"factors\": {\"elevation_mil\": [9], \"form\": [1], \"source\": \"X\"}}\n]", "/charges/0/factors/elevation_mil: this must be two numbers"},
      {"\"source\": \"X\"}\n]", "\"source\": \"X\", \"factors\": {\"elevation_mil\": [0, 900], \"fom\": [1], \"source\": \"X\"}}\n]", "/charges/0/factors/fom: there is no such key.\n  Did you mean form?"},
      {"\"source\": \"X\"}\n]", "\"source\": \"X\"},\n{\"name\": \"1\", \"muzzle_velocity\": 300, \"unit\": \"m/s\", \"source\": \"X\"}\n]", "p.json:16: /charges/1/name: the name \"1\" is taken by charge 0."},
  };
  for (const auto& [from, to, expected] : cases) {
    const std::string faults = faultsOf(changed(from, to));
    EXPECT_NE(faults.find(expected), std::string::npos) << to << "\n-> " << faults;
  }
  EXPECT_NE(faultsOf("[]").find("must be an object"), std::string::npos);
  EXPECT_NE(faultsOf("{").find("is not JSON"), std::string::npos);
}

TEST(ProjectileFile, SignsOfTheConventionAreChecked) {
  const std::string with = changed("\"CD0\":", "\"Cspin\": {\"mach\": [0, 1], \"value\": [-0.01, 0.02], \"source\": \"X\"},\n\"CMa\": {\"mach\": [0], \"value\": [0], \"source\": \"X\"},\n\"CD0\":");
  const std::string faults = faultsOf(with);
  EXPECT_NE(faults.find("/coefficients/Cspin/value/1: Cspin is 0.02, but must not be positive."), std::string::npos) << faults;
  EXPECT_NE(faults.find("/coefficients/CMa/value/0: CMa is 0, but must be positive."), std::string::npos) << faults;
}

TEST(ProjectileFile, PolynomialsByMachIntervalAreTheThesisEquation316) {
  const std::string text = changed("\"mach\": [0, 1, 2],\n\"value\": [0.2, 0.4, 0.3]", "\"polynomial\": [{\"mach_to\": 0.9, \"a\": [0.2]}, {\"mach_to\": 1.5, \"a\": [0.1, 0.2, 0.05, -0.01, 0.002]}]");
  const auto p = parseProjectile(text, "p.json");
  ASSERT_TRUE(p) << p.error().text();
  const CoefficientCurve& curve = p->curve(Coefficient::cd0);
  const auto expected = [](double m) { return 0.1 + 0.2 * m + 0.05 * m * m - 0.01 * m * m * m + 0.002 * m * m * m * m; };
  EXPECT_DOUBLE_EQ(curve.at(0.5), 0.2);
  EXPECT_NEAR(curve.at(1.2), expected(1.2), 1e-14);
  EXPECT_NEAR(curve.at(3.0), expected(1.5), 1e-14);
  EXPECT_NE(faultsOf(changed("\"mach\": [0, 1, 2],\n\"value\": [0.2, 0.4, 0.3]", "\"polynomial\": [{\"mach_to\": 0.9, \"a\": [0.2]}, {\"mach_to\": 0.8, \"a\": [0.1]}]")).find("ceilings must rise"), std::string::npos);
  EXPECT_NE(faultsOf(changed("\"mach\": [0, 1, 2],\n\"value\": [0.2, 0.4, 0.3]", "\"polynomial\": [{\"mach_to\": 0.9, \"a\": []}]")).find("1 to 12 coefficients"), std::string::npos);
}

TEST(ProjectileFile, APolynomialAndItsFineTableFlyTheSame) {
  auto polynomial = parseProjectile(changed("\"mach\": [0, 1, 2],\n\"value\": [0.2, 0.4, 0.3]", "\"polynomial\": [{\"mach_to\": 2, \"a\": [0.1, 0.2, 0.05, -0.01, 0.002]}]"), "p.json");
  ASSERT_TRUE(polynomial);
  Projectile table = *polynomial;
  CoefficientCurve& curve = table.curve(Coefficient::cd0);
  curve.pieces.clear();
  for (int i = 0; i <= 1000; ++i) {
    curve.mach.push_back(0.002 * i);
    curve.value.push_back(polynomial->curve(Coefficient::cd0).at(curve.mach.back()));
  }
  Shot s;
  s.speed_mps = 500.0;
  s.elevation_rad = 0.6;
  EXPECT_NEAR(Ballistics::make(*polynomial)->fly(s).range_m, Ballistics::make(table)->fly(s).range_m, 0.01);
}

TEST(ProjectileFile, MonotoneCurvesDoNotOvershootAndMeetTheirKnots) {
  CoefficientCurve curve;
  curve.mach = {0.0, 0.8, 0.9, 1.0, 1.1, 2.0};
  curve.value = {0.15, 0.15, 0.18, 0.38, 0.39, 0.29};
  for (std::size_t i = 0; i < curve.mach.size(); ++i) EXPECT_NEAR(curve.at(curve.mach[i]), curve.value[i], 1e-14);
  for (double m = 0.0; m < 0.8; m += 0.01) EXPECT_NEAR(curve.at(m), 0.15, 1e-14);
  for (double m = 0.8; m < 1.09; m += 0.005) EXPECT_LE(curve.at(m), curve.at(m + 0.005) + 1e-14) << m;
  for (double m = 1.1; m < 2.0; m += 0.01) EXPECT_LE(curve.at(m), 0.39 + 1e-14) << m;
  curve.interpolation = Interpolation::linear;
  EXPECT_NEAR(curve.at(0.95), 0.28, 1e-14);
}

TEST(AeroTable, BrokenTablesAreNamedWithTheirPlace) {
  const auto faults = [](const std::string& text, bool drag_only = false) {
    const auto table = parseAeroTable(text, "t.json", Interpolation::linear, drag_only);
    return table ? std::string() : table.error().text();
  };
  EXPECT_EQ(faults("{\"M\": [0, 1], \"CD0\": [0.2, 0.3]}", true), "");
  EXPECT_NE(faults("{\"M\": [0, 1],\n \"CD0\": [0.2, 0.3]}").find("/CLa: the column is missing.\n  The modified point-mass model needs it; with --model point-mass"), std::string::npos);
  EXPECT_NE(faults("{\"M\": [0, 1]}", true).find("/CD0: the column is missing."), std::string::npos);
  EXPECT_NE(faults("{\"CD0\": [0, 1]}", true).find("/M: this is missing."), std::string::npos);
  EXPECT_NE(faults("{\"M\": [0, 2, 1],\n\"CD0\": [0.2, 0.3, 0.4]}", true).find("t.json:1: /M/2: Mach 1 follows 2, but Mach numbers must rise."), std::string::npos);
  EXPECT_NE(faults("{\"M\": [0, 1],\n\"CD0\": [0.2]}", true).find("t.json:2: /CD0: the column has 1 values for 2 Mach numbers."), std::string::npos);
  EXPECT_NE(faults("{\"M\": [0, 1],\n\"CD0\": [0.2, NaN]}", true).find("t.json:2: is not JSON"), std::string::npos);
  EXPECT_NE(faults("{\"M\": [0, 1],\n\"CD0\": [0.2, null]}", true).find("t.json:2: /CD0/1: this is null"), std::string::npos);
  EXPECT_NE(faults("{\"M\": [], \"CD0\": []}", true).find("the table has no rows"), std::string::npos);
  EXPECT_NE(faults("{\"M\": [0, 1], \"CD0\": [0.2, 0.3], \"CDO\": [1, 2]}", true).find("Did you mean CD0?"), std::string::npos);
}

}  // namespace
}  // namespace npsee
