#include "app/commands/manual.h"

#include <CLI/CLI.hpp>

#include <map>
#include <vector>

namespace npsee::commands {
namespace {

/// Text as it stands, whatever man(7) makes of its characters.
std::string escaped(const std::string& text) {
  std::string out;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else out += c;
    line_start = c == '\n';
  }
  return out;
}

/// Lines as they are, indented as written.
std::string verbatim(const std::string& text) { return ".nf\n" + escaped(text) + (text.ends_with('\n') ? "" : "\n") + ".fi\n"; }

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string optionLine(const CLI::Option& option) {
  if (option.get_positional()) return italic(option.get_single_name()) + (option.get_expected_max() > 1 ? " ..." : "");
  std::string out;
  for (const std::string& name : option.get_snames()) out += (out.empty() ? "" : ", ") + bold("-" + name);
  for (const std::string& name : option.get_lnames()) out += (out.empty() ? "" : ", ") + bold("--" + name);
  if (option.get_expected_max() > 0 && !option.get_type_name().empty()) out += ' ' + italic(option.get_type_name());
  return out;
}

/// Options by their groups, in the order in which they were added.
std::string optionsSection(const CLI::App& app) {
  std::vector<std::string> order;
  std::map<std::string, std::string> groups;
  for (const CLI::Option* option : app.get_options()) {
    const std::string group = option->get_positional() ? "ARGUMENTS" : option->get_group();
    if (group.empty()) continue;
    if (!groups.contains(group)) order.push_back(group);
    groups[group] += ".TP\n" + optionLine(*option) + "\n" + escaped(option->get_description()) + (option->get_required() ? " (required)" : "") + "\n";
  }
  std::string out;
  for (const std::string& group : order)
    if (group == "ARGUMENTS") out += ".SH ARGUMENTS\n" + groups[group];
  out += ".SH OPTIONS\n";
  for (const std::string& group : order)
    if (group != "ARGUMENTS") out += (group == "Options" ? "" : ".SS " + escaped(group) + '\n') + groups[group];
  return out;
}

/// The text below the options: what comes before "Examples:" are notes.
std::string footerSections(const std::string& footer) {
  if (footer.empty()) return {};
  static const std::string kExamples = "Examples:\n";
  const std::size_t at = footer.find(kExamples);
  std::string out;
  if (at != 0) out += ".SH NOTES\n" + verbatim(footer.substr(0, at));
  if (at != std::string::npos) out += ".SH EXAMPLES\n" + verbatim(footer.substr(at + kExamples.size()));
  return out;
}

std::string synopsis(const CLI::App* command) {
  std::string out = bold("npsee");
  if (command == nullptr) return out + " [" + italic("COMMAND") + "] [" + italic("OPTION") + " ...]";
  out += ' ' + bold(command->get_name());
  for (const CLI::Option* option : command->get_options())
    if (option->get_positional()) out += ' ' + std::string(option->get_required() ? "" : "[") + optionLine(*option) + (option->get_required() ? "" : "]");
    else if (option->get_required()) out += ' ' + optionLine(*option);
  return out + " [" + italic("OPTION") + " ...]";
}

std::string commandsSection(const CLI::App& app) {
  std::string out = ".SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    out += ".TP\n" + bold(command->get_name()) + "\n" + escaped(command->get_description()) + "; see " + bold("npsee-" + command->get_name()) + "(1)\n";
  return out;
}

/// Exit codes of error.h, with the two that are no errors.
constexpr const char* kExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n0\nDone.\n"
    ".TP\n1\nDone, but negative: faults found, an expectation not met, a target out of reach.\n"
    ".TP\n2\nThe command line is wrong.\n"
    ".TP\n3\nAn input is unreadable or invalid.\n"
    ".TP\n4\nNo usable OpenGL, or no display for a window.\n"
    ".TP\n5\nAn output could not be written.\n";

}  // namespace

std::string manualPage(const CLI::App& app, const CLI::App* command) {
  const CLI::App& shown = command != nullptr ? *command : app;
  const std::string name = command != nullptr ? "npsee-" + command->get_name() : "npsee";
  std::string out = ".TH \"" + escaped(name) + "\" 1 \"\" \"npsee " NPSEE_VERSION "\" \"npsee\"\n";
  const std::string& title = shown.get_description();
  // A name that stands in the title already is not said twice.
  out += ".SH NAME\n" + escaped(name) + " \\- " + escaped(title.starts_with("npsee: ") ? title.substr(7) : title) + "\n.SH SYNOPSIS\n" + synopsis(command) + "\n";
  if (command == nullptr) out += commandsSection(app);
  out += optionsSection(shown) + footerSections(shown.get_footer()) + kExitStatus;
  if (command != nullptr) out += ".SH SEE ALSO\n" + bold("npsee") + "(1)\n";
  return out;
}

}  // namespace npsee::commands
