#pragma once

#include <npsee/error.h>
#include <npsee/preset.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace npsee::commands {

/// What a command leaves behind: the process's exit code (see npsee::exitCode; 1 is "done, but negative").
struct Outcome {
  int exit_code = 0;
};

/// Each command has a file of its own with one function that adds its options and what runs when it is chosen.
void addParams(CLI::App& app, Outcome& outcome);
void addCheck(CLI::App& app, Outcome& outcome);
void addCompare(CLI::App& app, Outcome& outcome);
void addParticles(CLI::App& app, Outcome& outcome);
void addRender(CLI::App& app, Outcome& outcome);
void addEdit(CLI::App& app, Outcome& outcome);
void addFly(CLI::App& app, Outcome& outcome);
void addTable(CLI::App& app, Outcome& outcome);
void addAim(CLI::App& app, Outcome& outcome);
void addWeapons(CLI::App& app, Outcome& outcome);
void addMission(CLI::App& app, Outcome& outcome);
void addReplay(CLI::App& app, Outcome& outcome);
void addManual(CLI::App& app, Outcome& outcome);

/// Adds all of the above, in the order of `npsee --help`.
void addAll(CLI::App& app, Outcome& outcome);

/// Prints an error to stderr and returns its exit code.
int report(const Error& error);

/// Writes results to stdout and returns the exit code: 5 if stdout takes no more (full disk, closed pipe).
int writeResult(std::string_view text);

/// `--seed` and `--set`, shared by every command that reads a preset.
struct PresetChoice {
  std::string file;
  std::vector<std::string> settings;
  std::string seed;  ///< empty = the preset's own
};
void addPresetOptions(CLI::App& command, PresetChoice& choice);
/// Only `--set` and `--seed`, for commands that take several files.
void addChangeOptions(CLI::App& command, std::vector<std::string>& settings, std::string& seed);
/// Loads the file and applies the settings in order, then the seed. Errors: input, usage.
Expected<Preset> loadChosen(const PresetChoice& choice);

}  // namespace npsee::commands
