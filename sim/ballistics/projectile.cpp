#include "sim/ballistics/projectile_rows.h"

#include "sim/ballistics/curve.h"
#include "sim/core/text.h"

#include <npsee/units.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace npsee {
namespace ballistics {
namespace {

constexpr UnitName kMasses[] = {{"kg", 1.0}, {"g", 1e-3}, {"lb", 0.45359237}};
constexpr UnitName kLengths[] = {{"m", 1.0}, {"mm", 1e-3}, {"in", 0.0254}};
constexpr UnitName kInertias[] = {{"kg m2", 1.0}, {"kgm2", 1.0}};
constexpr UnitName kTwists[] = {{"cal/turn", 1.0}, {"cal", 1.0}};
constexpr UnitName kElevations[] = {{"mil", kTwoPi / 6400.0}, {"deg", kPi / 180.0}, {"rad", 1.0}};

}  // namespace

std::span<const ConstantRow> constantRows() {
  static const ConstantRow rows[] = {
      {"mass", kMasses, &Projectile::mass_kg, 1e-5, 1e5, true, "The mass, above zero."},
      {"diameter", kLengths, &Projectile::diameter_m, 1e-4, 10.0, true, "Calibre, which also is the length the coefficients are made dimensionless with."},
      {"inertia", kInertias, &Projectile::inertia_kgm2, 0.0, 1e6, false, "Axial moment of inertia; 0 = unknown: no spin damping and no yaw of repose."},
      {"twist", kTwists, &Projectile::twist_cal, 0.0, 1000.0, false, "Calibres per turn of the rifling, never negative; 0 = smooth bore. Left-hand rifling is the option --left-hand."},
      {"valid_elevation", kElevations, &Projectile::valid_elevation_rad, 0.0, 0.5 * kPi, false, "Elevation above which the modified point-mass model is flagged as not valid; 0 = no limit."},
  };
  return rows;
}

std::span<const FactorRow> factorRows() {
  static const FactorRow rows[] = {
      {"form", &Factors::form, &FactorCurves::form, "Form factor i: multiplies the drag."},
      {"lift", &Factors::lift, &FactorCurves::lift, "Lift factor fL: multiplies the lift."},
      {"magnus", &Factors::magnus, &FactorCurves::magnus, "Magnus factor QM: multiplies the Magnus force."},
      {"yaw_drag", &Factors::yaw_drag, &FactorCurves::yaw_drag, "Yaw drag factor QD: multiplies the yaw in the drag by yaw."},
  };
  return rows;
}

std::string constantFault(const ConstantRow& row, double si) {
  // Also where it is not a number.
  if (si >= row.min && si <= row.max) return {};
  const UnitName& unit = row.units.front();
  return std::string(row.key) + " is " + shortest(si / unit.to_si) + ' ' + std::string(unit.name) + ", outside " + shortest(row.min / unit.to_si) + " to " +
         shortest(row.max / unit.to_si) + ' ' + std::string(unit.name) + '.';
}

std::optional<std::pair<double, std::string_view>> parseLeadingNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
  return std::pair(number, trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
}

std::optional<double> unitFactor(const ConstantRow& row, std::string_view unit) {
  if (unit.empty()) return row.units.front().to_si;
  for (const UnitName& known : row.units)
    if (known.name == unit) return known.to_si;
  return std::nullopt;
}

std::string unknownUnit(const ConstantRow& row, std::string_view unit) {
  const auto names = namesOf(row.units, &UnitName::name);
  return '"' + std::string(unit) + "\" is not a unit of " + std::string(row.key) + "; units are " + listed(names) + '.';
}

namespace {

class Checker {
 public:
  std::vector<Fault> faults;

  void constants(const Projectile& p) {
    for (const ConstantRow& row : constantRows())
      if (std::string wrong = constantFault(row, p.*row.member); !wrong.empty()) add("/constants/" + std::string(row.key) + "/value", std::move(wrong), std::string(row.doc));
  }

  void curve(const CoefficientCurve& curve, const std::string& at) {
    if (!curve.pieces.empty()) return polynomial(curve, at);
    if (curve.mach.size() != curve.value.size())
      return add(at, "there are " + std::to_string(curve.mach.size()) + " Mach numbers but " + std::to_string(curve.value.size()) + " values.", "Give one value for each Mach number.");
    if (curve.mach.size() > kMaxKnots) return add(at, "there are " + std::to_string(curve.mach.size()) + " knots, above the limit of " + std::to_string(kMaxKnots) + ".", "");
    for (std::size_t i = 0; i < curve.mach.size(); ++i) {
      if (!(curve.mach[i] >= 0.0 && curve.mach[i] <= kMaxMach)) add(at + "/mach/" + std::to_string(i), "the Mach number is " + shortest(curve.mach[i]) + ", outside 0 to " + shortest(kMaxMach) + ".", "");
      if (!(std::fabs(curve.value[i]) <= kMaxCoefficient)) add(at + "/value/" + std::to_string(i), "the coefficient is " + shortest(curve.value[i]) + ", beyond +-" + shortest(kMaxCoefficient) + ".", "");
      if (i > 0 && !(curve.mach[i] > curve.mach[i - 1]))
        add(at + "/mach/" + std::to_string(i), "Mach " + shortest(curve.mach[i]) + " follows " + shortest(curve.mach[i - 1]) + ", but Mach numbers must rise.", "Sort the rows by Mach number and leave out repeated ones.");
    }
  }

  void sign(const Projectile& p, Coefficient c, bool positive) {
    const CoefficientCurve& curve = p.curve(c);
    const std::string key(coefficientKey(c));
    for (std::size_t i = 0; i < curve.value.size(); ++i)
      if (positive ? !(curve.value[i] > 0.0) : curve.value[i] > 0.0)
        return add("/coefficients/" + key + "/value/" + std::to_string(i), key + " is " + shortest(curve.value[i]) + (positive ? ", but must be positive." : ", but must not be positive."),
                   positive ? "Leave the curve out where it is unknown." : "Its sign convention is in docs/physics.md: spin damping and the Magnus force are negative.");
  }

  void charges(const Projectile& p) {
    if (p.charges.size() > kMaxCharges) add("/charges", "there are " + std::to_string(p.charges.size()) + " charges, above the limit of " + std::to_string(kMaxCharges) + ".", "");
    for (std::size_t i = 0; i < p.charges.size(); ++i) {
      const Charge& charge = p.charges[i];
      const std::string at = "/charges/" + std::to_string(i);
      if (charge.name.empty()) add(at + "/name", "the charge has no name.", "Give it one, e.g. \"3W\".");
      for (std::size_t k = 0; k < i; ++k)
        if (p.charges[k].name == charge.name) add(at + "/name", "the name \"" + charge.name + "\" is taken by charge " + std::to_string(k) + ".", "Give each charge a name of its own.");
      if (!(charge.speed_mps > 0.0 && charge.speed_mps <= kMaxMuzzleSpeed_mps))
        add(at + "/muzzle_velocity", "the muzzle velocity is " + shortest(charge.speed_mps) + " m/s, outside 0 to " + shortest(kMaxMuzzleSpeed_mps) + " m/s.", "");
      factors(charge.factors, at + "/factors");
    }
  }

 private:
  void factors(const FactorCurves& f, const std::string& at) {
    if (!(f.elevation_min_rad >= -0.5 * kPi && f.elevation_max_rad <= 0.5 * kPi && f.elevation_min_rad <= f.elevation_max_rad))
      add(at + "/elevation_mil", "the elevations must rise and lie within -1600 to 1600 mil.", "");
    for (const FactorRow& row : factorRows()) {
      if ((f.*row.curve).size() > kMaxPowers) add(at + '/' + std::string(row.key), "there are more than " + std::to_string(kMaxPowers) + " powers.", "");
      for (const double c : f.*row.curve)
        if (!(std::fabs(c) <= 1000.0)) add(at + '/' + std::string(row.key), "the number " + shortest(c) + " is beyond +-1000.", "A factor is a polynomial in QE / 1000 mil.");
    }
  }

  void polynomial(const CoefficientCurve& curve, const std::string& at) {
    if (!curve.mach.empty()) add(at, "the curve is given twice, tabulated and as polynomials.", "Keep one.");
    if (curve.pieces.size() > kMaxPieces) return add(at, "there are " + std::to_string(curve.pieces.size()) + " pieces, above the limit of " + std::to_string(kMaxPieces) + ".", "");
    double before = 0.0;
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
      const PolynomialPiece& piece = curve.pieces[i];
      const std::string here = at + "/polynomial/" + std::to_string(i);
      if (!(piece.mach_to > before && piece.mach_to <= kMaxMach))
        add(here + "/mach_to", "the ceiling is Mach " + shortest(piece.mach_to) + " after " + shortest(before) + ", but ceilings must rise and stay below " + shortest(kMaxMach) + ".", "Sort the pieces by their ceilings.");
      before = piece.mach_to;
      if (piece.a.empty() || piece.a.size() > kMaxPowers) add(here + "/a", "a piece has 1 to " + std::to_string(kMaxPowers) + " coefficients.", "");
      for (const double a : piece.a)
        if (!(std::fabs(a) <= 1e9)) add(here + "/a", "the coefficient " + shortest(a) + " is beyond +-1e9.", "");
      for (const double m : {i > 0 ? curve.pieces[i - 1].mach_to : 0.0, piece.mach_to})
        if (!(std::fabs(polynomialAt(piece.a, m)) <= kMaxCoefficient)) add(here, "the polynomial is beyond +-" + shortest(kMaxCoefficient) + " at Mach " + shortest(m) + ".", "");
    }
  }

  void add(std::string pointer, std::string what, std::string remedy) {
    faults.push_back({.what = std::move(what), .remedy = std::move(remedy), .file = {}, .line = 0, .pointer = std::move(pointer)});
  }
};

double factorAt(const std::vector<double>& polynomial, double elevation_kilomil) { return polynomial.empty() ? 1.0 : polynomialAt(polynomial, elevation_kilomil); }

}  // namespace
}  // namespace ballistics

using namespace ballistics;

std::string_view coefficientKey(Coefficient coefficient) {
  static constexpr std::string_view keys[] = {"CD0", "CDa2", "CLa", "CLa3", "CMa", "CMa3", "Cspin", "Cmagf"};
  return keys[static_cast<std::size_t>(coefficient)];
}

Factors FactorCurves::at(double elevation_rad) const {
  const double e = std::clamp(elevation_rad, elevation_min_rad, elevation_max_rad) * (6.4 / kTwoPi);
  Factors out;
  for (const FactorRow& row : factorRows()) out.*row.member = factorAt(this->*row.curve, e);
  return out;
}

std::vector<Fault> validate(const Projectile& projectile) {
  Checker checker;
  checker.constants(projectile);
  for (std::size_t c = 0; c < kCoefficients; ++c) {
    const CoefficientCurve& curve = projectile.aero[c];
    if (!curve.empty()) checker.curve(curve, "/coefficients/" + std::string(coefficientKey(static_cast<Coefficient>(c))));
  }
  checker.sign(projectile, Coefficient::cma, true);
  checker.sign(projectile, Coefficient::cspin, false);
  checker.charges(projectile);
  return std::move(checker.faults);
}

Expected<Charge> findCharge(const Projectile& projectile, std::string_view name) {
  for (const Charge& charge : projectile.charges)
    if (charge.name == name) return charge;
  const auto names = namesOf(projectile.charges, &Charge::name);
  const std::string what = "the projectile " + projectile.name + " has no charge \"" + std::string(name) + "\".";
  if (names.empty()) return fail(ErrorKind::usage, what, "It has none at all; give the muzzle velocity with --v0.");
  return fail(ErrorKind::usage, what, "It has " + listed(names) + "; --v0 gives any other muzzle velocity.");
}

std::span<const ProjectileSetting> projectileSettings() {
  static const std::vector<ProjectileSetting> settings = [] {
    std::vector<ProjectileSetting> out;
    for (const ConstantRow& row : constantRows()) out.push_back({row.key, row.units.front().name, row.doc});
    for (const FactorRow& row : factorRows()) out.push_back({row.key, "", row.doc});
    return out;
  }();
  return settings;
}

Expected<void> applyProjectileSetting(Projectile& projectile, std::optional<Factors>& factors, std::string_view expression) {
  const std::size_t equals = expression.find('=');
  const std::string text(expression);
  if (equals == std::string_view::npos || equals == 0 || equals + 1 == expression.size())
    return fail(ErrorKind::usage, "--set " + text + ": not of the form KEY=VALUE.", "For example --set mass=43.5.");
  const std::string_view key = trimmed(expression.substr(0, equals)), value = trimmed(expression.substr(equals + 1));
  const auto number = parseLeadingNumber(value);
  for (const FactorRow& row : factorRows()) {
    if (key != row.key) continue;
    if (!number || !number->second.empty()) return fail(ErrorKind::usage, "--set " + text + ": \"" + std::string(value) + "\" is not a finite number.");
    if (!factors) factors.emplace();
    (*factors).*row.member = number->first;
    return {};
  }
  std::vector<std::string_view> keys;
  for (const ProjectileSetting& setting : projectileSettings()) keys.push_back(setting.key);
  for (const ConstantRow& row : constantRows()) {
    if (key != row.key) continue;
    if (!number) return fail(ErrorKind::usage, "--set " + text + ": \"" + std::string(value) + "\" is not a finite number.");
    const auto factor = unitFactor(row, number->second);
    if (!factor) return fail(ErrorKind::usage, "--set " + text + ": " + unknownUnit(row, number->second));
    const double si = number->first * *factor;
    if (std::string wrong = constantFault(row, si); !wrong.empty()) return fail(ErrorKind::usage, "--set " + text + ": " + wrong, std::string(row.doc));
    projectile.*row.member = si;
    return {};
  }
  const auto near = nearest(key, keys);
  return fail(ErrorKind::usage, "--set " + text + ": a projectile has no \"" + std::string(key) + "\".",
              near ? "Did you mean " + std::string(*near) + "?" : "There are " + listed(keys) + ".");
}

}  // namespace npsee
