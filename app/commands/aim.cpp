#include "app/commands/command.h"
#include "app/commands/shot_options.h"

#include <npsee/aiming.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace npsee::commands {
namespace {

using nlohmann::ordered_json;

struct AimOptions {
  ShotOptions shot;
  std::string range, solution = "both", legacy;
  bool use_legacy = false, json = false;
};

struct Found {
  const char* branch;
  std::optional<AimSolution> solution;
};

ordered_json solutionJson(const Found& found, const Projectile& projectile) {
  const AimSolution& s = *found.solution;
  return {{"branch", found.branch},
          {"elevation_rad", s.shot.elevation_rad},
          {"elevation_mil", s.shot.elevation_rad * 3200.0 / kPi},
          {"azimuth_rad", s.shot.azimuth_rad},
          {"azimuth_correction_rad", s.azimuth_correction_rad},
          {"azimuth_correction_mil", s.azimuth_correction_rad * 3200.0 / kPi},
          {"miss_m", s.miss_m},
          {"time_of_flight_s", s.flight.time_of_flight_s},
          {"max_ordinate_m", s.flight.max_ordinate_m},
          {"angle_of_fall_rad", s.flight.angle_of_fall_rad},
          {"impact_speed_mps", s.flight.impact_speed_mps},
          {"valid", s.flight.valid()},
          {"doubts", doubtTexts(s.flight, projectile)}};
}

std::string solutionText(const Found& found, const Projectile& projectile) {
  const std::string label = std::string("  ") + found.branch + (found.branch[0] == 'l' ? "   " : "  ");
  if (!found.solution) return label + "none: this branch does not reach so near\n";
  const AimSolution& s = *found.solution;
  const double correction = s.azimuth_correction_rad * 3200.0 / kPi;
  std::string out = label + "elevation " + fixed(s.shot.elevation_rad * 3200.0 / kPi, 2) + " mil (" + fixed(s.shot.elevation_rad * 180.0 / kPi, 3) + " deg), azimuth " + fixed(correction < 0 ? -correction : correction, 2) +
                    " mil " + (correction < 0 ? "left" : "right") + ", " + fixed(s.flight.time_of_flight_s, 1) + " s, summit " + fixed(s.flight.max_ordinate_m, 0) + " m, angle of fall " +
                    fixed(s.flight.angle_of_fall_rad * 3200.0 / kPi, 0) + " mil, miss " + fixed(s.miss_m, 2) + " m\n";
  for (const std::string& doubt : doubtTexts(s.flight, projectile)) out += "        NOT VALID: " + doubt + '\n';
  return out;
}

int aim(const AimOptions& options) {
  const auto firing = resolve(options.shot);
  if (!firing) return report(firing.error());
  if (options.solution != "low" && options.solution != "high" && options.solution != "both")
    return report(fail(ErrorKind::usage, "--solution: there is no \"" + options.solution + "\".", "It is low, high or both.").value());
  if (options.range.empty()) return report(fail(ErrorKind::usage, "no range is given.", "Give the horizontal distance to the target with --range, e.g. --range 5000.").value());
  auto range = parseOption("--range", options.range, Unit::metre);
  if (!range) return report(range.error());
  const double wanted = *range;
  if (options.use_legacy) {
    const auto step = parseOption("--legacy-step", options.legacy.empty() ? shortest(kLegacyRangeStep_m) : options.legacy, Unit::metre);
    if (!step) return report(step.error());
    if (!(*step >= 1.0 && *step <= 10000.0)) return report(fail(ErrorKind::usage, "--legacy-step " + options.legacy + ": the step lies between 1 and 10000 m.").value());
    *range = legacyRange(wanted, *step);
  }
  const auto ballistics = firing->ballistics();
  if (!ballistics) return report(ballistics.error());
  AimRequest request;
  request.speed_mps = firing->charge.speed_mps;
  request.factors = firing->charge.factors;
  if (firing->fixed_factors) request.factors = FactorCurves{0.0, 0.0, {firing->factors.form}, {firing->factors.lift}, {firing->factors.magnus}, {firing->factors.yaw_drag}, {}};
  request.azimuth_rad = firing->azimuth_rad;
  request.wind_mps = firing->wind_mps;
  request.height_m = firing->conditions.target_height_m;
  const auto aimer = Aimer::make(*ballistics, request);
  if (!aimer) return report(aimer.error());

  const auto reach = aimer->checkReach(*range);
  std::vector<Found> found;
  if (reach && options.solution != "high") found.push_back({"low", aimer->low(*range)});
  if (reach && options.solution != "low") found.push_back({"high", aimer->high(*range)});
  bool any = false;
  for (Found& f : found) {
    // Laid for a step of the table, the shell falls where the table says and not on the target.
    if (f.solution) f.solution->miss_m += options.use_legacy ? std::abs(wanted - *range) : 0.0;
    any = any || f.solution.has_value();
  }

  std::string text;
  if (options.json) {
    ordered_json out{{"range_m", wanted}, {"laid_range_m", *range}, {"reachable", static_cast<bool>(reach)}, {"max_range_m", aimer->maxRange()}, {"max_range_elevation_rad", aimer->maxRangeElevation()}, {"solutions", ordered_json::array()}};
    for (const Found& f : found)
      if (f.solution) out["solutions"].push_back(solutionJson(f, firing->projectile));
    text = out.dump(2) + '\n';
  } else if (reach) {
    text = describe(*firing) + "  range " + fixed(wanted, 1) + " m" + (options.use_legacy ? ", laid for " + fixed(*range, 1) + " m" : "") + "; the maximum is " + fixed(aimer->maxRange(), 1) + " m at " +
           fixed(aimer->maxRangeElevation() * 3200.0 / kPi, 1) + " mil\n";
    for (const Found& f : found) text += solutionText(f, firing->projectile);
  }
  if (const int code = text.empty() ? 0 : writeResult(text); code != 0) return code;
  if (reach) return any ? 0 : 1;
  const int code = report(reach.error());
  // Out of reach is an answer; a range below zero is a mistake.
  return *range > 0.0 ? 1 : code;
}

}  // namespace

void addAim(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<AimOptions>();
  CLI::App* command = app.add_subcommand("aim", "Find the elevations for a range: low and high solution, azimuth against drift; exit 1 out of reach");
  command->add_option("--range", options->range, "Horizontal distance to the target, m (also 5km)")->type_name("M");
  command->add_option("--solution", options->solution, "low, high or both (default)")->type_name("WHICH");
  CLI::Option* legacy = command->add_option("--legacy-step", options->legacy, "Lay only for multiples of this range, as the thesis's table did (250 m without a number)")->type_name("[M]")->expected(0, 1);
  command->add_flag("--json", options->json, "Print the result as one JSON object");
  addShotOptions(*command, options->shot);
  command->footer(
      "--azimuth is the bearing of the target here, and --wind is along the line to it.\n"
      "Examples:\n  npsee aim --charge 7W --range 10000\n  npsee aim --charge 3W --range 5km --height-of-target 120 --wind 0,0,8 --solution high --json");
  command->callback([options, legacy, &outcome] {
    options->use_legacy = legacy->count() > 0;
    outcome.exit_code = aim(*options);
  });
}

}  // namespace npsee::commands
