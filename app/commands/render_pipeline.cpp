#include "app/commands/render_pipeline.h"

#include "app/commands/bounded_queue.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace npsee::commands {
namespace {

/// Frames simulated ahead of the drawing.
constexpr std::size_t kFramesAhead = 3;
/// Bytes of pictures that may wait for encoding; fewer threads encode very large pictures.
constexpr std::size_t kWaitingBytes = 512u << 20;

/// Bytes of a picture; in single precision as many again, for encoding it.
std::size_t bytesOf(const PictureJob& job) {
  const std::size_t pixels = static_cast<std::size_t>(job.width) * static_cast<std::size_t>(job.height);
  if (!job.floats) return 4 * pixels;
  return 2 * sizeof(float) * pixels * ((job.floats->colour ? 4u : 0u) + (job.floats->depth ? 1u : 0u) + (job.floats->motion ? 2u : 0u));
}

/// Encoding threads, so that the pictures under way (per thread one waiting, one at work and one kept by the encoder, and two more)
/// stay within the bytes.
int writersFor(const PictureJob& job) {
  const std::size_t pictures = kWaitingBytes / bytesOf(job);
  return pictures < 5 ? 1 : static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(job.threads), (pictures - 2) / 3));
}

struct Finished {
  std::size_t index;
  Picture picture;
};

/// Encodes and writes pictures on several threads, or while one is handed over where none can be started. The destructor waits for all of them.
class Writers {
 public:
  Writers(int threads, std::size_t pictures, const SavePicture& save)
      : save_(save), queue_(static_cast<std::size_t>(threads)), spare_(2 * static_cast<std::size_t>(threads) + 2), written_(pictures, 0) {
    try {
      for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // Fewer do the same.
    }
  }
  ~Writers() { finish(); }
  Writers(const Writers&) = delete;
  Writers& operator=(const Writers&) = delete;

  /// Hands a picture over; false once a picture could not be written. `picture` gets the memory of one that is done.
  bool write(std::size_t index, Picture& picture) {
    if (threads_.empty()) {
      save({index, std::move(picture)}, encoder_);
      picture = spare_.tryPop().value_or(Picture{});
      return !failed_;
    }
    if (!queue_.push({index, std::move(picture)})) return false;
    picture = spare_.tryPop().value_or(Picture{});
    return true;
  }

  void finish() {
    queue_.close();
    threads_.clear();
  }
  std::size_t done() const { return done_; }

  /// After finish(): throws what a thread threw.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

  /// After finish(): the error of the earliest picture that has one.
  const std::optional<Error>& error() const { return error_; }
  const std::vector<char>& written() const { return written_; }

 private:
  void work() {
    try {
      saveAll();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failed_ = true;
      if (!thrown_) thrown_ = std::current_exception();
      queue_.close();
    }
  }
  void saveAll() {
    render::PngEncoder encoder;
    while (auto finished = queue_.pop())
      if (!failed_) save(std::move(*finished), encoder);
  }
  void save(Finished finished, render::PngEncoder& encoder) {
    auto result = save_(finished.index, finished.picture, encoder);
    if (result) {
      written_[finished.index] = 1;
      ++done_;
      spare_.push(std::move(finished.picture));
      return;
    }
    const std::lock_guard lock(mutex_);
    failed_ = true;
    if (!error_ || finished.index < error_index_) {
      error_ = std::move(result.error());
      error_index_ = finished.index;
    }
    queue_.close();
  }

  const SavePicture& save_;
  BoundedQueue<Finished> queue_;
  BoundedQueue<Picture> spare_;  // never full: there are fewer pictures about than it holds
  std::vector<char> written_;          // one byte each, so that threads do not share
  std::atomic<bool> failed_ = false;
  std::atomic<std::size_t> done_ = 0;
  std::mutex mutex_;
  std::optional<Error> error_;
  std::size_t error_index_ = 0;
  std::exception_ptr thrown_;
  render::PngEncoder encoder_;  // of write() where there are no threads
  std::vector<std::jthread> threads_;
};

/// Frames in the order of the shots, simulated ahead on a thread; each when it is asked for where none can be started.
class Simulation {
 public:
  Simulation(const PictureJob& job, const std::vector<Shot>& shots) : job_(job), shots_(shots) {
    try {
      thread_ = std::jthread([this] { work(); });
    } catch (const std::system_error&) {
      // next() does it.
    }
  }
  /// Lets a thread that is still ahead go home, on every way out: it is waited for.
  ~Simulation() { ahead_.close(); }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// The next frame; nothing after an exception.
  std::optional<Frame> next() { return thread_.joinable() ? ahead_.pop() : simulated(shots_[next_++]); }
  /// Takes back the memory of a frame that is drawn.
  void reuse(Frame frame) { spare_.push(std::move(frame)); }
  /// Ends the thread and throws what it threw.
  void finish() {
    ahead_.close();
    if (thread_.joinable()) thread_.join();
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  Frame simulated(const Shot& shot) {
    Frame frame = spare_.tryPop().value_or(Frame{});
    job_.explosion->at(shot.time_s, frame, render::kSceneFields, job_.threads);
    return frame;
  }
  void work() {
    try {
      for (const Shot& shot : shots_)
        if (!ahead_.push(simulated(shot))) return;
    } catch (...) {
      thrown_ = std::current_exception();
      ahead_.close();
    }
  }

  const PictureJob& job_;
  const std::vector<Shot>& shots_;
  std::size_t next_ = 0;
  BoundedQueue<Frame> ahead_{kFramesAhead}, spare_{kFramesAhead + 2};
  std::exception_ptr thrown_;  // read when the thread has ended
  std::jthread thread_;        // last, so that it ends before what it uses
};

}  // namespace

tl::unexpected<Error> stoppedEarly() { return fail(ErrorKind::output, "stopped before all pictures were drawn.", "What is written is whole; --resume goes on from there."); }

Expected<void> drawPictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots,
                            const std::function<Expected<void>(const Shot&, Picture&)>& take) {
  Simulation simulation(job, shots);
  Expected<void> result;
  Picture picture;
  for (const Shot& shot : shots) {
    if (job.stopped && job.stopped()) {
      result = stoppedEarly();
      break;
    }
    std::optional<Frame> frame = simulation.next();
    if (!frame) break;
    render::Scene scene = job.scene;
    scene.frame = &*frame;
    result = job.floats ? renderer.drawToFloats(scene, job.camera, job.width, job.height, *job.floats, picture.floats) : renderer.drawToImage(scene, job.camera, job.width, job.height, picture.image);
    if (result) result = take(shot, picture);
    if (!result) break;
    simulation.reuse(std::move(*frame));
  }
  simulation.finish();
  return result;
}

Expected<void> savePictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots, const SavePicture& save,
                            const std::function<void(std::size_t done)>& progress, std::vector<char>& saved) {
  Writers writers(std::min(writersFor(job), static_cast<int>(std::min<std::size_t>(shots.size(), 1024))), shots.size(), save);
  std::size_t next = 0;
  auto drawn = drawPictures(renderer, job, shots, [&](const Shot&, Picture& picture) -> Expected<void> {
    // The writers know the reason; any error ends the drawing.
    if (!writers.write(next++, picture)) return fail(ErrorKind::output, "a picture could not be written.");
    progress(writers.done());
    return {};
  });
  writers.finish();
  progress(writers.done());
  saved = writers.written();
  writers.rethrow();
  if (writers.error()) return tl::unexpected<Error>(*writers.error());
  return drawn;
}

}  // namespace npsee::commands
