#include "analyze/inputs.hpp"

#include <fmt/core.h>

#include "cli/option_values.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// A window beside the record is a mistake; one that reaches beyond it is not.
void check_overlap(const RecordCommand& command) {
  const double first = command.record.time.front(), last = command.record.time.back();
  const auto refuse = [&](const char* option, double t) {
    throw UsageError(
        fmt::format("{} {:g} is outside the record, which goes from {:.7g} s to {:.7g} s", option,
                    t, first, last));
  };
  if (command.from > last) refuse("--from", command.from);
  if (command.to < first) refuse("--to", command.to);
  if (command.to < command.from)
    throw UsageError("the time window is empty: --to is before --from");
}

}  // namespace

void add_window_options(po::options_description& options) {
  auto add = options.add_options();
  add("from", seconds(), "start of the time window");
  add("to", seconds(), "end of the time window");
}

RecordCommand record_of(const Parsed& parsed) {
  const auto& values = parsed.values;
  if (values.count("event") > 0 && values.count("from") + values.count("to") > 0) {
    throw UsageError("--event cannot be combined with --from or --to: give one of them");
  }
  RecordCommand command = {values, read_record(single_input(values, "record", "a record"))};
  if (command.record.time.empty()) throw Failure("the record holds no samples yet");
  command.from = optional_non_negative(values, "from").value_or(command.record.time.front());
  command.to = optional_non_negative(values, "to").value_or(command.record.time.back());
  if (values.count("ruptured-below") > 0) {
    command.record.ruptures = ruptures_below(command.record, fraction(values, "ruptured-below"));
  }
  check_overlap(command);
  return command;
}

Checkpoint checkpoint_of(const Parsed& parsed, const std::string& wanted) {
  return read_checkpoint(single_input(parsed.values, "checkpoint", wanted));
}

std::vector<std::string> files_of(const Parsed& parsed) {
  if (parsed.values.count("file") == 0) return {};
  auto files = parsed.values["file"].as<std::vector<std::string>>();
  refuse_empty_names(files);
  return files;
}

}  // namespace rupture::tools
