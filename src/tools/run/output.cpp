#include "run/output.hpp"

#include <cmath>
#include <set>

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

}  // namespace

void add_output_options(po::options_description& options, const std::string& holds) {
  const std::string help = holds + " to write";
  options.add_options()("output,o", output_file(holds)->required(), help.c_str())(
      "force,f", "replace existing files")("quiet,q", "print errors only")(
      "json", "print a summary as one JSON object; text goes to standard error");
}

void add_checkpoint_options(po::options_description& options) {
  add_output_options(options, "checkpoint");
}

OutputOptions output_options(const po::variables_map& values) {
  std::vector<std::filesystem::path> inputs;
  for (const auto* option : {"config", "profile", "original", "script"}) {
    if (values.count(option) > 0) inputs.emplace_back(values[option].as<std::string>());
  }
  return {.output = file_to_write(values, "output"),
          .inputs = std::move(inputs),
          .if_exists = values.count("force") > 0 ? IfExists::replace : IfExists::refuse,
          .is_quiet = values.count("quiet") > 0,
          .json = values.count("json") > 0};
}

void add_start_options(po::options_description& options) {
  options.add_options()("from-alarm",
                        "start from CHECKPOINT although an alarm stopped a run in that state");
}

Checkpoint read_start(const std::filesystem::path& path, const po::variables_map& values) {
  Checkpoint start = read_checkpoint(path);
  const bool is_wanted = values.count("from-alarm") > 0;
  if (start.alarm.empty() && !is_wanted) return start;
  if (start.alarm.empty()) {
    throw UsageError("{} is not the state of an alarm: leave out --from-alarm", path.string());
  }
  if (!is_wanted) refuse_state_of_alarm(start, path, ", or give --from-alarm");
  start.alarm.clear();
  try {
    check_finite(checkpoint_content(start));
  } catch (const Failure& failure) {
    throw Failure("{}: {}; start from an earlier checkpoint", path.string(), failure.what());
  }
  return start;
}

std::filesystem::path file_to_write(const po::variables_map& values, const std::string& option) {
  const auto name = values[option].as<std::string>();
  if (name.empty()) throw UsageError("the name of an output is empty; give the path of a file");
  if (name != "-") return name;
  throw UsageError(
      "--{} needs the path of a file (got -): checkpoints and records cannot go to standard output",
      option);
}

void check_distinct(const std::vector<std::filesystem::path>& files, const OutputOptions& output,
                    const std::filesystem::path& input) {
  namespace fs = std::filesystem;
  const auto resolved = [](const fs::path& path) {
    std::error_code error;  // is met again when the file is written
    const fs::path found = fs::weakly_canonical(path, error);
    return error ? path : found;
  };
  std::map<fs::path, fs::path> folders;  // a run can have thousands of files in one
  const auto place = [&](const fs::path& path) {
    std::error_code ignored;
    if (fs::is_symlink(path, ignored)) return resolved(fs::absolute(path));
    fs::path& folder = folders[path.parent_path()];
    if (folder.empty()) folder = resolved(fs::absolute(path).parent_path());
    return folder / path.filename();
  };
  std::set<fs::path> inputs, taken;
  if (!input.empty()) inputs.insert(place(input));
  for (const fs::path& path : output.inputs) inputs.insert(place(path));
  for (const fs::path& path : files) {
    const fs::path place_of_file = place(path);
    if (inputs.contains(place_of_file)) {
      throw UsageError("{} is the input, which is never changed: give another output",
                       path.string());
    }
    if (taken.insert(place_of_file).second) continue;
    throw UsageError("two outputs would have the name {}: give different names", path.string());
  }
}

void check_output(const OutputOptions& output, const std::filesystem::path& input) {
  check_distinct({output.output}, output, input);
  check_output(output.output, output.if_exists);
  try_output(output.output);
}

void announce(const WrittenFile& file, const OutputOptions& output) {
  output.say("wrote {}  {}\n", in_one_line(file.path.string()), labelled(file.checksum));
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

int write_and_report(FileKind kind, const Content& content, const Quantities& rows,
                     const std::string& text, const OutputOptions& output) {
  const WrittenFile file = {output.output, std::string(kind_name(kind)),
                            write_content(output.output, kind, content, output.if_exists)};
  output.say("{}", text);
  announce(file, output);
  if (output.json) print_json(with_files(rows, {file}));
  return kDone;
}

}  // namespace rupture::tools
