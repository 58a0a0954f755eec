#include "app/commands/progress.h"

#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace npsee::commands {

std::string progressText(const std::string& what, std::size_t done, std::size_t total, double elapsed_s) {
  std::string text = what + ' ' + std::to_string(done) + " of " + std::to_string(total);
  if (total > 0) text += ", " + std::to_string(100 * done / total) + " %";
  if (done == 0 || elapsed_s < 0.5) return text;
  const double left_s = elapsed_s / static_cast<double>(done) * static_cast<double>(total - done);
  const auto whole = static_cast<long long>(std::ceil(left_s));
  text += ", " + (whole >= 120 ? std::to_string(whole / 60) + " min" : std::to_string(whole) + " s") + " left";
  return text;
}

Expected<ProgressMode> readProgress(const std::string& text) {
  if (text.empty() || text == "auto") return ProgressMode::terminal;
  if (text == "never") return ProgressMode::never;
  if (text == "always") return ProgressMode::lines;
  if (text == "steps") return ProgressMode::steps;
  return fail(ErrorKind::usage, "--progress " + text + ": there is no such way to show progress.", "Write auto, never or always; steps is for programs that show it.");
}

Progress::Progress(std::string what, std::size_t total, ProgressMode mode) : what_(std::move(what)), total_(total), mode_(mode), begin_(Clock::now()), last_(begin_) {
  if (mode_ == ProgressMode::terminal && (total_ < 2 || ::isatty(STDERR_FILENO) != 1)) mode_ = ProgressMode::never;
}

Progress::~Progress() {
  if (shown_ && mode_ == ProgressMode::terminal) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::size_t done) {
  if (mode_ == ProgressMode::never) return;
  const Clock::time_point now = Clock::now();
  const auto pause = mode_ == ProgressMode::lines ? std::chrono::milliseconds(5000) : std::chrono::milliseconds(100);
  // In a log the end is worth a line too.
  const bool end = mode_ != ProgressMode::terminal && done == total_;
  if (shown_ && now - last_ < pause && !end) return;
  last_ = now;
  shown_ = true;
  const std::string text = progressText(what_, done, total_, std::chrono::duration<double>(now - begin_).count());
  std::fprintf(stderr, mode_ != ProgressMode::terminal ? "%s\n" : "\r\x1b[K%s", text.c_str());
  std::fflush(stderr);
}

}  // namespace npsee::commands
