#include "sim/observer/sensing.h"
#include "sim/world/vehicles.h"

#include <algorithm>
#include <array>

namespace npsee::world {
namespace {

/// Share of its full effect that a weapon made against one class (row, as in weapons.dat) has on each class (column): heavy armour, light armour,
/// wheeled, personnel, aircraft, watercraft. Game values, nothing operational.
constexpr std::array<std::array<double, 6>, 7> kEffect{{
    {1.0, 1.0, 1.0, 1.0, 1.0, 1.0},    // any
    {1.0, 1.0, 1.0, 1.0, 0.6, 0.8},    // heavy armor
    {0.15, 1.0, 1.0, 1.0, 0.7, 0.6},   // light armor
    {0.05, 0.4, 1.0, 1.0, 0.7, 0.5},   // wheeled vehicle
    {0.02, 0.1, 0.5, 1.0, 0.4, 0.2},   // personnel
    {0.3, 0.6, 0.8, 0.8, 1.0, 0.5},    // aircraft
    {0.5, 0.8, 0.9, 0.9, 0.6, 1.0},    // watercraft
}};

/// The rest of the game values.
constexpr struct {
  double at_kill_radius = 0.6;     ///< of the hull, just outside the inner volume; falls evenly to
  double at_damage_radius = 0.1;   ///< at the outer volume's edge
  double scatter = 0.3;            ///< harm varies by this share either way
  double mobility_per_harm = 0.9;  ///< chance that a harm of 1 costs mobility, and
  double firepower_per_harm = 0.6; ///< firepower
  double lame_from = 0.6;          ///< hull from which it moves no more, and
  double silent_from = 0.8;        ///< shoots no more, whatever the draws
} kGame;

}  // namespace

DamageStep harmed(const Weapon& weapon, TargetClass target, double miss_m, const DamageStep& earlier, std::int64_t seed, std::uint32_t vehicle, std::uint32_t count, double time_s) {
  DamageStep now = earlier;
  now.t_s = time_s;
  const double inner = std::max(0, weapon.kill_radius_m), outer = std::max<double>(inner, weapon.damage_radius_m);
  if (!(miss_m <= outer) || earlier.hull >= 1.0) return now;
  const double effect = kEffect[static_cast<std::size_t>(weapon.target)][static_cast<std::size_t>(target)];
  const auto u = observer::uniforms(seed, vehicle, observer::Purpose::damage, count);
  double harm = effect;
  if (miss_m > inner) {
    const double share = (miss_m - inner) / (outer - inner);
    harm *= (kGame.at_kill_radius + share * (kGame.at_damage_radius - kGame.at_kill_radius)) * (1.0 + kGame.scatter * (2.0 * u[0] - 1.0));
  }
  now.hull = std::min(1.0, earlier.hull + harm);
  if (u[1] < kGame.mobility_per_harm * harm || now.hull >= kGame.lame_from) now.mobility = false;
  if (u[2] < kGame.firepower_per_harm * harm || now.hull >= kGame.silent_from) now.firepower = false;
  return now;
}

}  // namespace npsee::world
