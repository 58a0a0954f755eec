#include "editor/desk/child.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace npsee::editor {
namespace {

/// What a program may write before the rest is dropped; messages are short, and a runaway must not fill the memory.
constexpr std::size_t kMaxText = 4u << 20;

/// Between fork and exec only what is safe in a process with threads.
[[noreturn]] void becomeChild(char* const* arguments, int out, int err, pid_t parent) {
  // Ends with the editor, however that ends.
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  ::setpriority(PRIO_PROCESS, 0, 10);
  const int null = ::open("/dev/null", O_RDONLY);
  ::dup2(null, 0);
  ::dup2(out, 1);
  ::dup2(err, 2);
  ::execv(arguments[0], arguments);
  ::_exit(127);
}

void drain(Descriptor& pipe, std::string& into) {
  std::array<char, 8192> buffer{};
  while (pipe.valid()) {
    const ssize_t n = ::read(pipe.get(), buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return;  // nothing there yet
    if (n == 0) pipe.close();
    else if (into.size() < kMaxText) into.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

}  // namespace

Expected<Child> Child::start(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  std::array<int, 2> out{}, err{};
  const auto refused = [&] { return fail(ErrorKind::output, "no other process can be started: " + std::string(std::strerror(errno)) + ".", "Close other programs and try again."); };
  if (::pipe2(out.data(), O_CLOEXEC) != 0) return refused();
  Descriptor out_read(out[0]), out_write(out[1]);
  if (::pipe2(err.data(), O_CLOEXEC) != 0) return refused();
  Descriptor err_read(err[0]), err_write(err[1]);
  std::string name = program.string();
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{name.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t parent = ::getpid();
  Child child;
  child.id_ = ::fork();
  if (child.id_ < 0) return refused();
  if (child.id_ == 0) becomeChild(argv.data(), out_write.get(), err_write.get(), parent);
  for (const int fd : {out_read.get(), err_read.get()}) ::fcntl(fd, F_SETFL, O_NONBLOCK);
  child.out_pipe_ = std::move(out_read);
  child.err_pipe_ = std::move(err_read);
  return child;
}

Child::Child(Child&& other) noexcept { *this = std::move(other); }

Child& Child::operator=(Child&& other) noexcept {
  std::swap(id_, other.id_);
  out_pipe_ = std::move(other.out_pipe_);
  err_pipe_ = std::move(other.err_pipe_);
  out_.swap(other.out_);
  err_.swap(other.err_);
  std::swap(exit_code_, other.exit_code_);
  return *this;
}

Child::~Child() {
  if (id_ < 0) return;
  ::kill(id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

void Child::read() {
  drain(out_pipe_, out_);
  drain(err_pipe_, err_);
}

bool Child::running() {
  if (id_ < 0) return false;
  read();
  int status = 0;
  if (::waitpid(id_, &status, WNOHANG) == 0) return true;
  read();
  id_ = -1;
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return false;
}

void Child::wait() {
  while (running()) {
    std::array<pollfd, 2> polls{pollfd{out_pipe_.get(), POLLIN, 0}, pollfd{err_pipe_.get(), POLLIN, 0}};
    ::poll(polls.data(), polls.size(), 20);
  }
}

void Child::cancel() const {
  if (id_ > 0) ::kill(id_, SIGTERM);
}

std::string shellLine(const std::vector<std::string>& words) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,+%@";
  std::string out;
  for (const std::string& word : words) {
    if (!out.empty()) out += ' ';
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
      out += word;
      continue;
    }
    out += '\'';
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    out += '\'';
  }
  return out;
}

}  // namespace npsee::editor
