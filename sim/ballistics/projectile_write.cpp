#include "sim/ballistics/projectile_rows.h"

#include <npsee/units.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace npsee {
namespace ballistics {
namespace {

using nlohmann::ordered_json;

/// The shortest number that the reader turns into `si` again.
double written(double si, double factor) {
  if (factor == 1.0) return si;
  double value = si / factor;
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 15).ptr;
  double rounded = 0.0;
  std::from_chars(text, end, rounded);
  if (rounded * factor == si) return rounded;
  for (double low = value, high = value, step = 0; step < 4; ++step) {
    if (low * factor == si) return low;
    if (high * factor == si) return high;
    low = std::nextafter(low, -INFINITY);
    high = std::nextafter(high, INFINITY);
  }
  return value;
}

ordered_json curveJson(const CoefficientCurve& curve) {
  ordered_json out;
  if (curve.pieces.empty()) {
    out["mach"] = curve.mach;
    out["value"] = curve.value;
  } else {
    out["polynomial"] = ordered_json::array();
    for (const PolynomialPiece& piece : curve.pieces) out["polynomial"].push_back({{"mach_to", piece.mach_to}, {"a", piece.a}});
  }
  if (curve.interpolation == Interpolation::linear) out["interpolation"] = "linear";
  out["source"] = curve.source;
  return out;
}

ordered_json chargeJson(const Charge& charge) {
  ordered_json out{{"name", charge.name}, {"muzzle_velocity", charge.speed_mps}, {"unit", "m/s"}};
  if (!charge.status.empty()) out["status"] = charge.status;
  out["source"] = charge.source;
  if (charge.factors == FactorCurves{}) return out;
  ordered_json& factors = out["factors"];
  factors["elevation_mil"] = {toUnit(Unit::mil, charge.factors.elevation_min_rad), toUnit(Unit::mil, charge.factors.elevation_max_rad)};
  for (const FactorRow& row : factorRows())
    if (!(charge.factors.*row.curve).empty()) factors[std::string(row.key)] = charge.factors.*row.curve;
  factors["source"] = charge.factors.source;
  return out;
}

/// Objects over lines, lists of numbers on one.
void print(const ordered_json& json, int indent, std::string& out) {
  const bool spread = !json.empty() && (json.is_object() || (json.is_array() && json[0].is_structured()));
  if (!spread) {
    out += json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    return;
  }
  out += json.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    out.append(static_cast<std::size_t>(2 * indent + 2), ' ');
    if (json.is_object()) out += ordered_json(key).dump() + ": ";
    print(value, indent + 1, out);
  }
  out += '\n';
  out.append(static_cast<std::size_t>(2 * indent), ' ');
  out += json.is_object() ? '}' : ']';
}

}  // namespace
}  // namespace ballistics

using namespace ballistics;

std::string projectileText(const Projectile& p) {
  ordered_json root{{"npsee_projectile", 1}, {"name", p.name}};
  if (!p.title.empty()) root["title"] = p.title;
  root["status"] = p.status;
  if (!p.note.empty()) root["note"] = p.note;
  for (std::size_t i = 0; i < constantRows().size(); ++i) {
    const ConstantRow& row = constantRows()[i];
    if (!row.required && p.*row.member == 0.0 && p.constant_sources[i].empty()) continue;
    const UnitName& unit = row.units.front();
    root["constants"][std::string(row.key)] = {{"value", written(p.*row.member, unit.to_si)}, {"unit", std::string(unit.name)}, {"source", p.constant_sources[i]}};
  }
  root["coefficients"] = ordered_json::object();
  for (std::size_t c = 0; c < kCoefficients; ++c)
    if (!p.aero[c].empty()) root["coefficients"][std::string(coefficientKey(static_cast<Coefficient>(c)))] = curveJson(p.aero[c]);
  root["charges"] = ordered_json::array();
  for (const Charge& charge : p.charges) root["charges"].push_back(chargeJson(charge));
  root["sources"] = ordered_json::object();
  for (const auto& [key, reference] : p.sources) root["sources"][key] = reference;
  std::string out;
  print(root, 0, out);
  return out + '\n';
}

}  // namespace npsee
