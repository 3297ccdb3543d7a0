#include "run/output.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <set>

#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/model/error.hpp"

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

void add_output_options(po::options_description& options, const std::string& holds) {
  const std::string help = holds + " to write";
  options.add_options()("output,o", output_file(holds)->required(), help.c_str())(
      "force,f", "replace existing files")(
      "sum", "beside each file, write FILE.sum with its content checksum, for workflows")(
      "quiet,q", "print errors only")(
      "json", "print a summary as one JSON object; text goes to standard error");
}

void add_checkpoint_options(po::options_description& options) {
  add_output_options(options, "checkpoint");
}

OutputOptions output_options(const po::variables_map& values) {
  OutputOptions options;
  options.output = file_to_write(values, "output");
  if (values.count("force") > 0) options.if_exists = IfExists::replace;
  if (values.count("quiet") > 0) options.verbosity = Verbosity::quiet;
  if (values.count("sum") > 0) options.sum = SumFile::write;
  if (values.count("json") > 0) options.summary = Summary::json;
  return options;
}

std::filesystem::path file_to_write(const po::variables_map& values, const std::string& option) {
  const auto name = values[option].as<std::string>();
  if (name.empty()) throw UsageError("the name of an output is empty; give the path of a file");
  if (name != "-") return name;
  throw UsageError(fmt::format(
      "--{} needs the path of a file (got -): checkpoints and records cannot go to standard output",
      option));
}

void check_distinct(const std::vector<std::filesystem::path>& outputs,
                    const std::filesystem::path& input) {
  namespace fs = std::filesystem;
  std::map<fs::path, fs::path> folders;  // a run can have thousands of files in one
  const auto place = [&folders](const fs::path& path) {
    std::error_code ignored;  // is met again when the file is written
    if (fs::is_symlink(path, ignored)) return fs::weakly_canonical(fs::absolute(path));
    fs::path& folder = folders[path.parent_path()];
    if (folder.empty()) folder = fs::weakly_canonical(fs::absolute(path).parent_path());
    return folder / path.filename();
  };
  const fs::path place_of_input = input.empty() ? input : place(input);
  std::set<fs::path> taken;
  for (const fs::path& output : outputs) {
    for (const fs::path& file : {output, sum_path(output)}) {
      const fs::path place_of_file = place(file);
      if (place_of_file == place_of_input) {
        throw UsageError(fmt::format("{} is the input, which is never changed: give another output",
                                     file.string()));
      }
      if (taken.insert(place_of_file).second) continue;
      throw UsageError(
          fmt::format("two outputs would have the name {}: give different names", file.string()));
    }
  }
}

void check_outputs(const std::vector<std::filesystem::path>& outputs, IfExists if_exists,
                   const std::filesystem::path& input) {
  check_distinct(outputs, input);
  for (const auto& output : outputs) check_output(output, if_exists);
}

std::string wrote_text(const WrittenFile& file) {
  return fmt::format("wrote {}  {}\n", in_one_line(file.path.string()), labelled(file.checksum));
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
