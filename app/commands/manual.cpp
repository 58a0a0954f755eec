#include "app/commands/manual.h"

#include "app/commands/command.h"
#include "sim/core/files.h"
#include "sim/core/text.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace npsee::commands {
namespace {

struct ManualOptions {
  std::string command, folder;
  bool bash = false;
};

std::vector<const CLI::App*> commandsOf(const CLI::App& app) { return app.get_subcommands([](const CLI::App*) { return true; }); }

/// Writes npsee.1, npsee-render.1, ... and prints their names.
int writePages(const CLI::App& app, const std::filesystem::path& folder) {
  std::vector<const CLI::App*> shown{nullptr};
  for (const CLI::App* command : commandsOf(app)) shown.push_back(command);
  std::string written;
  std::error_code told_when_writing;
  std::filesystem::create_directories(folder, told_when_writing);
  for (const CLI::App* command : shown) {
    const std::filesystem::path file = folder / (command != nullptr ? "npsee-" + command->get_name() + ".1" : std::string("npsee.1"));
    if (const auto done = writeFileAtomically(file, manualPage(app, command)); !done) return report(done.error());
    written += file.string() + '\n';
  }
  return writeResult(written);
}

int printManual(const CLI::App& app, const ManualOptions& options) {
  if (options.bash) return writeResult(bashCompletion(app));
  if (!options.folder.empty()) return writePages(app, options.folder);
  if (options.command.empty()) return writeResult(manualPage(app, nullptr));
  std::vector<std::string_view> names;
  std::vector<std::string> texts;
  for (const CLI::App* command : commandsOf(app)) {
    if (command->get_name() == options.command) return writeResult(manualPage(app, command));
    texts.push_back(command->get_name());
  }
  names.assign(texts.begin(), texts.end());
  const auto near = nearest(options.command, names);
  return report(fail(ErrorKind::usage, "there is no command \"" + options.command + "\"." + (near ? " Did you mean " + std::string(*near) + "?" : ""), "`npsee --help` lists the commands.").value());
}

}  // namespace

void addManual(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<ManualOptions>();
  CLI::App* command = app.add_subcommand("manual", "Print a command's manual page, or bash completion");
  command->add_option("COMMAND", options->command, "Command whose page is printed; without it the program's own");
  command->add_flag("--bash", options->bash, "Print completion for bash instead");
  command->add_option("--pages", options->folder, "Write the pages of all commands into a folder and print their names")->type_name("FOLDER");
  command->footer("What it prints comes from the options themselves, as `--help` does.\n"
                  "Examples:\n  npsee manual render | man -l -\n  source <(npsee manual --bash)\n  npsee manual --pages share/man/man1");
  command->callback([&app, options, &outcome] { outcome.exit_code = printManual(app, *options); });
}

}  // namespace npsee::commands
