#include "editor/desk/desk.h"

#include <system_error>
#include <utility>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxMessages = 200;

fs::path fileOf(const fs::path& folder, const char* name) { return folder.empty() ? fs::path() : folder / name; }

}  // namespace

Desk::Desk(const DeskFolders& folders, bool wait) : folders_(folders), wait_(wait), recovery_(fileOf(folders.state, "unsaved"), writer_) {
  auto loaded = loadSettings(fileOf(folders_.settings, "settings.json"));
  settings = saved_ = std::move(loaded.settings);
  problem_ = std::move(loaded.problem);
}

void Desk::update(double elapsed_s, Session& session) {
  if (!problem_.empty() && session.notices.error.empty()) session.notices.error = std::exchange(problem_, {});
  noteFile(session);
  recovery_.update(elapsed_s, session, wait_);
  saveSettings(elapsed_s);
  if (auto wrong = writer_.takeError()) session.notices.error = "What is unsaved or set cannot be kept for the next start.\n  " + *wrong;
  noteMessages(session.notices);
}

/// The file of the document shown becomes the newest of the recent ones.
void Desk::noteFile(const Session& session) {
  std::error_code ignored;
  const fs::path& path = session.file().path();
  if (path.empty()) return;
  if (std::string file = fs::absolute(path, ignored).lexically_normal().string(); file != noted_file_) noteRecent(settings, noted_file_ = std::move(file));
}

void Desk::noteMessages(const Notices& notices) {
  const auto note = [this](const std::string& now, std::string& last, bool error) {
    if (now == last) return;
    last = now;
    if (now.empty()) return;
    messages_.push_back({now, error});
    if (messages_.size() > kMaxMessages) messages_.pop_front();
  };
  note(notices.error, last_error_, true);
  note(notices.note, last_note_, false);
}

void Desk::saveSettings(double elapsed_s) {
  constexpr double kAfter_s = 1.0;  // one write for a drag of a bar
  if (folders_.settings.empty() || settings == saved_) return;
  unsaved_s_ += elapsed_s;
  if (unsaved_s_ < kAfter_s) return;
  unsaved_s_ = 0.0;
  saved_ = settings;
  writer_.write(folders_.settings / "settings.json", settingsText(settings));
}

void Desk::finish(bool asked) {
  saveSettings(1e9);
  if (asked) recovery_.finish();
  writer_.wait();
}

}  // namespace npsee::editor
