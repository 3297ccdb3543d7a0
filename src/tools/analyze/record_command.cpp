#include "analyze/record_command.hpp"

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
}

}  // namespace

void add_window_options(po::options_description& options) {
  auto add = options.add_options();
  add("from", seconds(), "start of the time window");
  add("to", seconds(), "end of the time window");
}

RecordCommand read_record_command(int argc, const char* const* argv, const std::string& name,
                                  const std::string& purpose, po::options_description& options) {
  RecordCommand command;
  command.parsed =
      parse(argc, argv, {"analyze " + name, "analyze " + name + " RECORD [options]", purpose},
            options, "record", UsesParameters::no);
  const auto& values = command.parsed.values;
  if (values.count("event") > 0 && values.count("from") + values.count("to") > 0) {
    throw UsageError("--event and --from or --to exclude each other: give one of them");
  }
  command.record = read_record(single_input(values, "record", "a record"));
  if (command.record.time.empty()) throw Failure("the record holds no samples yet");
  const bool windowed = options.find_nothrow("from", false) != nullptr;
  command.from = command.record.time.front();
  command.to = command.record.time.back();
  if (windowed && values.count("from") > 0) command.from = non_negative(values, "from");
  if (windowed && values.count("to") > 0) command.to = non_negative(values, "to");
  if (options.find_nothrow("ruptured-below", false) != nullptr) {
    command.record.ruptures = ruptures_below(command.record, fraction(values, "ruptured-below"));
  }
  check_overlap(command);
  if (command.to < command.from)
    throw UsageError("the time window is empty: --to is before --from");
  return command;
}

}  // namespace rupture::tools
