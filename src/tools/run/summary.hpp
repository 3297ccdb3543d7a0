// What the programs that write files have done, as they print it with --json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/quantity.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/compare.hpp"
#include "rupture/dynamics/energy.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

struct WrittenFile {
  std::filesystem::path path;
  std::string holds;     ///< "checkpoint" or "record"
  std::string checksum;  ///< of its content
};

/// Of load and restart.
struct RunSummary {
  std::string ending;                   ///< see name_of()
  double time = 0.0;                    ///< simulated, at the end [s]
  std::int64_t steps = 0;               ///< taken now, as is all that follows
  double simulated_time = 0.0;          ///< [s]
  double wall_time = 0.0;               ///< [s]
  EnergyBalance energy = {};            ///< [J]
  RunSoFar run = {};                    ///< since the run began, before an interruption too
  std::vector<WrittenFile> files = {};  ///< in their order
};

/// The word for it in JSON.
std::string name_of(Ending ending);

/// Of a run that was complete before: nothing was done.
RunSummary summary_of_complete(const Checkpoint& end);

/// Of prepare.
struct PreparedSummary {
  double prestress = 0.0;          ///< tau/p beyond the trigger region
  double error = 0.0;              ///< relative, the largest of all pinned blocks
  double sigma_bar = 0.0;          ///< of the last block
  double largest_sigma_bar = 0.0;  ///< that is possible
  double F_T = 0.0;                ///< [N]
  std::int64_t blocks = 0, depinned = 0;
  std::vector<WrittenFile> files = {};
};

/// Of modify-phi.
struct PhiSummary {
  std::vector<BlockForces> before = {}, after = {};
  std::vector<ImpossibleBlock> impossible = {};
  double largest_change = 0.0;  ///< of a block's friction force, over the largest of them
  std::vector<WrittenFile> files = {};
};

/// Of finish.
struct FinishedSummary {
  std::int64_t samples = 0;
  double time = 0.0;               ///< of the last one [s]
  std::int64_t ignored_bytes = 0;  ///< at the end of the unfinished record
  std::vector<WrittenFile> files = {};
};

/// Of seal.
struct SealSummary {
  std::string sealed_checksum;  ///< of the content before it was edited; empty if that is not known
  bool content_is_as_sealed = false;
  std::vector<Difference> differences = {};  ///< from the original, if one was given
  std::vector<WrittenFile> files = {};
};

Quantities quantities_of(const RunSummary& summary);
Quantities quantities_of(const PreparedSummary& summary);
Quantities quantities_of(const PhiSummary& summary);
Quantities quantities_of(const FinishedSummary& summary);
Quantities quantities_of(const SealSummary& summary);

/// Prints them as one JSON object if the options ask for it.
void print_if_asked(const Quantities& rows, const OutputOptions& output);

/// The rows of each of these programs.
std::vector<std::pair<std::string, Quantities>> summary_quantities();

}  // namespace rupture::tools
