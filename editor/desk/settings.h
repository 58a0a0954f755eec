#pragma once

#include <npsee/error.h>

#include <filesystem>
#include <string>
#include <vector>

namespace npsee::editor {

/// What the editor remembers from one start to the next. Lengths in unscaled pixels.
struct Settings {
  bool light = false;
  bool show_left = true, show_right = true;
  double left_width = 252, right_width = 396, template_height = 330;
  double mission_left_width = 286, mission_right_width = 344, plan_height = 330, log_height = 196;
  double window_width = 0, window_height = 0;  ///< screen coordinates; 0 = not known
  bool tour_done = false;
  std::vector<std::string> favourites;  ///< files
  std::vector<std::string> recent;      ///< files, newest first
  std::vector<std::string> bookmarks;   ///< cameras, as `--camera` reads them; an empty text is an empty place
  bool show_extent = false, show_grid = true;
  std::string background = "sky";       ///< as `--background` reads it
  std::string quality = "automatic";
  double exposure_stops = 0.0;

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// The settings' text, and the other way. What is unknown is passed over, what is out of range or of another type keeps its default and is
/// told of. Error kind input: no JSON object at all.
std::string settingsText(const Settings& settings);
struct ReadSettings {
  Settings settings;
  std::vector<Fault> faults;
};
Expected<ReadSettings> parseSettings(std::string_view text, std::string_view file);

/// `held` with what `now` has otherwise than `before`: several editors write the same file.
Settings changedSettings(Settings held, const Settings& before, const Settings& now);

/// Reads the file of a start. A missing file gives the defaults; a bad one too, with what was wrong in `problem`.
struct LoadedSettings {
  Settings settings;
  std::string problem;
};
LoadedSettings loadSettings(const std::filesystem::path& file);

/// Puts a file in front of the recent ones, which are at most kMaxRecent.
inline constexpr std::size_t kMaxRecent = 20;
void noteRecent(Settings& settings, const std::string& file);

}  // namespace npsee::editor
