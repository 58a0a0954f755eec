#pragma once

#include "editor/desk/writer.h"
#include "editor/document/session.h"
#include "sim/core/descriptor.h"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {

/// Keeps unsaved work safe from a kill at any moment. Each running editor holds a lock on a file of its own in the folder, and writes its
/// unsaved documents beside it; the kernel releases the lock when the process ends, however it ends. What lies beside a lock that nobody
/// holds was left behind, and is offered.
class Recovery {
 public:
  /// An empty folder keeps nothing.
  Recovery(std::filesystem::path folder, Writer& writer);
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Work found at the start that nobody has decided on.
  const std::vector<UnsavedWork>& found() const { return found_; }
  /// The first one found is brought back into the session, once its question about other unsaved work is answered; or thrown away.
  void bringBack(Session& session);
  bool bringingBack() const { return pending_; }
  /// Why unsaved work cannot be kept or read, once.
  std::string takeProblem() { return std::exchange(problem_, {}); }
  void throwAway();
  /// What was found stays for the next start.
  void later() { found_.clear(); }

  /// Writes what has changed, at most twice a second; `wait` until it is on the disk.
  void update(double elapsed_s, const Session& session, bool wait);
  /// The editor ends after its questions were answered: nothing is left behind. Without this call what is unsaved stays.
  void finish();
  /// True if nothing would be lost by a kill now.
  bool safe(const Session& session) const;

 private:
  struct Kept {
    std::uint64_t revision = 0;  ///< that is on the disk, or on its way
    bool written = false;
    std::uint64_t number = 0;    ///< of the writer's task
    double since_s = 1e9;        ///< the last write
  };
  std::filesystem::path recordOf(const std::string& session, WorkMode mode) const;
  enum class Locked { yes, taken, impossible };
  Locked lockOwn();
  void search();
  void searchBeside(const std::filesystem::path& lock);
  void update(double elapsed_s, const FileDocument& document, WorkMode mode);
  void forgetFirst();
  void removeLock(const std::filesystem::path& lock);

  std::filesystem::path folder_;
  Writer& writer_;
  std::string own_;  ///< name of this session's files, without endings
  Descriptor lock_;
  std::array<Kept, 2> kept_;
  std::vector<UnsavedWork> found_;
  struct Record {
    std::filesystem::path file;
    std::filesystem::path lock;
  };
  std::vector<Record> records_;      ///< of what was found
  std::vector<Descriptor> taken_;    ///< locks of dead sessions, so that no other editor offers the same
  std::vector<Record> adopted_;      ///< brought back, but not yet written under our own name
  bool pending_ = false;             ///< the first one found is being brought back; there may be a question before
  std::string problem_;
  int recoveries_ = 0;               ///< of the session before that
};

/// The file's text of unsaved work, and the other way. Error kind input.
std::string unsavedText(const UnsavedWork& work);
Expected<UnsavedWork> parseUnsaved(std::string_view text, std::string_view name);

}  // namespace npsee::editor
