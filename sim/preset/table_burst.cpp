#include "sim/preset/row.h"

namespace npsee::table {

std::vector<Parameter> burstRows() {
  using enum Section;
  std::vector<Parameter> rows;
  const auto add = [&](Parameter parameter) { rows.push_back(std::move(parameter)); };

  add(row(&Preset::title, std::string(), {.key = "title", .label = "Title", .thesis = "", .doc = "Name of the effect as people read it.", .section = about, .hard = {0, 120}}));
  add(row(&Preset::description, std::string(), {.key = "description", .label = "Description", .thesis = "", .doc = "What the effect shows and where its figures come from.", .section = about, .hard = {0, 4000}}));
  add(row(&Preset::tags, std::string(), {.key = "tags", .label = "Tags", .thesis = "", .doc = "Words to find the preset by, separated by commas.", .section = about, .hard = {0, 400}}));

  add(row(&Preset::burst, BurstKind::ground, {.key = "burst", .label = "Burst", .thesis = "air or ground burst", .doc = "A ground burst throws particles up and outward within the ejection angle; an air burst throws them in all directions.", .section = burst}));
  add(row(&Preset::burst_height_m, 0.0, {.key = "burst_height", .label = "Burst height", .thesis = "", .doc = "Height of an air burst's centre above the ground; a ground burst lies on it.", .section = burst, .unit = Unit::metre, .hard = {0, 5000}, .slider = {0, 100}, .idle = [](const Preset& p, const Layer&) -> std::string_view { return p.burst == BurstKind::ground ? "a ground burst lies on the ground" : ""; }}));
  add(row(&Preset::seed, std::int64_t{1993}, {.key = "seed", .label = "Seed", .thesis = "", .doc = "Selects the random draws; the same seed gives the same explosion, bit for bit.", .section = burst, .hard = {0, 9007199254740991.0}, .slider = {0, 9999}}));

  add(row(&Preset::gravity_mps2, 9.80665, {.key = "gravity", .label = "Gravity", .thesis = "", .doc = "Acceleration of free fall, downward.", .section = surroundings, .unit = Unit::metre_per_second2, .hard = {0, 100}, .slider = {0, 25}}));
  add(row(&Preset::wind_mps, Vec3{}, {.key = "wind", .label = "Wind", .thesis = "", .doc = "Velocity of the air: x east, y up, z south. Particles with drag are carried towards it.", .section = surroundings, .unit = Unit::metre_per_second, .hard = {-200, 200}, .slider = {-30, 30}}));
  add(row(&Preset::ground_height_m, 0.0, {.key = "ground.height", .label = "Ground height", .thesis = "", .doc = "Height of the flat ground in the world.", .section = surroundings, .unit = Unit::metre, .hard = {-10000, 10000}, .slider = {-10, 10}}));
  add(row(&Preset::ground_colour, Colour{0.46, 0.44, 0.38}, {.key = "ground.colour", .label = "Ground colour", .thesis = "", .doc = "Colour of the ground in pictures.", .section = surroundings, .hard = {0, 1}}));
  add(row(&Preset::sky, Sky::day, {.key = "sky", .label = "Sky", .thesis = "", .doc = "Hour in pictures: sky, light of the sun, and how bright the ground is. What shines by itself lights the ground at any hour. In a mission the mission's hour counts.", .section = surroundings}));
  return rows;
}

}  // namespace npsee::table
