#include "run/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "cli/text.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// True if `checkpoint` lies on the run that begins with `start`.
bool is_of_run(const Checkpoint& checkpoint, const Checkpoint& start) {
  return checkpoint.run && checkpoint.run->id == start.run->id;
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
    throw Failure(fmt::format("cannot look for checkpoints of {} in {}: {}", output.string(),
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

bool is_record_of_run(const Record& record, const Checkpoint& start, const RunFiles& files) {
  return record.run == recorded_run(start.run->id, files) &&
         record.crossing_levels == files.crossings;
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
    throw Failure(
        fmt::format("{} comes from a different run or was recorded with other options; give "
                    "another --record, or --force to replace it",
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

/// True if these rows are all that the record held when the run wrote the checkpoint, which is at
/// its end or on its way.
bool reach(const Content& rows, const Checkpoint& checkpoint, const fs::path& path,
           const StopRule& rule, const RunFiles& files) {
  const std::int64_t step = checkpoint.state.step, first = checkpoint.run->first_step;
  const bool at_end = path == files.output || step == rule.last_step;
  const auto have_samples = [&](const char* group, const Interval& every) {
    const auto steps = sampled_steps(rows, group);
    const std::int64_t last = at_end ? step : std::max(first, every.last_until(step));
    return std::ssize(steps) == every.samples(first, last) && steps.back() == last;
  };
  return have_samples(kSeriesGroup, files.record_every) &&
         (!files.fields_every || have_samples(kFieldsGroup, *files.fields_every)) &&
         rows.at("/ruptures/step").shape[0] == static_cast<std::uint64_t>(checkpoint.run->ruptures);
}

/// True if the run that begins with `start` ends at this checkpoint of it. Of a run until quiet
/// that is only known if it was to end by the same rule.
bool is_end(const Checkpoint& checkpoint, const StopRule& rule) {
  const RunSoFar& run = *checkpoint.run;
  return checkpoint.state.step <= rule.last_step &&
         ending_at(checkpoint.state, run, rule).has_value() &&
         (!rule.quiet_steps ||
          (run.quiet_steps == rule.quiet_steps && run.arrived_below == rule.arrived_below));
}

/// True if the run goes through this checkpoint, which it wrote at its end or on its way.
bool is_on_the_way(const Checkpoint& checkpoint, const fs::path& path, const StopRule& rule,
                   const RunFiles& files) {
  if (path == files.output) return is_end(checkpoint, rule);
  return !is_beyond_end(checkpoint.state.step, *checkpoint.run, rule);
}

}  // namespace

Found find_run(const Checkpoint& start, const StopRule& rule, const RunFiles& files) {
  const Recorded record = recorded_so_far(start, rule, files);
  bool too_new = false;
  Found found;
  for (const fs::path& path : checkpoints_of(files.output)) {
    auto checkpoint = read_if_intact(path);
    if (checkpoint ? !is_of_run(*checkpoint, start) : !is_checkpoint(path)) continue;
    const bool is_usable = checkpoint && is_on_the_way(*checkpoint, path, rule, files);
    if (is_usable || path != files.output) found.replaceable.insert(path);
    if (!is_usable) continue;
    Content rows =
        record.rows.empty() ? Content{} : rows_until(record.rows, checkpoint->state.step);
    if (!files.record || reach(rows, *checkpoint, path, rule, files)) {
      found.newest = {std::move(*checkpoint), path, std::move(rows)};
      found.is_complete = path == files.output && record.is_finished;
      return found;
    }
    if (!std::exchange(too_new, true)) {
      say_on(stderr, "not used to resume: {}, because the record ends before it\n",
             in_one_line(path.string()));
    }
  }
  return found;
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
