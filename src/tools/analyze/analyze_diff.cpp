// analyze diff: where and by how much two files differ.
#include <fmt/core.h>

#include <algorithm>

#include "analyze/analyze.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/compare.hpp"
#include "rupture/checkpoint/parameters_content.hpp"

namespace rupture::tools {
namespace {

/// What of two files counts in their checksums.
struct Pair {
  Content a, b;
};

/// The values of both files at one element of a dataset.
Json element_json(const Dataset& a, const Dataset& b, std::uint64_t index) {
  const auto number = [&](const Dataset& dataset) {
    return std::visit([](auto value) { return Json(value); }, number_at(dataset, index));
  };
  return {{"index", indices_at(a.shape, index)}, {"a", number(a)}, {"b", number(b)}};
}

/// Members of `json` that tell how the values of a dataset differ.
void add_values(Json& json, const Difference& difference, const Dataset& a, const Dataset& b) {
  json["count"] = difference.count;
  if (a.type == DataType::text) {
    for (const auto& [name, dataset] : {std::pair{"a", &a}, std::pair{"b", &b}}) {
      json[name] = read_text({{"text", *dataset}}, "text");
    }
    return;
  }
  const auto add_largest = [&](const char* name, const auto& largest) {
    json[name]["largest"] = largest.value;
    json[name].update(element_json(a, b, largest.index));
  };
  json["first"] = element_json(a, b, difference.first);
  add_largest("absolute", difference.absolute);
  add_largest("relative", difference.relative);
  if (a.type == DataType::float64) add_largest("ulp", difference.ulp);
}

Json difference_json(const Pair& pair, const Difference& difference) {
  const std::string& path = difference.path;
  const Change change = difference.change;
  Json json = {{"path", path}, {"change", name_of(change)}};
  if (change == Change::type || change == Change::shape) {
    for (const auto& [name, content] : {std::pair{"a", &pair.a}, std::pair{"b", &pair.b}}) {
      const Dataset& dataset = content->at(path);
      json[name] = {{"type", type_name(dataset.type)}, {"shape", dataset.shape}};
    }
  }
  if (change == Change::values) add_values(json, difference, pair.a.at(path), pair.b.at(path));
  return json;
}

/// Checksums of the file itself, of that from which it was made before it, and so on.
std::vector<std::string> ancestors(const ContentFile& file) {
  std::vector<std::string> all = {file.checksum};
  const auto chain = read_provenance(file.content);
  for (auto step = chain.rbegin(); step != chain.rend(); ++step) {
    all.push_back(step->parent_checksum);
  }
  return all;
}

/// The last file that both come from; null if there is none.
Json ancestor_json(const ContentFile& a, const ContentFile& b) {
  const auto others = ancestors(b);
  for (const std::string& checksum : ancestors(a)) {
    if (!checksum.empty() && std::ranges::count(others, checksum) > 0) {
      return {{"checksum", checksum}};
    }
  }
  return nullptr;
}

/// The parameters that differ and that the laws use.
Json parameters_json(const ContentFile& a, const ContentFile& b) {
  const Parameters of_a = read_parameters(a.content), of_b = read_parameters(b.content);
  Json list = Json::array();
  for (const auto& info : parameter_table()) {
    const std::string text = used_text(of_a, info), other = used_text(of_b, info);
    if (text != other) list.push_back({{"name", info.name}, {"a", text}, {"b", other}});
  }
  return list;
}

/// The first row in which two arrays of equal rows differ, of those that both have.
std::optional<std::uint64_t> first_row(const Dataset& a, const Dataset& b) {
  if (a.type != b.type || a.shape.empty() || b.shape.empty()) return std::nullopt;
  const auto row_of = [](const Shape& shape) { return std::span(shape).subspan(1); };
  const std::uint64_t rows = std::min(a.shape[0], b.shape[0]);
  if (rows == 0 || !std::ranges::equal(row_of(a.shape), row_of(b.shape))) return std::nullopt;
  const std::size_t bytes_per_row = a.bytes.size() / a.shape[0];
  const auto end = a.bytes.begin() + static_cast<std::ptrdiff_t>(rows * bytes_per_row);
  const auto at = std::mismatch(a.bytes.begin(), end, b.bytes.begin()).first;
  if (at == end) return std::nullopt;
  return static_cast<std::size_t>(at - a.bytes.begin()) / bytes_per_row;
}

/// The first sample of two records, of those that both have, in which a series differs; null if
/// none does.
Json first_sample_json(const Pair& pair) {
  std::optional<std::uint64_t> sample;
  for (const auto& [path, a] : pair.a) {
    const auto b = pair.b.find(path);
    if (!path.starts_with("/series/") || b == pair.b.end()) continue;
    if (const auto row = first_row(a, b->second)) sample = std::min(sample.value_or(*row), *row);
  }
  if (!sample) return nullptr;
  return {{"sample", *sample}, {"time", element<double>(pair.a.at("/series/time"), *sample)}};
}

/// When the states are [s]; null of records. Throws Failure if they are no states.
Json times_json(const ContentFile& a, const ContentFile& b) {
  if (a.kind != FileKind::checkpoint) return nullptr;
  const auto time_of = [](const ContentFile& file) {
    const Checkpoint checkpoint = checkpoint_from(file.content);
    return time(checkpoint.parameters, checkpoint.state);
  };
  return {{"a", time_of(a)}, {"b", time_of(b)}};
}

// --- the text, from the JSON

/// A line if the times differ, else nothing.
std::string times_text(const Json& times) {
  if (times.is_null() || times["a"] == times["b"]) return "";
  return fmt::format("different times: t = {:.10g} s and {:.10g} s\n", times["a"].get<double>(),
                     times["b"].get<double>());
}

std::string parameters_line(const Json& parameters) {
  std::vector<std::string> texts;
  for (const Json& one : parameters) {
    const std::string name = one["name"], a = one["a"], b = one["b"];
    texts.push_back(fmt::format("{} = {} and {}", name, a, b));
  }
  return texts.empty() ? "none" : in_one_line(fmt::format("{}", fmt::join(texts, "; ")));
}

std::string ancestor_line(const Json& ancestor) {
  if (ancestor.is_null()) return "none that the steps of both name";
  const std::string checksum = ancestor["checksum"];
  return "content checksum " + in_one_line(checksum.substr(0, 12));
}

std::string differences_line(const Json& report) {
  const Json &differences = report["differences"], &sample = report["first_sample"];
  std::string text =
      fmt::format("{} of {} datasets", differences.size(), report["datasets"].dump());
  if (!sample.is_null()) {
    return text + fmt::format(", the series from t = {:.10g} s on (sample {})",
                              sample["time"].get<double>(), sample["sample"].dump());
  }
  for (const Json& one : differences) {
    if (one["path"] != "/state/u_x" || !one.contains("absolute")) continue;
    const Json& most = one["absolute"];
    text += fmt::format(", /state/u_x by at most {:.4g} m, at {}", most["largest"].get<double>(),
                        shape_text(most["index"]));
  }
  return text;
}

std::string text_of(const Json& report) {
  if (report["equal"]) return "equal\n";
  return times_text(report["time"]) +
         fmt::format("parameters that differ: {}\ncommon ancestor: {}\nwhat differs: {}\n",
                     parameters_line(report["parameters"]), ancestor_line(report["ancestor"]),
                     differences_line(report));
}

int compare(const Parsed& parsed) {
  const auto files = files_of(parsed);
  if (files.size() != 2) throw UsageError("diff compares two files (got {})", files.size());
  const ContentFile a = read_file(files[0]), b = read_file(files[1]);
  if ((a.kind == FileKind::checkpoint) != (b.kind == FileKind::checkpoint)) {
    throw Failure("{} is {}, but {} is {}: give two files of the same kind", files[0],
                  kind_text(a.kind), files[1], kind_text(b.kind));
  }
  const Pair pair = {checksummed_part(a.content), checksummed_part(b.content)};
  const auto differences = diff(pair.a, pair.b);
  const auto added = std::ranges::count(differences, Change::only_in_b, &Difference::change);
  Json json = {{"equal", differences.empty()},
               {"datasets", std::ssize(pair.a) + added},  // that at least one of the files holds
               {"time", times_json(a, b)},
               {"differences", Json::array()},
               {"parameters", parameters_json(a, b)},
               {"ancestor", ancestor_json(a, b)},
               {"first_sample", first_sample_json(pair)}};
  for (const auto& d : differences) json["differences"].push_back(difference_json(pair, d));
  say("{}", parsed.values.count("json") > 0 ? json_text(json) + "\n" : text_of(json));
  return differences.empty() ? kDone : kFailed;
}

}  // namespace

constinit const Command diff_command = {
    "analyze diff A B",
    "file",
    "where and by how much two files differ",
    R"(Compares the parameters and the state of two checkpoints, or the series of two records. Like the
content checksum, it ignores parameters that the interface law does not use. It prints the
times of states if they differ, which parameters differ, the last file that both come from, and
how much else differs: of records, from which sample on. With --json it prints for each dataset
how many values differ, the first of them, and the largest difference: absolute, relative and in
units in the last place (ULP), each with its place and the values in A and B.
Exit code 0: equal, 1: different.)",
    {add_json_option},
    compare};

}  // namespace rupture::tools
