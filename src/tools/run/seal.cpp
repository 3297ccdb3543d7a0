// seal: a checkpoint or record that another program edited, checked and sealed again.
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "run/output.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/compare.hpp"
#include "rupture/checkpoint/verify.hpp"

namespace rupture::tools {
namespace {

using Differences = std::vector<Difference>;  // from the original, if one was given

Differences differences_from(const std::string& path, const EditedFile& edited) {
  const ContentFile original = verify_file(path);
  const std::string& sealed = edited.sealed_checksum;
  if (sealed == original.checksum) return diff(original.content, edited.content);
  throw Failure("{} is not the original of {}: its content checksum is {} (expected {})", path,
                edited.name, original.checksum, sealed.empty() ? "unknown" : sealed);
}

std::string line_about(const Difference& difference, const Content& edited) {
  constexpr std::array<std::string_view, 5> words = {"other values", "another type",
                                                     "another shape", "removed", "added"};
  std::string text = fmt::format("edited: {}: {}", in_one_line(difference.path),
                                 words.at(static_cast<std::size_t>(difference.change)));
  if (difference.change == Change::values) {
    text += fmt::format(", {} of {}", difference.count,
                        element_count(edited.at(difference.path).shape));
  }
  return text + "\n";
}

Quantities row_of(const Difference& difference) {
  return {
      {"path", "", "dataset", difference.path},
      {"change", "", "values, type, shape, only_in_a (the original) or only_in_b (the edited file)",
       std::string(name_of(difference.change))},
      {"count", "1", "elements with other values; 0 for other changes",
       static_cast<std::int64_t>(difference.count)},
  };
}

Quantities quantities_of(const EditedFile& edited, const Differences& differences) {
  List list{row_of(Difference{}), {}};
  for (const auto& difference : differences) list.elements.push_back(row_of(difference));
  return {
      {"content_is_as_sealed", "", "whether only something outside the content was changed",
       edited.content_is_as_sealed},
      {"sealed_checksum", "", "content checksum before the edit; empty if it is unknown",
       edited.sealed_checksum},
      {"differences", "", "changes from --original, dataset by dataset; empty without it", list},
  };
}

std::string text_of(const EditedFile& edited, const Differences& differences) {
  std::string text = "the content is unchanged; only something outside it was changed\n";
  if (!edited.content_is_as_sealed) {
    text =
        edited.sealed_checksum.empty()
            ? "the checksum before the edit is unknown\n"
            : fmt::format("the content has changed; its checksum was {}\n", edited.sealed_checksum);
  }
  for (const Difference& difference : differences) text += line_about(difference, edited.content);
  return text;
}

/// As sha256sum prints it.
std::string digest_of_script(const std::string& path) {
  std::ifstream file;
  const Failure failure("cannot read the script {}; give the path of a readable file", path);
  if (!std::filesystem::is_regular_file(path)) throw failure;
  file.open(path, std::ios::binary);
  if (!file.is_open()) throw MachineFailure(failure.what());
  try {
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return sha256(std::as_bytes(std::span(text)));
  } catch (const std::ios_base::failure&) {
    throw MachineFailure(failure.what());
  }
}

int seal(const Parsed& parsed) {
  const auto& values = parsed.values;
  const std::string path = single_input(values, "file", "a checkpoint or record to seal");
  const std::string original =
      values.count("original") > 0 ? values["original"].as<std::string>() : "";
  const OutputOptions output = output_options(values);

  const EditedFile edited = read_edited(path);
  check_output(output, path);
  Differences differences;
  if (!original.empty()) differences = differences_from(original, edited);
  auto entry = make_provenance("seal", parsed.arguments, edited.sealed_checksum, kEditedOutside);
  if (values.count("script") > 0) {
    const auto digest = digest_of_script(values["script"].as<std::string>());
    entry.command_line += "  # SHA-256 of the script: " + digest;
  }
  const Content content = checked_content(edited, entry);
  if (edited.is_sealed) {
    throw Failure("{} is as rupture sealed it: there is nothing to do", path);
  }
  return write_and_report(edited.kind, content, quantities_of(edited, differences),
                          text_of(edited, differences), output);
}

}  // namespace

constinit const Command seal_command = {
    "seal FILE -o OUT",
    "file",
    "check and seal a file that another program edited",
    "Checks a checkpoint or record that was edited or repacked by another program, such as h5py\n"
    "or MATLAB, and writes a sealed one, whose provenance says that it was edited outside.\n"
    "Attributes other than unit, and the storage layout of datasets, are not kept.",
    {[](po::options_description& options) {
      auto add = options.add_options();
      add("original", input_file("checkpoint or record"),
          "the file before it was edited; the datasets that differ are named");
      add("note", text("TEXT"), "what was edited, for the provenance");
      add("script", input_file("script"),
          "the script that edited it; its name and SHA-256 go into the provenance");
      add_output_options(options, "checkpoint or record");
    }},
    seal,
    [] { return with_files(quantities_of(EditedFile{}, {})); }};

}  // namespace rupture::tools
