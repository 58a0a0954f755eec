#include "sim/observer/sensing.h"
#include "sim/world/vehicle_state.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

/// A follower brakes later than the vehicle ahead by up to this, s.
constexpr double kLate_s = 0.6;
/// Places tried for each vehicle of a group, and how many of them must keep apart from the vehicles before it.
constexpr std::uint32_t kTries = 500, kTriesApart = 50;

std::string shownPlace(const Place& place) { return "(" + shortest(place.x_m) + ", " + shortest(place.z_m) + ")"; }

tl::unexpected<Error> refused(std::string what, std::string remedy, std::string pointer) {
  return fail(ErrorKind::input, {.what = std::move(what), .remedy = std::move(remedy), .file = {}, .line = 0, .pointer = std::move(pointer)});
}

Expected<const VehicleType*> typeOf(const std::vector<VehicleType>& types, int index, const std::string& pointer) {
  const auto found = std::find_if(types.begin(), types.end(), [&](const VehicleType& type) { return type.index == index; });
  if (found == types.end()) return refused("There is no vehicle type " + std::to_string(index) + ".", "Use one of the shipped types, or add it to vehicle_types.", pointer + "/type");
  return &*found;
}

Expected<void> checkPlace(const Passable& passable, const VehicleType& type, const Place& place, const std::string& who, const std::string& pointer) {
  const Medium medium = mediumOf(type.target_class);
  if (!passable.terrain().inside(place.x_m, place.z_m))
    return refused(who + " stands at " + shownPlace(place) + ", outside the world.", "The world reaches from (0, 0) to " + shownPlace({passable.terrain().sizeX(), passable.terrain().sizeZ()}) + ".", pointer);
  if (passable.allowed(medium, place.x_m, place.z_m)) return {};
  if (medium == Medium::water) return refused(who + " floats at " + shownPlace(place) + ", which is land.", "Move it into the sea.", pointer);
  return refused(who + " stands at " + shownPlace(place) + ", in the sea.", "Move it to land, or lower the sea level.", pointer);
}

}  // namespace

void Vehicles::State::addVehicle(const std::string& id, const VehicleType& type, const VehicleSetup& setup) {
  Driver driver;
  driver.medium = mediumOf(type.target_class);
  driver.behaviour = setup.behaviour;
  driver.reaction = setup.reaction;
  driver.greatest_mps = std::max(0.0, type.speed_mps);
  driver.wished_mps = std::clamp(setup.speed_mps, 0.0, driver.greatest_mps);
  driver.turn_radps = std::max(0.02, type.turn_radps);
  driver.goals = setup.goals;
  driver.repeat = setup.repeat_goals;
  driver.gap_m = std::max(1.0, setup.gap_m);
  driver.radius_m = 0.5 * std::sqrt(type.length_m * type.length_m + type.width_m * type.width_m);
  // Those that drive by themselves are already under way.
  const bool moves = setup.behaviour == Behaviour::straight || setup.behaviour == Behaviour::meander || (setup.behaviour == Behaviour::goals && !setup.goals.empty());
  const double speed_now = moves ? driver.wished_mps : 0.0;
  driver.leg = {0.0, setup.at.x_m, setup.at.z_m, wrapped(setup.heading_rad), speed_now, 0.0, 0.0};
  x.push_back(setup.at.x_m);
  z.push_back(setup.at.z_m);
  speed.push_back(speed_now);
  heading.push_back(driver.leg.heading_rad);
  VehicleRecord& record = records->emplace_back();
  record.id = id;
  record.type = type;
  record.track.add(driver.leg);
  drivers.push_back(std::move(driver));
}

bool Vehicles::State::occupied(const Place& place, const VehicleType& type) const {
  const double radius = 0.5 * std::sqrt(type.length_m * type.length_m + type.width_m * type.width_m);
  for (std::size_t v = 0; v < drivers.size(); ++v) {
    const double dx = x[v] - place.x_m, dz = z[v] - place.z_m, apart = radius + drivers[v].radius_m + kBetween_m;
    if (dx * dx + dz * dz < apart * apart) return true;
  }
  return false;
}

Expected<void> Vehicles::State::addGroup(const Scenario& scenario, std::size_t group, const VehicleType& type) {
  const VehicleGroup& setup = scenario.groups[group];
  const Medium medium = mediumOf(type.target_class);
  const auto between = [](double a, double b, double share) { return std::min(a, b) + share * std::max(a - b, b - a); };
  for (int i = 0; i < setup.count; ++i) {
    const auto entity = static_cast<std::uint32_t>(drivers.size());
    VehicleSetup vehicle;
    vehicle.behaviour = setup.behaviour;
    vehicle.reaction = setup.reaction;
    bool placed = false;
    for (std::uint32_t attempt = 0; attempt < kTries && !placed; ++attempt) {
      const auto u = observer::uniforms(scenario.seed, entity, observer::Purpose::placement, attempt);
      vehicle.at = {between(setup.from.x_m, setup.to.x_m, u[0]), between(setup.from.z_m, setup.to.z_m, u[1])};
      vehicle.heading_rad = kTwoPi * u[2];
      vehicle.speed_mps = between(setup.speed_min_mps, setup.speed_max_mps, u[3]);
      // In the last tries any land will do, steep or narrow.
      placed = attempt < kTries / 2 ? passable.good(medium, vehicle.at.x_m, vehicle.at.z_m) : passable.allowed(medium, vehicle.at.x_m, vehicle.at.z_m);
      if (attempt < kTriesApart) placed = placed && !occupied(vehicle.at, type);
    }
    if (!placed)
      return refused("Group " + setup.id + " finds no " + (medium == Medium::water ? "water" : "land") + " between " + shownPlace(setup.from) + " and " + shownPlace(setup.to) + ".",
                     "Choose another area, or lower the sea level.", "/groups/" + std::to_string(group) + "/from");
    addVehicle(setup.id + "-" + std::to_string(i + 1), type, vehicle);
  }
  return {};
}

Expected<void> Vehicles::State::fill(const Scenario& scenario) {
  const std::vector<VehicleType> types = vehicleTypes(scenario);
  Error faults;
  const auto keep = [&](Error&& error) { faults.faults.insert(faults.faults.end(), error.faults.begin(), error.faults.end()); };
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const VehicleSetup& setup = scenario.vehicles[i];
    const std::string pointer = "/vehicles/" + std::to_string(i);
    const auto type = typeOf(types, setup.type, pointer);
    if (!type) return tl::unexpected<Error>(type.error());
    if (auto checked = checkPlace(passable, **type, setup.at, "Vehicle " + setup.id, pointer + "/pos"); !checked) keep(std::move(checked.error()));
    addVehicle(setup.id, **type, setup);
  }
  for (std::size_t i = 0; i < scenario.groups.size(); ++i) {
    const auto type = typeOf(types, scenario.groups[i].type, "/groups/" + std::to_string(i));
    if (!type) return tl::unexpected<Error>(type.error());
    if (auto added = addGroup(scenario, i, **type); !added) keep(std::move(added.error()));
  }
  for (std::size_t i = 0; i < scenario.observers.size(); ++i) {
    const ObserverSetup& setup = scenario.observers[i];
    if (!setup.vehicle.empty()) continue;
    const std::string pointer = "/observers/" + std::to_string(i);
    const auto type = typeOf(types, setup.type, pointer);
    if (!type) return tl::unexpected<Error>(type.error());
    if (auto checked = checkPlace(passable, **type, setup.at, "Observer " + setup.id, pointer + "/pos"); !checked) keep(std::move(checked.error()));
    VehicleSetup carrier;
    carrier.at = setup.at;
    addVehicle(setup.id + "-vehicle", **type, carrier);
  }
  if (!faults.faults.empty()) return tl::unexpected<Error>(std::move(faults));
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const auto leader = std::find_if(records->begin(), records->end(), [&](const VehicleRecord& record) { return record.id == scenario.vehicles[i].follows; });
    if (scenario.vehicles[i].behaviour != Behaviour::follow || leader == records->end()) continue;
    drivers[i].leader = static_cast<int>(leader - records->begin());
    // However small a gap is asked for, they do not drive into one another: who follows sees the brake lights a moment later.
    drivers[i].gap_m = std::max(drivers[i].gap_m, apart(i, static_cast<std::size_t>(drivers[i].leader)) + kLate_s * drivers[i].greatest_mps);
  }
  return {};
}

Expected<Vehicles> Vehicles::make(const Scenario& scenario, const Terrain& terrain, std::vector<VehicleRecord>& records) {
  auto state = std::make_unique<State>(terrain, scenario.seed);
  records.clear();
  state->records = &records;
  if (auto filled = state->fill(scenario); !filled) return tl::unexpected<Error>(std::move(filled.error()));
  return Vehicles(std::move(state));
}

}  // namespace npsee::world
