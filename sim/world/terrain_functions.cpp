#include "sim/world/terrain_grid.h"

#include "sim/core/text.h"

#include <cmath>
#include <cstdint>
#include <numeric>

namespace npsee::world {
namespace {

/// Functions of one coordinate are fine across and coarse along, at most this, m.
constexpr double kCoarse_m = 500.0;
/// Most columns across, and the finest lattice looked for, m.
constexpr int kMaxColumns = 65'536;
constexpr double kLattice_m = 0.01;

using Values = std::map<std::string, double, std::less<>>;

struct Param {
  std::string_view name;
  bool needed = true;
  double value = 0.0;  ///< where it may be left out
};

/// A function of the coordinate across only: straight pieces between bends.
struct Bend {
  double at, height;
};

struct Function {
  std::string_view name;
  std::vector<Param> params;
};

const std::vector<Function>& functions() {
  static const std::vector<Function> table{
      {"ridge", {{"crest"}, {"crest_height"}, {"foot_before"}, {"foot_after"}, {"base_height", false, 0.0}}},
      {"slope", {{"from"}, {"to"}, {"low", false, 0.0}, {"high"}}},
      {"step", {{"at"}, {"low", false, 0.0}, {"high"}, {"width", false, 1.0}}},
      {"plane", {{"height", false, 0.0}, {"slope_x", false, 0.0}, {"slope_z", false, 0.0}}},
      {"cone", {{"top_x"}, {"top_z"}, {"top_height"}, {"radius"}, {"base_height", false, 0.0}}},
  };
  return table;
}

/// A name in the file: the crest's says along which coordinate it is measured.
std::string fileName(std::string_view param, const std::string& axis) {
  if (param == "crest") return axis == "z" ? "crest_x" : "crest_z";
  return std::string(param);
}

Expected<Values> valuesOf(const Function& function, const TerrainSource& source) {
  Error error;
  Values values;
  std::vector<std::string> names;
  for (const Param& param : function.params) names.push_back(fileName(param.name, source.axis));
  const std::vector<std::string_view> known(names.begin(), names.end());
  for (const auto& [name, value] : source.params) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      const auto close = nearest(name, known);
      error.faults.push_back({"The terrain function " + std::string(function.name) + " has no parameter " + printable(name) + ".",
                              close ? "Did you mean " + std::string(*close) + "?" : "It has " + listed(known) + ".", {}, 0, {}});
    } else if (!(std::fabs(value) <= Terrain::kMaxSize_m)) {
      error.faults.push_back({"The terrain's " + printable(name) + " is " + shown(value) + "; it must lie within " + shown(Terrain::kMaxSize_m) + " of 0.", "Lower it.", {}, 0, {}});
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto given = source.params.find(names[i]);
    if (given == source.params.end() && function.params[i].needed)
      error.faults.push_back({"The terrain function " + std::string(function.name) + " lacks the parameter " + names[i] + ".", "Add it to params.", {}, 0, {}});
    values[std::string(function.params[i].name)] = given == source.params.end() ? function.params[i].value : given->second;
  }
  if (!error.faults.empty()) return tl::unexpected<Error>(std::move(error));
  return values;
}

tl::unexpected<Error> notPositive(const std::string& name, double value) {
  return fail(ErrorKind::input, "The terrain's " + name + " is " + shown(value) + " m; it must be above 0.", "A cliff is a very small distance, e.g. 1.");
}

Expected<std::vector<Bend>> bendsOf(std::string_view name, const Values& v) {
  const auto get = [&](std::string_view key) { return v.find(key)->second; };
  if (name == "ridge") {
    for (const char* foot : {"foot_before", "foot_after"})
      if (!(get(foot) > 0.0)) return notPositive(foot, get(foot));
    return std::vector<Bend>{{get("crest") - get("foot_before"), get("base_height")}, {get("crest"), get("crest_height")}, {get("crest") + get("foot_after"), get("base_height")}};
  }
  const bool ramp = name == "slope";
  const double width = ramp ? get("to") - get("from") : get("width");
  if (!(width > 0.0)) {
    if (!ramp) return notPositive("width", width);
    return fail(ErrorKind::input, "The terrain's slope ends at " + shown(get("to")) + " m, not beyond its start at " + shown(get("from")) + " m.", "Let `to` be larger than `from`; exchange `low` and `high` for a fall.");
  }
  const double from = ramp ? get("from") : get("at") - 0.5 * width;
  return std::vector<Bend>{{from, get("low")}, {from + width, get("high")}};
}

double heightAt(const std::vector<Bend>& bends, double at) {
  if (at <= bends.front().at) return bends.front().height;
  for (std::size_t i = 1; i < bends.size(); ++i) {
    if (at > bends[i].at) continue;
    const double share = (at - bends[i - 1].at) / (bends[i].at - bends[i - 1].at);
    return bends[i - 1].height + share * (bends[i].height - bends[i - 1].height);
  }
  return bends.back().height;
}

/// Whole lattice steps of a length, or 0 if it lies on no step.
std::int64_t stepsOf(double length) {
  const double steps = std::floor(length / kLattice_m + 0.5);
  return std::fabs(steps * kLattice_m - length) < 1e-6 ? static_cast<std::int64_t>(steps) : 0;
}

/// Cells across a world so that lines fall on every bend, as few as that needs but none longer than kCoarse_m.
int cellsAcross(const std::vector<Bend>& bends, double size) {
  std::int64_t common = stepsOf(size);
  for (const Bend& bend : bends) {
    if (bend.at <= 0.0 || bend.at >= size || common == 0) continue;
    const std::int64_t steps = stepsOf(bend.at);
    common = steps == 0 ? 0 : std::gcd(common, steps);
  }
  if (common == 0) return kMaxColumns - 1;
  const std::int64_t parts = stepsOf(size) / common;
  if (parts >= kMaxColumns) return kMaxColumns - 1;
  const double cell = static_cast<double>(common) * kLattice_m;
  return static_cast<int>(parts) * std::max(1, static_cast<int>(std::ceil(cell / kCoarse_m)));
}

Expected<Terrain::Grid> bentTerrain(const std::vector<Bend>& bends, const TerrainSource& source, double size_x, double size_z) {
  const bool along_z = source.axis == "z";
  const double across = along_z ? size_x : size_z, along = along_z ? size_z : size_x;
  const double cells_along = std::ceil(along / kCoarse_m);
  const double cells_across = source.cell_m > 0.0 ? std::max(1.0, std::floor(across / source.cell_m + 0.5)) : cellsAcross(bends, across);
  auto grid = along_z ? emptyGrid(size_x, size_z, cells_across + 1, cells_along + 1) : emptyGrid(size_x, size_z, cells_along + 1, cells_across + 1);
  if (!grid) return grid;
  for (int r = 0; r < grid->rows; ++r)
    for (int c = 0; c < grid->columns; ++c) grid->row(r)[c] = static_cast<float>(heightAt(bends, along_z ? c * grid->cell_x : r * grid->cell_z));
  return grid;
}

Expected<Terrain::Grid> planeTerrain(const Values& v, double size_x, double size_z) {
  auto grid = emptyGridOfCells(size_x, size_z, kCoarse_m, kCoarse_m);
  if (!grid) return grid;
  for (int r = 0; r < grid->rows; ++r)
    for (int c = 0; c < grid->columns; ++c)
      grid->row(r)[c] = static_cast<float>(v.at("height") + v.at("slope_x") * (c * grid->cell_x) + v.at("slope_z") * (r * grid->cell_z));
  return grid;
}

Expected<Terrain::Grid> coneTerrain(const Values& v, const TerrainSource& source, double size_x, double size_z) {
  const double radius = v.at("radius"), base = v.at("base_height"), rise = v.at("top_height") - base;
  if (!(radius > 0.0)) return notPositive("radius", radius);
  const double chosen = std::max(std::max(size_x, size_z) / 2000.0, std::min(30.0, radius / 32.0));
  const double cell = source.cell_m > 0.0 ? source.cell_m : chosen;
  auto grid = emptyGridOfCells(size_x, size_z, cell, cell);
  if (!grid) return grid;
  for (int r = 0; r < grid->rows; ++r) {
    const double dz = r * grid->cell_z - v.at("top_z");
    for (int c = 0; c < grid->columns; ++c) {
      const double dx = c * grid->cell_x - v.at("top_x");
      grid->row(r)[c] = static_cast<float>(base + rise * std::max(0.0, 1.0 - std::sqrt(dx * dx + dz * dz) / radius));
    }
  }
  return grid;
}

Expected<void> checkHeights(const Terrain::Grid& grid) {
  for (const float height : grid.heights)
    if (!(std::fabs(height) <= Terrain::kMaxHeight_m))
      return fail(ErrorKind::input, "The terrain function reaches a height of " + shown(height) + " m, beyond the limit of " + shown(Terrain::kMaxHeight_m) + " m.", "Lower its heights or slopes.");
  return {};
}

}  // namespace

Expected<Terrain::Grid> functionTerrain(const TerrainSource& source, double size_x, double size_z) {
  if (source.axis != "x" && source.axis != "z")
    return fail(ErrorKind::input, "The terrain's axis is " + printable(source.axis.empty() ? "empty" : source.axis) + "; it must be x or z.", "z lets a crest run north to south.");
  const std::vector<std::string_view> names = terrainFunctionNames();
  const auto& table = functions();
  const auto function = std::find_if(table.begin(), table.end(), [&](const Function& f) { return f.name == source.expression; });
  if (function == table.end()) {
    const auto close = nearest(source.expression, names);
    return fail(ErrorKind::input, "There is no terrain function " + printable(source.expression.empty() ? "without a name" : source.expression) + ".",
                close ? "Did you mean " + std::string(*close) + "?" : "Use " + listed(names) + ".");
  }
  const auto values = valuesOf(*function, source);
  if (!values) return tl::unexpected<Error>(values.error());

  Expected<Terrain::Grid> grid = Terrain::Grid{};
  if (function->name == "plane") {
    grid = planeTerrain(*values, size_x, size_z);
  } else if (function->name == "cone") {
    grid = coneTerrain(*values, source, size_x, size_z);
  } else {
    const auto bends = bendsOf(function->name, *values);
    if (!bends) return tl::unexpected<Error>(bends.error());
    grid = bentTerrain(*bends, source, size_x, size_z);
  }
  if (!grid) return grid;
  if (auto checked = checkHeights(*grid); !checked) return tl::unexpected<Error>(checked.error());
  return grid;
}

}  // namespace npsee::world

namespace npsee {

std::vector<std::string_view> terrainFunctionNames() {
  std::vector<std::string_view> out;
  for (const auto& function : world::functions()) out.push_back(function.name);
  return out;
}

}  // namespace npsee
