#include "run/summary.hpp"

#include <cmath>
#include <optional>

namespace rupture::tools {
namespace {

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Quantities row_of(const WrittenFile& file) {
  return {
      {"path", "", "path as given on the command line", file.path.string()},
      {"holds", "", "checkpoint or record", file.holds},
      {"checksum", "", "content checksum", file.checksum},
  };
}

Quantity row_of(const std::vector<WrittenFile>& files) {
  List list{row_of(WrittenFile{}), {}};
  for (const WrittenFile& file : files) list.elements.push_back(row_of(file));
  return {"files", "", "files written, in order", list};
}

Quantities rows_of(const EnergyBalance& energy) {
  return {
      {"supplied", "J", "work of the driving point and of the load", energy.supplied},
      {"stored", "J", "gain of all energies", energy.stored},
      {"damping", "J", "energy taken by damping", energy.damping},
      {"junctions", "J", "work done against the junctions", energy.junctions},
      {"relative_error", "1", "error, relative to the largest term", energy.relative_error()},
  };
}

Quantities row_of(const ImpossibleBlock& block) {
  return {
      {"x", "m", "position of the block", block.x},
      {"largest_sigma_bar", "1", "widest phi that it can have", if_finite(block.largest_sigma_bar)},
  };
}

Quantities row_of(const Difference& difference) {
  return {
      {"path", "", "dataset", difference.path},
      {"change", "", "values, type, shape, only_in_a (the original) or only_in_b (the edited file)",
       std::string(name_of(difference.change))},
      {"count", "1", "elements with other values; 0 for other changes",
       static_cast<std::int64_t>(difference.count)},
  };
}

std::int64_t changed_blocks(const PhiSummary& phi) {
  std::int64_t changed = 0;
  for (std::size_t i = 0; i < phi.before.size(); ++i) {
    if (phi.before[i].forces != phi.after[i].forces) ++changed;
  }
  return changed;
}

}  // namespace

std::string name_of(Ending ending) {
  switch (ending) {
    case Ending::quiet:
      return "quiet";
    case Ending::spanned:
      return "spanned";
    case Ending::interrupted:
      return "interrupted";
    case Ending::last_step:
      break;
  }
  return "end";
}

RunSummary summary_of_complete(const Checkpoint& end) {
  return {.ending = "complete", .time = time(end.parameters, end.state), .run = *end.run};
}

Quantities quantities_of(const RunSummary& s) {
  return {
      {"ending", "",
       "end, quiet, spanned (an event did), interrupted, or complete (nothing was left to do)",
       s.ending},
      {"time", "s", "simulated time at the end", s.time},
      {"steps", "1", "time steps taken", s.steps},
      {"simulated_time", "s", "simulated time of these steps", s.simulated_time},
      {"wall_time", "s", "wall-clock time of these steps", s.wall_time},
      {"ruptures", "1", "block ruptures since the run began, also before an interruption",
       s.run.ruptures},
      {"leading_edge_ruptured", "", "whether the block at the leading edge was among them",
       s.run.leading_edge_ruptured},
      {"energy", "", "energy account of these steps", Group{rows_of(s.energy)}},
      row_of(s.files),
  };
}

Quantities quantities_of(const PreparedSummary& s) {
  return {
      {"prestress", "1", "tau/p beyond the trigger region", if_finite(s.prestress)},
      {"error", "1", "largest relative error of a pinned block's prestress", if_finite(s.error)},
      {"sigma_bar", "1", "width of phi beyond the trigger region", if_finite(s.sigma_bar)},
      {"largest_sigma_bar", "1", "largest possible width of phi", if_finite(s.largest_sigma_bar)},
      {"F_T", "N", "driving force, which balances the prestress", s.F_T},
      {"blocks", "1", "interface blocks", s.blocks},
      {"depinned", "1", "blocks whose junctions slip", s.depinned},
      row_of(s.files),
  };
}

Quantities quantities_of(const PhiSummary& s) {
  const auto width = [](const BlockForces& block) { return if_finite(block.sigma_bar()); };
  List impossible{row_of(ImpossibleBlock{}), {}};
  for (const auto& block : s.impossible) impossible.elements.push_back(row_of(block));
  return {
      {"x", "m", "position of each interface block", each(s.before, &BlockForces::x)},
      {"slipping", "1", "fraction of slipping junctions of each block, before",
       each(s.before, &BlockForces::slipping)},
      {"sigma_bar_before", "1", "width of phi of each block, before", each(s.before, width)},
      {"sigma_bar_after", "1", "width of phi of each block, after", each(s.after, width)},
      {"changed", "1", "blocks that were changed", changed_blocks(s)},
      {"largest_change", "1", "largest change of a friction force, over the largest friction force",
       s.largest_change},
      {"impossible", "", "blocks that cannot have this phi and were not changed", impossible},
      row_of(s.files),
  };
}

Quantities quantities_of(const FinishedSummary& s) {
  return {
      {"samples", "1", "samples in the record", s.samples},
      {"time", "s", "time of the last sample", s.time},
      {"ignored_bytes", "1",
       "bytes of an incomplete piece at the end of the unfinished record, as after a kill",
       s.ignored_bytes},
      row_of(s.files),
  };
}

Quantities quantities_of(const SealSummary& s) {
  List differences{row_of(Difference{}), {}};
  for (const auto& difference : s.differences) differences.elements.push_back(row_of(difference));
  return {
      {"content_is_as_sealed", "", "whether only something outside the content was changed",
       s.content_is_as_sealed},
      {"sealed_checksum", "", "content checksum before the edit; empty if it is unknown",
       s.sealed_checksum},
      {"differences", "", "changes from --original, dataset by dataset; empty without it",
       differences},
      row_of(s.files),
  };
}

void print_if_asked(const Quantities& rows, const OutputOptions& output) {
  if (output.summary == Summary::json) print_json(rows);
}

std::vector<std::pair<std::string, Quantities>> summary_quantities() {
  const Quantities of_run = quantities_of(RunSummary{});
  return {{"load", of_run},
          {"restart", of_run},
          {"prepare", quantities_of(PreparedSummary{})},
          {"modify-phi", quantities_of(PhiSummary{})},
          {"finish", quantities_of(FinishedSummary{})},
          {"seal", quantities_of(SealSummary{})}};
}

}  // namespace rupture::tools
