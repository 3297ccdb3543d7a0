// analyze checksum, verify, diff, show: what can be said of any file of ours.
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "analyze.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/compare.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"
#include "text.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

Parsed parse_files(int argc, const char* const* argv, const std::string& name,
                   const std::string& arguments, const std::string& purpose,
                   const po::options_description& options) {
  return parse(argc, argv,
               {"analyze " + name, "analyze " + name + " " + arguments + " [options]", purpose},
               options, "file", UsesParameters::no);
}

std::vector<std::string> files_of(const Parsed& parsed) {
  if (parsed.values.count("file") == 0) return {};
  return parsed.values["file"].as<std::vector<std::string>>();
}

/// A line "<64 hex digits>  <file name>" of a manifest or .sum file.
struct ManifestLine {
  std::string checksum;
  fs::path file;
};

std::vector<ManifestLine> read_manifest(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw Failure(fmt::format("cannot read the manifest {}", path.string()));
  std::vector<ManifestLine> lines;
  std::string text;
  while (std::getline(file, text)) {
    std::istringstream words(text);
    ManifestLine line;
    std::string name;
    if (!(words >> line.checksum)) continue;
    if (line.checksum.size() != 64 || !std::getline(words >> std::ws, name)) {
      throw Failure(fmt::format("{} is no manifest: '{}' is not '<64 hex digits>  <file>'",
                                path.string(), text));
    }
    line.file = path.parent_path() / name;
    lines.push_back(std::move(line));
  }
  if (lines.empty()) throw Failure(fmt::format("the manifest {} names no file", path.string()));
  return lines;
}

std::string_view change_text(Change change) {
  switch (change) {
    case Change::values:
      return "values differ";
    case Change::type:
      return "types differ";
    case Change::shape:
      return "shapes differ";
    case Change::only_in_a:
      return "only in the first file";
    case Change::only_in_b:
      break;
  }
  return "only in the second file";
}

std::string kind_summary(const ContentFile& file) {
  if (file.kind == FileKind::checkpoint) {
    const Checkpoint checkpoint = checkpoint_from(file.content);
    return fmt::format("checkpoint at t = {:.9g} s, step {}\n",
                       time(checkpoint.parameters, checkpoint.state), checkpoint.state.step);
  }
  const Record record = record_from(file);
  if (record.time.empty()) return fmt::format("{} without samples\n", kind_text(file.kind));
  return fmt::format("{} of {} samples from t = {:.9g} s to {:.9g} s, {} block ruptures\n",
                     kind_text(file.kind), record.time.size(), record.time.front(),
                     record.time.back(), record.ruptures.size());
}

Json provenance_json(const std::vector<ProvenanceEntry>& chain) {
  Json entries = Json::array();
  for (const auto& entry : chain) {
    entries.push_back({{"tool", entry.tool},
                       {"version", entry.version},
                       {"commit", entry.commit},
                       {"command_line", entry.command_line},
                       {"compiler", entry.compiler},
                       {"parent_checksum", entry.parent_checksum}});
  }
  return entries;
}

}  // namespace

int analyze_checksum(int argc, const char* const* argv) {
  po::options_description options("Options");
  const Parsed parsed =
      parse_files(argc, argv, "checksum", "FILE",
                  "Prints the content checksum, verified: 64 hex digits.", options);
  say("{}\n", verify_file(single_input(parsed.values, "file", "a file")));
  return kDone;
}

int analyze_verify(int argc, const char* const* argv) {
  po::options_description options("Options");
  options.add_options()("manifest", po::value<std::string>()->value_name("FILE"),
                        "file of lines '<checksum>  <file>', names relative to its own folder");
  const Parsed parsed =
      parse_files(argc, argv, "verify", "FILE...",
                  "Checks that files are intact; with --manifest also that their content checksums "
                  "are\nthose listed. Exit code 0: all intact, 1: something is damaged or differs.",
                  options);
  const auto files = files_of(parsed);
  const bool listed = parsed.values.count("manifest") > 0;
  if (files.empty() && !listed) {
    throw UsageError("nothing to verify: name a checkpoint or record, or give --manifest");
  }
  for (const auto& file : files) say("intact  {}  {}\n", verify_file(file), file);
  if (!listed) return kDone;
  for (const auto& line : read_manifest(parsed.values["manifest"].as<std::string>())) {
    const auto checksum = verify_file(line.file);
    if (checksum != line.checksum) {
      throw Failure(
          fmt::format("{} is intact but has content checksum {}, not {} as the manifest "
                      "says",
                      line.file.string(), checksum, line.checksum));
    }
    say("intact  {}  {}\n", checksum, line.file.string());
  }
  return kDone;
}

int analyze_diff(int argc, const char* const* argv) {
  po::options_description options("Options");
  const Parsed parsed = parse_files(
      argc, argv, "diff", "A B",
      "Compares parameters and state, or series, dataset by dataset.\nExit code 0: equal, "
      "1: different.",
      options);
  const auto files = files_of(parsed);
  if (files.size() != 2) {
    throw UsageError(fmt::format("{} files were given: name the two to compare", files.size()));
  }
  const auto differences =
      diff(checksummed_part(read_content(files[0])), checksummed_part(read_content(files[1])));
  for (const auto& d : differences) {
    say("{:<32} {}", d.path, change_text(d.change));
    if (d.change == Change::values) {
      say(": {} of them, first at {}; largest: {:.3e} absolute, {:.3e} relative, {} ULP", d.count,
          d.first, d.largest_absolute, d.largest_relative, d.largest_ulp);
    }
    say("\n");
  }
  if (!differences.empty()) return kFailed;
  say("equal\n");
  return kDone;
}

int analyze_show(int argc, const char* const* argv) {
  po::options_description options("Options");
  options.add_options()("json", "print one JSON object");
  const Parsed parsed =
      parse_files(argc, argv, "show", "FILE",
                  "Prints what a file is, its parameters and its provenance.", options);
  const auto path = single_input(parsed.values, "file", "a file");
  const ContentFile file = read_file(path);
  const Parameters parameters = read_parameters(file.content);
  const auto chain = read_provenance(file.content);
  if (parsed.values.count("json") > 0) {
    Json json = {{"kind", kind_text(file.kind)}, {"checksum", file.checksum}};
    for (const auto& info : parameter_table()) {
      json["parameters"][std::string(info.name)] = parameter_text(parameters, info);
    }
    json["provenance"] = provenance_json(chain);
    say("{}\n", json.dump());
    return kDone;
  }
  say("{}: {}", path, kind_summary(file));
  if (!file.checksum.empty()) say("sha256 {}\n", file.checksum);
  say("\nparameters\n");
  for (const auto& info : parameter_table()) {
    say("  {:<26} {:>12} {:<6} {}\n", info.name, parameter_text(parameters, info),
        info.unit == "1" ? "" : info.unit, info.symbol);
  }
  say("\nprovenance\n");
  for (const auto& entry : chain) {
    say("  {} {} (commit {}, {})\n    {}\n", entry.tool, entry.version, entry.commit,
        entry.compiler, entry.command_line);
    if (!entry.parent_checksum.empty()) say("    from {}\n", entry.parent_checksum);
  }
  return kDone;
}

}  // namespace rupture::tools
