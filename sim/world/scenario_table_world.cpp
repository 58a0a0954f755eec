#include "sim/world/scenario_row.h"

namespace npsee::world {
namespace {

// Why a field has no effect with the others as they are; empty where it has.

template <TerrainKind... kinds>
std::string_view unlessKind(const TerrainSource& terrain) {
  return ((terrain.kind == kinds) || ...) ? "" : "the terrain is of another kind";
}
template <TerrainKind... kinds>
constexpr auto kUnlessKind = idleIn<TerrainSource, unlessKind<kinds...>>;

std::string_view byDay(const Weather& weather) { return weather.night ? "" : "it is day"; }
std::string_view withoutTable(const FdcSetup& fdc) { return fdc.solver == ElevationSolver::table ? "" : "the solver uses no table"; }
std::string_view withoutMistakes(const FdcSetup& fdc) { return fdc.misunderstanding > 0.0 ? "" : "no message is misheard"; }

/// The terrain function's numbers, with the axis among them as files have it.
Field terrainParams() {
  Field out = fieldOf({.key = "params", .doc = "Of kind function: its numbers by name, and `axis` (x or z), along which a crest, a ramp or a cliff runs; ridge: crest_x (crest_z for axis x), crest_height, foot_before, foot_after.", .hard = {0, 64}, .idle = kUnlessKind<TerrainKind::function>}, FieldType::parameters);
  out.read = [](const void* object) {
    const auto& source = *static_cast<const TerrainSource*>(object);
    Params params;
    for (const auto& [name, number] : source.params) params.emplace(name, number);
    if (source.axis != TerrainSource{}.axis) params.emplace("axis", source.axis);
    return FieldValue(std::move(params));
  };
  out.write = [](void* object, const FieldValue& value) {
    auto& source = *static_cast<TerrainSource*>(object);
    source.params.clear();
    source.axis = TerrainSource{}.axis;
    for (const auto& [name, content] : std::get<Params>(value)) {
      if (const double* number = std::get_if<double>(&content)) source.params.emplace(name, *number);
      else source.axis = std::get<std::string>(content);
    }
  };
  return out;
}

}  // namespace

const Struct& weatherTable() {
  static const Struct table = structOf<Weather>(
      "weather", "What the air does to sight and to shells.",
      {
          field(&Weather::visibility_m, {.key = "visibility", .doc = "Meteorological visibility: the distance at which contrast has fallen to 2 %.", .hard = {1, 1e6}, .unit = Unit::metre}),
          field(&Weather::night, {.key = "night", .doc = "Whether it is night, which scales contrast and range of sight."}),
          field(&Weather::night_contrast, {.key = "night_contrast", .doc = "Factor on a target's contrast at night.", .hard = {0, 1}, .unit = Unit::fraction, .idle = idleIn<Weather, byDay>}),
          field(&Weather::night_range, {.key = "night_range", .doc = "Factor on the observers' greatest range at night.", .hard = {0.01, 1}, .unit = Unit::fraction, .idle = idleIn<Weather, byDay>}),
          field(&Weather::wind_mps, {.key = "wind", .doc = "Velocity of the air: x east, y up, z south.", .hard = {-100, 100}, .unit = Unit::metre_per_second}),
      });
  return table;
}

const Struct& terrainTable() {
  static const Struct table = structOf<TerrainSource>(
      "terrain", "How the ground comes about.",
      {
          field(&TerrainSource::kind, {.key = "kind", .doc = "flat ground, generated hills, a function, an SRTM tile (.hgt) or a 16-bit grey PNG with a sidecar."}),
          field(&TerrainSource::height_m, {.key = "height", .doc = "Of kind flat: height of the ground everywhere.", .hard = {-20000, 20000}, .unit = Unit::metre, .idle = kUnlessKind<TerrainKind::flat>}),
          field(&TerrainSource::expression, {.key = "expr", .doc = "Of kind function: its name (ridge, slope, step, plane or cone).", .hard = {0, 40}, .idle = kUnlessKind<TerrainKind::function>}),
          terrainParams(),
          field(&TerrainSource::cell_m, {.key = "cell", .doc = "Distance between samples of the ground; 0 chooses by kind and size.", .hard = {0, 100000}, .unit = Unit::metre}),
          field(&TerrainSource::relief_m, {.key = "relief", .doc = "Of kind hills: height of the land over the sea.", .hard = {0, 9000}, .unit = Unit::metre, .idle = kUnlessKind<TerrainKind::hills>}),
          field(&TerrainSource::scale_m, {.key = "scale", .doc = "Of kind hills: distance from one range of hills to the next.", .hard = {10, 1e6}, .unit = Unit::metre, .idle = kUnlessKind<TerrainKind::hills>}),
          field(&TerrainSource::valley, {.key = "valley", .doc = "Of kind hills: width of the valley floors, from notches (0) to plains (1).", .hard = {0, 1}, .unit = Unit::fraction, .idle = kUnlessKind<TerrainKind::hills>}),
          field(&TerrainSource::sea_fraction, {.key = "sea_fraction", .doc = "Of kind hills: share of the world under the sea.", .hard = {0, 0.9}, .unit = Unit::fraction, .idle = kUnlessKind<TerrainKind::hills>}),
          field(&TerrainSource::seed, {.key = "seed", .doc = "Of kind hills: selects the hills; independent of the mission's seed.", .hard = {0, kLargestWhole}, .idle = kUnlessKind<TerrainKind::hills>}),
          field(&TerrainSource::file, {.key = "file", .doc = "Of kinds hgt and png: the file, beside the mission file or below its folder.", .hard = {0, 1000}, .idle = kUnlessKind<TerrainKind::hgt, TerrainKind::png>}),
      });
  return table;
}

const Struct& worldTable() {
  static const Struct table = structOf<WorldSetup>(
      "world", "The synthetic world: x runs east from 0, z south from 0, y up. It has no place on Earth.",
      {
          pair(&WorldSetup::size_x_m, &WorldSetup::size_z_m, {.key = "size", .doc = "Extent along x and z; 0 takes the terrain file's.", .hard = {0, 1e6}, .unit = Unit::metre}),
          field(&WorldSetup::sea_level_m, {.key = "sea_level", .doc = "Height of the sea; ground below it is under water.", .hard = {-20000, 20000}, .unit = Unit::metre}),
          object(&WorldSetup::terrain, terrainTable(), {.key = "terrain", .doc = "The ground."}),
          object(&WorldSetup::weather, weatherTable(), {.key = "weather", .doc = "The air."}),
      });
  return table;
}

const Struct& fdcTable() {
  static const Struct table = structOf<FdcSetup>(
      "fdc", "The fire direction centre, and the thesis's own ways of 1993 as legacy modes.",
      {
          field(&FdcSetup::trajectory, {.key = "trajectory", .doc = "auto takes the low trajectory and, where the ground masks it, the high one; low and high force one even into a hill."}),
          field(&FdcSetup::solver, {.key = "solver", .doc = "root finds the elevation that hits; table looks it up in steps of range as in 1993."}),
          field(&FdcSetup::table_step_m, {.key = "table_step", .doc = "Step of range of the solver table.", .hard = {1, 5000}, .unit = Unit::metre, .idle = idleIn<FdcSetup, withoutTable>}),
          field(&FdcSetup::lead, {.key = "lead", .doc = "Whether guns aim where a moving target will be when the shells land."}),
          field(&FdcSetup::absolute_relay, {.key = "absolute_relay", .doc = "As in 1993: lay again on where the target is now instead of correcting from the last burst."}),
          field(&FdcSetup::sampled_visibility, {.key = "sampled_visibility", .doc = "As in 1993: line of sight by at most 100 samples of the ground, 40 m apart or farther, between which narrow ridges slip through."}),
          field(&FdcSetup::misunderstanding, {.key = "misunderstanding", .doc = "Probability that a message is misheard (digits swapped, left for right, lost).", .hard = {0, 1}, .unit = Unit::fraction}),
          field(&FdcSetup::read_back, {.key = "read_back", .doc = "Probability that reading a misheard message back catches the fault.", .hard = {0, 1}, .unit = Unit::fraction, .idle = idleIn<FdcSetup, withoutMistakes>}),
          field(&FdcSetup::lay_error, {.key = "lay_error", .doc = "Probability that a gun is laid 10 or 100 mil off.", .hard = {0, 1}, .unit = Unit::fraction}),
          field(&FdcSetup::danger_close_m, {.key = "danger_close", .doc = "Distance of friendly vehicles from the target within which a mission counts as danger close.", .hard = {0, 5000}, .unit = Unit::metre}),
      });
  return table;
}

}  // namespace npsee::world
