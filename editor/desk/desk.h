#pragma once

#include "editor/desk/folders.h"
#include "editor/desk/recovery.h"
#include "editor/desk/settings.h"
#include "editor/desk/writer.h"

#include <deque>
#include <string>

namespace npsee::editor {

/// What lies around the documents: settings, unsaved work, messages. No ImGui, no GL.
class Desk {
 public:
  /// `wait`: scripts see everything on the disk at once.
  Desk(const DeskFolders& folders, bool wait);

  Settings settings;
  Recovery& recovery() { return recovery_; }
  const Recovery& recovery() const { return recovery_; }
  const DeskFolders& folders() const { return folders_; }
  Writer& writer() { return writer_; }

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
  void noteFile(const Session& session);
  void saveSettings(double elapsed_s);

  DeskFolders folders_;
  bool wait_;
  Writer writer_;
  Recovery recovery_;
  std::string problem_;      ///< found while starting, not yet told
  Settings saved_;
  double unsaved_s_ = 0.0;   ///< since the settings were changed
  std::string noted_file_, last_error_, last_note_;
  std::deque<Message> messages_;
};

}  // namespace npsee::editor
