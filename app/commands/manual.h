#pragma once

#include <string>

namespace CLI {
class App;
}

namespace npsee::commands {

/// The manual page of the program (`command` null) or of one of its commands, in man(7)'s language, from the options as they are parsed.
std::string manualPage(const CLI::App& app, const CLI::App* command);

/// Completion for bash: commands, options, the words an option chooses from, and the kinds of files that a command reads.
std::string bashCompletion(const CLI::App& app);

}  // namespace npsee::commands
