// The commands that make a file anew (ProvenanceEntry::rebuild). They are complete, so that they
// need nothing but the parent, and canonical, so that equal content has equal commands. A command
// as a user types it is neither: it may name an INI file that has changed since, stop where the
// front happens to stop, or write several files at several times.
#pragma once

#include "cli/command_line.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/state.hpp"

namespace rupture::tools {

struct RunPlan;

struct RebuildCommand {
  struct Option {
    std::string name, value;  ///< without its dashes; the value of a flag is empty
  };
  std::string tool;
  std::vector<Option> options = {};  ///< those in whose declaration is in_rebuild()

  /// The first option of this name; null if there is none.
  const Option* find(std::string_view name) const;
  std::string text() const;
};

/// The command of a step. None if it is not of this form, or has characters that mean more than
/// themselves to a shell.
std::optional<RebuildCommand> read_rebuild(const std::string& text);

/// `tool` and --set NAME=VALUE for each parameter that is not what it was before: by default, or in
/// the parent. One that a law does not use counts as its default, as in the content checksum, so
/// that a parent of equal checksum will do.
RebuildCommand rebuild_command(const std::string& tool, const Parameters& before,
                               const Parameters& parameters);

/// The command with all those of the tool's `own` options in_rebuild() that have a value, defaults
/// included. Their values are numbers or texts, or they have none at all.
RebuildCommand with_options(RebuildCommand command, AddOptions add_own,
                            const po::variables_map& values);

/// The chain of a checkpoint that a run writes at `step`. Its last entry, which names the run,
/// lacks only the time.
std::vector<ProvenanceEntry> run_until(std::vector<ProvenanceEntry> chain,
                                       const Parameters& parameters, const Clock& clock,
                                       std::int64_t step);

/// The chain of a record that ends with the samples it has: its last entry gets the time of the
/// last one instead of the planned one. Without a command it stays as it is.
std::vector<ProvenanceEntry> cut_at_end(const Record& record);

/// The chain of the run's record if that ends at `step`.
std::vector<ProvenanceEntry> recorded_until(const RunPlan& plan, std::int64_t step);

}  // namespace rupture::tools
