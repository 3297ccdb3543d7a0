// analyze lineage: the steps that led to a file, and a script that takes them anew.
#include "analyze/analyze.hpp"
#include "analyze/inputs.hpp"
#include "analyze/lineage.hpp"
#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

std::optional<StartFile> start_of(const po::variables_map& values) {
  if (values.count("from") == 0) return std::nullopt;
  const auto path = values["from"].as<std::string>();
  const ContentFile file = verify_file(path);
  return StartFile{path, file.checksum, file.stored_checksum};
}

void check_combination(const po::variables_map& values) {
  const bool commands = values.count("commands") > 0;
  if (commands && values.count("json") > 0) {
    throw UsageError("--commands and --json exclude each other: give one");
  }
  if (!commands && (values.count("from") > 0 || !values["output"].defaulted())) {
    throw UsageError("--from and --output belong to --commands: give it, too");
  }
}

}  // namespace

constinit const Command lineage_command = {
    "lineage FILE",
    "file",
    "the steps that led to a file, also as a script",
    "Prints the steps from the first tool to FILE, one line each: the content checksum of the\n"
    "file that it wrote, the build, and the command that makes that file from the one before.\n"
    "With --commands a script of these commands, which also checks each file that it makes.",
    {[](po::options_description& options) {
       auto add = options.add_options();
       add("commands", "print a shell script that makes a file of the same content");
       add("output,o", text("FILE")->default_value("rebuilt.h5"),
           "what the script is to call that file");
       add("from", input_file("checkpoint or record"), "let the script begin with this ancestor");
     },
     add_json_option},
    [](const Parsed& parsed) {
      const po::variables_map& values = parsed.values;
      check_combination(values);
      const auto path = file_of(parsed);
      const ContentFile file = read_file(path);
      const Lineage lineage = {path, file.kind, file.checksum, read_provenance(file.content)};
      if (values.count("commands") > 0) {
        const auto output = file_to_write(values, "output");
        say("{}", rebuild_script(lineage, output.string(), start_of(values)));
      } else if (values.count("json") > 0) {
        say("{}\n", json_text(lineage_json(lineage)));
      } else {
        say("{}", lineage_text(lineage));
      }
      return int{kDone};
    }};

}  // namespace rupture::tools
