#pragma once

#include "editor/desk/exports.h"
#include "editor/desk/folders.h"
#include "editor/desk/recovery.h"
#include "editor/desk/settings.h"
#include "editor/desk/thumbnails.h"
#include "editor/desk/writer.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace npsee::editor {

/// What lies around the documents: settings, unsaved work, messages. No ImGui, no GL.
class Desk {
 public:
  /// `program`: the npsee that renders thumbnails and exports. `wait`: scripts see everything on the disk at once.
  Desk(const DeskFolders& folders, const std::filesystem::path& program, bool wait);

  Settings settings;
  Recovery& recovery() { return recovery_; }
  const Recovery& recovery() const { return recovery_; }
  const DeskFolders& folders() const { return folders_; }
  Thumbnails& thumbnails() { return thumbnails_; }
  Exports& exports() { return exports_; }
  const Exports& exports() const { return exports_; }

  bool favourite(const std::filesystem::path& file) const;
  void flipFavourite(const std::filesystem::path& file);

  /// The `npsee render` line that makes the same picture as an export now: of the document's file, with `--set` for what is not saved, or,
  /// where that does not suffice, of a copy in the state folder. Error kinds output and usage.
  Expected<std::string> commandLine(const Document& document, const ExportChoice& choice, const ExportView& view);
  /// Returns when thumbnails and exports are done: for scripts.
  void settle(Session& session);

  /// What the person was told, newest last.
  struct Message {
    std::string text;
    bool error = false;
  };
  const std::deque<Message>& messages() const { return messages_; }

  /// Once a frame, after the session's own update.
  void update(double elapsed_s, Session& session);
  /// The editor ends; `asked` if what is unsaved was asked about.
  void finish(bool asked);

 private:
  void noteMessages(const Notices& notices);
  void tell(const std::vector<Exports::Told>& told, Notices& notices);
  void noteFile(const Session& session);
  void saveSettings(double elapsed_s, bool at_once = false);
  void watchLibrary(double elapsed_s, Session& session);

  DeskFolders folders_;
  bool wait_;
  Writer writer_;
  Recovery recovery_;
  Thumbnails thumbnails_;
  Exports exports_;
  double unwatched_s_ = 0.0;  ///< since the library was last looked at
  std::vector<FileStamp> library_stamps_;
  std::string problem_;      ///< found while starting, not yet told
  Settings saved_, saved_before_;  ///< what the file holds of what was set here; before the last write
  Settings tried_;                 ///< what was written last, or could not be
  std::uint64_t writing_ = 0;      ///< the write that is not known to have succeeded; 0 = none
  double unsaved_s_ = 0.0;   ///< since the settings were changed
  std::string noted_file_, last_error_, last_note_;
  std::deque<Message> messages_;
};

}  // namespace npsee::editor
