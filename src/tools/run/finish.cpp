// finish: the record of a run that was killed, or still runs, as an ordinary record.
#include <fmt/core.h>

#include "run/files.hpp"
#include "run/output.hpp"
#include "run/programs.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// Its run may end, and complete its record, at any moment.
bool has_become_record(const std::filesystem::path& part) {
  std::filesystem::path record = part;
  record.replace_extension();
  return part.extension() == ".part" && !exists(part) && exists(record);
}

RecordFile read_part(const std::filesystem::path& path) try {
  if (const FileKind kind = identify(path); kind != FileKind::open_record) {
    throw Failure(fmt::format("{} is {}; expected an unfinished record (RECORD.h5.part)",
                              path.string(), kind_text(kind)));
  }
  RecordFile part = read_record_file(path);
  if (part.record.time.empty()) {
    throw Failure(
        fmt::format("{} has no samples yet: continue its run or start it again", path.string()));
  }
  return part;
} catch (const Failure&) {
  if (!has_become_record(path)) throw;
  throw Failure(fmt::format("{} is gone: its run has ended, and its record is {}", path.string(),
                            std::filesystem::path(path).replace_extension().string()));
}

/// The run refuses to replace at its end what it did not find at its start.
void refuse_name_of_run(const std::filesystem::path& part, const std::filesystem::path& output) {
  namespace fs = std::filesystem;
  if (!is_being_written(part) || fs::weakly_canonical(part_path(fs::absolute(output))) !=
                                     fs::weakly_canonical(fs::absolute(part))) {
    return;
  }
  throw Failure(
      fmt::format("a run is writing {} and will write {} when it ends: give another output",
                  part.string(), output.string()));
}

struct Finished {
  std::int64_t samples = 0;
  double time = 0.0;               ///< of the last one [s]
  std::int64_t ignored_bytes = 0;  ///< at the end of the unfinished record
};

Quantities quantities_of(const Finished& finished) {
  return {
      {"samples", "1", "samples in the record", finished.samples},
      {"time", "s", "time of the last sample", finished.time},
      {"ignored_bytes", "1",
       "bytes of an incomplete piece at the end of the unfinished record, as after a kill",
       finished.ignored_bytes},
  };
}

std::string text_of(const Finished& finished) {
  std::string text =
      fmt::format("{} samples up to t = {:.9g} s\n", finished.samples, finished.time);
  if (finished.ignored_bytes == 0) return text;
  return text + fmt::format(
                    "ignored {} bytes at the end, an incomplete piece: the run was killed while "
                    "writing it, is still writing it, or it is damaged\n",
                    finished.ignored_bytes);
}

int finish(const Parsed& parsed) {
  const std::string path =
      single_input(parsed.values, "record", "an unfinished record (RECORD.h5.part)");
  const OutputOptions output = output_options(parsed.values);

  const RecordFile part = read_part(path);
  check_outputs({output.output}, output.if_exists, path);
  refuse_name_of_run(path, output.output);
  const Record& record = part.record;
  const Finished finished = {std::ssize(record.time), record.time.back(),
                             static_cast<std::int64_t>(part.ignored_bytes)};
  const auto chain =
      cut_at(record.provenance, record.parameters, finished.time, record.step.back());
  const WrittenFile file = write(FileKind::record, finished_content(part, chain), output);
  return report(quantities_of(finished), text_of(finished), file, output);
}

}  // namespace

constinit const Command finish_command = {
    "finish RECORD.h5.part -o OUT",
    "record",
    "make an ordinary record from an unfinished one",
    "Makes an ordinary record from an unfinished one, up to its last sample. The run may have\n"
    "been killed or may still be going on; it is not disturbed, and RECORD.h5.part stays.",
    {[](po::options_description& options) { add_output_options(options, "record"); }},
    finish,
    [] { return with_files(quantities_of(Finished{})); }};

}  // namespace rupture::tools
