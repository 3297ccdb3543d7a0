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
    throw Failure("not all is well: " + summary());
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
    "Prints the content checksum, verified: 64 hex digits.",
    {[](po::options_description& options) {
      options.add_options()(
          "as-schema-2",
          "the one that it would have in a file of schema 2, to compare it with one "
          "that was noted before schema 3");
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
    R"(Checks that files are intact, and of folders all files *.h5 in them and below; links to
folders are not followed, and unfinished records (*.h5.part) are only named. A manifest must
also give the content checksums of the files that it lists, and list all files *.h5 in the
folders given. A .sum file is a manifest; so are the lines of intact files printed here,
without their first word.
Every file is looked at, whatever is wrong with others. Exit code 0: all is well, 1: a file
is changed, damaged, missing, unfinished, not what the manifest says or not listed, or a folder is
unreadable or holds no file *.h5.)",
    {[](po::options_description& options) {
      options.add_options()(
          "manifest", input_file("manifest"),
          "file of lines 'content-sha256 <64 hex digits>  <file>', names relative to its own "
          "folder; the first word may be missing, as in older ones");
    }},
    verify};

}  // namespace rupture::tools
