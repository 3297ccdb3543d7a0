// Programs that are interrupted, or whose standard streams are closed, without losing a run.
#pragma once

#include <csignal>
#include <string>

namespace rupture::tools {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is only noted; one that comes more than half
/// a second later ends the process at once (a closed terminal sends two within a moment). Signals
/// that were ignored, as under nohup, stay ignored. One at a time.
class InterruptionNoted {
 public:
  InterruptionNoted();
  ~InterruptionNoted();
  InterruptionNoted(const InterruptionNoted&) = delete;
  InterruptionNoted& operator=(const InterruptionNoted&) = delete;
  InterruptionNoted(InterruptionNoted&&) = delete;
  InterruptionNoted& operator=(InterruptionNoted&&) = delete;

  /// The signal that came, or 0.
  static int signal();
};

/// Thrown when a run has stopped at a signal and everything is saved.
struct Interrupted {
  int signal;
  std::string message;
};

/// Puts /dev/null where a standard stream is closed, so that no file gets its number, which other
/// output would then go to. Reading and writing go on to fail.
void occupy_standard_streams();

/// From now on, writing to a pipe that nobody reads fails instead of ending the process.
void ignore_broken_pipes();

/// True if standard output is such a pipe.
bool nobody_reads_output();

/// Ends the process as the signal would have, so that a shell or a workflow sees why.
[[noreturn]] void end_by_signal(int signal);

}  // namespace rupture::tools
