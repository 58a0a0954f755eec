#include "app/commands/render_pipeline.h"

#include "app/commands/bounded_queue.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
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

/// Closes a queue at the end of its scope.
struct Closing {
  BoundedQueue<Frame>& queue;
  ~Closing() { queue.close(); }
};

/// Encodes and writes pictures on several threads. The destructor waits for all of them.
class Writers {
 public:
  Writers(int threads, std::size_t pictures, const SavePicture& save)
      : save_(save), queue_(static_cast<std::size_t>(threads)), spare_(2 * static_cast<std::size_t>(threads) + 2), written_(pictures, 0) {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Writers() { finish(); }
  Writers(const Writers&) = delete;
  Writers& operator=(const Writers&) = delete;

  /// Hands a picture over; false once a picture could not be written. `picture` gets the memory of one that is done.
  bool write(std::size_t index, Picture& picture) {
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
    while (auto finished = queue_.pop()) {
      if (failed_) continue;
      auto result = save_(finished->index, finished->picture, encoder);
      if (result) {
        written_[finished->index] = 1;
        ++done_;
        spare_.push(std::move(finished->picture));
        continue;
      }
      const std::lock_guard lock(mutex_);
      failed_ = true;
      if (!error_ || finished->index < error_index_) {
        error_ = std::move(result.error());
        error_index_ = finished->index;
      }
      queue_.close();
    }
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
  std::vector<std::jthread> threads_;
};

}  // namespace

tl::unexpected<Error> stoppedEarly() { return fail(ErrorKind::output, "stopped before all pictures were drawn.", "What is written is whole; --resume goes on from there."); }

Expected<void> drawPictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots,
                            const std::function<Expected<void>(const Shot&, Picture&)>& take) {
  BoundedQueue<Frame> ahead(kFramesAhead), spare(kFramesAhead + 2);
  std::exception_ptr thrown;  // by the simulation; read when its thread has ended
  std::jthread simulation([&] {
    try {
      for (const Shot& shot : shots) {
        Frame frame = spare.tryPop().value_or(Frame{});
        job.explosion->at(shot.time_s, frame, render::kSceneFields, job.threads);
        if (!ahead.push(std::move(frame))) return;
      }
    } catch (...) {
      thrown = std::current_exception();
      ahead.close();
    }
  });
  // Lets a simulation that is still ahead go home, on every way out: its thread is waited for.
  const Closing closing{ahead};
  Expected<void> result;
  Picture picture;
  for (const Shot& shot : shots) {
    if (job.stopped && job.stopped()) {
      result = stoppedEarly();
      break;
    }
    std::optional<Frame> frame = ahead.pop();
    if (!frame) break;
    render::Scene scene = job.scene;
    scene.frame = &*frame;
    result = job.floats ? renderer.drawToFloats(scene, job.camera, job.width, job.height, *job.floats, picture.floats) : renderer.drawToImage(scene, job.camera, job.width, job.height, picture.image);
    if (result) result = take(shot, picture);
    if (!result) break;
    spare.push(std::move(*frame));
  }
  ahead.close();
  simulation.join();
  if (thrown) std::rethrow_exception(thrown);
  return result;
}

Expected<void> savePictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots, const SavePicture& save,
                            const std::function<void(std::size_t done)>& progress, std::vector<char>& saved) {
  Writers writers(writersFor(job), shots.size(), save);
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
