// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// Stopping a run by Ctrl-C or kill without losing it.
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

/// Ends the process as the signal would have, so that a shell or a workflow sees why.
[[noreturn]] void end_by_signal(int signal);

}  // namespace rupture::tools
