#include "app/commands/interrupt.h"

#include <atomic>
#include <csignal>

namespace npsee::commands {
namespace {

std::atomic<int> signalled{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only touch what needs no lock");

void note(int signal) {
  signalled = signal;
  // The second one ends the process at once.
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
  // A signal that our caller had us ignore (nohup) stays ignored.
  for (const int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, note) == SIG_IGN) std::signal(signal, SIG_IGN);
}

Interrupt::~Interrupt() {
  for (const int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

bool Interrupt::requested() { return signalled != 0; }

void Interrupt::resume() {
  const int signal = signalled;
  if (signal == 0) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace npsee::commands
