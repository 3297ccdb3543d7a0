#include "resume.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

using Chain = std::vector<ProvenanceEntry>;

/// True if `chain` begins as `start` does: the same tools on the same checkpoints.
bool begins_as(const Chain& chain, const Chain& start) {
  return chain.size() >= start.size() &&
         std::equal(start.begin(), start.end(), chain.begin(), [](const auto& a, const auto& b) {
           return a.tool == b.tool && a.parent_checksum == b.parent_checksum;
         });
}

/// Files OUT-t*.h5, those of the latest times first.
std::vector<fs::path> checkpoints_beside(const fs::path& output) {
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
    if (!name.starts_with(prefix) || entry.path().extension() != output.extension()) continue;
    const double t = std::strtod(name.c_str() + prefix.size(), nullptr);
    const fs::path path = path_at(output, t);
    if (path.filename() == name) found.emplace_back(t, path);
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> paths;
  paths.reserve(found.size());
  for (auto& [t, path] : found) paths.push_back(std::move(path));
  return paths;
}

/// Reads a file of an interrupted run; one that is damaged counts as none.
template <class Read>
auto read_if_intact(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Failure& damage) {
    fmt::print(stderr, "not used to resume: {}\n", damage.what());
    return std::nullopt;
  }
}

/// What the run has recorded so far; empty if there is nothing.
Content recorded(const Checkpoint& start, const fs::path& record) {
  const fs::path part = part_path(record);
  const fs::path path = fs::exists(part) ? part : record;
  if (!fs::exists(path)) return {};
  const auto file = read_if_intact([&] { return read_file(path); });
  if (!file) return {};
  const Record so_far = record_from(*file);
  if (parameters_content(so_far.parameters) != parameters_content(start.parameters) ||
      !begins_as(so_far.provenance, start.provenance)) {
    throw Failure(
        fmt::format("{} is the record of another run, not of the one to be resumed; move it "
                    "away or give another --record",
                    path.string()));
  }
  return file->content;
}

std::int64_t multiples_up_to(std::int64_t step, std::int64_t every) {
  return step / every;
}

/// True if these rows are all that the run had recorded when it wrote the checkpoint.
bool reach(const Content& rows, const Checkpoint& checkpoint, std::int64_t every) {
  if (rows.empty()) return false;
  const RunSoFar& run = *checkpoint.run;
  const std::int64_t samples =
      1 + multiples_up_to(checkpoint.state.step, every) - multiples_up_to(run.first_step, every);
  return rows.at("/series/step").shape[0] == static_cast<std::uint64_t>(samples) &&
         rows.at("/ruptures/step").shape[0] == static_cast<std::uint64_t>(run.ruptures);
}

}  // namespace

fs::path path_at(const fs::path& output, double t) {
  const auto name =
      fmt::format("{}-t{:.9f}{}", output.stem().string(), t, output.extension().string());
  return output.parent_path() / name;
}

bool is_of_run(const Checkpoint& checkpoint, const Checkpoint& start) {
  return checkpoint.run && checkpoint.run->first_step == start.state.step &&
         begins_as(checkpoint.provenance, start.provenance) &&
         parameters_content(checkpoint.parameters) == parameters_content(start.parameters);
}

std::optional<Resumption> find_resumption(const Checkpoint& start, const RunFiles& files) {
  const Content record = files.record ? recorded(start, *files.record) : Content{};
  for (const fs::path& path : checkpoints_beside(files.output)) {
    auto checkpoint = read_if_intact([&] { return read_checkpoint(path); });
    if (!checkpoint || !is_of_run(*checkpoint, start)) continue;
    Content rows = record.empty() ? Content{} : rows_until(record, checkpoint->state.step);
    if (files.record && !reach(rows, *checkpoint, files.record_every)) continue;
    return Resumption{std::move(*checkpoint), path, std::move(rows)};
  }
  return std::nullopt;
}

}  // namespace rupture::tools
