#pragma once

#include "app/gl/context.h"
#include "app/render/renderer.h"
#include "editor/run.h"
#include "editor/ui/context.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {

class KeptWindow;
struct PictureTimes;

/// The whole editor on the current GL and ImGui contexts; whoever owns those feeds input and time. The same in a window and on
/// OSMesa.
class Editor {
 public:
  /// Loads fonts, shaders and the file. Errors: graphics, input.
  static Expected<std::unique_ptr<Editor>> create(const EditorOptions& options, std::unique_ptr<Desk> desk = nullptr);
  /// Keeps the settings; unsaved work stays for the next start unless it was asked about.
  ~Editor();

  /// One frame between ImGui::NewFrame and ImGui::Render: `elapsed_s` passes, keys and panels act. Without `pictures` the
  /// explosion and the template are not drawn, which a script's frames that nobody sees need not be.
  void frame(double elapsed_s, std::optional<float> frame_ms, bool pictures);

  /// From now on adds up what pictures cost; null = no longer.
  void timePictures(PictureTimes* into);

  /// Brings the window's picture up to date; false if it is as it was.
  bool draw();
  const KeptWindow& window() const;
  /// Nothing of what was drawn is kept: the next frame draws everything.
  void drawAnew();
  /// Why the driver could not draw what the last frame with pictures should show, once. The message is on the screen from the next frame on.
  std::optional<Error> takeGraphicsFault();

  Session& session();
  const Session& session() const;
  UiState& state();
  const UiState& state() const;
  Items& items();
  Desk& desk();
  const Desk& desk() const;

  /// What scripts can ask for, by name: camera, time, undo steps, title, ...
  std::vector<std::pair<std::string, std::string>> facts() const;

 private:
  struct Impl;
  explicit Editor(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// An ImGui context of our own, without files of its own; destroyed with the object. Make it before the Editor.
class UiHost {
 public:
  UiHost();
  ~UiHost();
  UiHost(const UiHost&) = delete;
  UiHost& operator=(const UiHost&) = delete;
};

}  // namespace npsee::editor
