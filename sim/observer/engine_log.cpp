#include "sim/observer/engine.h"

#include "sim/ballistics/angles.h"

#include <cmath>

namespace npsee {

namespace observer {

double bearing(const Vec3& from, const Vec3& to) {
  const double angle = ballistics::angleOf(from.z - to.z, to.x - from.x);
  return angle < 0.0 ? angle + kTwoPi : angle;
}

double levelDistance(const Vec3& a, const Vec3& b) {
  const double dx = a.x - b.x, dz = a.z - b.z;
  return std::sqrt(dx * dx + dz * dz);
}

std::string_view methodName(FireMethod method) {
  switch (method) {
    case FireMethod::automatic: return "auto";
    case FireMethod::adjust_fire: return "adjust_fire";
    case FireMethod::fire_for_effect: return "fire_for_effect";
    case FireMethod::suppress: return "suppress";
    case FireMethod::immediate_suppression: return "immediate_suppression";
    case FireMethod::smoke: return "smoke";
    case FireMethod::illuminate: return "illuminate";
  }
  return "auto";
}

}  // namespace observer

MissionEvent& Mission::State::log(EventKind kind, double t_s) {
  MissionEvent& event = rec.events.emplace_back();
  event.t_s = t_s;
  event.kind = kind;
  return event;
}

const std::string& Mission::State::vehicleId(int vehicle) const {
  static const std::string none;
  return vehicle < 0 ? none : rec.vehicles[static_cast<std::size_t>(vehicle)].id;
}

const Weapon* Mission::State::weaponOf(int id) const { return weapons.find(std::to_string(id)); }

/// An error ends the mission: the log says why, and nothing after it is simulated.
void Mission::State::fail(const std::string& text) {
  log(EventKind::error, now_s).fields = {{"text", text}};
  failed = true;
}

Vec3 Mission::State::vehicleAt(int vehicle) const {
  const auto v = static_cast<std::size_t>(vehicle);
  const double x = vehicles->x()[v], z = vehicles->z()[v];
  return {x, rec.terrain.surface(x, z), z};
}

}  // namespace npsee
