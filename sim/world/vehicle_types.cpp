#include <npsee/scenario.h>

#include <algorithm>

namespace npsee {
namespace {

constexpr int kUnarmed = 0, kMachineGun = 112;

VehicleType type(int index, std::string name, Side side, TargetClass target_class, Vec3 size_m, double speed_mps, double turn_deg, int weapon = kUnarmed) {
  VehicleType out;
  out.index = index;
  out.name = std::move(name);
  out.side = side;
  out.target_class = target_class;
  out.length_m = size_m.x;
  out.height_m = size_m.y;
  out.width_m = size_m.z;
  out.speed_mps = speed_mps;
  out.turn_radps = toSi(Unit::degree_per_second, turn_deg);
  out.weapon = weapon;
  return out;
}

}  // namespace

// Indices 8, 51, 52 and 53 are the thesis's (appendix B.C); it does not say what a T2fred is, and here it is one more light armoured vehicle.
// The others are ours. Sizes (length, height, width) and speeds are round figures of such vehicles, good for a picture and a game.
const std::vector<VehicleType>& shippedVehicleTypes() {
  using enum Side;
  using enum TargetClass;
  static const std::vector<VehicleType> types{
      type(1, "infantry squad", friendly, personnel, {10.0, 1.8, 10.0}, 1.5, 90.0),
      type(4, "truck", friendly, wheeled, {6.9, 3.0, 2.5}, 20.0, 25.0),
      type(6, "M113", friendly, light_armor, {4.9, 2.5, 2.7}, 15.0, 25.0, kMachineGun),
      type(8, "M577", friendly, light_armor, {4.9, 2.7, 2.7}, 15.0, 25.0),
      type(9, "M109", friendly, light_armor, {9.1, 3.2, 3.1}, 14.0, 20.0),
      type(10, "M110", friendly, light_armor, {10.8, 3.1, 3.1}, 14.0, 20.0),
      type(51, "T-72", hostile, heavy_armor, {6.9, 2.2, 3.6}, 15.0, 25.0, kMachineGun),
      type(52, "BMP", hostile, light_armor, {6.7, 2.1, 2.9}, 16.0, 25.0, kMachineGun),
      type(53, "T2fred", hostile, light_armor, {6.5, 2.3, 3.0}, 15.0, 25.0, kMachineGun),
      type(54, "hostile truck", hostile, wheeled, {7.4, 2.9, 2.5}, 20.0, 25.0),
      type(55, "hostile infantry squad", hostile, personnel, {10.0, 1.8, 10.0}, 1.5, 90.0),
      type(90, "civil car", neutral, wheeled, {4.4, 1.5, 1.8}, 25.0, 35.0),
      type(91, "civil bus", neutral, wheeled, {12.0, 3.1, 2.5}, 22.0, 20.0),
  };
  return types;
}

std::vector<VehicleType> vehicleTypes(const Scenario& scenario) {
  std::vector<VehicleType> out = shippedVehicleTypes();
  for (const VehicleType& own : scenario.types) {
    const auto place = std::ranges::lower_bound(out, own.index, {}, &VehicleType::index);
    if (place != out.end() && place->index == own.index) *place = own;
    else out.insert(place, own);
  }
  return out;
}

}  // namespace npsee
