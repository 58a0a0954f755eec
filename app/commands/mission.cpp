#include "app/commands/command.h"
#include "app/commands/mission_pictures.h"
#include "app/commands/mission_statistics.h"
#include "app/commands/shipped.h"
#include "sim/core/parallel.h"
#include "sim/world/scenario_files.h"

#include <npsee/mission.h>
#include <npsee/units.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

namespace npsee::commands {
namespace {

struct Options {
  std::string file, until, seed, record, format;  ///< empty = text
  std::vector<std::string> settings;
  bool expect = false, quiet = false;
  std::optional<int> monte_carlo, jobs;
  MissionPictureOptions pictures;
};

constexpr int kMaxRuns = 1'000'000;

Expected<Scenario> chosenScenario(const Options& options) {
  auto scenario = loadScenario(options.file);
  if (!scenario) return scenario;
  for (const std::string& setting : options.settings)
    if (auto applied = applySetting(*scenario, setting); !applied) return tl::unexpected(applied.error());
  if (!options.seed.empty()) {
    const char* end = options.seed.data() + options.seed.size();
    std::int64_t seed = 0;
    const auto read = std::from_chars(options.seed.data(), end, seed);
    if (read.ec != std::errc{} || read.ptr != end || seed < 0 || seed > (std::int64_t{1} << 53))
      return fail(ErrorKind::usage, "--seed " + options.seed + " is no whole number from 0 to 9007199254740992.");
    scenario->seed = seed;
  }
  if (auto faults = validate(*scenario); !faults.empty()) {
    for (Fault& fault : faults) fault.file = options.file;
    return tl::unexpected(Error{options.settings.empty() ? ErrorKind::input : ErrorKind::usage, std::move(faults)});
  }
  return scenario;
}

/// A broken file that the mission names is told before anything is simulated; an error while simulating is in the log.
int exitOf(const Recording& recording) {
  for (const MissionEvent& event : recording.events)
    if (event.kind == EventKind::error) {
      std::fprintf(stderr, "at %.2f s: %s\n", event.t_s, printable(event.text("text")).c_str());
      return exitCode(ErrorKind::input);
    }
  return 0;
}

/// What --set has changed is not at the lines of the file.
int reportSetUp(const Options& options, Error error) {
  if (options.settings.empty()) world::placeFaults(options.file, error.faults);
  return report(error);
}

int runOnce(const Options& options, const Scenario& scenario, std::optional<double> until, const MissionPicturePlan& pictures) {
  const auto recording = runMission(scenario, until);
  if (!recording) return reportSetUp(options, recording.error());
  // Whoever reads the log may go (`| head`), or the disk behind it be full: what was simulated is kept all the same.
  const int told = options.quiet ? 0 : writeResult(eventLog(*recording));
  if (!options.record.empty())
    if (auto saved = saveRecording(*recording, options.record); !saved) return report(saved.error());
  // The log is the result on stdout; pictures are named on stderr, as files written besides.
  std::vector<std::filesystem::path> written;
  const auto drawn = writeMissionPictures(pictures, *recording, written);
  for (const auto& file : written) std::fprintf(stderr, "%s\n", printable(file.string()).c_str());
  if (!drawn) return report(drawn.error());
  if (told != 0) return told;
  if (const int code = exitOf(*recording); code != 0) return code;
  if (!options.expect) return 0;
  const auto unmet = unmetExpectations(*recording);
  for (const std::string& sentence : unmet) std::fprintf(stderr, "%s\n", printable(sentence).c_str());
  if (unmet.empty()) std::fprintf(stderr, "All %zu expectations are met.\n", scenario.expect.size());
  return unmet.empty() ? 0 : 1;
}

/// Runs with seeds from the scenario's own upward, spread over threads; results stand by seed, so the table does not depend on them.
int runMany(const Options& options, const Scenario& scenario, std::optional<double> until) {
  const auto runs = static_cast<std::size_t>(*options.monte_carlo);
  std::vector<MissionOutcome> outcomes(runs);
  std::vector<std::optional<Error>> errors(runs);
  const int wanted = options.jobs.value_or(0);
  const int threads = wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  parallelFor(threads, runs, [&](std::size_t i) {
    Scenario one = scenario;
    one.seed += static_cast<std::int64_t>(i);
    const auto recording = runMission(one, until);
    if (recording) outcomes[i] = outcomeOf(*recording);
    else errors[i] = recording.error();
  });
  for (const auto& error : errors)
    if (error) return report(*error);
  if (const int code = writeResult(options.format == "json" ? statisticsJson(outcomes) : statisticsText(outcomes)); code != 0) return code;
  if (!options.expect) return 0;
  return std::all_of(outcomes.begin(), outcomes.end(), [](const MissionOutcome& o) { return o.expectations_met; }) ? 0 : 1;
}

/// What has no use without --monte-carlo, or with it, is refused: nothing that was asked for is left out without a word.
Expected<void> checkUse(const Options& options, const MissionPicturePlan& pictures) {
  if (!options.monte_carlo) {
    if (options.jobs) return fail(ErrorKind::usage, "--jobs is the number of threads of --monte-carlo, and one mission runs on one.", "Leave it out, or add --monte-carlo N.");
    if (!options.format.empty()) return fail(ErrorKind::usage, "--format " + options.format + " is that of the summary of --monte-carlo; a log is JSON lines.", "Leave it out, or add --monte-carlo N.");
    return {};
  }
  if (*options.monte_carlo < 1 || *options.monte_carlo > kMaxRuns) return fail(ErrorKind::usage, "--monte-carlo takes 1 to " + std::to_string(kMaxRuns) + " runs.");
  if (!pictures.renders.empty()) return fail(ErrorKind::usage, "--monte-carlo prints a summary of many runs and draws no pictures.", "Leave --render out, or run one seed with --seed.");
  if (!options.record.empty()) return fail(ErrorKind::usage, "--monte-carlo prints a summary of many runs and records none.", "Leave --record out, or run one seed with --seed.");
  return {};
}

int run(const Options& options) {
  std::optional<double> until;
  if (!options.until.empty()) {
    const auto time = parseQuantity(options.until, Unit::second);
    if (!time || *time < 0.0) return report({ErrorKind::usage, {{.what = "--until " + options.until + " is no time in seconds.", .remedy = "For example --until 120.", .file = {}, .line = 0, .pointer = {}}}});
    until = *time;
  }
  const auto pictures = planMissionPictures(options.pictures);
  if (!pictures) return report(pictures.error());
  if (auto sensible = checkUse(options, *pictures); !sensible) return report(sensible.error());
  const auto scenario = chosenScenario(options);
  if (!scenario) return report(scenario.error());
  return options.monte_carlo ? runMany(options, *scenario, until) : runOnce(options, *scenario, until, *pictures);
}

}  // namespace

void addMission(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("mission", "Run a fire mission without a display: the event log as JSON lines");
  acceptShipped(command->add_option("FILE", options->file, "Mission file (*.mission.json), or the name of a shipped one")->required(), kShippedMissions);
  command->add_option("--until", options->until, "Stop at this time of the mission, s")->type_name("T");
  command->add_option("--set", options->settings, "Change a value: PATH=VALUE, e.g. world.weather.visibility=800 or vehicles.t72-1.pos=25400,25000; repeatable")->allow_extra_args(false)->type_name("PATH=VALUE");
  command->add_option("--seed", options->seed, "Seed of the random draws, instead of the mission's own")->type_name("N");
  command->add_flag("--expect", options->expect, "Check the mission's `expect` clauses; exit 1 and name those that are not met");
  command->add_option("--record", options->record, "Write a recording, for `npsee replay`")->type_name("FILE");
  addMissionPictureOptions(*command, options->pictures);
  command->add_option("-o,--output", options->pictures.output, "PNG file of the picture; of several or a sequence with %04d where the number goes (else _0000 is added)")->type_name("OUT");
  command->add_option("--monte-carlo", options->monte_carlo, "Run with N seeds from the mission's own upward and print a summary instead of the log")->type_name("N");
  command->add_option("--jobs", options->jobs, "Threads of --monte-carlo; 0 = one per core")->check(CLI::Range(0, 1024))->type_name("N");
  command->add_option("--format", options->format, "Summary of --monte-carlo as text or json")->check(CLI::IsMember({"text", "json"}))->type_name("FORMAT");
  command->add_flag("--quiet", options->quiet, "Do not print the log");
  command->footer(std::string("Every line has t (s) and ev; the line `end` closes the log with its hash: same mission, seed and program, same hash.\n") +
                                    "A VIEW of --render is a list of key=value, separated by commas:\n" + std::string(render::missionRenderHelp()) +
                  "Examples:\n  npsee mission assets/missions/thesis_default.mission.json --expect\n"
                  "  npsee mission assets/missions/ridge_high_angle.mission.json --set fdc.trajectory=low --until 120\n"
                  "  npsee mission assets/missions/foggy_night.mission.json --monte-carlo 200\n"
                  "  npsee mission assets/missions/thesis_default.mission.json --quiet --render \"t=40,camera=observer\" -o seen.png\n"
                  "  npsee mission assets/missions/moving_column.mission.json --quiet --render \"camera=plan,show=rings\" --frames 0:60 --fps 10 -o frames/plan_%04d.png");
  command->callback([options, &outcome] { outcome.exit_code = run(*options); });
}

}  // namespace npsee::commands
