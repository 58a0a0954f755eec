#include "app/render/video.h"

#include "sim/core/descriptor.h"
#include "sim/core/files.h"
#include "sim/core/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace npsee::render {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Encoders work on a fixed number of threads: their bytes depend on it.
constexpr const char* kThreads = "2";

std::string_view nameOf(VideoFormat format) {
  switch (format) {
    case VideoFormat::mp4: return "mp4";
    case VideoFormat::webm: return "webm";
    case VideoFormat::gif: break;
  }
  return "gif";
}

/// What the encoder is told. Colours are converted to BT.709, which players take HD video for.
Words encoderWords(const VideoSettings& settings) {
  const std::string to_video = "scale=in_range=full:out_range=tv:out_color_matrix=bt709:flags=accurate_rnd+full_chroma_int+bicubic";
  const Words colours{"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"};
  Words out;
  switch (settings.format) {
    case VideoFormat::mp4:
      out = {"-vf", to_video, "-c:v", "libx264", "-preset", "medium", "-crf", "16", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
      break;
    case VideoFormat::webm:
      out = {"-vf", to_video, "-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "20", "-row-mt", "0", "-pix_fmt", settings.alpha ? "yuva420p" : "yuv420p"};
      // libvpx cannot look at alternative frames and keep alpha.
      if (settings.alpha) out.insert(out.end(), {"-auto-alt-ref", "0"});
      break;
    case VideoFormat::gif:
      return {"-filter_complex", "[0:v]split[a][b];[a]palettegen=stats_mode=diff:reserve_transparent=1[p];[b][p]paletteuse=dither=bayer:bayer_scale=4:alpha_threshold=128", "-loop", "0", "-threads", kThreads};
  }
  out.insert(out.end(), colours.begin(), colours.end());
  out.insert(out.end(), {"-threads", kThreads});
  return out;
}

Words ffmpegWords(const fs::path& program, const VideoSettings& s, const fs::path& out) {
  Words words{program.string(), "-hide_banner", "-nostdin", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgba", "-video_size", std::to_string(s.width) + 'x' + std::to_string(s.height), "-framerate",
              std::to_string(s.rate_numerator) + '/' + std::to_string(s.rate_denominator), "-i", "pipe:0"};
  const Words encoder = encoderWords(s);
  words.insert(words.end(), encoder.begin(), encoder.end());
  // Nothing of the encoder's version or of the time gets into the file.
  words.insert(words.end(), {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-f", std::string(nameOf(s.format)), "file:" + out.string()});
  return words;
}

/// Starts a program with our pipe as its input and `messages` as both outputs; -1 and errno if it cannot be.
pid_t start(const Words& words, int input, int messages) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t how;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&how);
  ::posix_spawn_file_actions_adddup2(&files, input, 0);
  ::posix_spawn_file_actions_adddup2(&files, messages, 1);
  ::posix_spawn_file_actions_adddup2(&files, messages, 2);
  // A process group of its own: Ctrl-C is for us, and we end it in order. SIGPIPE as programs expect it.
  sigset_t usual;
  ::sigemptyset(&usual);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGXFSZ}) ::sigaddset(&usual, signal);
  ::posix_spawnattr_setsigdefault(&how, &usual);
  ::posix_spawnattr_setpgroup(&how, 0);
  ::posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_t child = -1;
  const int error = ::posix_spawn(&child, argv[0], &files, &how, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  ::posix_spawnattr_destroy(&how);
  if (error == 0) return child;
  errno = error;
  return -1;
}

/// What is appended to a whole file, so that one that lost its end is known: in each format something that players skip. A comment of a
/// GIF goes before the GIF's last byte.
struct Seal {
  std::string before, after;
};
constexpr std::size_t kMostComment = 120;
constexpr char kGifTrailer = 0x3b;

Seal sealOf(VideoFormat format, std::size_t comment_bytes) {
  const char size = static_cast<char>(comment_bytes);
  switch (format) {
    case VideoFormat::mp4: return {std::string("\0\0\0", 3) + static_cast<char>(comment_bytes + 8) + "free", {}};  // a box: size, kind, content
    case VideoFormat::webm: return {std::string("\xec") + static_cast<char>(0x80 | size), {}};                      // a Void element: kind, size, content
    case VideoFormat::gif: break;
  }
  return {std::string("\x21\xfe") + size, std::string("\0", 1) + kGifTrailer};  // a comment: one block and the end of blocks
}

/// Appends the seal; false and errno if it cannot be written.
bool appendSeal(int file, VideoFormat format, const std::string& comment) {
  const Seal seal = sealOf(format, comment.size());
  const std::string block = seal.before + comment + seal.after;
  if (::lseek(file, format == VideoFormat::gif ? -1 : 0, SEEK_END) < 0) return false;
  const ssize_t written = ::write(file, block.data(), block.size());
  if (written >= 0 && written != static_cast<ssize_t>(block.size())) errno = ENOSPC;
  return written == static_cast<ssize_t>(block.size());
}

}  // namespace

struct VideoWriter::Impl {
  explicit Impl(TemporaryFile file) : temporary(std::move(file)) {}

  fs::path path;
  TemporaryFile temporary;
  VideoSettings settings;
  Descriptor input, messages;
  pid_t child = -1;

  ~Impl() {
    input.close();
    if (child > 0) {
      ::kill(child, SIGKILL);
      wait();
    }
  }

  /// ffmpeg's exit status, -1 if a signal ended it.
  int wait() {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    child = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// The last lines that ffmpeg wrote.
  std::string words() const {
    std::array<char, 2000> text{};
    const off_t size = ::lseek(messages.get(), 0, SEEK_END);
    const ssize_t n = ::pread(messages.get(), text.data(), text.size(), std::max<off_t>(size - static_cast<off_t>(text.size()), 0));
    std::string out(text.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    while (!out.empty() && (out.back() == '\n' || out.back() == '.')) out.pop_back();
    std::ranges::replace(out, '\n', ';');
    return out;
  }

  tl::unexpected<Error> refused() const {
    const std::string why = words();
    return fail(ErrorKind::output, {.what = "ffmpeg could not make the video" + (why.empty() ? std::string() : ": " + why) + '.', .remedy = "Debian's package ffmpeg has every encoder that is needed; nothing was changed.", .file = path.string(), .line = 0, .pointer = {}});
  }
};

VideoWriter::VideoWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Expected<fs::path> findFfmpeg() {
  const char* named = std::getenv("NPSEE_FFMPEG");
  const std::string name = named != nullptr && *named != '\0' ? named : "ffmpeg";
  const char* path = std::getenv("PATH");
  const auto usable = [](const fs::path& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) {
    if (usable(name)) return fs::path(name);
  } else {
    for (const std::string_view folder : splitAt(path != nullptr ? path : "/usr/bin:/bin", ':'))
      if (!folder.empty() && usable(fs::path(folder) / name)) return fs::path(folder) / name;
  }
  return fail(ErrorKind::output, "a video needs the program ffmpeg, and there is no " + name + " to run.", "Install Debian's package ffmpeg or name the program in NPSEE_FFMPEG; or write a sequence of pictures, -o frame_%04d.png.");
}

std::optional<std::string> videoComment(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> head{};
  file.read(head.data(), head.size());
  const std::string_view begin(head.data(), head.size());
  const VideoFormat format = begin == "GIF8" ? VideoFormat::gif : begin == "\x1a\x45\xdf\xa3" ? VideoFormat::webm : VideoFormat::mp4;
  if (!file || !file.seekg(0, std::ios::end)) return std::nullopt;
  std::array<char, kMostComment + 16> end{};
  const auto tail = std::min<std::streamoff>(file.tellg(), static_cast<std::streamoff>(end.size()));
  if (!file.seekg(-tail, std::ios::end) || !file.read(end.data(), tail)) return std::nullopt;
  const std::string_view text(end.data(), static_cast<std::size_t>(tail));
  for (std::size_t bytes = 1; bytes <= kMostComment; ++bytes) {
    const Seal seal = sealOf(format, bytes);
    const std::size_t whole = seal.before.size() + bytes + seal.after.size();
    if (whole <= text.size() && text.ends_with(seal.after) && text.substr(text.size() - whole).starts_with(seal.before)) return std::string(text.substr(text.size() - whole + seal.before.size(), bytes));
  }
  return std::nullopt;
}

Expected<VideoWriter> VideoWriter::open(const fs::path& path, const VideoSettings& settings) {
  const auto program = findFfmpeg();
  if (!program) return tl::unexpected<Error>(program.error());
  if (isSpecialFile(path)) return cannotWrite(path, "it is no regular file, and encoders go back in what they have written", "Write to a file.");
  auto temporary = TemporaryFile::beside(path);
  if (!temporary) return tl::unexpected<Error>(temporary.error());
  auto impl = std::make_unique<Impl>(std::move(*temporary));
  impl->path = path;
  impl->settings = settings;
  impl->messages = Descriptor(::memfd_create("ffmpeg", MFD_CLOEXEC));
  std::array<int, 2> pipe{};
  if (impl->messages.get() < 0 || ::pipe2(pipe.data(), O_CLOEXEC) != 0) return cannotWrite(path, std::strerror(errno));
  const Descriptor read_end(pipe[0]);
  impl->input = Descriptor(pipe[1]);
  impl->child = start(ffmpegWords(*program, settings, impl->temporary.path()), read_end.get(), impl->messages.get());
  if (impl->child < 0) return cannotWrite(path, program->string() + ": " + std::strerror(errno), "Name a program that can be run in NPSEE_FFMPEG, or unset it.");
  return VideoWriter(std::move(impl));
}

Expected<void> VideoWriter::add(const Image& frame) {
  const char* at = reinterpret_cast<const char*>(frame.rgba.data());
  std::size_t left = frame.rgba.size();
  while (left > 0) {
    const ssize_t n = ::write(impl_->input.get(), at, left);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      // It has gone; what it said tells why.
      impl_->input.close();
      if (impl_->child > 0) impl_->wait();
      return impl_->refused();
    }
    at += n;
    left -= static_cast<std::size_t>(n);
  }
  return {};
}

Expected<void> VideoWriter::finish() {
  impl_->input.close();
  if (impl_->child < 0 || impl_->wait() != 0) return impl_->refused();
  Descriptor file(::open(impl_->temporary.path().c_str(), O_RDWR | O_CLOEXEC));
  if (::lseek(file.get(), 0, SEEK_END) == 0) return impl_->refused();
  if (file.get() < 0 || !appendSeal(file.get(), impl_->settings.format, impl_->settings.comment.substr(0, kMostComment))) return cannotWrite(impl_->path, std::strerror(errno));
  file.close();
  return impl_->temporary.publish();
}

}  // namespace npsee::render
