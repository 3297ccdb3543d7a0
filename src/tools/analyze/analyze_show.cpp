// analyze show: what a file is, its parameters and where it comes from.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/record.hpp"

namespace rupture::tools {
namespace {

std::string kind_summary(const ContentFile& file) {
  if (file.kind == FileKind::checkpoint) {
    const Checkpoint checkpoint = checkpoint_from(file.content);
    return fmt::format("checkpoint at t = {:.9g} s, step {}\n",
                       time(checkpoint.parameters, checkpoint.state), checkpoint.state.step);
  }
  const Record record = record_from(file);
  if (record.time.empty()) return fmt::format("{} without samples\n", kind_name(file.kind));
  return fmt::format("{} of {} samples from t = {:.9g} s to {:.9g} s, {} block ruptures\n",
                     kind_name(file.kind), record.time.size(), record.time.front(),
                     record.time.back(), record.ruptures.size());
}

}  // namespace

std::string alarm_text(const Content& content) {
  if (!content.contains(kAlarmPath)) return "";
  return fmt::format("an alarm stopped the run in this state, which means nothing: {}\n",
                     in_one_line(read_text(content, kAlarmPath)));
}

namespace {

int show(const Parsed& parsed) {
  const auto path = single_input(parsed.values, "file", "a file");
  const ContentFile file = read_file(path);
  const Parameters parameters = read_parameters(file.content);
  const auto chain = read_provenance(file.content);
  if (parsed.values.count("json") > 0) {
    Json json = {{"kind", kind_name(file.kind)}, {"checksum", file.checksum}};
    for (const auto& info : parameter_table()) {
      json["parameters"][std::string(info.name)] = tools::json_of(parameters, info);
    }
    if (file.content.contains(kAlarmPath)) json["alarm"] = read_text(file.content, kAlarmPath);
    json["provenance"] = Json::array();
    for (const auto& entry : chain) json["provenance"].push_back(tools::json_of(entry));
    say("{}\n", json_text(json));
    return kDone;
  }
  say("{}: {}{}", in_one_line(path), kind_summary(file), alarm_text(file.content));
  if (!file.checksum.empty()) say("{}\n", labelled(file.checksum));
  say("\nparameters\n");
  for (const auto& info : parameter_table()) {
    say("  {:<26} {:>12} {:<6} {}\n", info.name, parameter_text(parameters, info),
        info.unit == "1" ? "" : info.unit, info.symbol);
  }
  say("\nprovenance\n");
  for (const auto& entry : chain) {
    say("  {}\n    {}\n",
        in_one_line(fmt::format("{} {} (commit {}, {})", entry.tool, entry.version, entry.commit,
                                entry.compiler)),
        in_one_line(entry.command_line));
    if (!entry.parent_checksum.empty()) say("    from {}\n", in_one_line(entry.parent_checksum));
    if (entry.rebuild == kEditedOutside) {
      say("    {}\n", kEditedOutside);
    } else if (!entry.rebuild.empty()) {
      say("    rebuilt by: {}\n", in_one_line(entry.rebuild));
    }
  }
  return kDone;
}

}  // namespace

constinit const Command show_command = {"analyze show FILE",
                                        "file",
                                        "parameters, time and provenance of a file",
                                        "Prints a file's kind, its parameters and its provenance.",
                                        {add_json_option},
                                        show};

}  // namespace rupture::tools
