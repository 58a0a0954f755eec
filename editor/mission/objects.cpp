#include "editor/mission/objects.h"

#include "sim/world/scenario_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;

template <class List>
auto* named(List& list, std::string_view id) {
  const auto found = std::ranges::find_if(list, [&](const auto& one) { return one.id == id; });
  return found == list.end() ? nullptr : &*found;
}

const world::Struct* tableOf(Kind kind) {
  constexpr std::array<std::string_view, 6> kLists{"", "vehicles", "groups", "batteries", "guns", "observers"};
  const world::Struct& mission = world::missionTable();
  if (kind == Kind::mission) return &mission;
  if (kind == Kind::gun) return mission.find("batteries")->child->find("guns")->child;
  return mission.find(kLists[static_cast<std::size_t>(kind)])->child;
}

GunSetup* findGun(Scenario& scenario, std::string_view id, BatterySetup** battery = nullptr) {
  for (BatterySetup& one : scenario.batteries)
    if (GunSetup* gun = named(one.guns, id)) {
      if (battery != nullptr) *battery = &one;
      return gun;
    }
  return nullptr;
}

void* find(Scenario& scenario, const ObjectRef& ref) {
  switch (ref.kind) {
    case Kind::mission: return &scenario;
    case Kind::vehicle: return named(scenario.vehicles, ref.id);
    case Kind::group: return named(scenario.groups, ref.id);
    case Kind::battery: return named(scenario.batteries, ref.id);
    case Kind::gun: return findGun(scenario, ref.id);
    case Kind::observer: return named(scenario.observers, ref.id);
  }
  return nullptr;
}

/// Every place of the scenario that moves with the object.
std::vector<Place*> placesOf(Scenario& scenario, const ObjectRef& ref) {
  std::vector<Place*> out;
  void* const object = find(scenario, ref);
  if (object == nullptr) return out;
  switch (ref.kind) {
    case Kind::mission: break;
    case Kind::vehicle: out.push_back(&static_cast<VehicleSetup*>(object)->at); break;
    case Kind::gun: out.push_back(&static_cast<GunSetup*>(object)->at); break;
    case Kind::group: {
      auto* const group = static_cast<VehicleGroup*>(object);
      out = {&group->from, &group->to};
      break;
    }
    case Kind::battery:
      for (GunSetup& gun : static_cast<BatterySetup*>(object)->guns) out.push_back(&gun.at);
      break;
    case Kind::observer: {
      auto* const observer = static_cast<ObserverSetup*>(object);
      VehicleSetup* const carrier = observer->vehicle.empty() ? nullptr : named(scenario.vehicles, observer->vehicle);
      out.push_back(&observer->at);
      if (carrier != nullptr) out.push_back(&carrier->at);
      break;
    }
  }
  return out;
}

Place clamped(const Scenario& scenario, const Place& place) {
  return {std::clamp(place.x_m, 0.0, scenario.world.size_x_m), std::clamp(place.z_m, 0.0, scenario.world.size_z_m)};
}

}  // namespace

std::string_view kindName(Kind kind) {
  constexpr std::array<std::string_view, 6> kNames{"mission", "vehicle", "group", "battery", "gun", "observer"};
  return kNames[static_cast<std::size_t>(kind)];
}

TablePart partOf(Scenario& scenario, const ObjectRef& ref) {
  void* const object = find(scenario, ref);
  return object == nullptr ? TablePart{} : TablePart{tableOf(ref.kind), object};
}

bool exists(const Scenario& scenario, const ObjectRef& ref) { return static_cast<bool>(partOf(scenario, ref)); }

std::optional<Place> placeOf(const Scenario& scenario, const ObjectRef& ref) {
  const auto places = placesOf(const_cast<Scenario&>(scenario), ref);
  if (places.empty()) return std::nullopt;
  // An observer's own place stands first; where he rides, the vehicle's counts.
  if (ref.kind == Kind::observer) return *places.back();
  Place mean;
  for (const Place* place : places) {
    mean.x_m += place->x_m / static_cast<double>(places.size());
    mean.z_m += place->z_m / static_cast<double>(places.size());
  }
  return mean;
}

void shift(Scenario& scenario, const ObjectRef& ref, double dx_m, double dz_m) {
  const auto places = placesOf(scenario, ref);
  // The step is cut once for all, so that a group or battery keeps its shape at the world's edge.
  for (const Place* place : places) {
    const Place to = clamped(scenario, {place->x_m + dx_m, place->z_m + dz_m});
    dx_m = to.x_m - place->x_m;
    dz_m = to.z_m - place->z_m;
  }
  for (Place* place : places) {
    place->x_m += dx_m;
    place->z_m += dz_m;
  }
}

std::vector<ObjectRef> ownersOf(const Recording& recording) {
  std::vector<ObjectRef> out;
  for (const VehicleRecord& vehicle : recording.vehicles) out.push_back({Kind::vehicle, vehicle.id});
  for (const ObserverRecord& observer : recording.observers)
    // A vehicle of its own in the mission is selected as itself, even where it carries somebody.
    if (observer.vehicle >= 0 && observer.vehicle < static_cast<int>(out.size()) && named(recording.scenario.vehicles, out[static_cast<std::size_t>(observer.vehicle)].id) == nullptr)
      out[static_cast<std::size_t>(observer.vehicle)] = {Kind::observer, observer.id};
  return out;
}

ObjectRef editable(const Scenario& scenario, const ObjectRef& ref) {
  if (ref.kind != Kind::vehicle || named(scenario.vehicles, ref.id) != nullptr) return ref;
  // A vehicle of a group is called after it: "patrol-3".
  const std::string group = ref.id.substr(0, std::min(ref.id.rfind('-'), ref.id.size()));
  return named(scenario.groups, group) != nullptr ? ObjectRef{Kind::group, group} : ref;
}

int vehicleOf(const Recording& recording, const ObjectRef& ref) {
  if (ref.kind == Kind::vehicle) return recording.findVehicle(ref.id);
  const int observer = ref.kind == Kind::observer ? recording.findObserver(ref.id) : -1;
  return observer < 0 ? -1 : recording.observers[static_cast<std::size_t>(observer)].vehicle;
}

std::vector<std::string> allNames(const Scenario& scenario) {
  std::vector<std::string> out;
  for (const auto& one : scenario.vehicles) out.push_back(one.id);
  for (const auto& one : scenario.groups) out.push_back(one.id);
  for (const auto& one : scenario.observers) out.push_back(one.id);
  for (const auto& one : scenario.batteries) {
    out.push_back(one.id);
    for (const auto& gun : one.guns) out.push_back(gun.id);
  }
  return out;
}

std::string freeName(const Scenario& scenario, std::string_view like) {
  const auto names = allNames(scenario);
  const auto taken = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
  const std::size_t last = like.find_last_not_of("0123456789");
  const std::string stem(like.substr(0, last == std::string_view::npos ? 0 : last + 1));
  for (int i = 1;; ++i)
    if (std::string name = (stem.empty() ? "object-" : stem) + std::to_string(i); !taken(name)) return name;
}

bool adoptFacts(Scenario& scenario, const Recording& recording) {
  const bool observers = scenario.observers.empty() && !recording.scenario.observers.empty(), batteries = scenario.batteries.empty() && !recording.scenario.batteries.empty();
  if (observers) scenario.observers = recording.scenario.observers;
  if (batteries) scenario.batteries = recording.scenario.batteries;
  return observers || batteries;
}

ObjectRef addVehicle(Scenario& scenario, int type, const Place& at) {
  std::string stem = "vehicle-";
  for (const VehicleType& known : vehicleTypes(scenario)) {
    if (known.index != type || known.name.empty()) continue;
    stem.clear();
    for (const char c : known.name)
      if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-') stem += c;
      else if (c >= 'A' && c <= 'Z') stem += static_cast<char>(c - 'A' + 'a');
    stem += '-';
  }
  VehicleSetup vehicle;
  vehicle.id = freeName(scenario, stem);
  vehicle.type = type;
  vehicle.at = clamped(scenario, at);
  scenario.vehicles.push_back(vehicle);
  return {Kind::vehicle, vehicle.id};
}

ObjectRef addGun(Scenario& scenario, const std::string& battery, const Place& at) {
  BatterySetup* to = named(scenario.batteries, battery);
  if (to == nullptr) {
    BatterySetup made;
    made.id = freeName(scenario, "battery");
    scenario.batteries.push_back(std::move(made));
    to = &scenario.batteries.back();
  }
  GunSetup gun{freeName(scenario, to->guns.empty() ? "gun" : to->guns.back().id), clamped(scenario, at)};
  to->guns.push_back(gun);
  return {Kind::gun, gun.id};
}

ObjectRef addObserver(Scenario& scenario, const Place& at) {
  ObserverSetup observer;
  observer.id = freeName(scenario, "fo");
  observer.at = clamped(scenario, at);
  // He is there for whatever stands against him.
  for (const VehicleSetup& vehicle : scenario.vehicles)
    for (const VehicleType& type : vehicleTypes(scenario))
      if (type.index == vehicle.type && type.side == Side::hostile && std::ranges::find(observer.missions, type.index, &MissionOrder::type) == observer.missions.end())
        observer.missions.push_back({MissionAction::destroy, type.index});
  scenario.observers.push_back(observer);
  return {Kind::observer, observer.id};
}

ObjectRef addGroup(Scenario& scenario, int type, const Place& at) {
  VehicleGroup group;
  group.id = freeName(scenario, "group");
  group.type = type;
  group.count = 10;
  group.from = clamped(scenario, {at.x_m - 500.0, at.z_m - 500.0});
  group.to = clamped(scenario, {at.x_m + 500.0, at.z_m + 500.0});
  scenario.groups.push_back(group);
  return {Kind::group, group.id};
}

std::optional<ObjectRef> duplicate(Scenario& scenario, const ObjectRef& ref) {
  void* const object = find(scenario, ref);
  if (object == nullptr || ref.kind == Kind::mission) return std::nullopt;
  const std::string name = freeName(scenario, ref.id);
  const auto copy = [&](auto& list, auto one) {
    one.id = name;
    list.push_back(std::move(one));
  };
  switch (ref.kind) {
    case Kind::vehicle: copy(scenario.vehicles, *static_cast<VehicleSetup*>(object)); break;
    case Kind::group: copy(scenario.groups, *static_cast<VehicleGroup*>(object)); break;
    case Kind::observer: {
      // The copy stands on his own feet: moving him aside aboard would move the vehicle.
      ObserverSetup one = *static_cast<ObserverSetup*>(object);
      one.at = placeOf(scenario, ref).value_or(one.at);
      one.vehicle.clear();
      copy(scenario.observers, std::move(one));
      break;
    }
    case Kind::gun: {
      BatterySetup* battery = nullptr;
      const GunSetup gun = *findGun(scenario, ref.id, &battery);
      copy(battery->guns, gun);
      break;
    }
    case Kind::battery: {
      BatterySetup battery = *static_cast<BatterySetup*>(object);
      battery.id = name;
      std::vector<GunSetup> guns = std::exchange(battery.guns, {});
      scenario.batteries.push_back(std::move(battery));
      for (GunSetup& gun : guns) {
        gun.id = freeName(scenario, gun.id);
        scenario.batteries.back().guns.push_back(std::move(gun));
      }
      break;
    }
    case Kind::mission: break;
  }
  const ObjectRef made{ref.kind, name};
  shift(scenario, made, 30.0, 30.0);
  return made;
}

bool remove(Scenario& scenario, const ObjectRef& ref) {
  if (ref.kind == Kind::mission || find(scenario, ref) == nullptr) return false;
  const auto gone = [&](const auto& one) { return one.id == ref.id; };
  if (ref.kind == Kind::group) std::erase_if(scenario.groups, gone);
  if (ref.kind == Kind::observer) std::erase_if(scenario.observers, gone);
  if (ref.kind == Kind::gun) {
    BatterySetup* battery = nullptr;
    findGun(scenario, ref.id, &battery);
    std::erase_if(battery->guns, gone);
    if (battery->guns.empty()) return remove(scenario, {Kind::battery, std::string(battery->id)});
  }
  if (ref.kind == Kind::battery) {
    std::erase_if(scenario.batteries, gone);
    for (ObserverSetup& observer : scenario.observers) std::erase(observer.batteries, ref.id);
  }
  if (ref.kind == Kind::vehicle) {
    for (ObserverSetup& observer : scenario.observers)
      if (observer.vehicle == ref.id) {
        observer.at = static_cast<VehicleSetup*>(find(scenario, ref))->at;
        observer.vehicle.clear();
      }
    for (VehicleSetup& vehicle : scenario.vehicles)
      if (vehicle.follows == ref.id) {
        vehicle.follows.clear();
        if (vehicle.behaviour == Behaviour::follow) vehicle.behaviour = Behaviour::stationary;
      }
    std::erase_if(scenario.vehicles, gone);
  }
  return true;
}

void rename(Scenario& scenario, const ObjectRef& ref, const std::string& name) {
  const auto change = [&](auto& list) {
    if (auto* one = named(list, ref.id)) one->id = name;
  };
  const auto follow = [&](std::string& word) {
    if (word == ref.id) word = name;
  };
  if (ref.kind == Kind::group) change(scenario.groups);
  if (ref.kind == Kind::observer) change(scenario.observers);
  if (ref.kind == Kind::gun)
    if (GunSetup* gun = findGun(scenario, ref.id)) gun->id = name;
  if (ref.kind == Kind::battery) {
    change(scenario.batteries);
    for (ObserverSetup& observer : scenario.observers) std::ranges::for_each(observer.batteries, follow);
  }
  if (ref.kind != Kind::vehicle) return;
  change(scenario.vehicles);
  for (VehicleSetup& vehicle : scenario.vehicles) follow(vehicle.follows);
  for (ObserverSetup& observer : scenario.observers) follow(observer.vehicle);
}

}  // namespace npsee::editor
