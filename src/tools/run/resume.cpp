#include "run/resume.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

using Chain = std::vector<ProvenanceEntry>;

bool same_step(const ProvenanceEntry& a, const ProvenanceEntry& b) {
  return a.tool == b.tool && a.parent_checksum == b.parent_checksum;
}

/// True if resuming the run made this entry: its command is `restart --until T` and nothing else.
bool is_resumption(const ProvenanceEntry& entry, const std::string& tool) {
  const auto words = shell_words(entry.rebuild);
  return entry.tool == tool && !entry.parent_checksum.empty() && words.size() == 3 &&
         words[0] == "restart" && words[1] == "--until";
}

/// True if `chain` is that of the run whose first file has the chain `start`: the same tools on the
/// same checkpoints, and behind them nothing but resumptions.
bool is_chain_of(const Chain& chain, const Chain& start) {
  if (chain.size() < start.size()) return false;
  const auto rest = chain.begin() + static_cast<std::ptrdiff_t>(start.size());
  return std::equal(start.begin(), start.end(), chain.begin(), same_step) &&
         std::all_of(rest, chain.end(), [&](const ProvenanceEntry& entry) {
           return is_resumption(entry, start.back().tool);
         });
}

/// The same where the checkpoint is of a build that stored no id.
bool is_of_run_without_id(const Checkpoint& checkpoint, const Checkpoint& start) {
  return checkpoint.run->first_step == start.state.step &&
         is_chain_of(checkpoint.provenance, start.provenance);
}

/// True if `checkpoint` lies on the run that begins with `start`.
bool is_of_run(const Checkpoint& checkpoint, const Checkpoint& start) {
  if (!checkpoint.run ||
      parameters_content(checkpoint.parameters) != parameters_content(start.parameters)) {
    return false;
  }
  return checkpoint.run_id.empty() ? is_of_run_without_id(checkpoint, start)
                                   : checkpoint.run_id == id_of_run(start);
}

/// True if a run with this rule would have ended before `step`. When an event spanned is not known,
/// nor, in files of earlier builds, whether one has; then it is true.
bool is_beyond_end(std::int64_t step, const RunSoFar& run, const StopRule& rule) {
  if (step > rule.last_step) return true;
  if (!rule.quiet_steps) return false;
  const std::int64_t quiet_from = run.last_break + *rule.quiet_steps;
  const std::int64_t end = (quiet_from + kQuietCheck - 1) / kQuietCheck * kQuietCheck;
  return run.spanned || run.event.empty() || step > end;
}

/// OUT.h5, if it is there, and files OUT-t*.h5, those of the latest times first.
std::vector<fs::path> checkpoints_of(const fs::path& output) {
  const std::string prefix = output.stem().string() + "-t";
  std::vector<std::pair<double, fs::path>> found;
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  if (error) {
    throw Failure(fmt::format("could not look for checkpoints of {} in {}: {}", output.string(),
                              folder.string(), error.message()));
  }
  for (const auto& entry : entries) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const double t = std::strtod(name.c_str() + prefix.size(), nullptr);
    const fs::path path = path_at(output, t);
    if (std::isfinite(t) && path.filename() == name) found.emplace_back(t, path);
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> paths;
  if (fs::exists(output)) paths.push_back(output);
  for (auto& [t, path] : found) paths.push_back(std::move(path));
  return paths;
}

/// Reads a checkpoint of an interrupted run; one that is damaged counts as none.
std::optional<Checkpoint> read_if_intact(const fs::path& path) {
  try {
    return read_checkpoint(path);
  } catch (const Failure& damage) {
    say_on(stderr, "not used to resume: {}\n", damage.what());
    return std::nullopt;
  }
}

/// True if this is a checkpoint, be it damaged.
bool is_checkpoint(const fs::path& path) {
  try {
    return identify(path) == FileKind::checkpoint;
  } catch (const Failure&) {
    return false;
  }
}

std::vector<std::int64_t> sampled_steps(const Content& rows, const std::string& group) {
  const auto found = rows.find(group + "/step");
  if (found == rows.end()) return {};
  return read_array<std::int64_t>(rows, found->first, found->second.shape);
}

/// Step of sample number n of a run: its first step, then whenever `every` has passed.
std::int64_t sample_step(std::int64_t first, const Interval& every, std::size_t n) {
  return n == 0 ? first : every.step_of(every.number_at(first) + static_cast<std::int64_t>(n));
}

/// True if these are the steps that the run samples; the last one may be that of an earlier end.
bool samples_of_run(const std::vector<std::int64_t>& steps, std::int64_t first,
                    const Interval& every) {
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const std::int64_t due = sample_step(first, every, n);
    const bool is_last = n > 0 && n + 1 == steps.size();
    if (steps[n] != due && !(is_last && steps[n] > steps[n - 1] && steps[n] < due)) return false;
  }
  return true;
}

bool is_record_of_run(const Record& record, const Checkpoint& start, const RunFiles& files) {
  const std::int64_t first = start.state.step;
  const bool has_fields = record.fields == Fields::record;
  return parameters_content(record.parameters) == parameters_content(start.parameters) &&
         is_chain_of(record.provenance, start.provenance) &&
         samples_of_run(record.step, first, files.record_every) &&
         record.crossing_levels == files.crossings &&
         has_fields == files.fields_every.has_value() &&
         (!has_fields || samples_of_run(record.field_step, first, *files.fields_every));
}

/// The part of the run in `path`, a record or its .part; empty if there is no such file. Throws
/// Failure if it holds anything else.
Content recorded(const fs::path& path, const Checkpoint& start, const StopRule& rule,
                 const RunFiles& files) {
  if (!fs::exists(path)) return {};
  RecordFile file = read_record_file(path);
  const Record& record = file.record;
  if (!is_record_of_run(record, start, files) ||
      (!record.step.empty() && record.step.back() > rule.last_step)) {
    throw Failure(fmt::format(
        "{} is not what the run to be resumed has recorded, but the record of another "
        "run, interval, end or choice of --crossings or --fields; move it away, give another "
        "--record, or --force to replace it",
        path.string()));
  }
  return std::move(file.content);
}

/// What a run has recorded so far.
struct Recorded {
  Content rows;
  bool is_finished;  ///< and there is no .part any more
};

/// That of the .part, or else of the record; both must be of the run.
Recorded recorded_so_far(const Checkpoint& start, const StopRule& rule, const RunFiles& files) {
  if (!files.record) return {{}, true};
  const auto held_by = [&](const fs::path& path) {
    try {
      return recorded(path, start, rule, files);
    } catch (const Failure&) {
      if (files.if_exists == IfExists::refuse) throw;
      return Content{};  // and it will be replaced
    }
  };
  Content finished = held_by(*files.record);
  Content part = held_by(part_path(*files.record));
  if (!part.empty()) return {std::move(part), false};
  return {std::move(finished), !fs::exists(part_path(*files.record))};
}

/// True if these rows have all samples that the run had taken when it wrote the checkpoint. At its
/// end it takes one in any case.
bool have_all_samples(const Content& rows, const std::string& group, const Checkpoint& checkpoint,
                      const Interval& every, const StopRule& rule) {
  const std::int64_t step = checkpoint.state.step, first = checkpoint.run->first_step;
  const auto steps = sampled_steps(rows, group);
  auto samples = static_cast<std::size_t>(1 + every.number_at(step) - every.number_at(first));
  std::int64_t last = sample_step(first, every, samples - 1);
  if (step == rule.last_step && last < step) {
    last = step;
    ++samples;
  }
  return steps.size() == samples && steps.back() == last;
}

/// The same of everything that the record holds.
bool reach(const Content& rows, const Checkpoint& checkpoint, const RunFiles& files,
           const StopRule& rule) {
  return have_all_samples(rows, kSeriesGroup, checkpoint, files.record_every, rule) &&
         (!files.fields_every ||
          have_all_samples(rows, kFieldsGroup, checkpoint, *files.fields_every, rule)) &&
         rows.at("/ruptures/step").shape[0] == static_cast<std::uint64_t>(checkpoint.run->ruptures);
}

/// The part of a command that decides what it computes: its arguments without the program and
/// without the options that change no bit. The words after "--" are files.
std::vector<std::string> deciding_arguments(const std::string& command_line) {
  constexpr std::array<std::string_view, 7> without_effect = {
      "--resume", "--sum", "--force", "--json", "-f", "--quiet", "-q"};
  auto words = shell_words(command_line);
  if (!words.empty()) words.erase(words.begin());
  const auto files = std::find(words.begin(), words.end(), "--");
  words.erase(std::remove_if(words.begin(), files,
                             [&](const std::string& word) {
                               return std::find(without_effect.begin(), without_effect.end(),
                                                word) != without_effect.end();
                             }),
              files);
  return words;
}

bool same_command(const Checkpoint& a, const Checkpoint& b) {
  return deciding_arguments(a.provenance.back().command_line) ==
         deciding_arguments(b.provenance.back().command_line);
}

/// True if the run that begins with `start` ends at this checkpoint of it. Of a run until quiet
/// that is only known if the command was the same, up to options that change no bit.
bool is_end(const Checkpoint& checkpoint, const Checkpoint& start, const StopRule& rule) {
  return checkpoint.state.step <= rule.last_step &&
         ending_at(checkpoint.state, *checkpoint.run, rule).has_value() &&
         (!rule.quiet_steps || same_command(checkpoint, start));
}

/// True if the run goes through this checkpoint, which it wrote at its end or on its way.
bool is_on_the_way(const Checkpoint& checkpoint, const fs::path& path, const Checkpoint& start,
                   const StopRule& rule, const RunFiles& files) {
  if (path == files.output) return is_end(checkpoint, start, rule);
  return !is_beyond_end(checkpoint.state.step, *checkpoint.run, rule);
}

}  // namespace

std::string id_of_run(const Checkpoint& start) {
  Sha256 hash;
  hash.update("rupture run 1\n");
  for (const ProvenanceEntry& entry : start.provenance) {
    hash.update(fmt::format("{} {}\n", entry.tool, entry.parent_checksum));
  }
  hash.update(fmt::format("{}\n", start.state.step));
  return hash.hex();
}

fs::path path_at(const fs::path& output, double t) {
  const auto name =
      fmt::format("{}-t{:.9f}{}", output.stem().string(), t, output.extension().string());
  return output.parent_path() / name;
}

Remains find_remains(const Checkpoint& start, const StopRule& rule, const RunFiles& files) {
  const Recorded record = recorded_so_far(start, rule, files);
  bool too_new = false;
  Remains remains;
  for (const fs::path& path : checkpoints_of(files.output)) {
    auto checkpoint = read_if_intact(path);
    if (checkpoint ? !is_of_run(*checkpoint, start) : !is_checkpoint(path)) continue;
    const bool is_usable = checkpoint && is_on_the_way(*checkpoint, path, start, rule, files);
    if (is_usable || path != files.output) remains.replaceable.insert(path);
    if (!is_usable) continue;
    Content rows =
        record.rows.empty() ? Content{} : rows_until(record.rows, checkpoint->state.step);
    if (!files.record || reach(rows, *checkpoint, files, rule)) {
      remains.newest = {std::move(*checkpoint), path, std::move(rows), {}};
      remains.is_complete = path == files.output && record.is_finished;
      return remains;
    }
    if (!std::exchange(too_new, true)) {
      say_on(stderr, "not used to resume: {}, which the record does not reach\n",
             in_one_line(path.string()));
    }
  }
  return remains;
}

bool may_write(const fs::path& path, const Checkpoint& start) {
  if (!fs::exists(path)) return true;
  try {
    return is_of_run(read_checkpoint(path), start);
  } catch (const Failure&) {
    return is_checkpoint(path);
  }
}

std::int64_t last_sample(const Content& rows, const std::string& group) {
  const auto steps = sampled_steps(rows, group);
  return steps.empty() ? -1 : steps.back();
}

}  // namespace rupture::tools
