#pragma once

#include "app/render/camera.h"
#include "editor/desk/child.h"
#include "editor/desk/work_folder.h"

#include <npsee/preset.h>

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::editor {

enum class ExportKind { picture, sequence, contact_sheet, sprite_sheet, video };

/// What is to be made of the effect, beside the effect itself.
struct ExportChoice {
  ExportKind kind = ExportKind::picture;
  int width = 1280, height = 720;   ///< of each picture
  int columns = 4, rows = 3;        ///< of sheets
  double fps = 30.0;
  bool whole_effect = false;        ///< the camera that has all in view instead of the viewport's
  std::string background = "sky";
  std::filesystem::path output;
};
std::string_view exportName(ExportKind kind);
/// The first file that an export writes.
std::filesystem::path firstOutput(const ExportChoice& choice);
/// The file name that an export of `name` gets at first.
std::string exportFile(ExportKind kind, const std::string& name);

/// What is shown at the moment of the export.
struct ExportView {
  double time_s = 0.0, duration_s = 0.0;
  render::Camera camera;
  double exposure_stops = 0.0;
};

/// `npsee render`'s arguments for a preset file, `settings` as `--set` takes them.
std::vector<std::string> renderArguments(const std::filesystem::path& preset, const std::vector<std::string>& settings, const ExportChoice& choice, const ExportView& view);

/// The `--set` expressions that turn one preset into the other; nothing where that takes more (other layers).
std::optional<std::vector<std::string>> settingsBetween(const Preset& from, const Preset& to);

/// Exports at work and finished ones. Each runs `npsee render` in a process of its own, on a copy of the preset as it is, so that editing goes
/// on beside it. Layers shown alone are a matter of looking: all that are switched on are exported.
class Exports {
 public:
  explicit Exports(std::filesystem::path program) : program_(std::move(program)) {}
  ~Exports();
  Exports(const Exports&) = delete;
  Exports& operator=(const Exports&) = delete;

  struct Job {
    std::string label;               ///< "video explosion.mp4"
    std::filesystem::path output;
    enum class State { running, done, failed, cancelled } state = State::running;
    int done = 0, total = 0;         ///< pictures; 0 = not known
    std::string message;             ///< why it failed
  };
  const std::deque<Job>& jobs() const { return jobs_; }
  int running() const;

  /// Error kinds output and usage: another export writes the same file.
  Expected<void> start(const Preset& preset, const ExportChoice& choice, const ExportView& view);
  void cancel(std::size_t job);
  /// Takes finished ones off the list.
  void clearFinished();
  /// What became of an export.
  struct Told {
    std::string text;
    bool error = false;
  };
  /// Collects progress; `wait` until all are done. Returns what can be told of those that have ended.
  std::vector<Told> update(bool wait);

 private:
  struct Work {
    Child child;
    WorkFolder folder;             ///< of the copy
    bool cancelled = false;
    std::size_t read = 0;          ///< of what it has said
  };
  void finish(Job& job, Work& work);

  std::filesystem::path program_;
  std::deque<Job> jobs_;
  std::deque<std::optional<Work>> works_;  ///< by job
};

}  // namespace npsee::editor
