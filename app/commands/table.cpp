#include "app/commands/command.h"
#include "app/commands/shot_options.h"
#include "sim/core/text.h"

#include <npsee/aiming.h>
#include <npsee/firing_table.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace npsee::commands {
namespace {

using nlohmann::ordered_json;

struct TableOptions {
  ShotOptions shot;
  std::string elevations, ranges, solution = "low", format = "text";
  bool thesis = false, json = false, csv = false;
};

/// A column: heading in text, key in CSV and JSON, decimals in text. Cells are numbers, texts or nothing.
struct Column {
  const char* heading;
  const char* key;
  int decimals;
};
using Row = std::vector<ordered_json>;

std::string cellText(const ordered_json& cell, int decimals, const char* missing) {
  if (cell.is_null()) return missing;
  if (cell.is_string()) return cell.get<std::string>();
  if (cell.is_boolean()) return cell.get<bool>() ? "yes" : "NO";
  return decimals < 0 ? shortest(cell.get<double>()) : withDecimals(cell.get<double>(), decimals);
}

std::string asText(const std::vector<Column>& columns, const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> cells;
  std::vector<std::size_t> widths;
  widths.reserve(columns.size());
  for (const Column& column : columns) widths.push_back(std::string_view(column.heading).size());
  for (const Row& row : rows) {
    cells.emplace_back();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      cells.back().push_back(cellText(row[c], columns[c].decimals, "-"));
      widths[c] = std::max(widths[c], cells.back()[c].size());
    }
  }
  std::string out;
  const auto line = [&](const auto& cell) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::string text = cell(c);
      out += (c > 0 ? "  " : "") + std::string(widths[c] - text.size(), ' ') + text;
    }
    out += '\n';
  };
  line([&](std::size_t c) { return std::string(columns[c].heading); });
  for (const auto& row : cells) line([&](std::size_t c) { return row[c]; });
  return out;
}

std::string asCsv(const std::vector<Column>& columns, const std::vector<Row>& rows) {
  std::string out;
  for (const Column& column : columns) out += (out.empty() ? "" : ",") + std::string(column.key);
  out += '\n';
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < columns.size(); ++c) out += (c > 0 ? "," : "") + (row[c].is_boolean() ? std::string(row[c].get<bool>() ? "true" : "false") : cellText(row[c], -1, ""));
    out += '\n';
  }
  return out;
}

ordered_json asJson(const std::vector<Column>& columns, const std::vector<Row>& rows) {
  ordered_json out = ordered_json::array();
  for (const Row& row : rows) {
    ordered_json object;
    for (std::size_t c = 0; c < columns.size(); ++c) object[columns[c].key] = row[c];
    out.push_back(std::move(object));
  }
  return out;
}

int print(const std::string& format, const std::string& title, const std::vector<Column>& columns, const std::vector<Row>& rows, const std::string& footer = {}) {
  if (format == "csv") return writeResult(asCsv(columns, rows));
  if (format == "json") return writeResult(ordered_json{{"title", title}, {"rows", asJson(columns, rows)}}.dump(2) + '\n');
  return writeResult(title + '\n' + asText(columns, rows) + footer);
}

const std::vector<Column> kFlightColumns = {{"QE mil", "elevation_mil", 1},        {"range m", "range_m", 1},         {"drift m", "drift_m", 1},
                                            {"time s", "time_of_flight_s", 2},     {"summit m", "max_ordinate_m", 1}, {"fall mil", "angle_of_fall_mil", 1},
                                            {"impact m/s", "impact_speed_mps", 1}, {"yaw deg", "yaw_max_deg", 2},     {"valid", "valid", 0}};

Row flightRow(double elevation_rad, const Flight& f) {
  constexpr double kMil = 3200.0 / kPi;
  if (f.end != FlightEnd::impact) return {elevation_rad * kMil, nullptr, nullptr, nullptr, f.max_ordinate_m, nullptr, nullptr, nullptr, false};
  return {elevation_rad * kMil, f.range_m, f.drift_m, f.time_of_flight_s, f.max_ordinate_m, f.angle_of_fall_rad * kMil, f.impact_speed_mps, f.yaw_max_rad * 180.0 / kPi, f.valid()};
}

int elevationTable(const TableOptions& options, const Firing& firing) {
  const auto elevations = parseSteps("--qe", options.elevations.empty() ? "100:1100:100" : options.elevations, Unit::mil);
  if (!elevations) return report(elevations.error());
  const auto ballistics = firing.ballistics();
  if (!ballistics) return report(ballistics.error());
  std::vector<Shot> shots;
  for (const double elevation : *elevations) {
    shots.push_back(firing.shot(elevation));
    if (const auto possible = ballistics->checkShot(shots.back()); !possible) return report(possible.error());
  }
  std::vector<Flight> flights(shots.size());
  ballistics->flyMany(shots, flights);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < shots.size(); ++i) rows.push_back(flightRow(shots[i].elevation_rad, flights[i]));
  return print(options.format, describe(firing), kFlightColumns, rows);
}

int rangeTable(const TableOptions& options, const Firing& firing) {
  const auto ranges = parseSteps("--range", options.ranges, Unit::metre);
  if (!ranges) return report(ranges.error());
  const auto ballistics = firing.ballistics();
  if (!ballistics) return report(ballistics.error());
  const auto aimer = Aimer::make(*ballistics, firing.aimRequest());
  if (!aimer) return report(aimer.error());
  std::vector<Column> columns = {{"target m", "target_range_m", 1}, {"azimuth mil", "azimuth_correction_mil", 2}};
  columns.insert(columns.end(), kFlightColumns.begin(), kFlightColumns.end());
  std::vector<Row> rows;
  bool beyond = false;
  for (const double range : *ranges) {
    const auto solution = options.solution == "high" ? aimer->high(range) : aimer->low(range);
    Row row{range, nullptr};
    if (solution) {
      row[1] = solution->azimuth_correction_rad * 3200.0 / kPi;
      for (ordered_json& cell : flightRow(solution->shot.elevation_rad, solution->flight)) row.push_back(std::move(cell));
    } else {
      row.resize(columns.size());
    }
    beyond = beyond || range > aimer->maxRange();
    rows.push_back(std::move(row));
  }
  std::string footer = "the maximum range is " + withDecimals(aimer->maxRange(), 1) + " m at " + withDecimals(aimer->maxRangeElevation() * 3200.0 / kPi, 1) + " mil\n";
  return print(options.format, describe(firing) + (options.solution == "high" ? "high" : "low") + " solutions", columns, rows, footer);
}

/// Range and deflection as the thesis prints an impact.
std::string impact(double range_m, double deflection_m) { return withDecimals(range_m, 0) + " / " + withDecimals(deflection_m, 1); }

/// A row of the thesis beside our three flights.
struct Comparison {
  const ThesisRow& row;
  Flight vacuum, unfitted, fitted;

  double ceps(const Flight& f) const { return errorInCeps(row, f.range_m, f.drift_m); }
  double ceps(const PublishedImpact& p) const { return errorInCeps(row, p.range_m, p.deflection_m); }
};

Row comparisonText(const Comparison& c) {
  Row out{c.row.charge, c.row.elevation_rad * 3200.0 / kPi, c.row.cep_m, impact(c.row.firing_table.range_m, c.row.firing_table.deflection_m)};
  const auto published = [&](const PublishedImpact& p) { out.insert(out.end(), {impact(p.range_m, p.deflection_m), c.ceps(p)}); };
  const auto flown = [&](const Flight& f) { out.insert(out.end(), {impact(f.range_m, f.drift_m), c.ceps(f)}); };
  published(c.row.thesis_vacuum);
  flown(c.vacuum);
  published(c.row.thesis_model);
  flown(c.unfitted);
  flown(c.fitted);
  return out;
}

Row comparisonNumbers(const Comparison& c) {
  Row out{c.row.charge, c.row.elevation_rad * 3200.0 / kPi, c.row.cep_m, c.row.firing_table.range_m, c.row.firing_table.deflection_m};
  const auto published = [&](const PublishedImpact& p) { out.insert(out.end(), {p.range_m, p.deflection_m, c.ceps(p)}); };
  const auto flown = [&](const Flight& f) { out.insert(out.end(), {f.range_m, f.drift_m, c.ceps(f)}); };
  published(c.row.thesis_vacuum);
  flown(c.vacuum);
  published(c.row.thesis_model);
  flown(c.unfitted);
  flown(c.fitted);
  return out;
}

const std::vector<Column> kThesisText = {{"charge", "", 0},       {"QE mil", "", 2}, {"CEP m", "", 2},        {"firing table", "", 0}, {"thesis vacuum", "", 0}, {"CEPs", "", 1}, {"our vacuum", "", 0},
                                         {"CEPs", "", 1},         {"thesis model", "", 0}, {"CEPs", "", 2},   {"unfitted", "", 0},     {"CEPs", "", 2},          {"fitted", "", 0}, {"CEPs", "", 2}};
const std::vector<Column> kThesisNumbers = {{"", "charge", 0},
                                            {"", "elevation_mil", 2},
                                            {"", "cep_m", 2},
                                            {"", "firing_table_range_m", 1},
                                            {"", "firing_table_deflection_m", 1},
                                            {"", "thesis_vacuum_range_m", 1},
                                            {"", "thesis_vacuum_deflection_m", 1},
                                            {"", "thesis_vacuum_ceps", 2},
                                            {"", "vacuum_range_m", 1},
                                            {"", "vacuum_deflection_m", 1},
                                            {"", "vacuum_ceps", 2},
                                            {"", "thesis_model_range_m", 1},
                                            {"", "thesis_model_deflection_m", 1},
                                            {"", "thesis_model_ceps", 2},
                                            {"", "unfitted_range_m", 1},
                                            {"", "unfitted_deflection_m", 1},
                                            {"", "unfitted_ceps", 2},
                                            {"", "fitted_range_m", 1},
                                            {"", "fitted_deflection_m", 1},
                                            {"", "fitted_ceps", 2}};

int thesisTable(const TableOptions& options) {
  const auto tables = thesisTables();
  if (!tables) return report(tables.error());
  TableOptions mine = options;
  if (mine.shot.projectile.empty()) mine.shot.projectile = tables->projectile;
  const auto firing = resolve(mine.shot, false);
  if (!firing) return report(firing.error());
  const auto ballistics = firing->ballistics(), vacuum = Ballistics::make(firing->projectile, firing->conditions, FlightModel::vacuum, firing->integration);
  if (!ballistics) return report(ballistics.error());
  if (!vacuum) return report(vacuum.error());

  std::vector<Row> rows;
  double worst_unfitted = 0.0, worst_fitted = 0.0;
  for (const ThesisRow& row : tables->rows) {
    const auto charge = findCharge(firing->projectile, row.charge);
    if (!charge) return report(charge.error());
    Firing fitted = *firing, plain = *firing;
    fitted.charge = plain.charge = *charge;
    plain.charge.factors = {};
    plain.fixed_factors = false;
    const Shot shot = plain.shot(row.elevation_rad);
    const Comparison c{row, vacuum->fly(shot), ballistics->fly(shot), ballistics->fly(fitted.shot(row.elevation_rad))};
    worst_unfitted = std::max(worst_unfitted, c.ceps(c.unfitted));
    worst_fitted = std::max(worst_fitted, c.ceps(c.fitted));
    rows.push_back(options.format == "text" ? comparisonText(c) : comparisonNumbers(c));
  }
  if (options.format != "text") return print(options.format, tables->title, kThesisNumbers, rows);
  return print("text", tables->title + "\nimpacts as range / deflection in m; errors in CEPs, hypot(range error, deflection error) / CEP\n", kThesisText, rows,
               "worst row: unfitted " + withDecimals(worst_unfitted, 2) + " CEPs, fitted " + withDecimals(worst_fitted, 2) + " CEPs\n");
}

int table(TableOptions options) {
  if (options.json) options.format = "json";
  if (options.csv) options.format = "csv";
  if (options.format != "text" && options.format != "csv" && options.format != "json") return report(fail(ErrorKind::usage, "--format: there is no \"" + options.format + "\".", "It is text, csv or json.").value());
  if (options.solution != "low" && options.solution != "high") return report(fail(ErrorKind::usage, "--solution: there is no \"" + options.solution + "\".", "It is low or high.").value());
  if (!options.elevations.empty() && !options.ranges.empty()) return report(fail(ErrorKind::usage, "--qe and --range both say what the rows are.", "Keep one of them.").value());
  if (options.thesis) return thesisTable(options);
  const auto firing = resolve(options.shot);
  if (!firing) return report(firing.error());
  return options.ranges.empty() ? elevationTable(options, *firing) : rangeTable(options, *firing);
}

}  // namespace

void addTable(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<TableOptions>();
  CLI::App* command = app.add_subcommand("table", "A firing table over elevations or ranges; --thesis compares with the thesis's tables 1 and 2");
  command->add_option("--qe", options->elevations, "Rows by elevation, mil (default 100:1100:100)")->type_name("FROM:TO:STEP");
  command->add_option("--range", options->ranges, "Rows by range, m")->type_name("FROM:TO:STEP");
  command->add_option("--solution", options->solution, "With --range: low (default) or high")->type_name("WHICH");
  command->add_option("--format", options->format, "text (default), csv or json")->type_name("FORMAT");
  command->add_flag("--csv", options->csv, "The same as --format csv");
  command->add_flag("--json", options->json, "The same as --format json");
  command->add_flag("--thesis", options->thesis, "The thesis's tables 1 and 2: firing table, thesis, vacuum, unfitted, fitted, each error in CEPs");
  addShotOptions(*command, options->shot);
  command->footer("Examples:\n  npsee table --charge 7W\n  npsee table --charge 3W --range 1000:7000:500 --csv\n  npsee table --thesis");
  command->callback([options, &outcome] { outcome.exit_code = table(*options); });
}

}  // namespace npsee::commands
