#include "editor/desk/desk.h"

#include "editor/mission/document.h"
#include "sim/core/files.h"
#include "sim/core/sha256.h"

#include <npsee/fragments.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxMessages = 200;

fs::path fileOf(const fs::path& folder, const char* name) { return folder.empty() ? fs::path() : folder / name; }

}  // namespace

Desk::Desk(const DeskFolders& folders, const fs::path& program, bool wait)
    : folders_(folders), wait_(wait), recovery_(fileOf(folders.state, "unsaved"), writer_), thumbnails_(folders.cache, program), exports_(program) {
  auto loaded = loadSettings(fileOf(folders_.settings, "settings.json"));
  settings = saved_ = tried_ = std::move(loaded.settings);
  problem_ = std::move(loaded.problem);
}

void Desk::update(double elapsed_s, Session& session) {
  if (!problem_.empty() && session.notices.error.empty()) session.notices.error = std::exchange(problem_, {});
  noteFile(session);
  recovery_.update(elapsed_s, session, wait_);
  saveSettings(elapsed_s);
  watchLibrary(elapsed_s, session);
  thumbnails_.update(wait_);
  tell(exports_.update(false), session.notices);
  session.exporting = exports_.running();
  if (std::string problem = recovery_.takeProblem(); !problem.empty()) problem_ += (problem_.empty() ? "" : "\n") + problem;
  if (auto wrong = writer_.takeError()) session.notices.error = "What is unsaved or set cannot be kept for the next start.\n  " + *wrong;
  noteMessages(session.notices);
}

/// Shows what became of exports; each is kept among the messages, though only the last of its kind is seen.
void Desk::tell(const std::vector<Exports::Told>& told, Notices& notices) {
  for (const Exports::Told& one : told) {
    (one.error ? notices.error : notices.note) = one.text;
    noteMessages(notices);
  }
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

void Desk::saveSettings(double elapsed_s, bool at_once) {
  constexpr double kAfter_s = 1.0;  // one write for a drag of a bar
  // What could not be written is not saved. It is tried again with the next change, and at the end: not again and again on a full disk.
  if (writing_ != 0 && writer_.fateOf(writing_) == Writer::Fate::failed) saved_ = saved_before_;
  if (writing_ != 0 && writer_.fateOf(writing_) != Writer::Fate::waiting) writing_ = 0;
  if (folders_.settings.empty() || settings == saved_) return;
  unsaved_s_ += elapsed_s;
  if (!at_once && (unsaved_s_ < kAfter_s || settings == tried_)) return;
  unsaved_s_ = 0.0;
  // Another editor may have set something else meanwhile: only what was set here is written over it.
  const std::filesystem::path file = folders_.settings / "settings.json";
  writer_.wait();
  const auto text = readTextFile(file);
  const auto held = text ? parseSettings(*text, file.string()) : Expected<ReadSettings>(ReadSettings{settings, {}});
  writing_ = writer_.write(file, settingsText(held ? changedSettings(held->settings, saved_, settings) : settings));
  saved_before_ = std::exchange(saved_, settings);
  tried_ = settings;
}

bool Desk::favourite(const fs::path& file) const { return std::ranges::find(settings.favourites, file.string()) != settings.favourites.end(); }

void Desk::flipFavourite(const fs::path& file) {
  if (std::erase(settings.favourites, file.string()) == 0) settings.favourites.push_back(file.string());
}

/// Files that come, go or change in the library's folder show without a restart.
void Desk::watchLibrary(double elapsed_s, Session& session) {
  constexpr double kEvery_s = 1.0;
  unwatched_s_ += elapsed_s;
  if (unwatched_s_ < kEvery_s && !library_stamps_.empty()) return;
  unwatched_s_ = 0.0;
  thumbnails_.lookAgain();
  std::vector<FileStamp> now;
  for (const fs::path& folder : {session.options().library, session.options().missions}) now.push_back(stampOf(folder));
  for (const auto* list : {&session.presets(), &session.missionFiles()})
    for (const LibraryEntry& entry : *list) now.push_back(stampOf(entry.path));
  if (now == library_stamps_) return;
  if (!std::exchange(library_stamps_, std::move(now)).empty()) session.readLibraries();
}

Expected<std::string> Desk::commandLine(const Document& document, const ExportChoice& choice, const ExportView& view) {
  std::error_code ignored;
  const auto line = [&](const fs::path& file, const std::vector<std::string>& settings_of) {
    std::vector<std::string> words{"npsee"};
    const auto arguments = renderArguments(file, settings_of, choice, view);
    words.insert(words.end(), arguments.begin(), arguments.end());
    return shellLine(words);
  };
  const Preset& preset = document.preset();
  if (!document.path().empty())
    // Models of its own lie beside that file, unless the preset came from another folder.
    if (const auto held = loadPreset(document.path()); held && (held->folder.path == preset.folder.path || modelFiles(preset).empty()))
      if (const auto changes = settingsBetween(*held, preset)) return line(fs::absolute(document.path(), ignored), *changes);
  if (folders_.state.empty()) return fail(ErrorKind::usage, "A command line needs a file: these changes cannot be written with --set.", "Save the preset first.");
  const std::string text = document.text();
  // A folder for each content: models of the same name may differ, and may change.
  const fs::path copy = folders_.state / "recipes" / (document.name() + '-' + sha256(text + modelTexts(preset)).substr(0, 12)) / (document.name() + std::string(kPresetEnding));
  fs::create_directories(copy.parent_path(), ignored);
  auto written = writeFileAtomically(copy, text);
  if (written) written = bringModels(preset, copy.parent_path());
  if (!written) return tl::unexpected<Error>(written.error());
  return line(copy, {});
}

void Desk::settle(Session& session) {
  thumbnails_.update(true);
  tell(exports_.update(true), session.notices);
  noteMessages(session.notices);
}

void Desk::finish(bool asked) {
  saveSettings(0.0, true);
  if (asked) recovery_.finish();
  writer_.wait();
}

}  // namespace npsee::editor
