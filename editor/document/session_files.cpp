// Opening, saving and leaving: what may be lost is asked about first.

#include "editor/document/session.h"
#include "editor/mission/session.h"

#include <utility>

namespace npsee::editor {

namespace fs = std::filesystem;

void Session::setMode(WorkMode wanted) {
  if (wanted == mode_) return;
  endMerge();
  closeFiles();
  mode_ = wanted;
}

void Session::startNew() { begin(Intent::start_new); }
void Session::open(const fs::path& path) { begin(Intent::open, path); }
void Session::quit() { begin(Intent::quit); }

void Session::recover(const UnsavedWork& work) {
  intent_work_ = work;
  begin(Intent::recover);
}

void Session::begin(Intent intent, fs::path path) {
  intent_ = intent;
  intent_path_ = std::move(path);
  given_up_ = {};
  wait_for_exports_ = exports_given_up_ = false;
  document.endMerge();
  mission_->document.endMerge();
  goOn();
}

/// The mode whose unsaved work would be lost and is not yet given up.
std::optional<WorkMode> Session::endangered() const {
  const WorkMode replaced = intent_ == Intent::recover ? intent_work_.mode : intent_ == Intent::open ? (isMissionFile(intent_path_) ? WorkMode::mission : WorkMode::explosion) : mode_;
  for (const WorkMode which : {WorkMode::explosion, WorkMode::mission}) {
    if (intent_ == Intent::none || given_up_[static_cast<std::size_t>(which)] || (intent_ != Intent::quit && which != replaced)) continue;
    if (fileOf(which).dirty()) return which;
  }
  return std::nullopt;
}

/// Asks about what would be lost, shown while it is asked about, or does what was wanted.
void Session::goOn() {
  if (const auto which = endangered()) setMode(*which);
  else if (!askingAboutExports() || exports_given_up_) proceed();
}

std::string Session::askingAbout() const { return file().name(); }

void Session::proceed() {
  const Intent intent = std::exchange(intent_, Intent::none);
  proceed_after_save_ = false;
  if (intent == Intent::quit) quitting_ = true;
  if (intent == Intent::open) loadNow(intent_path_);
  if (intent == Intent::recover) recoverNow();
  if (intent != Intent::start_new) return;
  startNewNow();
  notices = {};
}

void Session::startNewNow() {
  if (inMission()) mission_->startNew();
  else document.startNew();
  beginAnew();
}

/// The mode's document is another one: nothing of what was said about the last is kept. Its layers may even have the same names.
void Session::beginAnew() {
  outside_[static_cast<std::size_t>(mode_)] = false;
  if (inMission()) return;
  frame_on_compile_ = true;
  playback.time_s = 0.0;
  playback.clearRange();
  design.solo.clear();
  design.locked.clear();
  compare.mode = Compare::Mode::off;
  compare.preset = nullptr;
  variations.open = false;
}

/// False where the file cannot be read.
bool Session::loadNow(const fs::path& path) {
  const bool mission = isMissionFile(path);
  if (!took(mission ? mission_->load(path) : document.load(path))) return false;
  notices = {{}, "Opened " + path.string()};
  setMode(mission ? WorkMode::mission : WorkMode::explosion);
  beginAnew();
  closeFiles();
  return true;
}

std::string UnsavedWork::name() const {
  const std::string name = bareName(file);
  return name.empty() ? "untitled" : name;
}

void Session::recoverNow() {
  setMode(intent_work_.mode);
  std::error_code ignored;
  const bool there = !intent_work_.file.empty() && fs::is_regular_file(intent_work_.file, ignored);
  if (!there || !loadNow(intent_work_.file)) startNewNow();
  if (!took(file().takeText(intent_work_.text, "Unsaved work", intent_work_.file))) return;
  ++recoveries_;
  notices = {{}, "Brought back the unsaved work on " + intent_work_.name()};
}

void Session::watchFile(double elapsed_s) {
  constexpr double kEvery_s = 0.5;
  unwatched_s_ += elapsed_s;
  bool& outside = outside_[static_cast<std::size_t>(mode_)];
  if (unwatched_s_ < kEvery_s || outside || intent_ != Intent::none) return;
  unwatched_s_ = 0.0;
  if (!file().changedOutside()) return;
  std::error_code ignored;
  const bool there = fs::exists(file().path(), ignored);
  if (file().dirty() && there) {
    outside = true;
    return;
  }
  const std::string name = file().path().filename().string();
  if (!there) {
    file().keepOwn();
    notices.error = name + " is gone: another program removed or renamed it.\n  Saving writes it again.";
    return;
  }
  const auto read = file().reload();
  if (read) {
    notices.note = name + " was changed by another program and read again; undo brings back what was here.";
    return;
  }
  // What cannot be read now is tried again when it has changed once more.
  file().keepOwn();
  notices.error = "Another program changed the file, and it cannot be read any more. The last good state stays.\n  " + read.error().text();
}

void Session::reloadFile() {
  if (took(file().reload())) notices.note = "Read " + file().path().filename().string() + " again; undo brings back your own work.";
  outside_[static_cast<std::size_t>(mode_)] = false;
}

void Session::keepOwn() {
  file().keepOwn();
  outside_[static_cast<std::size_t>(mode_)] = false;
}

void Session::answer(Answer answer) {
  if (intent_ == Intent::none) return;
  const auto about = endangered();
  if (!about && askingAboutExports()) {
    if (answer == Answer::cancel) intent_ = Intent::none;
    wait_for_exports_ = answer == Answer::save;
    exports_given_up_ = answer == Answer::discard;
    if (exports_given_up_) goOn();
    return;
  }
  if (!about) return goOn();
  if (answer == Answer::discard) {
    given_up_[static_cast<std::size_t>(*about)] = true;
    return goOn();
  }
  if (answer == Answer::cancel) {
    intent_ = Intent::none;
    return;
  }
  setMode(*about);
  proceed_after_save_ = true;
  save();
}

const FileDocument& Session::fileOf(WorkMode which) const { return which == WorkMode::mission ? static_cast<const FileDocument&>(mission_->document) : document; }

std::string Session::title() const { return file().name() + (file().dirty() ? " *" : ""); }

void Session::save() {
  if (file().path().empty()) return showFiles(FilePanel::Mode::save_as);
  // What another program has written is not overwritten unseen.
  std::error_code ignored;
  if (file().changedOutside() && fs::exists(file().path(), ignored)) {
    outside_[static_cast<std::size_t>(mode_)] = true;
    return;
  }
  if (!took(file().save())) {
    proceed_after_save_ = false;
    return;
  }
  notices = {{}, "Saved " + file().path().string()};
  if (std::exchange(proceed_after_save_, false)) goOn();
}

void Session::showFiles(FilePanel::Mode wanted) {
  files.mode = wanted;
  const fs::path start = !file().path().empty() ? file().path().parent_path() : inMission() && !options_.missions.empty() ? options_.missions : files.listing.folder;
  files.name = wanted == FilePanel::Mode::save_as ? file().name() + std::string(file().ending()) : "";
  files.replacing.clear();
  files.listing = listFolder(start);
}

void Session::drop(const std::vector<fs::path>& paths) {
  if (paths.empty()) return;
  const fs::path& first = paths.front();
  std::error_code ignored;
  if (fs::is_directory(first, ignored)) {
    showFiles(FilePanel::Mode::open);
    return enterFolder(first);
  }
  if (first.extension() != ".json") {
    notices.error = first.filename().string() + " is neither a preset nor a mission.\n  Drop a *.npsee.json or *.mission.json file, or a folder with some.";
    return;
  }
  open(first);
  if (paths.size() > 1 && notices.error.empty()) notices.note = "Opened the first of " + std::to_string(paths.size()) + " files: one is worked on at a time.";
}

void Session::enterFolder(const fs::path& folder) { files.listing = listFolder(folder); }

void Session::confirmFiles() {
  if (files.name.empty()) {
    notices.error = "The name of the file is missing.\n  Write a name, or click one in the list.";
    return;
  }
  const fs::path path = (files.listing.folder / files.name).lexically_normal();
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    enterFolder(path);
    files.name.clear();
    return;
  }
  if (files.mode == FilePanel::Mode::open) return open(path);
  const fs::path target = file().fileFor(path);
  outside_[static_cast<std::size_t>(mode_)] = false;
  if (fs::exists(target, ignored) && target != file().path() && target != files.replacing) {
    files.replacing = target;
    return;
  }
  if (!took(file().saveAs(path))) return;
  notices = {{}, "Saved " + file().path().string()};
  const bool go_on = proceed_after_save_;
  closeFiles();
  if (go_on) goOn();
}

void Session::closeFiles() {
  files.mode = FilePanel::Mode::closed;
  // Leaving the panel without saving means the question is still open.
  proceed_after_save_ = false;
}

}  // namespace npsee::editor
