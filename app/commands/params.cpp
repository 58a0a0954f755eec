#include "app/commands/command.h"

#include "sim/world/event_reference.h"
#include "sim/world/scenario_table.h"

#include <npsee/parameters.h>

#include <CLI/CLI.hpp>

#include <map>
#include <memory>

namespace npsee::commands {

void addParams(CLI::App& app, Outcome& outcome) {
  struct Options {
    std::string key;
    bool missions = false, events = false;
    ReferenceFormat format = ReferenceFormat::text;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("params", "The parameter reference: every preset parameter with meaning, unit, range and default");
  command->add_option("KEY", options->key, "Only this parameter, group (region) or section (Launch)");
  auto* missions = command->add_flag("--missions", options->missions, "The keys of mission files instead; KEY is a key (lay_time) or an object (battery)");
  command->add_flag("--events", options->events, "The keys of the event log that `npsee mission` prints")->excludes(missions);
  const std::map<std::string, ReferenceFormat> formats{
      {"text", ReferenceFormat::text}, {"json", ReferenceFormat::json}, {"markdown", ReferenceFormat::markdown}, {"schema", ReferenceFormat::json_schema}};
  command->add_option("--format", options->format, "text, json, markdown, or schema (JSON Schema of presets, missions or log lines)")
      ->transform(CLI::CheckedTransformer(formats).description(""))
      ->type_name("FORMAT");
  command->footer("Examples:\n  npsee params speed_mean\n  npsee params --format schema > preset.schema.json\n  npsee params --missions battery");
  command->callback([options, &outcome] {
    if (options->events) {
      outcome.exit_code = writeResult(world::eventReference(options->format));
      return;
    }
    const auto text = options->missions ? world::missionReference(options->format, options->key) : parameterReference(options->format, options->key);
    outcome.exit_code = text ? writeResult(*text) : report(text.error());
  });
}

}  // namespace npsee::commands
