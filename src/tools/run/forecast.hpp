// Time, memory and disk of a run, forecast from what it will do and how fast this machine is.
//
// The constants come from measurements of lattices from 57 x 31 to 449 x 241 blocks (x86-64, Debian
// 12, gcc 12.2).
#pragma once

#include <cstdint>
#include <string>

#include "run/files.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture::tools {

enum class RunsFrom { equilibrium, checkpoint };
enum class End { known, at_the_latest };

/// The work of a run, as far as it costs something.
struct Workload {
  Parameters parameters;
  RunsFrom from = RunsFrom::checkpoint;
  std::int64_t first_step = 0, last_step = 0;
  End end = End::known;
  int threads = 1;
  std::int64_t checkpoints = 0;    ///< that at the end included
  std::int64_t samples = 0;        ///< of the record; 0 without one
  std::int64_t field_samples = 0;  ///< of its fields; 0 without them
};

/// The needs of a run. Ruptures in the record, 24 bytes each, are not counted.
struct Forecast {
  Workload work;
  double memory = 0;            ///< peak of the process [bytes]
  double checkpoint = 0;        ///< size of one checkpoint [bytes]
  double record = 0;            ///< size of the record, 0 without one [bytes]
  double equilibrium_time = 0;  ///< 0 if none is looked for [s]
  double time_per_step = 0;     ///< [s]

  std::int64_t steps() const { return work.last_step - work.first_step; }
  double simulated_time() const;  ///< [s]
  double disk() const;            ///< [bytes]
  double time() const;            ///< [s]
};

/// Takes steps from `state` for some tenths of a second and, if the run will look for an
/// equilibrium, finds that of a smaller slider.
Forecast forecast(const Workload& work, const State& state);

/// A few lines for people, and the same as one JSON object.
std::string text_of(const Forecast& forecast);
std::string json_text(const Forecast& forecast);

/// A slider near the equilibrium under its normal load, at once: uniformly compressed, with
/// unstretched junctions.
State roughly_loaded(const Parameters& parameters);

}  // namespace rupture::tools
