// The commands that make a file anew (ProvenanceEntry::rebuild): complete, so that they need
// nothing but the parent, and canonical, so that equal content has equal commands.
//
// A command as a user types it is neither: it may name an INI file that has changed since, stop
// where the front happens to stop, or write several files at several times.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "run/resume.hpp"
#include "rupture/checkpoint/provenance.hpp"
#include "rupture/model/state.hpp"

namespace rupture::tools {

/// `tool` and --set NAME=VALUE for each parameter that is not what it was before: by default, or in
/// the parent. One that a law does not use counts as its default, as in the content checksum, so
/// that a parent of equal checksum will do.
std::vector<std::string> rebuild_command(const std::string& tool, const Parameters& before,
                                         const Parameters& parameters);

/// The command with all the tool's `own` options that have a value, defaults included. Their values
/// are numbers or texts, or they have none at all.
std::vector<std::string> with_options(std::vector<std::string> command,
                                      const po::options_description& own,
                                      const po::variables_map& values);

/// The chain of a checkpoint that a run writes at `step`. Its last entry, which names the run,
/// lacks only the time.
std::vector<ProvenanceEntry> run_until(std::vector<ProvenanceEntry> chain,
                                       const Parameters& parameters, const Clock& clock,
                                       std::int64_t step);

/// The chain of a record of which only what there is at `step`, at time `t`, is kept: its last
/// entry gets this time instead of the planned one. Without a command it stays as it is.
std::vector<ProvenanceEntry> cut_at(std::vector<ProvenanceEntry> chain,
                                    const Parameters& parameters, double t, std::int64_t step);

/// The chain of a record that ends at `step` and holds what `files` say.
std::vector<ProvenanceEntry> recorded_until(std::vector<ProvenanceEntry> chain,
                                            const Parameters& parameters, const Clock& clock,
                                            std::int64_t step, const RunFiles& files);

}  // namespace rupture::tools
