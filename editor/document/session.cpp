#include "editor/document/session.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>
#include <utility>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// Patience with the compiler in a window: a quarter of a frame at 60 Hz; a script waits as long as it takes.
constexpr milliseconds kPatience{4}, kForever{600'000};
/// The first picture may take a little longer, so that most presets are there from the first frame.
constexpr milliseconds kFirstPatience{150};
/// Particles above which evaluating is shared between threads; below, starting them costs more.
constexpr std::size_t kManyParticles = 50'000;

std::vector<LibraryEntry> readLibrary(const fs::path& folder) {
  std::vector<LibraryEntry> out;
  for (const FolderListing::Entry& entry : listFolder(folder).entries) {
    if (entry.folder) continue;
    const fs::path path = fs::absolute(folder).lexically_normal() / entry.name;
    const auto preset = loadPreset(path);
    if (preset) out.push_back({path, preset->title, preset->description, true});
    else out.push_back({path, {}, preset.error().text(), false});
  }
  return out;
}

}  // namespace

Session::Session(SessionOptions options) : options_(std::move(options)) {
  if (!options_.library.empty()) library_ = readLibrary(options_.library);
}

void Session::update(double elapsed_s) {
  if (requested_revision_ != document.revision()) {
    requested_revision_ = document.revision();
    compiler_.request(document.snapshot(), requested_revision_);
  }
  takeCompiled();
  playback.advance(elapsed_s);
  if (!explosion_) return;
  const int threads = explosion_->particleCount() > kManyParticles ? static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 16u)) : 1;
  explosion_->at(playback.time_s, frame_, render::kSceneFields, threads);
  const auto end = frame_.alive.begin() + static_cast<std::ptrdiff_t>(frame_.count);
  sampleLaunch();
  alive_ = std::accumulate(frame_.alive.begin(), end, std::size_t{0});
}

void Session::sampleLaunch() {
  constexpr std::size_t kLargest = 200'000;
  const std::pair<const Explosion*, int> now{explosion_.get(), document.selected()};
  if (now == sampled_) return;
  sampled_ = now;
  sample_ = {};
  if (!document.hasLayer() || explosion_->particleCount() > kLargest) return;
  const Layer& layer = document.layer();
  const auto span = std::ranges::find(explosion_->layers(), layer.name, &LayerSpan::name);
  if (span == explosion_->layers().end() || !layer.parent.empty() || layer.duration_s > 0.0) return;
  explosion_->at(layer.start_s, launch_, kVelocity);
  // Frames show the size with its curve over life; what was drawn is the size without it.
  const double grown = layer.size_over_life.empty() ? 1.0 : layer.size_over_life.front().value;
  for (std::size_t i = span->first; i < span->first + span->count; ++i) {
    if (launch_.alive[i] == 0) continue;
    sample_.speed_mps.push_back(std::hypot(launch_.vx[i], launch_.vy[i], launch_.vz[i]));
    if (grown > 0.0) sample_.size_m.push_back(static_cast<float>(launch_.size[i] / grown));
  }
}

void Session::takeCompiled() {
  auto result = compiler_.poll(options_.wait_for_compile ? kForever : explosion_ ? kPatience : kFirstPatience);
  if (!result) return;
  if (!result->explosion) {
    notices.error = result->explosion.error().text() + "\n  The picture still shows the last good state.";
    return;
  }
  // The first particles of an empty preset come into view; afterwards the camera belongs to the person.
  if (explosion_ && explosion_->particleCount() == 0) frame_on_compile_ = true;
  explosion_ = std::move(*result->explosion);
  playback.setDuration(explosion_->duration_s());
  if (std::exchange(frame_on_compile_, false)) frameAll();
}

void Session::frameAll() {
  if (!explosion_) return;
  // An empty preset shows the ground that a usual effect needs.
  framed_extent_ = explosion_->particleCount() > 0 ? explosion_->extent() : Extent{{-15.0, 0.0, -15.0}, {15.0, 12.0, 15.0}};
  framed_ = camera = render::framing(framed_extent_, aspect_);
}

void Session::setAspect(double aspect) {
  if (aspect == aspect_) return;
  aspect_ = aspect;
  if (framed_ && camera == *framed_) framed_ = camera = render::framing(framed_extent_, aspect_);
}

double Session::radius_m() const { return explosion_ ? std::max(explosion_->extent().radius_m(), 0.1) : 20.0; }

bool Session::took(const Expected<void>& result) {
  if (result) {
    notices.note.clear();
    return true;
  }
  notices.error = result.error().text();
  return false;
}

void Session::startNew() { begin(Intent::start_new); }
void Session::open(const fs::path& path) { begin(Intent::open, path); }
void Session::quit() { begin(Intent::quit); }

void Session::begin(Intent intent, fs::path path) {
  intent_ = intent;
  intent_path_ = std::move(path);
  document.endMerge();
  if (!document.dirty()) proceed();
}

void Session::proceed() {
  const Intent intent = std::exchange(intent_, Intent::none);
  proceed_after_save_ = false;
  if (intent == Intent::quit) quitting_ = true;
  if (intent == Intent::open) loadNow(intent_path_);
  if (intent != Intent::start_new) return;
  document.startNew();
  frame_on_compile_ = true;
  notices = {};
}

void Session::loadNow(const fs::path& path) {
  if (!took(document.load(path))) return;
  notices = {{}, "Opened " + path.string()};
  frame_on_compile_ = true;
  playback.time_s = 0.0;
  closeFiles();
}

void Session::answer(Answer answer) {
  if (intent_ == Intent::none) return;
  if (answer == Answer::discard) return proceed();
  if (answer == Answer::cancel) {
    intent_ = Intent::none;
    return;
  }
  proceed_after_save_ = true;
  save();
}

void Session::save() {
  if (document.path().empty()) return showFiles(FilePanel::Mode::save_as);
  if (!took(document.save())) {
    proceed_after_save_ = false;
    return;
  }
  notices = {{}, "Saved " + document.path().string()};
  if (proceed_after_save_) proceed();
}

void Session::showFiles(FilePanel::Mode mode) {
  files.mode = mode;
  const fs::path start = !document.path().empty() ? document.path().parent_path() : files.listing.folder;
  files.name = mode == FilePanel::Mode::save_as ? document.name() + ".npsee.json" : "";
  files.replacing.clear();
  files.listing = listFolder(start);
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
  const fs::path target = Document::fileFor(path);
  if (fs::exists(target, ignored) && target != document.path() && target != files.replacing) {
    files.replacing = target;
    return;
  }
  if (!took(document.saveAs(path))) return;
  notices = {{}, "Saved " + document.path().string()};
  const bool go_on = proceed_after_save_;
  closeFiles();
  if (go_on) proceed();
}

void Session::closeFiles() {
  files.mode = FilePanel::Mode::closed;
  // Leaving the panel without saving means the question is still open.
  proceed_after_save_ = false;
}

std::string Session::title() const { return document.name() + (document.dirty() ? " *" : ""); }

}  // namespace npsee::editor
