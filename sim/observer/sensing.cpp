#include "sim/observer/sensing.h"

#include "sim/core/elementary.h"
#include "sim/core/random.h"

#include <npsee/units.h>

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace npsee::observer {
namespace {

/// Evidence that leaves less than this to agree on is in total conflict: the quotient would only magnify rounding.
constexpr double kLeastAgreement = 1e-12;

/// -ln 0.02: contrast falls exponentially with distance, and the meteorological visibility is where 2 % are left.
/// Source: Koschmieder 1924, Theorie der horizontalen Sichtweite.
constexpr double kKoschmieder = 3.912;

/// Keeps a mission's draws apart from those of particles, whose last counter word is a layer's stream.
constexpr std::uint32_t kMissionStream = 0x6d697373;  // "miss"

double nightContrast(const Weather& weather) { return weather.night ? weather.night_contrast : 1.0; }
double nightRange(const Weather& weather) { return weather.night ? weather.night_range : 1.0; }

/// `value_m`, a whole number of metres, with two neighbouring digits swapped; the draw picks the pair. The same value where no
/// swap changes it or all would make it begin with a zero, which nobody says.
double withSwappedDigits(double value_m, double draw) {
  const double size = std::floor(std::fabs(value_m) + 0.5);
  if (!(size < 1e9)) return value_m;
  std::string digits = std::to_string(static_cast<long long>(size));
  std::vector<std::size_t> pairs;
  for (std::size_t i = 0; i + 1 < digits.size(); ++i)
    if (digits[i] != digits[i + 1] && (i > 0 || digits[1] != '0')) pairs.push_back(i);
  if (pairs.empty()) return value_m;
  const std::size_t pair = pairs[std::min(pairs.size() - 1, static_cast<std::size_t>(draw * static_cast<double>(pairs.size())))];
  std::swap(digits[pair], digits[pair + 1]);
  return (value_m < 0.0 ? -1.0 : 1.0) * static_cast<double>(std::stoll(digits));
}

std::string sideways(double right_m) { return (right_m < 0.0 ? "left " : "right ") + shortest(std::fabs(right_m)); }
std::string along(double add_m) { return (add_m < 0.0 ? "drop " : "add ") + shortest(std::fabs(add_m)); }

}  // namespace

Combined combine(const Evidence& a, const Evidence& b) {
  Combined out;
  out.conflict = a.hostile * b.friendly + a.friendly * b.hostile;
  const double agreement = 1.0 - out.conflict;
  // Also where the masses are not numbers: nothing is known then.
  if (!(agreement > kLeastAgreement)) {
    out.conflict = 1.0;
    out.undecided = true;
    return out;
  }
  out.evidence.hostile = (a.hostile * b.hostile + a.hostile * b.unknown + a.unknown * b.hostile) / agreement;
  out.evidence.friendly = (a.friendly * b.friendly + a.friendly * b.unknown + a.unknown * b.friendly) / agreement;
  out.evidence.unknown = a.unknown * b.unknown / agreement;
  return out;
}

double beliefAt(const Sensing& sensing, double range_m) {
  if (!sensing.limited_belief) return 1.0;
  if (!(range_m > sensing.near_m) || !(sensing.near_m > 0.0)) return sensing.belief_near;
  if (range_m >= sensing.far_m) return sensing.belief_far;
  const double share = logarithm(range_m / sensing.near_m) / logarithm(sensing.far_m / sensing.near_m);
  return sensing.belief_near - (sensing.belief_near - sensing.belief_far) * share;
}

double fogRange(const Sensing& sensing, const Weather& weather) {
  const double contrast = sensing.contrast * nightContrast(weather);
  if (!(contrast > sensing.contrast_threshold) || !(weather.visibility_m > 0.0)) return 0.0;
  // A threshold of nothing is met at any distance; a number that no world reaches stands for it.
  if (!(sensing.contrast_threshold > 1e-9)) return 1e9;
  return weather.visibility_m * logarithm(contrast / sensing.contrast_threshold) / kKoschmieder;
}

bool visibleThrough(const Sensing& sensing, const Weather& weather, double range_m, double max_range_m) {
  if (!(range_m <= max_range_m * nightRange(weather))) return false;
  return !sensing.fog || range_m <= fogRange(sensing, weather);
}

std::array<double, 4> uniforms(std::int64_t seed, std::uint32_t entity, Purpose purpose, std::uint32_t count) {
  const r123::Philox4x32::ctr_type counter{{entity, count, static_cast<std::uint32_t>(purpose), kMissionStream}};
  const auto bits64 = static_cast<std::uint64_t>(seed);
  const r123::Philox4x32::key_type key{{static_cast<std::uint32_t>(bits64), static_cast<std::uint32_t>(bits64 >> 32)}};
  const auto bits = r123::Philox4x32()(counter, key);
  std::array<double, 4> out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = (static_cast<double>(bits[i]) + 0.5) * 0x1p-32;
  return out;
}

Normals normals(std::int64_t seed, std::uint32_t entity, Purpose purpose, std::uint32_t count) {
  const auto u = uniforms(seed, entity, purpose, count);
  return {inverseNormal(u[0]), inverseNormal(u[1])};
}

Misheard mishear(const FdcSetup& fdc, std::int64_t seed, std::uint32_t mission, std::uint32_t count, double right_m, double add_m) {
  Misheard out{false, right_m, add_m, false, {}};
  if (!(fdc.misunderstanding > 0.0)) return out;
  const auto u = uniforms(seed, mission, Purpose::message, count);
  if (!(u[0] < fdc.misunderstanding) || u[1] < fdc.read_back) return out;
  out.changed = true;
  if (u[2] < 1.0 / 3.0) {
    out.lost = true;
    out.how = "the message was lost";
    return out;
  }
  if (u[2] < 2.0 / 3.0 && right_m != 0.0) {
    out.right_m = -right_m;
    out.how = "heard \"" + sideways(out.right_m) + "\" instead of \"" + sideways(right_m) + "\"";
    return out;
  }
  // One of the two numbers, by the last draw; the other where that one has no digits to swap.
  const bool first = u[3] < 0.5;
  const double draw = first ? 2.0 * u[3] : 2.0 * u[3] - 1.0;
  out.right_m = withSwappedDigits(right_m, draw);
  out.add_m = withSwappedDigits(add_m, draw);
  const bool right_changes = out.right_m != right_m, add_changes = out.add_m != add_m;
  if (right_changes && (first || !add_changes)) {
    out.add_m = add_m;
    out.how = "heard \"" + sideways(out.right_m) + "\" instead of \"" + sideways(right_m) + "\"";
  } else if (add_changes) {
    out.right_m = right_m;
    out.how = "heard \"" + along(out.add_m) + "\" instead of \"" + along(add_m) + "\"";
  } else {
    out.lost = true;
    out.how = "the message was lost";
  }
  return out;
}

}  // namespace npsee::observer
