#include "app/commands/command.h"

#include "sim/core/file_kind.h"
#include "sim/core/files.h"
#include "sim/observer/mind.h"
#include "sim/world/scenario_files.h"

#include <npsee/explosion.h>
#include <npsee/mission.h>
#include <npsee/projectile.h>
#include <npsee/recording.h>
#include <npsee/weapons.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <system_error>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

bool named(const fs::path& file, std::string_view ending) { return file.string().ends_with(ending); }

/// Files meant by the arguments: files as they are, folders with all presets and missions below them, in name order.
Expected<std::vector<fs::path>> filesIn(const std::vector<std::string>& arguments) {
  std::vector<fs::path> out;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) {
      out.emplace_back(argument);
      continue;
    }
    std::vector<fs::path> found;
    for (auto entry = fs::recursive_directory_iterator(argument, fs::directory_options::skip_permission_denied, error); !error && entry != fs::end(entry); entry.increment(error))
      if (named(entry->path(), ".npsee.json") || named(entry->path(), ".mission.json")) found.push_back(entry->path());
    if (error) return fail(ErrorKind::input, argument + " cannot be read: " + error.message() + ".");
    if (found.empty()) return fail(ErrorKind::input, argument + " holds no *.npsee.json or *.mission.json file.", "Name a folder with presets or missions, or the files themselves.");
    std::ranges::sort(found);
    out.insert(out.end(), found.begin(), found.end());
  }
  return out;
}

Expected<void> readRules(const fs::path& file) {
  const auto text = readTextFile(file);
  if (!text) return tl::unexpected<Error>(text.error());
  auto faults = observer::checkRules(*text, file.string());
  if (faults.empty()) return {};
  return tl::unexpected(Error{ErrorKind::input, std::move(faults)});
}

/// Reads a mission with everything that it names, up to its first tick. Setting it up finds what no single value shows: weapons that are
/// not listed, a terrain that cannot be made, rules that do not load.
Expected<void> readMission(const fs::path& file) {
  const auto scenario = loadScenario(file);
  if (!scenario) return tl::unexpected(scenario.error());
  const auto mission = Mission::make(*scenario);
  if (mission) return {};
  Error error = mission.error();
  world::placeFaults(file, error.faults);
  return tl::unexpected(std::move(error));
}

/// Reads a preset, and the models it names.
Expected<void> readPreset(const fs::path& file) {
  const auto preset = loadPreset(file);
  if (!preset) return tl::unexpected(preset.error());
  auto faults = modelFaults(*preset);
  for (Fault& fault : faults)
    if (fault.file.empty()) fault.file = file.string();
  if (faults.empty()) return {};
  return tl::unexpected(Error{ErrorKind::input, std::move(faults)});
}

/// Reads a file as what it is: weapons.dat, rules, a mission, a recording, a projectile, or else a preset. The error lists its faults.
Expected<void> readWhole(const fs::path& file) {
  const auto lift = [](auto read) -> Expected<void> {
    if (!read) return tl::unexpected<Error>(std::move(read.error()));
    return {};
  };
  if (file.extension() == ".clp") return readRules(file);
  if (file.extension() == ".dat") return lift(loadWeapons(file));
  if (named(file, ".mission.json")) return readMission(file);
  if (!named(file, ".npsee.json"))
    switch (fileKindAt(file)) {
      case FileKind::projectile: return lift(loadProjectile(file));
      case FileKind::mission: return readMission(file);
      case FileKind::recording: return lift(loadRecording(file));
      case FileKind::preset:
      case FileKind::other: break;
    }
  return readPreset(file);
}

nlohmann::ordered_json faultJson(const Fault& fault) {
  return {{"file", fault.file}, {"line", fault.line}, {"pointer", fault.pointer}, {"what", fault.what}, {"remedy", fault.remedy}};
}

int check(const std::vector<std::string>& arguments, bool as_json) {
  const auto files = filesIn(arguments);
  if (!files) return report(files.error());
  nlohmann::ordered_json faults = nlohmann::ordered_json::array();
  std::size_t bad = 0;
  std::string text;
  bool unreadable = false;
  for (const fs::path& file : *files) {
    const auto read = readWhole(file);
    if (read) continue;
    ++bad;
    std::error_code ignored;
    unreadable = unreadable || !fs::is_regular_file(file, ignored);
    for (const Fault& fault : read.error().faults) {
      faults.push_back(faultJson(fault));
      text += fault.text() + '\n';
    }
  }
  const std::string summary = std::to_string(files->size()) + (files->size() == 1 ? " file" : " files") + " checked, " + std::to_string(bad) + " with faults\n";
  const int code = writeResult(as_json ? nlohmann::ordered_json{{"files", files->size()}, {"bad", bad}, {"faults", faults}}.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n'
                                       : text + summary);
  if (code != 0) return code;
  if (unreadable) return exitCode(ErrorKind::input);
  return bad > 0 ? 1 : 0;
}

}  // namespace

void addCheck(CLI::App& app, Outcome& outcome) {
  struct Options {
    std::vector<std::string> paths;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("check", "Validate presets, missions, recordings, projectiles, weapons.dat and rules: every fault with file, line, message and remedy; exit 1 where there is one");
  command->add_option("PATH", options->paths, "Preset, mission, recording, projectile, weapons.dat or rules (*.clp) files, or folders with presets and missions")->required();
  command->add_flag("--json", options->json, "Print the faults as JSON");
  command->footer("Examples:\n  npsee check presets\n  npsee check my_burst.npsee.json --json\n  npsee check assets/missions\n  npsee check my_observer.clp");
  command->callback([options, &outcome] { outcome.exit_code = check(options->paths, options->json); });
}

}  // namespace npsee::commands
