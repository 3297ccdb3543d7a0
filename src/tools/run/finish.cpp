// finish: the record of a run that was killed, or still runs, as an ordinary record.
#include <fmt/core.h>

#include "run/output.hpp"
#include "run/rebuild.hpp"

namespace rupture::tools {
namespace {

RecordFile read_part(const std::filesystem::path& path) try {
  if (const FileKind kind = identify(path); kind != FileKind::open_record) {
    throw Failure("{} is {}; expected an unfinished record (RECORD.h5.part)", path.string(),
                  kind_text(kind));
  }
  RecordFile part = read_record_file(path);
  if (part.record.time.empty()) {
    throw Failure("{} has no samples yet: continue its run or start it again", path.string());
  }
  return part;
} catch (const Failure&) {
  std::error_code ignored;
  if (status(path, ignored).type() != std::filesystem::file_type::not_found) throw;
  std::filesystem::path record = path;  // a run may end, and complete its record, at any moment
  if (path.extension() == ".part" && exists(record.replace_extension(), ignored)) {
    throw Failure("{} is gone: its run has ended, and its record is {}", path.string(),
                  record.string());
  }
  throw Failure("{} does not exist; give the path of an unfinished record (RECORD.h5.part)",
                path.string());
}

/// The run refuses to replace at its end what it did not find at its start.
void refuse_name_of_run(const std::filesystem::path& part, const std::filesystem::path& output) {
  namespace fs = std::filesystem;
  if (!is_being_written(part) || fs::weakly_canonical(part_path(fs::absolute(output))) !=
                                     fs::weakly_canonical(fs::absolute(part))) {
    return;
  }
  throw Failure("a run is writing {} and will write {} when it ends: give another output",
                part.string(), output.string());
}

double end_of(const Record& record) {
  return record.time.empty() ? 0.0 : record.time.back();
}

Quantities quantities_of(const RecordFile& part) {
  return {
      {"samples", "1", "samples in the record", std::ssize(part.record.time)},
      {"time", "s", "time of the last sample", end_of(part.record)},
      {"ignored_bytes", "1",
       "bytes of an incomplete piece at the end of the unfinished record, as after a kill",
       static_cast<std::int64_t>(part.ignored_bytes)},
  };
}

std::string text_of(const RecordFile& part) {
  std::string text =
      fmt::format("{} samples up to t = {:.9g} s\n", part.record.time.size(), end_of(part.record));
  if (part.ignored_bytes == 0) return text;
  return text + fmt::format(
                    "ignored {} bytes at the end, an incomplete piece: the run was killed while "
                    "writing it, is still writing it, or it is damaged\n",
                    part.ignored_bytes);
}

int finish(const Parsed& parsed) {
  const std::string path =
      single_input(parsed.values, "record", "an unfinished record (RECORD.h5.part)");
  const OutputOptions output = output_options(parsed.values);

  const RecordFile part = read_part(path);
  check_output(output, path);
  refuse_name_of_run(path, output.output);
  return write_and_report(FileKind::record, finished_content(part, cut_at_end(part.record)),
                          quantities_of(part), text_of(part), output);
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
    [] { return with_files(quantities_of(RecordFile{})); }};

}  // namespace rupture::tools
