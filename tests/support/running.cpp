#include "tests/support/running.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace npsee::test {

Running::Running(const std::string& program, const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment) {
  std::array<int, 2> out{};
  if (::pipe2(out.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  child_ = ::fork();
  if (child_ == 0) {
    for (const auto& [key, value] : environment) ::setenv(key.c_str(), value.c_str(), 1);
    ::dup2(out[1], 1);
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  ::close(out[1]);
  out_ = out[0];
}

Running::~Running() {
  kill();
  ::close(out_);
}

std::string Running::readLines(int lines) {
  std::array<char, 4096> buffer{};
  while (std::ranges::count(read_, '\n') < lines) {
    const ssize_t n = ::read(out_, buffer.data(), buffer.size());
    if (n <= 0) break;
    read_.append(buffer.data(), static_cast<std::size_t>(n));
  }
  return read_;
}

void Running::kill() {
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
  child_ = -1;
}

}  // namespace npsee::test
