#include "app/commands/command.h"
#include "app/commands/shot_options.h"
#include "sim/core/text.h"

#include <npsee/aiming.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
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
  std::string out = label + "elevation " + withDecimals(s.shot.elevation_rad * 3200.0 / kPi, 2) + " mil (" + withDecimals(s.shot.elevation_rad * 180.0 / kPi, 3) + " deg), azimuth " + withDecimals(correction < 0 ? -correction : correction, 2) +
                    " mil " + (correction < 0 ? "left" : "right") + ", " + withDecimals(s.flight.time_of_flight_s, 1) + " s, summit " + withDecimals(s.flight.max_ordinate_m, 0) + " m, angle of fall " +
                    withDecimals(s.flight.angle_of_fall_rad * 3200.0 / kPi, 0) + " mil, miss " + withDecimals(s.miss_m, 2) + " m\n";
  for (const std::string& doubt : doubtTexts(s.flight, projectile)) out += "        NOT VALID: " + doubt + '\n';
  return out;
}

/// The distance to the target, and that the gun is laid for.
struct Ranges {
  double wanted_m = 0.0, laid_m = 0.0;
};

Expected<Ranges> rangesOf(const AimOptions& options) {
  if (options.solution != "low" && options.solution != "high" && options.solution != "both")
    return fail(ErrorKind::usage, "--solution: there is no \"" + options.solution + "\".", "It is low, high or both.");
  if (options.range.empty()) return fail(ErrorKind::usage, "no range is given.", "Give the horizontal distance to the target with --range, e.g. --range 5000.");
  const auto range = parseOption("--range", options.range, Unit::metre);
  if (!range) return tl::unexpected<Error>(range.error());
  if (!options.use_legacy) return Ranges{*range, *range};
  const auto step = parseOption("--legacy-step", options.legacy.empty() ? shortest(kLegacyRangeStep_m) : options.legacy, Unit::metre);
  if (!step) return tl::unexpected<Error>(step.error());
  if (!(*step >= 1.0 && *step <= 10000.0)) return fail(ErrorKind::usage, "--legacy-step " + options.legacy + ": the step lies between 1 and 10000 m.");
  return Ranges{*range, legacyRange(*range, *step)};
}

std::vector<Found> solutions(const Aimer& aimer, const AimOptions& options, const Ranges& ranges) {
  std::vector<Found> found;
  if (options.solution != "high") found.push_back({"low", aimer.low(ranges.laid_m)});
  if (options.solution != "low") found.push_back({"high", aimer.high(ranges.laid_m)});
  // Laid for a step of the table, the shell falls where the table says and not on the target.
  for (Found& f : found)
    if (f.solution && options.use_legacy) f.solution->miss_m += std::abs(ranges.wanted_m - ranges.laid_m);
  return found;
}

/// `aimer` is null where no elevation reaches the target's height.
std::string answerJson(const Aimer* aimer, const Ranges& ranges, bool reachable, const std::vector<Found>& found, const Projectile& projectile) {
  ordered_json out{{"range_m", ranges.wanted_m}, {"laid_range_m", ranges.laid_m}, {"reachable", reachable}, {"max_range_m", aimer != nullptr ? aimer->maxRange() : 0.0}, {"max_range_elevation_rad", aimer != nullptr ? aimer->maxRangeElevation() : 0.0}, {"solutions", ordered_json::array()}};
  for (const Found& f : found)
    if (f.solution) out["solutions"].push_back(solutionJson(f, projectile));
  return out.dump(2) + '\n';
}

std::string answerText(const Aimer& aimer, const Firing& firing, const Ranges& ranges, bool legacy, const std::vector<Found>& found) {
  std::string text = describe(firing) + "  range " + withDecimals(ranges.wanted_m, 1) + " m" + (legacy ? ", laid for " + withDecimals(ranges.laid_m, 1) + " m" : "") + "; the maximum is " + withDecimals(aimer.maxRange(), 1) + " m at " +
                     withDecimals(aimer.maxRangeElevation() * 3200.0 / kPi, 1) + " mil\n";
  for (const Found& f : found) text += solutionText(f, firing.projectile);
  return text;
}

int aim(const AimOptions& options) {
  const auto firing = resolve(options.shot);
  if (!firing) return report(firing.error());
  const auto ranges = rangesOf(options);
  if (!ranges) return report(ranges.error());
  const auto ballistics = firing->ballistics();
  if (!ballistics) return report(ballistics.error());
  if (const auto sound = Aimer::check(*ballistics, firing->aimRequest()); !sound) return report(sound.error());
  const auto aimer = Aimer::make(*ballistics, firing->aimRequest());
  if (!aimer) {
    // Higher than the shell flies is out of reach as well.
    if (options.json)
      if (const int code = writeResult(answerJson(nullptr, *ranges, false, {}, firing->projectile)); code != 0) return code;
    const int code = report(aimer.error());
    return ranges->laid_m > 0.0 ? 1 : code;
  }

  const auto reach = aimer->checkReach(ranges->laid_m);
  const std::vector<Found> found = reach ? solutions(*aimer, options, *ranges) : std::vector<Found>();
  if (options.json) {
    if (const int code = writeResult(answerJson(&*aimer, *ranges, static_cast<bool>(reach), found, firing->projectile)); code != 0) return code;
  } else if (reach) {
    if (const int code = writeResult(answerText(*aimer, *firing, *ranges, options.use_legacy, found)); code != 0) return code;
  }
  if (reach) return std::ranges::any_of(found, [](const Found& f) { return f.solution.has_value(); }) ? 0 : 1;
  const int code = report(reach.error());
  // Out of reach is an answer; a range below zero is a mistake.
  return ranges->laid_m > 0.0 ? 1 : code;
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
