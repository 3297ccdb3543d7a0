// How far a run is, on standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

/// Shows percentage, simulated time, steps/s and the time left: on a terminal in one line that is
/// written anew and never wider than it; elsewhere in a line per tenth of the run, but none within
/// five seconds of another or of the start. Of a run until quiet only the latest end is known.
class Progress : public Observer {
 public:
  Progress(const Simulation& simulation, const StopRule& rule, std::string tool);
  std::int64_t next_step() const override { return next_; }
  void observe(const Simulation& simulation) override;

 private:
  using Clock = std::chrono::steady_clock;

  void redraw(const Simulation& simulation, double rate);
  void print_tenth(const Simulation& simulation, double rate);
  std::int64_t tenth_after(std::int64_t step) const;

  const bool until_quiet_;
  const std::string tool_;
  const std::int64_t first_, last_;  // of the whole run
  const std::int64_t begin_;         // of this part of it
  const Clock::time_point start_;
  Clock::time_point printed_;
  std::int64_t next_;
};

/// Clears the line that Progress has drawn on a terminal, if it has, so that other words begin one.
void clear_progress_line();

}  // namespace rupture::tools
