// seal: a checkpoint or record that another program edited, checked and sealed again.
#include <fmt/core.h>

#include <array>

#include "cli/command_line.hpp"
#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "run/summary.hpp"
#include "rupture/checkpoint/compare.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "rupture/model/error.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

struct Options {
  std::string file;
  std::string original;  // empty if none is given
  OutputOptions output;
  std::vector<std::string> arguments;
};

Options setup(int argc, char** argv) {
  po::options_description options("Options");
  options.add_options()("original", input_file("checkpoint or record"),
                        "the file before it was edited; the datasets that differ are named");
  add_output_options(options, "checkpoint or record");
  const Parsed parsed = parse(
      argc, argv,
      {"seal",
       "seal FILE -o OUT [options]",
       "Checks a checkpoint or record that was edited or repacked by another program, such as "
       "h5py\n"
       "or MATLAB, and writes a sealed one, whose provenance says that it was edited outside.\n"
       "Attributes other than unit, and how datasets are stored, are not kept.",
       {},
       "check and seal a file that another program edited"},
      options, "file", UsesParameters::no);
  const auto& values = parsed.values;
  return {single_input(values, "file", "a checkpoint or record to seal"),
          values.count("original") > 0 ? values["original"].as<std::string>() : "",
          output_options(values), parsed.arguments};
}

void refuse_what_needs_no_seal(const std::string& path) {
  FileKind kind{};
  try {
    kind = identify(path);
    if (kind != FileKind::open_record) verify_file(path, Opening::in_child_first);
  } catch (const Failure&) {
    return;  // why, is said when it is read
  }
  if (kind == FileKind::open_record) {
    throw Failure(
        fmt::format("{} is an unfinished record: rupture finish {} -o NEW.h5", path, path));
  }
  throw Failure(fmt::format("{} is sealed and intact: there is nothing to do", path));
}

ContentFile read_original(const std::string& path, const EditedFile& edited,
                          const std::string& edited_path) {
  ContentFile original = verify_file(path, Opening::in_child_first);
  const std::string& sealed = edited.sealed_checksum;
  if (sealed == original.checksum || sealed == original.stored_checksum) return original;
  throw Failure(
      fmt::format("{} is not the original of {}: its content checksum is {} (expected {})", path,
                  edited_path, original.checksum, sealed.empty() ? "unknown" : sealed));
}

std::string_view words_about(Change change) {
  constexpr std::array<std::string_view, 5> words = {"other values", "another type",
                                                     "another shape", "removed", "added"};
  return words.at(static_cast<std::size_t>(change));
}

std::string line_about(const Difference& difference, const Content& edited) {
  std::string text =
      fmt::format("edited: {}: {}", in_one_line(difference.path), words_about(difference.change));
  if (difference.change == Change::values) {
    text += fmt::format(", {} of {}", difference.count,
                        element_count(edited.at(difference.path).shape));
  }
  return text + "\n";
}

void print(const SealSummary& summary, const Content& edited, std::FILE* to) {
  if (summary.content_is_as_sealed) {
    say_on(to, "the content is unchanged; only something outside it was changed\n");
  } else if (summary.sealed_checksum.empty()) {
    say_on(to, "the checksum before the edit is unknown\n");
  } else {
    say_on(to, "the content has changed; its checksum was {}\n", summary.sealed_checksum);
  }
  for (const Difference& difference : summary.differences) {
    say_on(to, "{}", line_about(difference, edited));
  }
  const WrittenFile& file = summary.files.front();
  say_on(to, "{}", wrote_text(file.path, file.checksum));
}

int run(const Options& options) {
  const OutputOptions& output = options.output;
  refuse_what_needs_no_seal(options.file);
  const EditedFile edited = read_edited(options.file);
  check_outputs({output.output}, output.if_exists, options.file);
  if (!options.original.empty()) check_distinct({output.output}, options.original);
  SealSummary summary = {.sealed_checksum = edited.sealed_checksum,
                         .content_is_as_sealed = edited.content_is_as_sealed};
  if (!options.original.empty()) {
    const ContentFile original = read_original(options.original, edited, options.file);
    summary.differences = diff(original.content, edited.content);
  }
  const auto entry =
      make_provenance("seal", options.arguments, edited.sealed_checksum, kEditedOutside);
  const std::string checksum = write_content(
      output.output, edited.kind, checked_content(edited, entry), output.if_exists, output.sum);
  const std::string holds = edited.kind == FileKind::record ? "record" : "checkpoint";
  summary.files = {{output.output, holds, checksum}};
  if (output.verbosity == Verbosity::normal) print(summary, edited.content, output.text());
  print_if_asked(quantities_of(summary), output);
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("seal", [&] { return run(setup(argc, argv)); });
}
