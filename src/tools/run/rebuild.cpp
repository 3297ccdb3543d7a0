#include "run/rebuild.hpp"

#include <algorithm>
#include <boost/any.hpp>
#include <cstdlib>

#include "cli/text.hpp"
#include "run/plan.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

/// The time of a step with the fewest digits by which step_at() finds the step again.
std::string shortest_text(const Parameters& p, const Clock& clock, std::int64_t step) {
  const double t = time_at(p, clock, step);
  constexpr int most = 17;
  std::string text;
  for (int digits = 1; digits <= most; ++digits) {
    text = fmt::format("{:.{}g}", t, digits);
    if (step_at(p, clock, std::strtod(text.c_str(), nullptr)) == step) break;
  }
  return text;
}

}  // namespace

const RebuildCommand::Option* RebuildCommand::find(std::string_view name) const {
  const auto found = std::ranges::find(options, name, &Option::name);
  return found == options.end() ? nullptr : &*found;
}

std::string RebuildCommand::text() const {
  std::vector<std::string> words = {tool};
  for (const auto& [name, value] : options) {
    words.push_back("--" + name);
    if (!value.empty()) words.push_back(value);
  }
  return shell_line(words);
}

std::optional<RebuildCommand> read_rebuild(const std::string& text) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+=.,- ";
  if (text.find_first_not_of(harmless) != std::string::npos) return std::nullopt;
  std::optional<RebuildCommand> command;
  for (const std::string& word : split(text, ' ')) {
    const bool is_option = word.starts_with('-') && word.find_first_of("0123456789") != 1;
    if (!command) {
      command = {word};
    } else if (is_option && word.starts_with("--")) {
      command->options.push_back({word.substr(2), ""});
    } else if (is_option || word.empty() || command->options.empty() ||
               !command->options.back().value.empty()) {
      return std::nullopt;
    } else {
      command->options.back().value = word;
    }
  }
  return command;
}

RebuildCommand rebuild_command(const std::string& tool, const Parameters& before,
                               const Parameters& parameters) {
  RebuildCommand command = {tool};
  for (const auto& info : parameter_table()) {
    const std::string value = used_text(parameters, info);
    if (value == used_text(before, info)) continue;
    command.options.push_back({"set", fmt::format("{}={}", info.name, value)});
  }
  return command;
}

RebuildCommand with_options(RebuildCommand command, AddOptions add_own,
                            const po::variables_map& values) {
  po::options_description own;
  add_own(own);
  for (const auto& option : own.options()) {
    const auto found = values.find(option->long_name());
    if (found == values.end() || !is_in_rebuild(*option)) continue;
    const boost::any& value = found->second.value();
    const auto* const number = boost::any_cast<double>(&value);
    const bool is_flag = option->semantic()->max_tokens() == 0;
    command.options.push_back({option->long_name(), is_flag ? ""
                                                    : number
                                                        ? fmt::format("{}", *number)
                                                        : boost::any_cast<std::string>(value)});
  }
  return command;
}

std::vector<ProvenanceEntry> run_until(std::vector<ProvenanceEntry> chain,
                                       const Parameters& parameters, const Clock& clock,
                                       std::int64_t step) {
  chain.back().rebuild += " --until " + shortest_text(parameters, clock, step);
  return chain;
}

std::vector<ProvenanceEntry> cut_at_end(const Record& record) {
  auto chain = record.provenance;
  if (chain.empty()) return chain;
  auto command = read_rebuild(chain.back().rebuild);
  if (!command) return chain;
  const Clock end = {record.step.back(), record.time.back()};
  for (auto& [name, value] : command->options) {
    if (name == "until") value = shortest_text(record.parameters, end, end.origin_step);
  }
  chain.back().rebuild = command->text();
  return chain;
}

std::vector<ProvenanceEntry> recorded_until(const RunPlan& plan, std::int64_t step) {
  const Checkpoint& start = plan.start;
  auto chain = run_until(start.provenance, start.parameters, start.state.clock, step);
  std::string& command = chain.back().rebuild;
  command += fmt::format(" --record-every {}", plan.record_every.time);
  if (plan.in_events) {
    command +=
        fmt::format(" --record-every-in-{}events {}",
                    plan.is_dense_only_if_spanning() ? "spanning-" : "", plan.in_events->time);
  }
  if (const auto quiet = plan.recorded_run.quiet_time)
    command += fmt::format(" --quiet-time {}", *quiet);
  if (const auto& levels = plan.options.crossings; !levels.empty()) {
    command += fmt::format(" --crossings {}", fmt::join(levels, ","));
  }
  if (plan.fields_every) command += fmt::format(" --fields {}", plan.fields_every->time);
  return chain;
}

}  // namespace rupture::tools
