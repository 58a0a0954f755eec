#pragma once

#include "sim/world/scenario_table.h"

#include <npsee/scenario.h>

#include <string>

namespace npsee::test {

inline VehicleType typeNamed(int index, std::string name) {
  VehicleType out;
  out.index = index;
  out.name = std::move(name);
  return out;
}

/// A valid mission that has one of everything.
inline Scenario sampleScenario() {
  Scenario s;
  s.name = "sample";
  s.types.push_back(typeNamed(60, "scout car"));
  s.vehicles.emplace_back();
  s.vehicles[0].id = "t72-1";
  s.vehicles[0].type = 51;
  s.vehicles[0].at = {26000, 25000};
  s.groups.push_back({.id = "group", .type = 52, .count = 3, .from = {20000, 20000}, .to = {21000, 21000}});
  BatterySetup battery;
  battery.id = "alpha";
  battery.guns.push_back({"gun1", {24000, 24000}});
  s.batteries.push_back(battery);
  ObserverSetup observer;
  observer.id = "fo1";
  observer.at = {25000, 25000};
  observer.missions.push_back({MissionAction::destroy, 51});
  s.observers.push_back(observer);
  return s;
}

/// A value of a field that is allowed and differs from `initial`.
inline world::FieldValue another(const world::Field& field, const world::FieldValue& initial) {
  using world::FieldType;
  const double middle = field.hard.min + 0.37 * (field.hard.max - field.hard.min);
  switch (field.type) {
    case FieldType::boolean: return !std::get<bool>(initial);
    case FieldType::integer: return static_cast<std::int64_t>(field.hard.max);
    case FieldType::number: return field.si ? toSi(field.unit, middle) : middle;
    case FieldType::choice: return std::string(std::get<std::string>(initial) == field.choices.back() ? field.choices.front() : field.choices.back());
    case FieldType::text: return std::string("other \"text\"\n\xc3\xa9");
    case FieldType::id: return std::string("an-Other_1");
    case FieldType::file: return std::string("folder/file.dat");
    case FieldType::place: return Place{middle, 0.1 + field.hard.max / 2.0};
    case FieldType::vector: return Vec3{0.25, 0.5, -0.75};
    case FieldType::texts: return std::vector<std::string>{"3W", "4W"};
    case FieldType::places: return std::vector<Place>{{1.5, 2}, {3, 4}};
    case FieldType::parameters: return world::Params{{"axis", std::string("x")}, {"crest_z", 25000.5}};
    case FieldType::object:
    case FieldType::list:
    case FieldType::expectations: break;
  }
  return initial;
}

}  // namespace npsee::test
