#pragma once

#include <npsee/projectile.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace npsee::ballistics {

/// A unit that may be written for a constant, with its factor to SI.
struct UnitName {
  std::string_view name;
  double to_si;
};

/// One constant of a projectile: the one place that knows its key, range and meaning. Files, `--set`, validation and the
/// written form all read this table.
struct ConstantRow {
  std::string_view key;
  std::span<const UnitName> units;  ///< the first is the one files are written in
  double Projectile::* member;
  double min, max;                  ///< SI
  bool required;
  std::string_view doc;
};
std::span<const ConstantRow> constantRows();

/// A fitting factor.
struct FactorRow {
  std::string_view key;
  double Factors::* member;
  std::vector<double> FactorCurves::* curve;
  std::string_view doc;
};
std::span<const FactorRow> factorRows();

inline constexpr double kMaxMuzzleSpeed_mps = 10000.0;
inline constexpr std::size_t kMaxKnots = 2000, kMaxPieces = 64, kMaxPowers = 12, kMaxCharges = 64;
inline constexpr double kMaxMach = 100.0, kMaxCoefficient = 1e4;

/// What is wrong with a number of a table row ("" = nothing).
std::string constantFault(const ConstantRow& row, double si);

/// "43.5 kg" as number and unit; nothing where it does not begin with a finite number.
std::optional<std::pair<double, std::string_view>> parseLeadingNumber(std::string_view text);
/// Factor to SI of a unit of the row ("" = the row's own); nothing where the row has no such unit.
std::optional<double> unitFactor(const ConstantRow& row, std::string_view unit);
/// "\"furlong\" is not a unit of mass; units are kg, g and lb."
std::string unknownUnit(const ConstantRow& row, std::string_view unit);

}  // namespace npsee::ballistics
