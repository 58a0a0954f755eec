#pragma once

#include <npsee/error.h>

#include <string>
#include <string_view>

namespace npsee {

inline constexpr double kPi = 3.14159265358979323846;
/// Radians of one degree.
inline constexpr double kDegree = kPi / 180.0;
inline constexpr double kTwoPi = 2.0 * kPi;

/// Standard acceleration of free fall, m/s^2. Source: 3rd CGPM, 1901.
inline constexpr double kStandardGravity_mps2 = 9.80665;

/// The unit a value is written in, in files and on the command line. Inside the program everything is SI and radians.
enum class Unit {
  none,
  metre,
  metre_per_second,
  metre_per_second2,
  second,
  degree,            ///< radians inside
  mil,               ///< 6400 to the circle; radians inside
  per_second,
  per_metre,
  revolution_per_second,  ///< rad/s inside
  degree_per_second,      ///< rad/s inside
  kelvin,
  fraction,
  kilogram_per_metre3,
  kilopascal_second,      ///< Pa s inside
  particle,
};

/// Symbol as shown to people ("m/s", "deg"); empty for plain numbers.
std::string_view symbol(Unit unit);

/// Converts a number written in `unit` to SI, and back. `toUnit(unit, toSi(unit, v)) == v` for every v with at most
/// 15 significant digits: of the values that map to the same SI number the shortest decimal one is returned.
double toSi(Unit unit, double value);
double toUnit(Unit unit, double si);

/// Parses "52", "52deg", "0.9 rad", "60 m/s", "216km/h", "12 cm" for a value whose file unit is `unit`; a bare number is
/// in `unit` itself. Returns SI. Error (usage) names the units that fit.
Expected<double> parseQuantity(std::string_view text, Unit unit);

/// Shortest decimal text that reads back as the same double ("0.1", not "0.10000000000000001").
std::string shortest(double value);

/// `si` in its file unit with the unit's symbol, e.g. "52 deg".
std::string quantity(double si, Unit unit);

}  // namespace npsee
