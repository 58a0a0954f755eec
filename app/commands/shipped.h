#pragma once

#include <filesystem>
#include <string_view>

namespace CLI {
class Option;
}

namespace npsee::commands {

/// Folder of what is shipped ("presets", "assets/missions"): beside the executable, below its prefix, or in the source tree it was built
/// in. Empty where there is none.
std::filesystem::path shippedFolder(const std::filesystem::path& name);

/// A shipped folder whose files go by their names without the ending.
struct ShippedFiles {
  std::string_view folder, ending;
};
inline constexpr ShippedFiles kShippedPresets{"presets", ".npsee.json"}, kShippedMissions{"assets/missions", ".mission.json"};

/// Lets an option that takes files take names of shipped ones too ("howitzer_155"), where no file is called so.
void acceptShipped(CLI::Option* option, const ShippedFiles& shipped);

}  // namespace npsee::commands
