#include "run/files.hpp"

#include <algorithm>
#include <boost/any.hpp>
#include <cstdlib>

#include "run/plan.hpp"
#include "rupture/checkpoint/checksum.hpp"
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

std::int64_t steps_in(const Parameters& p, double duration) {
  const double steps = std::round(duration / p.dt);
  if (!(std::abs(steps) < 0x1p53)) {
    throw UsageError("{:g} s is too long for time steps of {:g} s", duration, p.dt);
  }
  return static_cast<std::int64_t>(steps);
}

std::int64_t block_at(const Parameters& p, double x, const std::string& option) {
  const double block = std::round(x / block_spacing(p));
  if (block <= static_cast<double>(p.Nx - 1)) return static_cast<std::int64_t>(block);
  throw UsageError("--{} {:g} is beyond the interface, which ends at {:g} m", option, x, p.L);
}

std::int64_t step_at(const Parameters& p, const Clock& clock, double t) {
  return clock.origin_step + steps_in(p, t - clock.origin_time);
}

Interval interval(const Parameters& p, const Clock& clock, double t, std::string_view option) {
  constexpr double rounding = 1e-9, half = 0.5 - 1e-6;  // a tie is decided once, by `zero`
  steps_in(p, t);                                       // not too long
  const std::int64_t zero = step_at(p, clock, 0.0);
  const double offset = std::clamp(-time_at(p, clock, zero) / p.dt, -half, half);
  if (t >= p.dt * (1.0 - rounding)) return {std::max(t, p.dt), p.dt, zero, offset};
  throw UsageError("--{} must be at least one time step, {:g} s (got {:g} s)", option, p.dt, t);
}

std::string id_of_run(const Checkpoint& start) {
  const ProvenanceEntry& tool = start.provenance.back();
  const std::string text =
      fmt::format("rupture run 2\n{} {}\n{}\n{}\n", tool.tool, tool.parent_checksum,
                  content_checksum(parameters_content(start.parameters)), start.state.step);
  return sha256(std::as_bytes(std::span(text)));
}

RecordedRun recorded_run(const RunPlan& plan) {
  RecordedRun run = {plan.start.run->id, plan.record_every.time};
  if (plan.fields_every) run.fields_every = plan.fields_every->time;
  if (plan.in_events) run.every_in_events = plan.in_events->time;
  if (plan.in_events) run.quiet_time = plan.rule.early.quiet_time;
  return run;
}

std::filesystem::path path_at(const std::filesystem::path& output, double t) {
  const auto name =
      fmt::format("{}-t{:.9f}{}", output.stem().string(), t, output.extension().string());
  return output.parent_path() / name;
}

std::vector<std::string> rebuild_command(const std::string& tool, const Parameters& before,
                                         const Parameters& parameters) {
  std::vector<std::string> command = {tool};
  for (const auto& info : parameter_table()) {
    const std::string value = used_text(parameters, info);
    if (value == used_text(before, info)) continue;
    command.emplace_back("--set");
    command.push_back(fmt::format("{}={}", info.name, value));
  }
  return command;
}

std::vector<std::string> with_options(std::vector<std::string> command, AddOptions add_own,
                                      const po::variables_map& values) {
  po::options_description own;
  add_own(own);
  for (const auto& option : own.options()) {
    const auto found = values.find(option->long_name());
    if (found == values.end()) continue;
    command.push_back("--" + option->long_name());
    const boost::any& value = found->second.value();
    if (value.type() == typeid(double)) {
      command.push_back(fmt::format("{}", boost::any_cast<double>(value)));
    } else if (option->semantic()->max_tokens() > 0) {
      command.push_back(boost::any_cast<std::string>(value));
    }
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
  std::string& command = chain.back().rebuild;  // without spaces in its words
  constexpr std::string_view option = " --until ";
  const std::size_t found = command.find(option), from = found + option.size();
  if (found == std::string::npos) return chain;
  const Clock end = {record.step.back(), record.time.back()};
  command.replace(from, command.find(' ', from) - from,
                  shortest_text(record.parameters, end, end.origin_step));
  return chain;
}

std::vector<ProvenanceEntry> recorded_until(const RunPlan& plan, std::int64_t step) {
  const Checkpoint& start = plan.start;
  auto chain = run_until(start.provenance, start.parameters, start.state.clock, step);
  std::string& command = chain.back().rebuild;
  command += fmt::format(" --record-every {}", plan.record_every.time);
  if (plan.in_events) command += fmt::format(" --record-every-in-events {}", plan.in_events->time);
  if (const auto quiet = recorded_run(plan).quiet_time)
    command += fmt::format(" --quiet-time {}", *quiet);
  if (const auto& levels = plan.options.crossings; !levels.empty()) {
    command += fmt::format(" --crossings {}", fmt::join(levels, ","));
  }
  if (plan.fields_every) command += fmt::format(" --fields {}", plan.fields_every->time);
  return chain;
}

}  // namespace rupture::tools
