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

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), terminal_(total > 1 && ::isatty(STDERR_FILENO) == 1), begin_(Clock::now()), last_(begin_) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::size_t done) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (shown_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  shown_ = true;
  const std::string text = progressText(what_, done, total_, std::chrono::duration<double>(now - begin_).count());
  std::fprintf(stderr, "\r\x1b[K%s", text.c_str());
  std::fflush(stderr);
}

}  // namespace npsee::commands
