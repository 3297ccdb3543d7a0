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
    throw UsageError("--commands and --json cannot be combined: give one of them");
  }
  if (!commands && (values.count("from") > 0 || !values["output"].defaulted())) {
    throw UsageError("--from and --output need --commands: add it");
  }
}

}  // namespace

constinit const Command lineage_command = {
    "lineage FILE",
    "file",
    "the steps that led to a file, also as a script",
    "Prints the steps that led to FILE, one line each: the content checksum of the file that was\n"
    "written, the build, and the command that makes it from the file before. With --commands,\n"
    "prints a script of these commands, which also checks each file that it makes.",
    {[](po::options_description& options) {
       auto add = options.add_options();
       add("commands", "print a shell script that makes a file with the same content");
       add("output,o", text("FILE")->default_value("rebuilt.h5"),
           "name of the file that the script makes");
       add("from", input_file("checkpoint or record"), "start the script from this ancestor");
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
