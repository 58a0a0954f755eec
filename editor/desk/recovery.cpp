#include "editor/desk/recovery.h"

#include "editor/mission/session.h"
#include "sim/core/files.h"
#include "sim/core/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

constexpr double kEvery_s = 0.5;
constexpr std::string_view kLock = ".lock";
constexpr std::uint64_t kNever = ~std::uint64_t{0};  ///< no document's revision
constexpr std::array kModes{WorkMode::explosion, WorkMode::mission};

const FileDocument& documentOf(const Session& session, WorkMode mode) {
  return mode == WorkMode::mission ? static_cast<const FileDocument&>(session.mission().document) : session.document;
}

/// Whether the file holds the work already: the kill came between saving and tidying up.
bool savedMeanwhile(const UnsavedWork& work) {
  if (work.file.empty()) return false;
  if (work.mode == WorkMode::explosion) {
    const auto held = loadPreset(work.file);
    const auto unsaved = parsePreset(work.text, "unsaved work");
    return held && unsaved && *held == *unsaved;
  }
  const auto held = loadScenario(work.file);
  return held && scenarioText(*held) == work.text;
}

}  // namespace

std::string unsavedText(const UnsavedWork& work) {
  const nlohmann::ordered_json json{{"npsee_unsaved", 1}, {"kind", work.mode == WorkMode::mission ? "mission" : "preset"}, {"file", work.file.string()}, {"text", work.text}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

Expected<UnsavedWork> parseUnsaved(std::string_view text, std::string_view name) {
  const auto json = JsonText::parse(text, name);
  if (!json) return tl::unexpected<Error>(json.error());
  const auto& root = json->root();
  const auto word = [&](const char* key) { return root.contains(key) && root[key].is_string() ? root[key].get<std::string>() : std::string(); };
  const std::string kind = root.is_object() ? word("kind") : std::string();
  if (kind != "preset" && kind != "mission") return tl::unexpected<Error>(Error{ErrorKind::input, {json->fault("", "is no unsaved work of this editor.")}});
  return UnsavedWork{kind == "mission" ? WorkMode::mission : WorkMode::explosion, word("file"), word("text")};
}

Recovery::Recovery(fs::path folder, Writer& writer) : folder_(std::move(folder)), writer_(writer) {
  if (folder_.empty()) return;
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  search();
  // Another editor that starts just now may take a fresh lock for one left behind.
  constexpr int kTries = 20;
  Locked locked = Locked::taken;
  for (int i = 0; i < kTries && locked == Locked::taken; ++i) locked = lockOwn();
  if (locked == Locked::yes) return;
  lock_ = Descriptor();
  problem_ = "Unsaved work cannot be kept for the case that the editor ends unasked: no file can be locked in " + folder_.string() + ".\n  Save more often, or set XDG_STATE_HOME to a folder on a local disk.";
}

Recovery::~Recovery() {
  if (own_.empty()) return;
  writer_.wait();
  std::error_code ignored;
  if (std::ranges::none_of(kept_, &Kept::written)) fs::remove(folder_ / (own_ + std::string(kLock)), ignored);
}

void Recovery::finish() {
  if (own_.empty()) return;
  for (const WorkMode mode : kModes) writer_.remove(recordOf(own_, mode));
  for (const Record& record : adopted_) {
    writer_.remove(record.file);
    removeLock(record.lock);
  }
  adopted_.clear();
  kept_ = {};
}

/// Removes a dead session's lock unless other work lies beside it.
void Recovery::removeLock(const fs::path& lock) {
  if (std::ranges::none_of(records_, [&](const Record& other) { return other.lock == lock; })) writer_.remove(lock);
}

fs::path Recovery::recordOf(const std::string& session, WorkMode mode) const { return folder_ / (session + (mode == WorkMode::mission ? ".mission.unsaved" : ".preset.unsaved")); }

/// Makes this session's lock. `taken` if another editor, just starting, took it for one left behind: then another name is tried.
Recovery::Locked Recovery::lockOwn() {
  std::string name = (folder_ / ("session-XXXXXX" + std::string(kLock))).string();
  lock_ = Descriptor(::mkostemps(name.data(), static_cast<int>(kLock.size()), O_CLOEXEC));
  if (!lock_.valid()) return Locked::impossible;
  struct stat status {};
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK || errno == EINTR) return Locked::taken;
    ::unlink(name.c_str());
    return Locked::impossible;
  }
  if (::fstat(lock_.get(), &status) != 0 || status.st_nlink == 0) return Locked::taken;
  own_ = fs::path(name).stem().string();
  return Locked::yes;
}

void Recovery::search() {
  std::error_code error;
  std::vector<fs::path> locks;
  for (auto entry = fs::directory_iterator(folder_, error); !error && entry != fs::end(entry); entry.increment(error))
    if (entry->path().extension() == kLock) locks.push_back(entry->path());
  std::ranges::sort(locks);
  for (const fs::path& lock : locks) searchBeside(lock);
}

void Recovery::searchBeside(const fs::path& lock) {
  Descriptor held(::open(lock.c_str(), O_RDWR | O_CLOEXEC));
  if (!held.valid() || ::flock(held.get(), LOCK_EX | LOCK_NB) != 0) return;  // its editor is running
  std::error_code ignored;
  bool any = false;
  for (const WorkMode mode : kModes) {
    const fs::path file = recordOf(lock.stem().string(), mode);
    if (!fs::exists(file, ignored)) continue;
    const auto text = readTextFile(file);
    if (!text) {
      // It stays, with its lock, for a start at which it can be read.
      any = true;
      problem_ = "Unsaved work was found that cannot be read now.\n  " + text.error().text();
      continue;
    }
    auto work = parseUnsaved(*text, file.string());
    if (!work) {
      fs::path bad = file;
      fs::rename(file, bad += ".bad", ignored);
      problem_ = "Unsaved work was found that makes no sense; it is kept as " + bad.string() + ".\n  " + work.error().text();
      continue;
    }
    if (savedMeanwhile(*work)) {
      fs::remove(file, ignored);
      continue;
    }
    any = true;
    found_.push_back(std::move(*work));
    records_.push_back({file, lock});
  }
  if (any) taken_.push_back(std::move(held));
  else fs::remove(lock, ignored);
}

void Recovery::forgetFirst() {
  found_.erase(found_.begin());
  records_.erase(records_.begin());
}

void Recovery::bringBack(Session& session) {
  if (found_.empty()) return;
  pending_ = true;
  recoveries_ = session.recoveries();
  session.recover(found_.front());
}

void Recovery::throwAway() {
  if (found_.empty()) return;
  const Record record = records_.front();
  forgetFirst();
  writer_.remove(record.file);
  removeLock(record.lock);
}

void Recovery::update(double elapsed_s, const Session& session, bool wait) {
  if (folder_.empty()) return;
  if (pending_ && session.asking() == Intent::none) {
    pending_ = false;
    if (session.recoveries() != recoveries_) {
      adopted_.push_back(records_.front());
      forgetFirst();
    }
  }
  for (const WorkMode mode : kModes) update(elapsed_s, documentOf(session, mode), mode);
  // What was brought back is removed only after it was written under our own name. A question about other unsaved work may be open until then.
  if (!adopted_.empty() && session.asking() == Intent::none && safe(session)) {
    for (const Record& record : adopted_) {
      writer_.remove(record.file);
      removeLock(record.lock);
    }
    adopted_.clear();
  }
  if (wait) writer_.wait();
}

void Recovery::update(double elapsed_s, const FileDocument& document, WorkMode mode) {
  Kept& kept = kept_[static_cast<std::size_t>(mode)];
  kept.since_s += elapsed_s;
  if (kept.written && writer_.fateOf(kept.number) == Writer::Fate::failed) {
    constexpr double kAgain_s = 5.0;  // a full disk is not asked all the time
    kept = {kNever, false, 0, kEvery_s - kAgain_s};
  }
  if (kept.revision == document.revision() && kept.written == document.dirty()) return;
  if (!document.dirty()) {
    if (kept.written) writer_.remove(recordOf(own_, mode));
    kept = {document.revision(), false, 0, kept.since_s};
    return;
  }
  if (kept.since_s < kEvery_s || own_.empty()) return;
  std::error_code ignored;
  const fs::path file = document.path().empty() ? fs::path() : fs::absolute(document.path(), ignored);
  const std::uint64_t number = writer_.write(recordOf(own_, mode), unsavedText({mode, file, document.text()}));
  kept = {document.revision(), true, number, 0.0};
}

bool Recovery::safe(const Session& session) const {
  return std::ranges::all_of(kModes, [&](WorkMode mode) {
    const FileDocument& document = documentOf(session, mode);
    const Kept& kept = kept_[static_cast<std::size_t>(mode)];
    return !document.dirty() || (kept.written && kept.revision == document.revision() && writer_.fateOf(kept.number) == Writer::Fate::written);
  });
}

}  // namespace npsee::editor
