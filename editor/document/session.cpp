#include "editor/document/session.h"

#include "editor/mission/session.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>
#include <utility>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// Patience with the compiler in a window: a quarter of a frame at 60 Hz.
constexpr milliseconds kPatience{4};
/// The first picture may take a little longer, so that most presets are there from the first frame.
constexpr milliseconds kFirstPatience{150};
/// Particles above which evaluating is shared between threads; below, starting them costs more.
constexpr std::size_t kManyParticles = 50'000;

}  // namespace

Session::Session(SessionOptions options)
    : options_(std::move(options)), mission_(std::make_unique<MissionSession>(MissionSessionOptions{options_.wait_for_compile})) {
  readLibraries();
}

void Session::readLibraries() {
  library_ = files_known_.folder(options_.library, kPresetEnding);
  missions_ = files_known_.folder(options_.missions, kMissionEnding);
}

Session::~Session() = default;

void Session::update(double elapsed_s) {
  // What was asked about has ended by itself, or was saved meanwhile: then there is nothing left to ask.
  if (intent_ == Intent::quit && exporting == 0 && !endangered()) {
    if (wait_for_exports_) goOn();
    else intent_ = Intent::none;
  }
  watchFile(elapsed_s);
  if (!inMission()) return updateExplosion(elapsed_s);
  mission_->view.presets.clear();
  if (mission_->own_burst) mission_->view.presets[0] = document.snapshot();
  mission_->update(elapsed_s, notices);
}

bool Session::moving() const { return inMission() ? mission_->clock.playing || mission_->simulating() : playback.playing || compiling() || design.ease.moving() || compare.shelf.busy() || variations.shelf.busy(); }

void Session::updateExplosion(double elapsed_s) {
  if (requested_revision_ != document.revision()) {
    requested_revision_ = document.revision();
    followNames();
    compiler_.request(document.snapshot());
  }
  probeLayer();
  takeCompiled();
  playback.advance(elapsed_s);
  updateCompared();
  design.ease.update(document.snapshot(), document.hasLayer() ? document.selected() : -1, elapsed_s, scripted());
  if (!explosion_) return;
  evaluate();
}

/// Locks and layers shown alone go by name. They follow a layer that is named anew, wherever that was done; undo and redo do it too.
void Session::followNames() {
  const auto before = std::exchange(followed_, document.snapshot());
  if (before == nullptr || before->layers.size() != followed_->layers.size()) return;
  std::size_t changed = 0, which = 0;
  for (std::size_t i = 0; i < before->layers.size(); ++i)
    if (before->layers[i].name != followed_->layers[i].name) {
      ++changed;
      which = i;
    }
  if (changed == 1) design.rename(before->layers[which].name, followed_->layers[which].name);
}

/// Whether the next frames are evaluated ahead: while the effect is played in a window, on the grid of moments that will be shown.
bool Session::aheadOfTime() const {
  constexpr std::size_t kFewParticles = 2'000;  // evaluated faster than a thread is woken
  const std::size_t count = explosion_ ? explosion_->particleCount() : 0;
  return playback.playing && !options_.wait_for_compile && count >= kFewParticles && count * kFramesAhead <= kMostQueuedParticles;
}

double Session::shownTime() const { return aheadOfTime() ? std::min(onGrid(playback.time_s, Playback::kFrame_s * playback.speed), playback.duration_s) : playback.time_s; }

/// The frame shown, unless it is there already.
void Session::evaluate() {
  std::erase_if(design.solo, [&](const std::string& name) { return findLayer(document.preset(), name) < 0; });
  Evaluated wanted{explosion_, shownTime(), design.solo};
  if (wanted != evaluated_) {
    if (!aheadOfTime() || !queue_.take(explosion_.get(), wanted.time_s, frame_)) {
      const int threads = explosion_->particleCount() > kManyParticles ? static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 16u)) : 1;
      explosion_->at(wanted.time_s, frame_, render::kSceneFields, threads);
    }
    evaluated_ = std::move(wanted);
    ++frame_stamp_;
    showSolo();
    alive_ = std::accumulate(frame_.alive.begin(), frame_.alive.begin() + static_cast<std::ptrdiff_t>(frame_.count), std::size_t{0});
  }
  if (aheadOfTime()) planAhead();
}

void Session::planAhead() {
  // The next frame is expected as long after this one as this came after the last.
  const double shown = evaluated_.time_s, step = Playback::kFrame_s * playback.speed;
  if (shown == shown_s_) return;
  const double stride = std::clamp(std::round((shown - shown_s_) / step), 1.0, 12.0);
  shown_s_ = shown;
  std::vector<double> next;
  for (int k = 1; k <= kFramesAhead; ++k)
    if (const double time = (std::round(shown / step) + k * stride) * step; time < playback.duration_s) next.push_back(time);
  queue_.plan(explosion_, next);
}

/// The selected layer's launch, found beside; until then the one before is shown.
void Session::probeLayer() {
  constexpr std::size_t kMost = 20'000;  // of more, these say enough
  const std::pair now{document.snapshot(), document.hasLayer() ? document.selected() : -1};
  if (now == probed_) return;
  probed_ = now;
  compiler_.requestProbe(now.first, now.second, kMost);
}

void Session::showHistograms() {
  design.histograms.clear();
  const auto add = [&](const char* key, const std::vector<float>& probe) {
    const Histogram histogram = histogramOf(probe);
    if (histogram.spread()) design.histograms.emplace(key, histogram);
  };
  add("speed_deviation", design.probe.speed_mps);
  add("size_deviation", design.probe.size_m);
  add("lifetime_deviation", design.probe.lifetime_s);
  add("ejection_angle", design.probe.angle_rad);
}

void Session::showSolo() {
  if (design.solo.empty()) return;
  for (const LayerSpan& span : explosion_->layers()) {
    if (design.shows(span.name)) continue;
    const auto first = static_cast<std::ptrdiff_t>(span.first), end = static_cast<std::ptrdiff_t>(span.first + span.count);
    std::fill(frame_.alive.begin() + first, frame_.alive.begin() + end, std::uint8_t{0});
    std::fill(frame_.size.begin() + first, frame_.size.begin() + end, 0.0f);
    std::fill(frame_.a.begin() + first, frame_.a.begin() + end, 0.0f);
  }
}

void Session::takeCompiled() {
  // A script waits for all that was asked for.
  while (auto result = options_.wait_for_compile ? compiler_.pollAll() : compiler_.poll(explosion_ ? kPatience : kFirstPatience)) {
    takeResult(std::move(*result));
    if (!options_.wait_for_compile) return;
  }
}

void Session::takeResult(Compiler::Result result) {
  if (result.explosion && !*result.explosion) {
    notices.error = compile_error_ = result.explosion->error().text() + "\n  The picture still shows the last good state.";
  } else if (result.explosion) {
    if (notices.error == compile_error_) notices.error.clear();
    compile_error_.clear();
    // The first particles of an empty preset come into view; afterwards the camera belongs to the person.
    if (explosion_ && explosion_->particleCount() == 0) frame_on_compile_ = true;
    explosion_ = std::move(**result.explosion);
    playback.setDuration(explosion_->duration_s());
    if (std::exchange(frame_on_compile_, false)) frameAll();
  }
  if (result.moments) design.moments = *result.moments;
  if (!result.probe) return;
  design.probe = std::move(*result.probe);
  showHistograms();
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

}  // namespace npsee::editor
