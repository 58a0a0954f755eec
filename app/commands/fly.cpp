#include "app/commands/command.h"
#include "app/commands/shot_options.h"

#include "sim/core/files.h"
#include "sim/core/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace npsee::commands {
namespace {

using nlohmann::ordered_json;

struct FlyOptions {
  ShotOptions shot;
  std::string elevation, step = "0.5", csv;
  bool want_csv = false, json = false;
};

ordered_json flightJson(const Firing& firing, const Shot& shot, const Flight& f) {
  const bool hit = f.end == FlightEnd::impact;
  const auto ifHit = [&](double value) { return hit ? ordered_json(value) : ordered_json(nullptr); };
  ordered_json out;
  out["projectile"] = firing.projectile.name;
  if (!firing.charge.name.empty()) out["charge"] = firing.charge.name;
  out["muzzle_velocity_mps"] = shot.speed_mps;
  out["elevation_rad"] = shot.elevation_rad;
  out["azimuth_rad"] = shot.azimuth_rad;
  out["model"] = flightModelNames()[static_cast<std::size_t>(firing.model)];
  out["integrator"] = integratorNames()[static_cast<std::size_t>(firing.integration.integrator)];
  out["factors"] = {{"form", shot.factors.form}, {"lift", shot.factors.lift}, {"magnus", shot.factors.magnus}, {"yaw_drag", shot.factors.yaw_drag}};
  out["impact"] = hit;
  out["range_m"] = ifHit(f.range_m);
  out["drift_m"] = ifHit(f.drift_m);
  out["height_m"] = ifHit(f.height_m);
  out["time_of_flight_s"] = ifHit(f.time_of_flight_s);
  out["max_ordinate_m"] = f.max_ordinate_m;
  out["apex_time_s"] = f.apex_time_s;
  out["apex_range_m"] = f.apex_range_m;
  out["impact_speed_mps"] = ifHit(f.impact_speed_mps);
  out["angle_of_fall_rad"] = ifHit(f.angle_of_fall_rad);
  out["spin_muzzle_radps"] = f.spin_muzzle_radps;
  out["spin_impact_radps"] = ifHit(f.spin_impact_radps);
  out["yaw_max_rad"] = f.yaw_max_rad;
  out["valid"] = f.valid();
  out["doubts"] = doubtTexts(f, firing.projectile);
  out["evaluations"] = f.evaluations;
  out["steps"] = f.steps;
  return out;
}

std::string angleText(double rad) { return withDecimals(rad * 3200.0 / kPi, 1) + " mil (" + withDecimals(rad * 180.0 / kPi, 2) + " deg)"; }

std::string summary(const Firing& firing, const Shot& shot, const Flight& f) {
  std::string out = describe(firing);
  const auto row = [&](const char* label, const std::string& value) { out += "  " + std::string(label) + std::string(20 - std::string_view(label).size(), ' ') + value + '\n'; };
  row("elevation", angleText(shot.elevation_rad));
  row("range", withDecimals(f.range_m, 1) + " m");
  row("drift", withDecimals(f.drift_m, 1) + " m to the right");
  row("time of flight", withDecimals(f.time_of_flight_s, 2) + " s");
  row("maximum ordinate", withDecimals(f.max_ordinate_m, 1) + " m at " + withDecimals(f.apex_time_s, 2) + " s, " + withDecimals(f.apex_range_m, 1) + " m");
  row("angle of fall", angleText(f.angle_of_fall_rad));
  row("impact speed", withDecimals(f.impact_speed_mps, 1) + " m/s");
  row("spin", withDecimals(f.spin_muzzle_radps, 1) + " rad/s at the muzzle, " + withDecimals(f.spin_impact_radps, 1) + " at the impact");
  row("greatest yaw", withDecimals(f.yaw_max_rad * 180.0 / kPi, 2) + " deg");
  row("evaluations", std::to_string(f.evaluations) + " in " + std::to_string(f.steps) + " steps");
  const auto doubts = doubtTexts(f, firing.projectile);
  row("valid", doubts.empty() ? "yes" : "NO: " + doubts.front());
  for (std::size_t i = 1; i < doubts.size(); ++i) row("", doubts[i]);
  return out;
}

Expected<std::string> csvOf(const FlightPath& trajectory, const std::string& step_text) {
  const auto step = parseOption("--step", step_text, Unit::second);
  if (!step) return tl::unexpected<Error>(step.error());
  const Flight& flight = trajectory.flight();
  const auto nodes = trajectory.nodes();
  const double end = flight.end == FlightEnd::impact ? flight.time_of_flight_s : nodes.empty() ? 0.0 : nodes.back().start_s + nodes.back().step_s;
  if (!(*step > 0.0) || end / *step > 1e6) return fail(ErrorKind::usage, "--step " + step_text + ": the path would have " + (*step > 0.0 ? "more than a million" : "no end of") + " rows.", "Choose a longer step, e.g. --step 0.1.");
  std::string out = "t_s,range_m,height_m,drift_m,v_range_mps,v_up_mps,v_right_mps,speed_mps,spin_radps\n";
  const auto count = static_cast<long>(std::ceil(end / *step - 1e-9));
  for (long i = 0; i <= count; ++i) {
    const double t = std::min(end, static_cast<double>(i) * *step);
    const FlightPath::State s = trajectory.at(t);
    const double values[] = {t, s.position_m.x, s.position_m.y, s.position_m.z, s.velocity_mps.x, s.velocity_mps.y, s.velocity_mps.z, length(s.velocity_mps), s.spin_radps};
    for (const double& value : values) out += (&value == values ? "" : ",") + shortest(value);
    out += '\n';
  }
  return out;
}

int fly(const FlyOptions& options) {
  const auto firing = resolve(options.shot);
  if (!firing) return report(firing.error());
  if (options.elevation.empty()) return report(fail(ErrorKind::usage, "no elevation is given.", "Give it with --qe, e.g. --qe 533mil or --qe 30deg; `npsee aim` finds one for a range.").value());
  const auto elevation = parseOption("--qe", options.elevation, Unit::mil);
  if (!elevation) return report(elevation.error());
  const auto ballistics = firing->ballistics();
  if (!ballistics) return report(ballistics.error());
  const Shot shot = firing->shot(*elevation);
  if (const auto possible = ballistics->checkShot(shot); !possible) return report(possible.error());

  const FlightPath trajectory = ballistics->path(shot);
  const Flight& flight = trajectory.flight();
  const bool csv_only = options.want_csv && (options.csv.empty() || options.csv == "-");
  if (options.want_csv) {
    const auto csv = csvOf(trajectory, options.step);
    if (!csv) return report(csv.error());
    if (csv_only) {
      if (const int code = writeResult(*csv); code != 0) return code;
    } else if (const auto written = writeFileAtomically(options.csv, *csv); !written) {
      return report(written.error());
    }
  }
  if (options.json && !csv_only) {
    if (const int code = writeResult(flightJson(*firing, shot, flight).dump(2) + '\n'); code != 0) return code;
  }
  if (flight.end != FlightEnd::impact) {
    report(fail(ErrorKind::usage, "the shell never comes down on a surface " + shortest(firing->conditions.target_height_m) + " m above the muzzle (summit " + withDecimals(flight.max_ordinate_m, 1) + " m).",
                "Raise the elevation, or lower the target with --height-of-target.").value());
    return 1;
  }
  if (!options.json && !csv_only) return writeResult(summary(*firing, shot, flight));
  return 0;
}

}  // namespace

void addFly(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<FlyOptions>();
  CLI::App* command = app.add_subcommand("fly", "Fly one trajectory: range, drift, time, summit, angle of fall; exit 1 if it never comes down");
  command->add_option("--qe", options->elevation, "Quadrant elevation, mil (also 30deg, 0.5rad)")->type_name("ANGLE");
  CLI::Option* csv = command->add_option("--csv", options->csv, "The path as CSV, to FILE or, without one, to standard output")->type_name("[FILE]")->expected(0, 1);
  command->add_option("--step", options->step, "Time between rows of the CSV, s (default 0.5)")->type_name("S");
  command->add_flag("--json", options->json, "Print the result as one JSON object");
  addShotOptions(*command, options->shot);
  command->footer(
      "Examples:\n  npsee fly --charge 7W --qe 533mil\n  npsee fly --projectile m33 --charge service --qe 2deg --wind 0,0,5 --json\n"
      "  npsee fly --mass 43.09 --diameter 0.155 --cd 0.3 --atmosphere constant:1.225 --v0 568 --qe 30deg --csv --step 1");
  command->callback([options, csv, &outcome] {
    options->want_csv = csv->count() > 0;
    outcome.exit_code = fly(*options);
  });
}

}  // namespace npsee::commands
