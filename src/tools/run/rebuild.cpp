#include "run/rebuild.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/any.hpp>
#include <iterator>

#include "run/run_options.hpp"

namespace rupture::tools {
namespace {

/// The time of a step with the fewest digits by which step_at() finds the step again.
std::string time_text(const Parameters& p, const Clock& clock, std::int64_t step) {
  const double t = time_at(p, clock, step);
  constexpr int most = 17;
  std::string text;
  for (int digits = 1; digits <= most; ++digits) {
    text = fmt::format("{:.{}g}", t, digits);
    if (step_at(p, clock, std::stod(text)) == step) break;
  }
  return text;
}

}  // namespace

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

std::vector<std::string> with_options(std::vector<std::string> command,
                                      const po::options_description& own,
                                      const po::variables_map& values) {
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
  chain.back().rebuild += " --until " + time_text(parameters, clock, step);
  return chain;
}

std::vector<ProvenanceEntry> cut_at(std::vector<ProvenanceEntry> chain,
                                    const Parameters& parameters, double t, std::int64_t step) {
  if (chain.empty()) return chain;
  auto words = shell_words(chain.back().rebuild);
  const auto until = std::find(words.begin(), words.end(), "--until");
  if (std::distance(until, words.end()) < 2) return chain;
  *std::next(until) = time_text(parameters, {step, t}, step);
  chain.back().rebuild = shell_line(words);
  return chain;
}

std::vector<ProvenanceEntry> recorded_until(std::vector<ProvenanceEntry> chain,
                                            const Parameters& parameters, const Clock& clock,
                                            std::int64_t step, const RunFiles& files) {
  chain = run_until(std::move(chain), parameters, clock, step);
  std::string& command = chain.back().rebuild;
  command += fmt::format(" --record-every {}", files.record_every.time);
  if (!files.crossings.empty()) {
    command += fmt::format(" --crossings {}", fmt::join(files.crossings, ","));
  }
  if (files.fields_every) command += fmt::format(" --fields {}", files.fields_every->time);
  return chain;
}

}  // namespace rupture::tools
