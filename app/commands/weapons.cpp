#include "app/commands/command.h"

#include "sim/core/files.h"

#include <npsee/units.h>
#include <npsee/weapons.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <memory>

namespace npsee::commands {
namespace {

using nlohmann::ordered_json;

struct WeaponsOptions {
  std::string file, output;
  bool json = false;
};

constexpr std::array<const char*, 7> kTargets{"any", "heavy armor", "light armor", "wheeled vehicle", "personnel", "aircraft", "watercraft"};
constexpr std::array<const char*, 4> kPaths{"low angle", "high angle", "linear", "gravity bomb"};

ordered_json weaponJson(const Weapon& w) {
  return {{"name", w.name},
          {"id", w.id},
          {"range_m", w.range_m},
          {"muzzle_velocity_mps", w.muzzle_velocity_mps},
          {"kill_radius_m", w.kill_radius_m},
          {"damage_radius_m", w.damage_radius_m},
          {"knowledge_radius_m", w.knowledge_radius_m},
          {"target_type", static_cast<int>(w.target)},
          {"target", kTargets[static_cast<std::size_t>(w.target)]},
          {"path_type", static_cast<int>(w.path)},
          {"path", kPaths[static_cast<std::size_t>(w.path)]}};
}

std::string weaponText(const Weapon& w) {
  return w.name + " (" + std::to_string(w.id) + "): range " + std::to_string(w.range_m) + " m, " + shortest(w.muzzle_velocity_mps) + " m/s, radii " + std::to_string(w.kill_radius_m) + " / " +
         std::to_string(w.damage_radius_m) + " / " + std::to_string(w.knowledge_radius_m) + " m (kill, damage, noticed), against " + kTargets[static_cast<std::size_t>(w.target)] + ", " +
         kPaths[static_cast<std::size_t>(w.path)] + '\n';
}

int weapons(const WeaponsOptions& options) {
  const auto read = loadWeapons(options.file);
  if (!read) return report(read.error());
  for (const Fault& warning : read->warnings) std::fputs(("warning: " + warning.text() + '\n').c_str(), stderr);
  if (options.output == "-") return writeResult(weaponsText(*read));
  if (!options.output.empty()) {
    const auto written = saveWeapons(*read, options.output);
    return written ? 0 : report(written.error());
  }
  if (options.json) {
    ordered_json out = ordered_json::array();
    for (const Weapon& weapon : read->list) out.push_back(weaponJson(weapon));
    return writeResult(out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
  }
  std::string text;
  for (const Weapon& weapon : read->list) text += weaponText(weapon);
  return writeResult(text);
}

}  // namespace

void addWeapons(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<WeaponsOptions>();
  CLI::App* command = app.add_subcommand("weapons", "Read a weapons.dat of 1993 (appendix B.A), show it, or write it back");
  command->add_option("FILE", options->file, "The file")->required();
  command->add_option("-o,--output", options->output, "Write the file back here, comments kept (- for standard output)")->type_name("OUT");
  command->add_flag("--json", options->json, "Print the weapons as JSON");
  command->footer("Examples:\n  npsee weapons assets/weapons.dat\n  npsee weapons mine.dat --json\n  npsee weapons mine.dat -o tidy.dat");
  command->callback([options, &outcome] { outcome.exit_code = weapons(*options); });
}

}  // namespace npsee::commands
