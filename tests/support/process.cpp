#include "tests/support/process.h"

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace npsee::test {
namespace {

[[noreturn]] void runChild(const std::string& program, const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment,
                           const std::string& folder, int out, int err) {
  for (const auto& [key, value] : environment) {
    if (value.empty()) ::unsetenv(key.c_str());
    else ::setenv(key.c_str(), value.c_str(), 1);
  }
  if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
  const int null = ::open("/dev/null", O_RDONLY);
  ::dup2(null, 0);
  ::dup2(out, 1);
  ::dup2(err, 2);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  ::_exit(127);
}

/// What takes longer hangs. Sanitizers make everything many times as slow.
#ifdef NPSEE_SANITIZED
constexpr std::chrono::minutes kPatience{20};
#else
constexpr std::chrono::minutes kPatience{2};
#endif

}  // namespace

ProcessResult run(const std::string& program, const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment,
                  const std::string& folder) {
  std::array<int, 2> out{}, err{};
  if (::pipe2(out.data(), O_CLOEXEC) != 0 || ::pipe2(err.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) runChild(program, arguments, environment, folder, out[1], err[1]);
  ::close(out[1]);
  ::close(err[1]);

  ProcessResult result;
  std::array<pollfd, 2> polls{pollfd{out[0], POLLIN, 0}, pollfd{err[0], POLLIN, 0}};
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  int open = 2;
  while (open > 0) {
    if (::poll(polls.data(), polls.size(), 1000) < 0) break;
    if (std::chrono::steady_clock::now() > deadline) {
      ::kill(child, SIGKILL);
      break;
    }
    for (std::size_t i = 0; i < polls.size(); ++i) {
      if (polls[i].fd < 0 || polls[i].revents == 0) continue;
      char buffer[65536];
      const ssize_t n = ::read(polls[i].fd, buffer, sizeof buffer);
      if (n > 0) {
        (i == 0 ? result.out : result.err).append(buffer, static_cast<std::size_t>(n));
      } else {
        polls[i].fd = -1;
        --open;
      }
    }
  }
  ::close(out[0]);
  ::close(err[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

std::string npseePath() { return NPSEE_BINARY; }

ProcessResult npseeRun(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment) {
  return run(NPSEE_BINARY, arguments, environment);
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "npsee-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string slurp(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void spill(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

}  // namespace npsee::test
