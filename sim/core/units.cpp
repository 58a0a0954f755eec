#include <npsee/units.h>

#include "sim/core/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <vector>

namespace npsee {
namespace {

/// A unit that may be typed for a quantity, with its factor to SI.
struct Spelling {
  std::string_view name;
  double to_si;
};

struct UnitRow {
  std::string_view symbol;
  double to_si;
  std::span<const Spelling> spellings;
};

constexpr std::array kLengths{Spelling{"m", 1.0}, Spelling{"km", 1000.0}, Spelling{"cm", 0.01}, Spelling{"mm", 0.001}};
constexpr std::array kSpeeds{Spelling{"m/s", 1.0}, Spelling{"km/h", 1.0 / 3.6}};
constexpr std::array kAccelerations{Spelling{"m/s2", 1.0}, Spelling{"m/s^2", 1.0}};
constexpr std::array kTimes{Spelling{"s", 1.0}, Spelling{"ms", 0.001}, Spelling{"min", 60.0}};
// 6400 mil to the circle, as gunners count.
constexpr std::array kAngles{Spelling{"deg", kDegree}, Spelling{"rad", 1.0}, Spelling{"mil", kTwoPi / 6400.0}, Spelling{"\u00b0", kDegree}};
constexpr std::array kRates{Spelling{"1/s", 1.0}};
constexpr std::array kSpins{Spelling{"rev/s", kTwoPi}, Spelling{"rad/s", 1.0}, Spelling{"deg/s", kDegree}, Spelling{"rpm", kTwoPi / 60.0}};
constexpr std::array kTemperatures{Spelling{"K", 1.0}};
constexpr std::array kDensities{Spelling{"kg/m3", 1.0}, Spelling{"g/cm3", 1000.0}};
constexpr std::array kImpulses{Spelling{"kPa s", 1000.0}, Spelling{"Pa s", 1.0}};
constexpr std::array kFractions{Spelling{"%", 0.01}};

UnitRow row(Unit unit) {
  switch (unit) {
    case Unit::none: return {"", 1.0, {}};
    case Unit::metre: return {"m", 1.0, kLengths};
    case Unit::metre_per_second: return {"m/s", 1.0, kSpeeds};
    case Unit::metre_per_second2: return {"m/s2", 1.0, kAccelerations};
    case Unit::second: return {"s", 1.0, kTimes};
    case Unit::degree: return {"deg", kDegree, kAngles};
    case Unit::mil: return {"mil", kTwoPi / 6400.0, kAngles};
    case Unit::per_second: return {"1/s", 1.0, kRates};
    case Unit::per_metre: return {"per m, m2 or m3", 1.0, {}};
    case Unit::revolution_per_second: return {"rev/s", kTwoPi, kSpins};
    case Unit::degree_per_second: return {"deg/s", kDegree, kSpins};
    case Unit::kelvin: return {"K", 1.0, kTemperatures};
    case Unit::fraction: return {"", 1.0, kFractions};
    case Unit::kilogram_per_metre3: return {"kg/m3", 1.0, kDensities};
    case Unit::kilopascal_second: return {"kPa s", 1000.0, kImpulses};
    case Unit::particle: return {"particles", 1.0, {}};
  }
  return {"", 1.0, {}};
}

}  // namespace

std::string_view symbol(Unit unit) { return row(unit).symbol; }

double toSi(Unit unit, double value) { return value * row(unit).to_si; }

double toUnit(Unit unit, double si) {
  const double factor = row(unit).to_si;
  if (factor == 1.0) return si;
  const double rough = si / factor;
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, rough, std::chars_format::general, 15).ptr;
  double rounded = 0.0;
  std::from_chars(text, end, rounded);
  if (rounded * factor == si) return rounded;
  double below = rough, above = rough;
  for (int step = 0; step < 4; ++step) {
    if (below * factor == si) return below;
    if (above * factor == si) return above;
    below = std::nextafter(below, -INFINITY);
    above = std::nextafter(above, INFINITY);
  }
  return rough;
}

Expected<double> parseQuantity(std::string_view text, Unit unit) {
  const std::string_view whole = trimmed(text);
  std::string_view body = whole;
  if (body.starts_with('+')) body.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error != std::errc() || !std::isfinite(number))
    return fail(ErrorKind::usage, "\"" + std::string(whole) + "\" is not a finite number.");
  const std::string_view suffix = trimmed(body.substr(static_cast<std::size_t>(end - body.data())));
  if (suffix.empty()) return toSi(unit, number);

  const UnitRow unit_row = row(unit);
  for (const Spelling& spelling : unit_row.spellings)
    if (suffix == spelling.name) return number * spelling.to_si;
  const auto names = namesOf(unit_row.spellings, &Spelling::name);
  if (names.empty()) return fail(ErrorKind::usage, "\"" + std::string(whole) + "\" carries a unit, but this is a plain number.");
  return fail(ErrorKind::usage, "\"" + std::string(suffix) + "\" is not a unit for this value; units are " + listed(names) + ".");
}

std::string shortest(double value) {
  char text[64];
  // 4000000, not 4e+06: people read these.
  const double size = std::fabs(value);
  const bool plain = size >= 1e-4 && size < 1e15;
  const auto result = plain ? std::to_chars(text, text + sizeof text, value, std::chars_format::fixed) : std::to_chars(text, text + sizeof text, value);
  return std::string(text, result.ptr);
}

std::string quantity(double si, Unit unit) {
  std::string out = shortest(toUnit(unit, si));
  if (!symbol(unit).empty()) out += ' ' + std::string(symbol(unit));
  return out;
}

}  // namespace npsee
