#pragma once

#include "app/render/camera.h"
#include "app/render/renderer.h"
#include "editor/document/compare.h"
#include "editor/document/compiler.h"
#include "editor/document/design.h"
#include "editor/document/document.h"
#include "editor/document/folder.h"
#include "editor/document/frame_queue.h"
#include "editor/document/library.h"
#include "editor/document/playback.h"

#include <npsee/explosion.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {

class MissionSession;

/// What is being worked on; each keeps its own document, history and time line.
enum class WorkMode { explosion, mission };

/// What waits until the question about unsaved work is answered.
enum class Intent { none, start_new, open, quit, recover };
enum class Answer { save, discard, cancel };

/// The file panel: which of the two it is and what is typed in it.
struct FilePanel {
  enum class Mode { closed, open, save_as } mode = Mode::closed;
  FolderListing listing;
  std::string name;  ///< file name or path as typed
  std::filesystem::path replacing;  ///< another file that would be overwritten; the button then says so and asks once more
};

/// What the person is told. An error stays until it is dismissed or followed by another, and one about the
/// picture until that is right again; a note goes with the next edit.
struct Notices {
  std::string error;
  std::string note;
};

/// Work that an editor which ended without being asked has left behind.
struct UnsavedWork {
  WorkMode mode = WorkMode::explosion;
  std::filesystem::path file;  ///< that it belongs to; empty if it was never saved
  std::string text;            ///< as that file would hold it
  std::string name() const;    ///< of the file, or "untitled"
};

struct SessionOptions {
  std::filesystem::path library;  ///< folder whose presets the library lists; empty = none
  bool wait_for_compile = false;  ///< scripts: every frame shows the finished explosion
  std::filesystem::path missions = {};  ///< folder whose missions the library lists; empty = none
};

/// The editor without a picture: everything the panels show and change, and the rules between them. No ImGui, no GL.
class Session {
 public:
  explicit Session(SessionOptions options);
  ~Session();

  WorkMode mode() const { return mode_; }
  bool inMission() const { return mode_ == WorkMode::mission; }
  /// Shows the other document. A drag in the one before is over, and what the file panel asks about is no longer the document shown: it closes.
  void setMode(WorkMode wanted);
  /// The mission's part; there from the start, empty until one is opened.
  MissionSession& mission() { return *mission_; }
  const MissionSession& mission() const { return *mission_; }

  Document document;
  Playback playback;
  render::Camera camera;
  render::TemplateView template_view = render::TemplateView::surface;
  double template_yaw_rad = 0.6, template_pitch_rad = 0.35;
  Design design;
  Compare compare;
  Variations variations;
  FilePanel files;
  Notices notices;

  /// Lets time pass, hands changed presets to the compiler and evaluates the explosion at the moment shown.
  void update(double elapsed_s);

  /// Last good explosion and its state at `playback.time_s`; null before the first.
  const Explosion* explosion() const { return explosion_.get(); }
  const std::shared_ptr<const Explosion>& explosionShared() const { return explosion_; }
  const Frame& frame() const { return frame_; }
  /// The moment it shows: while playing ahead of time, the next one of the grid.
  double shownTime() const;
  /// Differs when the frame is another one.
  std::uint64_t frameStamp() const { return frame_stamp_; }
  std::size_t alive() const { return alive_; }
  bool compiling() const { return compiler_.busy(); }
  /// Scripts: nothing depends on how long a frame takes.
  bool scripted() const { return options_.wait_for_compile; }
  /// From now on as in a window, which nobody has to wait for.
  void goLive() { options_.wait_for_compile = false; }
  /// True while something changes by itself: time passes, or something is being computed.
  bool moving() const;

  /// Puts the whole effect into view.
  void frameAll();
  /// Width over height of the viewport. The effect stays framed in the new shape if nobody has moved the camera since.
  void setAspect(double aspect);
  double aspect() const { return aspect_; }
  /// Radius by which keyboard steps are sized, m.
  double radius_m() const;

  /// Runs an edit's result through the notices: an error is shown, success clears the note.
  bool took(const Expected<void>& result);

  /// Opening, starting anew and quitting ask first when there is unsaved work. A file's name says whether it is a preset or a mission;
  /// opening it changes the mode, and only the document it replaces is asked about.
  void startNew();
  void open(const std::filesystem::path& path);
  void quit();
  Intent asking() const { return intent_; }
  /// How many exports are at work, which quitting would cancel; told by whoever runs them.
  int exporting = 0;
  /// True if the question is about them and not about unsaved work. Saving is then answered by waiting for them.
  bool askingAboutExports() const { return intent_ == Intent::quit && exporting > 0 && !endangered(); }
  bool waitingForExports() const { return askingAboutExports() && wait_for_exports_; }
  /// Whose unsaved work the question is about.
  std::string askingAbout() const;
  void answer(Answer answer);
  bool quitting() const { return quitting_; }
  /// Opens unsaved work over its file's content, as a step that can be undone; asks first like open().
  void recover(const UnsavedWork& work);
  /// How often that was done: the question before it may also be cancelled.
  int recoveries() const { return recoveries_; }

  /// True while the mode's file holds something else than was read from it, and the document has unsaved work. Without any it is read again.
  bool outside() const { return outside_[static_cast<std::size_t>(mode_)]; }
  /// What was asked: read it again, or keep the document as it is and save over the file.
  void reloadFile();
  void keepOwn();

  /// Undo and redo of the mode's document.
  bool undo() { return file().undo(); }
  bool redo() { return file().redo(); }
  /// A drag is over.
  void endMerge() { file().endMerge(); }

  /// Saves to the document's file, or shows the file panel if it has none.
  void save();
  void showFiles(FilePanel::Mode mode);
  void enterFolder(const std::filesystem::path& folder);
  /// What the file panel's button does with the typed name: enter a folder, open or save.
  void confirmFiles();
  void closeFiles();

  const std::vector<LibraryEntry>& library() const { return inMission() ? missions_ : library_; }

  const std::vector<LibraryEntry>& presets() const { return library_; }
  const std::vector<LibraryEntry>& missionFiles() const { return missions_; }
  /// What a list shows of any preset or mission file.
  const LibraryEntry& libraryEntry(const std::filesystem::path& file) { return files_known_.entry(file); }
  /// Reads the libraries' folders again.
  void readLibraries();
  const SessionOptions& options() const { return options_; }

  /// Files or a folder that were dropped on the window: the first one is opened, a folder shown.
  void drop(const std::vector<std::filesystem::path>& paths);

  /// Presets to compare with; comparing begins where nothing was compared.
  void keepForComparing();
  void compareWithUndo(std::size_t back);  ///< the state that `back` undos lead to
  void compareWithFile(const std::filesystem::path& path);
  /// A is edited from now on, and B kept to compare with. One undo step.
  void swapCompared();
  /// Nine neighbours of the preset, or nine others.
  void showVariations();
  void adoptVariation(std::size_t index);

  /// "name *" as the window's title shows it.
  std::string title() const;
  /// The mode's document, whichever it is.
  const FileDocument& file() const { return fileOf(mode_); }
  FileDocument& file() { return const_cast<FileDocument&>(fileOf(mode_)); }

 private:
  void begin(Intent intent, std::filesystem::path path = {});
  void updateCompared();
  void compareWith(std::shared_ptr<const Preset> preset, std::string name);
  void gatherVariations();
  std::optional<WorkMode> endangered() const;
  void goOn();
  void proceed();
  const FileDocument& fileOf(WorkMode which) const;
  void updateExplosion(double elapsed_s);
  bool loadNow(const std::filesystem::path& path);
  void recoverNow();
  void startNewNow();
  void beginAnew();
  void followNames();
  void watchFile(double elapsed_s);
  void takeCompiled();
  bool aheadOfTime() const;
  void evaluate();
  void planAhead();
  void probeLayer();
  void showHistograms();
  void takeResult(Compiler::Result result);
  void showSolo();

  SessionOptions options_;
  WorkMode mode_ = WorkMode::explosion;
  Compiler compiler_;
  std::shared_ptr<const Explosion> explosion_;
  Frame frame_;
  FrameQueue queue_{render::kSceneFields};
  /// What the frame shows.
  struct Evaluated {
    std::shared_ptr<const Explosion> explosion;
    double time_s = -1.0;
    std::set<std::string> solo;
    friend bool operator==(const Evaluated&, const Evaluated&) = default;
  } evaluated_;
  std::uint64_t frame_stamp_ = 0;
  double shown_s_ = 0.0;  ///< moment of the last frame that was played
  std::size_t alive_ = 0;
  std::pair<std::shared_ptr<const Preset>, int> probed_{nullptr, -1};  ///< what the probe is of
  std::uint64_t requested_revision_ = 0;
  std::shared_ptr<const Preset> followed_;  ///< whose layers' names `design` knows
  std::string compile_error_;  ///< shown while the picture is not that of the preset
  std::pair<std::uint64_t, double> varied_{0, 0.0};  ///< revision and amount that the variations are of
  bool frame_on_compile_ = true;  ///< a new file is put into view, an edit is not
  double aspect_ = 1.6;
  Extent framed_extent_;
  std::optional<render::Camera> framed_;  ///< what frameAll last set
  Intent intent_ = Intent::none;
  std::filesystem::path intent_path_;
  UnsavedWork intent_work_;
  int recoveries_ = 0;
  double unwatched_s_ = 0.0;  ///< since the file was last looked at
  std::array<bool, 2> outside_{};  ///< by mode: its file was changed by another program
  std::array<bool, 2> given_up_{};  ///< by mode: its unsaved work may be lost
  bool wait_for_exports_ = false, exports_given_up_ = false;
  bool proceed_after_save_ = false;
  bool quitting_ = false;
  Library files_known_;
  std::vector<LibraryEntry> library_, missions_;
  std::unique_ptr<MissionSession> mission_;
};

}  // namespace npsee::editor
