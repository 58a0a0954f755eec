#pragma once

#include <npsee/error.h>

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// The aerodynamic coefficients of the modified point-mass model, all functions of the Mach number, non-dimensionalised with
/// the calibre d and with the spin as p d / V. Symbols and signs: docs/physics.md, "Exterior ballistics".
enum class Coefficient {
  cd0,    ///< zero-yaw drag
  cda2,   ///< drag by the square of the yaw, per rad^2
  cla,    ///< lift, per rad
  cla3,   ///< cubic lift, per rad^3
  cma,    ///< overturning moment, per rad
  cma3,   ///< cubic overturning moment, per rad^3
  cspin,  ///< spin damping moment (negative)
  cmagf,  ///< Magnus force (negative)
};
inline constexpr std::size_t kCoefficients = 8;
/// Key in files: "CD0", "CDa2", ...
std::string_view coefficientKey(Coefficient coefficient);

/// How a tabulated curve runs between its knots.
enum class Interpolation {
  linear,
  monotone,  ///< cubic without overshoot (PCHIP): Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238
};

/// One interval of a piecewise polynomial, the thesis's Physical_coefficient (eq. 3.16): a0 + a1 M + a2 M^2 + ... up to the
/// ceiling Mach number, from the ceiling of the piece before.
struct PolynomialPiece {
  double mach_to = 0.0;
  std::vector<double> a;
  friend bool operator==(const PolynomialPiece&, const PolynomialPiece&) = default;
};

/// A coefficient over the Mach number: tabulated, or polynomial by intervals, or zero where both are empty. Outside its
/// knots the end values hold.
struct CoefficientCurve {
  std::vector<double> mach, value;  ///< tabulated
  Interpolation interpolation = Interpolation::monotone;
  std::vector<PolynomialPiece> pieces;  ///< polynomial
  std::string source;

  bool empty() const { return mach.empty() && pieces.empty(); }  ///< Zero everywhere.
  double at(double mach_number) const;  ///< Its value at a Mach number of at least 0. Thread-safe.
  /// The curve that has one value everywhere.
  static CoefficientCurve constant(double value);
  friend bool operator==(const CoefficientCurve&, const CoefficientCurve&) = default;
};

using AeroTable = std::array<CoefficientCurve, kCoefficients>;

/// Fitting factors at one elevation: form factor i (drag), lift factor fL, Magnus factor QM, yaw drag factor QD. The thesis's
/// ballistic coefficient is C = m / (i d^2), its lift factor L is fL, its yaw factor Q is QD.
struct Factors {
  double form = 1.0, lift = 1.0, magnus = 1.0, yaw_drag = 1.0;
  friend bool operator==(const Factors&, const Factors&) = default;
};

/// Factors as polynomials in the quadrant elevation, c0 + c1 e + c2 e^2 + ... with e = QE / 1000 mil. Outside
/// [elevation_min, elevation_max], where nothing was fitted, the values at the ends hold. An empty list means 1.
struct FactorCurves {
  double elevation_min_rad = 0.0, elevation_max_rad = 0.0;
  std::vector<double> form, lift, magnus, yaw_drag;
  std::string source;

  Factors at(double elevation_rad) const;  ///< The factors at an elevation, rad. Thread-safe.
  friend bool operator==(const FactorCurves&, const FactorCurves&) = default;
};

struct Charge {
  std::string name;  ///< "3W"
  double speed_mps = 0.0;
  std::string status, source;
  FactorCurves factors;
  friend bool operator==(const Charge&, const Charge&) = default;
};

/// A shell or bullet: constants, coefficients, charges.
struct Projectile {
  std::string name, title, status, note;
  double mass_kg = 0.0;
  double diameter_m = 0.0;
  double inertia_kgm2 = 0.0;     ///< axial moment of inertia Ix; 0 where unknown: then spin is not damped and there is no yaw
  double twist_cal = 0.0;        ///< calibres per turn, right-hand positive; 0 = smooth bore
  bool left_hand = false;        ///< left-hand twist
  double valid_elevation_rad = 0.0;  ///< above this the modified point-mass model is not to be trusted; 0 = no limit given
  std::array<std::string, 5> constant_sources;  ///< of mass, diameter, inertia, twist, valid elevation
  AeroTable aero;
  std::vector<Charge> charges;
  std::vector<std::pair<std::string, std::string>> sources;  ///< key -> full reference

  const CoefficientCurve& curve(Coefficient c) const { return aero[static_cast<std::size_t>(c)]; }  ///< The curve of one coefficient.
  CoefficientCurve& curve(Coefficient c) { return aero[static_cast<std::size_t>(c)]; }  ///< The same, to be changed.
  friend bool operator==(const Projectile&, const Projectile&) = default;
};

/// Every fault of the value itself (zero mass, unsorted Mach numbers, ...). Pointers are those of a projectile file.
std::vector<Fault> validate(const Projectile& projectile);

/// Reads a projectile file. The error lists every fault with file, line and JSON pointer.
Expected<Projectile> parseProjectile(std::string_view text, std::string_view file);
Expected<Projectile> loadProjectile(const std::filesystem::path& path);
/// The file's text; `parseProjectile(projectileText(p), "") == p`.
std::string projectileText(const Projectile& projectile);

/// Reads a bare coefficient table `{"M": [...], "CD0": [...], ...}`. `drag_only` needs no other columns; else only the cubic
/// ones may be missing. Error kind input.
Expected<AeroTable> parseAeroTable(std::string_view text, std::string_view file, Interpolation interpolation, bool drag_only = false);

/// Names of the projectiles that are built in from assets/projectiles, in order.
std::vector<std::string_view> shippedProjectiles();
/// A shipped projectile by its name, or one from a file when `choice` has a dot or a slash in it. Error kind usage names the
/// nearest shipped one.
Expected<Projectile> findProjectile(std::string_view choice);

/// Charge by name; error kind usage lists those there are.
Expected<Charge> findCharge(const Projectile& projectile, std::string_view name);

/// The constants that `--set` and the options of the command line can change, one row each.
struct ProjectileSetting {
  std::string_view key, unit, doc;
};
std::span<const ProjectileSetting> projectileSettings();  ///< All of them, in the order of the reference. Static; thread-safe.

/// Sets one constant (`KEY=VALUE`; keys of projectileSettings). A factor goes into `factors`, which so says whether one was set: those set by hand
/// replace all fitted ones, for they belong together. Error kind usage; nothing is changed then.
Expected<void> applyProjectileSetting(Projectile& projectile, std::optional<Factors>& factors, std::string_view expression);

}  // namespace npsee
