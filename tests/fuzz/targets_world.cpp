#include "tests/fuzz/require.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/targets.h"

#include <npsee/ballistics.h>
#include <npsee/terrain.h>
#include <npsee/weapons.h>

#include <cmath>

namespace npsee::fuzz {
namespace {

void standsEverywhere(const Terrain& terrain) {
  require(terrain.lowest() <= terrain.highest(), "a terrain has a lowest and a highest place");
  for (const double part : {-0.5, 0.0, 0.3, 0.999, 1.0, 2.0}) {
    const double x = part * terrain.sizeX(), z = (1.0 - part) * terrain.sizeZ();
    require(std::isfinite(terrain.height(x, z)) && std::isfinite(terrain.normal(x, z).y), "the ground has a height and a normal everywhere");
  }
}

}  // namespace

void weaponsFile(std::string_view bytes) {
  const auto weapons = parseWeapons(bytes, "fuzz.dat");
  if (!weapons) return requireFaults(weapons.error());
  const std::string text = weaponsText(*weapons);
  const auto again = parseWeapons(text, "again");
  require(again.has_value(), "weapons that are written can be read", again ? text : again.error().text() + '\n' + text);
  require(*again == *weapons, "writing and reading weapons changes nothing", text);
}

void projectileFile(std::string_view bytes) {
  const auto projectile = parseProjectile(bytes, "fuzz.json");
  if (!projectile) return requireFaults(projectile.error());
  require(validate(*projectile).empty(), "a projectile that is read is valid");
  const std::string text = projectileText(*projectile);
  const auto again = parseProjectile(text, "again");
  require(again.has_value() && *again == *projectile, "writing and reading a projectile changes nothing", again ? text : again.error().text() + '\n' + text);
  Integration quick;
  quick.step_limit = 300;
  for (const FlightModel model : {FlightModel::vacuum, FlightModel::point_mass, FlightModel::modified_point_mass}) {
    const auto ballistics = Ballistics::make(*projectile, {}, model, quick);
    if (!ballistics) {
      requireFaults(ballistics.error());
      continue;
    }
    Shot shot;
    shot.speed_mps = 300.0;
    shot.elevation_rad = 0.7;
    shot.factors = projectile->charges.empty() ? Factors{} : projectile->charges.front().factors.at(0.7);
    if (!ballistics->checkShot(shot)) continue;
    const Flight flight = ballistics->fly(shot);
    require(std::isfinite(flight.range_m) && std::isfinite(flight.time_of_flight_s) && std::isfinite(flight.max_ordinate_m), "a flight has finite numbers", text);
  }
}

void aeroTable(std::string_view bytes) {
  for (const bool drag_only : {false, true}) {
    const auto table = parseAeroTable(bytes, "fuzz.json", Interpolation::monotone, drag_only);
    if (!table) {
      requireFaults(table.error());
      continue;
    }
    for (const CoefficientCurve& curve : *table)
      for (const double mach : {0.0, 0.5, 1.0, 3.0}) require(std::isfinite(curve.at(mach)), "a coefficient is finite");
  }
}

void terrainHgt(std::string_view bytes) {
  const ScratchFile file(".hgt", bytes);
  TerrainSource source;
  source.kind = TerrainKind::hgt;
  source.file = file.path();
  source.cell_m = 90.0;
  const auto terrain = Terrain::make(source, 0.0, 0.0, 0.0, 1);
  if (!terrain) return requireFaults(terrain.error());
  standsEverywhere(*terrain);
}

void terrainPng(std::string_view bytes) {
  const std::size_t zero = bytes.find('\0');
  const std::string_view sidecar = bytes.substr(0, zero), picture = zero == std::string_view::npos ? std::string_view() : bytes.substr(zero + 1);
  const ScratchFile file(".png", picture), beside(".png.json", sidecar);
  TerrainSource source;
  source.kind = TerrainKind::png;
  source.file = file.path();
  const auto terrain = Terrain::make(source, 0.0, 0.0, 0.0, 1);
  if (!terrain) return requireFaults(terrain.error());
  standsEverywhere(*terrain);
}

}  // namespace npsee::fuzz
