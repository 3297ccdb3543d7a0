#include "run/summary.hpp"

#include <fmt/core.h>

#include <cmath>

#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"

namespace rupture::tools {
namespace {

Quantities row_of(const WrittenFile& file) {
  return {
      {"path", "", "path as given on the command line", file.path.string()},
      {"holds", "", "checkpoint or record", file.holds},
      {"checksum", "", "content checksum", file.checksum},
  };
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

}  // namespace

std::string wrote_text(const WrittenFile& file) {
  return fmt::format("wrote {}  {}\n", in_one_line(file.path.string()), labelled(file.checksum));
}

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
  const Quantities rows = {
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
  };
  return with_files(rows, s.files);
}

Quantities with_files(Quantities rows, const std::vector<WrittenFile>& files) {
  List list{row_of(WrittenFile{}), {}};
  for (const WrittenFile& file : files) list.elements.push_back(row_of(file));
  rows.push_back({"files", "", "files written, in order", list});
  return rows;
}

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void print_if_asked(const Quantities& rows, const OutputOptions& output) {
  if (output.summary == Summary::json) print_json(rows);
}

WrittenFile write(const Checkpoint& checkpoint, const OutputOptions& output) {
  return {output.output, "checkpoint",
          write_checkpoint(output.output, checkpoint, output.if_exists, output.sum)};
}

WrittenFile write(FileKind kind, const Content& content, const OutputOptions& output) {
  return {output.output, std::string(kind_name(kind)),
          write_content(output.output, kind, content, output.if_exists, output.sum)};
}

int report(const Quantities& rows, const std::string& text, const WrittenFile& file,
           const OutputOptions& output) {
  if (output.verbosity == Verbosity::normal) {
    say_on(output.text(), "{}{}", text, wrote_text(file));
  }
  print_if_asked(with_files(rows, {file}), output);
  return kDone;
}

}  // namespace rupture::tools
