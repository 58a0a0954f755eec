#include "app/commands/command.h"
#include "app/commands/shipped.h"

#include <npsee/parameters.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

#include <unistd.h>

namespace npsee::commands {

int report(const Error& error) {
  const std::string text = error.text() + '\n';
  std::fputs(text.c_str(), stderr);
  return exitCode(error.kind);
}

namespace {

/// What a terminal gets: lines and tabs as they are, of every other control character its number. Files and pipes get every byte.
std::string forTerminal(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
    out += printable(text.substr(0, end));
    if (end < text.size()) out += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

}  // namespace

int writeResult(std::string_view text) {
  std::string shown;
  if (::isatty(STDOUT_FILENO) == 1) text = shown = forTerminal(text);
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return 0;
  std::fputs("standard output cannot be written: the disk is full or the reader is gone.\n", stderr);
  return exitCode(ErrorKind::output);
}

void addPresetOptions(CLI::App& command, PresetChoice& choice) {
  acceptShipped(command.add_option("FILE", choice.file, "Preset file (*.npsee.json), or the name of a shipped one")->required(), kShippedPresets);
  addChangeOptions(command, choice.settings, choice.seed);
}

void addChangeOptions(CLI::App& command, std::vector<std::string>& settings, std::string& seed) {
  command.add_option("--set", settings, "Change a parameter: KEY=VALUE or LAYER.KEY=VALUE; repeatable")->allow_extra_args(false)->type_name("KEY=VALUE");
  command.add_option("--seed", seed, "Seed of the random draws, instead of the preset's own")->type_name("N");
}

Expected<Preset> loadChosen(const PresetChoice& choice) {
  // A mistyped seed is reported before files are touched.
  auto preset = loadPreset(choice.file);
  if (!preset) return preset;
  for (const std::string& setting : choice.settings)
    if (auto applied = applySetting(*preset, setting); !applied) return tl::unexpected<Error>(applied.error());
  if (!choice.seed.empty()) {
    const auto value = parseValue(*findParameter(Scope::burst, "seed"), choice.seed);
    if (!value) return fail(ErrorKind::usage, "--seed " + choice.seed + ": " + value.error().faults.front().what);
    preset->seed = std::get<std::int64_t>(*value);
  }
  if (std::vector<Fault> faults = validate(*preset); !faults.empty()) {
    for (Fault& fault : faults) fault.file = choice.file;
    return tl::unexpected<Error>(Error{choice.settings.empty() ? ErrorKind::input : ErrorKind::usage, std::move(faults)});
  }
  return preset;
}

}  // namespace npsee::commands
