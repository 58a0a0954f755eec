#pragma once

namespace npsee::commands {

/// While one exists, SIGINT and SIGTERM (a batch system's time limit) only ask the work to stop, so that what is being written
/// gets finished. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool requested();
  /// Ends the process as the signal would have; returns if there was none.
  static void resume();
};

}  // namespace npsee::commands
