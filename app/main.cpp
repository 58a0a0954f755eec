#include "app/commands/command.h"

#include "sim/core/text.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

namespace {

/// `npsee` alone and `npsee FILE` mean the editor; an unknown word is named with the command it resembles.
int chooseCommand(const CLI::App& app, std::vector<std::string>& arguments) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) names.push_back(command->get_name());
  if (arguments.empty()) {
    arguments.insert(arguments.begin(), "edit");
    return 0;
  }
  const std::string& first = arguments.front();
  if (first.starts_with('-') || std::ranges::find(names, first) != names.end()) return 0;
  if (first.ends_with(".json") || first.find('/') != std::string::npos) {
    arguments.insert(arguments.begin(), "edit");
    return 0;
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto near = npsee::nearest(first, views);
  std::fprintf(stderr, "there is no command \"%s\".%s\n  `npsee --help` lists the commands.\n", npsee::printable(first).c_str(),
               near ? (" Did you mean " + std::string(*near) + "?").c_str() : "");
  return npsee::exitCode(npsee::ErrorKind::usage);
}

/// Refuses a command line that does not parse. A mistyped option is named with the one it resembles, even where another that
/// is required is missing too.
int refuse(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::string what = error.what();
  for (const std::string& word : command.remaining()) {
    if (!word.starts_with('-')) {
      what = "\"" + word + "\" was not expected.";
      continue;
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
      if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
    const std::vector<std::string_view> views(names.begin(), names.end());
    const auto near = npsee::nearest(word.substr(0, word.find('=')), views);
    what = "there is no option " + word + '.' + (near ? " Did you mean " + std::string(*near) + "?" : "");
    break;
  }
  std::fprintf(stderr, "%s\n  `npsee %s--help` shows how to call it.\n", npsee::printable(what).c_str(), chosen.empty() ? "" : (command.get_name() + ' ').c_str());
  return npsee::exitCode(npsee::ErrorKind::usage);
}

}  // namespace

int main(int argc, char** argv) {
  // A closed pipe or an output over the file-size limit is an error we report, not a signal to die of.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);

  CLI::App app("npsee: explosion editor, viewer and headless renderer", "npsee");
  app.set_version_flag("--version", "npsee " NPSEE_VERSION);
  app.require_subcommand(0, 1);
  app.footer("`npsee COMMAND --help` shows a command's options and examples. `npsee` alone, or with a preset file, opens the editor.");
  npsee::commands::Outcome outcome;
  npsee::commands::addAll(app, outcome);

  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (const int refused = chooseCommand(app, arguments); refused != 0) return refused;
  std::ranges::reverse(arguments);
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return refuse(app, error);
  } catch (const std::bad_alloc&) {
    // What is too large by its numbers has been refused before; this machine has less. Output files appear whole or not at all.
    std::fputs("there is not enough memory for this.\n  Lower counts or sizes, or use a machine with more.\n", stderr);
    return npsee::exitCode(npsee::ErrorKind::input);
  } catch (const std::system_error& error) {
    // A thread for the editor, say: work that is shared out among threads does with fewer.
    const bool used_up = error.code() == std::errc::resource_unavailable_try_again;
    std::fprintf(stderr, "the system refuses what this needs: %s.\n  %s\n", npsee::printable(error.what()).c_str(),
                 used_up ? "Allow more threads and memory (ulimit -u, ulimit -v), or use fewer --jobs." : "Try it from another folder, or on another machine.");
    return npsee::exitCode(npsee::ErrorKind::input);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "npsee cannot go on: %s.\n  This is a defect of npsee; files that were written are whole.\n", npsee::printable(error.what()).c_str());
    return npsee::exitCode(npsee::ErrorKind::input);
  }
  return outcome.exit_code;
}
