// finish: the record of a run that was killed, or still runs, as an ordinary record.
#include <fmt/core.h>

#include "cli/command_line.hpp"
#include "cli/text.hpp"
#include "run/files.hpp"
#include "run/summary.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

struct Options {
  std::filesystem::path part;
  OutputOptions output;
};

Options setup(int argc, char** argv) {
  po::options_description options("Options");
  add_output_options(options, "record");
  const Parsed parsed = parse(
      argc, argv,
      {"finish",
       "finish RECORD.h5.part -o OUT [options]",
       "Makes an ordinary record from an unfinished one, up to its last sample. The run may have\n"
       "been killed or may still be going on; it is not disturbed, and RECORD.h5.part stays.",
       {},
       "make an ordinary record from an unfinished one"},
      options, "record", UsesParameters::no);
  return {single_input(parsed.values, "record", "an unfinished record (RECORD.h5.part)"),
          output_options(parsed.values)};
}

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
void refuse_name_of_run(const Options& options) {
  namespace fs = std::filesystem;
  const fs::path& output = options.output.output;
  if (!is_being_written(options.part) || fs::weakly_canonical(part_path(fs::absolute(output))) !=
                                             fs::weakly_canonical(fs::absolute(options.part))) {
    return;
  }
  throw Failure(
      fmt::format("a run is writing {} and will write {} when it ends: give another output",
                  options.part.string(), output.string()));
}

void print(const FinishedSummary& summary, std::FILE* to) {
  say_on(to, "{} samples up to t = {:.9g} s\n", summary.samples, summary.time);
  if (summary.ignored_bytes > 0) {
    say_on(to,
           "ignored {} bytes at the end, an incomplete piece: the run was killed while writing it, "
           "is still writing it, or it is damaged\n",
           summary.ignored_bytes);
  }
  const WrittenFile& file = summary.files.front();
  say_on(to, "{}", wrote_text(file.path, file.checksum));
}

int run(const Options& options) {
  const OutputOptions& output = options.output;
  const RecordFile part = read_part(options.part);
  check_outputs({output.output}, output.if_exists, options.part);
  refuse_name_of_run(options);
  const Record& record = part.record;
  const double t = record.time.back();
  const auto chain = cut_at(record.provenance, record.parameters, t, record.step.back());
  const std::string checksum = write_content(
      output.output, FileKind::record, finished_content(part, chain), output.if_exists, output.sum);
  const FinishedSummary summary = {.samples = std::ssize(record.time),
                                   .time = t,
                                   .ignored_bytes = static_cast<std::int64_t>(part.ignored_bytes),
                                   .files = {{output.output, "record", checksum}}};
  if (output.verbosity == Verbosity::normal) print(summary, output.text());
  print_if_asked(quantities_of(summary), output);
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("finish", [&] { return run(setup(argc, argv)); });
}
