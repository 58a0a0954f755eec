#pragma once

#include <npsee/scenario.h>

#include <array>
#include <cstdint>
#include <string>

namespace npsee::observer {

/// Evidence about a contact on the frame {hostile, friendly}: masses of hostile, friendly and the whole frame; they sum to 1.
struct Evidence {
  double hostile = 0.0, friendly = 0.0, unknown = 1.0;
  friend bool operator==(const Evidence&, const Evidence&) = default;
};
struct Combined {
  Evidence evidence;
  double conflict = 0.0;
  bool undecided = false;  ///< total conflict: the evidence is then that nothing is known
};
/// Dempster's rule of combination (Shafer 1976).
Combined combine(const Evidence& a, const Evidence& b);

/// Belief by range: b = bmax - (bmax - bmin) ln(R / Rn) / ln(Rf / Rn), clamped (world.md section 2).
double beliefAt(const Sensing& sensing, double range_m);

/// Greatest distance at which a target of the contrast is seen: C0 exp(-3.912 R / V) = threshold.
double fogRange(const Sensing& sensing, const Weather& weather);
/// Whether fog and night allow sight over this distance.
bool visibleThrough(const Sensing& sensing, const Weather& weather, double range_m, double max_range_m);

/// Purposes of random draws in a mission: written into what every mission looks like, never renumber, only add.
enum class Purpose : std::uint32_t {
  location = 0, own_location = 1, spotting = 2, dispersion = 3, lay_error = 4, message = 5, behaviour = 6, placement = 7, damage = 8,
  burst = 9, sensing = 10, shot = 11,
};
/// Two standard normal draws / four uniform ones of entity `entity` and purpose, number `count`. Philox underneath.
struct Normals { double a = 0.0, b = 0.0; };
Normals normals(std::int64_t seed, std::uint32_t entity, Purpose purpose, std::uint32_t count);
std::array<double, 4> uniforms(std::int64_t seed, std::uint32_t entity, Purpose purpose, std::uint32_t count);
/// Standard deviation on each axis of a circular normal error with this circular error probable.
inline double sigmaOfCep(double cep_m) { return cep_m / 1.1774100225154747; }

/// What a misheard message does to a correction: lost, left for right, or two digits swapped.
struct Misheard { bool lost = false; double right_m = 0.0, add_m = 0.0; bool changed = false; std::string how; };
Misheard mishear(const FdcSetup& fdc, std::int64_t seed, std::uint32_t mission, std::uint32_t count, double right_m, double add_m);

}  // namespace npsee::observer
