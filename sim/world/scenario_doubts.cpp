#include "sim/world/scenario_files.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

/// Enough to see what is wrong.
constexpr std::size_t kMostTold = 20;

struct Standing {
  const std::string* id;
  Place at;
  double width_m;
  bool flies;
  std::string pointer;
};

std::vector<Standing> standingIn(const Scenario& scenario) {
  const std::vector<VehicleType> types = vehicleTypes(scenario);
  std::vector<Standing> out;
  const auto add = [&](const std::string& id, int type_index, const Place& at, std::string pointer) {
    const auto type = std::ranges::lower_bound(types, type_index, {}, &VehicleType::index);
    if (type != types.end() && type->index == type_index) out.push_back({&id, at, std::min(type->width_m, type->length_m), type->target_class == TargetClass::aircraft, std::move(pointer)});
  };
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) add(scenario.vehicles[i].id, scenario.vehicles[i].type, scenario.vehicles[i].at, "/vehicles/" + std::to_string(i) + "/pos");
  for (std::size_t i = 0; i < scenario.observers.size(); ++i)
    if (scenario.observers[i].vehicle.empty()) add(scenario.observers[i].id, scenario.observers[i].type, scenario.observers[i].at, "/observers/" + std::to_string(i) + "/pos");
  return out;
}

/// Vehicles and observers that stand inside one another.
void doubtPlaces(const Scenario& scenario, std::vector<Fault>& warnings) {
  const std::vector<Standing> all = standingIn(scenario);
  double widest = 0.0;
  std::vector<std::size_t> by_x(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    by_x[i] = i;
    widest = std::max(widest, all[i].width_m);
  }
  std::ranges::stable_sort(by_x, {}, [&](std::size_t i) { return all[i].at.x_m; });
  std::size_t told = 0;
  for (std::size_t i = 0; i < by_x.size(); ++i)
    for (std::size_t j = i + 1; j < by_x.size() && told < kMostTold; ++j) {
      const Standing &a = all[std::min(by_x[i], by_x[j])], &b = all[std::max(by_x[i], by_x[j])];
      const double dx = b.at.x_m - a.at.x_m, dz = b.at.z_m - a.at.z_m, apart = 0.5 * (a.width_m + b.width_m);
      if (std::fabs(dx) >= widest) break;
      if (a.flies != b.flies || dx * dx + dz * dz >= apart * apart) continue;
      ++told;
      warnings.push_back({.what = *b.id + " stands inside " + *a.id + ", at (" + shortest(b.at.x_m) + ", " + shortest(b.at.z_m) + ").", .remedy = "Move one of them by some metres.", .file = {}, .line = 0, .pointer = b.pointer});
    }
}

}  // namespace

void addDoubts(const Scenario& scenario, std::vector<Fault>& warnings) {
  for (std::size_t i = 0; i < scenario.observers.size(); ++i) {
    const ObserverSetup& observer = scenario.observers[i];
    const std::string pointer = "/observers/" + std::to_string(i);
    if (observer.missions.empty() && observer.rules.empty() && !observer.human)
      warnings.push_back({.what = "Observer " + observer.id + " has no mission orders: he watches, but calls fire on nothing.", .remedy = "Give him missions, or name a facts file.", .file = {}, .line = 0, .pointer = pointer});
  }
  doubtPlaces(scenario, warnings);
}

}  // namespace npsee::world
