#include "app/commands/manual.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace npsee::commands {
namespace {

/// Names of an option as typed.
std::vector<std::string> namesOf(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : separator) + word;
  return out;
}

std::string optionsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional())
      for (const std::string& name : namesOf(*option))
        if (name.starts_with("--")) names.push_back(name);
  return joined(names, " ");
}

/// Endings of files that a description speaks of, "*.npsee.json".
std::vector<std::string> patternsIn(const std::string& text) {
  std::set<std::string> found;
  for (std::size_t at = 0; (at = text.find("*.", at)) != std::string::npos;) {
    std::size_t end = at + 2;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.')) ++end;
    std::string pattern = text.substr(at, end - at);
    while (pattern.ends_with('.')) pattern.pop_back();
    if (pattern.size() > 2) found.insert(pattern);
    at = end;
  }
  return {found.begin(), found.end()};
}

/// The words an option chooses from, which its type or its check lists as {a,b} or a|b; empty where it takes anything.
std::string choicesOf(const CLI::Option& option) {
  std::string type = option.get_type_name();
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos || close < open) return {};
  type = type.substr(open + 1, close - open - 1);
  for (char& c : type)
    if (c == ',' || c == '|') c = ' ';
  return type;
}

/// Whether an option's value is a file or folder, by its type.
bool takesFile(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return std::ranges::any_of(std::array{"FILE", "OUT", "PNG", "FOLDER", "DIR"}, [&](const char* word) { return type.starts_with(word) || type.starts_with('[' + std::string(word)); });
}

/// A branch of `case` for one command: what it takes after an option, and which files it reads.
std::string branch(const std::string& name, const CLI::App& command) {
  std::vector<std::string> takers, others, files;
  std::string values;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      for (const std::string& pattern : patternsIn(option->get_description())) files.push_back(pattern);
      continue;
    }
    if (option->get_expected_max() == 0) continue;
    const std::vector<std::string> each = namesOf(*option);
    if (const std::string choices = choicesOf(*option); !choices.empty())
      values += "        " + joined(each, "|") + ") COMPREPLY=($(compgen -W '" + choices + "' -- \"$current\")); return ;;\n";
    else (takesFile(*option) ? takers : others).insert((takesFile(*option) ? takers : others).end(), each.begin(), each.end());
  }
  // Numbers and the like: nothing to offer.
  if (!others.empty()) values += "        " + joined(others, "|") + ") return ;;\n";
  if (!takers.empty()) values += "        " + joined(takers, "|") + ") IFS=$'\\n'; COMPREPLY=($(compgen -f -- \"$current\")); return ;;\n";
  std::string out = "    " + name + ")\n      options='" + optionsOf(command) + "'\n      patterns='" + joined(files, " ") + "'";
  return out + (values.empty() ? " ;;\n" : "\n      case $previous in\n" + values + "      esac ;;\n");
}

constexpr const char* kBegin = R"(# Completion of npsee for bash, written by `npsee manual --bash`.
_npsee() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command= options= patterns= word pattern
  local IFS=$' \t\n'
  COMPREPLY=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
)";

constexpr const char* kEnd = R"(  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
    return
  fi
  [[ -z $command ]] && COMPREPLY=($(compgen -W "$commands" -- "$current"))
  # File names may have blanks: one a line.
  IFS=$'\n'
  COMPREPLY+=($(compgen -d -- "$current"))
  set -f
  local IFS=' '
  for pattern in $patterns; do
    IFS=$'\n'
    COMPREPLY+=($(compgen -f -X "!$pattern" -- "$current"))
  done
  IFS=$'\n'
  [[ -n $patterns || -z $command ]] || COMPREPLY+=($(compgen -f -- "$current"))
  set +f
}
complete -o filenames -F _npsee npsee
)";

}  // namespace

std::string bashCompletion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string branches;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
    branches += branch(command->get_name(), *command);
  }
  // Without a command `npsee FILE` opens the editor.
  const CLI::App* editor = app.get_subcommand("edit");
  std::vector<std::string> files;
  for (const CLI::Option* option : editor->get_options())
    if (option->get_positional())
      for (const std::string& pattern : patternsIn(option->get_description())) files.push_back(pattern);
  return kBegin + std::string("      ") + joined(names, "|") + ") command=$word; break ;;\n    esac\n  done\n  local commands='" + joined(names, " ") + "'\n  case $command in\n    '')\n      options='" +
         optionsOf(app) + "'\n      patterns='" + joined(files, " ") + "' ;;\n" + branches + kEnd;
}

}  // namespace npsee::commands
