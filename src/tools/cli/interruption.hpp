// Programs that are interrupted, or whose standard streams are closed, without losing a run.
#pragma once

#include <csignal>
#include <string>

namespace rupture::tools {

/// From now on, the first SIGINT, SIGTERM or SIGHUP, or SIGUSR1, SIGUSR2 or SIGXCPU, by which
/// schedulers warn, only stops the run; one that comes more than half a second later ends the
/// process at once (a closed terminal sends two within a moment). Signals that were ignored, as
/// under nohup, stay ignored.
void catch_interruptions();

/// The signal that came, or 0.
int interruption();

/// Thrown when a run has stopped at a signal and everything is saved.
struct Interrupted {
  int signal;
  std::string message;
};

/// Puts /dev/null where a standard stream is closed, so that no file gets its number, which other
/// output would then go to. Reading and writing still fail.
void occupy_standard_streams();

/// True if standard output is a pipe that nobody reads.
bool nobody_reads_output();

/// Ends the process as the signal would have, so that a shell or a workflow sees why.
[[noreturn]] void end_by_signal(int signal);

}  // namespace rupture::tools
