// Every case of tests/data/ballistics_reference.json: published firing-table values, other people's programs, quadratures and
// closed forms. Where our own bound is tighter than the case's, ours is checked.

#include "tests/physics/ballistics_support.h"

#include <nlohmann/json.hpp>

#include <set>

namespace npsee {
namespace {

using nlohmann::json;
using test::flying;
using test::mil;

const json& cases() {
  static const json all = json::parse(test::data("ballistics_reference.json"))["cases"];
  return all;
}

const json& byId(const std::string& id) {
  for (const json& item : cases())
    if (item["id"] == id) return item;
  throw std::runtime_error("no case " + id);
}

std::vector<json> byPrefix(const std::string& prefix) {
  std::vector<json> out;
  for (const json& item : cases())
    if (item["id"].get<std::string>().starts_with(prefix)) out.push_back(item);
  return out;
}

Projectile independentShell() {
  Projectile p = test::shipped("m107");
  auto aero = parseAeroTable(test::data("m107_table.json"), "m107_table.json", Interpolation::linear);
  EXPECT_TRUE(aero) << aero.error().text();
  p.aero = *aero;
  return p;
}

double percentOff(double value, double expected) { return 100.0 * std::fabs(value - expected) / std::fabs(expected); }

TEST(BallisticsReference, EveryCaseOfTheFileBelongsToATestHere) {
  const std::set<std::string> known{"thesis_table2", "thesis_table1", "ft_4W_97.2", "ft_4W_152.0", "ft_4W_211.6", "ft_6W_258.4", "ft_6W_378.6", "ft_6W_539.9", "ft_7W_319.8",
                                    "ob_3W_267", "ob_3W_533", "ob_3W_800", "dragonly3dof_15", "dragonly3dof_45", "qd_cd030_568_533", "qd_cd015_297_266", "linear_drag",
                                    "vertical_cd030_300", "vacuum_297_533_h0", "coriolis_vacuum_lat36_az0", "maxrange_274.3", "maxrange_374.6", "isa"};
  for (const json& item : cases()) EXPECT_TRUE(known.contains(item["id"].get<std::string>())) << item["id"];
  EXPECT_EQ(cases().size(), known.size());
}

TEST(BallisticsReference, AnIndependentModifiedPointMassCodeAgreesWithinFiveCentimetres) {
  const Ballistics model = flying(independentShell());
  for (const json& item : byPrefix("ob_")) {
    const Flight flight = model.fly(test::shot(item["v0"], mil(item["qe_mil"])));
    EXPECT_NEAR(flight.range_m, item["expected"]["range"], 0.05) << item["id"];
    EXPECT_NEAR(flight.drift_m, item["expected"]["drift_right"], 0.05) << item["id"];
    EXPECT_TRUE(flight.valid());
  }
}

TEST(BallisticsReference, AnIndependentDragOnlyCodeAgreesWithinFiveCentimetres) {
  // ASAT-13 axial force, linear, as that code has it.
  Projectile p = test::sphere(43.4542, 0.155, 0.3);
  CoefficientCurve& cd = p.curve(Coefficient::cd0);
  cd.mach = {0.01, 0.6, 0.8, 0.9, 0.95, 1.0, 1.05, 1.1, 1.2, 1.35, 1.5, 1.75, 2.0};
  cd.value = {0.144, 0.144, 0.146, 0.167, 0.221, 0.327, 0.383, 0.381, 0.37, 0.353, 0.338, 0.314, 0.294};
  cd.interpolation = Interpolation::linear;
  Conditions conditions;
  conditions.gravity = GravityModel::inverse_square;
  const Ballistics model = flying(p, conditions, FlightModel::point_mass);
  for (const json& item : byPrefix("dragonly3dof_")) {
    const Flight flight = model.fly(test::shot(684.0, item["qe_deg"].get<double>() * kPi / 180.0));
    EXPECT_NEAR(flight.range_m, item["expected"]["range"], 0.05) << item["id"];
  }
}

TEST(BallisticsReference, HodographQuadratureAgreesWithinACentimetre) {
  for (const json& item : byPrefix("qd_")) {
    const Projectile p = test::sphere(item["mass_kg"], item["d_m"], item["CD"]);
    const Flight flight = flying(p, test::constantAir(item["rho"])).fly(test::shot(item["v0"], mil(item["qe_mil"])));
    const json& expected = item["expected"];
    EXPECT_NEAR(flight.range_m, expected["range"], 0.01) << item["id"];
    EXPECT_NEAR(flight.time_of_flight_s, expected["tof"], 1e-4) << item["id"];
    EXPECT_NEAR(flight.max_ordinate_m, expected["max_ordinate"], 0.01) << item["id"];
    EXPECT_NEAR(flight.apex_time_s, expected["t_apex"], 1e-3) << item["id"];
    EXPECT_NEAR(flight.apex_range_m, expected["x_apex"], 0.2) << item["id"];
    EXPECT_NEAR(flight.impact_speed_mps, expected["v_impact"], 1e-3) << item["id"];
    EXPECT_NEAR(flight.angle_of_fall_rad * 180.0 / kPi, expected["angle_of_fall_deg"], 1e-3) << item["id"];
  }
}

TEST(BallisticsReference, DragProportionalToSpeedFollowsItsClosedForm) {
  const json& item = byId("linear_drag");
  Projectile p = test::sphere(43.0913, 0.155, 0.3);
  CoefficientCurve& cd = p.curve(Coefficient::cd0);
  cd = {};
  // CD = c / M by a table so fine that its interpolation does not show.
  const double area = kPi * 0.155 * 0.155 / (8.0 * 43.0913);
  const double c = item["kL"].get<double>() / (area * 1.225 * 340.29399);
  for (int i = 0; i <= 1500; ++i) {
    cd.mach.push_back(0.2 + i * 0.001);
    cd.value.push_back(c / cd.mach.back());
  }
  Conditions conditions = test::constantAir();
  conditions.atmosphere.sound_speed_mps = 340.29399;
  const Flight flight = flying(p, conditions).fly(test::shot(item["v0"], mil(item["qe_mil"])));
  EXPECT_NEAR(flight.range_m, item["expected"]["range"], 0.01);
  EXPECT_NEAR(flight.time_of_flight_s, item["expected"]["tof"], 1e-4);
  EXPECT_NEAR(flight.apex_time_s, item["expected"]["t_apex"], 1e-3);
  EXPECT_NEAR(flight.max_ordinate_m, item["expected"]["max_ordinate"], 0.01);
}

TEST(BallisticsReference, AVerticalShotWithQuadraticDragFollowsItsClosedForm) {
  const json& item = byId("vertical_cd030_300");
  const Flight flight = flying(test::sphere(43.0913, 0.155, 0.3), test::constantAir()).fly(test::shot(item["v0"], mil(item["qe_mil"])));
  EXPECT_NEAR(flight.max_ordinate_m, item["expected"]["max_ordinate"], 0.01);
  EXPECT_NEAR(flight.apex_time_s, item["expected"]["t_up"], 1e-3);
  EXPECT_NEAR(flight.time_of_flight_s, item["expected"]["t_total"], 1e-3);
  EXPECT_NEAR(flight.impact_speed_mps, item["expected"]["v_impact"], 1e-3);
  EXPECT_NEAR(flight.range_m, 0.0, 1e-9);
}

TEST(BallisticsReference, TheVacuumFollowsTheParabola) {
  const json& item = byId("vacuum_297_533_h0");
  const Flight flight = flying(test::shipped("m107"), {}, FlightModel::vacuum).fly(test::shot(item["v0"], mil(item["qe_mil"])));
  EXPECT_NEAR(flight.range_m, item["expected"]["range"], 1e-6);
  EXPECT_NEAR(flight.time_of_flight_s, item["expected"]["tof"], 1e-9);
  EXPECT_NEAR(flight.max_ordinate_m, item["expected"]["max_ordinate"], 1e-6);
  EXPECT_NEAR(flight.impact_speed_mps, item["expected"]["v_impact"], 1e-9);
}

TEST(BallisticsReference, CoriolisInAVacuumAgreesWithTheMatrixExponential) {
  const json& item = byId("coriolis_vacuum_lat36_az0");
  Conditions conditions;
  conditions.coriolis = conditions.has_latitude = true;
  conditions.latitude_rad = item["lat_deg"].get<double>() * kPi / 180.0;
  const Flight flight = flying(test::shipped("m107"), conditions, FlightModel::vacuum).fly(test::shot(item["v0"], mil(item["qe_mil"])));
  EXPECT_NEAR(flight.range_m, item["expected"]["range"], 0.01);
  EXPECT_NEAR(flight.drift_m, item["expected"]["right"], 0.01);
  EXPECT_NEAR(flight.time_of_flight_s, item["expected"]["tof"], 1e-4);
}

TEST(BallisticsReference, FiringTableRowsAreMetByTheUnfittedModel) {
  const Projectile m107 = test::shipped("m107");
  const Ballistics model = flying(m107);
  for (const json& item : byPrefix("ft_")) {
    const auto charge = findCharge(m107, item["charge"].get<std::string>());
    ASSERT_TRUE(charge);
    EXPECT_EQ(charge->speed_mps, item["v0"].get<double>());
    const Flight flight = model.fly(test::shot(charge->speed_mps, mil(item["qe_mil"])));
    const json &expected = item["expected"], &tolerance = item["tolerance"];
    EXPECT_LT(percentOff(flight.range_m, expected["range"]), tolerance["range_pct"].get<double>()) << item["id"];
    EXPECT_LT(percentOff(flight.time_of_flight_s, expected["tof"]), tolerance["tof_pct"].get<double>()) << item["id"];
    EXPECT_LT(percentOff(flight.drift_m, expected["drift_right"]), tolerance["drift_pct"].get<double>()) << item["id"];
    EXPECT_LT(percentOff(flight.impact_speed_mps, expected["v_impact"]), tolerance["v_impact_pct"].get<double>()) << item["id"];
    EXPECT_LT(percentOff(flight.max_ordinate_m, expected["max_ordinate"]), tolerance["max_ordinate_pct"].get<double>()) << item["id"];
  }
}

TEST(BallisticsReference, TheStandardAtmosphereHasItsPublishedValues) {
  for (const json& row : byId("isa")["rows"]) {
    const AirState air = airAt({}, row[0]);
    EXPECT_NEAR(air.density_kgm3 / row[1].get<double>(), 1.0, 2e-4) << row[0];
    EXPECT_NEAR(air.sound_speed_mps, row[2], 0.01) << row[0];
  }
}

}  // namespace
}  // namespace npsee
