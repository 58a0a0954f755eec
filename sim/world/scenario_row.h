#pragma once

#include "sim/world/scenario_table.h"

#include <array>
#include <type_traits>

namespace npsee::world {

/// Keys of an enum's values in declaration order; specialised once per enum.
template <class E>
struct Choices;

#define NPSEE_CHOICES(E, ...)                                                      \
  template <>                                                                      \
  struct Choices<E> {                                                              \
    static constexpr auto keys = std::to_array<std::string_view>({__VA_ARGS__}); \
  }

NPSEE_CHOICES(Side, "friendly", "hostile", "neutral");
NPSEE_CHOICES(TargetClass, "heavy_armor", "light_armor", "wheeled", "personnel", "aircraft", "watercraft");
NPSEE_CHOICES(Behaviour, "static", "straight", "meander", "goals", "follow", "user");
NPSEE_CHOICES(Reaction, "none", "retire", "return_fire", "both");
NPSEE_CHOICES(FireMethod, "auto", "adjust_fire", "fire_for_effect", "suppress", "immediate_suppression", "smoke", "illuminate");
NPSEE_CHOICES(MissionAction, "destroy", "neutralize", "special");
NPSEE_CHOICES(TrajectoryChoice, "auto", "low", "high");
NPSEE_CHOICES(ElevationSolver, "root", "table");
NPSEE_CHOICES(TerrainKind, "flat", "hills", "function", "hgt", "png");

#undef NPSEE_CHOICES

/// What a row says besides its type and accessors, which follow from the member.
struct Words {
  std::string_view key, doc;
  Range hard{};
  Unit unit = Unit::none;
  bool required = false;
  bool si = true;
  std::string_view word{}, singular{};
  std::string_view (*idle)(const void*) = nullptr;
};

/// Words::idle from a function of the structure itself.
template <class Object, std::string_view (*why)(const Object&)>
std::string_view idleIn(const void* object) {
  return why(*static_cast<const Object*>(object));
}

template <class Member>
constexpr FieldType typeOf() {
  if constexpr (std::is_same_v<Member, bool>) return FieldType::boolean;
  else if constexpr (std::is_integral_v<Member>) return FieldType::integer;
  else if constexpr (std::is_same_v<Member, double>) return FieldType::number;
  else if constexpr (std::is_enum_v<Member>) return FieldType::choice;
  else if constexpr (std::is_same_v<Member, std::string>) return FieldType::text;
  else if constexpr (std::is_same_v<Member, std::filesystem::path>) return FieldType::file;
  else if constexpr (std::is_same_v<Member, Place>) return FieldType::place;
  else if constexpr (std::is_same_v<Member, Vec3>) return FieldType::vector;
  else if constexpr (std::is_same_v<Member, std::vector<std::string>>) return FieldType::texts;
  else return FieldType::places;
}

template <class Member>
FieldValue toField(const Member& member) {
  if constexpr (std::is_same_v<Member, bool>) return member;
  else if constexpr (std::is_integral_v<Member>) return static_cast<std::int64_t>(member);
  else if constexpr (std::is_enum_v<Member>) return std::string(Choices<Member>::keys[static_cast<std::size_t>(member)]);
  else if constexpr (std::is_same_v<Member, std::filesystem::path>) return member.generic_string();
  else return member;
}

template <class Member>
Member fromField(const FieldValue& value) {
  if constexpr (std::is_same_v<Member, bool>) {
    return std::get<bool>(value);
  } else if constexpr (std::is_integral_v<Member>) {
    return static_cast<Member>(std::get<std::int64_t>(value));
  } else if constexpr (std::is_enum_v<Member>) {
    const auto& key = std::get<std::string>(value);
    for (std::size_t i = 0; i < Choices<Member>::keys.size(); ++i)
      if (Choices<Member>::keys[i] == key) return static_cast<Member>(i);
    return Member{};
  } else if constexpr (std::is_same_v<Member, std::filesystem::path>) {
    return std::get<std::string>(value);
  } else {
    return std::get<Member>(value);
  }
}

inline Field fieldOf(const Words& words, FieldType type) {
  Field out;
  out.key = words.key;
  out.doc = words.doc;
  out.type = type;
  out.unit = words.unit;
  out.hard = words.hard;
  out.required = words.required;
  out.si = words.si;
  out.word = words.word;
  out.singular = words.singular;
  out.idle = words.idle;
  return out;
}

/// A row for a plain member.
template <class Object, class Member>
Field field(Member Object::*member, const Words& words) {
  Field out = fieldOf(words, typeOf<Member>());
  if constexpr (std::is_enum_v<Member>) out.choices = Choices<Member>::keys;
  out.read = [member](const void* object) { return toField(static_cast<const Object*>(object)->*member); };
  out.write = [member](void* object, const FieldValue& value) { static_cast<Object*>(object)->*member = fromField<Member>(value); };
  return out;
}

/// A row for a member that names its object.
template <class Object>
Field identity(std::string Object::*member, Words words) {
  words.hard = {1, 40};
  Field out = field(member, words);
  out.type = FieldType::id;
  return out;
}

/// A row for two numbers written as [x, z].
template <class Object>
Field pair(double Object::*x, double Object::*z, const Words& words) {
  Field out = fieldOf(words, FieldType::place);
  out.read = [x, z](const void* object) { return Place{static_cast<const Object*>(object)->*x, static_cast<const Object*>(object)->*z}; };
  out.write = [x, z](void* object, const FieldValue& value) {
    static_cast<Object*>(object)->*x = std::get<Place>(value).x_m;
    static_cast<Object*>(object)->*z = std::get<Place>(value).z_m;
  };
  return out;
}

/// A row for a member that is a structure.
template <class Object, class Child>
Field object(Child Object::*member, const Struct& child, const Words& words) {
  Field out = fieldOf(words, FieldType::object);
  out.child = &child;
  out.part = [member](void* whole) -> void* { return &(static_cast<Object*>(whole)->*member); };
  return out;
}

/// A row for a list of structures. New elements have the child's defaults.
template <class Object, class Child>
Field list(std::vector<Child> Object::*member, const Struct& child, const Words& words) {
  Field out = fieldOf(words, FieldType::list);
  out.child = &child;
  out.count = [member](const void* whole) { return (static_cast<const Object*>(whole)->*member).size(); };
  out.item = [member](void* whole, std::size_t index) -> void* { return &(static_cast<Object*>(whole)->*member)[index]; };
  out.append = [member, &child](void* whole) -> void* {
    auto& elements = static_cast<Object*>(whole)->*member;
    elements.push_back(*static_cast<const Child*>(child.make().get()));
    return &elements.back();
  };
  out.clear = [member](void* whole) { (static_cast<Object*>(whole)->*member).clear(); };
  return out;
}

template <class Object>
Struct structOf(std::string_view name, std::string_view doc, std::vector<Field> fields, std::string_view identity = {}, const Object& initial = {}) {
  Struct out;
  out.name = name;
  out.doc = doc;
  out.fields = std::move(fields);
  out.identity = identity;
  out.make = [initial] { return std::shared_ptr<void>(std::make_shared<Object>(initial)); };
  return out;
}

inline constexpr Range kIndexRange{0, 9999};
inline constexpr double kLargestWhole = 9007199254740991.0;

const Struct& worldTable();
const Struct& weatherTable();
const Struct& terrainTable();
const Struct& vehicleTypeTable();
const Struct& vehicleTable();
const Struct& groupTable();
const Struct& gunTable();
const Struct& batteryTable();
const Struct& sensingTable();
const Struct& orderTable();
const Struct& observerTable();
const Struct& fdcTable();

}  // namespace npsee::world
