// analyze checksum, verify: whether files are intact and what they should be.
#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <system_error>

#include "analyze/analyze.hpp"
#include "analyze/inputs.hpp"
#include "analyze/inspection.hpp"
#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// Prints findings as they come and counts them.
class Account {
 public:
  void add(const Inspection& finding) {
    say("{}  {}\n", verdict_name(finding.verdict), in_one_line(finding.text));
    std::fflush(stdout);
    ++counts_[finding.verdict];
    if (finding.bad()) bad_.push_back(finding.text);
  }
  void add(const std::vector<Inspection>& findings) {
    for (const Inspection& finding : findings) add(finding);
  }

  /// "3 intact, 1 damaged".
  std::string summary() const {
    std::string text;
    for (const auto& [verdict, count] : counts_) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict_name(verdict));
    }
    return text;
  }

  /// Throws Failure, with the sentence of the finding if it is the only one, if any was bad.
  void demand_all_good() const {
    if (bad_.size() == 1) throw Failure(bad_.front());
    if (bad_.empty()) return;
    throw Failure("not all files are intact: " + summary());
  }

 private:
  std::map<Verdict, int> counts_;
  std::vector<std::string> bad_;
};

std::vector<ManifestLine> manifest_of(const po::variables_map& values) {
  if (values.count("manifest") == 0) return {};
  return read_manifest(values["manifest"].as<std::string>());
}

int verify(const Parsed& parsed) {
  const auto files = files_of(parsed);
  const auto manifest = manifest_of(parsed.values);
  if (files.empty() && manifest.empty()) {
    throw UsageError("nothing to verify: name a checkpoint, record or folder, or give --manifest");
  }
  const Places listed = places_of(manifest);
  Account account;
  for (const auto& file : files) {
    if (std::error_code ignored; fs::is_directory(file, ignored)) {
      account.add(inspect_folder(file, listed));
    } else if (!contains(listed, file)) {
      account.add(inspect_file(file));
    }
  }
  for (const auto& line : manifest) account.add(inspect_file(line.file, line.checksum));
  say("{}\n", account.summary());
  account.demand_all_good();
  return kDone;
}

}  // namespace

constinit const Command checksum_command = {
    "checksum FILE",
    "file",
    "content checksum of a file",
    "Verifies the file and prints its content checksum, 64 hex digits.",
    {[](po::options_description& options) {
      options.add_options()("as-schema-2",
                            "print the checksum that the same content has in schema 2, to compare "
                            "it with one noted before schema 3");
    }},
    [](const Parsed& parsed) {
      const ContentFile file = verify_file(file_of(parsed));
      const bool as_schema_2 = parsed.values.count("as-schema-2") > 0;
      say("{}\n", as_schema_2 ? content_checksum_of_schema_2(file.content) : file.checksum);
      return int{kDone};
    }};

constinit const Command verify_command = {
    "verify FILE|FOLDER...",
    "file",
    "check that files and folders are intact, also against a manifest",
    R"(Checks that files are intact. In a folder it checks all *.h5 files, also in folders below; it
does not follow links to folders, and only names unfinished records (*.h5.part). With a
manifest, files must also have the content checksums listed there, and all *.h5 files in the
given folders must be listed. A .sum file is a manifest; so are the lines printed here for
intact files, without their first word.
All files are checked, even if some are damaged. Exit code 0: all files are intact, 1: a file
is changed, damaged, missing, unfinished, different from the manifest or not listed, or a
folder is unreadable or contains no *.h5 files.)",
    {[](po::options_description& options) {
      options.add_options()("manifest", input_file("manifest"),
                            "file with lines 'content-sha256 <64 hex digits>  <file>', with names "
                            "relative to its own folder; older manifests lack the first word");
    }},
    verify};

}  // namespace rupture::tools
