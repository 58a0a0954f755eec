#include "app/commands/command.h"

#include <npsee/parameters.h>

#include <CLI/CLI.hpp>

#include <map>
#include <memory>

namespace npsee::commands {

void addParams(CLI::App& app, Outcome& outcome) {
  struct Options {
    std::string key;
    ReferenceFormat format = ReferenceFormat::text;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("params", "The parameter reference: every preset parameter with meaning, unit, range and default");
  command->add_option("KEY", options->key, "Only this parameter, group (region) or section (Launch)");
  const std::map<std::string, ReferenceFormat> formats{
      {"text", ReferenceFormat::text}, {"json", ReferenceFormat::json}, {"markdown", ReferenceFormat::markdown}, {"schema", ReferenceFormat::json_schema}};
  command->add_option("--format", options->format, "text, json, markdown, or schema (JSON Schema of preset files)")
      ->transform(CLI::CheckedTransformer(formats).description(""))
      ->type_name("FORMAT");
  command->footer("Examples:\n  npsee params speed_mean\n  npsee params --format schema > preset.schema.json");
  command->callback([options, &outcome] {
    const auto text = parameterReference(options->format, options->key);
    outcome.exit_code = text ? writeResult(*text) : report(text.error());
  });
}

}  // namespace npsee::commands
