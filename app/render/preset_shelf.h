#pragma once

#include <npsee/error.h>
#include <npsee/preset.h>
#include <npsee/recording.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace npsee::render {

/// Explosion presets by the names a mission uses: a shipped one, or a file relative to the mission's. Each is read once.
class PresetShelf {
 public:
  /// Never null: what cannot be read is drawn as the shipped `fallback`, with a warning.
  std::shared_ptr<const Preset> find(const std::string& name, const std::filesystem::path& folder);
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// The preset itself, or an error of kind usage that names the nearest shipped one, or of kind input for a file that cannot be read.
  static Expected<std::shared_ptr<const Preset>> lookUp(const std::string& name, const std::filesystem::path& folder);

 private:
  std::map<std::string, std::shared_ptr<const Preset>> read_;
  std::vector<std::string> warnings_;
};

/// Upper bound of the time after which a preset's effect has ended, s.
double longestDuration(const Preset& preset);

}  // namespace npsee::render
