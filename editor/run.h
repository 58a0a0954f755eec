#pragma once

#include "editor/desk/folders.h"

#include <npsee/error.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace npsee::editor {

struct EditorOptions {
  std::filesystem::path file;     ///< preset or mission to open; empty starts a new preset
  std::filesystem::path library;  ///< folder of the shipped presets; empty = none
  std::filesystem::path missions = {};  ///< folder of the shipped missions; empty = none
  std::optional<double> time_s;   ///< start paused at this moment instead of playing
  float scale = 1.0f;             ///< of the display
  std::filesystem::path program = {};  ///< the npsee that renders thumbnails and exports; empty = none
  DeskFolders folders = {};       ///< where settings, unsaved work and thumbnails are kept; empty = nowhere
  bool scripted = false;          ///< every frame waits for the compiler, nothing measured is shown
};

/// The scale of the panels that a window of that size can hold: no larger than leaves 880 x 550 unscaled pixels, no smaller than 0.75.
float fittingScale(float wished, int width, int height);

struct HeadlessOptions {
  EditorOptions editor;
  int width = 1440, height = 900;
  std::filesystem::path script;      ///< empty = none
  std::filesystem::path screenshot;  ///< picture of the last frame; empty = none
  double measure_s = 0.0;            ///< after the script: frames as in a window for so long, and what they took; 0 = none
};
/// Runs the editor on OSMesa through a script. Returns the exit code 0, or 1 when an expectation of the script did not hold, with
/// the message on stderr. `print` gets what the script prints. Errors: graphics, input, output.
Expected<int> runHeadless(const HeadlessOptions& options, const std::function<void(const std::string&)>& print);

struct WindowedOptions {
  EditorOptions editor;
  int width = 1440, height = 900;
  bool sized = false;        ///< that size was asked for; otherwise the last one is taken
  bool print_state = false;  ///< print the facts when the window closes
};
/// Opens the window and returns when it is closed. Errors: graphics (no display), input.
Expected<void> runWindow(const WindowedOptions& options, const std::function<void(const std::string&)>& print);

}  // namespace npsee::editor
