#pragma once

#include <npsee/recording.h>
#include <npsee/scenario.h>

#include <optional>
#include <string>
#include <vector>

namespace npsee::world {
struct Struct;
}

namespace npsee::editor {

/// Something in a mission that can be selected, by its kind and name. `mission` stands for what belongs to no single thing: name,
/// duration, ground, weather, fire direction.
struct ObjectRef {
  enum class Kind { mission, vehicle, group, battery, gun, observer };
  Kind kind = Kind::mission;
  std::string id;
  friend bool operator==(const ObjectRef&, const ObjectRef&) = default;
};

/// "vehicle", "gun", ...
std::string_view kindName(ObjectRef::Kind kind);

/// A structure of the scenario with the table that describes it.
struct TablePart {
  const world::Struct* table = nullptr;
  void* object = nullptr;
  explicit operator bool() const { return object != nullptr; }
};
/// The structure of an object; empty if there is none of that name. The mission is the scenario itself.
TablePart partOf(Scenario& scenario, const ObjectRef& ref);
/// For reading only.
inline TablePart partOf(const Scenario& scenario, const ObjectRef& ref) { return partOf(const_cast<Scenario&>(scenario), ref); }
bool exists(const Scenario& scenario, const ObjectRef& ref);

/// Where an object starts: a vehicle, gun or observer its place, a group the middle of its area, a battery the mean of its guns.
std::optional<Place> placeOf(const Scenario& scenario, const ObjectRef& ref);
/// Shifts an object; clamped so that no part of it leaves the world. An observer who rides on a vehicle moves that vehicle.
void shift(Scenario& scenario, const ObjectRef& ref, double dx_m, double dz_m);

/// By what each vehicle of a recording is selected: itself, or the observer it carries.
std::vector<ObjectRef> ownersOf(const Recording& recording);
/// What of the scenario is edited where something is selected: a vehicle that comes from a group is edited as the group; everything else
/// is itself, whether the scenario has it or a facts file brings it.
ObjectRef editable(const Scenario& scenario, const ObjectRef& ref);
/// Index in the recording of the vehicle, gun or observer's vehicle that an object is; -1 if none.
int vehicleOf(const Recording& recording, const ObjectRef& ref);

/// A name that no object of the scenario has: "t72-1" gives "t72-2".
std::string freeName(const Scenario& scenario, std::string_view like);
/// Every vehicle, gun, battery, group and observer name.
std::vector<std::string> allNames(const Scenario& scenario);

/// Writes into the scenario what its recording took from a facts file: observers and batteries that the scenario leaves to it. True if
/// there was something to write.
bool adoptFacts(Scenario& scenario, const Recording& recording);

/// New things at a place, each with a free name. They return what was added.
ObjectRef addVehicle(Scenario& scenario, int type, const Place& at);
/// To the battery `battery` (an id), or a new one where that is empty.
ObjectRef addGun(Scenario& scenario, const std::string& battery, const Place& at);
ObjectRef addObserver(Scenario& scenario, const Place& at);
/// Ten vehicles of a type at random places of a square around `at`.
ObjectRef addGroup(Scenario& scenario, int type, const Place& at);
/// A copy beside the original; empty if nothing can be copied.
std::optional<ObjectRef> duplicate(Scenario& scenario, const ObjectRef& ref);
/// Removes an object and what names it: followers stand still, observers carried by it stand on their own feet. False if there is
/// no such object. The last gun of a battery takes the battery with it.
bool remove(Scenario& scenario, const ObjectRef& ref);
/// Gives an object another name, everywhere it is named.
void rename(Scenario& scenario, const ObjectRef& ref, const std::string& name);

}  // namespace npsee::editor
