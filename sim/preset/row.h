#pragma once

#include <npsee/parameters.h>

#include <array>
#include <type_traits>

namespace npsee::table {

/// Keys of an enum's values in declaration order; specialised once per enum.
template <class E>
struct Choices;

#define NPSEE_CHOICES(E, ...)                                            \
  template <>                                                            \
  struct Choices<E> {                                                    \
    static constexpr auto keys = std::to_array<std::string_view>({__VA_ARGS__}); \
  }

NPSEE_CHOICES(BurstKind, "ground", "air");
NPSEE_CHOICES(RegionShape, "point", "disc", "ring", "square", "line", "sphere", "hemisphere", "box", "cylinder");
NPSEE_CHOICES(RegionFill, "filled", "surface");
NPSEE_CHOICES(Directionality, "burst", "cone", "neutral");
NPSEE_CHOICES(AngleDistribution, "normal", "uniform", "place");
NPSEE_CHOICES(Distribution, "normal", "uniform");
NPSEE_CHOICES(Trajectory, "linear", "parabolic");
NPSEE_CHOICES(Form, "tetrahedron", "disc", "sphere", "shard", "streak", "smoke", "fire", "flash", "shock", "scorch", "pieces");
NPSEE_CHOICES(Trigger, "none", "birth", "path", "bounce", "death");
NPSEE_CHOICES(PathSpacing, "time", "distance");
NPSEE_CHOICES(Sky, "day", "dusk", "night");

#undef NPSEE_CHOICES

/// What a row says besides type, accessor and scope, which follow from the member.
struct Words {
  std::string_view key, label, thesis, doc;
  Section section{};
  Unit unit = Unit::none;
  Range hard{}, slider{};
  Scale scale = Scale::linear;
  std::string_view (*idle)(const Preset&, const Layer&) = nullptr;
};

template <class Member>
constexpr ParameterType typeOf() {
  if constexpr (std::is_same_v<Member, bool>) return ParameterType::boolean;
  else if constexpr (std::is_same_v<Member, std::int64_t>) return ParameterType::integer;
  else if constexpr (std::is_same_v<Member, double>) return ParameterType::number;
  else if constexpr (std::is_enum_v<Member>) return ParameterType::choice;
  else if constexpr (std::is_same_v<Member, std::string>) return ParameterType::text;
  else if constexpr (std::is_same_v<Member, Vec3>) return ParameterType::vector;
  else if constexpr (std::is_same_v<Member, Colour>) return ParameterType::colour;
  else if constexpr (std::is_same_v<Member, Curve>) return ParameterType::curve;
  else return ParameterType::gradient;
}

template <class Member>
Value toValue(const Member& member) {
  if constexpr (std::is_enum_v<Member>) return std::string(Choices<Member>::keys[static_cast<std::size_t>(member)]);
  else return member;
}

template <class Member>
Member fromValue(const Value& value) {
  if constexpr (std::is_enum_v<Member>) {
    const auto& key = std::get<std::string>(value);
    for (std::size_t i = 0; i < Choices<Member>::keys.size(); ++i)
      if (Choices<Member>::keys[i] == key) return static_cast<Member>(i);
    return Member{};
  } else {
    return std::get<Member>(value);
  }
}

/// A row for a struct member. `initial` is in the file unit.
template <class Object, class Member>
Parameter row(Member Object::*member, const Member& initial, const Words& words) {
  Parameter out;
  out.key = words.key;
  out.label = words.label;
  out.thesis = words.thesis;
  out.doc = words.doc;
  out.scope = std::is_same_v<Object, Layer> ? Scope::layer : Scope::burst;
  out.section = words.section;
  out.type = typeOf<Member>();
  out.unit = words.unit;
  out.hard = words.hard;
  out.slider = words.slider.min == words.slider.max ? words.hard : words.slider;
  out.scale = words.scale;
  out.idle = words.idle;
  if constexpr (std::is_enum_v<Member>) out.choices = Choices<Member>::keys;
  if constexpr (std::is_same_v<Member, double>) out.initial = toSi(words.unit, initial);
  else out.initial = toValue(initial);
  out.read = [member](const void* object) { return toValue(static_cast<const Object*>(object)->*member); };
  out.write = [member](void* object, const Value& value) { static_cast<Object*>(object)->*member = fromValue<Member>(value); };
  return out;
}

std::vector<Parameter> burstRows();
std::vector<Parameter> layerRows();

}  // namespace npsee::table
