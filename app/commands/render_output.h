#pragma once

#include "app/commands/render_plan.h"

#include <filesystem>

namespace npsee::commands {

/// "bridge" for "effects/bridge.npsee.json".
std::string presetName(const std::string& file);

/// Names of the files a `npsee render` writes.
class OutputNames {
 public:
  /// `output` is a name, a name with %d or %04d for the frame number, or a folder, which then gets the presets' names with
  /// `ending`. A folder named with a / at its end need not be there yet; makeFolder() makes it.
  /// Errors: usage for a name that cannot hold the results, output for a folder that is missing or closed to us.
  static Expected<OutputNames> make(const std::string& output, const std::vector<std::string>& presets, bool sequence, const std::string& ending);

  /// Names of the presets in a folder, of which nothing is asked. Error kind usage for two presets of one name.
  static Expected<OutputNames> inFolder(const std::filesystem::path& folder, const std::vector<std::string>& presets, bool sequence, const std::string& ending);

  /// Makes the folder if that is wanted and it is missing. Error kind output.
  Expected<void> makeFolder() const;

  /// Place of frame `number` of preset `index`; a single picture ignores the number.
  std::filesystem::path path(std::size_t index, std::int64_t number) const;

 private:
  struct Name {
    std::filesystem::path folder;
    std::string before, after;  ///< around the number
  };
  std::vector<Name> names_;
  std::filesystem::path missing_;  ///< folder that is to be made
  int digits_ = 4;
  bool numbered_ = false;
};

/// Whether a file could be put there, as far as the folder tells. Error kind output.
Expected<void> checkPlace(const std::filesystem::path& file);

}  // namespace npsee::commands
