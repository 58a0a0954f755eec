#include "sim/observer/child.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace npsee::observer {
namespace {

constexpr rlim_t kCpuSeconds = 20;
constexpr rlim_t kMemoryBytes = 512u << 20;
constexpr double kWallSeconds = 60.0;
constexpr std::size_t kMaxReport = 1u << 20;
constexpr char kEnd = '\x04';

// Sanitizers reserve terabytes of addresses and map more at any time, so addresses cannot be limited under them; the rules' own
// limits (clips_host.h) still hold.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitMemory = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr bool kLimitMemory = false;
#else
constexpr bool kLimitMemory = true;
#endif
#else
constexpr bool kLimitMemory = true;
#endif

void limit(decltype(RLIMIT_CPU) what, rlim_t value) {
  rlimit now{};
  if (getrlimit(what, &now) != 0) return;
  now.rlim_cur = now.rlim_max == RLIM_INFINITY ? value : std::min(value, now.rlim_max);
  setrlimit(what, &now);
}

/// Bytes of addresses this process has: what the child inherits and may have beyond its own use.
rlim_t addressesInUse() {
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  return file >> pages ? pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void writeAll(int to, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t now = write(to, text.data() + done, text.size() - done);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) return;
    done += static_cast<std::size_t>(now);
  }
}

[[noreturn]] void beChild(int to, rlim_t inherited, const std::function<std::string()>& work) {
  // A crash of the child is told by the parent; nothing else may be printed, dumped or written.
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGXCPU}) signal(number, SIG_DFL);
  if (const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC); nowhere >= 0) {
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  limit(RLIMIT_CPU, kCpuSeconds);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  if (kLimitMemory && inherited > 0) limit(RLIMIT_AS, inherited + kMemoryBytes);
  std::string report;
  try {
    report = work();
  } catch (...) {
    _exit(3);
  }
  writeAll(to, report + kEnd);
  _exit(0);
}

double now() {
  timespec at{};
  clock_gettime(CLOCK_MONOTONIC, &at);
  return static_cast<double>(at.tv_sec) + static_cast<double>(at.tv_nsec) * 1e-9;
}

/// Reads until the end mark, the end of the pipe, or the time is over.
std::string readReport(int from) {
  std::string out;
  const double until = now() + kWallSeconds;
  char buffer[4096];
  while (out.size() < kMaxReport) {
    const double left = until - now();
    if (left <= 0.0) break;
    pollfd wait{from, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(left * 1000.0) + 1);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) break;
    const ssize_t got = read(from, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    out.append(buffer, static_cast<std::size_t>(got));
    if (out.back() == kEnd) break;
  }
  return out;
}

std::string howItEnded(int status) {
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) return "take too long when they are tried";
  // CLIPS and the standard library abort when an allocation fails.
  if (WIFSIGNALED(status) && WTERMSIG(status) != SIGABRT) return std::string("crash the rule engine when they are tried (") + strsignal(WTERMSIG(status)) + ")";
  return "use up the memory allowed when they are tried";
}

}  // namespace

Expected<std::string> runInChild(const std::string& who, const std::function<std::string()>& work) {
  int ends[2];
  const auto refused = [&who](const char* what) {
    return fail(ErrorKind::input, who + " cannot be tried in a process of their own: " + what + ": " + std::strerror(errno) + ".", "Close other programs and try again.");
  };
  if (pipe2(ends, O_CLOEXEC) != 0) return refused("pipe");
  const rlim_t inherited = addressesInUse();
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    return refused("fork");
  }
  if (child == 0) {
    close(ends[0]);
    beChild(ends[1], inherited, work);
  }
  close(ends[1]);
  std::string report = readReport(ends[0]);
  close(ends[0]);
  const bool whole = !report.empty() && report.back() == kEnd;
  // It has nothing more to say, or nothing in time.
  kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!whole) return fail(ErrorKind::input, who + " " + howItEnded(status) + ".", "Simplify them; docs/rules.md tells the limits.");
  report.pop_back();
  return report;
}

}  // namespace npsee::observer
