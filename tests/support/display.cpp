#include "tests/support/display.h"

#include <array>
#include <csignal>
#include <stdexcept>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace npsee::test {
namespace {

/// What Xvfb writes to its -displayfd once it accepts clients; empty if it ends or says nothing for half a minute.
std::string readDisplay(int from) {
  std::string out;
  pollfd waiting{from, POLLIN, 0};
  while (!out.ends_with('\n') && ::poll(&waiting, 1, 30'000) > 0) {
    std::array<char, 16> buffer{};
    const ssize_t n = ::read(from, buffer.data(), buffer.size());
    if (n <= 0) break;
    out.append(buffer.data(), static_cast<std::size_t>(n));
  }
  if (out.ends_with('\n')) out.pop_back();
  return out;
}

}  // namespace

VirtualDisplay::VirtualDisplay(const std::string& screen) {
  std::array<int, 2> channel{};
  if (::pipe(channel.data()) != 0) throw std::runtime_error("no pipe");
  const std::string number = std::to_string(channel[1]);
  server_ = ::fork();
  if (server_ == 0) {
    const int null = ::open("/dev/null", O_RDWR);
    for (const int standard : {0, 1, 2}) ::dup2(null, standard);
    ::close(channel[0]);
    ::execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp", "-noreset", nullptr);
    ::_exit(127);
  }
  ::close(channel[1]);
  const std::string display = readDisplay(channel[0]);
  ::close(channel[0]);
  if (!display.empty()) name_ = ':' + display;
  if (!name_.empty()) return;
  ::kill(server_, SIGKILL);
  ::waitpid(server_, nullptr, 0);
  throw std::runtime_error("Xvfb did not start; the package xvfb is needed");
}

VirtualDisplay::~VirtualDisplay() {
  ::kill(server_, SIGTERM);
  ::waitpid(server_, nullptr, 0);
}

std::string VirtualDisplay::xdotool(const std::vector<std::string>& words) const {
  std::vector<std::string> arguments{"xdotool"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const ProcessResult result = run("/usr/bin/env", arguments, environment());
  if (result.exit_code != 0) throw std::runtime_error("xdotool " + words.front() + ": " + result.err);
  return result.out;
}

ProcessResult VirtualDisplay::client(const std::vector<std::string>& words) const { return run(NPSEE_X_CLIENT, words, environment()); }

void VirtualDisplay::askToClose(const std::string& window) const {
  // Xlib is there because GLFW needs it; its headers need not be.
  struct Message {
    int type;
    unsigned long serial;
    int sent;
    void* display;
    unsigned long window, atom;
    int format;
    std::array<long, 5> data;
  };
  union Event {
    Message message;
    std::array<long, 24> room;
  };
  void* const x11 = ::dlopen("libX11.so.6", RTLD_NOW);
  if (x11 == nullptr) throw std::runtime_error("no libX11");
  const auto open = reinterpret_cast<void* (*)(const char*)>(::dlsym(x11, "XOpenDisplay"));
  const auto intern = reinterpret_cast<unsigned long (*)(void*, const char*, int)>(::dlsym(x11, "XInternAtom"));
  const auto send = reinterpret_cast<int (*)(void*, unsigned long, int, long, Event*)>(::dlsym(x11, "XSendEvent"));
  const auto close = reinterpret_cast<int (*)(void*)>(::dlsym(x11, "XCloseDisplay"));
  void* const display = open(name_.c_str());
  if (display == nullptr) throw std::runtime_error("no display " + name_);
  constexpr int kClientMessage = 33;
  Event event{};
  const unsigned long target = std::stoul(window);
  event.message = {kClientMessage, 0, 1, display, target, intern(display, "WM_PROTOCOLS", 0), 32, {static_cast<long>(intern(display, "WM_DELETE_WINDOW", 0)), 0, 0, 0, 0}};
  send(display, target, 0, 0, &event);
  close(display);
}

}  // namespace npsee::test
